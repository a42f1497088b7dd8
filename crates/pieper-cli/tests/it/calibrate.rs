//! `pieper calibrate`

use crate::support::{Ended, Temporary, pieper};

fn json(ended: &Ended) -> serde_json::Value {
    serde_json::from_str(&ended.stdout).expect(&ended.stderr)
}

/// Simulate, calibrate, and use the arm that was identified.
#[test]
fn the_round_trip() {
    let folder = Temporary::new();
    let (table, arm) = (folder.path("m.csv"), folder.path("real.toml"));
    let ended = pieper(&[
        "calibrate",
        "irb120",
        "--simulate",
        "--out",
        &table,
        "--json",
    ]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let truth = json(&ended)["truth"].clone();
    let ended = pieper(&["calibrate", "irb120", &table, "--out", &arm, "--json"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let result = json(&ended);
    assert_eq!(result["converged"], true);
    assert!(result["rms_after"].as_f64().unwrap() < 2e-4);
    assert!(
        result["held_out"]["after"].as_f64().unwrap() * 10.0
            < result["held_out"]["before"].as_f64().unwrap()
    );
    // What nothing else shows together with is found, within four of its standard deviations.
    let alone = result["parameters"]
        .as_array()
        .unwrap()
        .iter()
        .find(|p| p["name"] == "a2")
        .unwrap();
    let off = alone["value"].as_f64().unwrap() - truth["a2"].as_f64().unwrap();
    assert!(off.abs() < 4.0 * alone["sigma"].as_f64().unwrap(), "{off}");
    assert!(
        result["held"]
            .as_array()
            .unwrap()
            .iter()
            .any(|held| held["sentence"] == "d2 and d3 only together")
    );
    // The arm is an arm: there and back, by its own inverse.
    let ended = pieper(&["fk", &arm, "--q", "10,20,-30,40,50,60", "--deg", "--json"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let pose = json(&ended)["pose"].to_string();
    let ended = pieper(&["ik", &arm, "--pose", &pose, "--deg", "--json"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let wanted = [10.0, 20.0, -30.0, 40.0, 50.0, 60.0];
    let solutions = json(&ended)["solutions"].clone();
    let hits = |solution: &serde_json::Value| {
        let q = solution["q"].as_array().unwrap();
        q.iter()
            .zip(wanted)
            .all(|(q, w)| (q.as_f64().unwrap() - w).abs() < 1e-6)
    };
    assert!(
        solutions.as_array().unwrap().iter().any(hits),
        "{solutions}"
    );
    let page = std::fs::read_to_string(folder.path("real.html")).unwrap();
    assert!(page.contains("only together") && page.contains("<svg"));
}

#[test]
fn outliers_are_named_by_their_rows() {
    let folder = Temporary::new();
    let (table, arm) = (folder.path("m.csv"), folder.path("real.toml"));
    let ended = pieper(&[
        "calibrate",
        "ar3",
        "--simulate",
        "--outliers",
        "0.05",
        "--seed",
        "3",
        "--out",
        &table,
    ]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let ended = pieper(&["calibrate", "ar3", &table, "--out", &arm]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(
        ended.stdout.contains("do not agree with the others"),
        "{}",
        ended.stdout
    );
}

#[test]
fn a_plan_says_more_than_chance() {
    let folder = Temporary::new();
    let plan = folder.path("plan.csv");
    let ended = pieper(&[
        "calibrate",
        "irb120",
        "--design",
        "15",
        "--out",
        &plan,
        "--json",
    ]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let plan = json(&ended);
    assert_eq!(plan["postures"].as_array().unwrap().len(), 15);
    assert!(plan["gain"].as_f64().unwrap() > 1.05, "{plan}");
}

/// What is wrong with a table is told with its place.
#[test]
fn wrong_tables_are_refused_with_their_place() {
    let folder = Temporary::new();
    let out = folder.path("real.toml");
    let head = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";
    let cases = [
        (String::new(), "a header was expected"),
        (format!("{head},x,y,zz\n"), "m.csv:1:47: \"zz\""),
        ("q1,q2,q3,x,y,z\n".to_owned(), "a column q4 or"),
        (format!("{head},x_deg,y,z\n"), "this is a length"),
        (format!("{head},x,y,z\n"), "a row of values was expected"),
        (
            format!("{head},x,y,z\n0,0,0,0,0,0,1,2\n"),
            "9 cells were expected",
        ),
        (
            format!("{head},x,y,z\n0,0,0,0,0,0,1,2,nan\n"),
            "a finite number was expected",
        ),
        (
            format!("{head},x,y,z\n0,0,0,0,0,0,1,2,\n"),
            "x, y, z were expected together",
        ),
        (
            format!("{head},x,y,z,qw,qx,qy,qz\n0,0,0,0,0,0,1,2,3,1,1,0,0\n"),
            "a quaternion of length 1",
        ),
        (
            format!("{head},anchor\n0,0,0,0,0,0,A\n"),
            "a distance of 0 or more",
        ),
        (
            format!("{head},mark\n0,0,0,0,0,0,A\n"),
            "something seen was expected",
        ),
        (
            format!("{head},x,y,z,sigma\n0,0,0,0,0,0,1,2,3,-1\n"),
            "above 0 was expected",
        ),
        (
            format!("{head},x,y,z\n0,0,0,0,0,0,374,0,630\n"),
            "are they in millimetres?",
        ),
        (
            format!("{head},x_mm,y_mm,z_mm\n0,0,0,0,0,0,374,0,630\n"),
            "cannot determine",
        ),
    ];
    for (text, said) in cases {
        let table = folder.file("m.csv", &text);
        let ended = pieper(&["calibrate", "irb120", &table, "--out", &out]);
        assert_eq!(ended.code, 2, "{text}: {}", ended.stderr);
        assert!(ended.stderr.contains(said), "{text}: {}", ended.stderr);
    }
    let ended = pieper(&[
        "calibrate",
        "irb120",
        "--simulate",
        "--parameters",
        "theta,zeta",
        "--out",
        &out,
    ]);
    assert_eq!(ended.code, 2);
    assert!(ended.stderr.contains("zeta"), "{}", ended.stderr);
}

#[test]
fn every_example_in_help_works_as_typed() {
    let help = pieper(&["calibrate", "--help"]).stdout;
    let folder = Temporary::new();
    for example in help
        .lines()
        .map(str::trim)
        .filter(|line| line.starts_with("pieper "))
    {
        let words = example.split_whitespace().skip(1);
        let words: Vec<String> = words
            .map(|word| match word.strip_prefix("out/") {
                Some(name) => folder.path(name),
                None => word.to_owned(),
            })
            .collect();
        let ended = pieper(&words.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(ended.code, 0, "{example}: {}", ended.stderr);
    }
}
