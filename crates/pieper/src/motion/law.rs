//! A motion through rows of joint values.

use super::profile::Profile;
use crate::error::{Error, Result};

/// Joint values as a function of time: through given rows at given times.
///
/// ```
/// use pieper::motion::{Law, Profile, State};
/// let law = Law::new(vec![0.0, 2.0, 3.0], vec![vec![0.0], vec![1.0], vec![1.0]], Profile::Cubic)?;
/// let mut state = State::default();
/// law.at(1.0, &mut state);
/// assert_eq!((state.position[0], state.rate[0]), (0.5, 0.75));
/// # Ok::<(), pieper::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Law {
    times: Vec<f64>,
    rows: Vec<Vec<f64>>,
    profile: Profile,
}

/// Where the joints are and how they move.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Joint values, radians or metres.
    pub position: Vec<f64>,
    /// Their rates, per second.
    pub rate: Vec<f64>,
    /// Their accelerations, per second squared.
    pub acceleration: Vec<f64>,
}

impl Law {
    /// A motion that is at `rows[k]` at `times[k]`.
    ///
    /// # Errors
    /// An input error unless there is at least one row, one row for each time, rows are of one length, times rise,
    /// and all numbers are finite.
    pub fn new(times: Vec<f64>, rows: Vec<Vec<f64>>, profile: Profile) -> Result<Self> {
        let error = |text: &str| Err(Error::input("motion", text));
        if rows.is_empty() || rows.len() != times.len() {
            return error("one row of joint values for each time was expected");
        }
        if rows.iter().any(|row| row.len() != rows[0].len()) {
            return error("rows of one length were expected");
        }
        if !times
            .iter()
            .chain(rows.iter().flatten())
            .all(|x| x.is_finite())
        {
            return error("finite numbers were expected");
        }
        if times.windows(2).any(|pair| pair[0] >= pair[1]) {
            return error("times were expected each later than the one before");
        }
        Ok(Self {
            times,
            rows,
            profile,
        })
    }

    /// The times of the rows.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The rows of joint values.
    pub fn rows(&self) -> &[Vec<f64>] {
        &self.rows
    }

    /// The course of the moves between rows.
    pub fn profile(&self) -> Profile {
        self.profile
    }

    /// The state at time `t`, into `state`. At a row's time the values are the row's, to the last bit; where rates
    /// jump there, they are those of the move that begins. Before the first row and after the last the arm rests.
    pub fn at(&self, t: f64, state: &mut State) {
        let after = self.times.partition_point(|&time| time <= t);
        if after == 0 || (after == self.times.len() && t > self.times[after - 1]) {
            self.rest(after.saturating_sub(1), state);
        } else {
            self.on_move(after.min(self.times.len() - 1), t, state);
        }
    }

    /// The state at the time of row `row`, seen from the move that ends there.
    ///
    /// Differs from [`Law::at`] where rates or accelerations jump. A row that is not there counts as the last.
    pub fn arriving(&self, row: usize, state: &mut State) {
        let row = row.min(self.times.len() - 1);
        self.on_move(row, self.times[row], state);
    }

    fn rest(&self, row: usize, state: &mut State) {
        let count = self.rows[row].len();
        state.position.clone_from(&self.rows[row]);
        for zeros in [&mut state.rate, &mut state.acceleration] {
            zeros.clear();
            zeros.resize(count, 0.0);
        }
    }

    /// The state on the move that ends at row `to`.
    fn on_move(&self, to: usize, t: f64, state: &mut State) {
        let Some(from) = to.checked_sub(1) else {
            return self.rest(0, state);
        };
        let duration = self.times[to] - self.times[from];
        let [share, rate, acceleration] = self.profile.at((t - self.times[from]) / duration);
        state.position.clear();
        state.rate.clear();
        state.acceleration.clear();
        for (&a, &b) in self.rows[from].iter().zip(&self.rows[to]) {
            let way = b - a;
            // From the nearer end, so that both ends are met to the last bit.
            let position = if share <= 0.5 {
                a + way * share
            } else {
                b - way * (1.0 - share)
            };
            state.position.push(position);
            state.rate.push(way * rate / duration);
            state
                .acceleration
                .push(way * acceleration / (duration * duration));
        }
    }
}
