//! Arms with an offset wrist: their equation against the elimination, which knows nothing of it.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector3;
use pieper::ik::general::{Completeness, General, Root, Roots};
use pieper::spatial::{self, Pose};

/// Standard Denavit-Hartenberg rows as (d, a, alpha).
fn links(rows: &[(f64, f64, f64); 6]) -> [Pose; 6] {
    rows.map(|(d, a, alpha)| {
        spatial::shift(Vector3::new(a, 0.0, d))
            * spatial::turn(&Vector3::x_axis(), spatial::sin_cos_exact(alpha))
    })
}

fn forward(links: &[Pose; 6], q: &[f64; 6]) -> Pose {
    links
        .iter()
        .zip(q)
        .fold(Pose::identity(), |pose, (link, &q)| {
            pose * spatial::turn(&Vector3::z_axis(), q.sin_cos()) * link
        })
}

/// A random arm with an offset wrist: half of them with right angles and many lengths zero, half of them seen from the
/// tool; axis 5 meets either neighbour. The other table is the same arm with axes 2 and 3 off parallel by `twist`.
fn arm(random: &mut fastrand::Rng, twist: f64) -> [[Pose; 6]; 2] {
    let right = random.bool();
    let signed = |random: &mut fastrand::Rng| 2.0 * random.f64() - 1.0;
    let mut rows: [(f64, f64, f64); 6] = std::array::from_fn(|_| {
        let mut length = || match right && random.bool() {
            true => 0.0,
            false => 2.0 * random.f64() - 1.0,
        };
        let (d, a) = (length(), length());
        let alpha = match right {
            true => FRAC_PI_2.copysign(signed(random)),
            false => PI * signed(random),
        };
        (d, a, alpha)
    });
    rows[1] = (
        rows[1].0,
        signed(random),
        if random.bool() { PI } else { 0.0 },
    );
    // Not on axis 3: the elbow would be a second shoulder.
    rows[2].1 = 0.5 * signed(random);
    rows[if random.bool() { 3 } else { 4 }].1 = 0.0;
    let mirrored = random.bool();
    [0.0, twist].map(|twist| {
        let mut rows = rows;
        rows[1].2 += twist;
        let mut links = links(&rows);
        if mirrored {
            let seen = links;
            for (index, link) in links.iter_mut().take(5).enumerate() {
                *link = seen[4 - index].inverse();
            }
        }
        links
    })
}

fn distance(root: &Root, q: &[f64; 6]) -> f64 {
    root.q().iter().zip(q).fold(0.0, |most, (a, b)| {
        let turns = (a - b) / TAU;
        most.max((turns - turns.round()).abs() * TAU)
    })
}

#[test]
fn the_equation_finds_what_the_elimination_finds() {
    let mut random = fastrand::Rng::with_seed(41);
    let (mut arms, mut targets, mut by_equation, mut compared) = (0, 0, 0, 0);
    for _ in 0..60 {
        // Beyond rounding: the second arm has no equation.
        let [exact, off] = arm(&mut random, 1e-10).map(|links| {
            let general = General::prepare(&links).unwrap();
            (links, general)
        });
        assert!(!off.1.has_equation());
        if !exact.1.has_equation() {
            continue;
        }
        arms += 1;
        for _ in 0..50 {
            let q: [f64; 6] = std::array::from_fn(|_| PI * (2.0 * random.f64() - 1.0));
            let target = forward(&exact.0, &q);
            let (mut found, mut other) = (Roots::default(), Roots::default());
            let how = exact.1.solve(&target, &mut found);
            assert!(found.iter().any(|root| distance(root, &q) < 1e-7), "{q:?}");
            targets += 1;
            if how != Completeness::Equation {
                continue;
            }
            by_equation += 1;
            // The second arm's solutions are the first one's, but for what the twist moves them by: far from singularities
            // they must be the same ones.
            let agreed = matches!(
                off.1.solve(&target, &mut other),
                Completeness::Agreed { .. }
            );
            if !agreed
                || found
                    .iter()
                    .chain(other.iter())
                    .any(|root| root.sigma < 1e-4)
            {
                continue;
            }
            compared += 1;
            assert_eq!(found.len(), other.len(), "{q:?}");
            for root in found.iter() {
                let near = |one: &&Root| distance(root, &one.q()) < 1e-5;
                assert_eq!(other.iter().filter(near).count(), 1, "{q:?}");
            }
        }
    }
    assert!(arms >= 50, "{arms} arms");
    assert!(10 * by_equation > 8 * targets, "{by_equation} of {targets}");
    assert!(
        10 * compared > 8 * by_equation,
        "{compared} of {by_equation}"
    );
}

#[test]
fn arms_that_are_more_special_yet_are_left_to_the_elimination() {
    let h = FRAC_PI_2;
    // Three parallel axes; and axis 5 meeting axis 4 on axis 3.
    for rows in [
        [
            (0.1, 0.0, h),
            (0.0, -0.4, 0.0),
            (0.0, -0.4, 0.0),
            (0.1, 0.0, h),
            (0.1, 0.0, -h),
            (0.1, 0.0, 0.0),
        ],
        [
            (0.1, 0.2, h),
            (0.0, 0.5, 0.0),
            (0.1, 0.0, h),
            (0.0, 0.0, -h),
            (0.2, 0.3, h),
            (0.1, 0.0, 0.0),
        ],
    ] {
        let links = links(&rows);
        let general = General::prepare(&links).unwrap();
        assert!(!general.has_equation());
        let q = [0.3, -0.8, 1.1, 2.0, -1.0, 0.4];
        let mut roots = Roots::default();
        general.solve(&forward(&links, &q), &mut roots);
        assert!(roots.iter().any(|root| distance(root, &q) < 1e-8));
    }
}
