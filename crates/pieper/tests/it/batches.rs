//! Many poses at once equal one at a time.

use crate::support::{arms, difference, random_joints};
use pieper::describe::Robot;
use pieper::kinematics::batch::{JointBatch, PoseBatch, tool_poses};
use pieper::kinematics::{link_poses, tool_pose, tool_pose_by_quaternions};

#[test]
fn four_ways_to_the_tool_pose_agree() {
    let mut random = fastrand::Rng::with_seed(1);
    for (id, chain) in arms() {
        // Not a multiple of any register's width.
        let count = 203;
        let inputs: Vec<Vec<f64>> = (0..count)
            .map(|_| random_joints(&chain, &mut random))
            .collect();
        let mut batch = JointBatch::zeros(chain.dof(), count);
        inputs
            .iter()
            .enumerate()
            .for_each(|(index, q)| batch.set(index, q));
        let mut poses = PoseBatch::zeros(count);
        tool_poses(&chain, &batch, &mut poses).unwrap();
        let mut links = Vec::new();
        for (index, q) in inputs.iter().enumerate() {
            let pose = tool_pose(&chain, q).unwrap();
            let scale = pose.translation.vector.norm().max(1.0) * 4e-15;
            link_poses(&chain, q, &mut links).unwrap();
            let by_links = links.last().unwrap() * chain.tool();
            let by_quaternions = nalgebra::convert(tool_pose_by_quaternions(&chain, q).unwrap());
            for (way, other) in [
                ("batch", poses.get(index)),
                ("links", by_links),
                ("quaternions", by_quaternions),
            ] {
                let off = difference(&pose, &other);
                assert!(off < scale, "{id}: {way} is off by {off:e} at {q:?}");
            }
        }
    }
}

/// Arms with a spherical wrist behind two parallel axes go by formulas: twists either way round, every offset there or
/// not, joints that count backwards, the foot anywhere.
#[test]
fn industrial_arms_of_every_make() {
    let mut random = fastrand::Rng::with_seed(11);
    for arm in 0..400 {
        let mut pick = |all: &[&str]| all[random.usize(..all.len())].to_owned();
        let square = ["pi/2", "-pi/2"];
        let twists = [
            pick(&square),
            pick(&["0", "pi"]),
            pick(&square),
            pick(&square),
            pick(&square),
            pick(&["0", "pi", "pi/2", "-pi/2"]),
        ];
        let mut text = "name = 'arm'\nconvention = 'standard'\n".to_owned();
        for (joint, twist) in twists.iter().enumerate() {
            let mut length = |there: bool| match there && random.bool() {
                true => 2.0 * random.f64() - 1.0,
                false => 0.0,
            };
            let (d, a) = (length(joint != 4), length(joint < 3));
            let sign = if random.bool() { '-' } else { '+' };
            let offset = ["0", "pi/2", "-pi/2", "pi", "0.3"][random.usize(..5)];
            text += &format!(
                "[[joint]]\ntheta = '{offset} {sign} q{}'\nd = {d}\na = {a}\nalpha = '{twist}'\n",
                joint + 1
            );
        }
        text += &format!("[base]\nxyz = [0.1, {}, -0.2]\n", random.f64());
        let chain = Robot::from_toml("arm.toml", &text)
            .unwrap()
            .chain()
            .unwrap();
        let mut batch = JointBatch::zeros(6, 16);
        let inputs: Vec<Vec<f64>> = (0..16)
            .map(|_| random_joints(&chain, &mut random))
            .collect();
        for (index, q) in inputs.iter().enumerate() {
            batch.set(index, q);
        }
        let mut poses = PoseBatch::zeros(16);
        tool_poses(&chain, &batch, &mut poses).unwrap();
        for (index, q) in inputs.iter().enumerate() {
            let off = difference(&tool_pose(&chain, q).unwrap(), &poses.get(index));
            assert!(off < 1e-14, "arm {arm}, off by {off:e} at {q:?}:\n{text}");
        }
    }
}

#[test]
fn large_angles_take_the_long_way_and_what_is_not_finite_is_named() {
    let (_, chain) = arms().next().unwrap();
    let mut batch = JointBatch::zeros(6, 20);
    let turns = std::f64::consts::TAU * 1e6;
    batch.set(5, &[0.1 + turns, 0.2, 0.3, 0.4, 0.5, 0.6]);
    let mut poses = PoseBatch::zeros(20);
    tool_poses(&chain, &batch, &mut poses).unwrap();
    let near = tool_pose(&chain, &[0.1, 0.2, 0.3, 0.4, 0.5, 0.6]).unwrap();
    // A double near six million radians has steps of 1e-9.
    assert!(difference(&poses.get(5), &near) < 2e-9);
    assert!(
        difference(
            &poses.get(5),
            &tool_pose(&chain, &[0.1 + turns, 0.2, 0.3, 0.4, 0.5, 0.6]).unwrap()
        ) < 1e-14
    );
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for index in [3, 19] {
            let mut batch = batch.clone();
            batch.set(index, &[0.0, 0.0, bad, 0.0, 0.0, 0.0]);
            let error = tool_poses(&chain, &batch, &mut poses).unwrap_err();
            assert!(
                error.is_input() && error.to_string().contains(&format!("joint vector {index}")),
                "{error}"
            );
        }
        let error = tool_pose(&chain, &[0.0, bad, 0.0, 0.0, 0.0, 0.0])
            .unwrap_err()
            .to_string();
        assert!(error.starts_with("joint value J2"), "{error}");
    }
    assert!(
        tool_pose(&chain, &[0.0; 5])
            .unwrap_err()
            .to_string()
            .contains("6 were expected")
    );
    assert!(tool_poses(&chain, &JointBatch::zeros(5, 20), &mut poses).is_err());
    assert!(tool_poses(&chain, &JointBatch::zeros(6, 21), &mut poses).is_err());
}

#[cfg(feature = "rayon")]
#[test]
fn over_all_cores_the_poses_are_the_same_to_the_last_bit() {
    use pieper::kinematics::batch::tool_poses_parallel;
    let (_, chain) = arms().next().unwrap();
    let mut random = fastrand::Rng::with_seed(2);
    // Several pieces and a ragged end.
    let count = 3 * 4096 + 5;
    let mut batch = JointBatch::zeros(6, count);
    (0..count).for_each(|index| batch.set(index, &random_joints(&chain, &mut random)));
    let (mut one, mut all) = (PoseBatch::zeros(count), PoseBatch::zeros(count));
    tool_poses(&chain, &batch, &mut one).unwrap();
    tool_poses_parallel(&chain, &batch, &mut all).unwrap();
    assert!((0..count).all(|index| one.get(index) == all.get(index)));
    batch.set(9000, &[f64::NAN; 6]);
    let error = tool_poses_parallel(&chain, &batch, &mut all).unwrap_err();
    assert!(error.to_string().contains("joint vector 9000"), "{error}");
}
