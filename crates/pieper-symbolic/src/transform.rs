//! Rigid motions whose entries are formulas.

use pieper::kinematics::kernel::Frame;

use crate::poly::Poly;

/// A rigid motion: the first three rows of its 4x4 matrix `[n s a p]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Transform(pub [[Poly; 4]; 3]);

/// A frame of the library's kernel over formulas.
pub(crate) type PolyFrame = Frame<[Poly; 3]>;

/// The frame that the identity is.
pub(crate) fn identity_frame() -> PolyFrame {
    let unit = |axis: usize| {
        std::array::from_fn(|row| {
            if row == axis {
                Poly::one()
            } else {
                Poly::zero()
            }
        })
    };
    Frame {
        x: unit(0),
        y: unit(1),
        z: unit(2),
        p: std::array::from_fn(|_| Poly::zero()),
    }
}

impl Transform {
    /// No motion.
    pub fn identity() -> Self {
        Self::of_frame(&identity_frame())
    }

    pub(crate) fn of_frame(frame: &PolyFrame) -> Self {
        let columns = [&frame.x, &frame.y, &frame.z, &frame.p];
        Self(std::array::from_fn(|row| {
            columns.map(|column| column[row].clone())
        }))
    }

    pub(crate) fn frame(&self) -> PolyFrame {
        let column = |j: usize| std::array::from_fn(|row: usize| self.0[row][j].clone());
        Frame {
            x: column(0),
            y: column(1),
            z: column(2),
            p: column(3),
        }
    }

    /// The entry in row and column, counted from 0; the last row is `0 0 0 1`.
    pub fn entry(&self, row: usize, column: usize) -> Poly {
        match row {
            3 => Poly::whole(i64::from(column == 3)),
            row => self.0[row][column].clone(),
        }
    }

    /// Every entry of the first three rows.
    pub fn entries(&self) -> impl Iterator<Item = &Poly> {
        self.0.iter().flatten()
    }

    /// The motion with each entry changed.
    #[must_use]
    pub fn map(&self, change: impl Fn(&Poly) -> Poly) -> Self {
        Self(self.0.each_ref().map(|row| row.each_ref().map(&change)))
    }

    /// `self * other`
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut frame = self.frame();
        frame.append(&other.0);
        Self::of_frame(&frame)
    }

    /// The inverse: `[R^T, -R^T p]`.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let m = &self.0;
        Self(std::array::from_fn(|i| {
            std::array::from_fn(|j| match j {
                3 => -(&m[0][i] * &m[0][3] + &m[1][i] * &m[1][3] + &m[2][i] * &m[2][3]),
                j => m[j][i].clone(),
            })
        }))
    }

    /// Whether an entry has grown past all use.
    pub fn is_swollen(&self) -> bool {
        self.entries().any(Poly::is_swollen)
    }
}
