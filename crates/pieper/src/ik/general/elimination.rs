//! The linear elimination of joints a and b: six equations in the angles c, d, e, as a matrix of 6 x 9 harmonics.
//!
//! Both halves of the loop, `D(Rc Lc Rd Ld Re) v(Le)` and `D(Lb^-1 Rb^-1 La^-1 Ra^-1) v(Lf^-1)`, are linear in the
//! harmonics (1, cos, sin) of their joints. N, the left null space of what goes with a and b, depends on the arm
//! alone, and so does everything but `D` of the one link that holds the target: per target the matrix is one product
//! `S T` with T constant. (Raghavan and Roth 1993; the split into constant and target parts follows Manocha and
//! Canny, IEEE Trans. Robotics and Automation 10(5), 1994.)

use nalgebra::SMatrix;
use pulp::Simd;

use super::cycle::{Case, Slot};
use super::line::{self, Line, SIZE};
use super::random::Random;
use crate::ik::lanes::{Lane, Rigid};
use crate::spatial::Pose;

/// Equations, columns (harmonics of d times harmonics of e), harmonics of one angle.
pub(super) const ROWS: usize = 6;
pub(super) const COLUMNS: usize = 9;
const HARMONICS: usize = 3;
/// Entries of a block of three columns, padded to whole registers.
pub(super) const BLOCK: usize = 24;

/// The matrix `M0 + cos c Mc + sin c Ms`: for each harmonic of c and each of the resultant's unknown (d, or e if they are
/// swapped) a block, column by column; its columns are the harmonics of the other one.
pub(super) type Harmonics = [[[f64; BLOCK]; HARMONICS]; HARMONICS];

/// Room for the product `S T`, at most 216 numbers with its padding; a power of two, so that a mask keeps within it.
const PRODUCT: usize = 256;
/// Most rows of S.
const MOST_ROWS: usize = 9;
/// Lanes are padded to a multiple of this.
const PAD: usize = 8;

/// The target-independent part of one elimination.
#[derive(Clone, Debug)]
pub(super) struct Linear {
    slot: Slot,
    /// Whether the outer and the inner of d and e slide.
    sliding: [bool; 2],
    /// The rows S before the target acts on them.
    rows: Vec<Line>,
    /// T: 15 rows of `width` numbers.
    fixed: Vec<f64>,
    width: usize,
    /// Where the entries of the matrix lie in the product.
    places: Box<[[[u8; BLOCK]; HARMONICS]; HARMONICS]>,
    /// What the constant part of the other half contributes.
    constant: [f64; ROWS],
    /// The motion that perturbs the target's link.
    perturbed: Pose,
    /// Whether d and e have exchanged their roles.
    swapped: bool,
}

impl Linear {
    /// Prepares the elimination `case` for the loop's links, the target's being ignored; `links` are perturbed by
    /// up to `delta` on the way.
    pub(super) fn new(
        case: Case,
        links: &[Pose; 6],
        slides: &[bool; 6],
        delta: f64,
        random: &mut Random,
    ) -> Self {
        let slides = case.joints().map(|joint| slides[joint]);
        let mut of = case.links(links);
        for link in &mut of {
            *link *= random.motion(delta);
        }
        let perturbed = random.motion(delta);
        let (nulls, constant) = null_space(&of, &slides, case.slot, random);
        let (left, right) = halves(&of, &slides, case.place(), nulls);
        let (rows, columns) = match case.slot {
            Slot::B => (left, right),
            _ => (right, left),
        };
        let width = columns.len().next_multiple_of(PAD);
        let mut fixed = vec![0.0; SIZE * width];
        for (lane, column) in columns.iter().enumerate() {
            for (j, &entry) in column.iter().enumerate() {
                fixed[j * width + lane] = entry;
            }
        }
        Self {
            slot: case.slot,
            sliding: [slides[3], slides[4]],
            rows,
            fixed,
            width,
            places: places_of(case.slot, width, false),
            constant,
            perturbed,
            swapped: false,
        }
    }

    /// The matrix for a target, whose link in the loop is `link`.
    #[inline(always)]
    pub(super) fn matrix<S: Simd>(&self, simd: S, link: &Pose) -> Harmonics {
        let motion = line::motion(&Rigid::of(&(link * self.perturbed)));
        let mut product = [0.0; PRODUCT];
        let mut moved = [[0.0; SIZE]; MOST_ROWS];
        for (to, from) in moved.iter_mut().zip(&self.rows) {
            *to = match self.slot {
                Slot::B => line::act_on_row(from, &motion),
                _ => line::act(&motion, from),
            };
        }
        for (row, out) in moved[..self.rows.len()]
            .iter()
            .zip(product.chunks_exact_mut(self.width))
        {
            for register in 0..self.width / S::F64_LANES {
                let mut sum = Lane::splat(simd, 0.0);
                for (j, &factor) in row.iter().enumerate() {
                    let fixed = &self.fixed[j * self.width..(j + 1) * self.width];
                    sum = Lane::splat(simd, factor).mul_add(Lane::load(simd, fixed, register), sum);
                }
                sum.store(out, register);
            }
        }
        let mut matrix = [[[0.0; BLOCK]; HARMONICS]; HARMONICS];
        for h in 0..HARMONICS {
            for outer in 0..HARMONICS {
                for k in 0..HARMONICS * ROWS {
                    matrix[h][outer][k] = product[usize::from(self.places[h][outer][k])];
                }
            }
        }
        for k in 0..ROWS {
            matrix[0][0][k] -= self.constant[k];
        }
        if self.sliding != [false; 2] {
            self.half_angles(&mut matrix);
        }
        matrix
    }

    /// From powers of a slide x to harmonics of twice its arc tangent, but for a factor of 1 + x^2: `1 = (1 + cos)/2`,
    /// `x = sin/2`, `x^2 = (1 - cos)/2`.
    #[cold]
    fn half_angles(&self, matrix: &mut Harmonics) {
        let turned =
            |[one, x, square]: [f64; 3]| [0.5 * (one + square), 0.5 * (one - square), 0.5 * x];
        for of_c in matrix {
            for k in 0..HARMONICS * ROWS {
                if self.sliding[0] {
                    let powers = [of_c[0][k], of_c[1][k], of_c[2][k]];
                    for (outer, value) in turned(powers).into_iter().enumerate() {
                        of_c[outer][k] = value;
                    }
                }
            }
            for block in of_c {
                for i in 0..ROWS {
                    if self.sliding[1] {
                        let powers = [block[i], block[ROWS + i], block[2 * ROWS + i]];
                        for (inner, value) in turned(powers).into_iter().enumerate() {
                            block[inner * ROWS + i] = value;
                        }
                    }
                }
            }
        }
    }

    /// Exchanges the roles of d and e.
    pub(super) fn swap(&mut self, swapped: bool) {
        self.places = places_of(self.slot, self.width, swapped);
        if swapped != self.swapped {
            self.sliding.reverse();
            self.swapped = swapped;
        }
    }
}

/// Where the entries lie: rows of S count the factors right of the target, lanes of T those left of it; for slot B
/// the other way round.
fn places_of(
    slot: Slot,
    width: usize,
    swapped: bool,
) -> Box<[[[u8; BLOCK]; HARMONICS]; HARMONICS]> {
    let place = |h: usize, i: usize, d: usize, e: usize| {
        let (row, lane) = match slot {
            Slot::B => (i, 9 * h + 3 * d + e),
            Slot::C => (3 * d + e, ROWS * h + i),
            Slot::D => (e, ROWS * (3 * h + d) + i),
            Slot::E => (0, ROWS * (9 * h + 3 * d + e) + i),
        };
        (row * width + lane) as u8
    };
    let mut places = Box::new([[[0; BLOCK]; HARMONICS]; HARMONICS]);
    for h in 0..HARMONICS {
        for outer in 0..HARMONICS {
            for k in 0..HARMONICS * ROWS {
                let (inner, i) = (k / ROWS, k % ROWS);
                let (d, e) = if swapped {
                    (inner, outer)
                } else {
                    (outer, inner)
                };
                places[h][outer][k] = place(h, i, d, e);
            }
        }
    }
    places
}

/// N as rows, and `N q0`, q0 the constant part of the half with joints a and b.
fn null_space(
    of: &[Pose; 6],
    slides: &[bool; 6],
    slot: Slot,
    random: &mut Random,
) -> (Vec<Line>, [f64; ROWS]) {
    let motion = |pose: &Pose| line::motion(&Rigid::of(pose));
    let start = line::act(&motion(&of[5].inverse()), &line::Z_AXIS);
    // The turns are by -a and -b: only the span of the columns matters, so the sign may be dropped.
    let mut terms: Vec<Line> = line::harmonics(&start, slides[0]).to_vec();
    let la = motion(&of[0].inverse());
    terms = terms
        .iter()
        .flat_map(|term| line::harmonics(&line::act(&la, term), slides[1]))
        .collect();
    if slot != Slot::B {
        let lb = motion(&of[1].inverse());
        terms = terms.iter().map(|term| line::act(&lb, term)).collect();
    }
    let q = SMatrix::<f64, 14, 14>::from_fn(|i, j| if j < 8 { terms[j + 1][i] } else { 0.0 });
    // Without convergence the elimination finds nothing, and the trial passes it over.
    let decomposed = q.try_svd(true, false, f64::EPSILON, SVD_STEPS);
    let Some((svd, u)) = decomposed.and_then(|svd| svd.u.map(|u| (svd, u))) else {
        return (vec![[0.0; SIZE]; ROWS], [0.0; ROWS]);
    };
    let mut order: Vec<usize> = (0..14).collect();
    order.sort_by(|&a, &b| svd.singular_values[b].total_cmp(&svd.singular_values[a]));
    let rank = order
        .iter()
        .filter(|&&k| svd.singular_values[k] > RANK * svd.singular_values[order[0]])
        .count()
        .min(8);
    let free: Vec<Line> = order[rank..]
        .iter()
        .map(|&k| std::array::from_fn(|i| if i < 14 { u[(i, k)] } else { 0.0 }))
        .collect();
    let nulls = if free.len() == ROWS {
        free
    } else {
        mixed(&free, random)
    };
    let constant = std::array::from_fn(|i| {
        let (null, q0) = (&nulls[i], &terms[0]);
        (0..14).map(|j| null[j] * q0[j]).sum()
    });
    (nulls, constant)
}

/// Far more steps than a matrix of this size takes.
const SVD_STEPS: usize = 1000;

/// A singular value of the linear part below this, relative, is rounding: the arm's own are zero or of the order of the
/// perturbation, at least 1e-7.
const RANK: f64 = 1e-13;

/// Six random orthonormal combinations: with more null vectors than needed, the first six would be an unlucky choice
/// for structured arms.
fn mixed(free: &[Line], random: &mut Random) -> Vec<Line> {
    let mut out: Vec<Line> = Vec::new();
    while out.len() < ROWS {
        let mut row = [0.0; SIZE];
        for vector in free {
            let factor = random.signed();
            for (entry, add) in row.iter_mut().zip(vector) {
                *entry += factor * add;
            }
        }
        for _ in 0..2 {
            for earlier in &out {
                let along: f64 = row.iter().zip(earlier).map(|(a, b)| a * b).sum();
                for (entry, e) in row.iter_mut().zip(earlier) {
                    *entry -= along * e;
                }
            }
        }
        let norm = row.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        out.push(row.map(|entry| entry / norm));
    }
    out
}

/// What stands left and right of the target's link, as lines with a harmonic index each (the last joint fastest; for
/// the left the row of N is fastest).
fn halves(
    of: &[Pose; 6],
    slides: &[bool; 6],
    target: usize,
    nulls: Vec<Line>,
) -> (Vec<Line>, Vec<Line>) {
    let motion = |place: usize| line::motion(&Rigid::of(&of[place]));
    let mut left = nulls;
    for place in 2..=target {
        // The harmonics of one joint more become the slower index of the rows.
        let split: Vec<[Line; 3]> = left
            .iter()
            .map(|row| line::row_harmonics(row, slides[place]))
            .collect();
        left = split
            .chunks(ROWS)
            .flat_map(|block| (0..3).flat_map(move |h| block.iter().map(move |parts| parts[h])))
            .collect();
        if place < target {
            let d = motion(place);
            left = left.iter().map(|row| line::act_on_row(row, &d)).collect();
        }
    }
    let mut right = vec![line::Z_AXIS];
    for place in (target + 1..=4).rev() {
        let d = motion(place);
        right = right.iter().map(|term| line::act(&d, term)).collect();
        let split: Vec<[Line; 3]> = right
            .iter()
            .map(|term| line::harmonics(term, slides[place]))
            .collect();
        right = (0..3)
            .flat_map(|h| split.iter().map(move |parts| parts[h]))
            .collect();
    }
    (left, right)
}
