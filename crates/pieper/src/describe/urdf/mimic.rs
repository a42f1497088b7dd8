//! Mimic joints: each follows another, perhaps through several, until one that moves by itself.

use std::collections::HashMap;

use super::joint::{Mimic, RawJoint};
use crate::error::Result;
use crate::model::{Drive, Variable};

/// The independent variables in the order written, and for each joint what drives it.
pub(super) fn resolve(
    joints: &[RawJoint<'_>],
    index_of: &HashMap<&str, usize>,
) -> Result<(Vec<Variable>, Vec<Option<Drive>>)> {
    let mut variables = Vec::new();
    let mut drives = vec![None; joints.len()];
    for (joint, drive) in joints.iter().zip(&mut drives) {
        let independent = joint.moving.as_ref().filter(|m| m.mimic.is_none());
        if let Some(moving) = independent {
            *drive = Some(Drive {
                variable: variables.len(),
                factor: 1.0,
                offset: 0.0,
            });
            variables.push(moving.variable.clone());
        }
    }
    for index in 0..joints.len() {
        follow(index, joints, index_of, &mut drives)?;
    }
    Ok((variables, drives))
}

/// Sets the drive of joint `index` and of all joints between it and the independent one.
fn follow(
    index: usize,
    joints: &[RawJoint<'_>],
    index_of: &HashMap<&str, usize>,
    drives: &mut [Option<Drive>],
) -> Result<()> {
    let mut way: Vec<(usize, &Mimic<'_>)> = Vec::new();
    let mut current = index;
    while drives[current].is_none() {
        let Some(mimic) = joints[current]
            .moving
            .as_ref()
            .and_then(|m| m.mimic.as_ref())
        else {
            break;
        };
        // Longer than the number of joints, so some joint is on the way twice.
        if way.len() > joints.len() {
            return Err(cycle(current, joints, index_of));
        }
        way.push((current, mimic));
        let leader = index_of.get(mimic.joint.value.as_str()).copied();
        current = leader.ok_or_else(|| mimic.joint.error("there is no joint of this name"))?;
        if joints[current].moving.is_none() {
            let text = "the joint of this name is fixed: there is no motion to follow";
            return Err(mimic.joint.error(text));
        }
    }
    while let (Some((follower, mimic)), Some(leader)) = (way.pop(), drives[current]) {
        let drive = Drive {
            variable: leader.variable,
            factor: mimic.multiplier * leader.factor,
            offset: mimic.multiplier.mul_add(leader.offset, mimic.offset),
        };
        if !(drive.factor.is_finite() && drive.offset.is_finite()) {
            return Err(mimic.joint.error("multiplier and offset become too large"));
        }
        drives[follower] = Some(drive);
        current = follower;
    }
    Ok(())
}

/// The cycle that joint `start` is part of.
#[cold]
fn cycle(
    start: usize,
    joints: &[RawJoint<'_>],
    index_of: &HashMap<&str, usize>,
) -> crate::error::Error {
    let leader = |index: usize| {
        let mimic = joints[index].moving.as_ref()?.mimic.as_ref()?;
        index_of.get(mimic.joint.value.as_str()).copied()
    };
    let mut names = vec![joints[start].name];
    let mut current = leader(start);
    while let Some(index) = current {
        names.push(joints[index].name);
        current = leader(index).filter(|_| index != start);
    }
    let text = format!(
        "joints follow each other in a circle: {}",
        names.join(" -> ")
    );
    joints[start].element.error(text)
}
