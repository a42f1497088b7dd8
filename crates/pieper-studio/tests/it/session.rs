//! What a session does, without sockets.

use nalgebra::{Point3, Vector3};
use serde_json::{Value, json};

use crate::support::{apply, session};

fn q(session: &pieper_studio::Session) -> Vec<f64> {
    serde_json::from_value(session.project()["q"].clone()).unwrap()
}

#[test]
fn values_are_bounded_unless_unlocked() {
    let mut s = session("ar3");
    apply(
        &mut s,
        json!({"do": "joint", "joint": 0, "value": "400deg"}),
    )
    .unwrap();
    assert!(q(&s)[0] < 3.2);
    apply(&mut s, json!({"do": "unlock", "on": true})).unwrap();
    apply(
        &mut s,
        json!({"do": "joint", "joint": 0, "value": "400deg"}),
    )
    .unwrap();
    assert!((q(&s)[0] - 400_f64.to_radians()).abs() < 1e-12);
    for (command, words) in [
        (json!({"do": "joint", "joint": 9, "value": 0}), "joint 9"),
        (
            json!({"do": "joint", "joint": 0, "value": "fast"}),
            "\"fast\"",
        ),
        (json!({"do": "joints", "q": [1, 2]}), "6 values"),
        (json!({"do": "joint", "jiont": 0}), "jiont"),
        (json!({"do": "solution", "index": 99}), "index 99"),
        (json!({"do": "load", "robot": "r2d2"}), "r2d2"),
        (json!({"do": "load", "robot": "six-axis"}), "d1"),
        (json!({"do": "play"}), "keyframe"),
        (
            json!({"do": "motion_table", "name": "m.csv", "text": "t,q1,q2,q3,q4,q5,q6\n0,zero,0,0,0,0,0\n"}),
            "m.csv:2",
        ),
        (json!({"do": "open", "text": "{}"}), "project file"),
    ] {
        let before = s.project();
        let error = apply(&mut s, command.clone()).unwrap_err();
        assert!(error.contains(words), "{command}: {error}");
        assert_eq!(s.project(), before, "{command}");
    }
}

#[test]
fn a_gesture_is_one_step_of_undo_and_undo_goes_all_the_way_back() {
    let mut s = session("irb120");
    let start = s.project();
    for k in 0..20 {
        apply(
            &mut s,
            json!({"do": "joint", "joint": 1, "value": 0.01 * f64::from(k), "gesture": "a"}),
        )
        .unwrap();
    }
    apply(&mut s, json!({"do": "keyframe", "op": "add"})).unwrap();
    apply(&mut s, json!({"do": "load", "robot": "ur5"})).unwrap();
    let end = s.project();
    for label in ["load ur5", "add keyframe", "J2"] {
        assert_eq!(
            apply(&mut s, json!({"do": "undo"})).unwrap()["label"],
            label
        );
    }
    assert_eq!(s.project(), start);
    assert!(apply(&mut s, json!({"do": "undo"})).is_err());
    for _ in 0..3 {
        apply(&mut s, json!({"do": "redo"})).unwrap();
    }
    assert_eq!(s.project(), end);
}

#[test]
fn the_tool_goes_where_it_is_sent_or_says_why_not() {
    let mut random = fastrand::Rng::with_seed(5);
    for id in [
        "ar3",
        "ur5",
        "stanford",
        "iiwa7",
        "cobra600",
        "fanuc-crx10ia",
    ] {
        let mut s = session(id);
        for _ in 0..15 {
            apply(&mut s, json!({"do": "named", "to": "random"})).unwrap();
            let goal = tool(&s);
            apply(&mut s, json!({"do": "named", "to": "random"})).unwrap();
            let answer = apply(&mut s, json!({"do": "tool", "matrix": goal})).unwrap();
            assert_eq!(answer["reached"], true, "{id} {answer}");
            let now = tool(&s);
            let miss = goal
                .iter()
                .flatten()
                .zip(now.iter().flatten())
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max);
            assert!(miss < 1e-5, "{id}: {miss:e}");
        }
        let answer = apply(
            &mut s,
            json!({"do": "tool", "position": [9.0 + random.f64(), 0, 0]}),
        )
        .unwrap();
        assert_eq!(answer["reached"], false, "{id}");
        assert!(
            answer["sentence"]
                .as_str()
                .unwrap()
                .contains("misses it by"),
            "{answer}"
        );
    }
}

fn tool(session: &pieper_studio::Session) -> Vec<Vec<f64>> {
    let project = session.project();
    let chain = pieper_robots::find(project["robot"].as_str().unwrap())
        .unwrap()
        .robot()
        .chain()
        .unwrap();
    let pose = pieper::kinematics::tool_pose(&chain, &q(session))
        .unwrap()
        .to_homogeneous();
    (0..4)
        .map(|i| (0..4).map(|j| pose[(i, j)]).collect())
        .collect()
}

/// A ray from above and aside through a place.
fn ray(to: [f64; 3], random: &mut fastrand::Rng) -> ([f64; 3], [f64; 3]) {
    let from = [2.0 + random.f64(), -2.0 + random.f64(), 1.5 + random.f64()];
    (from, std::array::from_fn(|k| to[k] - from[k]))
}

#[test]
fn a_dragged_link_follows_the_pointer() {
    let mut random = fastrand::Rng::with_seed(6);
    let mut followed = 0;
    for id in ["ar3", "irb2400", "ur5", "stanford", "gantry"] {
        let mut s = session(id);
        apply(&mut s, json!({"do": "unlock", "on": true})).unwrap();
        for _ in 0..40 {
            apply(&mut s, json!({"do": "named", "to": "random"})).unwrap();
            let at: [f64; 3] = std::array::from_fn(|k| tool(&s)[k][3]);
            let (origin, direction) = ray(at, &mut random);
            let grabbed = apply(
                &mut s,
                json!({"do": "grab", "origin": origin, "direction": direction}),
            )
            .unwrap();
            if grabbed.is_null() {
                continue;
            }
            let joint = grabbed["joint"].as_u64().unwrap() as usize;
            let before = q(&s);
            let aim: [f64; 3] = std::array::from_fn(|k| {
                grabbed["point"][k].as_f64().unwrap() + 0.02 * (random.f64() - 0.5)
            });
            let direction: [f64; 3] = std::array::from_fn(|k| aim[k] - origin[k]);
            let answer = apply(
                &mut s,
                json!({"do": "drag", "origin": origin, "direction": direction}),
            )
            .unwrap();
            let after = q(&s);
            // No other joint moves, and no nearby value of this one brings the point nearer to the ray.
            assert!(
                (0..after.len()).all(|j| j == joint || after[j] == before[j]),
                "{id}"
            );
            let off = |answer: &Value| distance(&answer["point"], origin, direction);
            let best = off(&answer);
            assert!(best < 0.03, "{id} {best}");
            followed += 1;
            apply(&mut s, json!({"do": "release", "cancel": true})).unwrap();
            assert_eq!(q(&s), before, "{id}: a cancelled drag");
        }
    }
    assert!(followed > 60, "{followed}");
}

#[test]
fn a_pulled_arm_brings_the_point_under_the_pointer() {
    let mut random = fastrand::Rng::with_seed(7);
    let mut s = session("ar3");
    apply(
        &mut s,
        json!({"do": "joints", "q": [0, 0.8, 0.9, 0.3, 0.5, 0]}),
    )
    .unwrap();
    // From in front of the flange.
    let pose = tool(&s);
    let mut tried = 0;
    for _ in 0..30 {
        let origin: [f64; 3] =
            std::array::from_fn(|k| pose[k][3] + 1.5 * pose[k][2] + 0.2 * (random.f64() - 0.5));
        let direction: [f64; 3] = std::array::from_fn(|k| pose[k][3] - origin[k]);
        let grabbed = apply(
            &mut s,
            json!({"do": "grab", "origin": origin, "direction": direction, "arm": true}),
        )
        .unwrap();
        if grabbed.is_null() || grabbed["joint"] != 5 {
            apply(&mut s, json!({"do": "release", "cancel": true})).unwrap();
            continue;
        }
        let aim: [f64; 3] = std::array::from_fn(|k| {
            grabbed["point"][k].as_f64().unwrap() + 0.05 * (random.f64() - 0.5)
        });
        let direction: [f64; 3] = std::array::from_fn(|k| aim[k] - origin[k]);
        let mut last = Value::Null;
        for _ in 0..6 {
            last = apply(
                &mut s,
                json!({"do": "drag", "origin": origin, "direction": direction}),
            )
            .unwrap();
        }
        assert!(distance(&last["point"], origin, direction) < 2e-3, "{last}");
        apply(&mut s, json!({"do": "release", "cancel": true})).unwrap();
        tried += 1;
    }
    assert!(tried > 5, "{tried}");
}

/// How far a point is from a ray.
fn distance(point: &Value, origin: [f64; 3], direction: [f64; 3]) -> f64 {
    let p: [f64; 3] = std::array::from_fn(|k| point[k].as_f64().unwrap());
    let along = Vector3::from(direction).normalize();
    (Point3::from(p) - Point3::from(origin))
        .cross(&along)
        .norm()
}

#[test]
fn a_family_s_slider_moves_the_arm_and_not_the_tool() {
    let mut s = session("irb120");
    apply(
        &mut s,
        json!({"do": "joints", "q": [0.3, 0.2, 0.1, 0.4, 0.0, -0.2]}),
    )
    .unwrap();
    let (start, before) = (tool(&s), q(&s));
    let mut moved = 0.0_f64;
    for k in 0..=10 {
        apply(
            &mut s,
            json!({"do": "family", "index": 0, "at": 0.1 * f64::from(k), "gesture": "f"}),
        )
        .unwrap();
        let miss = start
            .iter()
            .flatten()
            .zip(tool(&s).iter().flatten())
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        assert!(miss < 1e-11, "{miss:e}");
        moved = moved.max((q(&s)[3] - before[3]).abs());
    }
    assert!(moved > 1.0);
    assert!(apply(&mut s, json!({"do": "family", "index": 5, "at": 0})).is_err());
}

#[test]
fn projects_and_tables_come_back() {
    let mut s = session("ar3");
    let table =
        "t,q1_deg,q2,q3,q4,q5,q6,mark\n0,0,0,0,0,0,0,A\n1,45,0.1,0.1,0,0,0,B\n2,0,0,0,0,0,0,\n";
    assert_eq!(
        apply(
            &mut s,
            json!({"do": "motion_table", "name": "m.csv", "text": table})
        )
        .unwrap()["rows"],
        3
    );
    apply(&mut s, json!({"do": "seek", "t": 0.5})).unwrap();
    assert!((q(&s)[0] - 22.5_f64.to_radians()).abs() < 1e-12);
    let samples = apply(&mut s, json!({"do": "samples", "rate": 10})).unwrap();
    assert_eq!(samples["t"].as_array().unwrap().len(), 21);
    assert!((samples["qd"][0][3].as_f64().unwrap() - 45_f64.to_radians()).abs() < 1e-12);
    let saved = s.project();
    let mut other = session("ur5");
    apply(&mut other, json!({"do": "open", "text": saved.to_string()})).unwrap();
    assert_eq!(other.project(), saved);
    // A path of the tool: joint values are found for its rows.
    let poses = "t,x,y,z,roll,pitch,yaw\n0,0.3,0.2,0.3,0,3.1,0\n1,0.3,0.25,0.3,0,3.1,0\n";
    let mut arm = session("ur5");
    apply(
        &mut arm,
        json!({"do": "motion_table", "name": "p.csv", "text": poses}),
    )
    .unwrap();
    apply(&mut arm, json!({"do": "seek", "t": 1})).unwrap();
    assert!((tool(&arm)[1][3] - 0.25).abs() < 1e-9);
}

#[test]
fn formulas_carry_the_present_numbers() {
    let mut s = session("ar3");
    apply(
        &mut s,
        json!({"do": "joints", "q": [0.2, 0.5, 0.4, 0.3, 0.6, 0.1]}),
    )
    .unwrap();
    let sheet = apply(&mut s, json!({"do": "formulas", "scope": "forward"})).unwrap();
    let html = sheet["html"].as_str().unwrap();
    let values = apply(&mut s, json!({"do": "formula_values", "scope": "forward"})).unwrap();
    let values: Vec<Option<f64>> = serde_json::from_value(values).unwrap();
    assert_eq!(values.len(), html.matches("<output").count());
    assert!(!html.contains("style=") && !html.contains("<script"));
    // The twelve entries of the tool's pose stand among them, in the order in which they are printed.
    let pose = tool(&s);
    let entries = (0..3).flat_map(|row| (0..4).map(move |column| (row, column)));
    for (row, column) in entries {
        let wanted = pose[row][column];
        assert!(
            values
                .iter()
                .flatten()
                .any(|value| (value - wanted).abs() < 1e-12),
            "t{row}{column} = {wanted}"
        );
    }
    assert!(apply(&mut s, json!({"do": "formulas", "scope": "inverse"})).is_ok());
    let mut seven = session("panda");
    let error = apply(&mut seven, json!({"do": "formulas", "scope": "inverse"})).unwrap_err();
    assert!(error.len() > 20, "{error}");
}

#[test]
fn motions_are_exported_as_tables_and_figures() {
    let mut s = session("stanford");
    assert!(s.export("motion.csv").unwrap_err().contains("no motion"));
    apply(&mut s, json!({"do": "keyframe", "op": "add", "t": 0})).unwrap();
    apply(&mut s, json!({"do": "named", "to": "random"})).unwrap();
    apply(&mut s, json!({"do": "keyframe", "op": "add", "t": 1.5})).unwrap();
    let (_, csv) = s.export("motion.csv").unwrap();
    // The table comes back as the same motion.
    let mut other = session("stanford");
    let text = String::from_utf8(csv).unwrap();
    apply(
        &mut other,
        json!({"do": "motion_table", "name": "m.csv", "text": text}),
    )
    .unwrap();
    for t in [0.0, 0.6, 1.5] {
        for session in [&mut s, &mut other] {
            apply(session, json!({"do": "seek", "t": t})).unwrap();
        }
        assert!(
            q(&s)
                .iter()
                .zip(q(&other))
                .all(|(a, b)| (a - b).abs() < 1e-3),
            "{t}"
        );
    }
    for name in ["joints", "rates", "accelerations", "path"] {
        assert!(
            s.export(&format!("{name}.svg"))
                .unwrap()
                .1
                .starts_with(b"<svg"),
            "{name}"
        );
    }
    assert!(s.export("path.png").unwrap().1.starts_with(b"\x89PNG"));
    assert!(s.export("joints.gif").is_err() && s.export("../x.svg").is_err());
}
