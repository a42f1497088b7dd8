//! Arms of more joints than a pose needs: the motion of least change from each start.

use super::TrackOptions;
use super::compose::{Ending, Knot, Motion};
use super::sample::{Node, Sample, Sampler};
use super::space::{add, minus};
use super::standing::Home;
use crate::error::{Error, Result};
use crate::ik::{Branch, JointVector};

/// Steps are halved down to this part of the path's duration.
const SHORTEST: f64 = 1e-9;

/// Joints (rad, or extents) may change by this much in a step.
const STRIDE: f64 = 0.2;

/// Steps are as short as keeps the joints' straight motion within this part of the tolerance.
const FINE: f64 = 0.05;

pub(super) fn motions(
    sampler: &mut Sampler<'_>,
    home: &Home,
    options: &TrackOptions,
    progress: &mut dyn FnMut(f64),
) -> Result<Vec<Motion>> {
    let sample = sampler.at(sampler.law.times()[0])?;
    let mut motions = Vec::new();
    let starts = starts(sampler, &sample, home)?;
    let count = starts.len();
    for (index, (q, branch)) in starts.into_iter().enumerate() {
        let mut tell = |share: f64| progress((index as f64 + share) / count as f64);
        motions.push(follow(sampler, q, branch, options, &mut tell)?);
    }
    progress(1.0);
    Ok(motions)
}

/// The solutions listed for the start, or the one nearest to what was asked for.
fn starts(
    sampler: &Sampler<'_>,
    sample: &Sample,
    home: &Home,
) -> Result<Vec<(JointVector, Branch)>> {
    let mut starts = Vec::new();
    for node in &sample.nodes {
        let q = match home.is_asked_for {
            true => sampler.member(sample, node, &home.q)?.unwrap_or(node.q),
            false => deepest(sampler, node)?,
        };
        starts.push((q, node.branch));
    }
    if home.is_asked_for {
        let distance = |q: &JointVector| sampler.space.size(&sampler.space.way(&home.q, q));
        starts.sort_by(|a, b| distance(&a.0).total_cmp(&distance(&b.0)));
        starts.truncate(1);
    }
    Ok(starts)
}

/// The member of a family that lies deepest within the limits, of so many.
const MEMBERS: usize = 48;

fn deepest(sampler: &Sampler<'_>, node: &Node) -> Result<JointVector> {
    let space = sampler.space;
    let margin = |q: &JointVector| {
        let joints = space.chain.variables().iter().zip(q);
        let margins = joints.filter_map(|(variable, &value)| {
            let limits = variable.limits?;
            let range = (limits.upper() - limits.lower()).max(f64::MIN_POSITIVE);
            Some((value - limits.lower()).min(limits.upper() - value) / range)
        });
        margins.fold(f64::INFINITY, f64::min)
    };
    let Some(family) = node.set.as_ref().and_then(|set| set.family.as_ref()) else {
        return Ok(node.q);
    };
    let members = sampler.solver.samples(family, MEMBERS);
    let members = members.iter().map(|q| space.vector(q));
    let best = members.max_by(|a, b| margin(a).total_cmp(&margin(b)));
    Ok(best.unwrap_or(node.q))
}

/// Follows the path from a start by the least change of joints, as far as that goes.
fn follow(
    sampler: &mut Sampler<'_>,
    start: JointVector,
    branch: Branch,
    options: &TrackOptions,
    progress: &mut dyn FnMut(f64),
) -> Result<Motion> {
    let rows = sampler.law.times();
    let (first, last) = (rows[0], rows[rows.len() - 1]);
    let shortest = SHORTEST * (last - first);
    let mut knots = vec![Knot {
        time: first,
        q: start,
    }];
    let mut stride = 0.01 * (last - first);
    let mut row = 1;
    while row < rows.len() {
        let here = knots[knots.len() - 1];
        let time = (here.time + stride).min(rows[row]);
        sampler.solves += 1;
        if sampler.solves > options.budget {
            return Err(Error::input(
                format!("the path at t = {} s", here.time),
                format!(
                    "its refinement stopped here after {} poses: a larger tolerance, fewer rows or a shorter path was expected",
                    options.budget
                ),
            ));
        }
        match step(sampler, &knots, time, FINE * options.tolerance)? {
            Some(q) => {
                knots.push(Knot { time, q });
                if time == rows[row] {
                    row += 1;
                    progress((time - first) / (last - first));
                }
                stride = 2.0 * (time - here.time).max(0.5 * stride);
            }
            None if time - here.time > shortest => stride = 0.5 * (time - here.time),
            None => {
                return Ok(Motion {
                    branch,
                    knots,
                    end: Ending::Lost,
                });
            }
        }
    }
    Ok(Motion {
        branch,
        knots,
        end: Ending::Alive,
    })
}

/// The joint values at a time, from those before; `None` if the step is too long.
fn step(
    sampler: &Sampler<'_>,
    knots: &[Knot],
    time: f64,
    tolerance: f64,
) -> Result<Option<JointVector>> {
    let space = sampler.space;
    let here = knots[knots.len() - 1];
    let Some(q) = space.refine(&here.q, &sampler.law.at(time))? else {
        return Ok(None);
    };
    let way = minus(&q, &here.q);
    if space.size(&way) > STRIDE {
        return Ok(None);
    }
    for share in [0.25, 0.5, 0.75] {
        let pose = sampler.law.at(here.time + share * (time - here.time));
        if !space
            .miss(&add(&here.q, &way, share), &pose)?
            .within(tolerance)
        {
            return Ok(None);
        }
    }
    Ok(Some(q))
}
