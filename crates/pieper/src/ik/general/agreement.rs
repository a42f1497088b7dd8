//! Several eliminations, until two agree.

use pulp::Simd;

use super::newton::Goal;
use super::pool::{CAPACITY, MAX_ROOTS, Pool};
use super::siblings;
use super::single::Target;
use super::tolerances::TOLERANCES;
use super::{Completeness, General, Root, Roots};

/// Eliminations run at most.
pub(super) const MOST: usize = 12;
/// Eliminations that must agree on an empty set: of structured arms at right-angle poses two may agree on nothing.
pub(super) const LEAST_EMPTY: usize = 5;

/// Runs eliminations in the arm's order; the evidence of completeness is that one more finds exactly what is there.
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
    let mut measured = 0;
    let mut run = 0;
    let mut agreed = false;
    let (mut once, mut twice, mut quiet) = (0_u64, 0_u64, 0);
    for elimination in general.eliminations.iter().take(MOST) {
        let before = pool.count;
        pool.start();
        elimination.run(simd, &general.tables, goal, target, &mut pool);
        run += 1;
        (once, twice) = (once | pool.hit, twice | (once & pool.hit));
        quiet = if pool.count == before { quiet + 1 } else { 0 };
        // A near-miss in one elimination may be two roots in another.
        let least = general.least + usize::from(pool.unsure);
        if run < least || (pool.count == 0 && run < LEAST_EMPTY) {
            continue;
        }
        siblings::measure_new(simd, goal, &pool, measured, &mut sigma);
        let merged = pool.merge(&mut sigma);
        measured = pool.count;
        if merged {
            (once, twice) = (0, 0);
        }
        // Copies of a double root and members of a family say nothing: they may be new every time.
        let singular = pool.mask(&sigma, |s| s < TOLERANCES.doubles);
        let known = if merged { u64::MAX } else { (1 << before) - 1 };
        let regular = pool.mask(&sigma, |s| s >= TOLERANCES.doubles);
        let nothing_new = regular & !(pool.hit & known) == 0;
        agreed = if singular == 0 {
            let seen_twice = !merged && regular & !twice == 0 && quiet >= QUIET;
            (nothing_new || seen_twice) && pool.count.is_multiple_of(2)
        } else {
            nothing_new && run >= least + EXTRA_SINGULAR
        };
        if agreed {
            break;
        }
    }
    siblings::measure_new(simd, goal, &pool, measured, &mut sigma);
    if !(agreed && siblings::paired(&pool, &sigma)) {
        siblings::search(simd, goal, &mut pool, &mut sigma);
    }
    pool.merge(&mut sigma);
    let singular = pool.mask(&sigma, |s| s < TOLERANCES.doubles) != 0;
    write(general, &pool, &sigma, out);
    let eliminations = run as u8;
    let whole = pool.count <= MAX_ROOTS && pool.count.is_multiple_of(2);
    if singular {
        Completeness::Singular { eliminations }
    } else if whole && agreed {
        Completeness::Agreed { eliminations }
    } else {
        Completeness::Doubtful { eliminations }
    }
}

/// Where eliminations differ: so many in a row that add nothing agree, too, if every root was found twice by then.
const QUIET: usize = 3;

/// Eliminations more than usual where a root is singular: its number says nothing there.
const EXTRA_SINGULAR: usize = 2;

/// Joint angles of the true arm.
fn write(general: &General, pool: &Pool, sigma: &[f64; CAPACITY], out: &mut Roots) {
    out.count = pool.count.min(MAX_ROOTS);
    for (index, root) in out.list[..out.count].iter_mut().enumerate() {
        let point = &pool.points[index];
        *root = Root {
            q: std::array::from_fn(|joint| point[6 + joint].atan2(point[joint])),
            residual: pool.errors[index] / general.arm.scale.min(1.0),
            sigma: sigma[index],
        };
    }
}
