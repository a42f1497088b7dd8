//! Up to four positions of a wrist at once, where its axes meet at right angles.

use nalgebra::Matrix3;

use super::{FOUR, Sines, Task, Turns, Wide, back, both, opposite, product};
use crate::ik::TOLERANCES;
use crate::ik::angle::AWAY;

/// The rotation to be made up for, `(links_0 Rz(t_0) links_1 Rz(t_1) links_2 Rz(t_2) links_3)^T`, and the wrist that does.
pub(in crate::ik) struct Wrist<'a> {
    pub(in crate::ik) links: &'a [&'a Matrix3<f64>; 4],
    pub(in crate::ik) turns: &'a [Sines; 3],
    /// Where the position is nearly singular already.
    pub(in crate::ik) near: &'a [bool; FOUR],
    /// Sines of the two right angles: 1 or -1.
    pub(in crate::ik) signs: [f64; 2],
    /// Sines and cosines of where the wrist's joints have their own zeros.
    pub(in crate::ik) shifts: &'a [(f64, f64); 3],
}

/// The wrist's joints, the middle one bent to its positive side, and bent to the other, for which the outer ones turn by half a
/// turn; and the other three joints, the same both times.
pub(in crate::ik) struct Oriented {
    pub(in crate::ik) ball: [Turns; 3],
    pub(in crate::ik) others: [Turns; 3],
}

impl Task for Wrist<'_> {
    type Output = Oriented;

    /// `None` if one of the wrists is stretched.
    #[inline(always)]
    fn solve(&self) -> Option<Oriented> {
        // By rows: m Rz(t) link.
        let mut rows = [[Wide::all(0.0); 3]; 3];
        for (i, row) in rows.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = Wide::all(self.links[0][(i, j)]);
            }
        }
        for ([sin, cos], link) in self.turns.iter().zip(&self.links[1..]) {
            let (sin, cos) = (Wide(*sin), Wide(*cos));
            for row in &mut rows {
                let [x, y, z] = *row;
                let x_turned = product(x, cos, y, sin);
                let y_turned = product(y, cos, x.negative(), sin);
                for (j, entry) in row.iter_mut().enumerate() {
                    let [a, b, c] = [0, 1, 2].map(|i| Wide::all(link[(i, j)]));
                    *entry = x_turned.mul_add(a, product(y_turned, b, z, c));
                }
            }
        }
        let [first, second, [x, y, z]] = rows;

        // As for one rotation in `Ball`, with cosines of the angles between the axes that are zero.
        let [s1, s2] = self.signs;
        let sine = product(x, x, y, y).sqrt();
        // Not with `any`: all four in one comparison, and what is not a number fails it.
        let mut is_bent = true;
        for (value, &near) in sine.0.iter().zip(self.near) {
            let least = if near { AWAY } else { 2.0 * TOLERANCES.free };
            is_bent &= *value > least;
        }
        if !is_bent {
            return None;
        }
        let cosine = z.times(Wide::all(-s1 * s2));
        let norm = product(sine, sine, cosine, cosine).sqrt().inverse();
        let (sin, cos) = (sine.times(norm), cosine.times(norm));
        let by = sine.inverse().times(Wide::all(s2));
        let (sin_first, cos_first) = (y.times(by), x.times(by));
        let u = [
            cos_first.times(cos),
            sin_first.times(cos),
            sin.times(Wide::all(s1)),
        ];
        let v = [
            sin_first.times(Wide::all(s1 * s2)),
            cos_first.times(Wide::all(-s1 * s2)),
        ];
        // Columns of the rotation are rows here.
        let three = |row: [Wide; 3]| u[0].mul_add(row[0], product(u[1], row[1], u[2], row[2]));
        let two = |row: [Wide; 3]| product(v[0], row[0], v[1], row[1]);
        let one = Wide::all(1.0);
        let sin_last = three(second).negative().mul_add(one, two(first));
        let cos_last = three(first).mul_add(one, two(second));
        let [a, b, c] = *self.shifts;
        let first = back(sin_first, cos_first, a);
        let last = back(sin_last, cos_last, c);
        let [d, e, f] = *self.turns;
        Some(Oriented {
            ball: [
                both(first, opposite(first)),
                both(back(sin, cos, b), back(sin.negative(), cos, b)),
                both(last, opposite(last)),
            ],
            others: [both(d, d), both(e, e), both(f, f)],
        })
    }
}
