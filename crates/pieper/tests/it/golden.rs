//! Poses computed elsewhere, with 50 digits.

use crate::support::difference;
use pieper::describe::Expr;
use pieper::kinematics;

#[test]
fn every_built_in_robot_meets_its_golden_poses() {
    for built_in in pieper_robots::ALL {
        let robot = built_in.robot();
        assert!(
            robot.golden.len() >= 5,
            "{} has too few golden poses",
            built_in.id
        );
        for golden in &robot.golden {
            let values = golden
                .parameters
                .iter()
                .map(|(name, value)| (name.as_str(), Expr::number(*value)));
            let chain = robot.with_parameters(values).unwrap().chain().unwrap();
            let pose = kinematics::tool_pose(&chain, &golden.q).unwrap();
            let reach = golden.pose.translation.vector.norm().max(1.0);
            let off = difference(&pose, &golden.pose);
            assert!(
                off <= 1e-15 * 4.0 * reach,
                "{}: off by {off:e} at {:?}",
                built_in.id,
                golden.q
            );
        }
    }
}

#[test]
fn every_built_in_robot_names_its_source() {
    for built_in in pieper_robots::ALL {
        let robot = built_in.robot();
        assert!(
            !robot.source.is_empty() && !robot.summary.is_empty(),
            "{}",
            built_in.id
        );
    }
}

#[test]
fn every_robot_file_is_built_in() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots");
    for entry in std::fs::read_dir(folder).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if let Some(id) = name.strip_suffix(".toml").filter(|id| *id != "Cargo") {
            assert!(
                pieper_robots::find(id).is_some(),
                "robots/{name} is not listed in robots/src/lib.rs"
            );
        }
    }
}
