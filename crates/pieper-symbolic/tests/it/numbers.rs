//! Every built-in arm: formulas with numbers put in give the library's poses.

use pieper::describe::Robot;
use pieper_symbolic::basis;
use pieper_symbolic::{Arm, Lengths};

/// A built-in robot with values for its symbols.
pub(crate) fn with_numbers(robot: &Robot) -> Robot {
    let missing: Vec<String> = robot
        .missing_parameters()
        .iter()
        .map(|name| (*name).to_owned())
        .collect();
    let values = missing.iter().enumerate().map(|(index, name)| {
        (
            name.as_str(),
            pieper::describe::Expr::number(0.25 + 0.125 * index as f64),
        )
    });
    robot.with_parameters(values).unwrap()
}

fn check(id: &str, lengths: Lengths) {
    let robot = with_numbers(&pieper_robots::find(id).unwrap().robot());
    let chain = robot.chain().unwrap();
    let arm = Arm::new(&robot, lengths).unwrap();
    let pose = arm.tool_pose().unwrap();
    let cumulative = basis::cumulative(&arm);
    let mut random = fastrand::Rng::with_seed(7);
    for _ in 0..20 {
        let q: Vec<f64> = (0..arm.dof()).map(|_| 6.0 * random.f64() - 3.0).collect();
        let expected = pieper::kinematics::tool_pose(&chain, &q)
            .unwrap()
            .to_homogeneous();
        for row in 0..3 {
            for column in 0..4 {
                let entry = &pose.0[row][column];
                for form in [
                    entry.clone(),
                    cumulative.rewrite(entry),
                    basis::shortest(&arm, entry),
                ] {
                    let value = form.evaluate(&0.0, |var| {
                        arm.value_at(var, &q, &|name| arm.parameter(name))
                    });
                    let off = (value - expected[(row, column)]).abs();
                    assert!(off < 1e-13, "{id} t{}{}: off by {off}", row + 1, column + 1);
                }
            }
        }
    }
}

#[test]
fn formulas_agree_with_the_library_on_every_built_in_arm() {
    for robot in pieper_robots::ALL {
        check(robot.id, Lengths::Symbols);
        check(robot.id, Lengths::Numbers);
    }
}
