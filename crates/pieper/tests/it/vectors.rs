//! The verified vectors: poses and Jacobians computed with 50 digits, each arm as a table and as screws.

use nalgebra::{Matrix3, Rotation3};
use pieper::describe::Robot;
use pieper::kinematics::{Jacobian, Reference, measures, pose_and_jacobian, tool_pose};
use pieper::model::Chain;
use pieper::spatial::to_rpy;
use serde_json::Value;

fn records(file: &str) -> Vec<Value> {
    let path = format!("{}/../../vectors/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .unwrap()
        .iter()
        .map(|x| x.as_f64().unwrap())
        .collect()
}

fn variable(row: &Value, index: usize) -> String {
    let sign = if row["sign"].as_f64().unwrap() > 0.0 {
        "+"
    } else {
        "-"
    };
    format!(
        "\"{} {sign} q{}\"",
        row["offset"].as_f64().unwrap(),
        index + 1
    )
}

/// The record's arm as a table.
fn table(record: &Value) -> Chain {
    let mut text = "name = 'r'\nconvention = 'standard'\n".to_owned();
    for (index, row) in record["rows"].as_array().unwrap().iter().enumerate() {
        let (theta, d) = match row["type"].as_str().unwrap() {
            "R" => (variable(row, index), row["d"].to_string()),
            _ => (row["theta"].to_string(), variable(row, index)),
        };
        let (a, alpha) = (&row["a"], &row["alpha"]);
        text += &format!("[[joint]]\ntheta = {theta}\nd = {d}\na = {a}\nalpha = {alpha}\n");
    }
    Robot::from_toml("table.toml", &text)
        .unwrap()
        .chain()
        .unwrap()
}

/// The record's arm as screws.
fn screws(record: &Value) -> Chain {
    let poe = &record["poe"];
    let mut text = "name = 'r'\n".to_owned();
    for (index, row) in record["rows"].as_array().unwrap().iter().enumerate() {
        let key = if row["type"] == "R" { "theta" } else { "d" };
        let (h, p) = (&poe["h"][index], &poe["p"][index]);
        text += &format!(
            "[[screws]]\nh = {h}\np = {p}\n{key} = {}\n",
            variable(row, index)
        );
    }
    let rotation: Vec<Vec<f64>> = poe["R0"].as_array().unwrap().iter().map(numbers).collect();
    let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_fn(|i, j| rotation[i][j]));
    let last = poe["p"].as_array().unwrap().last().unwrap();
    text += &format!("[tool]\nxyz = {last}\nrpy = {:?}\n", to_rpy(&rotation));
    Robot::from_toml("screws.toml", &text)
        .unwrap()
        .chain()
        .unwrap()
}

fn off(rows: &Value, entry: impl Fn(usize, usize) -> f64) -> f64 {
    let rows = rows.as_array().unwrap().iter().map(numbers).enumerate();
    let entries =
        rows.flat_map(|(i, row)| row.into_iter().enumerate().map(move |(j, x)| (i, j, x)));
    entries
        .map(|(i, j, x)| (x - entry(i, j)).abs())
        .fold(0.0, f64::max)
}

#[test]
fn poses_agree_to_the_last_digits() {
    let mut arms: Vec<(String, Chain, Chain)> = Vec::new();
    let mut checked = 0;
    for record in records("fk.jsonl") {
        if record["kind"] == "robot" {
            arms.push((
                record["name"].as_str().unwrap().to_owned(),
                table(&record),
                screws(&record),
            ));
            continue;
        }
        let (name, table, screws) = arms
            .iter()
            .find(|(name, ..)| record["robot"] == **name)
            .unwrap();
        let q = numbers(&record["q"]);
        for (form, chain) in [("table", table), ("screws", screws)] {
            let pose = tool_pose(chain, &q).unwrap().to_homogeneous();
            let off = off(&record["T"], |i, j| pose[(i, j)]);
            assert!(off <= 1e-14, "{name} as {form}: off by {off:e} at {q:?}");
        }
        checked += 1;
    }
    assert_eq!(checked, 65);
}

#[test]
fn jacobians_agree_to_the_last_digits() {
    let mut chain = None;
    for record in records("jacobian.jsonl") {
        if record["kind"] == "robot" {
            chain = Some(table(&record));
            continue;
        }
        let chain = chain.as_ref().unwrap();
        let mut jacobian = Jacobian::zeros(6);
        for (key, reference) in [("J_tool", Reference::Tool), ("J_base", Reference::Base)] {
            pose_and_jacobian(chain, &numbers(&record["q"]), reference, &mut jacobian).unwrap();
            let off = off(&record[key], |i, j| jacobian[(i, j)]);
            assert!(off <= 1e-13, "{key} is off by {off:e}");
        }
        let found = measures(&jacobian).unwrap();
        for (key, value) in [
            ("manipulability", found.manipulability),
            ("manipulability_trans", found.translational),
            ("manipulability_rot", found.rotational),
        ] {
            assert!(
                (record[key].as_f64().unwrap() - value).abs() <= 1e-13,
                "{key}"
            );
        }
        for (expected, value) in numbers(&record["singular_values"])
            .iter()
            .zip(&found.singular_values)
        {
            assert!((expected - value).abs() <= 1e-13);
        }
    }
}
