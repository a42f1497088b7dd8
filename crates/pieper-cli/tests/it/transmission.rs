//! Arms whose motors do not drive their joints directly: motor values in and out, and what a drive cannot reach.

use crate::support::{Temporary, pieper};
use serde_json::Value;

fn json(arguments: &[&str], code: i32) -> Value {
    let ended = pieper(arguments);
    assert_eq!(ended.code, code, "{arguments:?}: {}", ended.stderr);
    serde_json::from_str(&ended.stdout).expect("JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter().map(|x| x.as_f64().expect("a number")).collect()
}

#[test]
fn motors_in_and_out() {
    let q = "10,80,20,5,-30,40";
    let by_joints = json(
        &[
            "fk",
            "abb-paper",
            "--q",
            q,
            "--deg",
            "--json",
            "--jacobian",
            "base",
        ],
        0,
    );
    let motors = numbers(&by_joints["motors"]);
    // The servos stand at 90 where the joint is at zero; the crank turns with joint 2 and the linkage.
    let psi = 22.308_769_220_302;
    for (motor, expected) in motors
        .iter()
        .zip([100.0, 80.0, 80.0 + psi, 95.0, 60.0, 130.0])
    {
        assert!((motor - expected).abs() < 1e-9, "{motors:?}");
    }
    let text: Vec<String> = motors.iter().map(f64::to_string).collect();
    let by_motors = json(
        &[
            "fk",
            "abb-paper",
            "--motors",
            &text.join(","),
            "--deg",
            "--json",
        ],
        0,
    );
    for (a, b) in numbers(&by_motors["q"])
        .iter()
        .zip([10.0, 80.0, 20.0, 5.0, -30.0, 40.0])
    {
        assert!((a - b).abs() < 1e-11);
    }
    let rows = |key: &str| -> Vec<Vec<f64>> {
        by_joints[key]
            .as_array()
            .expect("rows")
            .iter()
            .map(numbers)
            .collect()
    };
    // The crank alone: the column of joint 3, slower by the linkage's ratio. The same twist for joint 2 and the crank
    // turning along with it.
    let (jacobian, by_motor) = (rows("jacobian"), rows("motor_jacobian"));
    for (row, motor_row) in jacobian.iter().zip(&by_motor) {
        let ratio = jacobian[0][2] / by_motor[0][2];
        assert!((row[2] - ratio * motor_row[2]).abs() < 1e-12);
        assert!((row[1] - motor_row[1] - motor_row[2]).abs() < 1e-12);
    }
}

#[test]
fn what_a_drive_cannot_reach_is_a_negative_answer() {
    let words =
        "motor m3 (four-bar): its value 170.00 deg lies 3.72 deg past the dead point at 166.28 deg";
    let arguments = ["fk", "abb-paper", "--motors", "90,90,170,90,90,90", "--deg"];
    let ended = pieper(&arguments);
    assert_eq!(ended.code, 1, "{}", ended.stderr);
    assert!(ended.stdout.contains(words), "{}", ended.stdout);
    let document = json(&[&arguments[..], &["--json"]].concat(), 1);
    assert!(
        document["pose"].is_null()
            && document["drive"]
                .as_str()
                .is_some_and(|text| text.starts_with(words))
    );

    // Joint values out of a drive's reach have a pose all the same.
    let document = json(
        &[
            "fk",
            "abb-paper",
            "--q",
            "0,90,-60,0,0,0",
            "--deg",
            "--json",
        ],
        0,
    );
    assert!(document["motors"][2].is_null() && document["motors"][1].is_number());
    let reason = document["drive"].as_str().expect("a reason");
    assert!(
        reason.contains("q3 = -60.00 deg lies 17.74 deg past the dead point"),
        "{reason}"
    );
}

#[test]
fn bad_motor_values_are_refused() {
    for (motors, words) in [
        (
            "1,2",
            "--motors: motor values: 6 were expected, 2 were given",
        ),
        (
            "1,2,x,4,5,6",
            "--motors: \"x\": a finite number was expected",
        ),
        (
            "1,2,inf,4,5,6",
            "--motors: \"inf\": a finite number was expected",
        ),
    ] {
        let ended = pieper(&["fk", "abb-paper", "--motors", motors]);
        assert_eq!(ended.code, 2, "{}", ended.stdout);
        assert!(ended.stderr.contains(words), "{}", ended.stderr);
    }
}

#[test]
fn batches_take_motors_too() {
    let folder = Temporary::new();
    let lines = "{\"id\": 1, \"motors\": [1.5, 1.5, 1.6, 1.5, 1.5, 1.5]}\n{\"id\": 2, \"motors\": [9, 1, 1, 1, 1, 1]}\n\
                 {\"id\": 3, \"motors\": 7}\n";
    let file = folder.file("in.jsonl", lines);
    let ended = pieper(&["fk", "abb-paper", "--input", &file]);
    assert_eq!(ended.code, 1);
    let answers: Vec<Value> = ended
        .stdout
        .lines()
        .map(|line| serde_json::from_str(line).expect("JSON"))
        .collect();
    let (motors, given) = (
        numbers(&answers[0]["motors"]),
        [1.5, 1.5, 1.6, 1.5, 1.5, 1.5],
    );
    assert!(
        motors.iter().zip(given).all(|(a, b)| (a - b).abs() < 1e-12),
        "{motors:?}"
    );
    let error = |index: usize| {
        answers[index]["error"]
            .as_str()
            .expect("an error")
            .to_owned()
    };
    assert!(
        error(1).contains("motor m1 (servo): its value 515.66 deg lies 335.66 deg past"),
        "{}",
        error(1)
    );
    assert_eq!(
        error(2),
        "line 3: \"motors\" = 7: a list of numbers was expected"
    );
}

#[test]
fn a_solution_names_the_drive_that_cannot_reach_it() {
    let pose = json(
        &[
            "fk",
            "abb-paper",
            "--q",
            "10,80,20,5,-30,40",
            "--deg",
            "--json",
        ],
        0,
    )["pose"]
        .to_string();
    let document = json(&["ik", "abb-paper", "--pose", &pose, "--deg", "--json"], 0);
    let solutions = document["solutions"].as_array().expect("solutions");
    let (mut reached, mut refused) = (0, 0);
    for solution in solutions {
        let motors = solution["motors"].as_array().expect("motors");
        if solution["drive"].is_null() {
            reached += 1;
            assert!(motors.iter().all(Value::is_number));
        } else {
            refused += 1;
            assert!(motors.iter().any(Value::is_null));
            assert_eq!(solution["within_limits"], false);
        }
    }
    assert!(reached > 0 && refused > 0, "{document}");
    let within = json(
        &[
            "ik",
            "abb-paper",
            "--pose",
            &pose,
            "--deg",
            "--json",
            "--limits",
        ],
        0,
    );
    let within = within["solutions"].as_array().expect("solutions");
    assert!(!within.is_empty() && within.iter().all(|one| one["drive"].is_null()));
    // Arms without a transmission answer as before.
    let plain = json(
        &["ik", "ar3", "--pose", "0.3,0.2,0.35,0.1,0.8,0.3", "--json"],
        0,
    );
    assert!(plain["solutions"][0].get("motors").is_none());
}

#[test]
fn info_shows_reach_dead_points_and_ratio() {
    let ended = pieper(&["info", "abb-paper"]);
    for words in [
        "four-bar of m3, open: crank 0.02596, coupler 0.10433, rocker 0.02927, frame 0.095",
        "-42.26 to 222.26",
        "phi -42.26, psi -85.27: crank and coupler are in line",
        "phi 101.30, psi 76.28: coupler and rocker are in line",
        "ratio dpsi/dphi at q3 = 0  1.1",
    ] {
        assert!(ended.stdout.contains(words), "{words} in\n{}", ended.stdout);
    }
    let document = json(&["info", "abb-paper", "--json"], 0);
    let motors = &document["transmission"]["motors"];
    assert_eq!(motors[0]["kind"], "servo");
    assert_eq!(
        motors[2]["four_bar"]["dead_points"]
            .as_array()
            .expect("a list")
            .len(),
        3
    );
}

#[test]
fn a_converted_arm_keeps_its_motors() {
    let folder = Temporary::new();
    let file = folder.path("screws.toml");
    assert_eq!(
        pieper(&["convert", "abb-paper", "--to", "screws", "--out", &file]).code,
        0
    );
    let q = ["--q", "0.1,1.4,0.2,0.3,0.4,0.5", "--json"];
    let motors = |robot: &str| numbers(&json(&[&["fk", robot], &q[..]].concat(), 0)["motors"]);
    for (a, b) in motors("abb-paper").iter().zip(motors(&file)) {
        assert!((a - b).abs() < 1e-14);
    }
}
