//! Which eliminations an arm is solved by: all are tried on random reachable poses.

use pulp::{Simd, WithSimd};

use super::Scaled;
use super::cycle::{CASES, Case};
use super::elimination::Linear;
use super::newton::Goal;
use super::offset::Offset;
use super::orientation::Orientation;
use super::pool::Pool;
use super::random::Random;
use super::resultant::{Form, SHIFTS};
use super::single::{Elimination, Target};
use super::tables::Tables;
use super::way::Way;
use crate::error::{Error, Result};
use crate::ik::lanes::Rigid;
use crate::spatial::Pose;

/// Poses on which the eliminations are tried.
const POSES: usize = 24;
/// Poses on which the form of the resultant is chosen.
const FORM_POSES: usize = 3;
/// Perturbations of the linear part. None is best for general arms; the others split the degeneracies of structured ones:
/// less drowns them in rounding, which grows with its inverse square, more moves close roots together.
const DELTAS: [f64; 3] = [0.0, 1e-7, 1e-6];
/// The perturbation of the eliminations with twice the digits: the matrix is rounded to doubles, which is noise of 1e-16
/// over it.
const PRECISE_DELTA: f64 = 1e-8;
/// Seeds of the test poses and of the perturbations.
const POSE_SEED: u64 = 0x6b69_6e65;
const MOTION_SEED: u64 = 0x7069_6570;

/// Eliminations in ordinary numbers that are kept.
const CHOSEN: usize = 3;

/// Eliminations of an arm at most: those, then all with twice the digits, or for two slides all others.
pub(super) const MOST: usize = CHOSEN + CASES.len();

/// Chooses eliminations and how many of them are run at least.
pub(super) struct Trial<'a> {
    pub(super) arm: &'a Scaled,
    pub(super) tables: &'a Tables,
}

/// What an arm is solved by.
pub(super) struct Chosen {
    /// In the order in which they are run.
    pub(super) ways: Vec<Way>,
    /// How many are run at least.
    pub(super) least: usize,
    /// The equation without elimination, if the arm has one.
    pub(super) offset: Option<Box<Offset>>,
}

/// An elimination and what it found.
struct Score {
    way: Way,
    /// For each pose the members of the union found.
    found: [u64; POSES],
    /// Whether it would have been believed alone.
    alone: [bool; POSES],
    /// The perturbation or the usual noise of the polynomial, whichever is larger.
    blur: f64,
}

impl WithSimd for Trial<'_> {
    type Output = Result<Chosen>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let targets = self.poses(simd)?;
        let mut random = Random::new(MOTION_SEED);
        let mut scores = Vec::new();
        let mut pools = vec![Pool::new(); POSES];
        for delta in DELTAS {
            for way in self.ways(simd, delta, &targets, &mut random) {
                let (mut found, mut noise) = ([0; POSES], [0.0; POSES]);
                let mut alone = [false; POSES];
                for (p, target) in targets.iter().enumerate() {
                    pools[p].start();
                    let goal = self.goal(target);
                    let doubt = way.run(simd, self.tables, &goal, target, &mut pools[p]);
                    (found[p], noise[p]) = (pools[p].hit, doubt.noise);
                    alone[p] = doubt.alone.is_some();
                }
                noise.sort_by(f64::total_cmp);
                scores.push(Score {
                    blur: noise[POSES / 2].max(delta),
                    way,
                    found,
                    alone,
                });
            }
        }
        for score in &mut scores {
            let missed = |p: usize| score.found[p].count_ones() < pools[p].count as u32;
            if (0..POSES).any(|p| score.alone[p] && missed(p)) {
                score.way.disbelieve();
            }
        }
        let (chosen, mut rest, least) = choose(scores, &pools);
        let mut ways: Vec<Way> = chosen.into_iter().map(|score| score.way).collect();
        if self.two_slides() {
            rest.sort_by_key(|score| {
                std::cmp::Reverse(score.found.iter().map(|f| f.count_ones()).sum::<u32>())
            });
            ways.extend(rest.into_iter().map(|score| score.way));
        } else {
            for case in self.cases() {
                let elimination = self.build(simd, case, PRECISE_DELTA, &targets, &mut random);
                ways.push(Way::Resultant(Box::new(Elimination {
                    precise: true,
                    ..elimination
                })));
            }
        }
        let offset = self.offset(simd, &targets, &pools);
        Ok(Chosen {
            ways,
            least,
            offset,
        })
    }
}

impl Trial<'_> {
    fn two_slides(&self) -> bool {
        self.arm.slides.iter().filter(|&&slides| slides).count() == 2
    }

    fn cases(&self) -> impl Iterator<Item = Case> + use<> {
        let slides = self.arm.slides;
        CASES.into_iter().filter(move |case| case.takes(&slides))
    }

    /// The equation of an offset wrist, if it finds what all eliminations together found: of arms that are more special
    /// yet, it may have double roots only.
    #[inline(always)]
    fn offset<S: Simd>(&self, simd: S, targets: &[Target], pools: &[Pool]) -> Option<Box<Offset>> {
        if self.arm.slides.contains(&true) {
            return None;
        }
        let offset = Box::new(Offset::new(&self.arm.poses)?);
        let (mut sure, mut wrong) = (0, 0);
        for (target, known) in targets.iter().zip(pools) {
            let mut pool = Pool::new();
            let goal = self.goal(target);
            let found = offset.run(simd, self.tables, &goal, target, &mut pool);
            if !found.doubt.drowned && !found.doubt.near_miss && found.pairs == 0 {
                sure += 1;
                wrong += usize::from(pool.count != known.count);
            }
        }
        (2 * sure > POSES && wrong == 0).then_some(offset)
    }

    /// Every way with this perturbation.
    #[inline(always)]
    fn ways<S: Simd>(
        &self,
        simd: S,
        delta: f64,
        targets: &[Target],
        random: &mut Random,
    ) -> Vec<Way> {
        if !self.two_slides() {
            let build = |case| self.build(simd, case, delta, targets, random);
            return self
                .cases()
                .map(build)
                .map(|elimination| Way::Resultant(Box::new(elimination)))
                .collect();
        }
        (0..6)
            .filter_map(|kept| {
                Orientation::new(kept, &self.arm.slides, &self.loop_links(), delta, random)
            })
            .map(|orientation| Way::Orientation(Box::new(orientation)))
            .collect()
    }

    /// The links of the loop, the last one without the target.
    fn loop_links(&self) -> [Pose; 6] {
        let link = |i: usize| self.arm.poses.get(i).copied();
        std::array::from_fn(|i| link(i).unwrap_or_else(Pose::identity))
    }

    /// Reachable poses; an error if the arm is singular at all of them.
    #[inline(always)]
    fn poses<S: Simd>(&self, simd: S) -> Result<Vec<Target>> {
        let mut random = Random::new(POSE_SEED);
        let mut regular = 0.0_f64;
        let mut targets = Vec::with_capacity(POSES);
        for _ in 0..POSES {
            let q: [f64; 6] = std::array::from_fn(|joint| {
                let half = if self.arm.slides[joint] {
                    super::TOTAL / 2.0
                } else {
                    std::f64::consts::PI
                };
                random.signed() * half
            });
            let target = Target::new(self.arm.forward(&q));
            let mut pool = Pool::new();
            let point = std::array::from_fn(|k| match (k < 6, self.arm.slides[k % 6]) {
                (true, true) => 1.0,
                (true, false) => q[k].cos(),
                (false, true) => q[k - 6],
                (false, false) => q[k - 6].sin(),
            });
            pool.insert(&point, 0.0, 0);
            let mut sigma = [0.0; super::pool::CAPACITY];
            let goal = self.goal(&target);
            super::siblings::measure_new(simd, &goal, &pool, 0, &mut sigma);
            regular = regular.max(sigma[0]);
            targets.push(target);
        }
        if regular < SINGULAR_ARM {
            let text = format!(
                "it is singular everywhere: some motion of the joints leaves the tool where it is \
                 (largest smallest singular value {regular:.1e} at {POSES} random configurations)"
            );
            return Err(Error::model("arm", text));
        }
        Ok(targets)
    }

    fn goal(&self, target: &Target) -> Goal<'_> {
        Goal {
            links: &self.arm.links,
            slides: &self.arm.slides,
            target: Rigid::of(&target.pose),
        }
    }

    /// Builds an elimination in its best form: the mean logarithm of the pivot ratio over a few poses decides.
    #[inline(always)]
    fn build<S: Simd>(
        &self,
        simd: S,
        case: Case,
        delta: f64,
        targets: &[Target],
        random: &mut Random,
    ) -> Elimination {
        let loop_links = self.loop_links();
        let of = case.links(&loop_links);
        let mut links = of.each_ref().map(Rigid::of);
        links[5] = Rigid::of(&of[5].inverse());
        let form = Form {
            swapped: false,
            shift: 0,
        };
        let mut best = Elimination {
            case,
            precise: false,
            exact: delta == 0.0,
            form,
            linear: Linear::new(case, &loop_links, &self.arm.slides, delta, random),
            links,
            slides: case.joints().map(|joint| self.arm.slides[joint]),
        };
        let mut best_score = f64::NEG_INFINITY;
        let mut best_form = form;
        for swapped in [false, true] {
            for shift in 0..SHIFTS.len() {
                best.set_form(Form { swapped, shift });
                let score: f64 = targets[..FORM_POSES]
                    .iter()
                    .map(|target| best.conditioning(simd, self.tables, target).max(1e-30).ln())
                    .sum();
                if score > best_score {
                    (best_score, best_form) = (score, best.form);
                }
            }
        }
        best.set_form(best_form);
        best
    }
}

/// Below this at every random configuration an arm counts as singular everywhere: rounding gives some 1e-16, arms that
/// move in all directions reach 1e-2.
const SINGULAR_ARM: f64 = 1e-9;

/// Share of the roots that a factor of ten in the blur is worth: eliminations differ by less only by chance.
const BLUR_COST: f64 = 0.0003;

/// Greedy: the first finds most, each further one most together with the ones before, with another kept joint preferred.
fn choose(mut scores: Vec<Score>, pools: &[Pool]) -> (Vec<Score>, Vec<Score>, usize) {
    let total: u32 = pools.iter().map(|pool| pool.count as u32).sum();
    let mut chosen: Vec<Score> = Vec::new();
    let mut union = [0_u64; POSES];
    while chosen.len() < CHOSEN && !scores.is_empty() {
        let value = |score: &Score| {
            let covered: u32 = (0..POSES)
                .map(|p| (union[p] | score.found[p]).count_ones())
                .sum();
            let own: u32 = score.found.iter().map(|f| f.count_ones()).sum();
            let share = |count: u32| f64::from(count) / f64::from(total.max(1));
            let repeated = chosen.iter().any(|c| c.way.kept() == score.way.kept());
            let cost = BLUR_COST * (score.blur + f64::EPSILON).log10();
            share(covered) + share(own) - cost - if repeated { 0.5 } else { 0.0 }
        };
        let mut best = 0;
        for index in 1..scores.len() {
            if value(&scores[index]) > value(&scores[best]) {
                best = index;
            }
        }
        let next = scores.remove(best);
        for p in 0..POSES {
            union[p] |= next.found[p];
        }
        chosen.push(next);
    }
    let least = least(&chosen, pools);
    (chosen, scores, least)
}

/// The smallest number of first eliminations, from 2 to 3, by which every root is found twice; 4 otherwise.
fn least(chosen: &[Score], pools: &[Pool]) -> usize {
    for count in 2..=chosen.len() {
        let twice = (0..POSES).all(|p| {
            (0..pools[p].count).all(|root| {
                let times = chosen[..count]
                    .iter()
                    .filter(|c| (c.found[p] >> root) & 1 == 1)
                    .count();
                times >= 2
            })
        });
        if twice {
            return count;
        }
    }
    4
}
