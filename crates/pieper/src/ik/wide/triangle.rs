//! Up to four loops closed by a triangle at once, behind three parallel axes.

use nalgebra::Vector3;

use super::{Bends, FOUR, Sines, Task, Turns, Wide, back, both, product, turning, unit};
use crate::ik::TOLERANCES;
use crate::ik::angle::{AWAY, MERGED, STEADY};
use crate::spatial::Pose;

/// `K_0 Z_d K_1 Z_e K_2 Z_f K_3` for given d and f: joint e follows from a direction, the other three from a triangle.
pub(in crate::ik) struct Closing<'a> {
    pub(in crate::ik) links: &'a [&'a Pose; 4],
    /// The direction of the three axes, seen from joint d and from behind joint f.
    pub(in crate::ik) axes: [Vector3<f64>; 2],
    /// Whether the chain turns that direction over: -1 if so.
    pub(in crate::ik) flip: f64,
    pub(in crate::ik) d: &'a Sines,
    pub(in crate::ik) f: &'a Sines,
    /// Where these are nearly singular already.
    pub(in crate::ik) near: &'a [bool; FOUR],
    pub(in crate::ik) triangle: Turning<'a>,
}

/// The triangle: its sides, whether its links turn the plane over, and where its joints have their own zeros.
pub(in crate::ik) struct Turning<'a> {
    pub(in crate::ik) lengths: [f64; 2],
    pub(in crate::ik) flips: [f64; 2],
    pub(in crate::ik) zeros: &'a [(f64, f64); 3],
}

/// All joints: the triangle's, bent either way, then d, e and f.
pub(in crate::ik) struct Closed {
    pub(in crate::ik) turns: [Turns; 6],
    /// Which of the two ways there are.
    pub(in crate::ik) there: [[bool; FOUR]; 2],
    /// Of which of the branches everything is known.
    pub(in crate::ik) clear: [bool; FOUR],
}

impl Task for Closing<'_> {
    type Output = Closed;

    #[inline(always)]
    fn solve(&self) -> Option<Closed> {
        let [sin_d, cos_d] = self.d.map(Wide);
        let [sin_f, cos_f] = self.f.map(Wide);
        let all = Wide::all;
        let [before, behind] = self.axes;
        // The direction of the three axes before joint e and behind it, square to the axis of e.
        let along = product(all(before.x), cos_d, all(before.y), sin_d);
        let across = product(all(before.y), cos_d, all(-before.x), sin_d);
        let r = self.links[1].rotation.matrix();
        let mut y = [all(0.0); 2];
        for (j, y) in y.iter_mut().enumerate() {
            let over = across.mul_add(all(r[(1, j)]), all(r[(2, j)] * before.z));
            *y = along.mul_add(all(r[(0, j)]), over);
        }
        let along = product(all(behind.x), cos_f, all(-behind.y), sin_f);
        let across = product(all(behind.y), cos_f, all(behind.x), sin_f);
        let r = self.links[2].rotation.matrix() * self.flip;
        let mut m = [all(0.0); 2];
        for (i, m) in m.iter_mut().enumerate() {
            let over = across.mul_add(all(r[(i, 1)]), all(r[(i, 2)] * behind.z));
            *m = along.mul_add(all(r[(i, 0)]), over);
        }
        let [sin_e, cos_e] = unit(turning(m, y));

        // The whole motion by rows, and its place.
        let first = self.links[0];
        let mut rows = [[all(0.0); 3]; 3];
        let mut place = [all(0.0); 3];
        for i in 0..3 {
            for j in 0..3 {
                rows[i][j] = all(first.rotation[(i, j)]);
            }
            place[i] = all(first.translation.vector[i]);
        }
        let turns = [(sin_d, cos_d), (sin_e, cos_e), (sin_f, cos_f)];
        for (step, (sin, cos)) in turns.into_iter().enumerate() {
            let behind = self.links[step + 1];
            let (link, shift) = (behind.rotation.matrix(), &behind.translation.vector);
            for (row, place) in rows.iter_mut().zip(&mut place) {
                let [x, y, z] = *row;
                let x_turned = product(x, cos, y, sin);
                let y_turned = product(y, cos, x.negative(), sin);
                let over = z.mul_add(all(shift.z), *place);
                *place = x_turned.mul_add(all(shift.x), y_turned.mul_add(all(shift.y), over));
                for (j, entry) in row.iter_mut().enumerate() {
                    let (a, b, c) = (all(link[(0, j)]), all(link[(1, j)]), all(link[(2, j)]));
                    *entry = x_turned.mul_add(a, product(y_turned, b, z, c));
                }
            }
        }
        // Of its inverse: where the third corner is, and the direction behind it.
        let [[a, b, _], [c, d, _], [e, f, _]] = rows;
        let [px, py, pz] = place;
        let at = [
            px.mul_add(a, product(py, c, pz, e)).negative(),
            px.mul_add(b, product(py, d, pz, f)).negative(),
        ];
        let (toward_x, toward_y) = (a, b);

        let Turning {
            lengths: [one, two],
            flips,
            ..
        } = self.triangle;
        let reach = product(at[0], at[0], at[1], at[1]).sqrt();
        let (short, long) = ((one - two).abs(), one + two);
        // Sine of the elbow without cancellation: Heron's formula.
        let one_all = all(1.0);
        let beyond = reach.mul_add(all(-1.0), all(long));
        let within = reach.mul_add(one_all, all(-short));
        let area = beyond
            .times(reach.mul_add(one_all, all(long)))
            .times(within.times(reach.mul_add(one_all, all(short))));
        let square = area.times(all(1.0 / (4.0 * one * one * two * two)));
        let cosine = reach.mul_add(reach, all(-one * one - two * two));
        let cosine = cosine.times(all(0.5 / (one * two)));
        let bends = Bends::new(square, beyond, within, MERGED * long, MERGED * long);
        let mut clear = [false; FOUR];
        let lengths = [
            product(y[0], y[0], y[1], y[1]),
            product(m[0], m[0], m[1], m[1]),
        ];
        for (k, clear) in clear.iter_mut().enumerate() {
            let near = bends.near[k] || self.near[k];
            let free = 2.0 * TOLERANCES.free;
            let [least, shortest] = if near { [AWAY, STEADY] } else { [free, free] };
            // What is not a number fails it.
            *clear = bends.there[0][k]
                && !(self.near[k] && bends.near[k])
                && reach.0[k] > least * long
                && lengths[0].0[k] > shortest * shortest
                && lengths[1].0[k] > shortest * shortest;
        }
        // A triangle that does not close is computed as a flat one: what is no number would be measured with the others.
        let root = bends.square.real_sqrt();
        let norm = product(root, root, cosine, cosine).sqrt().inverse();
        let (sin, cos) = (root.times(norm), cosine.times(norm));
        let elbow = [
            cos.mul_add(all(two), all(one)),
            sin.times(all(flips[0] * two)),
        ];
        let bend = Bend {
            triangle: &self.triangle,
            at,
            toward: [toward_x, toward_y],
            cos,
        };
        let [a, b, c] = bend.joints(sin, elbow);
        let [other_a, other_b, other_c] =
            bend.joints(sin.negative(), [elbow[0], elbow[1].negative()]);
        let e = [sin_e.0, cos_e.0];
        Some(Closed {
            turns: [
                both(a, other_a),
                both(b, other_b),
                both(c, other_c),
                both(*self.d, *self.d),
                both(e, e),
                both(*self.f, *self.f),
            ],
            there: bends.there,
            clear,
        })
    }
}

/// A triangle that is closed but for the way it bends.
struct Bend<'a> {
    triangle: &'a Turning<'a>,
    at: [Wide; 2],
    toward: [Wide; 2],
    /// The cosine of the middle joint.
    cos: Wide,
}

impl Bend<'_> {
    /// The three joints for a sine of the middle one and the place of the third corner, seen from the first link.
    #[inline(always)]
    fn joints(&self, sin: Wide, corner: [Wide; 2]) -> [Sines; 3] {
        let Turning { flips, zeros, .. } = self.triangle;
        // What follows needs no more than its direction.
        let [sin_first, cos_first] = turning(corner, self.at);
        // The x axis behind the third joint points to first + flip_1 (middle + flip_2 last).
        let [x, y] = self.toward;
        let across = product(y, cos_first, x.negative(), sin_first);
        let along = product(x, cos_first, y, sin_first);
        let middle = sin.times(Wide::all(flips[0]));
        let last_across = product(across, self.cos, along.negative(), middle);
        let last_along = product(along, self.cos, across, middle);
        let flip = Wide::all(flips[0] * flips[1]);
        [
            back(sin_first, cos_first, zeros[0]),
            back(sin, self.cos, zeros[1]),
            back(last_across.times(flip), last_along, zeros[2]),
        ]
    }
}
