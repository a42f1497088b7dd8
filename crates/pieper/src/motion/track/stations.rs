//! Joint values for poses between which the joints go straight.

use super::space::{Space, add};
use super::{TrackOptions, windings};
use crate::error::{Error, Result};
use crate::ik::{Family, JointVector, Solutions, Solver};
use crate::spatial::Pose;

/// Members of sets are moved between their neighbours at most this often.
const MOST_SWEEPS: usize = 64;

/// Members that move by less than this have settled.
const SETTLED: f64 = 1e-12;

/// What [`stations`] finds.
#[derive(Clone, Debug, PartialEq)]
pub enum Stations {
    /// Joint values for every pose, radians and metres, within the limits. Angles go on without wrapping.
    Rows(Vec<Vec<f64>>),
    /// A pose that the arm does not reach within its limits: its index, and why.
    Unreachable {
        /// Counted from 0.
        index: usize,
        /// In words.
        reason: String,
    },
}

/// Joint values for poses, one after the other, with the least travel of the joints in between.
///
/// Between the poses the joints are meant to go straight, as a [`Law`](crate::motion::Law) does; the tool's way is then
/// what it is. Use [`track`](super::track) where the tool must follow a path. All solutions of all poses, whole turns
/// included, are weighed against each other. Where a pose has infinitely many (a straight wrist), the member
/// between those of its neighbours is taken. With a wish for the start, the first pose's solution nearest to it.
///
/// # Errors
/// An input error for no poses, for more than `options.budget`, and for a wish of the wrong length.
///
/// ```
/// use pieper::describe::Robot;
/// use pieper::ik::Solver;
/// use pieper::kinematics::tool_pose;
/// use pieper::motion::{Stations, TrackOptions, stations};
/// let text = "name = 'elbow'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5\n[[joint]]\ntheta = 'q2'\na = 0.4";
/// let chain = Robot::from_toml("elbow.toml", text)?.chain()?;
/// let poses = [[0.1, 0.7], [0.4, 0.9]].map(|q| tool_pose(&chain, &q)).into_iter().collect::<Result<Vec<_>, _>>()?;
/// let options = TrackOptions { start: Some(vec![0.0, 1.0]), ..TrackOptions::default() };
/// let Stations::Rows(rows) = stations(&Solver::new(&chain)?, &poses, &options)? else { panic!("both are reached") };
/// assert!((rows[1][1] - 0.9).abs() < 1e-9);
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn stations(solver: &Solver, poses: &[Pose], options: &TrackOptions) -> Result<Stations> {
    let chain = solver.chain();
    if poses.is_empty() || poses.len() > options.budget {
        let text = format!("1 to {} poses were expected", options.budget);
        return Err(Error::input(format!("{} poses", poses.len()), text));
    }
    let space = Space::new(chain);
    let start = match &options.start {
        Some(start) => {
            chain.check_joint_values(start)?;
            space.vector(start)
        }
        None => space.vector(&vec![0.0; space.dof()]),
    };
    let route = Route { solver, space };
    let mut solutions = Solutions::default();
    let mut layers: Vec<Vec<Choice>> = Vec::with_capacity(poses.len());
    for (index, pose) in poses.iter().enumerate() {
        solver.solve_into(pose, &mut solutions)?;
        let layer = match layers.last() {
            Some(before) => route.onward(&solutions, before)?,
            None => route.first(&solutions, &start, options.start.is_some())?,
        };
        if layer.is_empty() {
            let reason = route.reason(&solutions);
            return Ok(Stations::Unreachable { index, reason });
        }
        layers.push(layer);
    }
    let mut way = cheapest(&layers);
    route.settle(&mut way, options.start.is_some())?;
    let dof = route.space.dof();
    let rows = way.iter().map(|choice| choice.q[..dof].to_vec());
    Ok(Stations::Rows(rows.collect()))
}

/// One way to stand at a pose.
#[derive(Clone, Copy, Debug)]
struct Choice {
    q: JointVector,
    /// The set that it is a member of.
    set: Option<Family>,
    /// The travel up to here, by the cheapest way.
    travel: f64,
    /// The choice before on that way.
    from: usize,
}

struct Route<'a> {
    solver: &'a Solver,
    space: Space<'a>,
}

impl Route<'_> {
    /// The choices for the first pose: those beside `start`; only the nearest if somebody asked for it.
    fn first(
        &self,
        solutions: &Solutions,
        start: &JointVector,
        is_asked_for: bool,
    ) -> Result<Vec<Choice>> {
        let mut layer = self.beside(solutions, start)?;
        let far = |choice: &Choice| self.travel(start, &choice.q);
        if is_asked_for {
            let nearest = layer.iter().min_by(|a, b| far(a).total_cmp(&far(b)));
            layer = nearest.copied().into_iter().collect();
        }
        Ok(layer)
    }

    /// The choices for a pose after the choices `before`, each with its cheapest way.
    fn onward(&self, solutions: &Solutions, before: &[Choice]) -> Result<Vec<Choice>> {
        let mut layer: Vec<Choice> = Vec::new();
        for (from, last) in before.iter().enumerate() {
            for (slot, choice) in self.beside(solutions, &last.q)?.into_iter().enumerate() {
                let travel = last.travel + self.travel(&last.q, &choice.q);
                let arrived = Choice {
                    travel,
                    from,
                    ..choice
                };
                match layer.get_mut(slot) {
                    Some(kept) if kept.travel <= travel => (),
                    Some(kept) => *kept = arrived,
                    None => layer.push(arrived),
                }
            }
        }
        Ok(layer)
    }

    /// Every solution, and of every set the member closest to `near`, by whole turns within the limits and next to it.
    /// The order and the number do not depend on `near`, but for members of sets that leave the limits.
    fn beside(&self, solutions: &Solutions, near: &JointVector) -> Result<Vec<Choice>> {
        let mut out = Vec::new();
        let mut add = |q: &[f64], set: Option<Family>| {
            if let Some(q) = windings::beside(&self.space, &self.space.vector(q), near) {
                out.push(Choice {
                    q,
                    set,
                    travel: 0.0,
                    from: 0,
                });
            }
        };
        solutions.iter().for_each(|one| add(one.q(), None));
        for set in solutions.families() {
            add(&self.member(set, near)?, Some(*set));
        }
        Ok(out)
    }

    /// The member of a set closest to `near`; where that is outside the limits, one inside.
    fn member(&self, set: &Family, near: &JointVector) -> Result<Vec<f64>> {
        let q = self.solver.nearest_member(set, &near[..self.space.dof()])?;
        if windings::beside(&self.space, &self.space.vector(&q), near).is_some() {
            return Ok(q);
        }
        let inside = self.solver.within_limits(set);
        Ok(inside.map_or(q, |family| family.q().to_vec()))
    }

    /// The sum of all joints' travel: radians, and metres by the arm's extent.
    fn travel(&self, from: &JointVector, to: &JointVector) -> f64 {
        let unit = |j: usize| match self.space.angular[j] {
            true => 1.0,
            false => self.space.extent,
        };
        (0..self.space.dof())
            .map(|j| (to[j] - from[j]).abs() / unit(j))
            .sum()
    }

    /// Moves members of sets between their neighbours, until none moves any more.
    fn settle(&self, way: &mut [Choice], is_start_fixed: bool) -> Result<()> {
        let last = way.len() - 1;
        for _ in 0..MOST_SWEEPS {
            let mut moved: f64 = 0.0;
            for index in usize::from(is_start_fixed)..way.len() {
                let Some(set) = way[index].set else { continue };
                let seed = match index {
                    0 if last == 0 => continue,
                    0 => way[1].q,
                    _ if index == last => way[last - 1].q,
                    _ => {
                        let (before, after) = (&way[index - 1].q, &way[index + 1].q);
                        add(before, &add(after, before, -1.0), 0.5)
                    }
                };
                let member = self.space.vector(&self.member(&set, &seed)?);
                let Some(q) = windings::beside(&self.space, &member, &seed) else {
                    continue;
                };
                moved = moved.max(self.travel(&way[index].q, &q));
                way[index].q = q;
            }
            if moved < SETTLED {
                break;
            }
        }
        Ok(())
    }

    /// Why there is no choice for a pose.
    fn reason(&self, solutions: &Solutions) -> String {
        if let Some(reason) = solutions.reason() {
            return reason.to_string();
        }
        let first = solutions.iter().next().map(|solution| solution.q());
        let first = first.or_else(|| solutions.families().first().map(Family::q));
        let names = self.space.chain.variables();
        match first.and_then(|q| windings::outside(&self.space, &self.space.vector(q))) {
            Some((j, value, limit)) => format!(
                "every solution is outside the joints' limits; the first has {} = {value:.4}, beyond {limit:.4}",
                names[j].name
            ),
            None => "no solution was found".to_owned(),
        }
    }
}

/// The way with the least travel, from the first layer to the last.
fn cheapest(layers: &[Vec<Choice>]) -> Vec<Choice> {
    let last = &layers[layers.len() - 1];
    let ends = 0..last.len();
    let mut at = ends
        .min_by(|&a, &b| last[a].travel.total_cmp(&last[b].travel))
        .unwrap_or_default();
    let mut way = Vec::with_capacity(layers.len());
    for layer in layers.iter().rev() {
        way.push(layer[at]);
        at = layer[at].from;
    }
    way.reverse();
    way
}
