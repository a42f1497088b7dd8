//! The solver of one arm.

use super::arm::Arm;
use super::classify::{self, Structure};
use super::goal::{Goal, Question};
use super::nearest::{self, Ladder};
use super::reason::{Part, Shortfall};
use super::registry::{self, Choice};
use super::sink::{Marks, Sink, Terms};
use super::solutions::{Branch, JointVector, Nearest, Solutions, Status};
use super::swivel;
use super::view::View;
use super::wrist::Method;
use crate::error::{Error, Result};
use crate::model::Chain;
use crate::spatial::Pose;

/// Inverse kinematics of one chain, prepared once: a few microseconds to classify it, a few milliseconds if no closed form
/// takes it.
#[derive(Clone, Debug)]
pub struct Solver {
    /// The arm at work: the chain without joints that are held, with others that make up for what a goal leaves open.
    pub(super) arm: Arm,
    pub(super) view: View,
    structure: Structure,
    choice: Choice,
    method: Method,
    swivel: Option<f64>,
    ladder: Option<Box<Ladder>>,
}

impl Solver {
    /// Prepares a chain for whole poses.
    ///
    /// # Errors
    /// A model error for a chain of more than [`MAX_JOINTS`](super::MAX_JOINTS) joints.
    pub fn new(chain: &Chain) -> Result<Self> {
        Self::prepare(chain, &Question::default())
    }

    /// Prepares a chain for a part of a pose, or with joints held.
    ///
    /// ```
    /// use pieper::ik::{Goal, Question, Solver, Status};
    /// use pieper::{describe::Robot, kinematics};
    /// let text = "name = 'elbow'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5\n[[joint]]\ntheta = 'q2'\na = 0.4";
    /// let chain = Robot::from_toml("elbow.toml", text)?.chain()?;
    /// let question = Question { goal: Goal::Position, ..Question::default() };
    /// let pose = kinematics::tool_pose(&chain, &[0.3, 0.7])?;
    /// let found = Solver::prepare(&chain, &question)?.solve(&pose)?;
    /// assert_eq!((found.status(), found.len()), (Status::Solved, 2)); // elbow up, elbow down
    /// # Ok::<(), pieper::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Solver::new`]; an input error for a held joint that the chain does not have, that is held twice or at no finite
    /// value; a model error if no joint is left.
    pub fn prepare(chain: &Chain, question: &Question) -> Result<Self> {
        let (view, free, work) = View::new(chain, question)?;
        let arm = Arm::new(&work)?;
        let structure = classify::of(&arm);
        let choice = registry::choose(&arm, &structure)
            .ok_or_else(|| Error::model("chain", "no solver takes it"))?;
        if let Some(angle) = question.swivel {
            check_swivel(angle, question, &choice)?;
        }
        let needs = matches!(question.goal, Goal::Pose | Goal::PositionAxis);
        let ladder = match needs && arm.chain().dof() < 6 {
            true => Some(Box::new(Ladder::new(&free, question.goal)?)),
            false => None,
        };
        Ok(Self {
            arm,
            view,
            structure,
            choice,
            method: question.method,
            swivel: question.swivel,
            ladder,
        })
    }

    /// The chain.
    pub fn chain(&self) -> &Chain {
        &self.view.chain
    }

    /// The part of a pose that it solves for.
    pub fn goal(&self) -> Goal {
        self.view.goal
    }

    /// How the axes lie: of the chain without joints that are held, with those that make up for what a goal leaves open.
    pub fn structure(&self) -> &Structure {
        &self.structure
    }

    /// The solver at work.
    pub fn choice(&self) -> &Choice {
        &self.choice
    }

    /// Every solution for a pose of the tool, `base_from_tool` as [`tool_pose`](crate::kinematics::tool_pose) gives
    /// it.
    ///
    /// # Errors
    /// An input error if the pose has an entry that is not finite or if its rotation part is none.
    pub fn solve(&self, pose: &Pose) -> Result<Solutions> {
        let mut out = Solutions::default();
        self.solve_into(pose, &mut out)?;
        Ok(out)
    }

    /// [`Solver::solve`] into an answer used again: nothing is allocated.
    ///
    /// # Errors
    /// As [`Solver::solve`].
    pub fn solve_into(&self, pose: &Pose, out: &mut Solutions) -> Result<()> {
        check(pose)?;
        let target = self.arm.target(pose);
        let mut sink = self.sink(pose, out);
        self.choice.solver.solve(&target, &mut sink);
        sink.finish();
        if out.status == Status::Unreachable
            && self.swivel.is_none()
            && out.reason.is_none_or(|reason| reason.is_unmeasured())
        {
            self.measure(pose, out);
        }
        self.view.present(&self.arm, pose, out);
        Ok(())
    }

    /// The swivel angle of the elbow at given joint values, radians in (-pi, pi]: 0 where the elbow's axis is at a right
    /// angle to axis 1, growing as the elbow turns about the line from shoulder to wrist, as seen along it. `None` for an
    /// arm that is not of seven joints with spherical shoulder and wrist, and where axis 1 lies on that line or the arm is
    /// folded, so that there is no such angle.
    ///
    /// ```
    /// use pieper::ik::{Question, Solver};
    /// use pieper::kinematics::tool_pose;
    /// let chain = pieper_robots::find("iiwa14").unwrap().robot().chain()?;
    /// let q = [0.3, 0.5, 0.2, -1.2, 0.4, 0.9, -0.1];
    /// let swivel = Solver::new(&chain)?.swivel(&q)?;
    /// let question = Question { swivel, ..Question::default() };
    /// let found = Solver::prepare(&chain, &question)?.solve(&tool_pose(&chain, &q)?)?;
    /// let near = |other: &[f64]| q.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-9);
    /// assert!(found.iter().any(|solution| near(solution.q())));
    /// # Ok::<(), pieper::Error>(())
    /// ```
    ///
    /// # Errors
    /// An input error unless `q` has one finite value for each variable.
    pub fn swivel(&self, q: &[f64]) -> Result<Option<f64>> {
        self.chain().check_joint_values(q)?;
        Ok(self.choice.solver.swivel(&self.arm, &self.view.inward(q)))
    }

    fn sink<'a>(&'a self, pose: &'a Pose, out: &'a mut Solutions) -> Sink<'a> {
        let terms = Terms {
            slack: self.choice.slack,
            method: self.method,
            swivel: self.swivel,
        };
        Sink::new(&self.arm, pose, terms, out)
    }

    /// Measures a failure for which the row had no number, by search. Should the search reach the pose after all, it
    /// is a solution.
    #[cold]
    fn measure(&self, pose: &Pose, out: &mut Solutions) {
        let part = out.reason.map_or(Part::NoneCloses, |reason| reason.part);
        let (reason, q) = self.closest(pose, part);
        let mut sink = self.sink(pose, out);
        sink.push_joints(q, Branch::default(), Marks::PLAIN);
        sink.finish();
        if out.status == Status::Unreachable {
            out.reason = Some(reason);
            out.nearest = Some(self.view.nearest(&q, pose));
        }
    }

    /// Joint values of the arm at work that come closest, and what they miss, said of `part` unless another is known.
    fn closest(&self, pose: &Pose, part: Part) -> (Shortfall, JointVector) {
        if let Some(ladder) = &self.ladder {
            let (reason, mut q) = ladder.find(pose);
            q[self.arm.chain().dof()..].fill(0.0);
            return (reason, q);
        }
        let q = nearest::find(&self.arm, pose);
        let miss = self.view.nearest(&q, pose);
        let part = match self.view.goal {
            Goal::Position => Part::Point,
            Goal::Axis => Part::Direction,
            _ => part,
        };
        let amount = match part.is_angular() {
            true => miss.orientation_error,
            false => miss.position_error,
        };
        (Shortfall::new(part, amount), q)
    }

    /// The closest the arm comes to a pose that it cannot reach: a local search from many starts. Errors of what is not
    /// asked for count as 0.
    ///
    /// With six joints or more, position errors in the arm's extent and orientation errors in radians count alike. With
    /// fewer, the tool's point comes first.
    ///
    /// # Errors
    /// As [`Solver::solve`].
    pub fn nearest(&self, pose: &Pose) -> Result<Nearest> {
        check(pose)?;
        let (_, q) = self.closest(pose, Part::NoneCloses);
        Ok(self.view.nearest(&q, pose))
    }
}

/// How far from orthonormal a pose may be: what callers pass was projected or computed.
const ORTHONORMAL: f64 = 1e-6;

pub(super) fn check(pose: &Pose) -> Result<()> {
    let (m, t) = (pose.rotation.matrix(), &pose.translation.vector);
    // A NaN makes the sum a NaN, and every comparison with it false.
    let sum: f64 = m.iter().chain(t.iter()).map(|x| x.abs()).sum();
    if !sum.is_finite() {
        return Err(Error::input(
            "pose",
            "it has an entry that is not a finite number",
        ));
    }
    let column = |j: usize| m.column(j);
    let off = [
        column(0).norm_squared() - 1.0,
        column(1).norm_squared() - 1.0,
        column(0).dot(&column(1)),
        (column(0).cross(&column(1)) - column(2)).amax(),
    ];
    let off = off.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if off > ORTHONORMAL {
        let text = format!("it is no rotation: off by {off:.3e}, at most 1e-6 was expected");
        return Err(Error::input("rotation part of the pose", text));
    }
    Ok(())
}

/// A swivel angle that is one, of an arm that has one.
fn check_swivel(angle: f64, question: &Question, choice: &Choice) -> Result<()> {
    if !angle.is_finite() {
        return Err(Error::input(
            "swivel",
            format!("{angle}: an angle was expected"),
        ));
    }
    if choice.name != swivel::NAME || question.goal != Goal::Pose || !question.held.is_empty() {
        let text = format!(
            "it belongs to the whole pose of an arm of seven free joints with a spherical shoulder and wrist; this is solved by the row {}",
            choice.name
        );
        return Err(Error::input("swivel", text));
    }
    Ok(())
}
