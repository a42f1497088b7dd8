//! A tree of links and joints, as a URDF describes it; chains are taken out of it.

use nalgebra::UnitVector3;

use super::chain::{Chain, ChainParts};
use super::joint::{Drive, Joint, Motion, Variable};
use super::shape::Shape;
use crate::error::{Error, Result};
use crate::spatial::Pose;

/// A link of a tree.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TreeLink {
    /// The link's name.
    pub name: String,
    /// What it looks like and what it collides with.
    pub shapes: Vec<Shape>,
}

/// A joint of a tree.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeJoint {
    /// The joint's name.
    pub name: String,
    /// Index of the parent link.
    pub parent: usize,
    /// Index of the child link.
    pub child: usize,
    /// From the parent link's frame to the child's, at displacement zero.
    pub origin: Pose,
    /// The axis in the child's frame; `None` for a fixed joint.
    pub axis: Option<UnitVector3<f64>>,
    /// What drives the joint; `None` for a fixed joint. `drive.variable` indexes [`Tree::variables`].
    pub drive: Option<Drive>,
    /// Whether the joint turns rather than slides; `false` for a fixed joint.
    pub turns: bool,
}

/// A tree of links, with one root. Immutable and valid.
///
/// Every variable is the displacement of one joint, which has its name; further joints may follow it.
#[derive(Clone, Debug, PartialEq)]
pub struct Tree {
    name: String,
    links: Vec<TreeLink>,
    joints: Vec<TreeJoint>,
    variables: Vec<Variable>,
    root: usize,
    /// For each link, the joint that carries it; `None` for the root.
    carrier: Vec<Option<usize>>,
    /// Joints, parents before children.
    order: Vec<usize>,
}

impl Tree {
    /// A tree of these parts, checked.
    ///
    /// # Errors
    /// A model error: no link, a link carried by two joints, more than one root, a loop, an index out of
    /// range, a variable that is not the displacement of the joint of its name.
    pub fn new(
        links: Vec<TreeLink>,
        joints: Vec<TreeJoint>,
        variables: Vec<Variable>,
    ) -> Result<Self> {
        for joint in &joints {
            check_joint(joint, links.len(), &variables)?;
        }
        check_variables(&joints, &variables)?;
        let mut carrier = vec![None; links.len()];
        for (index, joint) in joints.iter().enumerate() {
            if let Some(other) = carrier[joint.child].replace(index) {
                let (link, other): (_, &TreeJoint) = (&links[joint.child].name, &joints[other]);
                let text = format!("it is the child of both {} and {}", other.name, joint.name);
                return Err(Error::model(format!("link {link}"), text));
            }
        }
        let roots: Vec<usize> = (0..links.len())
            .filter(|&link| carrier[link].is_none())
            .collect();
        let root = match roots[..] {
            [root] => root,
            [] if links.is_empty() => return Err(Error::model("robot", "it has no links")),
            [] => {
                return Err(Error::model(
                    "robot",
                    "its joints form a loop: no link is the root",
                ));
            }
            _ => {
                let names: Vec<_> = roots
                    .iter()
                    .map(|&link| links[link].name.as_str())
                    .collect();
                let text = format!(
                    "one root link was expected, {} were found",
                    names.join(", ")
                );
                return Err(Error::model("robot", text));
            }
        };
        let order = parents_first(&joints, root, links.len());
        if order.len() != joints.len() {
            return Err(Error::model("robot", "some of its joints form a loop"));
        }
        Ok(Self {
            name: String::new(),
            links,
            joints,
            variables,
            root,
            carrier,
            order,
        })
    }

    /// The same tree under this name.
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = name.into();
        self
    }

    /// The robot's name; empty if it has none.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The links, in the description's order.
    pub fn links(&self) -> &[TreeLink] {
        &self.links
    }

    /// The joints, in the description's order.
    pub fn joints(&self) -> &[TreeJoint] {
        &self.joints
    }

    /// The independent variables, in the description's order.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The root link's index.
    pub fn root(&self) -> usize {
        self.root
    }

    /// The joint that carries a link, if it is not the root.
    pub fn carrier(&self, link: usize) -> Option<&TreeJoint> {
        self.carrier[link].map(|joint| &self.joints[joint])
    }

    /// A link's index.
    ///
    /// # Errors
    /// An input error with the names there are.
    pub fn link_index(&self, name: &str) -> Result<usize> {
        self.links
            .iter()
            .position(|link| link.name == name)
            .ok_or_else(|| {
                let names: Vec<_> = self.links.iter().map(|link| link.name.as_str()).collect();
                Error::input(
                    format!("link {name}"),
                    format!("the links are {}", names.join(", ")),
                )
            })
    }

    /// The indices of the joints from link `base` to link `tip`.
    fn path(&self, base: usize, tip: usize) -> Result<Vec<usize>> {
        let mut joints = Vec::new();
        let mut link = tip;
        while link != base {
            let Some(joint) = self.carrier[link] else {
                let (base, tip) = (&self.links[base].name, &self.links[tip].name);
                let text = format!("link {base} is not between the root and {tip}");
                return Err(Error::input(format!("chain from {base} to {tip}"), text));
            };
            joints.push(joint);
            link = self.joints[joint].parent;
        }
        joints.reverse();
        Ok(joints)
    }

    /// The tip that a person most likely means: at the end of the path with the most joints that move,
    /// the farthest link there; of several, the one named like a tool, else the first.
    ///
    /// Where a path forks into several that move, none by more joints than led there, a gripper begins: its fingers
    /// are no tips.
    pub fn default_tip(&self) -> usize {
        let fingers = self.fingers();
        // For each link that is no finger: moving joints on the way from the root, and all joints.
        let mut ways = vec![None; self.links.len()];
        ways[self.root] = Some((0, 0));
        for &index in &self.order {
            let joint = &self.joints[index];
            ways[joint.child] = ways[joint.parent]
                .filter(|_| !fingers[index])
                .map(|(moving, all)| (moving + usize::from(self.is_independent(index)), all + 1));
        }
        let rank = |link: usize| {
            let (moving, all) = ways[link]?;
            Some((moving, is_tool_like(&self.links[link].name), all))
        };
        // `max_by_key` takes the last of equals; reversed, that is the first in the description.
        (0..self.links.len())
            .rev()
            .max_by_key(|&link| rank(link))
            .unwrap_or(self.root)
    }

    /// For each joint, whether it is the first of a finger.
    fn fingers(&self) -> Vec<bool> {
        // Joints that move: on the longest way from a link outwards; first ones of such ways; on the way to it.
        let mut beyond = vec![0usize; self.links.len()];
        let mut branches = vec![0usize; self.links.len()];
        let mut before = vec![0usize; self.links.len()];
        for &index in self.order.iter().rev() {
            let joint = &self.joints[index];
            let (moves, further) = (joint.drive.is_some(), branches[joint.child]);
            // Fixed joints only hand on what branches behind them.
            branches[joint.parent] += if moves { 1 } else { further };
            let outward = beyond[joint.child] + usize::from(moves);
            beyond[joint.parent] = beyond[joint.parent].max(outward);
        }
        let mut fingers = vec![false; self.joints.len()];
        let mut in_gripper = vec![false; self.links.len()];
        for &index in &self.order {
            let joint = &self.joints[index];
            let (parent, child) = (joint.parent, joint.child);
            let forks = branches[parent] > 1 && beyond[parent] <= before[parent];
            in_gripper[child] = joint.drive.is_none() && (in_gripper[parent] || forks);
            fingers[index] = joint.drive.is_some() && (in_gripper[parent] || forks);
            before[child] = before[parent] + usize::from(joint.drive.is_some());
        }
        fingers
    }

    /// Whether a joint moves by a variable of its own rather than following another.
    fn is_independent(&self, joint: usize) -> bool {
        let joint = &self.joints[joint];
        joint
            .drive
            .is_some_and(|drive| self.variables[drive.variable].name == joint.name)
    }

    /// The chain from link `base` to link `tip`.
    ///
    /// A joint that mimics one outside the chain moves by that joint's variable.
    ///
    /// # Errors
    /// An input error if `base` is not between the root and `tip`; a model error if nothing moves between them.
    pub fn chain(&self, base: usize, tip: usize) -> Result<Chain> {
        let path = self.path(base, tip)?;
        let mut used: Vec<usize> = Vec::new();
        // For each of the tree's variables, its place among the chain's.
        let mut places = vec![None; self.variables.len()];
        let mut joints = Vec::with_capacity(path.len());
        for &index in &path {
            let joint = &self.joints[index];
            let drive = joint.drive.map(|drive| {
                let variable = *places[drive.variable].get_or_insert_with(|| {
                    used.push(drive.variable);
                    used.len() - 1
                });
                Drive { variable, ..drive }
            });
            joints.push(self.chain_joint(joint, drive));
        }
        let variables = used
            .iter()
            .map(|&variable| self.variables[variable].clone())
            .collect();
        if used.is_empty() {
            let (from, to) = (&self.links[base].name, &self.links[tip].name);
            return Err(Error::model(
                format!("chain from {from} to {to}"),
                "no joint of it moves",
            ));
        }
        Chain::new(ChainParts {
            variables,
            joints,
            base: Pose::identity(),
            tool: Pose::identity(),
        })
    }

    fn chain_joint(&self, joint: &TreeJoint, drive: Option<Drive>) -> Joint {
        let motion = match (joint.axis, drive) {
            (Some(axis), Some(drive)) if joint.turns => Motion::Turn(axis, drive),
            (Some(axis), Some(drive)) => Motion::Slide(axis, drive),
            _ => Motion::Fixed,
        };
        Joint {
            name: joint.name.clone(),
            link: self.links[joint.child].name.clone(),
            before: joint.origin,
            motion,
            after: Pose::identity(),
        }
    }

    /// The pose of every link in the root's frame, in the order of [`Tree::links`].
    ///
    /// # Errors
    /// An input error unless `q` has one finite value for each of [`Tree::variables`].
    pub fn link_poses(&self, q: &[f64]) -> Result<Vec<Pose>> {
        if q.len() != self.variables.len() || q.iter().any(|value| !value.is_finite()) {
            let text = format!(
                "{} finite values were expected, {} were given",
                self.variables.len(),
                q.len()
            );
            return Err(Error::input("joint values", text));
        }
        let mut poses = vec![Pose::identity(); self.links.len()];
        for &index in &self.order {
            let joint = &self.joints[index];
            poses[joint.child] = poses[joint.parent] * self.chain_joint(joint, joint.drive).pose(q);
        }
        Ok(poses)
    }
}

/// Whether a link's name says that it is where the tool is.
fn is_tool_like(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    let mut words = name.split(|c: char| !c.is_ascii_alphanumeric());
    ["tool", "tcp", "flange", "end_effector"]
        .iter()
        .any(|word| name.contains(word))
        || words.any(|word| word == "ee")
}

fn parents_first(joints: &[TreeJoint], root: usize, links: usize) -> Vec<usize> {
    let mut children = vec![Vec::new(); links];
    for (index, joint) in joints.iter().enumerate() {
        children[joint.parent].push(index);
    }
    let mut order = Vec::with_capacity(joints.len());
    let mut open = vec![root];
    while let Some(link) = open.pop() {
        order.extend(&children[link]);
        open.extend(children[link].iter().map(|&joint| joints[joint].child));
    }
    order
}

fn check_joint(joint: &TreeJoint, links: usize, variables: &[Variable]) -> Result<()> {
    let error = |text: &str| Err(Error::model(format!("joint {}", joint.name), text));
    if joint.parent >= links || joint.child >= links {
        return error("its parent or child is none of the links");
    }
    match (joint.axis, joint.drive) {
        (None, None) => Ok(()),
        (Some(_), Some(drive)) if drive.variable >= variables.len() => {
            error("its variable is none of the tree's")
        }
        (Some(_), Some(drive)) if drive.factor.is_finite() && drive.offset.is_finite() => Ok(()),
        (Some(_), Some(_)) => error("its factor and offset must be finite"),
        _ => error("an axis and a drive belong together"),
    }
}

fn check_variables(joints: &[TreeJoint], variables: &[Variable]) -> Result<()> {
    let mut owned = vec![false; variables.len()];
    for joint in joints {
        let Some(drive) = joint.drive else { continue };
        let variable = &variables[drive.variable];
        owned[drive.variable] |= variable.name == joint.name
            && (drive.factor, drive.offset) == (1.0, 0.0)
            && variable.kind.is_angular() == joint.turns;
    }
    match owned.iter().position(|owned| !owned) {
        None => Ok(()),
        Some(index) => {
            let name = &variables[index].name;
            let text = "it is not the displacement of a joint of its name";
            Err(Error::model(format!("variable {name}"), text))
        }
    }
}
