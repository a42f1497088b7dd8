//! `cargo run --release -p pieper-symbolic --example generated`: the AR3's generated forward kinematics beside the library's own, on the
//! same 1,024 joint vectors. Needs gcc.

use std::fs;
use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

use pieper::kinematics;
use pieper_symbolic::code::{self, Language, Precision, What};
use pieper_symbolic::{Arm, Lengths};

const ROUNDS: usize = 200;

/// Times itself: the least of several rounds, nanoseconds a call.
const DRIVER: &str = r#"
#include <stdio.h>
#include <time.h>
int main(void) {
    static double q[1024][6];
    static double T[3][4];
    for (int i = 0; i < 1024; ++i)
        for (int j = 0; j < 6; ++j) scanf("%lf", &q[i][j]);
    double least = 1e9, sum = 0;
    for (int round = 0; round < 200; ++round) {
        struct timespec a, b;
        clock_gettime(CLOCK_MONOTONIC, &a);
        for (int i = 0; i < 1024; ++i) {
            ar3_fk(q[i], T);
            sum += T[0][3];
        }
        clock_gettime(CLOCK_MONOTONIC, &b);
        const double ns = ((b.tv_sec - a.tv_sec) * 1e9 + (b.tv_nsec - a.tv_nsec)) / 1024;
        if (ns < least) least = ns;
    }
    printf("%.1f %g\n", least, sum);
    return 0;
}
"#;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let robot = pieper_robots::find("ar3")
        .ok_or("the AR3 is built in")?
        .robot();
    let (chain, arm) = (robot.chain()?, Arm::new(&robot, Lengths::Symbols)?);
    let mut random = fastrand::Rng::with_seed(1);
    let inputs: Vec<[f64; 6]> = (0..1024)
        .map(|_| std::array::from_fn(|_| 6.0 * random.f64() - 3.0))
        .collect();
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        for q in &inputs {
            black_box(kinematics::tool_pose(&chain, black_box(q))?);
        }
        least = least.min(start.elapsed().as_secs_f64() * 1e9 / inputs.len() as f64);
    }
    let folder = std::env::temp_dir().join(format!("pieper-generated-{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    let source = code::generate(&arm, "ar3", Language::C, What::Forward, Precision::Double)?;
    fs::write(
        folder.join("fk.c"),
        format!("#define _POSIX_C_SOURCE 199309L\n{source}{DRIVER}"),
    )?;
    let numbers: Vec<String> = inputs.iter().flatten().map(f64::to_string).collect();
    fs::write(folder.join("q.txt"), numbers.join(" "))?;
    let mut out = format!(
        "| forward kinematics of the AR3 | ns |\n|---|---|\n| the library | {least:.1} |\n"
    );
    for flags in [&["-O3"][..], &["-O3", "-march=native"]] {
        let status = Command::new("gcc")
            .args(flags)
            .args(["fk.c", "-o", "fk", "-lm"])
            .current_dir(&folder)
            .status()?;
        if !status.success() {
            return Err("gcc refused the generated code".into());
        }
        let input = fs::File::open(folder.join("q.txt"))?;
        let run = Command::new(folder.join("fk")).stdin(input).output()?;
        let text = String::from_utf8(run.stdout)?;
        let ns = text.split_whitespace().next().unwrap_or("?");
        out.push_str(&format!(
            "| generated C, gcc {} | {ns} |\n",
            flags.join(" ")
        ));
    }
    fs::remove_dir_all(&folder)?;
    print(&out);
    Ok(())
}

#[allow(clippy::print_stdout, reason = "this is what the example is for")]
fn print(text: &str) {
    print!("{text}");
}
