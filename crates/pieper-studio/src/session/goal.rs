//! Bringing the tool to a pose, by whichever solution is nearest.

use nalgebra::{Isometry3, Quaternion, Rotation3, Translation3, UnitQuaternion, Vector3};
use pieper::ik::{Options, Solutions, Status, windings};
use pieper::kinematics::tool_pose;
use pieper::spatial::{self, Pose};
use pieper_scene::frames::isometry;
use serde_json::{Value, json};

use super::Session;
use crate::command::{Frame, ToolGoal};
use crate::quantity::Quantity;
use crate::sections::Section;

/// Members of a family that its slider runs over.
const MEMBERS: usize = 97;

/// How near a pose must be reached to count as reached, metres and radians.
const REACHED: f64 = 1e-6;

impl Session {
    /// The tool's pose now.
    pub(crate) fn tool_now(&self) -> Isometry3<f64> {
        tool_pose(&self.arm.chain, &self.q)
            .map_or_else(|_| Isometry3::identity(), |pose| isometry(&pose))
    }

    /// The pose whose solutions are listed.
    pub(crate) fn goal(&self) -> Isometry3<f64> {
        self.missed.unwrap_or_else(|| self.tool_now())
    }

    /// Every solution for the goal.
    pub(crate) fn solutions(&self) -> Option<Solutions> {
        self.arm.solver.solve(&matrix_pose(&self.goal())).ok()
    }

    pub(super) fn tool(&mut self, wanted: &ToolGoal) -> Result<Value, String> {
        let goal = self.read_goal(wanted)?;
        let pose = matrix_pose(&goal);
        let found = self
            .arm
            .solver
            .solve(&pose)
            .map_err(|error| error.to_string())?;
        let gesture = wanted.gesture.as_deref();
        if let Some(q) = self.nearest_solution(&found) {
            self.move_to(q, "tool pose", gesture);
            return Ok(
                json!({"reached": true, "position_error": 0.0, "angle_error": 0.0, "sentence": ""}),
            );
        }
        // Within the limits, or at all: the nearest that a search finds from here.
        let options = Options {
            limits: !self.unlocked,
            starts: 8,
            tolerance: REACHED,
        };
        let near = self
            .arm
            .search
            .find(&pose, &self.q, &options)
            .map_err(|error| error.to_string())?;
        self.move_to(near.q().to_vec(), "tool pose", gesture);
        let (position, angle) = (near.nearest.position_error, near.nearest.orientation_error);
        if near.reached {
            return Ok(
                json!({"reached": true, "position_error": position, "angle_error": angle, "sentence": ""}),
            );
        }
        self.missed = Some(goal);
        let why = match (found.status(), found.reason()) {
            (Status::Unreachable, Some(reason)) => reason.to_string(),
            (Status::Unreachable, None) => "no solution was found".to_owned(),
            _ => "every solution lies outside the joints' limits".to_owned(),
        };
        let sentence = format!(
            "{why}; the nearest pose misses it by {:.2} mm and {:.2}\u{b0}",
            1e3 * position,
            angle.to_degrees()
        );
        Ok(
            json!({"reached": false, "position_error": position, "angle_error": angle, "sentence": sentence}),
        )
    }

    /// The solution with the least travel from here, whole turns included; on a family its nearest member.
    fn nearest_solution(&self, found: &Solutions) -> Option<Vec<f64>> {
        let chain = &self.arm.chain;
        let mut candidates: Vec<Vec<f64>> = match self.unlocked {
            true => found.iter().map(|solution| solution.q().to_vec()).collect(),
            false => windings(chain, found)
                .iter()
                .map(|solution| solution.q().to_vec())
                .collect(),
        };
        for family in found.families() {
            candidates.extend(self.arm.solver.nearest_member(family, &self.q).ok());
        }
        let fits = |q: &Vec<f64>| self.unlocked || chain.limit_violations(q).is_empty();
        candidates
            .into_iter()
            .filter(fits)
            .min_by(|a, b| self.travel_to(a).total_cmp(&self.travel_to(b)))
    }

    /// How far joint values are from the present ones.
    pub(crate) fn travel_to(&self, q: &[f64]) -> f64 {
        let squares = q.iter().zip(&self.q).map(|(a, b)| (a - b) * (a - b));
        squares.sum::<f64>().sqrt()
    }

    pub(super) fn solution(&mut self, index: usize) -> Result<Value, String> {
        let found = self.solutions().ok_or("there are no solutions")?;
        let count = found.len();
        let solution = found
            .as_slice()
            .get(index)
            .ok_or_else(|| format!("index {index}: there are {count} solutions"))?;
        if !solution.within_limits && !self.unlocked {
            return Err(
                "this solution lies outside the joints' limits: unlock them to see it".to_owned(),
            );
        }
        let (q, branch) = (solution.q().to_vec(), solution.branch.to_string());
        self.move_to(q, &branch, None);
        Ok(Value::Null)
    }

    /// Members of a family, in order, beginning where the arm is.
    pub(crate) fn members(&self, found: &Solutions, index: usize) -> Vec<Vec<f64>> {
        found.families().get(index).map_or_else(Vec::new, |family| {
            let members = match self.unlocked {
                true => self.arm.solver.samples(family, MEMBERS),
                false => self.arm.solver.samples_within(family, MEMBERS),
            };
            if members.is_empty() {
                self.arm.solver.samples(family, MEMBERS)
            } else {
                members
            }
        })
    }

    /// Moves within a family: `at` from 0 to 1 along its members.
    pub(super) fn family(
        &mut self,
        index: usize,
        at: f64,
        gesture: Option<&str>,
    ) -> Result<Value, String> {
        let members = match self.on_family.take() {
            Some((known, members)) if known == index => members,
            _ => {
                let found = self.solutions().ok_or("there are no solutions")?;
                self.members(&found, index)
            }
        };
        let last = members
            .len()
            .checked_sub(1)
            .ok_or_else(|| format!("index {index}: there is no such family"))?;
        let place = (at.clamp(0.0, 1.0) * last as f64).round() as usize;
        let q = members[place].clone();
        self.move_to(q, "family", gesture);
        self.on_family = Some((index, members));
        self.touch(&[Section::Ik]);
        Ok(json!({"at": place as f64 / last.max(1) as f64}))
    }

    fn read_goal(&self, wanted: &ToolGoal) -> Result<Isometry3<f64>, String> {
        let now = self.tool_now();
        let base = wanted.frame == Frame::Base;
        if let Some(rows) = &wanted.matrix {
            let pose = spatial::pose_from_rows(rows).map_err(|error| error.to_string())?;
            let pose = isometry(&pose);
            return Ok(if base { pose } else { now * pose });
        }
        let numbers = |values: &[Quantity; 3]| values.map(|value| value.0);
        let rotation = match (&wanted.rpy, &wanted.quaternion, &wanted.axis_angle) {
            (Some(rpy), None, None) => {
                let [roll, pitch, yaw] = numbers(rpy);
                Some(UnitQuaternion::from_euler_angles(roll, pitch, yaw))
            }
            (None, Some([w, x, y, z]), None) => {
                let q = Quaternion::new(*w, *x, *y, *z);
                let q = UnitQuaternion::try_new(q, 1e-9);
                Some(q.ok_or("quaternion: one that is not zero was expected")?)
            }
            (None, None, Some(values)) => {
                let [x, y, z, angle] = values.map(|value| value.0);
                let axis = nalgebra::Unit::try_new(Vector3::new(x, y, z), 1e-9);
                Some(UnitQuaternion::from_axis_angle(
                    &axis.ok_or("axis_angle: an axis that is not zero was expected")?,
                    angle,
                ))
            }
            (None, None, None) => None,
            _ => return Err("one of rpy, quaternion and axis_angle was expected".to_owned()),
        };
        let position = wanted.position.as_ref().map(numbers);
        Ok(match base {
            true => Isometry3::from_parts(
                position.map_or(now.translation, |p| Translation3::from(Vector3::from(p))),
                rotation.unwrap_or(now.rotation),
            ),
            false => {
                now * Isometry3::from_parts(
                    Translation3::from(Vector3::from(position.unwrap_or_default())),
                    rotation.unwrap_or_else(UnitQuaternion::identity),
                )
            }
        })
    }
}

/// The same motion with its turn as a matrix.
pub(crate) fn matrix_pose(pose: &Isometry3<f64>) -> Pose {
    Pose::from_parts(pose.translation, Rotation3::from(pose.rotation))
}
