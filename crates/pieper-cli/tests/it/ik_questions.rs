//! `pieper ik` with parts of poses, joints held, rankings, and families within limits.

use crate::support::pieper;
use serde_json::Value;

const PANDA: &[&str] = &[
    "ik",
    "panda",
    "--pose",
    "0.4,0.1,0.4,180,0,0",
    "--deg",
    "--json",
];

fn json(arguments: &[&[&str]]) -> Value {
    let ended = pieper(&arguments.concat());
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    serde_json::from_str(&ended.stdout).expect("JSON")
}

fn list<'a>(value: &'a Value, key: &str) -> &'a Vec<Value> {
    value[key].as_array().expect("a list")
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter().map(|x| x.as_f64().expect("a number")).collect()
}

#[test]
fn families_within_limits() {
    let all = json(&[PANDA]);
    assert_eq!(all["status"], "redundant");
    let within = json(&[PANDA, &["--limits"]]);
    assert!(!list(&within, "families").is_empty());
    assert!(list(&within, "families").len() < list(&all, "families").len());
    let limits = [
        (-166.1, 166.1),
        (-101.1, 101.1),
        (-166.1, 166.1),
        (-176.1, -3.9),
        (-166.1, 166.1),
        (-1.1, 215.1),
        (-166.1, 166.1),
    ];
    for family in list(&within, "families") {
        assert!(!list(family, "ranges").is_empty());
        assert!(list(family, "samples").len() >= 8);
        let ends = list(family, "ranges")
            .iter()
            .flat_map(|range| [&range["from"], &range["to"]]);
        for q in list(family, "samples")
            .iter()
            .chain([&family["q"]])
            .chain(ends)
        {
            let inside = numbers(q)
                .iter()
                .zip(limits)
                .all(|(value, (lower, upper))| (lower..=upper).contains(value));
            assert!(inside, "{q}");
        }
    }
}

#[test]
fn a_joint_held() {
    let answer = json(&[PANDA, &["--lock", "q7=45"]]);
    assert_eq!(answer["status"], "solved");
    let solutions = list(&answer, "solutions");
    assert!(!solutions.is_empty());
    for solution in solutions {
        let q = numbers(&solution["q"]);
        assert!((q[6] - 45.0).abs() < 1e-9 && q.len() == 7, "{q:?}");
    }
    for wrong in ["q8=1", "q7", "q7=x", "elbow=1"] {
        let ended = pieper(&[PANDA, &["--lock", wrong]].concat());
        assert_eq!(ended.code, 2);
        assert!(
            ended.stderr.contains("JOINT=VALUE was expected"),
            "{}",
            ended.stderr
        );
    }
}

#[test]
fn parts_of_a_pose() {
    let pose = ["--pose", "0.4,0.2,0.1,180,0,0", "--deg", "--json"];
    let scara = |goal: &str| json(&[&["ik", "cobra600"], &pose, &["--goal", goal]]);
    assert_eq!(scara("pose")["status"], "solved");
    assert_eq!(scara("position")["status"], "redundant");
    assert_eq!(scara("position+axis")["status"], "redundant");
    let tilted = [
        "ik",
        "cobra600",
        "--pose",
        "0.4,0.2,0.1,170,0,0",
        "--deg",
        "--json",
    ];
    let ended = pieper(&tilted);
    assert_eq!(ended.code, 1);
    let answer: Value = serde_json::from_str(&ended.stdout).expect("JSON");
    assert!(
        answer["reason"]
            .as_str()
            .expect("words")
            .contains("0.1745 rad")
    );
    assert!(
        answer["nearest"]["position_error"]
            .as_f64()
            .expect("a number")
            < 1e-6
    );
    assert_eq!(
        json(&[&tilted, &["--goal", "position"]])["status"],
        "redundant"
    );
}

#[test]
fn methods_and_rankings() {
    let ar3 = ["ik", "ar3", "--pose", "0.3,0.2,0.35,0.1,0.8,0.3", "--json"];
    let (a, b) = (json(&[&ar3]), json(&[&ar3, &["--method", "quaternion"]]));
    let (a, b) = (list(&a, "solutions").clone(), list(&b, "solutions").clone());
    assert!(!a.is_empty() && a.len() == b.len());
    for (a, b) in a.iter().zip(&b) {
        assert_eq!(a["branch"], b["branch"]);
        let pairs = numbers(&a["q"]).into_iter().zip(numbers(&b["q"]));
        assert!(pairs.into_iter().all(|(x, y)| (x - y).abs() < 1e-9));
    }
    for rank in ["limits", "singularity"] {
        let ranked = json(&[&ar3, &["--rank", rank]]);
        assert_eq!(list(&ranked, "solutions").len(), a.len());
    }
    let ended = pieper(&[&ar3[..], &["--rank", "seed"]].concat());
    assert_eq!(ended.code, 2);
}
