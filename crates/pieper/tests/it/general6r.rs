//! The general 6R solver against solution sets computed with 50 digits, and on poses where solvers break.

use std::f64::consts::PI;

use nalgebra::{Matrix3, Rotation3, Vector3};
use pieper::ik::general::{Completeness, General, Root, Roots};
use pieper::spatial::{self, Pose};

/// The numbers behind `"key":` of a JSON line, brackets and nested lists flattened.
fn numbers(line: &str, key: &str) -> Vec<f64> {
    let start = line.find(&format!("\"{key}\":")).unwrap() + key.len() + 3;
    let mut depth = 0;
    let end = line[start..].find(|c| {
        depth += i32::from(c == '[') - i32::from(c == ']');
        depth == 0 && (c == ']' || c == ',' || c == '}')
    });
    line[start..start + end.unwrap()]
        .split(|c: char| "[], ".contains(c))
        .filter(|text| !text.is_empty())
        .map(|text| text.parse().unwrap())
        .collect()
}

/// All numbers behind every occurrence of `"key":`.
fn every(line: &str, key: &str) -> Vec<f64> {
    let pattern = format!("\"{key}\":");
    let places = line.match_indices(&pattern);
    places
        .flat_map(|(at, _)| numbers(&line[at..], key))
        .collect()
}

struct Robot {
    links: [Pose; 6],
    signs: Vec<f64>,
    offsets: Vec<f64>,
    general: General,
}

impl Robot {
    fn parse(line: &str) -> Self {
        let [d, a, alpha] = ["d", "a", "alpha"].map(|key| every(line, key));
        let links = std::array::from_fn(|i| {
            spatial::shift(Vector3::new(a[i], 0.0, d[i]))
                * spatial::turn(
                    &Vector3::x_axis(),
                    spatial::sin_cos_exact(spatial::snap(alpha[i])),
                )
        });
        Self {
            links,
            signs: every(line, "sign"),
            offsets: every(line, "offset"),
            general: General::prepare(&links).unwrap(),
        }
    }

    /// The smallest difference of a root's joints from listed ones, in the file's convention.
    fn distance(&self, root: &Root, q: &[f64]) -> f64 {
        (0..6).fold(0.0, |most, j| {
            let value = self.signs[j] * (root.q()[j] - self.offsets[j]);
            let turns = (value - q[j]).rem_euclid(2.0 * PI);
            most.max(turns.min(2.0 * PI - turns))
        })
    }
}

fn pose(numbers: &[f64]) -> Pose {
    let m = |i: usize, j: usize| numbers[4 * i + j];
    let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_fn(m));
    Pose::from_parts(Vector3::new(m(0, 3), m(1, 3), m(2, 3)).into(), rotation)
}

fn forward(links: &[Pose; 6], q: &[f64; 6]) -> Pose {
    links
        .iter()
        .zip(q)
        .fold(Pose::identity(), |pose, (link, &q)| {
            pose * spatial::turn(&Vector3::z_axis(), q.sin_cos()) * link
        })
}

fn file(name: &str) -> String {
    let path = format!("{}/../../vectors/{name}.jsonl", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

fn name(line: &str) -> &str {
    let key = if line.contains("\"kind\": \"robot\"") {
        "\"name\": \""
    } else {
        "\"robot\": \""
    };
    let start = line.find(key).unwrap() + key.len();
    &line[start..start + line[start..].find('"').unwrap()]
}

#[test]
fn solving_allocates_nothing() {
    for line in file("ik")
        .lines()
        .filter(|line| line.contains("\"kind\": \"robot\""))
    {
        if !line.contains("\"P\"") && every(line, "d").len() == 6 {
            let robot = Robot::parse(line);
            let target = forward(&robot.links, &[0.3, -0.8, 1.1, 2.0, -1.0, 0.4]);
            let mut roots = Roots::default();
            let count = crate::hot_calls::allocations(|| {
                robot.general.solve(&target, &mut roots);
            });
            assert_eq!(count, 0, "{}", name(line));
            assert!(!roots.is_empty());
        }
    }
}

#[test]
fn finds_exactly_the_listed_solutions() {
    let robots = [
        "ar3",
        "irb140",
        "ur10",
        "ar3_e10",
        "crx20ia",
        "general_a",
        "general_b",
    ];
    let mut robot = None;
    let mut targets = 0;
    for line in file("ik")
        .lines()
        .filter(|line| robots.contains(&name(line)))
    {
        if line.contains("\"kind\": \"robot\"") {
            robot = Some(Robot::parse(line));
            continue;
        }
        let robot = robot.as_ref().unwrap();
        let (solutions, sigma) = (numbers(line, "solutions"), numbers(line, "sigma_min"));
        let mut roots = Roots::default();
        let completeness = robot.general.solve(&pose(&numbers(line, "T")), &mut roots);
        for (solution, sigma) in solutions.chunks(6).zip(&sigma) {
            let allowed = (1e-13 / sigma).max(1e-9);
            let found = roots
                .iter()
                .filter(|root| robot.distance(root, solution) < allowed)
                .count();
            assert_eq!(found, 1, "{}: {solution:?} {completeness:?}", name(line));
        }
        assert_eq!(roots.len(), sigma.len(), "{}", name(line));
        assert!(
            matches!(
                completeness,
                Completeness::Agreed { .. } | Completeness::Equation
            ),
            "{}",
            name(line)
        );
        targets += 1;
    }
    assert_eq!(targets, 48);
}

/// At singular poses: isolated solutions are found, everything found closes, what is out of reach has no solution.
#[test]
fn special_poses() {
    let mut robot = None;
    for line in file("special").lines() {
        if line.contains("\"kind\": \"robot\"") {
            robot = Some(Robot::parse(line));
            continue;
        }
        let robot = robot.as_ref().unwrap();
        let target = pose(&numbers(line, "T"));
        let mut roots = Roots::default();
        let completeness = robot.general.solve(&target, &mut roots);
        let label = &line[..line.find("\"T\"").unwrap_or(80)];
        for root in roots.iter() {
            let off = (forward(&robot.links, &root.q()).to_homogeneous() - target.to_homogeneous())
                .amax();
            assert!(off < 1e-9, "{label}: {off:e}");
        }
        if line.contains("\"expected\": \"unreachable\"") {
            assert!(
                roots.is_empty(),
                "{label}: {completeness:?} {}",
                roots.len()
            );
        }
        if line.contains("\"expected\": \"isolated\"")
            || line.contains("\"expected\": \"double_root\"")
        {
            let (listed, times) = (every(line, "q"), every(line, "multiplicity"));
            for (solution, &times) in listed.chunks(6).zip(&times) {
                let allowed = if times > 1.0 { 1e-7 } else { 1e-9 };
                let nearest = roots
                    .iter()
                    .map(|root| robot.distance(root, solution))
                    .fold(9.0, f64::min);
                assert!(
                    nearest < allowed,
                    "{label}: {solution:?} x{times} {nearest:e} {completeness:?}"
                );
            }
        }
    }
}

#[test]
fn finds_the_generating_joints_of_random_arms() {
    let mut random = fastrand::Rng::with_seed(7);
    let signed = |random: &mut fastrand::Rng| 2.0 * random.f64() - 1.0;
    for _ in 0..10 {
        let links: [Pose; 6] = std::array::from_fn(|_| {
            let shift = Vector3::new(signed(&mut random), 0.0, signed(&mut random));
            let twist = (PI * signed(&mut random)).sin_cos();
            spatial::shift(shift) * spatial::turn(&Vector3::x_axis(), twist)
        });
        let general = General::prepare(&links).unwrap();
        let mut roots = Roots::default();
        for _ in 0..20 {
            let q: [f64; 6] = std::array::from_fn(|_| PI * signed(&mut random));
            let completeness = general.solve(&forward(&links, &q), &mut roots);
            let found = roots.iter().any(|root| {
                let near =
                    |(a, b): (&f64, &f64)| ((a - b).sin().abs() < 1e-7) && (a - b).cos() > 0.0;
                root.q().iter().zip(&q).all(near)
            });
            assert!(found, "{q:?} {completeness:?}");
        }
    }
}

/// Nothing that can be handed in makes it panic or answer with something.
#[test]
fn bad_input() {
    let links = [spatial::shift(Vector3::new(0.3, 0.0, 0.2)); 6];
    assert!(General::prepare(&links).is_err(), "all axes are parallel");
    assert!(
        General::prepare(&[Pose::identity(); 6]).is_err(),
        "no lengths at all"
    );
    let mut broken = links;
    broken[2].translation.vector.x = f64::NAN;
    assert!(General::prepare(&broken).is_err());
    let quarter = spatial::turn(&Vector3::x_axis(), (0.6, 0.8));
    let general = General::prepare(&links.map(|link| link * quarter)).unwrap();
    let mut roots = Roots::default();
    let mut target = forward(&links, &[0.1; 6]);
    for bad in [f64::NAN, f64::INFINITY, 1e300] {
        target.translation.vector.y = bad;
        assert_eq!(general.solve(&target, &mut roots), Completeness::OutOfReach);
        assert!(roots.is_empty());
    }
    let target = Pose::from_parts(
        Vector3::new(0.1, 0.2, 0.3).into(),
        Rotation3::from_matrix_unchecked(Matrix3::repeat(f64::NAN)),
    );
    general.solve(&target, &mut roots);
    assert!(roots.is_empty());
}
