//! In which order the joints follow from the motors.

use nalgebra::DMatrix;

use super::motor::Motor;
use crate::error::{Error, Result};

/// Motors that give the values of as many joints, once the blocks before it are known.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) motors: Vec<usize>,
    pub(super) joints: Vec<usize>,
    /// d joint / d motor within the block; constant, as only a block of one holds a rocker.
    pub(super) inverse: DMatrix<f64>,
}

/// The blocks, each using only those before it.
///
/// # Errors
/// A model error that names the motors: if they do not determine their joints, or if a four-bar's rocker could only be
/// found together with other joints.
pub(super) fn blocks(motors: &[Motor]) -> Result<Vec<Block>> {
    let mut open_motors: Vec<usize> = (0..motors.len()).collect();
    let mut open_joints = open_motors.clone();
    let mut found = Vec::new();
    while !open_motors.is_empty() {
        let (block, joints) = next(motors, &open_motors, &open_joints);
        found.push(block_of(motors, &block, &joints)?);
        open_motors.retain(|motor| !block.contains(motor));
        open_joints.retain(|joint| !joints.contains(joint));
    }
    Ok(found)
}

/// The smallest set of motors whose open joints are as many as they are themselves; all that is left if there is none.
fn next(
    motors: &[Motor],
    open_motors: &[usize],
    open_joints: &[usize],
) -> (Vec<usize>, Vec<usize>) {
    let joints_of = |motor: usize| -> Vec<usize> {
        let is_open = |joint: &usize| open_joints.contains(joint);
        motors[motor].variables().filter(is_open).collect()
    };
    let mut best: Option<(Vec<usize>, Vec<usize>)> = None;
    for &first in open_motors {
        let joints = joints_of(first);
        let within = |motor: &usize| joints_of(*motor).iter().all(|joint| joints.contains(joint));
        let set: Vec<usize> = open_motors.iter().copied().filter(within).collect();
        let is_smaller = best.as_ref().is_none_or(|(best, _)| set.len() < best.len());
        if set.len() == joints.len() && is_smaller {
            best = Some((set, joints));
        }
    }
    best.unwrap_or_else(|| (open_motors.to_vec(), open_joints.to_vec()))
}

fn block_of(all: &[Motor], motors: &[usize], joints: &[usize]) -> Result<Block> {
    let names: Vec<&str> = motors.iter().map(|&motor| all[motor].name()).collect();
    let subject = || format!("motors {}", names.join(", "));
    let is_rocker = |joint: &usize| motors.iter().any(|&motor| all[motor].is_rocker(*joint));
    if let ([_], [joint]) = (motors, joints)
        && is_rocker(joint)
    {
        return Ok(Block {
            motors: motors.to_vec(),
            joints: joints.to_vec(),
            inverse: DMatrix::zeros(1, 1),
        });
    }
    if let Some(joint) = joints.iter().find(|joint| is_rocker(joint)) {
        let text = format!(
            "joint {} of the four-bar could only be found together with others; its frame's joint must be driven by \
             another motor",
            joint + 1
        );
        return Err(Error::model(subject(), text));
    }
    if joints.len() > super::MAX_BLOCK {
        let text = format!(
            "more than {} joints could only be found together",
            super::MAX_BLOCK
        );
        return Err(Error::model(subject(), text));
    }
    let forward = DMatrix::from_fn(motors.len(), joints.len(), |row, column| {
        all[motors[row]].ratio() * all[motors[row]].factor(joints[column])
    });
    let numbers: Vec<String> = joints.iter().map(|joint| (joint + 1).to_string()).collect();
    let undetermined = || {
        let text = format!("they do not determine the joints {}", numbers.join(", "));
        Error::model(subject(), text)
    };
    let scale = forward.amax().max(f64::MIN_POSITIVE);
    let inverse = forward.clone().try_inverse().ok_or_else(undetermined)?;
    if !inverse.iter().all(|x| x.is_finite()) || inverse.amax() * scale > WORST {
        return Err(undetermined());
    }
    Ok(Block {
        motors: motors.to_vec(),
        joints: joints.to_vec(),
        inverse,
    })
}

/// The largest product of a coupling's and its inverse's entries: beyond it, rows are equal but for roundings. Rows
/// of gears and of spindles (radians for a metre) differ by less than a million.
const WORST: f64 = 1e12;
