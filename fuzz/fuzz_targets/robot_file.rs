//! Robot files from strangers: nothing panics, every error is of the kinds a file can have, and what was read is
//! written and read again as the same robot.

#![no_main]

use libfuzzer_sys::fuzz_target;
use pieper::describe::Robot;

fuzz_target!(|text: &str| {
    let Ok(mut robot) = Robot::from_toml("fuzz.toml", text) else { return };
    robot.golden.clear();
    let written = robot.to_toml().expect("a table or screws can be written");
    let again = Robot::from_toml("again.toml", &written).unwrap_or_else(|error| panic!("{error}\n{written}"));
    assert_eq!(robot, again, "{written}");
    if let Ok(chain) = robot.chain() {
        let q = vec![0.3; chain.dof()];
        let _ = pieper::kinematics::tool_pose(&chain, &q);
        let Ok(transmission) = robot.transmission() else { return };
        let (mut motors, mut back) = (q.clone(), q.clone());
        if let Ok(Ok(())) = transmission.motors(&q, &mut motors) {
            let _ = transmission.joints(&motors, &mut back);
        }
        let _ = transmission.ratios(&q, &mut pieper::transmission::Ratios::zeros(q.len()));
        let _ = (0..q.len()).map(|joint| transmission.range(joint, &q)).collect::<Vec<_>>();
    }
});
