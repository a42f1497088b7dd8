//! Any text as a motion table of an arm that turns and slides: reading it never panics, every error names the file,
//! and what reads is a motion that can be sampled.

#![no_main]

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use pieper::describe::{MotionTable, MotionValues, Robot};
use pieper::model::Chain;
use pieper::motion::{Law, Profile, State, excesses, sample_times};

static CHAIN: LazyLock<Chain> = LazyLock::new(|| {
    let arm = "name = 'r'\nconvention = 'standard'\n\
               [[joint]]\ntheta = 'q1'\nlimits = [-1, 1]\nvelocity = 1\nacceleration = 1\n[[joint]]\nname = 'x'\nd = 'q2'\n";
    Robot::from_toml("r.toml", arm).unwrap().chain().unwrap()
});

fuzz_target!(|text: &str| {
    let table = match MotionTable::from_csv("m.csv", text, &CHAIN) {
        Ok(table) => table,
        Err(error) => {
            assert!(error.place().is_some(), "{error}");
            return;
        }
    };
    let rows = match table.values {
        MotionValues::Joints(rows) => rows,
        MotionValues::Poses(poses) => return assert_eq!(poses.len(), table.times.len()),
        MotionValues::Points(points) => return assert_eq!(points.len(), table.times.len()),
    };
    for profile in Profile::ALL {
        let law = Law::new(table.times.clone(), rows.clone(), profile).unwrap();
        let mut state = State::default();
        for (row, &time) in law.times().iter().enumerate() {
            law.at(time, &mut state);
            assert_eq!(state.position, law.rows()[row]);
            law.arriving(row, &mut state);
            assert_eq!(state.position, law.rows()[row]);
        }
        assert!(excesses(&law, &CHAIN).iter().all(|excess| excess.value.is_finite()));
    }
    if let Ok(times) = sample_times(&table.times, 0.1) {
        assert!(times.len() < 1000 || times.len() < table.times.len() + 2_000_001);
        assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
    }
});
