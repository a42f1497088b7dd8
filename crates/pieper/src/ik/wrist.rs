//! Three axes through one point turn a body to an orientation.

use nalgebra::{Matrix3, Rotation3, UnitQuaternion};

use super::TOLERANCES;
use super::angle::{Roots, back, forth, turn_between};
use super::normal::Normal;
use super::reason::{Part, Shortfall};
use crate::spatial::sin_cos_exact;

/// How rotations are represented while an orientation is solved; the answers are equal to rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Method {
    /// Rotation matrices.
    #[default]
    Matrix,
    /// Unit quaternions.
    Quaternion,
}

/// `Rz(x1) R_1 Rz(x2) R_2 Rz(x3) = R`, with `R_i = Rz(phi) Rx(alpha) Rz(psi)`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    alpha: [(f64, f64); 2],
    /// Sines and cosines of half the sum of both angles, and of half of the second minus the first.
    halves: [(f64, f64); 2],
    /// Whether both angles between neighbouring axes are right ones to the last bit.
    right: bool,
    /// Sines and cosines of where the three joints' own zeros lie.
    shifts: [(f64, f64); 3],
}

/// One way to turn there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turned {
    /// Sines and cosines, up to a common factor of the last.
    pub(super) turns: [(f64, f64); 3],
    pub(super) flip: bool,
    pub(super) multiplicity: u8,
    pub(super) edge: bool,
    /// The outer angles are determined only together.
    pub(super) free: bool,
}

/// All ways: two, or one where they merge; three starts where the arm misses its class.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turns {
    pub(super) list: [Turned; 3],
    pub(super) len: usize,
    pub(super) shortfall: Option<Shortfall>,
}

impl Ball {
    pub(super) fn new(first: &Normal, second: &Normal) -> Self {
        let shifts = [first.phi, first.psi + second.phi, second.psi].map(sin_cos_exact);
        Self::between([first.alpha, second.alpha], shifts)
    }

    fn between(alpha: [(f64, f64); 2], shifts: [(f64, f64); 3]) -> Self {
        let [first, second] = alpha.map(|(sin, cos)| sin.atan2(cos));
        Self {
            alpha,
            halves: [0.5 * (first + second), 0.5 * (second - first)].map(sin_cos_exact),
            right: alpha.iter().all(|(_, cos)| *cos == 0.0),
            shifts,
        }
    }

    /// The sines of the angles between neighbouring axes, where both are right ones.
    #[inline]
    pub(super) fn right_signs(&self) -> Option<[f64; 2]> {
        self.right.then_some(self.alpha.map(|(sin, _)| sin))
    }

    /// Sines and cosines of where the three joints' own zeros lie.
    #[inline]
    pub(super) fn shifts(&self) -> &[(f64, f64); 3] {
        &self.shifts
    }

    /// Both ways to reach the rotation `r`, by one method or the other.
    #[inline]
    pub(super) fn solve(&self, r: &Matrix3<f64>, slack: f64, method: Method) -> Turns {
        match method {
            Method::Matrix => self.solve_by_matrices(r, slack),
            Method::Quaternion => self.solve_by_quaternions(r, slack),
        }
    }

    #[inline]
    fn solve_by_matrices(&self, r: &Matrix3<f64>, slack: f64) -> Turns {
        let [(s1, c1), (s2, c2)] = self.alpha;
        let (x, y, z) = (r[(0, 2)], r[(1, 2)], r[(2, 2)]);
        // Third column: Rz(x1) g with g = Rx(a1) Rz(x2) (0, -s2, c2). Its height gives cos x2; the sine comes from
        // the length of its plane part, which keeps all digits where z is close to 1.
        let product = s1 * s2;
        let cosine = (c1 * c2 - z) / product;
        let flat = x * x + y * y;
        let square = if self.right {
            flat
        } else {
            (flat - c1 * c1 - c2 * c2 + 2.0 * c1 * c2 * z) / (product * product)
        };
        let sines = self.sines(square, slack);
        let mut turns = self.empty(&sines, cosine);
        for (turned, sine) in turns.list.iter_mut().zip(sines.iter()) {
            // Flip: the middle joint bends to the negative side, as its own zero counts it.
            turned.flip = sine < 0.0;
            if turned.flip && self.right && !sines.edge {
                break;
            }
            self.outer(r, (sine, cosine), turned);
        }
        if self.right && turns.len == 2 && !sines.edge {
            // Right angles: the other way turns both outer joints by half a turn.
            let [a, b, c] = turns.list[0].turns;
            let middle = forth(b, self.shifts[1]);
            let middle = back((-middle.0, middle.1), self.shifts[1]);
            turns.list[1].turns = [(-a.0, -a.1), middle, (-c.0, -c.1)];
        }
        turns
    }

    /// The sines of the middle joint.
    #[inline]
    fn sines(&self, square: f64, slack: f64) -> Roots {
        if self.right && slack == 0.0 {
            // A sum of squares: only an exact alignment merges the two, and then it is a family.
            let sine = square.sqrt();
            let aligned = sine < TOLERANCES.free;
            return Roots {
                values: [if aligned { 0.0 } else { sine }, -sine, 0.0],
                len: if aligned { 1 } else { 2 },
                edge: aligned,
            };
        }
        Roots::of(square, slack)
    }

    /// Starts for Newton's method where the arm is nearly aligned and misses its class: the first joint may be
    /// anywhere.
    pub(super) fn starts(&self, r: &Matrix3<f64>, turned: &Turned) -> [[(f64, f64); 3]; 8] {
        let middle = forth(turned.turns[1], self.shifts[1]);
        std::array::from_fn(|k| {
            let first = k as f64 * std::f64::consts::FRAC_PI_4;
            self.complete(r, first.sin_cos(), middle)
        })
    }

    /// The outer joints for a given middle one.
    #[inline]
    fn outer(&self, r: &Matrix3<f64>, (sine, cosine): (f64, f64), turned: &mut Turned) {
        let [(s1, c1), (s2, c2)] = self.alpha;
        let norm = (sine * sine + cosine * cosine).sqrt();
        let (sin, cos) = (sine / norm, cosine / norm);
        let g = [s2 * sin, -c1 * s2 * cos - s1 * c2];
        let plane = [r[(0, 2)], r[(1, 2)]];
        let short = |v: [f64; 2]| v[0].abs().max(v[1].abs()) < TOLERANCES.free;
        turned.free = short(g) || short(plane);
        let first = if turned.free {
            (0.0, 1.0)
        } else {
            turn_between(g, plane)
        };
        turned.turns = self.complete(r, first, (sin, cos));
    }

    /// The last joint for given others; its sine and cosine up to a common factor.
    #[inline]
    fn complete(
        &self,
        r: &Matrix3<f64>,
        (sf, cf): (f64, f64),
        (sin, cos): (f64, f64),
    ) -> [(f64, f64); 3] {
        let [(s1, c1), (s2, c2)] = self.alpha;
        // The last joint takes what is left of the whole rotation, so that an ill-determined first joint is made up
        // for. M = Rz(x1) Rx(a1) Rz(x2) Rx(a2); its first two columns against those of R.
        let u = [cos, c1 * sin, s1 * sin];
        let v = [-sin * c2, c1 * cos * c2 - s1 * s2, s1 * cos * c2 + c1 * s2];
        let spun = |w: [f64; 3]| [cf * w[0] - sf * w[1], sf * w[0] + cf * w[1], w[2]];
        let (u, v) = (spun(u), spun(v));
        let dot = |w: [f64; 3], j: usize| w[0] * r[(0, j)] + w[1] * r[(1, j)] + w[2] * r[(2, j)];
        let last = (dot(v, 0) - dot(u, 1), dot(u, 0) + dot(v, 1));
        let [a, b, c] = self.shifts;
        [back((sf, cf), a), back((sin, cos), b), back(last, c)]
    }

    /// [`Ball::solve`] by quaternions: the same ways in the same order.
    ///
    /// With `m = qx(a1) qz(x2) qx(a2)` the quaternion is `qz(x1) m qz(x3)`: the plane vector `(w, k)` is that of m turned
    /// by half the sum of the outer angles, `(i, j)` that of m turned by half their difference. Lengths do not change, and
    /// give the middle angle: with A the half sum and B the half difference of the angles between the axes,
    /// `w^2 + k^2 = cos^2(x2/2) cos^2 A + sin^2(x2/2) cos^2 B`.
    fn solve_by_quaternions(&self, r: &Matrix3<f64>, slack: f64) -> Turns {
        let rotation = Rotation3::from_matrix_unchecked(*r);
        let q = UnitQuaternion::from_rotation_matrix(&rotation).into_inner();
        let [(sum_sin, sum_cos), (gap_sin, gap_cos)] = self.halves;
        let (outer, inner) = (q.w * q.w + q.k * q.k, q.i * q.i + q.j * q.j);
        let product = -self.alpha[0].0 * self.alpha[1].0;
        let cosine_2 = (outer * gap_sin * gap_sin - inner * gap_cos * gap_cos) / product;
        let sine_2 = (inner * sum_cos * sum_cos - outer * sum_sin * sum_sin) / product;
        let cosine = cosine_2 - sine_2;
        let sines = self.sines(4.0 * sine_2 * cosine_2, slack);
        let mut turns = self.empty(&sines, cosine);
        for (turned, sine) in turns.list.iter_mut().zip(sines.iter()) {
            turned.flip = sine < 0.0;
            let middle = sine.atan2(cosine);
            let (sin, cos) = (0.5 * middle).sin_cos();
            let half_sum = q.k.atan2(q.w) - (sin * gap_cos).atan2(cos * sum_cos);
            let half_gap = q.j.atan2(q.i) - (sin * gap_sin).atan2(cos * sum_sin);
            // A plane vector without length has no direction: the first joint stands at zero then.
            let short = |square: f64| square.sqrt() < 0.5 * TOLERANCES.free;
            turned.free = short(inner) || short(outer);
            let all = match (short(inner), short(outer)) {
                (true, _) => [0.0, middle, 2.0 * half_sum],
                (_, true) => [0.0, middle, -2.0 * half_gap],
                _ => [half_sum + half_gap, middle, half_sum - half_gap],
            };
            turned.turns = std::array::from_fn(|i| back(all[i].sin_cos(), self.shifts[i]));
        }
        turns
    }

    /// Ways still without angles, one for each sine of the middle joint.
    #[inline]
    fn empty(&self, sines: &Roots, cosine: f64) -> Turns {
        let mut turns = Turns {
            list: [Turned {
                turns: [(0.0, 1.0); 3],
                flip: false,
                multiplicity: if sines.len == 1 { 2 } else { 1 },
                edge: sines.edge,
                free: false,
            }; 3],
            len: sines.len,
            shortfall: None,
        };
        if sines.len == 0 {
            let excess = cosine.abs().max(1.0) - 1.0;
            turns.shortfall = Some(Shortfall {
                part: Part::Orientation,
                amount: (2.0 * excess).sqrt().max(f64::MIN_POSITIVE),
            });
        }
        turns
    }
}

/// The rotations `(x1, x2, x3)` with `Rz(x1) Rx(+-90 deg) Rz(x2) Rx(+-90 deg) Rz(x3) = R`, both of them.
///
/// The orientation problem of an arm with a spherical wrist, `R_36 = R_03^T R_06`, by rotation matrices or by
/// quaternions (same answers): `signs` are those of the two right angles. Where the middle angle is 0 or pi only the
/// sum or difference of the outer ones is determined; then the first is 0 and both answers are equal.
///
/// ```
/// use nalgebra::{Matrix3, Rotation3, Vector3};
/// use pieper::ik::{Method, orientation};
/// let z = |x| Rotation3::from_axis_angle(&Vector3::z_axis(), x);
/// let x = |s: f64| Rotation3::from_axis_angle(&Vector3::x_axis(), s * std::f64::consts::FRAC_PI_2);
/// let r: Rotation3<f64> = z(0.3) * x(-1.0) * z(0.9) * x(1.0) * z(-1.2);
/// for method in [Method::Matrix, Method::Quaternion] {
///     let [first, _] = orientation(r.matrix(), [-1.0, 1.0], method);
///     assert!((first[0] - 0.3).abs() < 1e-12 && (first[1] - 0.9).abs() < 1e-12 && (first[2] + 1.2).abs() < 1e-12);
/// }
/// ```
pub fn orientation(r: &Matrix3<f64>, signs: [f64; 2], method: Method) -> [[f64; 3]; 2] {
    let ball = Ball::between(
        signs.map(|sign| (1.0_f64.copysign(sign), 0.0)),
        [(0.0, 1.0); 3],
    );
    let turns = ball.solve(r, 0.0, method);
    let last = turns.len.saturating_sub(1);
    let angle = |(sin, cos): (f64, f64)| super::angle::wrap(sin.atan2(cos));
    [turns.list[0], turns.list[last]].map(|turned| turned.turns.map(angle))
}
