//! Up to four positions of a wrist at once, where its axes meet at right angles.

use nalgebra::Matrix3;

use super::TOLERANCES;

/// Positions at once: an arm with a spherical wrist has four at most, away from singularities.
pub(super) const FOUR: usize = 4;

/// Sines and cosines of one joint for [`FOUR`] positions.
pub(super) type Sines = [[f64; FOUR]; 2];

/// The rotation to be made up for, `(links_0 Rz(t_0) links_1 Rz(t_1) links_2 Rz(t_2) links_3)^T`, and the wrist that does.
pub(super) struct Task<'a> {
    pub(super) links: &'a [Matrix3<f64>; 4],
    pub(super) turns: &'a [Sines; 3],
    /// Sines of the two right angles: 1 or -1.
    pub(super) signs: [f64; 2],
    /// Sines and cosines of where the wrist's joints have their own zeros.
    pub(super) shifts: &'a [(f64, f64); 3],
}

/// The wrist's joints, the middle one bent to its positive side; and the middle one bent to the other, for which the
/// outer ones turn by half a turn.
pub(super) struct Oriented {
    pub(super) turns: [Sines; 3],
    pub(super) other: Sines,
}

/// The wrist for all four, or `None` if one of them is stretched, or if this processor has no registers of four doubles:
/// those are solved one by one.
#[inline]
pub(super) fn orient(task: &Task<'_>) -> Option<Oriented> {
    #[cfg(all(target_arch = "x86_64", feature = "avx2"))]
    if let Some(simd) = pulp::x86::V3::try_new() {
        return pulp::Simd::vectorize(simd, Call(task));
    }
    let _ = task;
    None
}

/// The call, as what runs with the processor's features switched on.
#[cfg(all(target_arch = "x86_64", feature = "avx2"))]
struct Call<'a>(&'a Task<'a>);

#[cfg(all(target_arch = "x86_64", feature = "avx2"))]
impl pulp::NullaryFnOnce for Call<'_> {
    type Output = Option<Oriented>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        self.0.solve()
    }
}

/// One number for each position.
#[derive(Clone, Copy)]
struct Wide([f64; FOUR]);

impl Wide {
    #[inline(always)]
    fn all(value: f64) -> Self {
        Self([value; FOUR])
    }

    /// `self by + plus`, fused: only within [`Call`], where it is one instruction.
    #[inline(always)]
    fn mul_add(self, by: Self, plus: Self) -> Self {
        let mut out = [0.0; FOUR];
        for k in 0..FOUR {
            out[k] = self.0[k].mul_add(by.0[k], plus.0[k]);
        }
        Self(out)
    }

    #[inline(always)]
    fn times(self, by: Self) -> Self {
        let mut out = [0.0; FOUR];
        for k in 0..FOUR {
            out[k] = self.0[k] * by.0[k];
        }
        Self(out)
    }

    #[inline(always)]
    fn negative(self) -> Self {
        let mut out = [0.0; FOUR];
        for k in 0..FOUR {
            out[k] = -self.0[k];
        }
        Self(out)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let mut out = [0.0; FOUR];
        for k in 0..FOUR {
            out[k] = self.0[k].sqrt();
        }
        Self(out)
    }

    #[inline(always)]
    fn inverse(self) -> Self {
        let mut out = [0.0; FOUR];
        for k in 0..FOUR {
            out[k] = 1.0 / self.0[k];
        }
        Self(out)
    }
}

/// `a b + c d`
#[inline(always)]
fn product(a: Wide, b: Wide, c: Wide, d: Wide) -> Wide {
    a.mul_add(b, c.times(d))
}

/// Sine and cosine of an angle less a constant one.
#[inline(always)]
fn back(sin: Wide, cos: Wide, (s, c): (f64, f64)) -> Sines {
    let (s, c) = (Wide::all(s), Wide::all(c));
    [
        product(sin, c, cos.negative(), s).0,
        product(cos, c, sin, s).0,
    ]
}

impl Task<'_> {
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
        for value in sine.0 {
            is_bent &= value > 2.0 * TOLERANCES.free;
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
        Some(Oriented {
            turns: [
                back(sin_first, cos_first, a),
                back(sin, cos, b),
                back(sin_last, cos_last, c),
            ],
            other: back(sin.negative(), cos, b),
        })
    }
}
