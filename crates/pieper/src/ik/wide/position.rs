//! Up to four ways to bring a point to a place at once, by joints of which the second and third are parallel.

use super::{Bends, FOUR, Sines, Task, Wide, back, product, turning, unit};
use crate::ik::TOLERANCES;
use crate::ik::angle::{AWAY, MERGED, ONE};

/// Pieper's equations where axes 2 and 3 are parallel, once it is known how far the point is from axis 2: reaching forward
/// or back, with the elbow bent either way.
pub(in crate::ik) struct Folding {
    /// Where the point is, seen from axis 2 in the plane that it turns: forward or back along the first, one for both.
    pub(in crate::ik) u: [f64; 2],
    pub(in crate::ik) v: f64,
    /// From axis 1 to axis 2.
    pub(in crate::ik) a1: f64,
    /// Across that plane, seen from axis 1.
    pub(in crate::ik) side: f64,
    /// From axis 2 to axis 3, and from there to the point.
    pub(in crate::ik) lengths: [f64; 2],
    /// Whether link 2 turns the plane over: -1 if so.
    pub(in crate::ik) flip: f64,
    /// The place, seen from above.
    pub(in crate::ik) place: [f64; 2],
    /// A length that stands for the problem's.
    pub(in crate::ik) scale: f64,
    /// Sines and cosines of what the three angles are counted from.
    pub(in crate::ik) zeros: [(f64, f64); 3],
    /// Whether reaching forward and back are so close that nothing else may be singular.
    pub(in crate::ik) near: bool,
    /// Whether the distances are known to rounding.
    pub(in crate::ik) steady: bool,
}

/// The three joints, in the order forward and bent one way, forward and bent the other, back.
pub(in crate::ik) struct Folded {
    pub(in crate::ik) turns: [Sines; 3],
    /// Which there are.
    pub(in crate::ik) there: [bool; FOUR],
    /// Which are certain only if the wrist is not singular as well.
    pub(in crate::ik) near: [bool; FOUR],
    /// Of which of the two directions everything is known.
    pub(in crate::ik) clear: [bool; 2],
}

impl Task for Folding {
    type Output = Folded;

    #[inline(always)]
    fn solve(&self) -> Option<Folded> {
        let all = Wide::all;
        let [forward, behind] = self.u;
        let u = Wide([forward, forward, behind, behind]);
        let [long_side, short_side] = self.lengths;
        let v = all(self.v);
        let reach = product(u, u, v, v).sqrt();
        let (long, short) = (
            long_side.abs() + short_side,
            (long_side.abs() - short_side).abs(),
        );
        // Sine of the elbow without cancellation: Heron's formula.
        let one = all(1.0);
        let beyond = reach.mul_add(all(-1.0), all(long));
        let within = reach.mul_add(one, all(-short));
        let area = beyond
            .times(reach.mul_add(one, all(long)))
            .times(within.times(reach.mul_add(one, all(short))));
        let by = 2.0 * long_side * short_side;
        let square = area.times(all(1.0 / (by * by)));
        let bends = Bends::new(
            square,
            beyond,
            within,
            MERGED * self.scale,
            ONE * self.scale,
        );
        let square = bends.square;
        let cosine = reach.mul_add(reach, all(-long_side * long_side - short_side * short_side));
        let cosine = cosine.times(all(1.0 / by));
        let norm = product(cosine, cosine, square, one).sqrt().inverse();
        // An arm that does not reach is computed as a stretched one: what is no number would be measured with the others.
        let sine = square
            .real_sqrt()
            .times(norm)
            .times(Wide([1.0, -1.0, 1.0, -1.0]));
        let cosine = cosine.times(norm);
        // Joints 2 and 1 turn what is behind them to where it is to be.
        let elbow = [
            cosine.mul_add(all(short_side), all(long_side)),
            sine.times(all(self.flip * short_side)),
        ];
        let second = unit(turning(elbow, [u, v]));
        let around = [u.mul_add(one, all(self.a1)), all(self.side)];
        let first = unit(turning(around, self.place.map(all)));
        let least = 4.0 * TOLERANCES.free * TOLERANCES.free * self.scale * self.scale;
        let (bent, round) = (
            product(elbow[0], elbow[0], elbow[1], elbow[1]),
            product(around[0], around[0], around[1], around[1]),
        );
        let far = self.place[0] * self.place[0] + self.place[1] * self.place[1];
        let away = AWAY * AWAY * self.scale * self.scale;
        let (mut there, mut near) = ([false; FOUR], [false; FOUR]);
        let mut clear = [true; 2];
        for k in 0..FOUR {
            near[k] = bends.near[k] || self.near;
            there[k] = bends.there[k % 2][k];
            let least = if near[k] { away } else { least };
            // What is not a number fails.
            clear[k / 2] &= bends.there[0][k]
                && (self.steady || !bends.near[k])
                && !(self.near && bends.near[k])
                && far > least
                && reach.0[k] * reach.0[k] > least
                && bent.0[k] > least
                && round.0[k] > least;
        }
        let [a, b, c] = self.zeros;
        Some(Folded {
            turns: [
                back(first[0], first[1], a),
                back(second[0], second[1], b),
                back(sine, cosine, c),
            ],
            there,
            near,
            clear,
        })
    }
}
