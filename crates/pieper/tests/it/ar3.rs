//! The AR3 paper: its seven reference matrices and twelve closed forms; the three published tables of one arm.

use std::f64::consts::FRAC_PI_2;

use crate::support::{difference, matrix, random_joints};
use nalgebra::{Matrix4, Rotation3, Vector3};
use pieper::kinematics::tool_pose;
use pieper::model::Chain;
use pieper::spatial::Pose;
use twofloat::TwoFloat;

fn chain(id: &str) -> Chain {
    pieper_robots::find(id).unwrap().robot().chain().unwrap()
}

/// n, s, a, p at the paper's seven reference positions, exact.
pub(crate) const REFERENCE: [[[f64; 3]; 4]; 7] = [
    [
        [1., 0., 0.],
        [0., 1., 0.],
        [0., 0., 1.],
        [0., 0.6837, 0.164],
    ],
    [
        [0., -1., 0.],
        [1., 0., 0.],
        [0., 0., 1.],
        [0.6837, 0., 0.164],
    ],
    [
        [0., -1., 0.],
        [0., 0., 1.],
        [-1., 0., 0.],
        [0.079, 0., 0.7687],
    ],
    [
        [0., -1., 0.],
        [1., 0., 0.],
        [0., 0., 1.],
        [0.3787, 0., 0.469],
    ],
    [
        [0., 0., -1.],
        [1., 0., 0.],
        [0., -1., 0.],
        [0.3787, 0., 0.469],
    ],
    [
        [0., 0., -1.],
        [0., 1., 0.],
        [1., 0., 0.],
        [0.301, 0.0777, 0.469],
    ],
    [
        [-1., 0., 0.],
        [0., 1., 0.],
        [0., 0., -1.],
        [0.301, 0.0777, 0.469],
    ],
];

#[test]
fn the_seven_reference_matrices_hold() {
    let chain = chain("ar3");
    let mut q = [0.0; 6];
    for (position, columns) in REFERENCE.iter().enumerate() {
        if position > 0 {
            q[position - 1] = if position == 1 { -FRAC_PI_2 } else { FRAC_PI_2 };
        }
        let pose = matrix(&tool_pose(&chain, &q).unwrap());
        let expected = Matrix4::from_fn(|i, j| {
            if i < 3 {
                columns[j][i]
            } else {
                f64::from(j == 3)
            }
        });
        let off = (pose - expected).amax();
        assert!(off <= 1e-15, "position {position} is off by {off:e}");
    }
}

#[test]
fn the_twelve_closed_forms_hold() {
    let chain = chain("ar3");
    let mut random = fastrand::Rng::with_seed(3);
    for _ in 0..2000 {
        let q = random_joints(&chain, &mut random);
        let pose = matrix(&tool_pose(&chain, &q).unwrap());
        for (entry, expected) in closed_form(&q).into_iter().enumerate() {
            let off = f64::from(expected - pose[(entry / 4, entry % 4)]).abs();
            assert!(off <= 1e-15, "entry {entry} is off by {off:e} at {q:?}");
        }
    }
}

/// The paper's expansion with its two misprints corrected, row by row; in twice the digits, so that what differs is ours.
fn closed_form(q: &[f64]) -> [TwoFloat; 12] {
    let [s_1, a1, l2, l4, l6] = [0.164, 0.079, 0.305, 0.222, 0.0777].map(TwoFloat::from);
    let sin_cos = |angle: TwoFloat| (angle.sin(), angle.cos());
    let [(s1, c1), (s2, c2), (s4, c4), (s5, c5), (s6, c6)] =
        [0, 1, 3, 4, 5].map(|joint| sin_cos(TwoFloat::from(q[joint])));
    let (s23, c23) = sin_cos(TwoFloat::from(q[1]) - TwoFloat::from(q[2]));
    [
        c1 * (c4 * c6 - s4 * c5 * s6) - s1 * s23 * (s4 * c6 + c4 * c5 * s6) + s1 * c23 * s5 * s6,
        -s1 * c23 * c5 - c1 * s4 * s5 - s1 * s23 * c4 * s5,
        c1 * (c4 * s6 + s4 * c5 * c6) - s1 * s23 * (s4 * s6 - c4 * c5 * c6) - s1 * c23 * s5 * c6,
        -s1 * (a1 + l2 * c2) - (l4 + l6 * c5) * s1 * c23 - l6 * s5 * (c1 * s4 + s1 * s23 * c4),
        s1 * (c4 * c6 - s4 * c5 * s6) + c1 * s23 * (s4 * c6 + c4 * c5 * s6) - c1 * c23 * s5 * s6,
        c1 * c23 * c5 - s1 * s4 * s5 + c1 * s23 * c4 * s5,
        s1 * (c4 * s6 + s4 * c5 * c6) + c1 * s23 * (s4 * s6 - c4 * c5 * c6) + c1 * c23 * s5 * c6,
        c1 * (a1 + l2 * c2) + (l4 + l6 * c5) * c1 * c23 - l6 * s5 * (s1 * s4 - c1 * s23 * c4),
        -c23 * (s4 * c6 + c4 * c5 * s6) - s23 * s5 * s6,
        s23 * c5 - c23 * c4 * s5,
        s23 * s5 * c6 - c23 * (s4 * s6 - c4 * c5 * c6),
        s_1 + l2 * s2 + (l4 + l6 * c5) * s23 - l6 * c23 * c4 * s5,
    ]
}

#[test]
fn one_arm_three_published_tables() {
    let (ar4, modified, annin) = (chain("ar4"), chain("ar4-modified"), chain("ar3-annin"));
    let flip = Pose::from_parts(
        Vector3::zeros().into(),
        Rotation3::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI),
    );
    let mut random = fastrand::Rng::with_seed(4);
    for _ in 0..1000 {
        let q = random_joints(&ar4, &mut random);
        let pose = tool_pose(&ar4, &q).unwrap();
        assert!(difference(&pose, &tool_pose(&modified, &q).unwrap()) < 2e-15);
        let as_ar3 = [q[0], q[1] - FRAC_PI_2, q[2] + FRAC_PI_2, -q[3], q[4], -q[5]];
        assert!(difference(&pose, &(tool_pose(&annin, &as_ar3).unwrap() * flip)) < 2e-15);
    }
}
