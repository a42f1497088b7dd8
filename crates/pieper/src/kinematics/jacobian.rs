//! The geometric Jacobian.

use nalgebra::{Matrix6xX, Vector3};

use super::kernel::Frame;
use super::single::{self, Record, SpaceColumn};
use crate::error::Result;
use crate::model::{Canonical, Chain, Step};
use crate::spatial::Pose;

/// A Jacobian: six rows (linear velocity x, y, z of the tool point in m/s, then angular velocity x, y, z in rad/s),
/// one column for each variable.
pub type Jacobian = Matrix6xX<f64>;

/// The axes in which a velocity is written. The velocity itself is the tool point's, either way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// The base's axes.
    Base,
    /// The tool's axes.
    Tool,
}

/// The tool's pose at `q` and the geometric Jacobian there: `(v, omega) = J qdot`.
///
/// Column of a joint that turns about axis z through point o: `(z x (p - o), z)`; of one that slides: `(z, 0)`
/// (Whitney 1972); times the factor with which the variable enters, signs included. Joints that share a variable
/// (mimic) add up. `jacobian` is resized if it has another number of columns, and not allocated otherwise.
///
/// # Errors
/// An input error unless `q` has one finite value for each variable.
///
/// ```
/// use pieper::kinematics::{Jacobian, Reference, pose_and_jacobian};
/// use pieper::describe::Robot;
/// let text = "name = 'r'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5";
/// let chain = Robot::from_toml("r.toml", text)?.chain()?;
/// let mut jacobian = Jacobian::zeros(1);
/// pose_and_jacobian(&chain, &[0.0], Reference::Base, &mut jacobian)?;
/// assert_eq!(jacobian[(1, 0)], 0.5); // the tool moves along y
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn pose_and_jacobian(
    chain: &Chain,
    q: &[f64],
    reference: Reference,
    jacobian: &mut Jacobian,
) -> Result<Pose> {
    if jacobian.ncols() != chain.dof() {
        *jacobian = Jacobian::zeros(chain.dof());
    }
    let pose = pose_and_columns(chain, q, columns_of(jacobian));
    if let (Reference::Tool, Ok(pose)) = (reference, &pose) {
        let turn = pose.rotation.inverse();
        for column in columns_of(jacobian) {
            let [a, b, c, d, e, f] = *column;
            let (v, w) = (turn * Vector3::new(a, b, c), turn * Vector3::new(d, e, f));
            *column = [v.x, v.y, v.z, w.x, w.y, w.z];
        }
    }
    pose
}

/// The columns of [`pose_and_jacobian`], in the base's axes, into a buffer of the caller: one column for each variable.
#[inline(always)]
pub(crate) fn pose_and_columns(chain: &Chain, q: &[f64], columns: &mut [[f64; 6]]) -> Result<Pose> {
    let canonical = chain.canonical();
    if canonical.packed().in_order {
        let mut levers = Levers {
            columns,
            canonical,
            count: 0,
        };
        single::tool_pose(chain, q, &mut levers)
    } else {
        columns.fill([0.0; 6]);
        single::tool_pose(chain, q, &mut Moments { columns })
    }
}

/// The columns as they lie in memory.
#[inline(always)]
fn columns_of(jacobian: &mut Jacobian) -> &mut [[f64; 6]] {
    jacobian.as_mut_slice().as_chunks_mut().0
}

/// One joint a column: keeps each axis and a point on it in its column, and makes the velocity of them in the end.
struct Levers<'a> {
    columns: &'a mut [[f64; 6]],
    canonical: &'a Canonical,
    count: usize,
}

impl Record for Levers<'_> {
    #[inline(always)]
    fn axis<C: SpaceColumn>(&mut self, step: &Step, frame: &Frame<C>) {
        let column = &mut self.columns[self.count];
        // As a whole register, which is one store; the fourth entry is written again below.
        column[..4].copy_from_slice(&frame.p.padded());
        column[3..].copy_from_slice(&frame.z.scaled(&step.drive.factor).store());
        self.count += 1;
    }

    #[inline(always)]
    fn tool<C: SpaceColumn>(&mut self, tool: &Frame<C>) {
        for (column, step) in self.columns.iter_mut().zip(&self.canonical.steps) {
            let (upper, lower) = halves(column);
            if step.turns {
                let lever = tool.p.minus(&tool.p.load(upper));
                *upper = tool.z.load(lower).cross(&lever).store();
            } else {
                (*upper, *lower) = (*lower, [0.0; 3]);
            }
        }
    }
}

#[inline(always)]
fn halves(column: &mut [f64; 6]) -> (&mut [f64; 3], &mut [f64; 3]) {
    let (upper, lower) = column.as_chunks_mut::<3>().0.split_at_mut(1);
    (&mut upper[0], &mut lower[0])
}

/// Several joints a column: adds up what each does to the base's origin, and moves it to the tool point in the end.
struct Moments<'a> {
    columns: &'a mut [[f64; 6]],
}

impl Record for Moments<'_> {
    fn axis<C: SpaceColumn>(&mut self, step: &Step, frame: &Frame<C>) {
        let (v, w) = single::moment(step, frame);
        let column = &mut self.columns[step.drive.variable];
        for i in 0..3 {
            column[i] += v[i];
            column[i + 3] += w[i];
        }
    }

    fn tool<C: SpaceColumn>(&mut self, frame: &Frame<C>) {
        let p = Vector3::from(frame.p.store());
        for column in self.columns.iter_mut() {
            let v = Vector3::new(column[3], column[4], column[5]).cross(&p);
            (0..3).for_each(|i| column[i] += v[i]);
        }
    }
}
