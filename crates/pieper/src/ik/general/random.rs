//! Fixed pseudo-random numbers: perturbations and test poses are the same in every run.

use nalgebra::{Rotation3, Translation3, Vector3};

use crate::spatial::Pose;

/// SplitMix64 (Steele, Lea, Flood, OOPSLA 2014).
#[derive(Clone, Debug)]
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in (-1, 1).
    pub(super) fn signed(&mut self) -> f64 {
        let unit = (self.next() >> 11) as f64 * (0.5_f64).powi(53);
        2.0 * unit - 1.0
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::new(self.signed(), self.signed(), self.signed())
    }

    /// A motion whose rotation vector and shift are up to `size` in each coordinate; the identity for 0.
    pub(super) fn motion(&mut self, size: f64) -> Pose {
        if size == 0.0 {
            return Pose::identity();
        }
        let (turn, shift) = (self.vector() * size, self.vector() * size);
        Pose::from_parts(Translation3::from(shift), Rotation3::new(turn))
    }
}
