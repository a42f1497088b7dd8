//! Measures the general 6R solver: misses and times on random arms, structured arms and named ones.
//!
//! `cargo run --release -p pieper --example general6r -- [general|structured|named|singular|angles|slides|structured-slides|outside] [arms] [poses per arm] [seed]`
//!
//! A miss is a target whose generating joint values are not among the solutions (within 1e-6 rad).
//! `angles` measures the whole solver on built-in arms without a closed form, by a hair beside right angles.
//! Times are of single calls, or the best of five with `named`.

// A measuring program: it prints, and it stops where it must not go on.
#![allow(clippy::print_stdout, clippy::unwrap_used, clippy::expect_used)]

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::time::Instant;

use nalgebra::Vector3;
use pieper::ik::general::{Completeness, General, Roots};
use pieper::ik::{Solutions, Solver};
use pieper::kinematics::{Jacobian, Reference, pose_and_jacobian, tool_pose};
use pieper::spatial::{self, Pose};

/// A standard Denavit-Hartenberg row: d, a, alpha.
type Row = (f64, f64, f64);

fn link((d, a, alpha): Row) -> Pose {
    spatial::shift(Vector3::new(a, 0.0, d))
        * spatial::turn(&Vector3::x_axis(), spatial::sin_cos_exact(alpha))
}

fn forward(links: &[Pose; 6], q: &[f64; 6]) -> Pose {
    links
        .iter()
        .zip(q)
        .fold(Pose::identity(), |pose, (link, &q)| {
            pose * spatial::turn(&Vector3::z_axis(), q.sin_cos()) * link
        })
}

fn random_arm(random: &mut fastrand::Rng, structured: bool) -> [Pose; 6] {
    let twists = [0.0, FRAC_PI_4, -FRAC_PI_4, FRAC_PI_2, -FRAC_PI_2];
    std::array::from_fn(|_| {
        let signed = |random: &mut fastrand::Rng| 2.0 * random.f64() - 1.0;
        let length = |random: &mut fastrand::Rng| {
            let zero = structured && random.bool();
            if zero { 0.0 } else { signed(random) }
        };
        let (d, a) = (length(random), length(random));
        let alpha = if structured && random.f64() < 0.8 {
            twists[random.usize(0..5)]
        } else {
            signed(random) * PI
        };
        link((d, a, alpha))
    })
}

/// The DH rows of named arms.
fn named() -> Vec<(&'static str, [Row; 6])> {
    let h = FRAC_PI_2;
    let ar3 = |e: f64| {
        [
            (0.16977, 0.0642, -h),
            (0.0, 0.305, 0.0),
            (0.0, 0.0, h),
            (-0.22263, e, -h),
            (0.0, 0.0, h),
            (-0.03625, 0.0, 0.0),
        ]
    };
    let irb2400 = |e: f64| {
        [
            (0.615, 0.1, -h),
            (0.0, 0.705, 0.0),
            (0.0, 0.135, -h),
            (0.755, e, h),
            (0.0, 0.0, -h),
            (0.085, 0.0, 0.0),
        ]
    };
    let crx = [
        (0.0, 0.0, -h),
        (0.0, 0.54, PI),
        (0.0, 0.0, -h),
        (-0.54, 0.0, h),
        (0.15, 0.0, -h),
        (-0.16, 0.0, PI),
    ];
    let jaco = {
        let (s, t) = (PI / 3.0, 0.0741);
        let _ = s;
        [
            (0.2755, 0.0, h),
            (0.0, 0.41, PI),
            (-0.0098, 0.0, h),
            (-0.2501 - t, 0.0, PI / 3.0),
            (-2.0 * t, 0.0, PI / 3.0),
            (-0.16 - t, 0.0, PI),
        ]
    };
    let ur5 = [
        (0.089159, 0.0, h),
        (0.0, -0.425, 0.0),
        (0.0, -0.39225, 0.0),
        (0.10915, 0.0, h),
        (0.09465, 0.0, -h),
        (0.0823, 0.0, 0.0),
    ];
    let puma = [
        (0.0, 0.0, h),
        (0.0, 0.4318, 0.0),
        (0.15005, 0.0203, -h),
        (0.4318, 0.0, h),
        (0.0, 0.0, -h),
        (0.05, 0.0, 0.0),
    ];
    vec![
        ("CRX-10iA", crx),
        ("Jaco2", jaco),
        ("AR3 a4=5mm", ar3(0.005)),
        ("AR3 a4=10mm", ar3(0.01)),
        ("AR3 a4=20mm", ar3(0.02)),
        ("IRB2400 a4=5mm", irb2400(0.005)),
        ("IRB2400 a4=20mm", irb2400(0.02)),
        ("AR3", ar3(0.0)),
        ("UR5", ur5),
        ("PUMA 560", puma),
    ]
}

#[derive(Default)]
struct Tally {
    targets: usize,
    misses: usize,
    odd: usize,
    doubtful: usize,
    singular: usize,
    roots: usize,
    eliminations: usize,
    worst_error: f64,
    nanoseconds: Vec<f64>,
    setups: Vec<f64>,
}

impl Tally {
    fn target(
        &mut self,
        general: &General,
        links: &[Pose; 6],
        q: &[f64; 6],
        repeats: usize,
        label: &str,
    ) {
        let target = forward(links, q);
        let mut roots = Roots::default();
        let mut best = f64::INFINITY;
        let mut completeness = Completeness::OutOfReach;
        for _ in 0..repeats {
            let start = Instant::now();
            completeness = general.solve(std::hint::black_box(&target), &mut roots);
            best = best.min(start.elapsed().as_nanos() as f64);
        }
        self.nanoseconds.push(best);
        self.targets += 1;
        self.roots += roots.len();
        self.eliminations += match completeness {
            Completeness::OutOfReach => 0,
            Completeness::Equation => 1,
            Completeness::Agreed { eliminations }
            | Completeness::Singular { eliminations }
            | Completeness::Doubtful { eliminations } => usize::from(eliminations),
        };
        self.odd += roots.len() % 2;
        self.doubtful += usize::from(matches!(completeness, Completeness::Doubtful { .. }));
        self.singular += usize::from(matches!(completeness, Completeness::Singular { .. }));
        let difference = |a: &[f64; 6]| {
            a.iter().zip(q).fold(0.0_f64, |most, (x, y)| {
                let d = (x - y).rem_euclid(2.0 * PI);
                most.max(d.min(2.0 * PI - d))
            })
        };
        for root in roots.iter() {
            let off = forward(links, &root.q()).to_homogeneous() - target.to_homogeneous();
            if std::env::var_os("VERBOSE").is_some() && off.amax() > 1e-12 {
                println!(
                    "  error {:.1e} sigma {:.1e} residual {:.1e} of {} {completeness:?}",
                    off.amax(),
                    root.sigma,
                    root.residual,
                    roots.len()
                );
            }
            if root.sigma > 1e-4 {
                self.worst_error = self.worst_error.max(off.amax());
            }
            assert!(off.amax() < 1e-9, "a wrong solution: {label} {root:?}");
        }
        if std::env::var_os("VERBOSE").is_some()
            && matches!(completeness, Completeness::Doubtful { .. })
        {
            let sigmas: Vec<String> = roots.iter().map(|r| format!("{:.1e}", r.sigma)).collect();
            println!("  {label} {completeness:?} {sigmas:?}");
        }
        let nearest = roots
            .iter()
            .map(|r| difference(&r.q()))
            .fold(f64::INFINITY, f64::min);
        let allowed = 1e-6;
        if nearest > allowed {
            self.misses += 1;
            println!(
                "  miss: {label} q {q:?} sigma {:.1e} nearest {nearest:.1e} found {} {completeness:?}",
                jacobian(links, q).singular_values().min(),
                roots.len()
            );
        }
    }

    fn print(&mut self, name: &str) {
        self.nanoseconds.sort_by(f64::total_cmp);
        self.setups.sort_by(f64::total_cmp);
        let at = |list: &[f64], share: f64| {
            let last = list.len().saturating_sub(1);
            list.get((share * last as f64) as usize)
                .copied()
                .unwrap_or(f64::NAN)
                / 1e3
        };
        println!(
            "{name:18} targets {:6} misses {:3} odd {:3} doubtful {:4} singular {:4} roots {:5.2} eliminations {:5.2} error {:.1e} | us median {:6.2} 90% {:6.2} 99% {:6.2} 99.9% {:7.2} worst {:8.2} | set-up us median {:7.0} worst {:7.0}",
            self.targets,
            self.misses,
            self.odd,
            self.doubtful,
            self.singular,
            self.roots as f64 / self.targets.max(1) as f64,
            self.eliminations as f64 / self.targets.max(1) as f64,
            self.worst_error,
            at(&self.nanoseconds, 0.5),
            at(&self.nanoseconds, 0.9),
            at(&self.nanoseconds, 0.99),
            at(&self.nanoseconds, 0.999),
            at(&self.nanoseconds, 1.0),
            at(&self.setups, 0.5),
            at(&self.setups, 1.0),
        );
    }
}

/// The Jacobian in metres and radians at the last link.
fn jacobian(links: &[Pose; 6], q: &[f64; 6]) -> nalgebra::Matrix6<f64> {
    let end = forward(links, q);
    let mut jacobian = nalgebra::Matrix6::zeros();
    let mut pose = Pose::identity();
    for j in 0..6 {
        let axis = pose.rotation * Vector3::z();
        let arm = end.translation.vector - pose.translation.vector;
        jacobian
            .fixed_view_mut::<3, 1>(0, j)
            .copy_from(&axis.cross(&arm));
        jacobian.fixed_view_mut::<3, 1>(3, j).copy_from(&axis);
        pose = pose * spatial::turn(&Vector3::z_axis(), q[j].sin_cos()) * links[j];
    }
    jacobian
}

fn angles(random: &mut fastrand::Rng) -> [f64; 6] {
    std::array::from_fn(|_| (2.0 * random.f64() - 1.0) * PI)
}

fn prepare(links: &[Pose; 6], tally: &mut Tally) -> Option<General> {
    let start = Instant::now();
    let general = General::prepare(links).ok();
    tally.setups.push(start.elapsed().as_nanos() as f64);
    general
}

/// The determinant of the Jacobian.
fn determinant(links: &[Pose; 6], q: &[f64; 6]) -> f64 {
    jacobian(links, q).determinant()
}

/// Targets at a distance of 1e-3 ... 1e-12 rad from singular configurations of random arms and named ones.
fn sweep(arms: usize, random: &mut fastrand::Rng) {
    let mut list: Vec<[Pose; 6]> = named().iter().map(|(_, rows)| rows.map(link)).collect();
    list.extend((0..arms).map(|_| random_arm(random, false)));
    let mut tallies: Vec<Tally> = (0..5).map(|_| Tally::default()).collect();
    for (number, links) in list.iter().enumerate() {
        let Some(general) = prepare(links, &mut tallies[0]) else {
            continue;
        };
        for _ in 0..20 {
            let (start, end) = (angles(random), angles(random));
            let at = |t: f64| std::array::from_fn(|j| start[j] + t * (end[j] - start[j]));
            let (mut low, mut high) = (0.0, 1.0);
            let sign = determinant(links, &at(low)).signum();
            if sign == determinant(links, &at(high)).signum() {
                continue;
            }
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if determinant(links, &at(middle)).signum() == sign {
                    low = middle
                } else {
                    high = middle
                }
            }
            for (tally, distance) in tallies.iter_mut().zip([1e-3, 1e-5, 1e-7, 1e-9, 1e-12]) {
                tally.target(
                    &general,
                    links,
                    &at(low - distance),
                    1,
                    &format!("arm {number} {distance:e}"),
                );
            }
        }
    }
    for (tally, name) in tallies
        .iter_mut()
        .zip(["1e-3", "1e-5", "1e-7", "1e-9", "1e-12"])
    {
        tally.print(name);
    }
}

/// Targets that no arm of random general ones reaches, or few: positions around the reach, any orientation.
fn outside(arms: usize, poses: usize, random: &mut fastrand::Rng) {
    let mut list: Vec<[Pose; 6]> = named().iter().map(|(_, rows)| rows.map(link)).collect();
    list.extend((0..arms).map(|_| random_arm(random, false)));
    let (mut times, mut none, mut some) = (Vec::new(), 0, 0);
    for links in &list {
        let Ok(general) = General::prepare(links) else {
            continue;
        };
        let reach: f64 = links
            .iter()
            .map(|link| link.translation.vector.norm())
            .sum();
        for _ in 0..poses {
            let mut target = forward(links, &angles(random));
            let length = target.translation.vector.norm();
            target.translation.vector *= reach * (0.5 + 0.5 * random.f64()) / length;
            let mut roots = Roots::default();
            let start = Instant::now();
            general.solve(std::hint::black_box(&target), &mut roots);
            let time = start.elapsed().as_nanos() as f64 / 1e3;
            if roots.is_empty() {
                none += 1;
                times.push(time);
            } else {
                some += 1;
            }
        }
    }
    times.sort_by(f64::total_cmp);
    let at = |share: f64| times[(share * (times.len() - 1) as f64) as usize];
    println!(
        "outside: {some} reached, {none} not; us for those median {:.2} 90% {:.2} 99% {:.2}",
        at(0.5),
        at(0.9),
        at(0.99)
    );
}

fn forward_with_slides(links: &[Pose; 6], slides: &[bool; 6], q: &[f64; 6]) -> Pose {
    (0..6).fold(Pose::identity(), |pose, j| {
        let moved = if slides[j] {
            spatial::shift(Vector3::new(0.0, 0.0, q[j]))
        } else {
            spatial::turn(&Vector3::z_axis(), q[j].sin_cos())
        };
        pose * moved * links[j]
    })
}

/// Random arms with one or two sliding joints in every position; a slide moves by up to a metre.
fn sliding(arms: usize, poses: usize, structured: bool, random: &mut fastrand::Rng) {
    for mask in 1..63_u32 {
        let slides: [bool; 6] = std::array::from_fn(|j| mask >> j & 1 == 1);
        if mask.count_ones() > 2 {
            continue;
        }
        let kinds: String = slides
            .iter()
            .map(|&slides| if slides { 'P' } else { 'R' })
            .collect();
        let travel = slides.map(|slides| slides.then_some(1.0));
        let (mut done, mut refused, mut misses, mut most, mut total) = (0, 0, 0, 0, 0);
        let (mut odd, mut agreed, mut singular, mut times) = (0, 0, 0, Vec::new());
        while done < arms && refused < 20 * arms {
            let links = random_arm(random, structured);
            let Ok(general) = General::prepare_with_slides(&links, &travel) else {
                refused += 1;
                continue;
            };
            done += 1;
            for _ in 0..poses {
                let mut q = angles(random);
                for j in 0..6 {
                    if slides[j] {
                        q[j] = 2.0 * random.f64() - 1.0;
                    }
                }
                let target = forward_with_slides(&links, &slides, &q);
                let mut roots = Roots::default();
                let start = Instant::now();
                let completeness = general.solve(&target, &mut roots);
                times.push(start.elapsed().as_nanos() as f64 / 1e3);
                most = most.max(roots.len());
                total += roots.len();
                odd += roots.len() % 2;
                agreed += usize::from(matches!(
                    completeness,
                    Completeness::Agreed { .. } | Completeness::Equation
                ));
                singular += usize::from(matches!(completeness, Completeness::Singular { .. }));
                let mut nearest = f64::INFINITY;
                for root in roots.iter() {
                    let off = forward_with_slides(&links, &slides, &root.q()).to_homogeneous()
                        - target.to_homogeneous();
                    assert!(off.amax() < 1e-8, "a wrong solution: {kinds} {root:?}");
                    let apart = (0..6).fold(0.0_f64, |most, j| {
                        let d = (root.q()[j] - q[j]).abs();
                        most.max(if slides[j] { d } else { d.min(2.0 * PI - d) })
                    });
                    nearest = nearest.min(apart);
                }
                if nearest > 1e-6 {
                    misses += 1;
                    if misses < 4 {
                        println!(
                            "  miss: {kinds} arm {done} {q:?} nearest {nearest:.1e} found {} {completeness:?}",
                            roots.len()
                        );
                    }
                }
            }
        }
        times.sort_by(f64::total_cmp);
        let at = |share: f64| {
            times
                .get((share * times.len().saturating_sub(1) as f64) as usize)
                .copied()
                .unwrap_or(f64::NAN)
        };
        println!(
            "{kinds} targets {} misses {misses} odd {odd} agreed {agreed} singular {singular} most roots {most} mean {:.2} refused {refused} us median {:.1} 99% {:.1} worst {:.1}",
            times.len(),
            total as f64 / times.len().max(1) as f64,
            at(0.5),
            at(0.99),
            at(1.0)
        );
    }
}

/// Built-in arms without a closed form, whole solver: every joint at a multiple of 45 degrees or anywhere, one of them by
/// 1e-3 ... 1e-12 beside such a multiple.
fn near_right_angles(poses: usize, random: &mut fastrand::Rng) {
    for built_in in pieper_robots::ALL {
        let Ok(chain) = built_in.robot().chain() else {
            continue;
        };
        let solver = Solver::new(&chain).unwrap();
        if !["general", "offset-wrist"].contains(&solver.choice().name) || (chain.dof() != 6) {
            continue;
        }
        let (mut targets, mut missed, mut unsolved, mut times) = (0, 0, 0, Vec::new());
        let mut found = Solutions::default();
        for _ in 0..poses {
            let regular = random.bool();
            let mut q: Vec<f64> = (0..6)
                .map(|_| {
                    if regular || random.bool() {
                        PI * (2.0 * random.f64() - 1.0)
                    } else {
                        FRAC_PI_4 * random.i32(-3..=4) as f64
                    }
                })
                .collect();
            let joint = random.usize(0..6);
            let at = FRAC_PI_2 * random.i32(-1..=2) as f64;
            for distance in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-10, 1e-12] {
                q[joint] = at - distance;
                let pose = tool_pose(&chain, &q).unwrap();
                let start = Instant::now();
                solver.solve_into(&pose, &mut found).unwrap();
                times.push(start.elapsed().as_nanos() as f64 / 1e3);
                targets += 1;
                let mut jacobian = Jacobian::zeros(6);
                pose_and_jacobian(&chain, &q, Reference::Base, &mut jacobian).unwrap();
                let sigma = jacobian.singular_values().min();
                let off = |other: &[f64]| {
                    other.iter().zip(&q).fold(0.0_f64, |most, (a, b)| {
                        let d = (a - b).rem_euclid(2.0 * PI);
                        most.max(d.min(2.0 * PI - d))
                    })
                };
                let mut nearest = found.iter().map(|s| off(s.q())).fold(9.0, f64::min);
                for family in found.families() {
                    if let Ok(member) = solver.nearest_member(family, &q) {
                        nearest = nearest.min(off(&member));
                    }
                }
                unsolved += usize::from(found.iter().count() + found.families().len() == 0);
                // At a double root rounding moves the joints by the root of it.
                let allowed = (1e-13 / sigma).clamp(1e-9, 1e-6);
                if nearest > allowed {
                    missed += 1;
                    println!(
                        "  miss: {} {q:?} at {distance:e} sigma {sigma:.1e} nearest {nearest:.1e} found {} families {}",
                        built_in.id,
                        found.len(),
                        found.families().len()
                    );
                }
            }
        }
        times.sort_by(f64::total_cmp);
        let at = |share: f64| times[(share * (times.len() - 1) as f64) as usize];
        println!(
            "{:16} targets {targets} misses {missed} unsolved {unsolved} us median {:.1} 90% {:.1} 99% {:.1} worst {:.1}",
            built_in.id,
            at(0.5),
            at(0.9),
            at(0.99),
            at(1.0)
        );
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |index: usize, otherwise: usize| {
        arguments
            .get(index)
            .map_or(otherwise, |text| text.parse().expect("a number"))
    };
    let what = arguments.first().map_or("named", String::as_str);
    let (arms, poses, seed) = (number(1, 1000), number(2, 100), number(3, 1) as u64);
    let mut random = fastrand::Rng::with_seed(seed);
    if what == "named" {
        for (name, rows) in named() {
            let links = rows.map(link);
            let mut tally = Tally::default();
            let general = prepare(&links, &mut tally).expect(name);
            for _ in 0..poses {
                let q = angles(&mut random);
                tally.target(&general, &links, &q, 5, name);
            }
            tally.print(name);
        }
        return;
    }
    if what == "singular" {
        sweep(arms, &mut random);
        return;
    }
    if what == "angles" {
        near_right_angles(poses, &mut random);
        return;
    }
    if what == "slides" || what == "structured-slides" {
        sliding(arms, poses, what == "structured-slides", &mut random);
        return;
    }
    if what == "outside" {
        outside(arms, poses, &mut random);
        return;
    }
    let mut tally = Tally::default();
    let mut done = 0;
    while done < arms {
        let links = random_arm(&mut random, what == "structured");
        let Some(general) = prepare(&links, &mut tally) else {
            continue;
        };
        for _ in 0..poses {
            let q = angles(&mut random);
            tally.target(&general, &links, &q, 1, &format!("arm {done}"));
        }
        done += 1;
    }
    tally.print(what);
}
