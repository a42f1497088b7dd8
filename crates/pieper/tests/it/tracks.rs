//! Paths of the tool to motions of the joints: known motions come back, branches end where the solver says so.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::UnitQuaternion;
use pieper::describe::{MotionTable, MotionValues, Robot};
use pieper::ik::{Solver, Status};
use pieper::kinematics::{Jacobian, Reference, measures, pose_and_jacobian, tool_pose};
use pieper::model::Chain;
use pieper::motion::{
    End, Event, Law, PoseLaw, Profile, State, Track, TrackOptions, Tracks, sample_times, track,
};
use pieper::spatial::{Pose, from_xyz_rpy};

fn arm(name: &str) -> Chain {
    pieper_robots::find(name).unwrap().robot().chain().unwrap()
}

fn tracks(chain: &Chain, law: &PoseLaw) -> Tracks {
    let solver = Solver::new(chain).unwrap();
    track(&solver, law, &TrackOptions::default(), &mut |_| ()).unwrap()
}

/// Straight lines through poses x, y, z, roll, pitch, yaw, one second each.
fn line(poses: &[[f64; 6]]) -> PoseLaw {
    let pose = |v: &[f64; 6]| from_xyz_rpy([v[0], v[1], v[2]], [v[3], v[4], v[5]]);
    let times = (0..poses.len()).map(|k| k as f64).collect();
    PoseLaw::new(times, poses.iter().map(pose).collect(), Profile::Linear).unwrap()
}

/// Whatever is claimed of a motion is measured anew: the tool follows the path, within limits, without jumps.
fn check(chain: &Chain, law: &PoseLaw, track: &Track, tolerance: f64) {
    let rows = track.times.windows(2).zip(track.rows.windows(2));
    for (times, rows) in rows {
        assert!(times[0] <= times[1]);
        for part in 0..5 {
            let share = f64::from(part) / 4.0;
            let q: Vec<f64> = rows[0]
                .iter()
                .zip(&rows[1])
                .map(|(a, b)| a + share * (b - a))
                .collect();
            let (given, wanted) = (
                tool_pose(chain, &q).unwrap(),
                law.at(times[0] + share * (times[1] - times[0])),
            );
            let shift = (given.translation.vector - wanted.translation.vector).norm();
            let turn = (given.rotation.matrix() - wanted.rotation.matrix()).norm();
            assert!(
                shift <= tolerance && turn <= 1.5 * tolerance,
                "{shift:e} {turn:e} at {} s",
                times[0]
            );
            for (value, variable) in q.iter().zip(chain.variables()) {
                let limits = variable.limits;
                assert!(limits.is_none_or(|limits| {
                    limits.lower() - 1e-8 <= *value && *value <= limits.upper() + 1e-8
                }));
            }
        }
    }
}

fn programme() -> (Chain, Law) {
    let chain = arm("ar3");
    let text = include_str!("../../../../examples/ar3-programme.csv");
    let table = MotionTable::from_csv("ar3-programme.csv", text, &chain).unwrap();
    let MotionValues::Joints(rows) = table.values else {
        panic!("joints were expected");
    };
    (chain, Law::new(table.times, rows, Profile::Linear).unwrap())
}

/// The tool's poses at the given moments of a motion of the joints.
fn poses(chain: &Chain, law: &Law, times: &[f64]) -> Vec<Pose> {
    let mut state = State::default();
    let pose = |&t: &f64| {
        law.at(t, &mut state);
        tool_pose(chain, &state.position).unwrap()
    };
    times.iter().map(pose).collect()
}

/// The largest difference between a track and a motion of the joints, whole turns apart.
fn difference(track: &Track, law: &Law, times: &[f64]) -> f64 {
    let mut state = State::default();
    let mut worst = 0.0_f64;
    for &t in times {
        law.at(t, &mut state);
        for (a, b) in track.at(t).iter().zip(&state.position) {
            let apart = a - b;
            worst = worst.max((apart - TAU * (apart / TAU).round()).abs());
        }
    }
    worst
}

#[test]
fn the_papers_programme_comes_back() {
    let (chain, law) = programme();
    let times = sample_times(law.times(), 50.0).unwrap();
    let exact = poses(&chain, &law, &times);
    // As a table would give them: quaternions add rounding to what is singular all the way.
    let through_quaternions = exact.iter().map(|pose| {
        let turn = UnitQuaternion::from_rotation_matrix(&pose.rotation);
        Pose::from_parts(pose.translation, turn.to_rotation_matrix())
    });
    for rows in [through_quaternions.collect(), exact.clone()] {
        let path = PoseLaw::new(times.clone(), rows, Profile::Linear).unwrap();
        let found = tracks(&chain, &path);
        let best = found.best().unwrap();
        let worst = difference(best, &law, &times);
        assert!(worst < 1e-9, "{worst:e}");
        assert!(best.stops.is_empty());
        check(&chain, &path, best, 1e-4);
    }
}

/// A smooth random motion of two seconds within the limits, far enough from singularities for its digits to count.
fn random_motion(chain: &Chain, random: &mut fastrand::Rng) -> Law {
    loop {
        let waves: Vec<[f64; 4]> = chain
            .variables()
            .iter()
            .map(|variable| {
                let (low, high) = variable.limits.map_or((-PI, PI), |limits| {
                    (limits.lower().max(-PI), limits.upper().min(PI))
                });
                let span = (high - low).min(1.6);
                let middle = low + 0.5 * span + random.f64() * (high - low - span);
                [
                    middle,
                    0.45 * span * random.f64(),
                    4.0 * random.f64(),
                    TAU * random.f64(),
                ]
            })
            .collect();
        let at = |t: f64| -> Vec<f64> {
            let wave = |w: &[f64; 4]| w[0] + w[1] * (w[2] * t + w[3]).sin();
            waves.iter().map(wave).collect()
        };
        let times: Vec<f64> = (0..=200).map(|k| 0.01 * f64::from(k)).collect();
        let rows: Vec<Vec<f64>> = times.iter().map(|&t| at(t)).collect();
        let mut jacobian = Jacobian::zeros(chain.dof());
        let is_regular = rows.iter().all(|q| {
            pose_and_jacobian(chain, q, Reference::Base, &mut jacobian).unwrap();
            measures(&jacobian).unwrap().singularity.distance > 0.03
        });
        if is_regular {
            return Law::new(times, rows, Profile::Linear).unwrap();
        }
    }
}

#[test]
fn random_motions_are_among_the_tracks() {
    let mut random = fastrand::Rng::with_seed(21);
    for name in ["irb120", "ur5", "fanuc-crx10ia", "puma560"] {
        let chain = arm(name);
        for case in 0..6 {
            let law = random_motion(&chain, &mut random);
            let rows = poses(&chain, &law, law.times());
            let path = PoseLaw::new(law.times().to_vec(), rows, Profile::Linear).unwrap();
            let found = tracks(&chain, &path);
            let alive = found.tracks.iter().filter(|track| track.end == End::Alive);
            let alive: Vec<_> = alive.filter(|track| track.from() == 0.0).collect();
            let least = alive
                .iter()
                .map(|track| difference(track, &law, law.times()))
                .fold(f64::INFINITY, f64::min);
            assert!(least < 1e-9, "{name} {case}: {least:e}");
            alive
                .iter()
                .for_each(|track| check(&chain, &path, track, 1e-4));
        }
    }
}

#[test]
fn branches_end_where_the_solver_has_no_more_solutions() {
    for (name, from, to) in [
        (
            "irb120",
            [0.3, 0.1, 0.4, 0.0, 2.2, 0.3],
            [0.75, 0.1, 0.4, 0.0, 2.2, 0.3],
        ),
        (
            "ur5",
            [0.4, 0.2, 0.3, 0.0, PI, 0.0],
            [1.1, 0.3, 0.4, 0.0, PI, 0.0],
        ),
        (
            "puma560",
            [0.5, 0.1, 0.3, 0.0, PI, 0.0],
            [1.2, 0.1, 0.3, 0.0, PI, 0.0],
        ),
        (
            "fanuc-crx10ia",
            [0.6, 0.1, 0.4, 0.0, PI, 0.0],
            [1.6, 0.1, 0.4, 0.0, PI, 0.0],
        ),
    ] {
        let chain = arm(name);
        let law = line(&[from, to]);
        let found = tracks(&chain, &law);
        assert!(found.best.is_none(), "{name}");
        let solver = Solver::new(&chain).unwrap();
        let (mut inside, mut outside) = (0.0, 1.0);
        for _ in 0..45 {
            let middle = 0.5 * (inside + outside);
            let status = solver.solve(&law.at(middle)).unwrap().status();
            let side = if status == Status::Unreachable {
                &mut outside
            } else {
                &mut inside
            };
            *side = middle;
        }
        let gap = found.gaps.last().unwrap();
        assert!((gap.from - inside).abs() < 1e-8, "{name}: {gap:?} {inside}");
        assert!(gap.worst.unwrap().amount > 0.01);
        let last = found
            .tracks
            .iter()
            .find(|track| (track.to() - inside).abs() < 1e-8)
            .unwrap();
        let End::Dies { event, .. } = &last.end else {
            panic!("{name}: {last:?}");
        };
        assert!(
            matches!(
                event,
                Event::Meets {
                    other: Some(_),
                    beyond: Some(_),
                    ..
                }
            ),
            "{name}: {event:?}"
        );
        let words = event.sentence(&chain);
        assert!(
            words.contains("meet") && words.contains("no branch reaches"),
            "{words}"
        );
        assert!(
            name == "fanuc-crx10ia" || words.starts_with("the elbow is stretched"),
            "{words}"
        );
        for leg in &found.legs {
            check(&chain, &law, &found.tracks[leg.track], 1e-4);
        }
    }
}

#[test]
fn a_straight_wrist_is_passed_smoothly_where_the_path_is_smooth() {
    let chain = arm("irb120");
    let law = line(&[
        [0.3, 0.15, 0.63, 0.0, 1.2, 0.0],
        [0.448, -0.15, 0.63, 0.0, PI - 1.2, 0.0],
    ]);
    let found = tracks(&chain, &law);
    let best = found.best().unwrap();
    assert!(best.stops.is_empty());
    check(&chain, &law, best, 1e-4);
    let [start, end] = [&best.rows[0], &best.rows[best.rows.len() - 1]];
    assert!(start[4] * end[4] < -0.1, "joint 5 passes zero");
    assert!(
        (start[3] - end[3]).abs() < 0.5,
        "joint 4 does not turn over"
    );
    assert!(best.rate < 1.0, "{}", best.rate);
}

#[test]
fn a_straight_wrist_that_is_passed_by_turns_quickly() {
    // A line that misses the straight wrist by so much (rad).
    let chain = arm("irb120");
    for miss in [1e-2, 1e-3] {
        let law = line(&[
            [0.374, 0.0, 0.63, miss, FRAC_PI_2 - 0.3, 0.0],
            [0.374, 0.0, 0.63, miss, FRAC_PI_2 + 0.3, 0.0],
        ]);
        let turned = line(&[
            [0.374, 0.0, 0.63, 0.0, FRAC_PI_2 - 0.3, miss],
            [0.374, 0.0, 0.63, 0.0, FRAC_PI_2 + 0.3, -miss],
        ]);
        for law in [law, turned] {
            let found = tracks(&chain, &law);
            for track in &found.tracks {
                check(&chain, &law, track, 1e-4);
            }
        }
    }
    let away = |miss: f64| {
        let law = line(&[
            [0.374, 0.0, 0.63, 0.0, FRAC_PI_2 - 0.3, miss],
            [0.374, 0.0, 0.63, 0.0, FRAC_PI_2 + 0.3, miss],
        ]);
        let found = tracks(&chain, &law);
        found
            .tracks
            .iter()
            .map(|track| track.rate)
            .fold(0.0, f64::max)
    };
    let [near, far] = [away(1e-3), away(1e-2)];
    assert!(near > 5.0 * far && far > 2.0, "{near} {far}");
}

#[test]
fn a_corner_in_a_straight_wrist_is_a_stop() {
    let chain = arm("irb120");
    let law = line(&[
        [0.374, -0.1, 0.63, 0.0, 1.3, 0.0],
        [0.374, 0.0, 0.63, 0.0, FRAC_PI_2, 0.0],
        [0.374, 0.0, 0.63, 0.0, FRAC_PI_2, 0.4],
    ]);
    let found = tracks(&chain, &law);
    let best = found.best().unwrap();
    assert_eq!(best.stops.len(), 1);
    assert_eq!(best.stops[0].0, 1.0);
    assert!(best.stops[0].1 > 0.1 && best.stops[0].1 < PI);
    check(&chain, &law, best, 1e-4);
}

/// An arm of one joint whose tool stays on its axis.
fn one_joint(limits: &str) -> Chain {
    let text = format!(
        "name = 'one'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\nd = 0.3\n{limits}"
    );
    Robot::from_toml("one.toml", &text)
        .unwrap()
        .chain()
        .unwrap()
}

#[test]
fn joints_go_on_without_wrapping_and_keep_their_limits() {
    // Two and a quarter turns, from 10 degrees on.
    let rows: Vec<[f64; 6]> = (0..=9)
        .map(|k| {
            [
                0.0,
                0.0,
                0.3,
                0.0,
                0.0,
                10.0_f64.to_radians() + FRAC_PI_2 * f64::from(k),
            ]
        })
        .collect();
    let law = line(&rows);
    let free = tracks(&one_joint(""), &law);
    let end = |tracks: &Tracks| {
        let best = tracks.best().unwrap();
        [
            best.rows[0][0].to_degrees(),
            best.rows[best.rows.len() - 1][0].to_degrees(),
        ]
    };
    let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() < 1e-9 && (a[1] - b[1]).abs() < 1e-9;
    assert!(near(end(&free), [10.0, 820.0]));
    let wound = tracks(&one_joint("limits = ['-420 deg', '480 deg']"), &law);
    assert!(near(end(&wound), [-350.0, 460.0]), "{:?}", end(&wound));
    let tight = tracks(&one_joint("limits = ['-400 deg', '400 deg']"), &law);
    assert!(tight.best.is_none());
    let End::Dies { time, event } = &tight.tracks[0].end else {
        panic!("{tight:?}");
    };
    assert!((time - 750.0 / 90.0).abs() < 1e-9);
    assert_eq!(
        event.sentence(&one_joint("limits = ['-400 deg', '400 deg']")),
        "q1 passes its limit 400°"
    );
    assert_eq!(
        (tight.legs.len(), tight.switches.len(), tight.gaps.len()),
        (2, 1, 0)
    );
    assert!((tight.switches[0].travel[0] + TAU).abs() < 1e-9);
}

#[test]
fn a_wish_for_the_start_decides() {
    let chain = arm("ur5");
    let law = line(&[
        [0.4, -0.3, 0.2, 0.0, PI, 0.0],
        [0.4, 0.3, 0.2, 0.0, PI, 0.0],
    ]);
    let solver = Solver::new(&chain).unwrap();
    let all = tracks(&chain, &law);
    for wanted in all.tracks.iter().filter(|track| track.end == End::Alive) {
        let options = TrackOptions {
            start: Some(wanted.rows[0].clone()),
            ..TrackOptions::default()
        };
        let found = track(&solver, &law, &options, &mut |_| ()).unwrap();
        let apart = found.best().unwrap().rows[0]
            .iter()
            .zip(&wanted.rows[0])
            .fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!(apart < 1e-9);
    }
}

#[test]
fn arms_of_other_joint_numbers_are_followed() {
    // Seven joints: the motion of least change from each start.
    let chain = arm("iiwa7");
    let law = line(&[
        [0.45, -0.2, 0.4, 0.0, PI, 0.0],
        [0.45, 0.2, 0.4, 0.0, PI, 0.0],
    ]);
    let found = tracks(&chain, &law);
    check(&chain, &law, found.best().unwrap(), 1e-4);
    // Four: a SCARA moves its tool straight as long as the tool's axis stays upright, and not when it tilts.
    let chain = arm("cobra600");
    let upright = tool_pose(&chain, &[0.3, 0.9, 0.1, 0.2]).unwrap();
    let aside = tool_pose(&chain, &[-0.4, 1.2, 0.05, -0.2]).unwrap();
    let law = PoseLaw::new(vec![0.0, 1.0], vec![upright, aside], Profile::Quintic).unwrap();
    let found = tracks(&chain, &law);
    check(&chain, &law, found.best().unwrap(), 1e-4);
    let tilted = upright * from_xyz_rpy([0.0; 3], [0.2, 0.0, 0.0]);
    let law = PoseLaw::new(vec![0.0, 1.0], vec![upright, tilted], Profile::Linear).unwrap();
    let found = tracks(&chain, &law);
    assert!(found.best.is_none() && found.gaps[0].worst.is_some());
}

#[test]
fn paths_out_of_reach_and_hostile_ones_come_to_an_end() {
    let chain = arm("ur5");
    let far = line(&[
        [3.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [3.0, 1.0, 0.0, 0.0, 0.0, 0.0],
    ]);
    let found = tracks(&chain, &far);
    assert!(found.tracks.is_empty() && found.legs.is_empty() && found.gaps.len() == 1);
    let still = PoseLaw::new(
        vec![2.0],
        vec![tool_pose(&chain, &[0.1; 6]).unwrap()],
        Profile::Linear,
    );
    let found = tracks(&chain, &still.unwrap());
    assert!(found.best().unwrap().times == [2.0]);
    // A table that jumps about, at random.
    let mut random = fastrand::Rng::with_seed(5);
    let rows: Vec<[f64; 6]> = (0..12)
        .map(|_| std::array::from_fn(|_| 0.6 * (2.0 * random.f64() - 1.0)))
        .collect();
    let law = line(&rows);
    let found = tracks(&chain, &law);
    for track in found.tracks.iter().filter(|track| track.times.len() > 1) {
        check(&chain, &law, track, 1e-4);
    }
    let solver = Solver::new(&chain).unwrap();
    let options = TrackOptions {
        budget: 100,
        ..TrackOptions::default()
    };
    let error = track(&solver, &law, &options, &mut |_| ())
        .unwrap_err()
        .to_string();
    assert!(
        error.starts_with("the path at t = ") && error.contains("stopped here after 100 poses"),
        "{error}"
    );
}

#[test]
fn bad_calls_are_named() {
    let chain = arm("ur5");
    let solver = Solver::new(&chain).unwrap();
    let law = line(&[[0.4, 0.0, 0.2, 0.0, PI, 0.0], [0.4, 0.1, 0.2, 0.0, PI, 0.0]]);
    let refused = |options: TrackOptions, expected: &str| {
        let error = track(&solver, &law, &options, &mut |_| ()).unwrap_err();
        assert_eq!(error.to_string(), expected);
    };
    let tolerance = |tolerance: f64| TrackOptions {
        tolerance,
        ..TrackOptions::default()
    };
    refused(
        tolerance(0.0),
        "tolerance 0: a finite number above 0 was expected",
    );
    refused(
        tolerance(f64::NAN),
        "tolerance NaN: a finite number above 0 was expected",
    );
    let start = TrackOptions {
        start: Some(vec![0.0; 5]),
        ..TrackOptions::default()
    };
    assert!(
        track(&solver, &law, &start, &mut |_| ())
            .unwrap_err()
            .to_string()
            .ends_with("5 were given")
    );
    let pose = Pose::identity();
    let half = pose * from_xyz_rpy([0.0; 3], [0.0, 0.0, PI]);
    let law = |times: &[f64], rows: &[Pose]| {
        PoseLaw::new(times.to_vec(), rows.to_vec(), Profile::Linear)
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        law(&[0.0, 1.5], &[pose, half]),
        "the rows at t = 0 s and t = 1.5 s: the tool turns by half a turn, and either way round is as short: a row between them was expected"
    );
    assert_eq!(law(&[], &[]), "motion: one pose for each time was expected");
    assert_eq!(
        law(&[1.0, 1.0], &[pose, pose]),
        "motion: times were expected each later than the one before"
    );
    assert_eq!(
        law(&[0.0, f64::NAN], &[pose, pose]),
        "motion: finite numbers were expected"
    );
}
