//! Mistakes in `[[transmission]]`: each names its place, the text and what was expected.

use pieper::describe::Robot;

const HEAD: &str = "name = 'r'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\n[[joint]]\ntheta = 'q2'\na = 1\n";

/// A section from line 8 on, and the error.
fn check(section: &str, expected: &str) {
    let text = format!("{HEAD}[[transmission]]\n{section}");
    let error = Robot::from_toml("r.toml", &text).expect_err(section);
    assert_eq!(error.to_string(), expected, "for\n{section}");
}

const BARS: &str =
    "kind = 'four-bar'\nmotor = 'm2'\ncrank = 1\ncoupler = 4\nrocker = 1\nframe = 4\n";

#[test]
fn mistakes_are_named_with_their_place() {
    check(
        "motor = 'm1'",
        "r.toml:8:1: [[transmission]]: `kind = ` was expected: \"linear\", \"four-bar\" or \"servo\"",
    );
    check(
        "kind = 'belt'",
        "r.toml:9:8: kind = 'belt': \"linear\", \"four-bar\" or \"servo\" was expected",
    );
    check(
        "kind = 'servo'",
        "r.toml:8:1: [[transmission]]: `motor = ` was expected: the motor's place, as in motor = \"m3\"",
    );
    check(
        "kind = 'servo'\nmotor = 'm3'",
        "r.toml:10:9: motor = 'm3': one of the motors m1 to m2 was expected",
    );
    check(
        "kind = 'servo'\nmotor = 2",
        "r.toml:10:9: motor = 2: a string in quotes was expected",
    );
    check(
        "kind = 'servo'\nmotor = 'm1'",
        "r.toml:8:1: [[transmission]]: `joint = ` was expected: the joint it turns, as in joint = \"q1\"",
    );
    check(
        "kind = 'servo'\nmotor = 'm1'\njoint = 'q0'",
        "r.toml:11:9: joint = 'q0': one of the joints q1 to q2 was expected",
    );
    check(
        "kind = 'servo'\nmotor = 'm1'\njoint = 'q1'\nsign = 2",
        "r.toml:12:8: sign = 2: 1 or -1 was expected",
    );
    check(
        "kind = 'servo'\nmotor = 'm1'\njoint = 'q1'\noffset = 2",
        "r.toml:12:1: offset: one of the keys kind, motor, name, joint, centre, sign, ratio, window was expected",
    );
    check(
        "kind = 'servo'\nmotor = 'm1'\njoint = 'q1'\nwindow = [3, 1]",
        "r.toml: motor m1: limits [3, 1]: the lower end lies above the upper end",
    );
    check(
        "kind = 'servo'\nmotor = 'm1'\njoint = 'q1'\nwindow = [3]",
        "r.toml:12:10: window = [3]: 2 entries were expected, 1 were found",
    );
    check(
        "kind = 'linear'\nmotor = 'm2'",
        "r.toml:8:1: [[transmission]]: `joints = ` was expected: the joints with their factors, as in joints = { q2 = 1, \
         q3 = 1 }",
    );
    check(
        "kind = 'linear'\nmotor = 'm2'\njoints = ['q1']",
        "r.toml:11:10: joints = ['q1']: a table was expected",
    );
    check(
        "kind = 'linear'\nmotor = 'm2'\njoints = {}",
        "r.toml: motor m2: it drives no joint",
    );
    check(
        "kind = 'linear'\nmotor = 'm2'\njoints = { q5 = 1 }",
        "r.toml:11:17: q5 = 1: one of the joints q1 to q2 was expected",
    );
    check(
        "kind = 'linear'\nmotor = 'm2'\njoints = { q2 = 'x' }",
        "r.toml:11:17: q2 = 'x': x is unknown: the file has no [parameters]",
    );
    check(
        "kind = 'linear'\nmotor = 'm2'\njoints = { q2 = 0 }",
        "r.toml: motor m2: joint 2 enters with the factor 0: finite numbers were expected, the factor not zero",
    );
    check(
        "kind = 'linear'\nmotor = 'm2'\njoints = { q2 = 1 }\nratio = nan",
        "r.toml:12:9: ratio = nan: a finite number was expected",
    );
    check(
        "kind = 'linear'\nmotor = 'm2'\njoints = { q2 = 1 }\nratio = 0",
        "r.toml: motor m2: ratio 0, offset 0: finite numbers were expected, the ratio not zero",
    );
    check(
        "kind = 'linear'\nmotor = 'm2'\njoints = { q1 = 1 }",
        "r.toml: motors m1, m2: they do not determine the joints 1, 2",
    );
    check(
        "kind = 'linear'\nmotor = 'm2'\njoints = { q2 = 1 }\n[[transmission]]\nkind = 'servo'\nmotor = 'm2'\njoint = 'q2'",
        "r.toml:12:1: [[transmission]]: one [[transmission]] for each motor was expected, m2 has two",
    );
}

#[test]
fn mistakes_in_a_four_bar_too() {
    check(
        "kind = 'four-bar'\nmotor = 'm2'\ncrank = 1",
        "r.toml:8:1: [[transmission]]: `coupler = ` was expected: the length of that bar",
    );
    let bars = |more: &str, expected: &str| check(&format!("{BARS}{more}"), expected);
    bars(
        "",
        "r.toml:8:1: [[transmission]]: `rocker_angle = ` was expected: the rocker's angle, 0 where it is perpendicular \
         to the frame, as in rocker_angle = \"q3\"",
    );
    let expected =
        "\"offset + q\" or \"offset - q\" was expected, q being one of the joints q1 to q2";
    for angle in ["2*q2", "1", "q3", "q1*q2"] {
        let text = format!("r.toml:15:16: rocker_angle = '{angle}': {expected}");
        bars(&format!("rocker_angle = '{angle}'"), &text);
    }
    bars(
        "rocker_angle = 'q2 + x'",
        "r.toml:15:16: rocker_angle = 'q2 + x': x is unknown: one of q2 was expected",
    );
    bars(
        "rocker_angle = 'q2'\nassembly = 'closed'",
        "r.toml:16:12: assembly = 'closed': \"open\" or \"crossed\" was expected",
    );
    bars(
        "rocker_angle = 'q2'\nframe_angle = 'q2'",
        "r.toml: motor m2: joint 2 enters twice",
    );
    bars(
        "rocker_angle = 'q2'\ncentre = 1",
        "r.toml:16:1: centre: one of the keys kind, motor, name, crank, coupler, rocker, frame, assembly, rocker_angle, \
         frame_angle, ratio, offset, limits was expected",
    );
    let lengths = |crank: &str, frame: &str| {
        format!(
            "kind = 'four-bar'\nmotor = 'm2'\ncrank = {crank}\ncoupler = 4\nrocker = 1\nframe = {frame}\nrocker_angle = 'q2'"
        )
    };
    check(
        &lengths("-1", "4"),
        "r.toml: motor m2: four-bar, crank = -1: a positive length was expected",
    );
    check(
        &lengths("1", "7"),
        "r.toml: motor m2: four-bar, frame = 7: it can be assembled nowhere: the others together measure 6, less than \
         that",
    );
    check(
        &lengths("0.5", "5"),
        "r.toml: motor m2: the four-bar cannot be assembled where it is to work: the rocker's angle there is 0.000000 deg",
    );
}

#[test]
fn numbers_may_come_later() {
    let text = format!(
        "{HEAD}[parameters]\nk = '?'\n[[transmission]]\nkind = 'linear'\nmotor = 'm2'\njoints = {{ q1 = 'k', q2 = 1 }}"
    );
    let robot = Robot::from_toml("r.toml", &text).unwrap();
    assert!(robot.chain().is_ok());
    let error = robot.transmission().unwrap_err();
    assert!(error.is_missing_value());
    assert_eq!(error.to_string(), "\"k\": k has no value");
    let set = [("k", pieper::describe::Expr::number(2.0))];
    assert!(robot.with_parameters(set).unwrap().transmission().is_ok());
}
