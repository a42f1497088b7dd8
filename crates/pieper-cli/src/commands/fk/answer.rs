//! What `pieper fk` answers, for people and for programs.

use std::fmt::Write as _;

use pieper::Result;
use pieper::describe::{Form, Robot};
use pieper::kinematics::{self, AxisDirections, Directions, Jacobian, Measures, Reference};
use pieper::model::Chain;
use pieper::spatial::{self, Pose};
use serde_json::{Map, Value, json};

use super::joints::Joints;
use super::{Axes, Method, Shown};
use crate::{json, text};

/// Everything that was asked for at one joint vector.
pub(super) struct Answer {
    pose: Pose,
    frames: Option<Vec<(String, Pose)>>,
    jacobian: Option<(Axes, Jacobian, Option<Measures>)>,
    pub(super) violations: Vec<String>,
}

impl Answer {
    pub(super) fn compute(
        robot: &Robot,
        chain: &Chain,
        joints: &Joints,
        shown: &Shown,
    ) -> Result<Self> {
        let q = &joints.chain;
        let pose = match shown.method {
            Method::Matrix => kinematics::tool_pose(chain, q)?,
            Method::Quaternion => {
                nalgebra::convert(kinematics::tool_pose_by_quaternions(chain, q)?)
            }
        };
        let frames = match shown.frames {
            true => Some(frames(robot, chain, joints)?),
            false => None,
        };
        let jacobian = match shown.jacobian {
            None => None,
            Some(axes) => {
                let mut jacobian = Jacobian::zeros(chain.dof());
                kinematics::pose_and_jacobian(chain, q, Reference::from(axes), &mut jacobian)?;
                let measures = kinematics::measures(&jacobian);
                Some((axes, jacobian, measures))
            }
        };
        Ok(Self {
            pose,
            frames,
            jacobian,
            violations: chain.limit_violations(q),
        })
    }

    /// The fields of a batch's answer.
    pub(super) fn batch_fields(&self, limits: bool) -> Map<String, Value> {
        let mut fields = Map::new();
        fields.insert("pose".to_owned(), json::pose(&self.pose));
        if let Some(frames) = &self.frames {
            let frames = frames
                .iter()
                .map(|(name, pose)| (name.clone(), json::pose(pose)));
            fields.insert("frames".to_owned(), Value::Object(frames.collect()));
        }
        if let Some((_, jacobian, measures)) = &self.jacobian {
            fields.insert("jacobian".to_owned(), json::jacobian(jacobian));
            let manipulability = measures.as_ref().map(|measures| measures.manipulability);
            fields.insert("manipulability".to_owned(), json!(manipulability));
        }
        if limits {
            fields.insert("warnings".to_owned(), json!(self.violations));
        }
        fields
    }

    /// One JSON document.
    pub(super) fn document(&self, robot: &str, deg: bool) -> Value {
        let angle = |radians: f64| if deg { radians.to_degrees() } else { radians };
        let directions = Directions::of(&self.pose);
        let axis = |axis: &AxisDirections| json!({"cosines": axis.cosines, "angles": axis.angles.map(angle)});
        let q = nalgebra::UnitQuaternion::from_rotation_matrix(&self.pose.rotation);
        let mut document = Map::new();
        document.insert("robot".to_owned(), robot.into());
        document.extend(self.batch_fields(true));
        let rpy = spatial::to_rpy(&self.pose.rotation).map(angle);
        document.insert("rpy".to_owned(), json!(rpy));
        document.insert("quaternion".to_owned(), json!([q.w, q.i, q.j, q.k]));
        let axes =
            json!({"i": axis(&directions.i), "j": axis(&directions.j), "k": axis(&directions.k)});
        document.insert("directions".to_owned(), axes);
        if let Some((_, _, Some(measures))) = &self.jacobian {
            document.insert("measures".to_owned(), measures_document(measures));
        }
        Value::Object(document)
    }

    /// Text for a person.
    pub(super) fn text(&self, robot: &str, deg: bool) -> String {
        let angle = |radians: f64| if deg { radians.to_degrees() } else { radians };
        let unit = if deg { "deg" } else { "rad" };
        let mut out =
            format!("{robot}\n\ntool pose: columns n, s, a (the tool's x, y, z) and p in metres\n");
        out.push_str(&matrix(&self.pose));
        let rpy = spatial::to_rpy(&self.pose.rotation).map(|a| text::number(angle(a)));
        let q = nalgebra::UnitQuaternion::from_rotation_matrix(&self.pose.rotation);
        let q = [q.w, q.i, q.j, q.k].map(text::number);
        let _ = write!(out, "\nroll, pitch, yaw ({unit})  {}\n", rpy.join("  "));
        let _ = writeln!(out, "quaternion w x y z      {}", q.join("  "));
        out.push_str(&directions_text(&Directions::of(&self.pose), unit, angle));
        if let Some((axes, jacobian, measures)) = &self.jacobian {
            out.push_str(&jacobian_text(*axes, jacobian, measures.as_ref()));
        }
        for (name, pose) in self.frames.iter().flatten() {
            let _ = write!(out, "\nframe {name}\n{}", matrix(pose));
        }
        out
    }
}

fn frames(robot: &Robot, chain: &Chain, joints: &Joints) -> Result<Vec<(String, Pose)>> {
    if let Form::Tree { tree, .. } = &robot.form {
        let names = tree.links().iter().map(|link| link.name.clone());
        return Ok(names.zip(tree.link_poses(&joints.tree)?).collect());
    }
    let mut poses = Vec::new();
    kinematics::link_poses(chain, &joints.chain, &mut poses)?;
    let names = chain.joints().iter().map(|joint| joint.link.clone());
    Ok(names.zip(poses).collect())
}

fn matrix(pose: &Pose) -> String {
    let (m, p) = (pose.rotation.matrix(), &pose.translation.vector);
    let row = |i: usize| {
        [m[(i, 0)], m[(i, 1)], m[(i, 2)], p[i]]
            .map(text::number)
            .to_vec()
    };
    text::table(&[row(0), row(1), row(2)])
}

fn directions_text(directions: &Directions, unit: &str, angle: impl Fn(f64) -> f64) -> String {
    let head = [
        "", "cos x", "cos y", "cos z", "angle x", "angle y", "angle z",
    ]
    .map(str::to_owned)
    .to_vec();
    let row = |name: &str, axis: &AxisDirections| {
        let cosines = axis.cosines.iter().map(|&c| text::number(c));
        let angles = axis.angles.iter().map(|&a| text::number(angle(a)));
        [name.to_owned()]
            .into_iter()
            .chain(cosines)
            .chain(angles)
            .collect()
    };
    let rows = [
        head,
        row("i", &directions.i),
        row("j", &directions.j),
        row("k", &directions.k),
    ];
    format!(
        "\ndirection cosines of the tool's i, j, k and their angles with the base's axes ({unit})\n{}",
        text::table(&rows)
    )
}

fn jacobian_text(axes: Axes, jacobian: &Jacobian, measures: Option<&Measures>) -> String {
    let names = ["vx", "vy", "vz", "wx", "wy", "wz"];
    let row = |i: usize| {
        let values = jacobian
            .row(i)
            .iter()
            .map(|&value| text::number(value))
            .collect::<Vec<_>>();
        [names[i].to_owned()].into_iter().chain(values).collect()
    };
    let rows: Vec<Vec<String>> = (0..6).map(row).collect();
    let axes = match axes {
        Axes::Base => "base",
        Axes::Tool => "tool",
    };
    let mut out = format!(
        "\nJacobian of the tool point, {axes} axes\n{}",
        text::table(&rows)
    );
    let Some(measures) = measures else { return out };
    let number = |value: f64| format!("{value:.6e}");
    let rows = [
        ("manipulability (Yoshikawa)", measures.manipulability),
        ("  translational", measures.translational),
        ("  rotational", measures.rotational),
        ("condition number", measures.condition),
        ("smallest singular value", measures.singularity.distance),
    ];
    let rows = rows.map(|(name, value)| vec![name.to_owned(), number(value)]);
    let _ = write!(out, "\n{}", text::listing(&rows));
    if measures.singularity.distance < NEAR_SINGULAR {
        let lost = measures
            .singularity
            .lost_twist
            .map(|x| (x * 1e6).round() / 1e6 + 0.0);
        let _ = writeln!(
            out,
            "  near a singularity: the twist (v; w) = {:?} is lost",
            lost.as_slice()
        );
    }
    out
}

/// Below this smallest singular value an answer says what is being lost.
const NEAR_SINGULAR: f64 = 1e-3;

fn measures_document(measures: &Measures) -> Value {
    json!({
        "manipulability": measures.manipulability,
        "translational": measures.translational,
        "rotational": measures.rotational,
        // JSON has no infinity: null says that the arm is singular.
        "condition": measures.condition.is_finite().then_some(measures.condition),
        "singular_values": measures.singular_values,
        "lost_twist": measures.singularity.lost_twist.as_slice(),
        "idle_joints": measures.singularity.idle_joints.as_slice(),
    })
}
