//! A session with every simulated controller, on its real socket or pseudo-terminal, in good weather.

// Tests may unwrap, and so may their helper functions.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use common::{PATIENCE, Rig};
use pieper::motion::{Law, Profile};
use pieper_link::{Kind, Phase};

/// Arms, goes to a place, runs a motion from there, and checks that the arm did what it was told.
fn follows(kind: Kind, tolerance: f64) {
    let rig = Rig::new(kind);
    let session = &rig.session;
    let start = rig.measured();
    assert!(
        session.set_target(&start).is_err(),
        "a connection shows only"
    );
    session.arm().unwrap();
    let there = rig.towards(&start, 0.12);
    session.set_target(&there).unwrap();
    rig.drive(PATIENCE, |status| {
        status.phase == Phase::Holding && near(status.measured.as_deref(), &there, tolerance)
    });
    let back = rig.towards(&there, -0.06);
    let law = Law::new(
        vec![0.0, 0.9, 1.8],
        vec![there.clone(), back.clone(), there.clone()],
        Profile::Quintic,
    );
    session.play(law.unwrap()).unwrap();
    let status = rig.drive(PATIENCE, |status| {
        status.phase == Phase::Holding && near(status.measured.as_deref(), &there, tolerance)
    });
    assert_eq!(status.sentence, None);
    session.disarm().unwrap();
    assert_eq!(session.status().phase, Phase::Watching);
    // What the program shows is where the simulated motors are.
    let told = rig.joints_of_motors();
    assert!(near(Some(&told), &there, tolerance), "{told:?} {there:?}");
}

fn near(q: Option<&[f64]>, to: &[f64], tolerance: f64) -> bool {
    q.is_some_and(|q| q.iter().zip(to).all(|(a, b)| (a - b).abs() < tolerance))
}

#[test]
fn packets() {
    follows(Kind::Packets, 1e-3);
}

#[test]
fn ar4() {
    follows(Kind::Ar4, 1e-4);
}

#[test]
fn ar3() {
    // A step of J5 is 0.0008 rad.
    follows(Kind::Ar3, 1e-3);
}

#[test]
fn ros() {
    follows(Kind::Ros, 1e-3);
}

#[test]
fn servo() {
    // Whole degrees.
    follows(Kind::Servo, 0.02);
}

#[test]
fn egm() {
    follows(Kind::Egm, 1e-3);
}

#[test]
fn egm_with_poses_of_the_tool() {
    let rig = Rig::with(Kind::Egm, |options| options.poses = true);
    let session = &rig.session;
    session.arm().unwrap();
    let there = [0.1, 0.15, -0.1, 0.1, 0.4, -0.1];
    session.set_target(&there).unwrap();
    rig.drive(PATIENCE, |status| {
        status.phase == Phase::Holding && near(status.measured.as_deref(), &there, 1e-3)
    });
}

/// Steps are lost, and found again at the switches: where the controller believes to be is then where it is.
#[test]
fn homing_finds_what_was_lost() {
    for kind in [Kind::Ar4, Kind::Ros] {
        let rig = Rig::new(kind);
        rig.session.arm().unwrap();
        let start = rig.measured();
        let there = rig.towards(&start, 0.2);
        rig.session.set_target(&there).unwrap();
        rig.drive(PATIENCE, |status| {
            status.phase == Phase::Holding && near(status.measured.as_deref(), &there, 2e-3)
        });
        // Armed, it does not home.
        assert!(rig.session.home(&[true; 6]).is_err(), "{kind}");
        rig.session.disarm().unwrap();
        rig.served.inject(pieper_link::simulator::Fault::LoseSteps);
        rig.session.home(&[true; 6]).unwrap();
        // The simulated dialect C is there at once.
        if kind == Kind::Ar4 {
            assert!(rig.session.arm().is_err(), "armed on the way");
        }
        let status = rig.drive(PATIENCE * 3, |status| !status.is_homing);
        assert_eq!(status.sentence, None, "{kind}");
        // It stands where it starts, is told to be there, and can be moved.
        rig.drive(PATIENCE, |status| {
            near(status.measured.as_deref(), &start, 2e-3)
        });
        assert!(near(Some(&rig.joints_of_motors()), &start, 2e-3), "{kind}");
        rig.session.arm().unwrap();
        rig.session.set_target(&there).unwrap();
        rig.drive(PATIENCE, |_| {
            near(Some(&rig.joints_of_motors()), &there, 5e-3)
        });
        rig.session.disarm().unwrap();
    }
    // Others say that they have no such command.
    let rig = Rig::new(Kind::Servo);
    let refusal = rig.session.home(&[true; 6]).unwrap_err();
    assert!(refusal.0.contains("find no switches"), "{refusal}");
}

/// Dialect C takes nothing after an emergency stop until that is released: arming asks for it.
#[test]
fn arming_releases_an_emergency_stop() {
    let rig = Rig::new(Kind::Ros);
    rig.session.arm().unwrap();
    let there = rig.towards(&rig.measured(), 0.3);
    rig.session.set_target(&there).unwrap();
    rig.served
        .inject(pieper_link::simulator::Fault::EmergencyStop);
    let status = rig.drive(PATIENCE, |status| !status.phase.is_live());
    assert!(status.sentence.unwrap().contains("emergency stop"));
    rig.session.arm().unwrap();
    rig.session.set_target(&there).unwrap();
    rig.drive(PATIENCE, |_| {
        near(Some(&rig.joints_of_motors()), &there, 5e-3)
    });
}
