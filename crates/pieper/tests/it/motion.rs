//! Laws of motion: ends met exactly, rates that are derivatives, limits told from the rows.

use pieper::describe::{MotionTable, MotionValues};
use pieper::kinematics::tool_pose;
use pieper::motion::{Law, Limited, Profile, State, excesses, sample_times};

fn programme(profile: Profile) -> (pieper::model::Chain, Law) {
    let chain = pieper_robots::find("ar3").unwrap().robot().chain().unwrap();
    let text = include_str!("../../../../examples/ar3-programme.csv");
    let table = MotionTable::from_csv("ar3-programme.csv", text, &chain).unwrap();
    let MotionValues::Joints(rows) = table.values else {
        panic!("joints were expected");
    };
    (chain, Law::new(table.times, rows, profile).unwrap())
}

fn state(law: &Law, time: f64) -> State {
    let mut state = State::default();
    law.at(time, &mut state);
    state
}

#[test]
fn the_papers_programme_gives_the_papers_matrices() {
    for profile in Profile::ALL {
        let (chain, law) = programme(profile);
        for (position, expected) in crate::ar3::REFERENCE.iter().enumerate() {
            let pose = tool_pose(&chain, &state(&law, position as f64).position).unwrap();
            for (column, expected) in expected.iter().enumerate() {
                let given = pose.to_homogeneous();
                for row in 0..3 {
                    let off = (given[(row, column)] - expected[row]).abs();
                    assert!(off <= 1e-15, "position {position} is off by {off:e}");
                }
            }
        }
    }
}

#[test]
fn rows_are_met_to_the_last_bit_and_joints_at_rest_stay() {
    let mut random = fastrand::Rng::with_seed(1);
    for profile in Profile::ALL {
        let mut times: Vec<f64> = (0..50).map(|_| 100.0 * random.f64() - 50.0).collect();
        times.sort_by(f64::total_cmp);
        let mut rows: Vec<Vec<f64>> = (0..50).map(|_| vec![random.f64(), 0.3]).collect();
        rows[10] = vec![1e9, 0.3];
        let law = Law::new(times.clone(), rows.clone(), profile).unwrap();
        let mut arrived = State::default();
        for (index, (&time, row)) in times.iter().zip(&rows).enumerate() {
            assert_eq!(state(&law, time).position, *row);
            law.arriving(index, &mut arrived);
            assert_eq!(arrived.position, *row);
            assert_eq!(state(&law, time + 1e-3 * random.f64()).position[1], 0.3);
        }
        for outside in [-60.0, 60.0] {
            assert_eq!(state(&law, outside).rate, [0.0, 0.0]);
        }
    }
}

#[test]
fn rates_and_accelerations_are_derivatives_within_their_peaks() {
    for profile in Profile::ALL {
        let law = Law::new(vec![1.0, 3.0], vec![vec![2.0], vec![-1.0]], profile).unwrap();
        let (mut fastest, mut hardest) = (0.0_f64, 0.0_f64);
        for k in 1..400 {
            let (t, h) = (1.0 + 0.005 * f64::from(k), 1e-5);
            let [before, now, after] = [t - h, t, t + h].map(|t| state(&law, t));
            let slope = |f: fn(&State) -> f64| (f(&after) - f(&before)) / (2.0 * h);
            assert!((slope(|s| s.position[0]) - now.rate[0]).abs() < 1e-4);
            let kink = profile == Profile::Trapezoid && (k % 133 < 2);
            assert!(kink || (slope(|s| s.rate[0]) - now.acceleration[0]).abs() < 1e-4);
            assert!(now.rate[0] <= 0.0, "it moves one way");
            fastest = fastest.max(now.rate[0].abs());
            hardest = hardest.max(now.acceleration[0].abs());
        }
        let [rate, acceleration] = [
            profile.peak_rate() * 1.5,
            profile.peak_acceleration().unwrap_or(0.0) * 0.75,
        ];
        assert!(
            fastest <= rate * (1.0 + 1e-12) && fastest > 0.999 * rate,
            "{profile:?} {fastest}"
        );
        assert!(
            hardest <= acceleration && hardest >= 0.97 * acceleration,
            "{profile:?} {hardest}"
        );
    }
}

#[test]
fn limits_are_told_from_the_rows() {
    let chain = pieper_robots::find("iiwa7")
        .unwrap()
        .robot()
        .chain()
        .unwrap();
    let degrees = |joint: usize, value: f64| {
        let mut row = vec![0.0; 7];
        row[joint] = f64::to_radians(value);
        row
    };
    let rows = vec![
        degrees(0, 0.0),
        degrees(0, 98.0),
        degrees(0, 171.0),
        degrees(0, 175.0),
    ];
    let law = Law::new(vec![0.0, 1.0, 3.0, 4.0], rows, Profile::Linear).unwrap();
    let found = excesses(&law, &chain);
    assert_eq!(
        found.len(),
        1,
        "98 degrees a second is the limit itself: {found:?}"
    );
    assert_eq!(
        (
            found[0].joint,
            found[0].limited,
            found[0].count,
            found[0].time
        ),
        (0, Limited::Position, 2, 4.0)
    );
    let law = Law::new(law.times().to_vec(), law.rows().to_vec(), Profile::Cubic).unwrap();
    let found = excesses(&law, &chain);
    assert_eq!((found[1].limited, found[1].time), (Limited::Rate, 0.0));
    assert!((found[1].value - 147_f64.to_radians()).abs() < 1e-12);
}

#[test]
fn sample_times_hold_every_row_and_rise() {
    let times = sample_times(&[0.0, 1.0 / 3.0, 0.333334, 1.0], 50.0).unwrap();
    assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!(times.len(), 53);
    // The sums of tenths miss the multiples of a tenth by rounding: one sample each, the row's.
    let rows: Vec<f64> = (0..100)
        .scan(0.0, |t, _| {
            *t += 0.1;
            Some(*t)
        })
        .collect();
    assert_eq!(sample_times(&rows, 10.0).unwrap(), rows);
    assert_eq!(sample_times(&[5.0], 50.0).unwrap(), [5.0]);
    assert_eq!(sample_times(&[1e9], 1e300).unwrap(), [1e9]);
    for (rate, text) in [
        (
            0.0,
            "rate 0: a number of samples per second above 0 was expected",
        ),
        (
            f64::NAN,
            "rate NaN: a number of samples per second above 0 was expected",
        ),
        (
            1e7,
            "10000000 samples per second over 1 s: at most 2000000 samples were expected",
        ),
    ] {
        assert_eq!(
            sample_times(&[0.0, 1.0], rate).unwrap_err().to_string(),
            text
        );
    }
}

#[test]
fn laws_that_are_none_are_refused() {
    let law = |times: &[f64], rows: &[&[f64]]| {
        let rows = rows.iter().map(|row| row.to_vec()).collect();
        Law::new(times.to_vec(), rows, Profile::Linear)
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        law(&[], &[]),
        "motion: one row of joint values for each time was expected"
    );
    assert_eq!(
        law(&[0.0, 1.0], &[&[0.0], &[]]),
        "motion: rows of one length were expected"
    );
    assert_eq!(
        law(&[0.0], &[&[f64::NAN]]),
        "motion: finite numbers were expected"
    );
    assert_eq!(
        law(&[0.0, 0.0], &[&[0.0], &[1.0]]),
        "motion: times were expected each later than the one before"
    );
}
