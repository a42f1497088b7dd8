//! Arms with a vertical first axis, two parallel axes square to it, and a spherical wrist.

use nalgebra::Matrix3;

use super::names::{Names, StepRow};
use super::{Canonical, Step};
use crate::spatial::Quarters;

/// The numbers of an arm whose axis 1 is the world's z, whose axes 2 and 3 are parallel and square to it, whose axis 4 is
/// square to those, and whose axes 4 to 6 meet square to each other: most industrial arms (Brandstoetter, Angerer and
/// Hofbaur 2014 call them ortho-parallel with a spherical wrist).
///
/// All signs are in the numbers: in the stored columns of [`Names`] each twist by a right angle is a mere exchange of the
/// second and third column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ortho {
    /// The variables that drive the axes.
    pub(crate) variables: [usize; 6],
    /// The angles about the stored third columns: -0 where the variable's sign is turned round and 0 where not, and what is
    /// added then.
    pub(crate) drives: [(f64, f64); 6],
    /// From axis 1 to axis 2, along x.
    pub(crate) a1: f64,
    /// From axis 2 to axis 3, along x.
    pub(crate) a2: f64,
    /// From axis 3 to axis 4, along x.
    pub(crate) a3: f64,
    /// Along axes 2 and 3.
    pub(crate) side: f64,
    /// Along axis 4 to the wrist's centre.
    pub(crate) d4: f64,
    /// From the wrist's centre to the tool, along axis 6.
    pub(crate) d6: f64,
    /// The world's position of axis 1's foot, the height of axis 2 in it.
    pub(crate) base: [f64; 3],
    /// Signs of the world's y and z in the stored axes.
    pub(crate) signs: [f64; 2],
    /// The stored second column is the tool's z, the third its y.
    pub(crate) swapped: bool,
}

impl Ortho {
    /// The arm as one of this kind, if it is.
    pub(super) fn of(canonical: &Canonical) -> Option<Self> {
        let steps: &[Step; 6] = canonical.steps.as_slice().try_into().ok()?;
        let is_upright = *canonical.base.rotation.matrix() == Matrix3::identity();
        if !is_upright || canonical.tail.is_some() {
            return None;
        }
        let mut rows = [StepRow {
            d: 0.0,
            a: 0.0,
            quarters: Quarters::None,
        }; 6];
        for (row, step) in rows.iter_mut().zip(steps) {
            *row = StepRow::of(step)?;
        }
        let is_square =
            |index: usize| matches!(rows[index].quarters, Quarters::Plus | Quarters::Minus);
        let squares = [0, 2, 3, 4].into_iter().all(is_square) && !is_square(1);
        let meets = rows[3].a == 0.0 && rows[4].a == 0.0 && rows[5].a == 0.0 && rows[4].d == 0.0;
        if !squares || !meets {
            return None;
        }
        let start = Names::before(steps);
        let mut names = start;
        let mut drives = [(0.0, 0.0); 6];
        let mut shifts = [0.0; 6];
        for (index, (step, row)) in steps.iter().zip(&rows).enumerate() {
            let [y, z] = names.signs;
            drives[index] = match y * step.drive.factor {
                1.0 => (0.0, y * step.drive.offset),
                -1.0 => (-0.0, y * step.drive.offset),
                _ => return None,
            };
            shifts[index] = z * row.d;
            names = names.twisted(row.quarters);
        }
        let position = canonical.base.translation.vector;
        let [sign_y, sign_z] = start.signs;
        Some(Self {
            variables: [0, 1, 2, 3, 4, 5].map(|index: usize| steps[index].drive.variable),
            drives,
            a1: rows[0].a,
            a2: rows[1].a,
            a3: rows[2].a,
            side: shifts[1] + shifts[2],
            d4: shifts[3],
            d6: shifts[5],
            base: [position.x, position.y, position.z + sign_z * shifts[0]],
            signs: [sign_y, sign_z],
            swapped: is_square(5),
        })
    }
}
