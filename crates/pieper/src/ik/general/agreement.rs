//! One elimination that had no doubts at all, or several, until two agree and one of them had few.

use pulp::Simd;

use super::fold;
use super::newton::Goal;
use super::pool::{CAPACITY, MAX_ROOTS, Pool};
use super::siblings;
use super::single::Target;
use super::trial::MOST;
use super::{Completeness, General, Root, Roots};

/// Eliminations run at least to say that there is no root: of structured arms at right-angle poses two may agree on nothing.
pub(super) const LEAST_EMPTY: usize = 3;

/// An arm with an equation of its own is solved by that, unless too many places of it had to be looked at closely, or the
/// number of roots is odd. Otherwise runs eliminations in the arm's order. The evidence of completeness is one that is to be believed alone
/// (`Doubt::alone`), or that two of them found all that is there, and that one of the two saw nothing drown in its noise.
#[inline(always)]
pub(super) fn run<S: Simd>(
    simd: S,
    general: &General,
    goal: &Goal<'_>,
    target: &Target,
    out: &mut Roots,
) -> Completeness {
    let mut pool = Pool::new();
    let mut sigma = [0.0; CAPACITY];
    let (mut measured, mut run) = (0, 0);
    let (mut agreed, mut near_miss) = (false, false);
    let mut reports = [Report::default(); MOST + 1];
    if let Some(offset) = &general.offset {
        let doubt = offset
            .run(simd, &general.tables, goal, target, &mut pool)
            .doubt;
        // Of merged roots one is listed: where nothing was in doubt, an odd number is none either.
        let is_whole = |pool: &Pool| !doubt.drowned || pool.roots().is_multiple_of(2);
        if !doubt.near_miss && is_whole(&pool) {
            siblings::measure_new(simd, goal, &pool, 0, &mut sigma);
            if doubt.drowned && !siblings::paired(&pool, &sigma) {
                siblings::search(simd, goal, &mut pool, &mut sigma);
            }
            fold::ask(simd, goal, &mut pool, &mut sigma);
            pool.merge(&mut sigma);
            let singular = pool.open(&sigma) != 0;
            if singular || is_whole(&pool) {
                write(general, &pool, &sigma, out);
                return match singular {
                    true => Completeness::Singular { eliminations: 0 },
                    false => Completeness::Equation,
                };
            }
        }
        let (hit, clear) = (pool.hit, !doubt.drowned && !doubt.near_miss);
        reports[0] = Report { hit, clear };
        run = 1;
    }
    for elimination in &general.eliminations {
        let before = pool.count;
        pool.start();
        let doubt = elimination.run(simd, &general.tables, goal, target, &mut pool);
        near_miss |= doubt.near_miss;
        reports[run] = Report {
            hit: pool.hit,
            clear: !doubt.drowned,
        };
        run += 1;
        // Nothing is known that it missed.
        let is_all = pool.hit.count_ones() as usize == pool.count;
        if let Some(lone) = doubt.alone.filter(|_| is_all) {
            siblings::measure_new(simd, goal, &pool, measured, &mut sigma);
            let singular = pool.open(&sigma);
            if singular & lone == 0 {
                pool.merge(&mut sigma);
                write(general, &pool, &sigma, out);
                let eliminations = run as u8;
                return match singular {
                    0 => Completeness::Agreed { eliminations },
                    _ => Completeness::Singular { eliminations },
                };
            }
        }
        // A near-miss in one elimination may be two roots in another.
        if run < general.least + usize::from(near_miss) {
            continue;
        }
        siblings::measure_new(simd, goal, &pool, measured, &mut sigma);
        fold::ask(simd, goal, &mut pool, &mut sigma);
        if pool.merge(&mut sigma) {
            // The numbers of the roots have changed.
            reports = [Report::default(); MOST + 1];
            reports[run - 1].hit = pool.hit;
            reports[run - 1].clear = !doubt.drowned;
        }
        measured = pool.count;
        agreed = agree(&pool, &sigma, &reports[..run], pool.count > before)
            && (run >= general.least + EXTRA_SINGULAR || pool.open(&sigma) == 0);
        if agreed {
            break;
        }
    }
    siblings::measure_new(simd, goal, &pool, measured, &mut sigma);
    if !(agreed && siblings::paired(&pool, &sigma)) {
        siblings::search(simd, goal, &mut pool, &mut sigma);
    }
    fold::ask(simd, goal, &mut pool, &mut sigma);
    pool.merge(&mut sigma);
    let singular = pool.open(&sigma) != 0;
    write(general, &pool, &sigma, out);
    let eliminations = run as u8;
    let whole = pool.count <= MAX_ROOTS && pool.roots().is_multiple_of(2);
    if singular {
        Completeness::Singular { eliminations }
    } else if whole && agreed {
        Completeness::Agreed { eliminations }
    } else {
        Completeness::Doubtful { eliminations }
    }
}

/// Whether the eliminations agree on the roots that are not open: of those there may be new copies every time, they say nothing.
fn agree(pool: &Pool, sigma: &[f64; CAPACITY], reports: &[Report], grown: bool) -> bool {
    let open = pool.open(sigma);
    let listed = pool.listed();
    let (mut whole, mut clear) = (0, 0);
    for report in reports {
        if listed & !open & !report.hit == 0 {
            whole += 1;
            clear += usize::from(report.clear);
        }
    }
    if pool.count == 0 {
        return clear >= 2 && reports.len() >= LEAST_EMPTY;
    }
    let settled = open != 0 || (pool.roots().is_multiple_of(2) && !grown);
    settled && whole >= 2 && clear >= 1
}

/// What one elimination says.
#[derive(Clone, Copy, Default)]
struct Report {
    /// The roots that it found.
    hit: u64,
    /// Whether it rose above its noise everywhere.
    clear: bool,
}

/// Eliminations more than usual where a root is singular: its number says nothing there.
const EXTRA_SINGULAR: usize = 2;

/// Joints of the true arm.
fn write(general: &General, pool: &Pool, sigma: &[f64; CAPACITY], out: &mut Roots) {
    out.count = pool.count.min(MAX_ROOTS);
    for (index, root) in out.list[..out.count].iter_mut().enumerate() {
        let point = &pool.points[index];
        *root = Root {
            turns: std::array::from_fn(|joint| {
                let (sin, cos) = (point[6 + joint], point[joint]);
                if general.arm.slides[joint] {
                    (sin / general.arm.scale, 0.0)
                } else {
                    (sin, cos)
                }
            }),
            slides: general.arm.slides,
            residual: pool.errors[index] / general.arm.scale.min(1.0),
            sigma: sigma[index],
            multiplicity: pool.told[index].max(1),
            open: pool.is_open(sigma, index),
        };
    }
}
