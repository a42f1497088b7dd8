//! What the page is told: WIRE.md section 3.

use nalgebra::{Isometry3, UnitQuaternion};
use pieper::describe::Form;
use pieper::describe::dh::{DhTable, Moves};
use pieper::ik::registry::ROWS;
use pieper::ik::{Elbow, Shoulder, Solution, Wrist};
use pieper::kinematics::{
    Jacobian, Reference, measures, pose_and_jacobian, tool_pose, tool_pose_by_quaternions,
};
use pieper::model::{JointKind, TreeLink};
use pieper::motion::Profile;
use pieper::spatial::to_rpy;
use pieper_scene::frames::isometry;
use serde_json::{Value, json};

use crate::command::MethodName;
use crate::frames;
use crate::session::Session;

/// A part of the state that is sent whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Section {
    Robots,
    Robot,
    Pose,
    Ik,
    Motion,
    Script,
    History,
    Log,
    /// The binary frame of the links.
    Frame,
}

impl Section {
    pub(crate) const ALL: [Self; 9] = [
        Self::Robots,
        Self::Robot,
        Self::Pose,
        Self::Ik,
        Self::Motion,
        Self::Script,
        Self::History,
        Self::Log,
        Self::Frame,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Robots => "robots",
            Self::Robot => "robot",
            Self::Pose => "pose",
            Self::Ik => "ik",
            Self::Motion => "motion",
            Self::Script => "script",
            Self::History => "history",
            Self::Log => "log",
            Self::Frame => "frame",
        }
    }
}

impl Session {
    /// A section's value; null for the frame, which is binary.
    pub(crate) fn section(&self, section: Section) -> Value {
        match section {
            Section::Robots => robots(),
            Section::Robot => self.robot_section(),
            Section::Pose => self.pose_section(),
            Section::Ik => self.ik_section(),
            Section::Motion => self.motion_section(),
            Section::Script => self.script_status.value(&self.script),
            Section::History => {
                let [undo, redo] = self.labels();
                json!({"undo": undo, "redo": redo})
            }
            Section::Log => self
                .log
                .iter()
                .map(|line| json!({"level": line.level, "text": line.text}))
                .collect(),
            Section::Frame => Value::Null,
        }
    }

    /// The frame of the links, as bytes.
    pub(crate) fn frame(&self, sequence: u32) -> Vec<u8> {
        let motion = &self.motion;
        frames::pose(
            motion.playing,
            sequence,
            motion.time,
            &self.q,
            &self.arm.poses(&self.q),
        )
    }

    /// The frame of the other solutions, as bytes; of none where they are not asked for.
    pub(crate) fn ghost_frame(&self, sequence: u32) -> Vec<u8> {
        let links = self.arm.mover.len();
        let found = self.solutions().filter(|_| self.ghosts);
        let ghosts: Vec<Vec<Isometry3<f64>>> = found
            .iter()
            .flatten()
            .map(|solution| self.arm.poses(solution.q()))
            .collect();
        frames::ghosts(sequence, links, &ghosts)
    }

    /// The links along the motion, as frames: `rate` of them a second, `most` at most.
    pub(crate) fn pictures(&self, rate: f64, most: f64) -> Vec<Vec<u8>> {
        let motion = &self.motion;
        let end = motion.duration();
        if end <= 0.0 {
            return Vec::new();
        }
        let count = (end * rate).clamp(2.0, most).ceil() as u32;
        let picture = |k: u32| {
            let t = end * f64::from(k) / f64::from(count);
            let q = motion.at(t)?;
            Some(frames::pose(true, k, t, &q, &self.arm.poses(&q)))
        };
        (0..=count).filter_map(picture).collect()
    }

    fn robot_section(&self) -> Value {
        let arm = &self.arm;
        let joints: Value = arm
            .chain
            .variables()
            .iter()
            .enumerate()
            .map(|(j, variable)| {
                let ([lower, upper], unlimited) = arm.range(j);
                json!({
                    "name": variable.name, "label": format!("J{}", j + 1), "kind": kind(variable.kind),
                    "lower": lower, "upper": upper, "unlimited": unlimited,
                    "velocity": variable.velocity, "home": self.home[j],
                })
            })
            .collect();
        let links: Value = arm
            .body
            .links
            .iter()
            .enumerate()
            .map(|(link, parts)| {
                let parts: Value = parts
                    .iter()
                    .zip(&arm.names[link])
                    .map(|(part, name)| json!({"mesh": name, "color": part.color, "collision": part.collision, "placed": matrix(&part.placed)}))
                    .collect();
                json!({"name": self.link_name(link), "joint": arm.mover[link], "parts": parts})
            })
            .collect();
        let solver = arm.solver.choice().name;
        let how = ROWS
            .iter()
            .find(|row| row.name == solver)
            .map_or("", |row| row.summary);
        json!({
            "id": arm.id, "name": arm.robot.name, "summary": arm.robot.summary, "source": arm.robot.source, "revision": self.revision,
            "up": arm.robot.up.name(),
            "joints": joints, "links": links, "table": table(&arm.robot.form), "tree": tree(&arm.robot.form),
            "facts": [
                ["solver", solver],
                ["how", how],
                ["joints", arm.dof().to_string()],
                ["reach", format!("{:.3} m", arm.reach)],
            ],
            "parameters": arm.robot.parameters.iter().map(|p| json!([p.name, p.value.as_ref().map(ToString::to_string)])).collect::<Value>(),
            "problems": arm.body.problems, "reach": arm.reach, "outline": arm.outline,
            "outline_frame": matrix(&isometry(&arm.chain.canonical().base)),
        })
    }

    fn link_name(&self, link: usize) -> String {
        if let Some(bar) = link.checked_sub(self.arm.links()) {
            let what = ["crank", "coupler", "rocker"][bar % 3];
            return format!("{what} of {}", self.arm.bars[bar / 3].motor);
        }
        match &self.arm.frames {
            pieper_scene::Frames::Axes if link == 0 => "base".to_owned(),
            pieper_scene::Frames::Axes => format!("link {link}"),
            pieper_scene::Frames::Tree { tree, .. } => tree.links()[link].name.clone(),
        }
    }

    fn pose_section(&self) -> Value {
        let (arm, q) = (&self.arm, &self.q);
        let tool = self.tool_now();
        let by_matrices = tool_pose(&arm.chain, q).map(|pose| pose.to_homogeneous());
        let by_quaternions =
            tool_pose_by_quaternions(&arm.chain, q).map(|pose| pose.to_homogeneous());
        let methods = match (by_matrices, by_quaternions) {
            (Ok(a), Ok(b)) => {
                json!({"matrix": rows(&a), "quaternion": rows(&b), "difference": (a - b).amax()})
            }
            _ => Value::Null,
        };
        let mut jacobian = Jacobian::zeros(q.len());
        let measured = pose_and_jacobian(&arm.chain, q, Reference::Base, &mut jacobian)
            .ok()
            .and_then(|_| measures(&jacobian));
        let measured = measured.map_or(Value::Null, |m| {
            json!({
                "manipulability": m.manipulability,
                "smallest_singular_value": m.singularity.distance,
                "condition": if m.condition.is_finite() { json!(m.condition) } else { Value::Null },
            })
        });
        let over: Vec<bool> = arm
            .chain
            .variables()
            .iter()
            .zip(q)
            .map(|(v, value)| v.limits.is_some_and(|l| !l.contains(*value)))
            .collect();
        json!({
            "q": q, "tool": pose_numbers(&tool), "matrix": rows(&tool.to_homogeneous()),
            "method": match self.method { MethodName::Matrix => "matrix", MethodName::Quaternion => "quaternion" },
            "methods": methods, "measures": measured, "over_limit": over, "unlocked": self.unlocked,
        })
    }

    fn ik_section(&self) -> Value {
        let goal = self.goal();
        // While a motion plays the list would be old before it is read.
        if self.motion.playing {
            return json!({"status": "playing", "solutions": [], "families": []});
        }
        let started = std::time::Instant::now();
        let Some(found) = self.solutions() else {
            return json!({"status": "none", "solutions": [], "families": []});
        };
        let microseconds = started.elapsed().as_secs_f64() * 1e6;
        let solution = |solution: &Solution| {
            let distance = self.travel_to(solution.q());
            json!({
                "q": solution.q(), "branch": solution.branch.to_string(),
                "shoulder": solution.branch.shoulder.map(|s| match s { Shoulder::Front => "front", Shoulder::Back => "back", Shoulder::Left => "left", Shoulder::Right => "right" }),
                "elbow": solution.branch.elbow.map(|e| match e { Elbow::Up => "up", Elbow::Down => "down" }),
                "wrist": solution.branch.wrist.map(|w| match w { Wrist::Flip => "flip", Wrist::NoFlip => "no flip" }),
                "residual": solution.residual, "multiplicity": solution.multiplicity, "within_limits": solution.within_limits,
                "distance": distance, "current": self.missed.is_none() && distance < 1e-6,
            })
        };
        let family = |index: usize| {
            let member = &found.families()[index];
            let at = self
                .on_family
                .as_ref()
                .filter(|(known, _)| *known == index)
                .map_or(0.0, |(_, members)| {
                    let nearest = members
                        .iter()
                        .enumerate()
                        .min_by(|a, b| self.travel_to(a.1).total_cmp(&self.travel_to(b.1)));
                    nearest.map_or(0.0, |(k, _)| k as f64 / (members.len() - 1).max(1) as f64)
                });
            let moving: Vec<String> = member
                .free()
                .iter()
                .enumerate()
                .filter(|(_, x)| x.abs() > 1e-3)
                .map(|(j, _)| format!("J{}", j + 1))
                .collect();
            json!({"name": format!("{} move, the tool stands still", moving.join(", ")), "branch": member.branch.to_string(), "q": member.q(), "free": member.free(), "at": at})
        };
        json!({
            "status": found.status().name(), "solver": self.arm.solver.choice().name, "microseconds": microseconds,
            "goal": pose_numbers(&goal), "missed": self.missed.is_some(),
            "reason": found.reason().map(|reason| reason.to_string()),
            "solutions": found.iter().map(solution).collect::<Value>(),
            "families": (0..found.families().len()).map(family).collect::<Value>(),
        })
    }

    fn motion_section(&self) -> Value {
        let motion = &self.motion;
        json!({
            "keyframes": motion.keyframes.iter().map(|k| json!({"id": k.id, "t": k.t, "label": k.label})).collect::<Value>(),
            "law": motion.profile.name(), "laws": Profile::ALL.map(Profile::name), "duration": motion.duration(),
            "playing": motion.playing, "time": motion.time, "speed": motion.speed, "loop": motion.repeat,
            "name": motion.name, "samples": motion.revision, "problem": motion.problem,
        })
    }
}

fn robots() -> Value {
    let family = |robot: &pieper_robots::BuiltIn| {
        let described = robot.robot();
        json!({"id": robot.id, "name": described.name, "joints": described.form.dof(), "needs": described.missing_parameters()})
    };
    pieper_robots::ALL.iter().map(family).collect()
}

fn kind(kind: JointKind) -> &'static str {
    match kind {
        JointKind::Revolute => "revolute",
        JointKind::Continuous => "continuous",
        JointKind::Prismatic => "prismatic",
    }
}

/// The links of a tree, each with the one it hangs on and the joint between them; null for another description.
fn tree(form: &Form) -> Value {
    let Form::Tree { tree, .. } = form else {
        return Value::Null;
    };
    let link = |(index, link): (usize, &TreeLink)| {
        let carrier = tree.carrier(index);
        let how = carrier.map(|joint| match (&joint.drive, joint.turns) {
            (None, _) => "fixed".to_owned(),
            (Some(drive), turns) => {
                let variable = &tree.variables()[drive.variable];
                match (variable.name == joint.name, turns) {
                    (true, _) => kind(variable.kind).to_owned(),
                    (false, true) => format!("turns with {}", variable.name),
                    (false, false) => format!("slides with {}", variable.name),
                }
            }
        });
        json!({
            "name": link.name, "parent": carrier.map(|joint| joint.parent),
            "joint": carrier.map(|joint| joint.name.as_str()), "how": how,
        })
    };
    tree.links().iter().enumerate().map(link).collect()
}

/// A Denavit-Hartenberg table as texts; null for another description.
fn table(form: &Form) -> Value {
    let Form::Dh(DhTable {
        convention, rows, ..
    }) = form
    else {
        return Value::Null;
    };
    let texts: Value = rows
        .iter()
        .enumerate()
        .map(|(index, row)| {
            let moving = row.moving_entry(index).to_string();
            let (theta, d) = match row.moves {
                Moves::Theta => (moving, row.d.to_string()),
                Moves::D => (row.theta.to_string(), moving),
            };
            json!([theta, d, row.a.to_string(), row.alpha.to_string()])
        })
        .collect();
    json!({"convention": convention.name(), "columns": ["theta", "d", "a", "alpha"], "rows": texts})
}

/// A pose in every form the panel shows.
fn pose_numbers(pose: &Isometry3<f64>) -> Value {
    let q = pose.rotation;
    let q = if q.w < 0.0 {
        UnitQuaternion::new_unchecked(-q.into_inner())
    } else {
        q
    };
    let (axis, angle) = q
        .axis_angle()
        .map_or(([0.0, 0.0, 1.0], 0.0), |(axis, angle)| {
            (axis.into_inner().into(), angle)
        });
    json!({
        "position": [pose.translation.x, pose.translation.y, pose.translation.z],
        "rpy": to_rpy(&q.to_rotation_matrix()),
        "quaternion": [q.w, q.i, q.j, q.k],
        "axis": axis, "angle": angle,
    })
}

fn rows(m: &nalgebra::Matrix4<f64>) -> Value {
    (0..4)
        .map(|i| (0..4).map(|j| m[(i, j)]).collect::<Vec<f64>>())
        .collect()
}

fn matrix(pose: &Isometry3<f64>) -> Value {
    rows(&pose.to_homogeneous())
}
