//! Inverse kinematics of arms made of bytes: nothing panics or takes long, and whatever is answered verifies.

#![no_main]

use std::time::{Duration, Instant};

use libfuzzer_sys::fuzz_target;
use nalgebra::{UnitVector3, Vector3};
use pieper::ik::{Goal, Options, Question, Search, Solver, Status};
use pieper::kinematics::tool_pose;
use pieper::model::{Chain, ChainParts, Drive, Joint, JointKind, Limits, Motion, Variable};
use pieper::spatial::{Pose, shift, turn};

/// The bytes, read one value after the other; zeros when they are used up.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else {
            return 0;
        };
        self.0 = rest;
        first
    }

    /// A length: nothing, a hair, something, or anything from 1e-6 to 1e6.
    fn length(&mut self) -> f64 {
        let (kind, value) = (self.byte(), self.signed());
        match kind % 4 {
            0 => 0.0,
            1 => value * 10_f64.powi(-i32::from(kind / 4) / 4),
            2 => value,
            _ => value.signum() * 10_f64.powf(6.0 * value),
        }
    }

    /// An angle: a multiple of 45 degrees, perhaps missed by a hair, or any.
    fn angle(&mut self) -> f64 {
        let (kind, value) = (self.byte(), self.signed());
        let quarter = f64::from(kind / 4 % 8) * std::f64::consts::FRAC_PI_4;
        match kind % 3 {
            0 => quarter,
            1 => quarter + value * 10_f64.powi(-i32::from(kind / 32) * 2),
            _ => std::f64::consts::PI * value,
        }
    }

    /// Between -1 and 1.
    fn signed(&mut self) -> f64 {
        let value = i16::from_le_bytes([self.byte(), self.byte()]);
        f64::from(value) / 32768.0
    }
}

fn link(bytes: &mut Bytes<'_>) -> Pose {
    shift(Vector3::new(bytes.length(), 0.0, bytes.length()))
        * turn(&Vector3::x_axis(), bytes.angle().sin_cos())
}

fn chain(bytes: &mut Bytes<'_>) -> Option<Chain> {
    let count = usize::from(bytes.byte() % 9) + 1;
    let mut variables = Vec::new();
    let mut joints = Vec::new();
    for index in 0..count {
        let kind = bytes.byte();
        let name = format!("q{}", index + 1);
        // Now and then a joint follows the one before it.
        let follows = kind & 24 == 24 && index > 0;
        if !follows {
            let kind = if kind % 4 == 0 { JointKind::Prismatic } else { JointKind::Revolute };
            let mut variable = Variable::new(name.clone(), kind);
            variable.limits = Limits::new(bytes.angle(), bytes.angle()).ok();
            variables.push(variable);
        }
        let drive = Drive {
            variable: variables.len() - 1,
            factor: [1.0, -1.0, 1.0, 2.0][usize::from(kind / 32 % 4)],
            offset: bytes.angle(),
        };
        let axis: UnitVector3<f64> = Vector3::z_axis();
        let motion = match kind % 4 {
            0 => Motion::Slide(axis, drive),
            _ => Motion::Turn(axis, drive),
        };
        joints.push(Joint { link: name.clone(), name, before: Pose::identity(), motion, after: link(bytes) });
    }
    Chain::new(ChainParts { variables, joints, base: Pose::identity(), tool: Pose::identity() }).ok()
}

fuzz_target!(|data: &[u8]| {
    let mut bytes = Bytes(data);
    let goal = Goal::ALL[usize::from(bytes.byte() % 4)];
    let Some(chain) = chain(&mut bytes) else { return };
    let q: Vec<f64> = (0..chain.dof()).map(|_| bytes.angle()).collect();
    let Ok(mut pose) = tool_pose(&chain, &q) else { return };
    if bytes.byte() % 2 == 1 {
        pose.translation.vector += Vector3::new(bytes.length(), bytes.length(), bytes.length());
        pose.rotation = turn(&Vector3::y_axis(), bytes.angle().sin_cos()).rotation * pose.rotation;
    }
    let begin = Instant::now();
    let Ok(solver) = Solver::prepare(&chain, &Question { goal, ..Question::default() }) else { return };
    let Ok(found) = solver.solve(&pose) else { return };
    let reach: f64 = (0..chain.canonical().steps.len())
        .map(|index| chain.canonical().link(index).translation.vector.norm())
        .sum();
    let scale = 1.0 + reach + pose.translation.vector.norm();
    let check = |q: &[f64]| {
        let reached = tool_pose(&chain, q).expect("finite values, as many as joints");
        let (shift, turn) = goal.miss(&reached, &pose);
        let slides = q.iter().fold(scale, |most, x| most + x.abs());
        assert!(shift <= 1e-10 * slides && turn <= 1e-10, "{shift:e} {turn:e} of {scale:e} at {q:?}");
    };
    found.iter().for_each(|solution| check(solution.q()));
    for family in found.families().iter().take(2) {
        check(family.q());
        solver.samples(family, 9).iter().for_each(|member| check(member));
        for member in solver.samples_within(family, 9) {
            check(&member);
            assert!(chain.variables().iter().zip(&member).all(|(variable, value)| {
                variable.limits.is_none_or(|limits| limits.lower() - 1e-8 <= *value && *value <= limits.upper() + 1e-8)
            }));
        }
        solver.ranges(family);
        check(&solver.nearest_member(family, &q).expect("as many values as joints"));
    }
    assert_eq!(found.status() == Status::Unreachable, found.is_empty() && found.families().is_empty());
    assert_eq!(found.status() == Status::Unreachable, found.reason().is_some());
    if let Ok(search) = Search::new(&chain) {
        search.find(&pose, &q, &Options::default()).expect("a pose and as many values as joints");
    }
    assert!(begin.elapsed() < Duration::from_secs(5), "{:?}", begin.elapsed());
});
