//! What `pieper fk` answers, for people and for programs.

use std::fmt::Write as _;

use pieper::Result;
use pieper::describe::{Form, Robot};
use pieper::kinematics::{self, AxisDirections, Directions, Jacobian, Measures, Reference};
use pieper::model::Chain;
use pieper::spatial::{self, Pose};
use pieper::transmission::{Ratios, Transmission};
use serde_json::{Map, Value, json};

use super::joints::Joints;
use super::{Axes, Method, Shown};
use crate::commands::motors::Motors;
use crate::{json, text};

/// Everything that was asked for at one joint vector.
pub(super) struct Answer {
    pose: Pose,
    frames: Option<Vec<(String, Pose)>>,
    jacobian: Option<(Axes, Jacobian, Option<Measures>)>,
    /// The joint values, where they were given as motor values or have some; radians and metres.
    driven: Option<Driven>,
    pub(super) violations: Vec<String>,
}

/// What an arm with a transmission adds.
struct Driven {
    /// The joint values in both units.
    q: Vec<(f64, bool)>,
    motors: Motors,
    /// The Jacobian by motors, if one was asked for; none at a dead point or out of a drive's reach.
    jacobian: Option<Option<Jacobian>>,
}

impl Answer {
    pub(super) fn compute(
        robot: &Robot,
        chain: &Chain,
        drives: Option<&Transmission>,
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
        let by_joints = jacobian.as_ref().map(|(_, jacobian, _)| jacobian);
        let driven = drives.map(|drives| Driven::compute(chain, drives, q, by_joints));
        let driven = driven.transpose()?;
        let mut violations = chain.limit_violations(q);
        violations.extend(
            driven
                .iter()
                .filter_map(|driven| driven.motors.reason.clone()),
        );
        Ok(Self {
            pose,
            frames,
            jacobian,
            driven,
            violations,
        })
    }

    /// The fields of a batch's answer.
    pub(super) fn batch_fields(&self, limits: bool, deg: bool) -> Map<String, Value> {
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
        if let Some(driven) = &self.driven {
            fields.insert("q".to_owned(), json!(driven.joints(deg)));
            fields.extend(driven.motors.fields(deg));
            if let Some(jacobian) = &driven.jacobian {
                let jacobian = jacobian.as_ref().map(json::jacobian);
                fields.insert("motor_jacobian".to_owned(), json!(jacobian));
            }
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
        document.extend(self.batch_fields(true, deg));
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
        if let Some(driven) = &self.driven {
            out.push_str(&driven.text(unit, deg));
        }
        out.push_str(&directions_text(&Directions::of(&self.pose), unit, angle));
        if let Some((axes, jacobian, measures)) = &self.jacobian {
            out.push_str(&jacobian_text(*axes, jacobian, measures.as_ref()));
            if let Some(Some(jacobian)) = self.driven.as_ref().map(|driven| &driven.jacobian) {
                out.push_str(&match jacobian {
                    Some(jacobian) => format!("\nJacobian by motors\n{}", rows_text(jacobian)),
                    None => "\nno Jacobian by motors: a drive is at its dead point or cannot reach this\n".to_owned(),
                });
            }
        }
        for (name, pose) in self.frames.iter().flatten() {
            let _ = write!(out, "\nframe {name}\n{}", matrix(pose));
        }
        out
    }
}

impl Driven {
    fn compute(
        chain: &Chain,
        drives: &Transmission,
        q: &[f64],
        jacobian: Option<&Jacobian>,
    ) -> Result<Self> {
        let by_motors = |jacobian: &Jacobian| {
            let mut ratios = Ratios::zeros(drives.dof());
            match drives.ratios(q, &mut ratios)? {
                Ok(()) => ratios.motor_jacobian(jacobian).map(Some),
                Err(_) => Ok(None),
            }
        };
        let is_angle = chain
            .variables()
            .iter()
            .map(|variable| variable.kind.is_angular());
        Ok(Self {
            q: q.iter().copied().zip(is_angle).collect(),
            motors: Motors::at(drives, q)?,
            jacobian: jacobian.map(by_motors).transpose()?,
        })
    }

    fn joints(&self, deg: bool) -> Vec<f64> {
        let shown = |&(value, is_angle): &(f64, bool)| match deg && is_angle {
            true => value.to_degrees(),
            false => value,
        };
        self.q.iter().map(shown).collect()
    }

    fn text(&self, unit: &str, deg: bool) -> String {
        let joints = self.joints(deg).into_iter().map(text::number);
        let row = |name: &str, cells: Vec<String>| [vec![name.to_owned()], cells].concat();
        let rows = [
            row("joints", joints.collect()),
            row("motors", self.motors.cells(deg).collect()),
        ];
        let mut out = format!("\njoints and motors ({unit}, m)\n{}", text::table(&rows));
        if let Some(reason) = &self.motors.reason {
            let _ = writeln!(out, "  {reason}");
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
    let axes = match axes {
        Axes::Base => "base",
        Axes::Tool => "tool",
    };
    let mut out = format!(
        "\nJacobian of the tool point, {axes} axes\n{}",
        rows_text(jacobian)
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

fn rows_text(jacobian: &Jacobian) -> String {
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
    text::table(&rows)
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
