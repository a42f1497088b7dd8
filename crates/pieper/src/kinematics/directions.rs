//! Direction cosines of the tool's axes.

use crate::spatial::Pose;

/// The directions of the tool's unit vectors i, j, k in the base frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Directions {
    /// The tool's x axis (n).
    pub i: AxisDirections,
    /// The tool's y axis (s).
    pub j: AxisDirections,
    /// The tool's z axis (a).
    pub k: AxisDirections,
}

/// How one unit vector lies to the base's axes x, y, z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisDirections {
    /// Cosines of the angles with x, y, z: the vector's coordinates.
    pub cosines: [f64; 3],
    /// The angles themselves, in [0, pi].
    pub angles: [f64; 3],
}

impl Directions {
    /// The directions of a pose's axes.
    pub fn of(pose: &Pose) -> Self {
        let m = pose.rotation.matrix();
        let axis = |j: usize| {
            let cosines = [m[(0, j)], m[(1, j)], m[(2, j)]];
            // The angle from both its sine and its cosine: acos alone loses half the digits near 0 and pi.
            let angle = |r: usize| {
                let (s, t) = (cosines[(r + 1) % 3], cosines[(r + 2) % 3]);
                s.hypot(t).atan2(cosines[r])
            };
            AxisDirections {
                cosines,
                angles: [angle(0), angle(1), angle(2)],
            }
        };
        Self {
            i: axis(0),
            j: axis(1),
            k: axis(2),
        }
    }
}
