//! Generated code, compiled or run, against the library: 10,000 poses with Jacobians, and every inverse solution.
//!
//! A language whose compiler or interpreter is not installed is left out with a word about it; the test command installs
//! Octave where it can.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use pieper::describe::Robot;
use pieper::kinematics::{Jacobian, Reference, pose_and_jacobian};
use pieper::model::Chain;
use pieper_symbolic::code::{self, Language, Precision, What};
use pieper_symbolic::{Arm, Lengths};

use crate::numbers::with_numbers;

const POSES: usize = 10_000;

/// A folder that goes when the test is over.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("pieper-code-{}-{name}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    pub(crate) fn write(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.join(name);
        fs::write(&path, text).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[allow(
    clippy::print_stderr,
    reason = "whoever runs the tests should know what was left out"
)]
pub(crate) fn is_missing(program: &str) -> bool {
    let found = Command::new(program)
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    let missing = !found.is_ok_and(|status| status.success());
    if missing {
        eprintln!("not run: what needs {program}, which is not installed");
    }
    missing
}

pub(crate) fn run(program: &str, arguments: &[&str], folder: &Path) -> String {
    let output = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap();
    let words = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{program} {arguments:?}: {words}");
    String::from_utf8(output.stdout).unwrap()
}

/// What follows the generated code to make a program: it reads `q.txt` and prints, a line a pose, the pose, the Jacobian,
/// the number of solutions and the solutions; of an arm without an inverse the number is -1.
fn driver(language: Language, id: &str, dof: usize, most: usize) -> String {
    let solves = most > 0;
    match language {
        Language::C | Language::Cpp => {
            let scope = if language == Language::C {
                format!("{id}_")
            } else {
                format!("{id}::")
            };
            let inverse = match solves {
                true => format!(
                    "double found[{most}][{dof}]; int n = {scope}inverse(T, 0, found); printf(\" %d\", n); for (int k = 0; k < n; ++k) for (int j = 0; j < {dof}; ++j) printf(\" %.17g\", found[k][j]);"
                ),
                false => "printf(\" -1\");".to_owned(),
            };
            format!(
                "#include <stdio.h>\nint main(void) {{ double q[{dof}]; FILE *f = fopen(\"q.txt\", \"r\"); for (;;) {{\n\
                 for (int j = 0; j < {dof}; ++j) if (fscanf(f, \"%lf\", &q[j]) != 1) return 0;\n\
                 double T[3][4], J[6][{dof}]; {scope}fk(q, T); {scope}jacobian(q, J);\n\
                 for (int i = 0; i < 3; ++i) for (int j = 0; j < 4; ++j) printf(\" %.17g\", T[i][j]);\n\
                 for (int i = 0; i < 6; ++i) for (int j = 0; j < {dof}; ++j) printf(\" %.17g\", J[i][j]);\n{inverse} printf(\"\\n\"); }} }}\n"
            )
        }
        Language::Rust => {
            let inverse = match solves {
                true => format!(
                    "let mut found = [[0.0; {dof}]; {most}]; let n = inverse(&t, 0.0, &mut found); print!(\"{{n}} \"); for v in found[..n].iter().flatten() {{ print!(\"{{v:?}} \"); }}"
                ),
                false => "print!(\"-1\");".to_owned(),
            };
            format!(
                "fn main() {{ for line in std::fs::read_to_string(\"q.txt\").unwrap().lines() {{\n\
                 let v: Vec<f64> = line.split(' ').map(|x| x.parse().unwrap()).collect(); let q: [f64; {dof}] = v.try_into().unwrap();\n\
                 let t = fk(&q); let j = jacobian(&q); for v in t.iter().flatten().chain(j.iter().flatten()) {{ print!(\"{{v:?}} \"); }}\n{inverse} println!(); }} }}\n"
            )
        }
        Language::Python => {
            let inverse = match solves {
                true => {
                    "s = inverse(T) if i < 300 else None\n    out += [-2] if s is None else [len(s)] + sum(s, [])"
                }
                false => "out += [-1]",
            };
            format!(
                "\nfor i, line in enumerate(open('q.txt')):\n    q = [float(x) for x in line.split()]\n    T = fk(q)\n    out = sum(T, []) + sum(jacobian(q), [])\n    {inverse}\n    print(*map(repr, out))\n"
            )
        }
        Language::Matlab => {
            let inverse = match solves {
                true => {
                    "if i <= 300; s = k.inverse(T, 0); out = [out, size(s, 1), reshape(s', 1, [])]; else; out = [out, -2]; end"
                }
                false => "out = [out, -1];",
            };
            format!(
                "k = {id}_kinematics(); k.self_test(); Q = load('q.txt');\nfor i = 1:size(Q, 1)\n q = Q(i, :); T = k.fk(q); out = [reshape(T', 1, []), reshape(k.jacobian(q)', 1, [])];\n{inverse}\n printf('%.17g ', out); printf('\\n');\nend\n"
            )
        }
    }
}

fn check(id: &str, language: Language) {
    let robot = with_numbers(&pieper_robots::find(id).unwrap().robot());
    check_robot(id, &robot, language, 1e-13);
}

/// `near` is how far entries of the pose may be off.
fn check_robot(id: &str, robot: &Robot, language: Language, near: f64) {
    let program = match language {
        Language::C => "gcc",
        Language::Cpp => "g++",
        Language::Rust => "rustc",
        Language::Python => "python3",
        Language::Matlab => "octave-cli",
    };
    if is_missing(program) {
        return;
    }
    let (chain, arm) = (
        robot.chain().unwrap(),
        Arm::new(robot, Lengths::Symbols).unwrap(),
    );
    let most = match pieper_symbolic::inverse::derive(&arm) {
        Err(_) => 0,
        Ok(inverse) => {
            use pieper_symbolic::inverse::{Rule, Step};
            let is_branch = |step: &&Step| {
                matches!(
                    step,
                    Step::Joint {
                        rule: Rule::Two { .. } | Rule::Square { .. },
                        ..
                    }
                )
            };
            1_usize << inverse.steps.iter().filter(is_branch).count()
        }
    };
    let name = id.replace('-', "_");
    let folder = Folder::new(&format!("{name}-{language:?}"));
    let mut random = fastrand::Rng::with_seed(5);
    let qs: Vec<Vec<f64>> = (0..POSES)
        .map(|_| (0..chain.dof()).map(|_| 6.0 * random.f64() - 3.0).collect())
        .collect();
    let line = |q: &Vec<f64>| {
        q.iter()
            .map(|x| format!("{x:?}"))
            .collect::<Vec<_>>()
            .join(" ")
    };
    folder.write("q.txt", &qs.iter().map(line).collect::<Vec<_>>().join("\n"));
    let source = code::generate(&arm, id, language, What::All, Precision::Double).unwrap();
    let main = driver(language, &name, chain.dof(), most);
    let whole = format!("{source}{main}");
    let here = folder.0.as_path();
    let out = match language {
        Language::C | Language::Cpp => {
            let (file, standard) = if language == Language::C {
                ("a.c", "-std=c99")
            } else {
                ("a.cpp", "-std=c++11")
            };
            folder.write(&format!("self_{file}"), &source);
            let flags = [standard, "-O1", "-Wall", "-Wextra", "-Werror", "-pedantic"];
            let compile = |file: &str, out: &str, extra: &[&str]| {
                run(
                    program,
                    &[&flags[..], extra, &[file, "-o", out, "-lm"]].concat(),
                    here,
                );
            };
            compile(&format!("self_{file}"), "self", &["-DPIEPER_SELF_TEST"]);
            run(&format!("{}/self", here.display()), &[], here);
            folder.write(file, &whole);
            compile(file, "main", &[]);
            run(&format!("{}/main", here.display()), &[], here)
        }
        Language::Rust => {
            folder.write(
                "lib.rs",
                &format!("#![no_std]\n{source}").replacen("#![no_std]\n", "#![no_std]\n", 1),
            );
            run(
                "rustc",
                &["--edition=2024", "--crate-type=rlib", "lib.rs"],
                here,
            );
            folder.write("main.rs", &whole);
            run(
                "rustc",
                &["--edition=2024", "-O", "--test", "main.rs", "-o", "self"],
                here,
            );
            run(&format!("{}/self", here.display()), &[], here);
            run("rustc", &["--edition=2024", "-O", "main.rs"], here);
            run(&format!("{}/main", here.display()), &[], here)
        }
        Language::Python => {
            folder.write("a.py", &source);
            assert_eq!(run(program, &["a.py"], here).trim(), "passed");
            folder.write(
                "b.py",
                &format!("{}{main}", source.split("\nif __name__").next().unwrap()),
            );
            run(program, &["b.py"], here)
        }
        Language::Matlab => {
            folder.write(&format!("{name}_kinematics.m"), &source);
            folder.write("main.m", &main);
            run(program, &["--no-gui", "--no-init-file", "main.m"], here).replace("passed\n", "")
        }
    };
    compare((id, &chain, near), &qs, &out, most > 0);
}

fn compare((id, chain, near): (&str, &Chain, f64), qs: &[Vec<f64>], out: &str, solves: bool) {
    let solver = pieper::ik::Solver::new(chain).unwrap();
    let mut jacobian = Jacobian::zeros(chain.dof());
    let (mut compared, mut solved) = (0, 0);
    for (q, line) in qs.iter().zip(out.lines()) {
        let numbers: Vec<f64> = line
            .split_whitespace()
            .map(|x| x.parse().unwrap())
            .collect();
        let pose = pose_and_jacobian(chain, q, Reference::Base, &mut jacobian).unwrap();
        let matrix = pose.to_homogeneous();
        for (at, value) in numbers[..12].iter().enumerate() {
            let off = (value - matrix[(at / 4, at % 4)]).abs();
            assert!(off < near, "{id} T at {q:?}: off by {off}");
        }
        let (entries, rest) = numbers[12..].split_at(6 * chain.dof());
        for (at, value) in entries.iter().enumerate() {
            let off = (value - jacobian[(at / chain.dof(), at % chain.dof())]).abs();
            assert!(off < 10.0 * near, "{id} J at {q:?}: off by {off}");
        }
        compared += 1;
        if rest[0] >= 0.0 {
            let expected = solver.solve(&pose).unwrap();
            assert_eq!(
                rest[0] as usize,
                expected.iter().count(),
                "{id} solutions at {q:?}"
            );
            let found: Vec<&[f64]> = rest[1..].chunks(chain.dof()).collect();
            for solution in expected.iter() {
                let near = |other: &&[f64]| {
                    other
                        .iter()
                        .zip(solution.q())
                        .all(|(a, b)| (a - b).sin().atan2((a - b).cos()).abs() < 1e-5)
                };
                assert!(
                    found.iter().any(near),
                    "{id} at {q:?}: {:?} is missing",
                    solution.q()
                );
            }
            solved += 1;
        }
    }
    assert_eq!(compared, POSES, "{id}");
    assert!(!solves || solved >= 300, "{id}: {solved}");
}

#[test]
fn c_on_every_kind_of_arm() {
    for id in [
        "ar3",
        "six-axis",
        "puma560",
        "ur5",
        "cobra600",
        "stanford",
        "ar4-modified",
        "jaco2",
        "iiwa7",
    ] {
        check(id, Language::C);
    }
}

#[test]
fn cpp() {
    ["ar3", "stanford"]
        .iter()
        .for_each(|id| check(id, Language::Cpp));
}

#[test]
fn rust() {
    ["ar3", "ur5"]
        .iter()
        .for_each(|id| check(id, Language::Rust));
}

#[test]
fn python() {
    ["ar3", "cobra600"]
        .iter()
        .for_each(|id| check(id, Language::Python));
}

#[test]
fn octave() {
    ["ar3", "ur5"]
        .iter()
        .for_each(|id| check(id, Language::Matlab));
}

/// An arm as calibration leaves it, with no two axes parallel and none that meet: its formulas would fill pages, its code does not.
#[test]
fn a_calibrated_arm() {
    let text = include_str!("../../../../examples/irb120-real.toml");
    let robot = Robot::from_toml("irb120-real.toml", text).unwrap();
    let arm = Arm::new(&robot, Lengths::Symbols).unwrap();
    assert!(
        arm.tool_pose().is_err(),
        "an arm of short formulas tests nothing here"
    );
    for language in [
        Language::C,
        Language::Cpp,
        Language::Rust,
        Language::Python,
        Language::Matlab,
    ] {
        // Axes 2 and 3 are nearly parallel: the table of their common perpendicular has them meters apart.
        check_robot("irb120-real", &robot, language, 1e-12);
    }
}

#[test]
fn single_precision_compiles() {
    let arm = Arm::new(
        &pieper_robots::find("six-axis").unwrap().robot(),
        Lengths::Symbols,
    )
    .unwrap();
    for (language, program, file) in [(Language::C, "gcc", "a.c"), (Language::Cpp, "g++", "a.cpp")]
    {
        if is_missing(program) {
            continue;
        }
        let folder = Folder::new(&format!("float-{language:?}"));
        folder.write(
            file,
            &code::generate(&arm, "arm", language, What::All, Precision::Float).unwrap(),
        );
        run(
            program,
            &[
                "-Wall",
                "-Wextra",
                "-Werror",
                "-DPIEPER_SELF_TEST",
                file,
                "-o",
                "self",
                "-lm",
            ],
            &folder.0,
        );
        run(&format!("{}/self", folder.0.display()), &[], &folder.0);
    }
    let refused =
        code::generate(&arm, "arm", Language::Python, What::All, Precision::Float).unwrap_err();
    assert!(
        refused.to_string().contains("single precision"),
        "{refused}"
    );
}

/// Sines and cosines apart, the best form found by hand for the AR3: the wrist's rotation (two columns), turned by
/// q2 - q3 and by q1, the third column as a cross product, the position along the way.
#[test]
fn the_ar3_takes_no_more_operations_than_by_hand() {
    let arm = Arm::new(
        &pieper_robots::find("ar3").unwrap().robot(),
        Lengths::Symbols,
    )
    .unwrap();
    let code::Operations {
        multiplications,
        additions,
    } = code::operations(&arm);
    assert!(
        multiplications + additions <= BY_HAND * 11 / 10,
        "{multiplications} * and {additions} +"
    );
}

/// 43 multiplications and 21 additions.
const BY_HAND: usize = 64;

/// The generated sines and cosines of C, compiled in four ways, against the standard library's: within a unit in the
/// last place of 1, at multiples of a quarter turn, far from 0, and what is not a number stays that.
#[test]
fn generated_sines_and_cosines_are_those_of_the_library() {
    if is_missing("gcc") {
        return;
    }
    let robot = pieper_robots::find("ar3").unwrap().robot();
    let arm = Arm::new(&robot, Lengths::Symbols).unwrap();
    let source =
        code::generate(&arm, "ar3", Language::C, What::Forward, Precision::Double).unwrap();
    let mut random = fastrand::Rng::with_seed(77);
    let mut angles: Vec<f64> = (0..30_000)
        .map(|_| (random.f64() - 0.5) * 10_f64.powf(6.0 * random.f64() - 1.0))
        .collect();
    angles.extend((-3000..3000).map(|k| f64::from(k) * std::f64::consts::FRAC_PI_4));
    angles.extend([
        0.0,
        1e-300,
        -1e-9,
        2e5,
        -1e15,
        1e300,
        f64::NAN,
        f64::INFINITY,
    ]);
    let folder = Folder::new("turns");
    let text: Vec<String> = angles.iter().map(|x| format!("{x:e}")).collect();
    folder.write("x.txt", &text.join("\n"));
    folder.write(
        "turns.c",
        &format!(
            "{source}#include <stdio.h>\nint main(void) {{ double x[2], s[2], c[2]; FILE *f = fopen(\"x.txt\", \"r\");\n\
             while (fscanf(f, \"%lf\", &x[0]) == 1) {{ x[1] = 0.5; ar3_turns(x, s, c, 2); printf(\"%.17g %.17g\\n\", s[0], c[0]); }} }}\n"
        ),
    );
    for flags in [
        &["-O0"][..],
        &["-O3"],
        &["-O3", "-march=native"],
        &["-Ofast"],
    ] {
        run(
            "gcc",
            &[flags, &["turns.c", "-o", "turns", "-lm"]].concat(),
            folder.path(),
        );
        let program = folder.path().join("turns");
        let out = run(program.to_str().unwrap(), &[], folder.path());
        assert_eq!(out.lines().count(), angles.len());
        for (x, line) in angles.iter().zip(out.lines()) {
            let (sin, cos) = line.split_once(' ').unwrap();
            let (sin, cos): (f64, f64) = (sin.parse().unwrap(), cos.parse().unwrap());
            let off = (sin - x.sin()).abs().max((cos - x.cos()).abs());
            if x.is_finite() {
                assert!(off < f64::EPSILON, "{flags:?}: {x:e} off by {off:e}");
            } else {
                // Of what is not a number -Ofast promises nothing.
                assert!(sin.is_nan() || flags == ["-Ofast"], "{flags:?}: {x:e}");
            }
        }
    }
}
