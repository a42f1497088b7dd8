//! A pose as people and programs give it.

use std::path::Path;

use nalgebra::{Quaternion, UnitQuaternion};
use pieper::spatial::{self, Pose};
use serde_json::Value;

use crate::batch::shown;
use crate::error::Failure;
use crate::source::read_text;

/// What is understood.
const EXPECTED: &str = "a 4x4 nested list, x,y,z,roll,pitch,yaw, x,y,z,qw,qx,qy,qz, or a file with one of these was expected";

/// From `--pose`.
pub(super) fn from_text(text: &str, deg: bool) -> Result<Pose, String> {
    if let Some(result) = inline(text, deg) {
        return result.map_err(|text| format!("--pose: {text}"));
    }
    let path = Path::new(text);
    if !path.exists() {
        return Err(format!("--pose {text}: {EXPECTED}"));
    }
    let content = match read_text(path) {
        Ok(content) => content,
        Err(Failure::Input(text) | Failure::World(text)) => return Err(text),
        Err(Failure::ClosedPipe) => return Err(format!("{text}: it could not be read")),
    };
    inline(&content, deg)
        .unwrap_or_else(|| Err(EXPECTED.to_owned()))
        .map_err(|error| format!("{text}: {error}"))
}

/// JSON or bare numbers; `None` if it is neither.
fn inline(text: &str, deg: bool) -> Option<Result<Pose, String>> {
    let text = text.trim();
    if text.starts_with(['[', '{']) {
        let value = serde_json::from_str(text).map_err(|error| format!("it is no JSON: {error}"));
        return Some(value.and_then(|value| from_json(&value, deg)));
    }
    numbers(text).map(|values| from_numbers(&values, deg))
}

/// From a JSON value: a matrix, a list of six or seven numbers, or an object with a `pose`.
pub(super) fn from_json(value: &Value, deg: bool) -> Result<Pose, String> {
    let wrong = || format!("{}: {EXPECTED}", shown(value));
    match value {
        Value::Object(object) => from_json(object.get("pose").ok_or_else(wrong)?, deg),
        Value::Array(list) if list.iter().all(Value::is_array) => {
            let row = |row: &Value| -> Option<Vec<f64>> {
                row.as_array()?.iter().map(Value::as_f64).collect()
            };
            let rows: Option<Vec<Vec<f64>>> = list.iter().map(row).collect();
            spatial::pose_from_rows(&rows.ok_or_else(wrong)?).map_err(|error| error.to_string())
        }
        Value::Array(list) => {
            let values: Option<Vec<f64>> = list.iter().map(Value::as_f64).collect();
            from_numbers(&values.ok_or_else(wrong)?, deg)
        }
        _ => Err(wrong()),
    }
}

/// Numbers separated by commas or spaces.
pub(super) fn numbers(text: &str) -> Option<Vec<f64>> {
    let parts = text
        .split([',', ' ', '\n', '\t', '\r'])
        .filter(|part| !part.is_empty());
    let values: Option<Vec<f64>> = parts.map(|part| part.parse().ok()).collect();
    values.filter(|values| !values.is_empty())
}

fn from_numbers(values: &[f64], deg: bool) -> Result<Pose, String> {
    if let Some(value) = values.iter().find(|value| !value.is_finite()) {
        return Err(format!("{value}: a finite number was expected"));
    }
    match *values {
        [x, y, z, roll, pitch, yaw] => {
            let angle = |value: f64| if deg { value.to_radians() } else { value };
            Ok(spatial::from_xyz_rpy(
                [x, y, z],
                [roll, pitch, yaw].map(angle),
            ))
        }
        [x, y, z, w, i, j, k] => {
            let quaternion = Quaternion::new(w, i, j, k);
            let off = (quaternion.norm() - 1.0).abs();
            if off > UNIT_TOLERANCE {
                return Err(format!(
                    "the quaternion is off unit length by {off:.3e}, at most 1e-6 was expected"
                ));
            }
            let rotation = UnitQuaternion::new_normalize(quaternion).to_rotation_matrix();
            Ok(Pose::from_parts([x, y, z].into(), rotation))
        }
        _ => Err(format!("{} numbers were given; {EXPECTED}", values.len())),
    }
}

/// How far a quaternion may be from unit length: the contract of the program.
const UNIT_TOLERANCE: f64 = 1e-6;
