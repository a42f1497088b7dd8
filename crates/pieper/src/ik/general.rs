//! Any six revolute joints: all real solutions, up to 16, by elimination. A pure numeric kernel.
//!
//! `Rz(q1) L1 Rz(q2) L2 ... Rz(q6) L6 = T` with arbitrary constant links. The closed loop is reduced to one
//! trigonometric polynomial of degree 8 in one joint angle (`cycle`, `elimination`, `resultant`,
//! `polynomial`), whose real roots are isolated (`isolate`, `refine`), completed to six angles (`back`) and
//! improved by Newton's method on the true arm (`newton`). Every step runs on several samples or roots at once.
//! A single elimination loses about one root in a thousand to rounding, in clusters of roots. Where its polynomial is clear of its
//! noise everywhere and each root led to a solution of its own, it is believed alone; otherwise more with different
//! kept joints are run until two agree (`agreement`). Two roots that are nearly one are a fold of the arm, on which both solutions are
//! told apart, or found to be one or none (`fold`). Structured arms (parallel or meeting axes) make the
//! resultant vanish identically; their linear part is perturbed, the arm itself is not (`random`). Every elimination
//! measures its own noise, by the harmonics that the polynomial should not have, and says whether roots may have drowned
//! in it; then, and where eliminations differ, the resultant is computed with twice the digits (`number`). Roots that share
//! the kept angle, as mirrored ones of symmetric arms do, are separated where the resultant's matrix has rank 1
//! (`resultant`). Arms with an offset wrist have such a polynomial in closed form, exact and free of perturbation, which is
//! tried first (`offset`). Which eliminations are used, and in which order, is decided per arm by solving test poses (`trial`).
//!
//! Sources: M. Raghavan, B. Roth, J. Mech. Design 115, 1993 (the equations and the 12 x 12 resultant); D. Manocha,
//! J. Canny, IEEE Trans. Robotics and Automation 10(5), 1994 (numeric elimination). The reduction to 3 x 3, the root
//! isolation, the perturbation of the elimination alone, the measure of its noise, the agreement rule and the way to tell
//! solutions apart at a fold were worked out and measured for this project.

mod agreement;
mod back;
mod cycle;
mod elimination;
mod fold;
mod isolate;
mod line;
mod linear;
mod list;
mod newton;
mod number;
mod offset;
mod orientation;
mod polynomial;
mod pool;
mod random;
mod reach;
mod refine;
mod resultant;
mod siblings;
mod single;
mod tables;
mod tolerances;
mod trial;
mod way;

use pulp::{Arch, Simd, WithSimd};

use crate::error::{Error, Result};
use crate::ik::lanes::Rigid;
use crate::spatial::{self, Pose};
use nalgebra::Vector3;
use newton::Goal;
use single::Target;
use tables::Tables;

pub use pool::MAX_ROOTS;

/// A solver prepared for one arm with six revolute joints.
#[derive(Clone, Debug)]
pub struct General {
    arm: Scaled,
    tables: Box<Tables>,
    /// In the order in which they are run.
    eliminations: Vec<way::Way>,
    /// How many are run at least.
    least: usize,
    /// The equation without elimination of an arm that has one; tried first.
    offset: Option<Box<offset::Offset>>,
}

/// The arm as the eliminations see it: lengths scaled to add up to 3, no shift along the first and last axis.
#[derive(Clone, Debug)]
struct Scaled {
    links: [Rigid; 5],
    /// Which joints slide.
    slides: [bool; 6],
    poses: [Pose; 5],
    /// Shift along the first axis, metres.
    rise: f64,
    /// From the last link to the last axis.
    last: Pose,
    /// Scaled lengths per metre.
    scale: f64,
    /// The farthest that the last axis' point can be from the first axis' point, scaled.
    reach: reach::Reach,
}

/// One solution.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Root {
    /// Sine and cosine of each joint angle; metres and 0 of a joint that slides.
    pub turns: [(f64, f64); 6],
    /// Error of the pose after Newton: metres and radians, as one norm.
    pub residual: f64,
    /// Smallest singular value of the Jacobian, lengths scaled so that the arm's links add up to 3: small near
    /// singularities, zero on families and at double roots.
    pub sigma: f64,
    /// How many roots it stands for: 2 where two are closer than rounding tells apart.
    pub multiplicity: u8,
    /// It is singular, and whether it stands alone, and for how many roots, was not told.
    pub open: bool,
    slides: [bool; 6],
}

impl Root {
    /// Joint angles, in [-pi, pi]; metres of a joint that slides.
    pub fn q(&self) -> [f64; 6] {
        std::array::from_fn(|joint| {
            let (sin, cos) = self.turns[joint];
            if self.slides[joint] {
                sin
            } else {
                sin.atan2(cos)
            }
        })
    }
}

/// All solutions of one target.
#[derive(Clone, Debug)]
pub struct Roots {
    list: [Root; MAX_ROOTS],
    count: usize,
}

impl Default for Roots {
    fn default() -> Self {
        let list = [Root::default(); MAX_ROOTS];
        Self { list, count: 0 }
    }
}

impl std::ops::Deref for Roots {
    type Target = [Root];
    fn deref(&self) -> &[Root] {
        &self.list[..self.count]
    }
}

/// How sure it is that all solutions were found, and how that was established.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Completeness {
    /// So many eliminations were run. The last one found the whole set, and was exact and well above its noise everywhere but at pairs of
    /// roots that were told apart; or at least two found it, an even number of regular roots, one of them with
    /// every root and every gap above its noise. Not a proof; see the measured rates.
    Agreed {
        /// Eliminations run.
        eliminations: u8,
    },
    /// The arm has an offset wrist. Its equation in one unknown rose well above its noise everywhere, and every root led to a
    /// solution of its own; or it was looked at closely where it did not.
    Equation,
    /// The target is farther than the links together reach: there is none.
    OutOfReach,
    /// Some root is singular, where roots merge or form a family: isolated roots were found as usual, but how many there
    /// are at the singularity itself is not decided here.
    Singular {
        /// Eliminations run.
        eliminations: u8,
    },
    /// All eliminations were run without agreement; also for an odd number of roots.
    Doubtful {
        /// Eliminations run.
        eliminations: u8,
    },
}

impl General {
    /// Prepares the solver for `Rz(q1) L1 ... Rz(q6) L6`, links in metres.
    ///
    /// # Errors
    /// A model error for an arm that is singular everywhere, or whose links are not finite.
    pub fn prepare(links: &[Pose; 6]) -> Result<Self> {
        Self::prepare_with_slides(links, &[None; 6])
    }

    /// The same for an arm of which one or two joints slide along z instead of turning about it: those for which a length
    /// is given, by which they move as a rule, in metres. It sets the scale and is no limit.
    ///
    /// A slide takes part in the equations by 1, q and q^2 in place of 1, cos q and sin q; the kept joint and the one opposite
    /// turn.
    ///
    /// # Errors
    /// As [`General::prepare`]; and for more than two slides, or lengths that are not positive.
    pub fn prepare_with_slides(links: &[Pose; 6], slides: &[Option<f64>; 6]) -> Result<Self> {
        let arm = Scaled::new(links, slides)?;
        let tables = Box::new(Tables::new());
        let chosen = Arch::new().dispatch(trial::Trial {
            arm: &arm,
            tables: &tables,
        })?;
        Ok(Self {
            arm,
            tables,
            eliminations: chosen.ways,
            least: chosen.least,
            offset: chosen.offset,
        })
    }

    /// Whether the arm has an offset wrist, with an equation in one angle that needs no elimination.
    pub fn has_equation(&self) -> bool {
        self.offset.is_some()
    }

    /// Finds all joint angles that put the last link at `target`. Allocates nothing.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use pieper::ik::general::{General, Roots};
    /// use pieper::spatial;
    ///
    /// let link = |a: f64, alpha: f64| {
    ///     let bend = spatial::turn(&Vector3::x_axis(), alpha.sin_cos());
    ///     spatial::shift(Vector3::new(a, 0.0, 0.1)) * bend
    /// };
    /// let links = [1.1, -0.4, 1.4, -0.9, 1.2, 0.4].map(|alpha| link(0.3, alpha));
    /// let q = [0.3, -0.8, 1.1, 0.5, -1.2, 0.7];
    /// let turned = q.map(|angle: f64| spatial::turn(&Vector3::z_axis(), angle.sin_cos()));
    /// let target = turned.iter().zip(&links).fold(spatial::shift(Vector3::zeros()), |pose, (turn, link)| pose * turn * link);
    ///
    /// let mut roots = Roots::default();
    /// General::prepare(&links)?.solve(&target, &mut roots);
    /// let is_it = |root: [f64; 6]| root.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-9);
    /// assert!(roots.iter().any(|root| is_it(root.q())));
    /// # Ok::<(), pieper::Error>(())
    /// ```
    pub fn solve(&self, target: &Pose, out: &mut Roots) -> Completeness {
        out.count = 0;
        let target = Target::new(self.arm.inner(target));
        if self.arm.reach.excludes(&target.pose) {
            return Completeness::OutOfReach;
        }
        Arch::new().dispatch(Solve {
            general: self,
            target,
            out,
        })
    }
}

struct Solve<'a> {
    general: &'a General,
    target: Target,
    out: &'a mut Roots,
}

impl WithSimd for Solve<'_> {
    type Output = Completeness;
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Completeness {
        let Self {
            general,
            target,
            out,
        } = self;
        let goal = Goal {
            links: &general.arm.links,
            slides: &general.arm.slides,
            target: Rigid::of(&target.pose),
        };
        agreement::run(simd, general, &goal, &target, out)
    }
}

/// The sum of the scaled link lengths.
const TOTAL: f64 = 3.0;

impl Scaled {
    fn new(links: &[Pose; 6], slides: &[Option<f64>; 6]) -> Result<Self> {
        let travels = || slides.iter().flatten();
        if travels().count() > 2 {
            let text = "at most two of its six joints may slide: with three the orientation alone gives the angles";
            return Err(Error::model("arm", text));
        }
        if !travels().all(|&length| length.is_finite() && length > 0.0) {
            let text = "the length by which a joint slides is not a positive number";
            return Err(Error::model("arm", text));
        }
        let finite = |pose: &Pose| {
            let entries = pose.rotation.matrix().iter();
            entries
                .chain(pose.translation.vector.iter())
                .all(|x| x.is_finite())
        };
        if !links.iter().all(finite) {
            return Err(Error::model(
                "arm",
                "a link has an entry that is not finite",
            ));
        }
        let rise = links[0].translation.vector.z;
        let mut poses: [Pose; 5] = std::array::from_fn(|i| links[i]);
        poses[0].translation.vector.z = 0.0;
        let total: f64 = poses
            .iter()
            .map(|pose| pose.translation.vector.norm())
            .sum();
        let total = total + travels().sum::<f64>();
        if total.is_nan() || total <= 0.0 {
            let text = "all six axes meet in a point: it cannot move the tool's point";
            return Err(Error::model("arm", text));
        }
        let scale = TOTAL / total;
        if !scale.is_finite() || scale <= 0.0 {
            return Err(Error::model("arm", "its lengths are out of range"));
        }
        for pose in &mut poses {
            pose.translation.vector *= scale;
        }
        Ok(Self {
            links: poses.each_ref().map(Rigid::of),
            reach: reach::Reach::new(&poses, &slides.map(|slide| slide.is_some())),
            slides: slides.map(|slide| slide.is_some()),
            poses,
            rise,
            last: links[5].inverse(),
            scale,
        })
    }

    /// The target as the eliminations see it.
    fn inner(&self, target: &Pose) -> Pose {
        let mut inner = spatial::shift(Vector3::new(0.0, 0.0, -self.rise)) * target * self.last;
        inner.translation.vector *= self.scale;
        inner
    }

    /// Where the scaled arm puts its last axis.
    fn forward(&self, q: &[f64; 6]) -> Pose {
        let mut pose = Pose::identity();
        for (index, angle) in q.iter().enumerate() {
            if self.slides[index] {
                pose *= spatial::shift(Vector3::new(0.0, 0.0, *angle));
            } else {
                pose *= spatial::turn(&Vector3::z_axis(), angle.sin_cos());
            }
            if let Some(link) = self.poses.get(index) {
                pose *= link;
            }
        }
        pose
    }
}
