//! `pieper run` with paths of the tool: joint motions, certificates, and the way back.

use std::fs;

use serde_json::Value;

use crate::support::{Ended, Temporary, pieper};

fn run(robot: &str, motion: &str, out: &str, more: &[&str]) -> Ended {
    pieper(&[&["run", robot, motion, "--out", out], more].concat())
}

fn json(path: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(path).expect(path)).expect(path)
}

/// The joint values of every sample of a run.
fn samples(folder: &str) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(format!("{folder}/samples.csv")).unwrap();
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        cells[2..8]
            .iter()
            .map(|cell| cell.parse().unwrap())
            .collect()
    };
    text.lines().skip(1).map(row).collect()
}

fn largest_difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    assert_eq!(a.len(), b.len());
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

#[test]
fn the_papers_programme_runs_backwards() {
    let folder = Temporary::new();
    let [forth, back, again] = ["forth", "back", "again"].map(|name| folder.path(name));
    assert_eq!(
        run("ar3", "examples/ar3-programme.csv", &forth, &[]).code,
        0
    );
    // The shipped table is the one that a run writes.
    let written = fs::read_to_string(format!("{forth}/poses.csv")).unwrap();
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/ar3-poses.csv");
    let shipped = fs::read_to_string(root).unwrap();
    assert!(
        shipped.ends_with(&written),
        "examples/ar3-poses.csv: copy poses.csv below its comment"
    );
    let ended = run("ar3", "examples/ar3-poses.csv", &back, &[]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    let off = largest_difference(&samples(&forth), &samples(&back));
    assert!(off < 1e-9, "{off:e}");
    let marks = json(&format!("{back}/matrices.json"))["marks"]
        .as_array()
        .unwrap()
        .len();
    assert_eq!(marks, 7);
    // And the joint motion found is a table of its own.
    let ended = run("ar3", &format!("{back}/joints.csv"), &again, &[]);
    assert_eq!(ended.code, 0);
    let first = json(&format!("{back}/matrices.json"));
    assert_eq!(
        first["marks"],
        json(&format!("{again}/matrices.json"))["marks"]
    );
}

#[test]
fn three_points_of_the_tool_are_a_path_too() {
    let folder = Temporary::new();
    let [poses, points] = ["poses", "points"].map(|name| folder.path(name));
    let table = "t,x,y,z,roll,pitch,yaw\n0,0.4,0.1,0.5,0,1.5707963267948966,0\n1,0.4,-0.1,0.5,0,1.5707963267948966,0\n";
    let ended = run("irb120", &folder.file("poses.csv", table), &poses, &[]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let table = "t,Dx,Dy,Dz,Kx,Ky,Kz,Ex,Ey,Ez\n0,0.4,0.1,0.5,0.5,0.1,0.5,0.4,0.2,0.5\n1,0.4,-0.1,0.5,0.5,-0.1,0.5,0.4,0,0.5\n";
    let ended = run("irb120", &folder.file("points.csv", table), &points, &[]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let off = largest_difference(&samples(&poses), &samples(&points));
    assert!(off < 1e-12, "{off:e}");
}

#[test]
fn a_straight_wrist_is_passed_and_certified() {
    let folder = Temporary::new();
    let out = folder.path("out");
    let ended = run("irb120", "examples/irb120-wrist.csv", &out, &["--json"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    let document: Value = serde_json::from_str(&ended.stdout).unwrap();
    let certificate = json(&format!("{out}/certificate.json"));
    assert_eq!(document["certificate"], certificate);
    assert_eq!(certificate["followed"], true);
    let chosen = certificate["chosen"].as_u64().unwrap() as usize - 1;
    let branch = &certificate["branches"][chosen];
    assert_eq!(
        (&branch["alive"], &branch["dies_at"]),
        (&Value::Bool(true), &Value::Null)
    );
    assert!(branch["stops"].as_array().unwrap().is_empty());
    let (start, end) = (&branch["q_start"][4], &branch["q_end"][4]);
    assert!(
        start.as_f64().unwrap() * end.as_f64().unwrap() < 0.0,
        "joint 5 passes zero"
    );
    let dead = certificate["branches"].as_array().unwrap().iter();
    let dead = dead.filter(|branch| branch["alive"] == false);
    assert!(dead.clone().count() > 0);
    for branch in dead {
        assert!(
            branch["why"].as_str().unwrap().contains("limit"),
            "{branch}"
        );
    }
    let text = fs::read_to_string(format!("{out}/certificate.txt")).unwrap();
    assert!(
        text.contains("A continuous motion follows the whole path")
            && text.contains("joint_1 passes its limit")
    );
    let html = fs::read_to_string(format!("{out}/report.html")).unwrap();
    assert!(html.contains("<h2>Certificate</h2>") && html.contains("lives to the end"));
    for name in ["branches.svg", "branches.png", "joints.csv"] {
        assert!(
            fs::read(format!("{out}/{name}")).unwrap().len() > 1000,
            "{name}"
        );
    }
}

#[test]
fn a_line_out_of_reach_is_a_no_with_its_reason() {
    let folder = Temporary::new();
    let out = folder.path("out");
    let ended = run("irb120", "examples/irb120-reach.csv", &out, &[]);
    assert_eq!((ended.code, ended.stderr.as_str()), (1, ""));
    for words in [
        "No continuous motion of the joints follows the whole path from t = 0 s to t = 4 s.",
        "the elbow is stretched: this branch and",
        "beyond the arm's reach",
        "open ",
    ] {
        assert!(ended.stdout.contains(words), "{words}: {}", ended.stdout);
    }
    let certificate = json(&format!("{out}/certificate.json"));
    assert_eq!(
        (&certificate["followed"], &certificate["chosen"]),
        (&Value::Bool(false), &Value::Null)
    );
    let gap = &certificate["alternative"]["gaps"][0];
    let legs = certificate["alternative"]["legs"].as_array().unwrap();
    assert_eq!(
        (legs.len(), &legs[0]["to"], &legs[1]["from"]),
        (2, &gap["from"], &gap["to"])
    );
    // What is possible is shown: the first leg.
    assert_eq!(certificate["covered"][1], legs[0]["to"]);
    let samples = samples(&out);
    assert!(samples.len() > 60 && samples.len() < 80);
    // Nothing at all is possible: the certificate alone.
    let far = folder.file(
        "far.csv",
        "t,x,y,z,roll,pitch,yaw\n0,3,0,0,0,0,0\n1,3,1,0,0,0,0\n",
    );
    let out = folder.path("far");
    let ended = run("irb120", &far, &out, &[]);
    assert_eq!((ended.code, ended.stderr.as_str()), (1, ""));
    assert!(
        ended
            .stdout
            .contains("the path cannot be reached at all; where it is worst: wrist centre")
    );
    assert_eq!(fs::read_dir(&out).unwrap().count(), 2);
}

#[test]
fn long_tables_without_marks_have_two_reference_positions() {
    let folder = Temporary::new();
    let rows = |count: usize| -> String {
        (0..count)
            .map(|k| format!("{k},0,0,0,0,0,{}\n", 0.01 * k as f64))
            .collect()
    };
    for (count, marks) in [(24, 24), (25, 2)] {
        let table = format!("t,q1,q2,q3,q4,q5,q6\n{}", rows(count));
        let out = folder.path("out");
        let ended = run(
            "irb120",
            &folder.file("m.csv", &table),
            &out,
            &["--rate", "1"],
        );
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        let found = json(&format!("{out}/matrices.json"))["marks"]
            .as_array()
            .unwrap()
            .len();
        assert_eq!(found, marks);
        let html = fs::read_to_string(format!("{out}/report.html")).unwrap();
        for text in [&ended.stdout, &html] {
            assert_eq!(
                text.contains("The table has no column mark and 25 rows"),
                count > 24
            );
        }
    }
}

#[test]
fn joints_go_straight_between_poses_if_asked() {
    let folder = Temporary::new();
    let out = folder.path("out");
    let table = folder.path("table.csv");
    // Reached, beyond reach in the middle for a straight tool; the joints get there all the same.
    let text = "t,x,y,z,roll,pitch,yaw\n0,0.3,0.25,0.4,3.14159,0,0\n1,-0.3,0.25,0.4,3.14159,0,0\n";
    fs::write(&table, text).unwrap();
    let ended = run(
        "irb120",
        &table,
        &out,
        &["--between", "joints", "--rate", "10"],
    );
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    let rows = samples(&out);
    assert_eq!(rows.len(), 11);
    for (k, row) in rows.iter().enumerate() {
        let share = k as f64 / 10.0;
        for (j, value) in row.iter().enumerate() {
            let straight = rows[0][j] + share * (rows[10][j] - rows[0][j]);
            assert!((value - straight).abs() < 1e-12, "sample {k}, joint {j}");
        }
    }
    let far = "t,x,y,z,roll,pitch,yaw\n0,0.3,0.25,0.4,3.14159,0,0\n1,3,0.25,0.4,3.14159,0,0\n";
    fs::write(&table, far).unwrap();
    let ended = run("irb120", &table, &out, &["--between", "joints"]);
    assert_eq!(ended.code, 1);
    assert!(
        ended.stdout.contains("row 2, t = 1 s: wrist centre"),
        "{}",
        ended.stdout
    );
}
