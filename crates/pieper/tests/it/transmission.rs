//! Transmissions: motors to joints and back, speeds, torques, ranges, and what a drive cannot reach.

mod bad_sections;
mod four_bar;

use crate::support::arms;
use pieper::describe::Robot;
use pieper::kinematics::{Jacobian, Reference, joint_torques, pose_and_jacobian, twist};
use pieper::model::{Chain, Drive, Limits};
use pieper::transmission::{
    Assembly, FourBar, Lengths, Motor, OutOfReach, Past, Quantity, Ratios, Transmission,
};

pub(crate) const PAPER: Lengths = Lengths {
    crank: 25.96,
    coupler: 104.33,
    rocker: 29.27,
    frame: 95.0,
};

fn abb() -> (Chain, Transmission) {
    let robot = pieper_robots::find("abb-paper").unwrap().robot();
    (robot.chain().unwrap(), robot.transmission().unwrap())
}

fn term(variable: usize, factor: f64) -> Drive {
    Drive {
        variable,
        factor,
        offset: 0.0,
    }
}

/// Six joints: a four-bar on joint 3 whose pivot does not turn with joint 2, a differential wrist, a wrist whose axis 4
/// is turned by the shaft of another, gears; all of it coupled.
fn coupled() -> (Chain, Transmission) {
    let chain = pieper_robots::find("puma560")
        .unwrap()
        .robot()
        .chain()
        .unwrap();
    let four_bar = FourBar::new(PAPER, Assembly::Open).unwrap();
    let three = Motor::four_bar("elbow", four_bar, term(2, -1.0), Some(term(1, 1.0)), 0.0);
    let sum = |name: &str, terms: &[(usize, f64)], ratio: f64, offset: f64| {
        let terms = terms.iter().map(|&(v, f)| term(v, f)).collect();
        let motor = Motor::linear(name, terms).unwrap();
        motor.geared(ratio, offset).unwrap()
    };
    let motors = [
        (0, sum("base", &[(0, 1.0)], -120.0, 0.3)),
        (2, three.unwrap().geared(80.0, -0.1).unwrap()),
        (3, sum("roll", &[(3, 1.0), (2, 0.25)], 60.0, 0.0)),
        (4, sum("left", &[(3, 0.1), (4, 1.0), (5, 1.0)], 50.0, 1.0)),
        (5, sum("right", &[(4, 1.0), (5, -1.0)], -50.0, 0.0)),
    ];
    let transmission = Transmission::new(&chain, motors).unwrap();
    (chain, transmission)
}

/// A joint vector within the drives' reach: joint 3 between the linkage's dead points.
fn reachable(transmission: &Transmission, random: &mut fastrand::Rng) -> Vec<f64> {
    // Joint by joint: what those before leave free, with the others at zero.
    let mut at = vec![0.0; transmission.dof()];
    at[1] = 1.5;
    for joint in 0..at.len() {
        let range = transmission.range(joint, &at).unwrap().unwrap();
        let (lower, upper) = (range.lower.max(-3.0), range.upper.min(3.0));
        at[joint] = lower + (upper - lower) * (0.001 + 0.998 * random.f64());
    }
    at
}

fn forward(transmission: &Transmission, q: &[f64]) -> Vec<f64> {
    let mut motors = vec![0.0; q.len()];
    transmission.motors(q, &mut motors).unwrap().unwrap();
    motors
}

fn back(transmission: &Transmission, motors: &[f64]) -> Vec<f64> {
    let mut q = vec![0.0; motors.len()];
    transmission.joints(motors, &mut q).unwrap().unwrap();
    q
}

#[test]
fn joints_to_motors_and_back() {
    for (chain, transmission) in [abb(), coupled()] {
        let mut random = fastrand::Rng::with_seed(21);
        for _ in 0..5000 {
            let q = reachable(&transmission, &mut random);
            let motors = forward(&transmission, &q);
            let q_back = back(&transmission, &motors);
            let again = forward(&transmission, &q_back);
            for joint in 0..chain.dof() {
                // Roundings of angles of a few radians, through the gear.
                let scale = 1.0 + transmission.all()[joint].ratio().abs();
                let off = (again[joint] - motors[joint]).abs();
                assert!(off < 1e-13 * scale, "motor {joint}: {off:e} at {q:?}");
                // Near a dead point a small turn of the crank is a large one of the rocker: half the digits.
                let off = (q_back[joint] - q[joint]).abs();
                assert!(off < 1e-7, "joint {joint}: {off:e} at {q:?}");
            }
            if q[2].abs() < 0.6 {
                let off = q.iter().zip(&q_back).map(|(a, b)| (a - b).abs());
                assert!(
                    off.fold(0.0, f64::max) < 1e-13,
                    "{q:?} came back as {q_back:?}"
                );
            }
        }
    }
}

#[test]
fn every_built_in_arm_comes_back_from_its_motors() {
    let mut random = fastrand::Rng::with_seed(22);
    for (id, _) in arms() {
        let robot = pieper_robots::find(id).unwrap().robot();
        let transmission = robot.transmission().unwrap();
        for _ in 0..100 {
            let q = reachable(&transmission, &mut random);
            let q_back = back(&transmission, &forward(&transmission, &q));
            for (a, b) in q.iter().zip(&q_back) {
                assert!((a - b).abs() < 1e-7, "{id}: {q:?} came back as {q_back:?}");
            }
        }
    }
}

#[test]
fn ratios_are_derivatives_and_inverse_to_each_other() {
    for (_, transmission) in [abb(), coupled()] {
        let mut random = fastrand::Rng::with_seed(23);
        let dof = transmission.dof();
        let mut ratios = Ratios::zeros(dof);
        for _ in 0..500 {
            let q = reachable(&transmission, &mut random);
            transmission.ratios(&q, &mut ratios).unwrap().unwrap();
            let product = ratios.motors_by_joints() * ratios.joints_by_motors();
            let off = (product - nalgebra::DMatrix::identity(dof, dof)).amax();
            let size = ratios.motors_by_joints().amax() * ratios.joints_by_motors().amax();
            assert!(off < 1e-14 * size.max(10.0), "{off:e} at {q:?}");
            if q[2].abs() > 0.6 {
                continue;
            }
            let h = 1e-5;
            for joint in 0..dof {
                let moved = |by: f64| {
                    let mut q = q.clone();
                    q[joint] += by;
                    let mut motors = vec![0.0; dof];
                    // The ends of a window do not stop a derivative.
                    match transmission.motors(&q, &mut motors).unwrap() {
                        Ok(()) => Some(motors),
                        Err(_) => None,
                    }
                };
                let (Some(more), Some(less)) = (moved(h), moved(-h)) else {
                    continue;
                };
                for motor in 0..dof {
                    let difference = (more[motor] - less[motor]) / (2.0 * h);
                    let slope = ratios.motors_by_joints()[(motor, joint)];
                    let off = (difference - slope).abs();
                    assert!(
                        off < 1e-7 * (1.0 + slope.abs()),
                        "{motor} by {joint}: {off:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn power_is_the_same_on_either_side_and_the_tool_moves_alike() {
    for (chain, transmission) in [abb(), coupled()] {
        let mut random = fastrand::Rng::with_seed(24);
        let dof = chain.dof();
        let mut ratios = Ratios::zeros(dof);
        let mut jacobian = Jacobian::zeros(dof);
        let numbers = |random: &mut fastrand::Rng| -> Vec<f64> {
            (0..dof).map(|_| 2.0 * random.f64() - 1.0).collect()
        };
        for _ in 0..2000 {
            let q = reachable(&transmission, &mut random);
            transmission.ratios(&q, &mut ratios).unwrap().unwrap();
            pose_and_jacobian(&chain, &q, Reference::Base, &mut jacobian).unwrap();
            let (rates, torques) = (numbers(&mut random), numbers(&mut random));
            let (mut motor_rates, mut motor_torques) = (vec![0.0; dof], vec![0.0; dof]);
            ratios.motor_rates(&rates, &mut motor_rates).unwrap();
            ratios.motor_torques(&torques, &mut motor_torques).unwrap();
            let power =
                |tau: &[f64], rate: &[f64]| tau.iter().zip(rate).map(|(a, b)| a * b).sum::<f64>();
            let size = |tau: &[f64], rate: &[f64]| {
                tau.iter()
                    .zip(rate)
                    .map(|(a, b)| (a * b).abs())
                    .sum::<f64>()
            };
            let (at_joints, at_motors) =
                (power(&torques, &rates), power(&motor_torques, &motor_rates));
            let scale = 1.0 + size(&motor_torques, &motor_rates);
            assert!(
                (at_joints - at_motors).abs() < 1e-13 * scale,
                "{at_joints} {at_motors} at {q:?}"
            );

            let by_motors = ratios.motor_jacobian(&jacobian).unwrap();
            let one = twist(&jacobian, &rates).unwrap();
            let other = twist(&by_motors, &motor_rates).unwrap();
            let scale =
                1.0 + by_motors.amax() * motor_rates.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            assert!((one - other).amax() < 1e-13 * scale, "at {q:?}");

            // A wrench at the tool, by either Jacobian.
            let wrench =
                nalgebra::Vector6::from_iterator(numbers(&mut random)[..6].iter().copied());
            let (mut tau, mut tau_motor, mut direct) =
                (vec![0.0; dof], vec![0.0; dof], vec![0.0; dof]);
            joint_torques(&jacobian, &wrench, &mut tau).unwrap();
            ratios.motor_torques(&tau, &mut tau_motor).unwrap();
            joint_torques(&by_motors, &wrench, &mut direct).unwrap();
            let mut tau_back = vec![0.0; dof];
            ratios.joint_torques(&tau_motor, &mut tau_back).unwrap();
            for joint in 0..dof {
                let scale = 1.0 + by_motors.amax();
                assert!((tau_motor[joint] - direct[joint]).abs() < 1e-13 * scale);
                let scale = 1.0
                    + size(
                        &tau_motor,
                        ratios.motors_by_joints().column(joint).as_slice(),
                    );
                assert!((tau_back[joint] - tau[joint]).abs() < 1e-13 * scale);
            }
        }
    }
}

#[test]
fn a_parallelogram_is_the_sum_of_both_joints() {
    // A rectangle at zero: psi is phi, and the crank's angle over link 1 the forearm's against the horizontal.
    let lengths = Lengths {
        crank: 0.1,
        coupler: 0.7,
        rocker: 0.1,
        frame: 0.7,
    };
    let four_bar = FourBar::new(lengths, Assembly::Open).unwrap();
    let chain = pieper_robots::find("irb140")
        .unwrap()
        .robot()
        .chain()
        .unwrap();
    let linkage = Motor::four_bar("m3", four_bar, term(2, 1.0), Some(term(1, 1.0)), 0.0).unwrap();
    let sum = Motor::linear("m3", vec![term(1, 1.0), term(2, 1.0)]).unwrap();
    let linkage = Transmission::new(&chain, [(2, linkage)]).unwrap();
    let sum = Transmission::new(&chain, [(2, sum)]).unwrap();
    let mut random = fastrand::Rng::with_seed(25);
    for _ in 0..2000 {
        let q: Vec<f64> = (0..6).map(|_| 2.0 * random.f64() - 1.0).collect();
        let (one, other) = (forward(&linkage, &q), forward(&sum, &q));
        for (a, b) in one.iter().zip(&other) {
            assert!((a - b).abs() < 1e-14, "{one:?} {other:?}");
        }
    }
}

fn refused(answer: Result<(), OutOfReach<'_>>, expected: &str) {
    assert_eq!(answer.expect_err(expected).to_string(), expected);
}

#[test]
fn a_drive_says_what_it_cannot_reach_and_by_how_much() {
    let (_, transmission) = abb();
    let rest = [0.0, 90.0, 0.0, 0.0, 0.0, 0.0].map(f64::to_radians);
    let mut out = [0.0; 6];
    let mut check = |joint: usize, degrees: f64, expected: &str| {
        let mut q = rest;
        q[joint] = degrees.to_radians();
        refused(transmission.motors(&q, &mut out).unwrap(), expected);
    };
    check(
        2,
        -60.0,
        "motor m3 (four-bar): q3 = -60.00 deg lies 17.74 deg past the dead point at -42.26 deg, where crank and \
         coupler are in line",
    );
    check(
        2,
        110.0,
        "motor m3 (four-bar): q3 = 110.00 deg lies 8.70 deg past the dead point at 101.30 deg, where coupler and rocker \
         are in line",
    );
    check(
        4,
        -93.5,
        "motor m5 (servo): its value -3.50 deg lies 3.50 deg past the end of its window at 0 deg",
    );
    check(
        1,
        185.0,
        "motor m2 (servo): its value 185.00 deg lies 5.00 deg past the end of its window at 180.00 deg",
    );
    let mut q = rest;
    (q[1], q[2]) = (150_f64.to_radians(), 40_f64.to_radians());
    refused(
        transmission.motors(&q, &mut out).unwrap(),
        "motor m3 (four-bar): its value 192.24 deg lies 12.24 deg past its limit at 180.00 deg",
    );
    // The crank turned further than it can while the upper arm stands: 90 deg and the linkage's 76.28 deg.
    let motors = [90.0, 90.0, 170.0, 90.0, 90.0, 90.0].map(f64::to_radians);
    refused(
        transmission.joints(&motors, &mut out).unwrap(),
        "motor m3 (four-bar): its value 170.00 deg lies 3.72 deg past the dead point at 166.28 deg, where coupler and \
         rocker are in line",
    );
    let motors = [-1.0, 90.0, 90.0, 90.0, 90.0, 90.0].map(f64::to_radians);
    let answer = transmission.joints(&motors, &mut out).unwrap().unwrap_err();
    assert_eq!(
        (answer.quantity(), answer.bound()),
        (Quantity::Motor, Past::Limit)
    );
    assert!((answer.by().to_degrees() - 1.0).abs() < 1e-12 && answer.motor().name() == "m1");
    assert_eq!(answer.end(), 0.0);
    let mut q = rest;
    q[2] = transmission.all()[2].linkage().unwrap().section.phi().upper;
    let answer = transmission.ratios(&q, &mut Ratios::zeros(6)).unwrap();
    refused(
        answer,
        "motor m3 (four-bar): q3 = 101.30 deg is a dead point, where coupler and rocker are in line",
    );
}

#[test]
fn ranges_end_where_the_drives_do() {
    for (_, transmission) in [abb(), coupled()] {
        let mut random = fastrand::Rng::with_seed(26);
        for _ in 0..500 {
            let q = reachable(&transmission, &mut random);
            for joint in 0..q.len() {
                let range = transmission.range(joint, &q).unwrap().unwrap();
                assert!(range.contains(q[joint]));
                for (end, beyond) in [(range.lower, -1e-6), (range.upper, 1e-6)] {
                    if end.is_infinite() {
                        continue;
                    }
                    let mut at = q.clone();
                    at[joint] = end;
                    let mut motors = vec![0.0; q.len()];
                    let answer = transmission.motors(&at, &mut motors).unwrap();
                    assert!(answer.is_ok(), "{} at {at:?}", answer.unwrap_err());
                    at[joint] = end + beyond;
                    assert!(
                        transmission.motors(&at, &mut motors).unwrap().is_err(),
                        "{at:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn bad_input_is_an_error() {
    let (chain, transmission) = abb();
    let check = |error: pieper::Error, expected: &str| {
        assert_eq!(error.to_string(), expected);
    };
    let mut out = [0.0; 6];
    check(
        transmission.motors(&[0.0; 5], &mut out).unwrap_err(),
        "joint values: 6 were expected, 5 were given",
    );
    check(
        transmission
            .motors(&[0.0, f64::NAN, 0.0, 0.0, 0.0, 0.0], &mut out)
            .unwrap_err(),
        "joint value 2 = NaN: a finite number was expected",
    );
    check(
        transmission
            .joints(&[f64::INFINITY; 6], &mut out)
            .unwrap_err(),
        "motor value 1 = inf: a finite number was expected",
    );
    check(
        transmission.joints(&[0.0; 6], &mut out[..4]).unwrap_err(),
        "joint values: room for 6 was expected, there is room for 4",
    );
    check(
        transmission.motor(6, &[0.0; 6]).unwrap_err(),
        "motor 7: there are 6",
    );
    check(
        transmission.range(9, &[0.0; 6]).unwrap_err(),
        "joint 10: there are 6",
    );
    check(
        Ratios::zeros(6)
            .motor_jacobian(&Jacobian::zeros(5))
            .unwrap_err(),
        "Jacobian columns: 6 were expected, 5 were given",
    );
    let linear = |terms: &[(usize, f64)]| {
        Motor::linear("a", terms.iter().map(|&(v, f)| term(v, f)).collect())
    };
    check(linear(&[]).unwrap_err(), "motor a: it drives no joint");
    check(
        linear(&[(1, 1.0), (1, 2.0)]).unwrap_err(),
        "motor a: joint 2 enters twice",
    );
    check(
        linear(&[(0, 0.0)]).unwrap_err(),
        "motor a: joint 1 enters with the factor 0: finite numbers were expected, the factor not zero",
    );
    check(
        linear(&[(0, 1.0)]).unwrap().geared(0.0, 1.0).unwrap_err(),
        "motor a: ratio 0, offset 1: finite numbers were expected, the ratio not zero",
    );
    check(
        Transmission::new(&chain, [(7, linear(&[(0, 1.0)]).unwrap())]).unwrap_err(),
        "motor a: there is no joint 8: the arm has 6",
    );
    let same = || linear(&[(4, 1.0), (5, 2.0)]).unwrap();
    check(
        Transmission::new(&chain, [(4, same()), (5, same())]).unwrap_err(),
        "motors a, a: they do not determine the joints 5, 6",
    );
    check(
        Transmission::new(&chain, [(4, same()), (4, same())]).unwrap_err(),
        "motor a: two motors stand in the place of joint 5",
    );
    let four_bar = FourBar::new(PAPER, Assembly::Open).unwrap();
    let elbow = Motor::four_bar("b", four_bar, term(2, 1.0), Some(term(1, 1.0)), 0.0).unwrap();
    let shoulder = linear(&[(1, 1.0), (2, 1.0)]).unwrap();
    check(
        Transmission::new(&chain, [(1, shoulder), (2, elbow)]).unwrap_err(),
        "motors a, b: joint 3 of the four-bar could only be found together with others; its frame's joint must be \
         driven by another motor",
    );
    check(
        Motor::four_bar("b", four_bar, term(2, 1.0), None, -1.0).unwrap_err(),
        "motor b: the four-bar cannot be assembled where it is to work: the rocker's angle there is -57.295780 deg",
    );
    assert!(Limits::new(1.0, 0.0).is_err());
}

#[test]
fn what_is_written_reads_back_the_same() {
    let text = r#"
name = "r"
convention = "standard"
[parameters]
k = 0.25
[[joint]]
theta = "q1"
[[joint]]
theta = "q2"
a = 0.3
[[joint]]
theta = "q3"
a = 0.2
[[joint]]
d = "q4"
[[transmission]]
kind = "four-bar"
motor = "m3"
name = "elbow motor"
crank = "k"
coupler = 1
rocker = "k + 50 mm"
frame = "0.9"
assembly = "crossed"
rocker_angle = "10 deg - q3"
frame_angle = "q2 - pi/2"
ratio = -20
offset = "k"
limits = ["-20*180 deg", "20*180 deg"]
[[transmission]]
kind = "servo"
motor = "m1"
joint = "q1"
centre = "80 deg"
sign = -1
ratio = "k*8"
window = [0, "270 deg"]
[[transmission]]
kind = "linear"
motor = "m4"
joints = { q1 = "k", q4 = "2*pi/0.02" }
"#;
    let robot = Robot::from_toml("r.toml", text).unwrap();
    let transmission = robot.transmission().unwrap();
    let written = robot.to_toml().unwrap();
    let again = Robot::from_toml("again.toml", &written).unwrap();
    assert_eq!(robot, again, "{written}");
    assert_eq!(transmission, again.transmission().unwrap());
    let q = [0.2, 0.4, -0.3, 0.05];
    let motors = forward(&transmission, &q);
    // The servo turns twice as far, the other way, from its own middle.
    assert!((motors[0] - (80_f64.to_radians() - 2.0 * q[0])).abs() < 1e-15);
    assert_eq!(motors[1], q[1]);
    // A spindle of 20 mm, turned by joint 1 too.
    let spindle = 0.25 * q[0] + std::f64::consts::TAU / 0.02 * q[3];
    assert!((motors[3] - spindle).abs() < 1e-14);
    assert!(!transmission.is_direct());
}

#[test]
fn between_motors_and_joints_nothing_allocates() {
    for (_, transmission) in [abb(), coupled()] {
        let mut random = fastrand::Rng::with_seed(27);
        let q = reachable(&transmission, &mut random);
        let dof = q.len();
        let (mut motors, mut back, mut ratios) = (q.clone(), q.clone(), Ratios::zeros(dof));
        let count = crate::hot_calls::allocations(|| {
            transmission.motors(&q, &mut motors).unwrap().unwrap();
            transmission.joints(&motors, &mut back).unwrap().unwrap();
            transmission.ratios(&q, &mut ratios).unwrap().unwrap();
            ratios.motor_torques(&q, &mut back).unwrap();
            transmission.range(2, &q).unwrap();
        });
        assert_eq!(count, 0);
    }
}
