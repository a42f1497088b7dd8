//! Manipulability, singularities, direction cosines, reach.

use crate::support::{arms, random_joints};
use pieper::kinematics::{
    Directions, Jacobian, Reference, measures, pose_and_jacobian, reach, tool_pose,
};

#[test]
fn manipulability_is_the_root_of_the_determinant() {
    let mut random = fastrand::Rng::with_seed(12);
    for (id, chain) in arms() {
        let q = random_joints(&chain, &mut random);
        let mut jacobian = Jacobian::zeros(chain.dof());
        pose_and_jacobian(&chain, &q, Reference::Base, &mut jacobian).unwrap();
        let found = measures(&jacobian).unwrap();
        let gram = if chain.dof() < 6 {
            (jacobian.transpose() * &jacobian).determinant()
        } else {
            (&jacobian * jacobian.transpose()).determinant()
        };
        let expected = gram.max(0.0).sqrt();
        assert!(
            (found.manipulability - expected).abs() < 1e-9,
            "{id}: {} {expected}",
            found.manipulability
        );
        let smallest = found.singularity.distance;
        let idle = &jacobian * &found.singularity.idle_joints;
        assert!(
            (idle.norm() - smallest).abs() < 1e-12,
            "{id}: the idle motion moves the tool by {}",
            idle.norm()
        );
        let lost = jacobian.transpose() * found.singularity.lost_twist;
        assert!((lost.norm() - smallest).abs() < 1e-12, "{id}");
    }
}

#[test]
fn a_stretched_wrist_is_singular_and_says_what_is_lost() {
    let (_, chain) = arms().next().unwrap();
    let mut jacobian = Jacobian::zeros(6);
    let q = [0.1, 0.7, 0.4, 0.3, 0.0, 0.2];
    pose_and_jacobian(&chain, &q, Reference::Base, &mut jacobian).unwrap();
    let found = measures(&jacobian).unwrap();
    assert!(found.singularity.distance < 1e-15 && found.condition > 1e14);
    // Joints 4 and 6 turn against each other, the tool stands still.
    let idle = &found.singularity.idle_joints;
    assert!(
        (idle[3] + idle[5]).abs() < 1e-12 && (idle[3].abs() - 0.5_f64.sqrt()).abs() < 1e-12,
        "{idle}"
    );
}

#[test]
fn direction_cosines_belong_to_their_angles() {
    let mut random = fastrand::Rng::with_seed(13);
    for (id, chain) in arms() {
        let pose = tool_pose(&chain, &random_joints(&chain, &mut random)).unwrap();
        let directions = Directions::of(&pose);
        for axis in [directions.i, directions.j, directions.k] {
            let squares: f64 = axis.cosines.iter().map(|c| c * c).sum();
            assert!((squares - 1.0).abs() < 1e-14, "{id}");
            for (cosine, angle) in axis.cosines.iter().zip(axis.angles) {
                assert!((angle.cos() - cosine).abs() < 1e-15, "{id}");
            }
        }
    }
}

#[test]
fn no_random_pose_lies_beyond_the_reach() {
    let mut random = fastrand::Rng::with_seed(14);
    for (id, chain) in arms() {
        let found = reach(&chain).unwrap();
        for _ in 0..500 {
            let q: Vec<f64> = chain
                .variables()
                .iter()
                .map(|v| match v.limits {
                    Some(limits) => {
                        limits.lower() + random.f64() * (limits.upper() - limits.lower())
                    }
                    None => 6.3 * (random.f64() - 0.5),
                })
                .collect();
            let p = tool_pose(&chain, &q).unwrap().translation.vector;
            assert!(
                p.norm() <= found.from_base * (1.0 + 1e-12),
                "{id}: {} > {}",
                p.norm(),
                found.from_base
            );
        }
    }
}
