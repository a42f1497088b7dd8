//! The same arm in every description: numerically equal.

use crate::support::{arms, difference, random_joints};
use pieper::describe::{Convention, DhTable, Expr, Form, Robot, ScrewTable, expr::Values};
use pieper::kinematics::tool_pose;
use pieper::model::Chain;

fn check(id: &str, way: &str, one: &Chain, other: &Chain, random: &mut fastrand::Rng) {
    for _ in 0..50 {
        let q = random_joints(one, random);
        let (a, b) = (tool_pose(one, &q).unwrap(), tool_pose(other, &q).unwrap());
        let off = difference(&a, &b);
        assert!(off < 1e-14, "{id} as {way} is off by {off:e} at {q:?}");
    }
}

/// Found by fuzzing: in a text of several lines a backslash in front of an n is no line break.
#[test]
fn texts_of_several_lines_are_written_as_they_are() {
    let file = "name = 'r'\nconvention = 'standard'\nsource = \"\"\"\na \\\\n \\\"b\\\"\n\\u009B\tc\\\\\"\"\"\n[[joint]]\ntheta = 'q1'\na = 1";
    let robot = Robot::from_toml("r.toml", file).unwrap();
    assert_eq!(robot.source, "a \\n \"b\"\n\u{9b}\tc\\");
    let again = Robot::from_toml("again.toml", &robot.to_toml().unwrap()).unwrap();
    assert_eq!(robot, again);
}

#[test]
fn tables_and_screws_of_every_arm_are_equal() {
    let mut random = fastrand::Rng::with_seed(10);
    for (id, chain) in arms() {
        for convention in [Convention::Standard, Convention::Modified] {
            let table = DhTable::of_chain(&chain, convention).unwrap();
            check(
                id,
                convention.name(),
                &chain,
                &table.chain(&Values::new()).unwrap(),
                &mut random,
            );
        }
        let screws = ScrewTable::of_chain(&chain).unwrap();
        let as_screws = screws.chain(&Values::new()).unwrap();
        check(id, "screws", &chain, &as_screws, &mut random);
        let back = DhTable::of_chain(&as_screws, Convention::Standard).unwrap();
        check(
            id,
            "a table of its screws",
            &chain,
            &back.chain(&Values::new()).unwrap(),
            &mut random,
        );
    }
}

#[test]
fn a_written_robot_file_reads_back_the_same() {
    for built_in in pieper_robots::ALL {
        let mut robot = built_in.robot();
        robot.golden.clear();
        let text = robot.to_toml().unwrap();
        let back = Robot::from_toml("written.toml", &text).unwrap();
        assert_eq!(robot, back, "{}:\n{text}", built_in.id);
        let Ok(chain) = robot.chain() else { continue };
        let screws = Robot {
            form: Form::Screws(ScrewTable::of_chain(&chain).unwrap()),
            ..robot
        };
        let back = Robot::from_toml("screws.toml", &screws.to_toml().unwrap()).unwrap();
        let mut random = fastrand::Rng::with_seed(11);
        check(
            built_in.id,
            "written screws",
            &chain,
            &back.chain().unwrap(),
            &mut random,
        );
    }
}

#[test]
fn symbols_stay_symbols_until_numbers_are_asked_for() {
    let robot = pieper_robots::find("six-axis").unwrap().robot();
    assert_eq!(robot.missing_parameters(), ["d1", "a2", "d4", "d6"]);
    let error = robot.chain().unwrap_err();
    assert!(error.is_missing_value());
    assert!(
        error
            .to_string()
            .ends_with("numbers are needed for the parameters d1, a2, d4, d6"),
        "{error}"
    );
    let some = robot
        .with_parameters([("d1", Expr::number(0.4)), ("a2", Expr::number(0.3))])
        .unwrap();
    assert_eq!(some.missing_parameters(), ["d4", "d6"]);
    assert!(
        robot
            .with_parameters([("d9", Expr::number(0.4))])
            .unwrap_err()
            .to_string()
            .contains("d1, a2, d4, d6")
    );
}

#[test]
fn formulas_print_as_they_read() {
    for text in [
        "q1",
        "pi/2 + q1",
        "-l2*sin(beta)",
        "2*(a + b)",
        "a - (b - c)",
        "(a/b)/c",
        "a/(b/c)",
        "2^-3",
        "(-a)^2",
        "164 mm",
        "-170 deg",
        "atan2(y, x)",
        "1e-7",
        "(5 mm)^2",
    ] {
        let expr = Expr::parse(text).unwrap();
        let printed = expr.to_string();
        assert_eq!(
            Expr::parse(&printed).unwrap(),
            expr,
            "{text} printed as {printed}"
        );
    }
}
