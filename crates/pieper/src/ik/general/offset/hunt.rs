//! From the candidates of the polynomial to all solutions, or the knowledge that some may be missing: every root and every pair of them
//! claims the solutions to which it leads.

use pulp::Simd;

use super::finish::{Close, Finish, Followed, Polish};
use super::magnify::{Magnify, Search, Spots};
use super::pair::Pair;
use super::zoom::{self, Sight, Windows, Zoom};
use crate::ik::general::isolate::{CANDIDATES, Candidates};
use crate::ik::general::list::List;
use crate::ik::general::polynomial::Sampled;
use crate::ik::general::pool::{CAPACITY, Pool};
use crate::ik::general::tables::Tables;
use crate::ik::general::tolerances::TOLERANCES;

/// What is known of one target so far.
pub(super) struct Hunt<'a> {
    finish: &'a Finish<'a>,
    pool: &'a mut Pool,
    followed: Followed,
    /// How many of the roots that were followed are the polynomial's.
    polished: usize,
    /// Where the equation has to be looked at closely.
    windows: Windows,
    /// Tops of the polynomial's pairs, and the bits of their solutions.
    pairs: List<(f64, u64), CANDIDATES>,
    sight: Sight,
    claims: Claims,
}

/// The solutions to which roots and pairs of them lead: none is led to by two of them.
struct Claims {
    bits: u64,
    disjoint: bool,
    /// Every root led to its solutions.
    met: bool,
}

/// Radians: how well the polynomial knows the top of a pair. If it is farther away there is something else near.
const AT_TOP: f64 = 1e-5;
/// Radians: how far to the sides of a pair that was not told apart its roots are sought.
const BESIDE: f64 = 1e-2;

impl<'a> Hunt<'a> {
    pub(super) fn new(finish: &'a Finish<'a>, pool: &'a mut Pool, candidates: &Candidates) -> Self {
        Self {
            finish,
            pool,
            followed: Followed::new(),
            polished: 0,
            windows: zoom::drowned(candidates),
            pairs: List::new(),
            sight: Sight::new(),
            claims: Claims::new(),
        }
    }

    /// Follows the roots of the polynomial.
    #[inline(always)]
    pub(super) fn polish<S: Simd>(
        &mut self,
        simd: S,
        tables: &Tables,
        sampled: &Sampled,
        candidates: &Candidates,
    ) {
        for register in 0..candidates.count.div_ceil(S::F64_LANES) {
            simd.vectorize(Polish {
                finish: self.finish,
                tables,
                sampled,
                candidates,
                register,
                pool: self.pool,
                followed: &mut self.followed,
                windows: &mut self.windows,
            });
        }
        self.polished = self.followed.count;
    }

    /// Tells the polynomial's pairs apart; those that it does not tell, and whatever was found by the way, are to be looked at closely.
    #[inline(always)]
    pub(super) fn tell_pairs<S: Simd>(&mut self, simd: S, candidates: &Candidates) {
        let offset = self.finish.offset;
        let mut known = self.followed.bits();
        for &top in &candidates.pairs[..candidates.pair_count] {
            let (told, bits) = self.tell(simd, top, AT_TOP);
            // What belongs to others, or to where others look, was not told of this one.
            let is_own = |index: usize| {
                let angle = offset.kept(&self.pool.points[index]);
                self.windows.hold(angle) == self.windows.hold(top)
            };
            if told && bits & known == 0 && ones(bits).all(is_own) {
                self.pairs.push((top, bits));
            } else {
                self.windows.add_around(top, BESIDE);
            }
            known |= bits;
        }
        // What was found by the way may belong to a root that was not seen.
        let pairs = self.pairs.iter().fold(0, |all, (_, bits)| all | bits);
        for stray in ones(self.pool.listed() & !(self.followed.bits() | pairs)) {
            let angle = offset.kept(&self.pool.points[stray]);
            self.windows.add_around(angle, BESIDE);
        }
    }

    /// Whether a pair is told apart, and the bits of its solutions.
    #[inline(always)]
    fn tell<S: Simd>(&mut self, simd: S, top: f64, within: f64) -> (bool, u64) {
        let before = std::mem::take(&mut self.pool.hit);
        let told = simd.vectorize(Pair {
            finish: self.finish,
            top,
            within,
            pool: self.pool,
        });
        let bits = self.pool.hit;
        self.pool.hit |= before;
        (told, bits)
    }

    /// Looks into the windows, and follows what is seen there.
    #[inline(always)]
    pub(super) fn look_closely<S: Simd>(&mut self, simd: S) {
        let offset = self.finish.offset;
        if !self.windows.is_empty() {
            simd.vectorize(Zoom {
                equation: self.finish.equation,
                symmetric: offset.symmetric,
                tables: &offset.local,
                windows: &self.windows,
                sight: &mut self.sight,
            });
            for index in 0..self.sight.tops.len() {
                let top = self.sight.tops[index];
                let within = TOLERANCES.moved.min(0.5 * self.sight.nearest(index));
                let (told, bits) = self.tell(simd, top, within);
                self.claims.add(bits);
                if !told {
                    self.sight.dark.push((top - BESIDE, top + BESIDE));
                }
            }
            for register in 0..self.sight.roots.len().div_ceil(S::F64_LANES) {
                self.claims.met &= simd.vectorize(Close {
                    finish: self.finish,
                    roots: &self.sight.roots,
                    register,
                    pool: self.pool,
                    followed: &mut self.followed,
                });
            }
        }
        // Those in windows were seen again there.
        for &(top, bits) in self.pairs.iter() {
            if !self.windows.hold(top) {
                self.claims.add(bits);
            }
        }
    }

    /// Whether all solutions were found: two roots that lead to the same one are one root found twice, and another lost; an odd number of
    /// them, and one was not seen; and what nobody claims belongs to a root that was not seen.
    pub(super) fn is_whole(&mut self) -> bool {
        let is_seen = |k: usize, angle: f64| {
            if k < self.polished {
                !self.windows.hold(angle)
            } else {
                self.sight.roots[k - self.polished].inside
            }
        };
        let (roots, bits) = self.followed.count(is_seen);
        self.claims.add(bits.unwrap_or_default());
        let claimed = bits.is_some() && self.claims.met && self.claims.disjoint;
        let seen = self.sight.is_clear() && !self.windows.overflowed && !self.followed.unsure;
        seen && claimed && self.claims.bits == self.pool.hit && roots.is_multiple_of(2)
    }

    /// Tries everything at the places that are known, and at what else is found in the windows.
    #[inline(always)]
    pub(super) fn search<S: Simd>(&mut self, simd: S, candidates: &Candidates) {
        let angles = self.followed.angles[..self.followed.count].iter();
        let tops = candidates.pairs[..candidates.pair_count].iter();
        let mut spots = Spots::new(angles.chain(tops).chain(self.sight.tops.iter()).copied());
        for windows in [&self.sight.dark, &self.windows] {
            simd.vectorize(Magnify {
                equation: self.finish.equation,
                symmetric: self.finish.offset.symmetric,
                windows,
                spots: &mut spots,
            });
        }
        for register in 0..spots.count.div_ceil(S::F64_LANES) {
            simd.vectorize(Search {
                finish: self.finish,
                spots: &spots,
                register,
                pool: self.pool,
            });
        }
    }
}

impl Claims {
    fn new() -> Self {
        Self {
            bits: 0,
            disjoint: true,
            met: true,
        }
    }

    fn add(&mut self, bits: u64) {
        self.disjoint &= self.bits & bits == 0;
        self.bits |= bits;
    }
}

/// The places of the ones.
fn ones(bits: u64) -> impl Iterator<Item = usize> {
    (0..CAPACITY).filter(move |index| (bits >> index) & 1 == 1)
}
