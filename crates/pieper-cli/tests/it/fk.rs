//! `pieper fk`, `info`, `robots` and `convert` as a user meets them: answers, words of refusal, exit codes.

use std::io::Write as _;
use std::process::{Command, Stdio};

use crate::support::{Temporary, pieper};
use serde_json::Value;

fn json(arguments: &[&str]) -> Value {
    let ended = pieper(arguments);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    serde_json::from_str(&ended.stdout).expect("JSON")
}

/// Bad input: exit code 2, nothing on standard output, one line on standard error with these words.
fn refuses(arguments: &[&str], words: &str) {
    let ended = pieper(arguments);
    assert_eq!(
        ended.code, 2,
        "{arguments:?}: {}{}",
        ended.stdout, ended.stderr
    );
    assert!(ended.stdout.is_empty());
    assert!(
        ended.stderr.contains(words),
        "{arguments:?} said {}",
        ended.stderr
    );
    assert!(!ended.stderr.contains("panicked"), "{}", ended.stderr);
}

fn batch(arguments: &[&str], lines: &str) -> (i32, Vec<Value>) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_pieper"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("it starts");
    child
        .stdin
        .take()
        .expect("piped")
        .write_all(lines.as_bytes())
        .expect("it reads");
    let output = child.wait_with_output().expect("it ends");
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let answers = text
        .lines()
        .map(|line| serde_json::from_str(line).expect("JSON"))
        .collect();
    (output.status.code().expect("not killed"), answers)
}

#[test]
fn a_pose_in_words_and_in_json() {
    let text = pieper(&["fk", "ar3", "--q", "0,0,0,0,0,0"]);
    assert!(
        text.stdout.contains("0.683700") && text.stdout.contains("direction cosines"),
        "{}",
        text.stdout
    );
    let document = json(&[
        "fk",
        "ar3",
        "--q",
        "-90,90,0,0,0,0",
        "--deg",
        "--json",
        "--frames",
        "--jacobian",
        "base",
    ]);
    assert_eq!(document["pose"][3], serde_json::json!([0.0, 0.0, 0.0, 1.0]));
    assert!((document["pose"][2][3].as_f64().unwrap() - 0.7687).abs() < 1e-15);
    assert_eq!(
        document["frames"]
            .as_object()
            .unwrap()
            .keys()
            .collect::<Vec<_>>(),
        ["1", "2", "3", "4", "5", "6"]
    );
    assert_eq!(document["jacobian"].as_array().unwrap().len(), 6);
    assert!((document["directions"]["k"]["angles"][0].as_f64().unwrap() - 180.0).abs() < 1e-9);
    let quaternion = json(&[
        "fk",
        "ar3",
        "--q",
        "-90,90,0,0,0,0",
        "--deg",
        "--json",
        "--method",
        "quaternion",
    ]);
    for i in 0..4 {
        for j in 0..4 {
            let (a, b) = (&document["pose"][i][j], &quaternion["pose"][i][j]);
            assert!((a.as_f64().unwrap() - b.as_f64().unwrap()).abs() < 1e-15);
        }
    }
}

#[test]
fn bad_input_is_refused_in_words() {
    refuses(
        &["fk", "ar33", "--q", "0"],
        "neither a built-in robot nor a file; did you mean ar3?",
    );
    refuses(
        &["fk", "nowhere.toml", "--q", "0"],
        "nowhere.toml: it could not be read",
    );
    refuses(
        &["fk", "README.md", "--q", "0"],
        "a robot is read from a .toml, .urdf or .xacro file",
    );
    refuses(
        &["fk", "ar3", "--q", "0,0,0"],
        "6 were expected (J1, J2, J3, J4, J5, J6), 3 were given",
    );
    refuses(
        &["fk", "ar3", "--q", "0,0,x,0,0,0"],
        "--q: \"x\": a finite number was expected",
    );
    refuses(
        &["fk", "ar3", "--q", "0,0,nan,0,0,0"],
        "--q: \"nan\": a finite number was expected",
    );
    refuses(
        &["fk", "ar3", "--q", "0,0,1e999,0,0,0"],
        "a finite number was expected",
    );
    refuses(&["fk", "ar3"], "--q");
    refuses(
        &["fk", "ar3", "--input", "nowhere.jsonl"],
        "nowhere.jsonl: it could not be read",
    );
    refuses(&["fk", "ar3", "--input", "."], "this is a folder");
    refuses(
        &["fk", "six-axis", "--q", "0,0,0,0,0,0"],
        "numbers are needed for the parameters d1, a2, d4, d6: give them with --set NAME=VALUE",
    );
    refuses(
        &["fk", "six-axis", "--q", "0", "--set", "d1"],
        "NAME=VALUE was expected",
    );
    refuses(
        &["fk", "ar3", "--q", "0", "--set", "z9=1"],
        "the parameters of Annin Robotics AR3 are S1, a1, l2, l4, l6",
    );
    refuses(
        &["fk", "ar3", "--q", "0", "--set", "a1=1 ft"],
        "an operator or the end of the formula was expected",
    );
}

#[test]
fn files_of_every_kind_are_refused_with_their_place() {
    let folder = Temporary::new();
    let robot = folder.file(
        "bad.toml",
        "name = 'x'\nconvention = 'standard'\n[[joint]]\ntheta = 'q2'\n",
    );
    refuses(
        &["info", &robot],
        "bad.toml:4:9: theta = 'q2': this row's joint variable is q1, not q2",
    );
    let empty = folder.file("empty.toml", "");
    refuses(&["info", &empty], "a [[joint]] for each row of the table");
    let urdf = folder.file(
        "bad.urdf",
        "<robot name='r'>\n<link name='a'/>\n<link name='a'/>\n</robot>",
    );
    refuses(&["info", &urdf], "bad.urdf:3");
    let bomb = "<!DOCTYPE r [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;&a;'>]><robot name='&b;'/>";
    refuses(&["info", &folder.file("bomb.urdf", bomb)], "bomb.urdf");
    let looping = "<robot xmlns:xacro='http://www.ros.org/wiki/xacro' name='r'><xacro:include filename='loop.xacro'/></robot>";
    refuses(&["info", &folder.file("loop.xacro", looping)], "loop.xacro");
    let missing = "<robot xmlns:xacro='http://www.ros.org/wiki/xacro' name='r'><xacro:include filename='$(find no_such_package)/a.xacro'/></robot>";
    refuses(
        &["info", &folder.file("missing.xacro", missing)],
        "no_such_package",
    );
    std::fs::write(folder.path("latin.toml"), b"name = '\xe9'").unwrap();
    refuses(
        &["info", &folder.path("latin.toml")],
        "text in UTF-8 was expected",
    );
}

#[test]
fn a_robot_file_may_take_its_chain_out_of_a_urdf() {
    let folder = Temporary::new();
    let urdf = pieper(&["convert", "ur5", "--to", "urdf"]).stdout;
    folder.file("ur5.urdf", &urdf);
    let whole = folder.file("whole.toml", "name = 'whole'\nurdf = 'ur5.urdf'\n");
    let part = folder.file(
        "part.toml",
        "name = 'part'\nurdf = 'ur5.urdf'\nbase = 'base_link'\ntip = '3'\n",
    );
    let joints = |robot: &str| {
        json(&["info", robot, "--json"])["joints"]
            .as_array()
            .unwrap()
            .len()
    };
    assert_eq!((joints(&whole), joints(&part)), (6, 3));
    let bad = folder.file(
        "bad.toml",
        "name = 'bad'\nurdf = 'ur5.urdf'\ntip = 'nose'\n",
    );
    refuses(&["info", &bad], "link nose");
    let gone = folder.file("gone.toml", "name = 'gone'\nurdf = 'gone.urdf'\n");
    refuses(&["info", &gone], "gone.toml:2:8: urdf = 'gone.urdf'");
}

#[test]
fn a_batch_answers_line_by_line() {
    let lines = "{\"id\": \"a\", \"q\": [0,0,0,0,0,0]}\n\n{\"id\": 2, \"q\": {\"J1\": 0, \"q2\": 0, \"J3\": 0, \"J4\": 0, \"J5\": 0, \"J6\": 0}}\n\
                 nonsense\n{\"id\": \"b\"}\n{\"id\": \"c\", \"q\": [0,0]}\n[1]\n{\"id\": \"d\", \"q\": {\"elbow\": 1}}\n{\"q\": [0,0,0,0,0,1e400]}\n\
                 {\"id\": \"e\", \"q\": [0,0,0,0,0,0]}";
    let (code, answers) = batch(&["fk", "ar3", "--input", "-", "--output", "-"], lines);
    assert_eq!(code, 1, "some lines were bad");
    let ids: Vec<_> = answers.iter().map(|answer| answer["id"].clone()).collect();
    assert_eq!(
        ids,
        serde_json::json!(["a", 2, null, "b", "c", null, "d", null, "e"])
            .as_array()
            .unwrap()[..]
    );
    for good in [0, 1, 8] {
        assert_eq!(answers[good]["pose"], answers[0]["pose"]);
        assert!(answers[good].get("error").is_none());
    }
    for (index, words) in [
        (2, "line 4: it is no JSON"),
        (3, "line 5: \"q\" was expected"),
        (4, "line 6: joint values: 6 were expected"),
        (5, "line 7: [1]: a JSON object was expected"),
        (6, "line 8: \"q\": elbow is no joint; the joints are J1"),
        (7, "line 9: it is no JSON"),
    ] {
        let error = answers[index]["error"].as_str().unwrap();
        assert!(error.starts_with(words), "{error}");
    }
    let (code, answers) = batch(&["fk", "ar3", "--input", "-"], "");
    assert_eq!((code, answers.len()), (0, 0));
}

#[test]
fn limits_are_spoken_of_when_asked() {
    let ended = pieper(&["fk", "ar3", "--q", "0,-10,0,0,0,0", "--deg", "--limits"]);
    assert_eq!(ended.code, 0);
    assert!(
        ended.stderr.contains("warning: J2 = ") && ended.stderr.contains("lies outside its limits"),
        "{}",
        ended.stderr
    );
    assert!(
        pieper(&["fk", "ar3", "--q", "0,-10,0,0,0,0", "--deg"])
            .stderr
            .is_empty()
    );
}

#[test]
fn every_built_in_robot_can_be_shown_and_converted() {
    let list = json(&["robots", "--json"]);
    for robot in list.as_array().unwrap() {
        let id = robot["id"].as_str().unwrap();
        let shown = pieper(&["info", id]);
        assert_eq!(shown.code, 0, "{id}: {}", shown.stderr);
        let needs_numbers = !robot["missing_parameters"].as_array().unwrap().is_empty();
        for form in ["standard", "modified", "screws", "urdf"] {
            let ended = pieper(&["convert", id, "--to", form]);
            assert_eq!(
                ended.code,
                if needs_numbers { 2 } else { 0 },
                "{id} to {form}: {}",
                ended.stderr
            );
        }
    }
}

#[test]
fn every_example_in_help_works_as_typed() {
    let help = pieper(&["--help"]).stdout;
    assert!(help.contains("fk") && help.contains("Exit codes"));
    for command in ["robots", "info", "fk", "convert", "run"] {
        let help = pieper(&[command, "--help"]).stdout;
        let examples = help
            .lines()
            .map(str::trim)
            .filter(|line| line.starts_with("pieper "));
        for example in examples {
            let folder = Temporary::new();
            let words: Vec<String> = example
                .split_whitespace()
                .skip(1)
                .map(str::to_owned)
                .collect();
            let place = |word: &String| match word.as_str() {
                path if path.starts_with("out/") => folder.path("out"),
                path if path.ends_with(".toml") && !path.contains('/') => folder.path(path),
                _ => word.clone(),
            };
            let words: Vec<String> = words.iter().map(place).collect();
            let ended = pieper(&words.iter().map(String::as_str).collect::<Vec<_>>());
            assert_eq!(ended.code, 0, "{example}: {}", ended.stderr);
        }
    }
}
