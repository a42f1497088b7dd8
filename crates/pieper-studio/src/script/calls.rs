//! What a script may ask of the session.

use pieper::spatial::to_rpy;
use serde_json::{Value, json};

use crate::command::Command;
use crate::session::Session;

/// Degrees for a joint that turns, millimetres for one that slides.
fn scale(session: &Session, joint: usize) -> f64 {
    match session.arm.chain.variables()[joint].kind.is_angular() {
        true => 180.0 / std::f64::consts::PI,
        false => 1000.0,
    }
}

fn shown(session: &Session, q: &[f64]) -> Vec<f64> {
    q.iter()
        .enumerate()
        .map(|(joint, value)| value * scale(session, joint))
        .collect()
}

/// Answers a call; all moves of one run, named by `gesture`, are one step of undo.
pub(super) fn answer(
    session: &mut Session,
    call: &[Value],
    gesture: &str,
) -> Result<Value, String> {
    let name = call.first().and_then(Value::as_str).unwrap_or_default();
    let number = |place: usize| {
        let value = call
            .get(place)
            .and_then(Value::as_f64)
            .filter(|value| value.is_finite());
        value.ok_or_else(|| format!("{name}: a finite number was expected"))
    };
    let joint = |session: &Session| -> Result<usize, String> {
        let asked = number(1)?;
        let dof = session.arm.dof();
        let fits = asked >= 1.0 && asked <= dof as f64;
        if fits {
            Ok(asked as usize - 1)
        } else {
            Err(format!("joint {asked}: the arm has joints 1 to {dof}"))
        }
    };
    match name {
        "joint" => {
            let joint = joint(session)?;
            Ok(json!(session.q[joint] * scale(session, joint)))
        }
        "joints" => Ok(json!(shown(session, &session.q))),
        "set_joint" => {
            let joint = joint(session)?;
            let value = number(2)? / scale(session, joint);
            apply(
                session,
                json!({"do": "joint", "joint": joint, "value": value, "gesture": gesture}),
            )
        }
        "set_joints" => {
            let values: Vec<f64> = call
                .get(1)
                .and_then(Value::as_array)
                .into_iter()
                .flatten()
                .filter_map(Value::as_f64)
                .collect();
            if values.len() != session.arm.dof() {
                return Err(format!(
                    "joints: {} values were expected, {} were given",
                    session.arm.dof(),
                    values.len()
                ));
            }
            let q: Vec<f64> = values
                .iter()
                .enumerate()
                .map(|(joint, value)| value / scale(session, joint))
                .collect();
            apply(session, json!({"do": "joints", "q": q, "gesture": gesture}))
        }
        "tool" => {
            let pose = session.tool_now();
            let turn = to_rpy(&pose.rotation.to_rotation_matrix()).map(f64::to_degrees);
            let place = pose.translation.vector * 1000.0;
            Ok(json!([
                place.x, place.y, place.z, turn[0], turn[1], turn[2]
            ]))
        }
        "matrix" => {
            let m = session.tool_now().to_homogeneous();
            Ok((0..4)
                .map(|i| (0..4).map(|j| m[(i, j)]).collect::<Vec<f64>>())
                .collect())
        }
        "move" => {
            let values = |place: usize| {
                call.get(place)
                    .and_then(Value::as_array)
                    .cloned()
                    .unwrap_or_default()
            };
            let place: Vec<f64> = values(1)
                .iter()
                .filter_map(Value::as_f64)
                .map(|x| x / 1000.0)
                .collect();
            let now = to_rpy(&session.tool_now().rotation.to_rotation_matrix());
            let given = values(2);
            let turn: Vec<f64> = (0..3)
                .map(|k| {
                    given
                        .get(k)
                        .and_then(Value::as_f64)
                        .map_or(now[k], f64::to_radians)
                })
                .collect();
            let keeps = given.iter().all(Value::is_null);
            let mut goal = json!({"do": "tool", "position": place, "gesture": gesture});
            if !keeps {
                goal["rpy"] = json!(turn);
            }
            let answer = apply(session, goal)?;
            match answer["reached"].as_bool() {
                Some(true) => Ok(Value::Null),
                _ => Err(answer["sentence"].as_str().unwrap_or_default().to_owned()),
            }
        }
        "solutions" => {
            let found = session.solutions();
            Ok(found
                .iter()
                .flatten()
                .map(|solution| shown(session, solution.q()))
                .collect())
        }
        "keyframe" => {
            let mut command = json!({"do": "keyframe", "op": "add"});
            if call.get(1).is_some_and(|t| !t.is_null()) {
                command["t"] = json!(number(1)?);
            }
            apply(session, command)
        }
        "limits" => Ok((0..session.arm.dof())
            .map(|joint| {
                let ([low, high], _) = session.arm.range(joint);
                json!([low * scale(session, joint), high * scale(session, joint)])
            })
            .collect()),
        // How often the paper's program redraws: this one always does.
        "refresh_rate" => number(1).map(|_| Value::Null),
        _ => Err(format!("mathmodel has no {name}")),
    }
}

fn apply(session: &mut Session, command: Value) -> Result<Value, String> {
    let command: Command = serde_json::from_value(command).map_err(|error| error.to_string())?;
    session.apply(command)
}
