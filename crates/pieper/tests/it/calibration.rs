//! Calibration against known truth.

use pieper::calibration::{
    Calibration, Group, Groups, Kind, Measurement, Model, Outcome, Random, Readings, Seen,
    Simulation, design, posture, simulate,
};
use pieper::describe::Robot;
use pieper::ik::Solver;
use pieper::kinematics::tool_pose;
use pieper::model::Chain;

fn robot(id: &str) -> Robot {
    pieper_robots::find(id).unwrap().robot()
}

fn model(id: &str, groups: Groups) -> Model {
    Model::of(&robot(id), groups).unwrap()
}

/// The largest distance and angle between two arms' tools over random postures.
fn apart(model: &Model, a: &Chain, b: &Chain) -> [f64; 2] {
    let mut random = Random::new(77);
    let mut worst = [0.0_f64; 2];
    for _ in 0..200 {
        let q = posture(model, &mut random);
        let (one, two) = (tool_pose(a, &q).unwrap(), tool_pose(b, &q).unwrap());
        worst[0] = worst[0].max((one.translation.vector - two.translation.vector).norm());
        worst[1] = worst[1].max((one.rotation.inverse() * two.rotation).angle());
    }
    worst
}

/// A model with nothing changed is the arm itself, in every form of description.
#[test]
fn the_nominal_model_is_the_arm() {
    for id in [
        "ar3",
        "ar4",
        "ar4-modified",
        "irb120",
        "ur5",
        "puma560",
        "cobra600",
        "stanford",
        "panda",
        "abb-paper",
    ] {
        let groups = Groups {
            gear: true,
            ..Groups::USUAL
        };
        let model = model(id, groups);
        let chain = model.chain_with(&model.nominal()).unwrap();
        let [place, turn] = apart(&model, &chain, model.chain());
        assert!(place < 1e-12 && turn < 1e-7, "{id}: {place:e} {turn:e}");
        // Written and read again, it is still that arm; a table stays a table.
        let again = model
            .robot_with(&model.nominal(), "a test".to_owned())
            .unwrap();
        let text = again.to_toml().unwrap();
        let again = Robot::from_toml("again.toml", &text)
            .unwrap()
            .chain()
            .unwrap();
        let [place, turn] = apart(&model, &again, model.chain());
        assert!(place < 1e-9 && turn < 1e-7, "{id}: {place:e} {turn:e}");
    }
}

/// Without noise the arm that was measured is found, to rounding, whatever was measured.
#[test]
fn the_true_arm_is_found() {
    for id in [
        "ar3",
        "irb120",
        "ur5",
        "ar4-modified",
        "cobra600",
        "stanford",
    ] {
        for kind in [Kind::Poses, Kind::Positions, Kind::Distances] {
            let groups = match kind {
                // A distance does not change when arm and anchors are moved together: the base is not to be had.
                Kind::Distances => Groups {
                    base: false,
                    tool: false,
                    ..Groups::USUAL
                },
                _ => Groups::USUAL,
            };
            let model = model(id, groups);
            // Distances leave things that show together at first, and apart in the second order: small errors keep that small.
            let small = if kind == Kind::Distances { 1e-2 } else { 1.0 };
            let simulation = Simulation {
                count: 120,
                kind,
                wrong_lengths: 1e-3 * small,
                wrong_angles: 5e-3 * small,
                sigma: 1e-12,
                sigma_angle: 1e-12,
                ..Simulation::default()
            };
            let (truth, mut measurements) = simulate(&model, &simulation).unwrap();
            for measurement in &mut measurements {
                // Told to be as they are used to be; they are better.
                (measurement.sigma, measurement.sigma_angle) = (1e-4, 1e-4);
            }
            let result = Calibration::new(model.clone(), measurements)
                .unwrap()
                .run()
                .unwrap();
            assert!(result.converged, "{id} {kind:?}: {}", result.ending);
            let found = result.robot("a test".to_owned()).unwrap().chain().unwrap();
            let real = model.chain_with(&truth).unwrap();
            let [place, turn] = match kind {
                // The anchors move with whatever is the base's.
                Kind::Distances => continue_if_small(&result),
                _ => apart(&model, &found, &real),
            };
            assert!(place < 1e-7, "{id} {kind:?}: {place:e} {:?}", result.held);
            assert!(
                turn < 1e-6 || kind != Kind::Poses,
                "{id} {kind:?}: {turn:e}"
            );
        }
    }
}

/// For distances: what is left of them.
fn continue_if_small(result: &Outcome) -> [f64; 2] {
    let worst = result.after.iter().map(|r| r.length).fold(0.0, f64::max);
    [worst, 0.0]
}

/// What cannot be told apart is named, and held.
#[test]
fn what_shows_only_together_is_said_so() {
    let model = model(
        "ar3",
        Groups {
            base: false,
            tool: false,
            ..Groups::USUAL
        },
    );
    let (_, measurements) = simulate(&model, &Simulation::default()).unwrap();
    let result = Calibration::new(model, measurements)
        .unwrap()
        .run()
        .unwrap();
    let sentences: Vec<String> = result.held.iter().map(|held| held.sentence()).collect();
    // Axes 2 and 3 of the AR3 are parallel.
    assert!(
        sentences
            .iter()
            .any(|s| s == "d2 and d3 only together" || s == "d3 and d2 only together"),
        "{sentences:?}"
    );
    // With base and tool 30 numbers of a six-axis arm and its two frames show, no more.
    for id in ["irb120", "puma560", "ar4-modified"] {
        let model = self::model(id, Groups::USUAL);
        let (_, measurements) = simulate(&model, &Simulation::default()).unwrap();
        let result = Calibration::new(model, measurements)
            .unwrap()
            .run()
            .unwrap();
        assert_eq!(result.fitted.len(), 30, "{id}: {:?}", result.held);
    }
    // Joints that never moved: their gears do not show.
    let model = self::model(
        "irb120",
        Groups {
            gear: true,
            ..Groups::NONE
        },
    );
    let (_, mut measurements) = simulate(
        &model,
        &Simulation {
            wrong_lengths: 0.0,
            ..Simulation::default()
        },
    )
    .unwrap();
    for measurement in &mut measurements {
        measurement.readings.values_mut()[5] = 0.0;
    }
    let result = Calibration::new(model, measurements)
        .unwrap()
        .robust(false)
        .run()
        .unwrap();
    assert_eq!(
        result.held[0].sentence(),
        "gear6 does not show in these measurements"
    );
}

/// The rates agree with differences of the arm's own forward kinematics.
#[test]
fn rates_agree_with_differences() {
    let groups = Groups {
        gear: true,
        ..Groups::USUAL
    };
    for id in ["ar3", "ar4-modified", "stanford", "cobra600"] {
        let model = model(id, groups);
        let mut random = Random::new(3);
        let q = posture(&model, &mut random);
        let values: Vec<f64> = model
            .nominal()
            .iter()
            .map(|x| x + 0.01 * random.normal())
            .collect();
        for (index, parameter) in model.parameters().iter().enumerate() {
            let at = |by: f64| {
                let mut values = values.clone();
                values[index] += by;
                tool_pose(&model.chain_with(&values).unwrap(), &q).unwrap()
            };
            let h = 1e-6;
            let (more, less) = (at(h), at(-h));
            let shift = (more.translation.vector - less.translation.vector) / (2.0 * h);
            let turned = (more.rotation * less.rotation.inverse()).into_inner();
            let turned = (turned - turned.transpose()) / (4.0 * h);
            let turn = nalgebra::Vector3::new(turned[(2, 1)], turned[(0, 2)], turned[(1, 0)]);
            // The library's own rates, seen through one measurement of a whole pose in units of one.
            let rates = model.rates(&values, &Readings::Joints(q.clone())).unwrap();
            let [by_turn, by_shift] = rates[index];
            assert!((shift - by_shift).norm() < 1e-7, "{id} {}", parameter.name);
            assert!((turn - by_turn).norm() < 1e-7, "{id} {}", parameter.name);
        }
    }
}

/// A plane that is touched and a pin that is met tell of the arm as well.
#[test]
fn planes_and_contacts() {
    let groups = Groups {
        theta: true,
        a: true,
        ..Groups::NONE
    };
    let model = model("irb120", groups);
    let mut random = Random::new(8);
    let truth: Vec<f64> = model
        .nominal()
        .iter()
        .map(|x| x + 2e-5 * random.normal())
        .collect();
    let real = model.chain_with(&truth).unwrap();
    let solver = Solver::new(&real).unwrap();
    let mut measurements = Vec::new();
    // Postures that bring the true tool to a plane, and to a pin, with many orientations.
    while measurements.len() < 240 {
        let q = posture(&model, &mut random);
        let mut pose = tool_pose(&real, &q).unwrap();
        let is_pin = measurements.len() % 2 == 0;
        pose.translation.vector = match is_pin {
            true => nalgebra::Vector3::new(0.35, 0.1, 0.3),
            false => {
                nalgebra::Vector3::new(0.2 + 0.2 * random.even(), 0.3 * random.even() - 0.15, 0.25)
            }
        };
        let found = solver.solve(&pose).unwrap();
        let Some(solution) = found.iter().find(|s| s.within_limits) else {
            continue;
        };
        let seen = match is_pin {
            true => Seen::Contact {
                contact: "pin".to_owned(),
                at: [0.0; 3],
            },
            false => Seen::Plane {
                plane: "table".to_owned(),
                at: [0.0; 3],
            },
        };
        measurements.push(Measurement {
            readings: Readings::Joints(solution.q().to_vec()),
            seen,
            sigma: 1e-5,
            sigma_angle: 1e-4,
        });
    }
    let result = Calibration::new(model.clone(), measurements)
        .unwrap()
        .robust(false)
        .run()
        .unwrap();
    assert!(result.converged, "{}", result.ending);
    let worst = result.after.iter().map(|r| r.length).fold(0.0, f64::max);
    assert!(worst < 1e-8, "{worst:e}");
    // The pin and the plane are found where they are, up to what the arm's turn about axis 1 and its size hide.
    for (index, estimate) in result.estimates.iter().enumerate() {
        if result.fitted.contains(&index) && model.parameters().get(index).is_some() {
            let others = result
                .held
                .iter()
                .any(|h| h.with.iter().any(|w| w.name == estimate.name));
            if !others {
                assert!(
                    (estimate.value - truth[index]).abs() < 1e-6,
                    "{} {}",
                    estimate.name,
                    estimate.value - truth[index]
                );
            }
        }
    }
}

/// Gross errors are found out, and do little.
#[test]
fn outliers_are_named_and_do_little() {
    let model = model("irb120", Groups::USUAL);
    let clean = Simulation {
        count: 100,
        ..Simulation::default()
    };
    let dirty = Simulation {
        outliers: 0.05,
        ..clean
    };
    let error = |simulation: &Simulation| {
        let (truth, measurements) = simulate(&model, simulation).unwrap();
        let result = Calibration::new(model.clone(), measurements)
            .unwrap()
            .run()
            .unwrap();
        let found = result.robot("a test".to_owned()).unwrap().chain().unwrap();
        let real = model.chain_with(&truth).unwrap();
        (apart(&model, &found, &real)[0], result)
    };
    let (alone, result) = error(&clean);
    assert!(result.outliers.is_empty(), "{:?}", result.outliers);
    let (with, result) = error(&dirty);
    assert!(
        (2..12).contains(&result.outliers.len()),
        "{:?}",
        result.outliers
    );
    for (index, residual) in result.after.iter().enumerate() {
        assert_eq!(
            result.outliers.contains(&index),
            residual.length > 0.005,
            "{index} {residual:?}"
        );
    }
    assert!(with < 3.0 * alone, "{with:e} against {alone:e}");
}

/// The round trip: simulate, calibrate, and go where the true arm should: the inverse of the calibrated arm, on the true one.
#[test]
fn the_inverse_of_the_calibrated_arm_hits() {
    for id in ["ar3", "irb120"] {
        let model = model(id, Groups::USUAL);
        let (truth, measurements) = simulate(
            &model,
            &Simulation {
                count: 80,
                ..Simulation::default()
            },
        )
        .unwrap();
        let result = Calibration::new(model.clone(), measurements)
            .unwrap()
            .run()
            .unwrap();
        let held_out = result.held_out.unwrap();
        assert!(held_out.after * 10.0 < held_out.before, "{held_out:?}");
        assert!((0.5..2.0).contains(&result.variance), "{}", result.variance);
        let real = model.chain_with(&truth).unwrap();
        let calibrated = result.robot("a test".to_owned()).unwrap().chain().unwrap();
        let solver = Solver::new(&calibrated).unwrap();
        let nominal = Solver::new(model.chain()).unwrap();
        let mut random = Random::new(5);
        let (mut worst, mut before) = (0.0_f64, 0.0_f64);
        let mut tried = 0;
        while tried < 50 {
            let q = posture(&model, &mut random);
            let goal = tool_pose(&calibrated, &q).unwrap();
            let found = solver.solve(&goal).unwrap();
            assert!(!found.is_empty(), "{id}: {q:?}");
            let off = |q: &[f64]| {
                (tool_pose(&real, q).unwrap().translation.vector - goal.translation.vector).norm()
            };
            worst = worst.max(off(found.as_slice()[0].q()));
            if let Some(solution) = nominal.solve(&goal).unwrap().iter().next() {
                before = before.max(off(solution.q()));
            }
            tried += 1;
        }
        assert!(worst < 2e-4, "{id}: {worst:e}");
        assert!(before > 10.0 * worst, "{id}: {before:e} {worst:e}");
    }
}

/// Chosen postures say more than as many at random.
#[test]
fn chosen_postures_say_more() {
    let model = model("irb120", Groups::USUAL);
    let (_, candidates) = simulate(
        &model,
        &Simulation {
            count: 300,
            ..Simulation::default()
        },
    )
    .unwrap();
    let chosen = design(&model, &candidates, 20).unwrap();
    assert_eq!(chosen.len(), 20);
    let spread = |measurements: Vec<Measurement>| {
        let result = Calibration::new(model.clone(), measurements)
            .unwrap()
            .robust(false)
            .run()
            .unwrap();
        result
            .covariance
            .diagonal()
            .iter()
            .map(|v| v.sqrt().ln())
            .sum::<f64>()
    };
    let best = spread(chosen.iter().map(|&k| candidates[k].clone()).collect());
    let random = spread(candidates[..20].to_vec());
    assert!(best < random - 1.0, "{best} {random}");
}

/// What is wrong with the measurements is said in words.
#[test]
fn wrong_measurements_are_refused_in_words() {
    let model = model("irb120", Groups::USUAL);
    let (_, measurements) = simulate(&model, &Simulation::default()).unwrap();
    let refused = |measurements: Vec<Measurement>| {
        let made = Calibration::new(model.clone(), measurements).and_then(Calibration::run);
        made.err()
            .map(|error| error.to_string())
            .unwrap_or_default()
    };
    assert!(refused(Vec::new()).contains("measurements were expected"));
    assert!(refused(measurements[..4].to_vec()).contains("cannot determine"));
    let mut thousand = measurements.clone();
    for measurement in &mut thousand {
        if let Seen::Pose(pose) = &mut measurement.seen {
            pose.translation.vector *= 1000.0;
        }
    }
    assert!(refused(thousand).contains("are they in millimetres?"));
    let mut zero = measurements.clone();
    zero[3].sigma = 0.0;
    assert!(
        refused(zero).contains("measurement 4"),
        "the place is named"
    );
    let mut far = measurements.clone();
    if let Seen::Pose(pose) = &mut far[7].seen {
        pose.translation.vector.x = 1e200;
    }
    assert!(
        refused(far).contains("measurement 8: 1"),
        "no arm reaches that"
    );
    // A table of one posture, over and over: of the gears nothing shows where every joint is at zero.
    let mut still = measurements.clone();
    for measurement in &mut still {
        measurement.readings.values_mut().fill(0.0);
        if let Seen::Pose(pose) = &mut measurement.seen {
            *pose = tool_pose(model.chain(), &[0.0; 6]).unwrap();
        }
    }
    let gears = Groups {
        gear: true,
        ..Groups::NONE
    };
    let gears = Model::of(&robot("irb120"), gears).unwrap();
    let said = Calibration::new(gears, still).and_then(Calibration::run);
    assert!(
        said.unwrap_err()
            .to_string()
            .contains("none of the parameters shows")
    );
    let mut short = measurements;
    short[0].readings.values_mut().pop();
    assert!(refused(short).contains("measurement 1"));
    assert_eq!(model.parameters()[0].group, Group::Base);
}

/// Hand-eye: a marker anywhere on the tool, seen from anywhere; and a camera on the tool that looks at a target.
#[test]
fn hand_and_eye() {
    let groups = Groups {
        base: true,
        tool: true,
        ..Groups::NONE
    };
    let mut random = Random::new(31);
    for id in ["irb120", "ur5", "ar4-modified"] {
        let model = model(id, groups);
        for _ in 0..20 {
            let mut frame = |reach: f64| {
                let turn = nalgebra::Vector3::from_fn(|_, _| 3.0 * (random.even() - 0.5));
                let way = nalgebra::Vector3::from_fn(|_, _| reach * (random.even() - 0.5));
                pieper::spatial::Pose::new(way, turn)
            };
            let (device, mount) = (frame(4.0), frame(0.3));
            let simulation = Simulation {
                count: 12,
                wrong_lengths: 0.0,
                wrong_angles: 0.0,
                sigma: 1e-9,
                sigma_angle: 1e-9,
                ..Simulation::default()
            };
            let (_, measurements) = simulate(&model, &simulation).unwrap();
            for eye_in_hand in [false, true] {
                let seen = measurements.iter().map(|m| {
                    let tool = tool_pose(model.chain(), m.readings.values()).unwrap();
                    let there = device * tool * mount;
                    let seen = Seen::Pose(if eye_in_hand { there.inverse() } else { there });
                    let measurement = Measurement {
                        readings: m.readings.clone(),
                        seen,
                        sigma: 1e-4,
                        sigma_angle: 1e-4,
                    };
                    if eye_in_hand {
                        measurement.of_eye_in_hand()
                    } else {
                        measurement
                    }
                });
                let result = Calibration::new(model.clone(), seen.collect())
                    .unwrap()
                    .robust(false)
                    .run()
                    .unwrap();
                let worst = result.after.iter().map(|r| r.length).fold(0.0, f64::max);
                assert!(result.converged && worst < 1e-9, "{id}: {worst:e}");
                let found = result.robot("a test".to_owned()).unwrap().chain().unwrap();
                let off = found.tool().inverse() * (model.chain().tool() * mount);
                assert!(off.translation.vector.norm() < 1e-8, "{id}: {off}");
            }
        }
    }
}

/// What drives the joints, by its own numbers: the groups that a test of motors is about.
const DRIVES: Groups = Groups {
    theta: true,
    drive: true,
    ..Groups::NONE
};

/// With motor values, the rates by the drives' numbers agree with differences: four-bar, couplings, servos.
#[test]
fn rates_by_drives_agree_with_differences() {
    for id in ["abb-paper", "irb2400", "irb4400"] {
        let model = model(id, DRIVES);
        let mut random = Random::new(12);
        let mut done = 0;
        while done < 20 {
            let nominal = model.nominal();
            let values: Vec<f64> = nominal
                .iter()
                .map(|x| x * (1.0 + 0.01 * random.normal()) + 0.001 * random.normal())
                .collect();
            let Some(motors) = model
                .motors(&values, &posture(&model, &mut random))
                .unwrap()
            else {
                continue;
            };
            done += 1;
            let readings = Readings::Motors(motors);
            let rates = model.rates(&values, &readings).unwrap();
            for (index, parameter) in model.parameters().iter().enumerate() {
                let h = 1e-6 * parameter.spread;
                // The tool by the arm as it is rebuilt, written and read again: no code is shared with the rates.
                let at = |by: f64| {
                    let mut values = values.clone();
                    values[index] += by;
                    let robot = model.robot_with(&values, String::new()).unwrap();
                    let mut q = vec![0.0; model.chain().dof()];
                    let transmission = robot.transmission().unwrap();
                    transmission
                        .joints(readings.values(), &mut q)
                        .unwrap()
                        .unwrap();
                    tool_pose(&robot.chain().unwrap(), &q).unwrap()
                };
                let (more, less) = (at(h), at(-h));
                let shift = (more.translation.vector - less.translation.vector) / (2.0 * h);
                let [_, by_shift] = rates[index];
                let off = (shift - by_shift).norm() * parameter.spread;
                assert!(off < 1e-7, "{id} {}: {shift} {by_shift}", parameter.name);
            }
        }
    }
}

/// From motor values the drives are found: the lengths of the four-bar, the couplings, the servos' ratios; what shows only together is held.
#[test]
fn the_true_drives_are_found() {
    for id in ["abb-paper", "irb2400", "irb4400"] {
        let model = model(id, DRIVES);
        let simulation = Simulation {
            count: 150,
            of_motors: true,
            wrong_lengths: 2e-3,
            sigma: 1e-12,
            sigma_angle: 1e-12,
            ..Simulation::default()
        };
        let (truth, mut measurements) = simulate(&model, &simulation).unwrap();
        for measurement in &mut measurements {
            (measurement.sigma, measurement.sigma_angle) = (1e-5, 1e-5);
        }
        let result = Calibration::new(model.clone(), measurements)
            .unwrap()
            .run()
            .unwrap();
        assert!(result.converged, "{id}: {}", result.ending);
        let worst = result.after.iter().map(|r| r.length).fold(0.0, f64::max);
        assert!(worst < 1e-9, "{id}: {worst:e} {:?}", result.held);
        // Postures that were not measured: the motors' values are those of the true drives.
        let found = result.robot(String::new()).unwrap();
        let found = Robot::from_toml("found.toml", &found.to_toml().unwrap()).unwrap();
        let (drives, chain) = (found.transmission().unwrap(), found.chain().unwrap());
        let real = model.chain_with(&truth).unwrap();
        let mut random = Random::new(99);
        let mut q = vec![0.0; chain.dof()];
        for _ in 0..100 {
            let posture = posture(&model, &mut random);
            let Some(motors) = model.motors(&truth, &posture).unwrap() else {
                continue;
            };
            drives.joints(&motors, &mut q).unwrap().unwrap();
            let (one, two) = (
                tool_pose(&chain, &q).unwrap(),
                tool_pose(&real, &posture).unwrap(),
            );
            let off = (one.translation.vector - two.translation.vector).norm();
            assert!(off < 1e-8, "{id}: {off:e}");
        }
    }
    // A linkage twice as large is the same drive, and a servo's zero is its joint's.
    let model = model("abb-paper", DRIVES);
    let simulation = Simulation {
        of_motors: true,
        ..Simulation::default()
    };
    let (_, measurements) = simulate(&model, &simulation).unwrap();
    let result = Calibration::new(model, measurements)
        .unwrap()
        .run()
        .unwrap();
    let held: Vec<&str> = result.held.iter().map(|held| held.name.as_str()).collect();
    assert!(held.contains(&"m1.offset"), "{held:?}");
    let lengths = ["m3.crank", "m3.coupler", "m3.rocker", "m3.frame"];
    assert!(lengths.iter().any(|l| held.contains(l)), "{held:?}");
}

/// Columns in another's place are recognised, whatever was measured; and the arm that is only a little off is not taken for such.
#[test]
fn exchanged_columns_are_recognised() {
    for id in ["irb120", "ar3", "ur5"] {
        let model = model(id, Groups::USUAL);
        for kind in [Kind::Poses, Kind::Position, Kind::Positions] {
            let simulation = Simulation {
                kind,
                ..Simulation::default()
            };
            let (_, measurements) = simulate(&model, &simulation).unwrap();
            let refused = |change: &dyn Fn(&mut Measurement)| {
                let mut measurements = measurements.clone();
                measurements.iter_mut().for_each(change);
                let made = Calibration::new(model.clone(), measurements);
                made.err()
                    .map(|error| error.to_string())
                    .unwrap_or_default()
            };
            assert_eq!(refused(&|_| ()), "", "{id}");
            let said = refused(&|m| m.readings.values_mut().swap(1, 2));
            let [two, three] = [1, 2].map(|k| &model.chain().variables()[k].name);
            let words = format!("with {two} and {three} exchanged: are columns exchanged?");
            assert!(said.contains(&words), "{id} {kind:?}: {said}");
            let said = refused(&|m| {
                m.readings
                    .values_mut()
                    .iter_mut()
                    .for_each(|q| *q *= 57.29577951308232)
            });
            assert!(
                said.contains("columns in degrees are called q1_deg"),
                "{id} {kind:?}: {said}"
            );
            let said = refused(&|m| match &mut m.seen {
                Seen::Pose(pose) => pose.translation.vector.swap_rows(0, 1),
                Seen::Position { point, .. } => point.swap(0, 1),
                _ => {}
            });
            assert!(
                said.contains("with x and y exchanged"),
                "{id} {kind:?}: {said}"
            );
        }
    }
}
