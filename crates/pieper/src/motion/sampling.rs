//! When a motion is looked at.

use crate::error::{Error, Result};

/// More samples are refused: a file of them would be of no use to anybody.
const MOST: f64 = 2e6;

/// A regular time this share of a period or less from a row's time gives way to it.
const NEAR: f64 = 1e-6;

/// Regular times, `rate` to the second from the first row on, and every row's time exactly.
///
/// # Errors
/// An input error unless the rate is finite and above zero, there are rows, and at most two million samples would come of it.
///
/// ```
/// let times = pieper::motion::sample_times(&[0.0, 0.25, 0.5], 10.0)?;
/// assert_eq!(times, [0.0, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5]);
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn sample_times(rows: &[f64], rate: f64) -> Result<Vec<f64>> {
    let (Some(&first), Some(&last)) = (rows.first(), rows.last()) else {
        return Err(Error::input("motion", "at least one row was expected"));
    };
    if !(rate.is_finite() && rate > 0.0) {
        let subject = format!("rate {rate}");
        return Err(Error::input(
            subject,
            "a number of samples per second above 0 was expected",
        ));
    }
    let count = (last - first) * rate;
    if count.is_nan() || count > MOST {
        let subject = format!("{rate} samples per second over {} s", last - first);
        return Err(Error::input(
            subject,
            format!("at most {MOST} samples were expected"),
        ));
    }
    let mut times = Vec::with_capacity(count as usize + rows.len() + 1);
    let mut index = 0_u64;
    for &row in rows {
        // The first regular time that is not before the row, and the first one clearly after it.
        let place = (row - first) * rate;
        let [until, next] = [
            (place - NEAR).ceil() as u64,
            (place + NEAR).floor() as u64 + 1,
        ];
        times.extend((index..until).map(|index| first + index as f64 / rate));
        times.push(row);
        index = next;
    }
    Ok(times)
}
