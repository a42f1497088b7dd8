//! Every fault, with every controller, in the middle of a motion: what the arm does, and what a person is told.

// Tests may unwrap, and so may their helper functions.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use std::time::{Duration, Instant};

use common::{PATIENCE, Rig};
use pieper::motion::{Law, Profile};
use pieper_link::simulator::Fault;
use pieper_link::{Kind, Phase, Status};

/// What is to come of a fault.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum End {
    /// The motion is run as if nothing had been.
    Completed,
    /// The arm is stopped, with a sentence.
    Stopped,
    /// The connection is gone, with a sentence.
    Lost,
    /// Completed or stopped: a flipped bit may be of a number, or of a state.
    Either,
}

/// A motion of a few seconds, with a fault a moment after its start.
fn motion_with(kind: Kind, fault: Fault) -> (End, Status) {
    let rig = Rig::new(kind);
    rig.session.arm().unwrap();
    let start = rig.measured();
    let there = rig.towards(&start, 0.3);
    let law = Law::new(
        vec![0.0, 1.5, 3.0],
        vec![start.clone(), there, start.clone()],
        Profile::Quintic,
    );
    rig.session.play(law.unwrap()).unwrap();
    let begun = Instant::now();
    rig.drive(PATIENCE, |_| begun.elapsed() > Duration::from_millis(700));
    rig.served.inject(fault);
    let mut worst = 0.0_f64;
    let mut before: Option<Vec<f64>> = None;
    let status = rig.drive(PATIENCE, |status| {
        // Whatever happens, the arm makes no leap.
        let motors = rig.served.motors();
        if let Some(before) = &before {
            let leap = before.iter().zip(&motors).map(|(a, b)| (a - b).abs());
            worst = worst.max(leap.fold(0.0, f64::max));
        }
        before = Some(motors);
        status.phase != Phase::Playing
    });
    // A tick of these tests is 10 ms; a busy machine may miss some. Steps that are lost, are lost at once.
    if fault != Fault::LoseSteps {
        assert!(worst < 0.2, "{kind} {fault}: a leap of {worst} rad");
    }
    let end = match status.phase {
        Phase::Lost => End::Lost,
        Phase::Stopped => End::Stopped,
        _ => End::Completed,
    };
    if end != End::Completed {
        let said = status.sentence.clone().unwrap_or_default();
        assert!(said.len() > 20, "{kind} {fault}: it was not said why");
        // Nothing moves any more.
        std::thread::sleep(Duration::from_millis(700));
        let rest = rig.served.motors();
        std::thread::sleep(Duration::from_millis(200));
        let later = rig.served.motors();
        assert!(
            rest.iter().zip(&later).all(|(a, b)| (a - b).abs() < 1e-3),
            "{kind} {fault}: it still moves: {rest:?} {later:?}"
        );
        assert!(rig.session.set_target(&start).is_err());
    }
    (end, status)
}

/// What a trial came to that the machine let run: where it kept the test itself from running for a quarter of a second, the guard
/// has stopped the arm, as it should, and the trial is made again.
fn undisturbed(trial: impl Fn() -> (End, Status)) -> (End, Status) {
    let is_disturbed = |status: &Status| {
        let said = status.sentence.as_deref().unwrap_or_default();
        said.contains("has been silent for") || said.contains("was held up")
    };
    let again = (0..4)
        .map(|_| trial())
        .find(|(_, status)| !is_disturbed(status));
    again.expect("the machine is too busy for tests in true time")
}

#[track_caller]
fn expect(kind: Kind, faults: &[(Fault, End, &str)]) {
    let threads: Vec<_> = faults
        .iter()
        .map(|&(fault, end, sentence)| {
            let sentence = sentence.to_owned();
            std::thread::spawn(move || {
                let (ended, status) = undisturbed(|| motion_with(kind, fault));
                match end {
                    End::Either => assert_ne!(ended, End::Lost, "{kind} {fault}: {status:?}"),
                    end => assert_eq!(ended, end, "{kind} {fault}: {status:?}"),
                }
                let said = status.sentence.unwrap_or_default();
                assert!(said.contains(&sentence), "{kind} {fault}: {said}");
            })
        })
        .collect();
    for thread in threads {
        thread.join().unwrap();
    }
}

#[test]
fn packets() {
    expect(
        Kind::Packets,
        &[
            (Fault::Corrupt, End::Completed, ""),
            (Fault::Truncate, End::Completed, ""),
            (Fault::Duplicate, End::Completed, ""),
            (Fault::Reorder, End::Completed, ""),
            (Fault::Flood, End::Completed, ""),
            (Fault::Mute, End::Stopped, "no position"),
            (Fault::Unplug, End::Lost, "cable"),
            (Fault::Reset, End::Stopped, ""),
            (Fault::EmergencyStop, End::Stopped, "emergency stop"),
            (Fault::LoseSteps, End::Stopped, "from where it was sent"),
            (Fault::ClockJump, End::Stopped, "heard nothing for too long"),
        ],
    );
}

#[test]
fn ar4() {
    expect(
        Kind::Ar4,
        &[
            (Fault::Duplicate, End::Completed, ""),
            // There is no checksum: what came with the flood is not believed.
            (Fault::Flood, End::Stopped, "no answer"),
            (Fault::Mute, End::Stopped, "no answer to a move"),
            (Fault::Unplug, End::Lost, "cable"),
            (Fault::Reset, End::Stopped, "no answer"),
            (Fault::EmergencyStop, End::Stopped, "emergency stop"),
            (Fault::LoseSteps, End::Stopped, "encoder and step count"),
            (Fault::ClockJump, End::Completed, ""),
        ],
    );
}

#[test]
fn ar3() {
    expect(
        Kind::Ar3,
        &[
            (Fault::Duplicate, End::Completed, ""),
            // There is no checksum: what came with the flood is not believed.
            (Fault::Flood, End::Stopped, "no answer"),
            (Fault::Mute, End::Stopped, "no answer"),
            (Fault::Unplug, End::Lost, "cable"),
            (Fault::Reset, End::Stopped, "no answer"),
            (Fault::LoseSteps, End::Stopped, "encoder and step count"),
        ],
    );
}

#[test]
fn ros() {
    expect(
        Kind::Ros,
        &[
            // There is no checksum: what came with the flood is not believed.
            (Fault::Flood, End::Stopped, "did not answer"),
            (Fault::Mute, End::Stopped, "did not answer"),
            (Fault::Unplug, End::Lost, "cable"),
            (Fault::Reset, End::Stopped, "did not answer"),
            (Fault::EmergencyStop, End::Stopped, "emergency stop"),
            (Fault::LoseSteps, End::Stopped, "from where it was sent"),
        ],
    );
}

#[test]
fn servo() {
    expect(
        Kind::Servo,
        &[
            // There is no checksum: what came with the flood is not believed.
            (Fault::Flood, End::Stopped, "did not answer"),
            (Fault::Mute, End::Stopped, "did not answer"),
            (Fault::Unplug, End::Lost, "cable"),
            (Fault::Reset, End::Stopped, "did not answer"),
        ],
    );
}

#[test]
fn egm() {
    expect(
        Kind::Egm,
        &[
            (Fault::Corrupt, End::Either, ""),
            (Fault::Truncate, End::Completed, ""),
            (Fault::Mute, End::Stopped, "no position"),
            (Fault::Unplug, End::Stopped, "no position"),
            (Fault::Reset, End::Stopped, ""),
            (Fault::EmergencyStop, End::Stopped, "motors are off"),
            // The controller notices before we do.
            (Fault::LoseSteps, End::Stopped, "reports an error"),
            (Fault::ClockJump, End::Completed, ""),
        ],
    );
}

/// Whoever drives the arm falls silent.
#[test]
fn a_silent_driver_stops_the_arm() {
    let rig = Rig::new(Kind::Packets);
    rig.session.arm().unwrap();
    let start = rig.measured();
    let there = rig.towards(&start, 0.5);
    rig.session.set_target(&there).unwrap();
    let begun = Instant::now();
    let status = rig.session.wait(PATIENCE, |status| !status.phase.is_live());
    assert_eq!(status.phase, Phase::Stopped);
    assert!(
        begun.elapsed() < Duration::from_millis(900),
        "{:?}",
        begun.elapsed()
    );
    assert!(status.sentence.unwrap().contains("has been silent for"));
    // It can be armed again, and begins where it is.
    rig.session.arm().unwrap();
    let status = rig.drive(PATIENCE, |status| status.sent > 5);
    let (measured, commanded) = (status.measured.unwrap(), status.commanded.unwrap());
    for (a, b) in measured.iter().zip(&commanded) {
        assert!((a - b).abs() < 0.01, "{measured:?} {commanded:?}");
    }
}

/// Stop is one action, from anywhere.
#[test]
fn stop_stops() {
    for kind in [Kind::Packets, Kind::Ros, Kind::Egm] {
        let rig = Rig::with(kind, |options| options.share = 0.1);
        rig.session.arm().unwrap();
        let start = rig.measured();
        let there = rig.towards(&start, 0.5);
        rig.session.set_target(&there).unwrap();
        let begun = Instant::now();
        rig.drive(PATIENCE, |_| begun.elapsed() > Duration::from_millis(250));
        rig.session.stop().unwrap();
        let status = rig.drive(PATIENCE, |status| !status.phase.is_live());
        assert_eq!(status.sentence.as_deref(), Some("stopped: stopped by hand"));
        std::thread::sleep(Duration::from_millis(300));
        let stopped = rig.joints_of_motors();
        assert!(
            stopped.iter().zip(&there).any(|(a, b)| (a - b).abs() > 0.1),
            "{kind}: it went on"
        );
    }
}

/// What no arm should be told, is not sent.
#[test]
fn nonsense_is_refused_in_words() {
    let rig = Rig::new(Kind::Packets);
    let here = rig.measured();
    let mut nan = here.clone();
    nan[2] = f64::NAN;
    let mut far = here.clone();
    far[1] = 9.0;
    rig.session.arm().unwrap();
    for (q, said) in [(&nan, "no number"), (&far, "outside its limits")] {
        let refusal = rig.session.set_target(q).unwrap_err().to_string();
        assert!(refusal.contains(said), "{refusal}");
    }
    let refusal = rig.session.set_target(&here[..3]).unwrap_err().to_string();
    assert!(
        refusal.contains("6 joint values were expected"),
        "{refusal}"
    );
    let mut elsewhere = here.clone();
    elsewhere[0] += 0.2;
    let law =
        |rows: Vec<Vec<f64>>, times: Vec<f64>, profile| Law::new(times, rows, profile).unwrap();
    let motions = [
        (
            law(vec![elsewhere.clone()], vec![0.0], Profile::Cubic),
            "move there first",
        ),
        (
            law(
                vec![here.clone(), elsewhere.clone()],
                vec![0.0, 0.01],
                Profile::Cubic,
            ),
            "of its speed the motion could be run",
        ),
        (
            law(
                vec![here.clone(), elsewhere],
                vec![0.0, 5.0],
                Profile::Linear,
            ),
            "the rates jump",
        ),
        (
            law(vec![here, far], vec![0.0, 50.0], Profile::Cubic),
            "t = 50 s: ",
        ),
    ];
    for (motion, said) in motions {
        let refusal = rig.session.play(motion).unwrap_err().to_string();
        assert!(refusal.contains(said), "{refusal}");
    }
    // None of this did anything.
    assert_eq!(rig.session.status().phase, Phase::Holding);
}

/// A protocol that the controller does not speak: nothing moves, and it is said what was heard.
#[test]
fn the_wrong_protocol_connects_to_nothing() {
    use pieper_link::simulator::{Place, Served};
    use pieper_link::{Options, Session};
    let kinds = [Kind::Ar4, Kind::Ar3, Kind::Ros, Kind::Packets];
    let pairs = kinds
        .iter()
        .flat_map(|&a| kinds.iter().map(move |&b| (a, b)))
        .filter(|(a, b)| a != b);
    let threads: Vec<_> = pairs
        .map(|(device, host)| {
            std::thread::spawn(move || {
                let arm = common::arm_of(device);
                let served = Served::start(device, &arm, &Place::Tcp(0)).unwrap();
                let before = served.motors();
                let arm = common::arm_of(host);
                let session =
                    Session::connect(served.address(), host, arm, &Options::default()).unwrap();
                let error = session
                    .wait_connected(Duration::from_millis(1500))
                    .unwrap_err();
                assert!(error.contains("no controller answered"), "{error}");
                assert!(session.arm().is_err());
                assert_eq!(before, served.motors());
            })
        })
        .collect();
    for thread in threads {
        thread.join().unwrap();
    }
}

/// The second program is sent away, and the first one's arm is not disturbed.
#[test]
fn two_programs_at_once() {
    use pieper_link::{Options, Session};
    // A terminal belongs to whoever has opened it.
    let rig = Rig::new(Kind::Ros);
    let second = Session::connect(
        rig.served.address(),
        Kind::Ros,
        common::arm_of(Kind::Ros),
        &Options::default(),
    );
    let error = second.err().expect("a serial port is for one program");
    assert!(error.contains("could not be opened"), "{error}");
    // A simulated controller's socket as well.
    let rig = Rig::new(Kind::Packets);
    rig.session.arm().unwrap();
    let second = Session::connect(
        rig.served.address(),
        Kind::Packets,
        common::arm_of(Kind::Packets),
        &Options::default(),
    );
    let second = second.unwrap();
    let refused = second.wait_connected(Duration::from_millis(800));
    assert!(refused.is_err());
    // The one that was there first is followed as before.
    let sent = rig.session.status().sent;
    rig.drive(PATIENCE, |status| {
        status.phase == Phase::Holding && status.sent > sent + 3
    });
}

/// The line is set to another rate than the controller's: it connects to nothing, nothing moves, and the rate is among what is asked.
#[cfg(unix)]
#[test]
fn the_wrong_rate_connects_to_nothing() {
    use pieper_link::simulator::{Place, Served};
    use pieper_link::transport::Address;
    use pieper_link::{Options, Session};
    for kind in [Kind::Ros, Kind::Servo, Kind::Packets, Kind::Ar3] {
        let arm = common::arm_of(kind);
        let served = Served::start(kind, &arm, &Place::Terminal).unwrap();
        let before = served.motors();
        let at = |baud| match served.address() {
            Address::Serial { path, .. } => Address::Serial {
                path: path.clone(),
                baud: Some(baud),
            },
            other => panic!("{other}"),
        };
        let session = Session::connect(&at(9600), kind, arm.clone(), &Options::default()).unwrap();
        let error = session
            .wait_connected(Duration::from_millis(1200))
            .unwrap_err();
        assert!(error.contains("its rate"), "{error}");
        assert!(session.arm().is_err());
        drop(session);
        assert_eq!(before, served.motors());
        // At its own rate it is there.
        let session = Session::connect(&at(115_200), kind, arm, &Options::default()).unwrap();
        session.wait_connected(PATIENCE).unwrap();
    }
}
