//! Mistakes in robot files: each names its place, the text and what was expected.

use pieper::describe::Robot;

const HEAD: &str = "name = \"r\"\nconvention = \"standard\"\n";

fn check(text: &str, expected: &str) {
    let error = Robot::from_toml("r.toml", text)
        .expect_err(text)
        .to_string();
    assert_eq!(error, expected, "for the file\n{text}");
}

fn check_body(body: &str, expected: &str) {
    check(&format!("{HEAD}{body}"), expected);
}

#[test]
fn mistakes_are_named_with_their_place() {
    check(
        "",
        "r.toml: a [[joint]] for each row of the table, [[screws]], or `urdf = ` was expected",
    );
    check(
        "name = ",
        "r.toml:1:8: string values must be quoted, expected literal string",
    );
    check(
        "[[joint]]\ntheta = 'q1'",
        "r.toml: `convention = ` was expected: \"standard\" or \"modified\"",
    );
    check(
        "convention = 'craig'\n[[joint]]\ntheta = 'q1'",
        "r.toml:1:14: convention = 'craig': \"standard\" or \"modified\" was expected",
    );
    check_body(
        "[[joint]]\ntheta = \"pi/2 + q2\"",
        "r.toml:4:9: theta = \"pi/2 + q2\": this row's joint variable is q1, not q2",
    );
    check_body(
        "[[joint]]\ntheta = \"q1 +\"",
        "r.toml:4:9: theta = \"q1 +\": a number, a symbol or '(' was expected at its end",
    );
    check_body(
        "[[joint]]\ntheta = \"2*q1\"",
        "r.toml:4:9: theta = \"2*q1\": \"offset + q1\" or \"offset - q1\" was expected",
    );
    check_body(
        "[[joint]]\nd = 0.1",
        "r.toml:3:1: [[joint]]: theta or d was expected to hold the joint variable, as in theta = \"pi/2 + q1\"",
    );
    check_body(
        "[[joint]]\ntheta = \"q1\"\nd = \"q1\"",
        "r.toml:3:1: [[joint]]: only one of theta and d can hold q1, both do",
    );
    check_body(
        "[[joint]]\ntheta = \"q1\"\na = \"l9\"",
        "r.toml:5:5: a = \"l9\": l9 is unknown: the file has no [parameters]",
    );
    check_body(
        "[parameters]\nl1 = 1\n[[joint]]\ntheta = \"q1\"\na = \"l9\"",
        "r.toml:7:5: a = \"l9\": l9 is unknown: one of l1 was expected",
    );
    check_body(
        "[[joint]]\ntheta = \"q1\"\na = nan",
        "r.toml:5:5: a = nan: a finite number was expected",
    );
    check_body(
        "[[joint]]\ntheta = \"q1\"\nlength = 3",
        "r.toml:5:1: length: one of the keys theta, d, a, alpha, name, limits, velocity, acceleration was expected",
    );
    check_body(
        "[[joint]]\ntheta = \"q1\"\nlimits = [1]",
        "r.toml:5:10: limits = [1]: 2 entries were expected, 1 were found",
    );
    check_body(
        "[[joint]]\ntheta = \"q1\"\nlimits = [2, \"1 deg\"]",
        "r.toml: joint q1: limits [2, 0.017453292519943295]: the lower end lies above the upper end",
    );
    check_body(
        "[parameters]\nl1 = \"l2\"\nl2 = \"l1\"\n[[joint]]\ntheta = \"q1\"\na = \"l1\"",
        "r.toml: parameter l1: it is defined by itself, in a circle",
    );
    check_body(
        "[parameters]\nl1 = \"1/0\"\n[[joint]]\ntheta = \"q1\"\na = \"l1\"",
        "r.toml: \"1/0\": its value is inf",
    );
    check_body(
        "[parameters]\nq1 = 2\n[[joint]]\ntheta = \"q1\"",
        "r.toml:4:1: q1: a name of letters, digits and '_' was expected that is neither pi, a unit, a function nor a \
         joint variable q1, q2, ...",
    );
    check_body(
        "[[screws]]\nh = [0, 0, 0]",
        "r.toml: joint q1: its axis h has length zero",
    );
    check_body(
        "[[screws]]\np = [0, 0, 0]",
        "r.toml:3:1: [[screws]]: `h = ` was expected: the axis, as in h = [0, 0, 1]",
    );
    check_body(
        "[[joint]]\ntheta = 'q1'\n[base]\nrpy = ['q1', 0, 0]",
        "r.toml:6:8: rpy = 'q1': the joint variable q1 cannot stand here",
    );
    check_body(
        "[[joint]]\ntheta = 'q1'\n[[golden]]\nq = [0]\npose = [[1,0,0,0],[0,1,0,0],[0,0,2,0],[0,0,0,1]]",
        "r.toml:7:8: pose = [[1,0,0,0],[0,1,0,0],[0,0,2,0],[0,0,0,1]]: rotation part of the pose: it is not orthonormal: \
         R^T R is off the identity by 3.000e0, at most 1e-6 was expected",
    );
}

#[test]
fn deep_and_long_formulas_are_refused_without_harm() {
    let deep = format!(
        "[[joint]]\ntheta = \"{}q1{}\"",
        "(".repeat(5000),
        ")".repeat(5000)
    );
    let long = format!("[[joint]]\ntheta = \"q1{}\"", " + 1".repeat(5000));
    let signs = format!("[[joint]]\ntheta = \"{}q1\"", "-".repeat(9000));
    for body in [deep, long, signs] {
        let error = Robot::from_toml("r.toml", &format!("{HEAD}{body}")).unwrap_err();
        assert!(error.is_parse(), "{error}");
    }
}
