//! The four-bar linkage: the paper's numbers, points constructed in another way, ratios, reach and dead points.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::PAPER;
use pieper::scalar::{Dual, Trigonometric};
use pieper::transmission::{Assembly, FourBar, Lengths, Rest};

fn paper() -> FourBar {
    FourBar::new(PAPER, Assembly::Open).unwrap()
}

/// Random linkages of every kind: those that turn round and those that do not.
fn linkages(random: &mut fastrand::Rng) -> impl Iterator<Item = FourBar> {
    std::iter::from_fn(move || {
        let mut length = || 0.2 + random.f64();
        let lengths = Lengths {
            crank: length(),
            coupler: length(),
            rocker: length(),
            frame: length(),
        };
        let assembly = [Assembly::Open, Assembly::Crossed][random.usize(..2)];
        Some(FourBar::new(lengths, assembly))
    })
    .filter_map(Result::ok)
}

#[test]
fn the_paper_s_numbers() {
    let linkage = paper();
    let near = |value: f64, degrees: f64, digits: f64| {
        assert!(
            (value.to_degrees() - degrees).abs() < digits,
            "{} {degrees}",
            value.to_degrees()
        );
    };
    near(linkage.psi0(), 69.219_824_038_2, 5e-11);
    assert_eq!(linkage.crank_angle(0.0), Some(0.0));
    for (phi, psi) in [
        (20.0, 22.308_769_2),
        (-20.0, -25.907_983_0),
        // Printed as 42.2433934 in the specification; its own formula in 40 digits gives this.
        (40.0, 42.243_394_883_6),
        (-40.0, -66.841_047_9),
    ] {
        let phi = f64::to_radians(phi);
        near(linkage.crank_angle(phi).unwrap(), psi, 5e-8);
        let [one, other] = linkage.rocker_angles(f64::to_radians(psi)).unwrap();
        let nearest = (one.0 - phi).abs().min((other.0 - phi).abs());
        assert!(nearest < 1e-8, "{one:?} {other:?}");
    }
    assert_eq!(linkage.crank_angle(-60_f64.to_radians()), None);
    assert_eq!(linkage.ratio(-60_f64.to_radians()), None);
}

/// The angle of the crank by the paper's own formulas, arc cosines and all.
fn by_the_paper(lengths: Lengths, phi: f64) -> f64 {
    let Lengths {
        crank: r,
        coupler: b,
        rocker: big_r,
        frame: d,
    } = lengths;
    let ac2 = d * d + big_r * big_r + 2.0 * d * big_r * phi.sin();
    let ac = ac2.sqrt();
    let beta1 = ((ac2 + r * r - b * b) / (2.0 * ac * r)).acos();
    let beta2 = ((ac2 + d * d - big_r * big_r) / (2.0 * ac * d)).acos();
    let hypot = (d * d + big_r * big_r).sqrt();
    let psi0 = PI
        - ((r * r + d * d + big_r * big_r - b * b) / (2.0 * r * hypot)).acos()
        - (big_r / d).atan();
    PI - psi0 - beta1 - beta2
}

#[test]
fn it_is_the_paper_s_formula_where_that_holds() {
    let linkage = paper();
    for step in -420..900 {
        let phi = f64::from(step).to_radians() / 10.0;
        let (ours, paper) = (linkage.crank_angle(phi).unwrap(), by_the_paper(PAPER, phi));
        assert!((ours - paper).abs() < 1e-12, "at {phi}: {ours} {paper}");
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// B by the intersection of two circles: no angle in it.
fn circles(a: [f64; 2], radius_a: f64, c: [f64; 2], radius_c: f64, left: bool) -> [f64; 2] {
    let ac = distance(a, c);
    let u = [(c[0] - a[0]) / ac, (c[1] - a[1]) / ac];
    let along = (ac * ac + radius_a * radius_a - radius_c * radius_c) / (2.0 * ac);
    let across = (radius_a * radius_a - along * along).max(0.0).sqrt();
    let sign = if left { 1.0 } else { -1.0 };
    [
        a[0] + along * u[0] - sign * across * u[1],
        a[1] + along * u[1] + sign * across * u[0],
    ]
}

#[test]
fn the_points_keep_their_distances_and_meet_another_construction() {
    let mut random = fastrand::Rng::with_seed(31);
    let mut count = 0;
    let mut all: Vec<FourBar> = linkages(&mut random).take(500).collect();
    all.push(paper());
    let mut random = fastrand::Rng::with_seed(32);
    for linkage in all {
        let lengths = linkage.lengths();
        let size = lengths.coupler + lengths.frame;
        for _ in 0..20 {
            let phi = PI * (2.0 * random.f64() - 1.0);
            let Some([a, b, c, d]) = linkage.points(phi) else {
                continue;
            };
            count += 1;
            for (one, other, length) in [
                (a, b, lengths.crank),
                (b, c, lengths.coupler),
                (c, d, lengths.rocker),
                (a, d, lengths.frame),
            ] {
                let off = (distance(one, other) - length).abs();
                assert!(off < 1e-14 * size, "{off:e} {linkage:?} at {phi}");
            }
            // C turned about D by phi from the perpendicular; the crank's angle by B alone.
            let again = [
                lengths.frame + lengths.rocker * (FRAC_PI_2 - phi).cos(),
                lengths.rocker * (FRAC_PI_2 - phi).sin(),
            ];
            let left = linkage.assembly() == Assembly::Open;
            let other = circles(a, lengths.crank, again, lengths.coupler, left);
            // Two circles that touch: the root of a rounding.
            let flat = (distance(a, c) - lengths.crank - lengths.coupler)
                .abs()
                .min((distance(a, c) - (lengths.crank - lengths.coupler).abs()).abs());
            let tolerance = if flat > 1e-3 { 1e-12 } else { 1e-6 };
            assert!(
                distance(b, other) < tolerance,
                "{linkage:?} at {phi}: {b:?} {other:?}"
            );
            let psi = linkage.crank_angle(phi).unwrap();
            let theta = PI - linkage.psi0() - psi;
            assert!((theta.cos() * lengths.crank - b[0]).abs() < 1e-14 * size);
            assert!((theta.sin() * lengths.crank - b[1]).abs() < 1e-14 * size);
        }
    }
    assert!(count > 5000, "{count}");
}

#[test]
fn a_crank_angle_has_two_rocker_angles_and_one_of_them_is_where_it_came_from() {
    let mut random = fastrand::Rng::with_seed(33);
    let mut turns = fastrand::Rng::with_seed(34);
    for linkage in linkages(&mut random).take(3000) {
        let phi = PI * (2.0 * turns.f64() - 1.0);
        let (Some(psi), Some(ratio)) = (linkage.crank_angle(phi), linkage.ratio(phi)) else {
            continue;
        };
        let found = linkage.rocker_angles(psi).unwrap();
        let off = |phi_found: f64| {
            ((phi_found - phi).sin().powi(2) + (1.0 - (phi_found - phi).cos()).powi(2)).sqrt()
        };
        let nearest = found
            .into_iter()
            .min_by(|a, b| off(a.0).total_cmp(&off(b.0)))
            .unwrap();
        let tolerance = 1e-14 * (1.0 + 1.0 / ratio.abs()).powi(2) + 1e-14 * (1.0 + ratio.abs());
        assert!(
            off(nearest.0) < 100.0 * tolerance,
            "{linkage:?} at {phi}: {found:?}"
        );
        if ratio.abs() < 1e3 && ratio.abs() > 1e-3 {
            assert_eq!(
                nearest.1,
                linkage.assembly(),
                "{linkage:?} at {phi}: {found:?}"
            );
        }
        for (phi, assembly) in found {
            // Both are poses of the same lengths, in the assembly they name.
            let other = FourBar::new(linkage.lengths(), assembly).unwrap();
            let crank = other.crank_angle(phi).map(|own| PI - other.psi0() - own);
            let theta = PI - linkage.psi0() - psi;
            let Some(crank) = crank else {
                continue; // past the end of the reach by a rounding
            };
            let slope = other.ratio(phi).unwrap_or(f64::INFINITY);
            let off = (crank - theta).sin().hypot(1.0 - (crank - theta).cos());
            assert!(
                off < 1e-12 * (1.0 + slope.abs()).powi(2),
                "{linkage:?} at {phi}: {off:e}"
            );
        }
    }
}

/// `|BC|^2` over dual numbers, B and C by their angles.
fn coupler_squared(lengths: Lengths, theta: Dual, phi: Dual) -> Dual {
    let number = Dual::constant;
    let ((sin_theta, cos_theta), (sin_phi, cos_phi)) = (theta.sin_cos(), phi.sin_cos());
    let x = number(lengths.frame) + number(lengths.rocker) * sin_phi
        - number(lengths.crank) * cos_theta;
    let y = number(lengths.rocker) * cos_phi - number(lengths.crank) * sin_theta;
    x * x + y * y
}

#[test]
fn the_ratio_is_that_of_dual_numbers() {
    let mut random = fastrand::Rng::with_seed(35);
    let mut turns = fastrand::Rng::with_seed(36);
    let mut count = 0;
    for linkage in linkages(&mut random).take(5000).chain([paper()]) {
        let phi = PI * (2.0 * turns.f64() - 1.0);
        let Some(ratio) = linkage.ratio(phi) else {
            continue;
        };
        count += 1;
        let theta = PI - linkage.psi0() - linkage.crank_angle(phi).unwrap();
        let lengths = linkage.lengths();
        let by_theta =
            coupler_squared(lengths, Dual::variable(theta), Dual::constant(phi)).derivative;
        let by_phi =
            coupler_squared(lengths, Dual::constant(theta), Dual::variable(phi)).derivative;
        // The coupler keeps its length; psi falls as theta grows.
        let expected = by_phi / by_theta;
        let off = (ratio - expected).abs();
        assert!(
            off < 1e-13 * (1.0 + ratio.abs()).powi(2),
            "{linkage:?} at {phi}: {off:e} of {ratio}"
        );
        let h = 1e-6;
        if let (Some(more), Some(less)) =
            (linkage.crank_angle(phi + h), linkage.crank_angle(phi - h))
            && ratio.abs() < 10.0
        {
            let difference = (more - less) / (2.0 * h);
            assert!(
                (difference - ratio).abs() < 1e-6,
                "{linkage:?} at {phi}: {difference} {ratio}"
            );
        }
    }
    assert!(count > 3000, "{count}");
}

#[test]
fn the_reach_is_where_it_can_be_assembled() {
    let mut random = fastrand::Rng::with_seed(37);
    for linkage in linkages(&mut random).take(2000).chain([paper()]) {
        let reach = linkage.reach();
        assert!(!reach.is_empty() && reach.len() <= 2);
        for step in 0..360 {
            let phi = f64::from(step).to_radians() - FRAC_PI_2;
            let near_end = |phi: f64| {
                let ends = reach.iter().flat_map(|span| [span.lower, span.upper]);
                ends.filter(|end| end.is_finite())
                    .any(|end| ((phi - end) / 2.0).sin().abs() < 1e-9)
            };
            if near_end(phi) {
                continue;
            }
            let within = [phi, phi + TAU, phi - TAU]
                .iter()
                .any(|copy| reach.iter().any(|span| span.contains(*copy)));
            assert_eq!(
                within,
                linkage.crank_angle(phi).is_some(),
                "{linkage:?} at {phi}"
            );
        }
    }
    let [span] = paper().reach()[..] else {
        panic!("one span");
    };
    assert!((span.lower.to_degrees() + 42.258_942_785_465_52).abs() < 1e-12);
    assert!((span.upper.to_degrees() - 222.258_942_785_465_52).abs() < 1e-12);
}

#[test]
fn derivatives_vanish_and_blow_up_at_the_dead_points_and_nowhere_else() {
    let mut random = fastrand::Rng::with_seed(38);
    let (mut crank_rests, mut rocker_rests) = (0, 0);
    for linkage in linkages(&mut random).take(2000).chain([paper()]) {
        let points = linkage.dead_points();
        for point in &points {
            // One-sided, from within the reach.
            let near = |by: f64| {
                let ratio = |phi| linkage.ratio(phi).filter(|r: &f64| r.is_finite());
                [ratio(point.phi - by), ratio(point.phi + by)]
            };
            let inside = near(1e-6).into_iter().flatten();
            match point.rest {
                Rest::Crank => {
                    crank_rests += 1;
                    let at = linkage.ratio(point.phi).unwrap();
                    let slope = inside.fold(0.0, |a: f64, b| a.max(b.abs())) / 1e-6;
                    assert!(
                        at.abs() < 1e-12 * (1.0 + slope),
                        "{linkage:?}: {at:e} at {point:?}"
                    );
                    let psi = linkage.crank_angle(point.phi).unwrap();
                    assert!((psi - point.psi).abs() < 1e-12);
                }
                Rest::Rocker => {
                    rocker_rests += 1;
                    let (coarse, fine) = (near(1e-4), near(1e-8));
                    let largest = |both: [Option<f64>; 2]| {
                        both.into_iter()
                            .flatten()
                            .fold(0.0, |a: f64, b| a.max(b.abs()))
                    };
                    // As 1 / sqrt(distance): a hundred times for four decades.
                    let growth = largest(fine) / largest(coarse);
                    assert!(
                        (50.0..200.0).contains(&growth),
                        "{linkage:?}: {growth} at {point:?}"
                    );
                    let psi = linkage.crank_angle(point.phi).unwrap_or(point.psi);
                    assert!(
                        (psi - point.psi).abs() < 1e-6,
                        "{linkage:?}: {psi} at {point:?}"
                    );
                }
            }
        }
        // The ratio changes its sign at the crank's dead points alone.
        for step in 0..720 {
            let phi = f64::from(step).to_radians() / 2.0 - PI;
            let next = phi + 0.5_f64.to_radians();
            let (Some(one), Some(other)) = (linkage.ratio(phi), linkage.ratio(next)) else {
                continue;
            };
            if one * other < 0.0 {
                let between = |point: &&pieper::transmission::DeadPoint| {
                    [0.0, TAU, -TAU]
                        .iter()
                        .any(|turn| (phi - 1e-9..=next + 1e-9).contains(&(point.phi + turn)))
                };
                assert!(
                    points.iter().any(|p| between(&p)),
                    "{linkage:?}: a sign between {phi} and {next}, {points:?}"
                );
            }
        }
    }
    assert!(
        crank_rests > 500 && rocker_rests > 500,
        "{crank_rests} {rocker_rests}"
    );
}

#[test]
fn a_section_is_one_to_one() {
    let mut random = fastrand::Rng::with_seed(39);
    let mut turns = fastrand::Rng::with_seed(40);
    let mut round = 0;
    for linkage in linkages(&mut random).take(3000).chain([paper()]) {
        let start = PI * (2.0 * turns.f64() - 1.0);
        let Some(section) = linkage.section_at(start) else {
            assert!(linkage.crank_angle(start).is_none());
            continue;
        };
        let span = section.phi();
        let (lower, upper) = match section.ends() {
            Some(_) => (span.lower, span.upper),
            None => {
                round += 1;
                (-9.0, 9.0)
            }
        };
        let mut last: Option<f64> = None;
        let rising = section.crank_angle(f64::midpoint(lower, upper)).unwrap()
            > section.crank_angle(lower).unwrap();
        for step in 0..=40 {
            // The end itself: a rounding short of it, half the digits of the way back are gone.
            let phi = match step {
                40 => upper,
                _ => lower + (upper - lower) * f64::from(step) / 40.0,
            };
            let psi = section.crank_angle(phi).unwrap();
            if let Some(last) = last {
                assert_eq!(psi > last, rising, "{linkage:?} at {phi}: not monotone");
            }
            last = Some(psi);
            let back = section.rocker_angle(psi).unwrap();
            let ratio = linkage.ratio(phi).unwrap_or(0.0).abs();
            let tolerance = match step {
                0 | 40 if section.ends().is_some() => 1e-15,
                _ => 1e-13 * (1.0 + 1.0 / ratio + ratio),
            };
            let off = (back - phi).abs();
            assert!(
                off < tolerance.max(1e-15) * 10.0,
                "{linkage:?} at {phi}: {off:e}"
            );
        }
        if section.ends().is_some() {
            let psi = section.psi();
            assert!(section.rocker_angle(psi.lower - 1e-6).is_err());
            assert!(section.rocker_angle(psi.upper + 1e-6).is_err());
            if upper - lower < 6.0 {
                assert!(section.crank_angle(upper + 1e-6).is_err());
                assert!(section.crank_angle(lower - 1e-6).is_err());
                let (_, by) = section.crank_angle(upper + 0.1).unwrap_err();
                assert!((by - 0.1).abs() < 1e-9);
            }
        }
    }
    assert!(round > 20, "{round} that turn round");
    let [lower, upper] = paper().section_at(0.0).unwrap().ends().unwrap();
    assert_eq!((lower.rest, upper.rest), (Rest::Rocker, Rest::Crank));
    assert!((upper.phi.to_degrees() - 101.297_044_916_815_11).abs() < 1e-12);
    assert!((upper.psi.to_degrees() - 76.280_134_682_915_59).abs() < 1e-12);
}

#[test]
fn a_parallelogram_works_between_its_change_points() {
    for (short, long) in [(0.1, 0.7), (0.3, 0.4), (0.029, 0.095)] {
        let lengths = Lengths {
            crank: short,
            coupler: long,
            rocker: short,
            frame: long,
        };
        let linkage = FourBar::new(lengths, Assembly::Open).unwrap();
        let section = linkage.section_at(0.0).unwrap();
        let span = section.phi();
        assert!((span.lower + FRAC_PI_2).abs() < 1e-7 && (span.upper - FRAC_PI_2).abs() < 1e-7);
        for step in -89..=89 {
            let phi = f64::from(step).to_radians();
            assert!((section.crank_angle(phi).unwrap() - phi).abs() < 1e-13);
            assert!((section.rocker_angle(phi).unwrap() - phi).abs() < 1e-13);
        }
    }
}
