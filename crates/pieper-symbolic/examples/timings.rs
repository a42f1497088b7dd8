//! `cargo run --release -p pieper-symbolic --example timings`: how long the formulas of every built-in arm take.

use std::fmt::Write as _;
use std::time::{Duration, Instant};

use pieper_symbolic::sheet::Format;
use pieper_symbolic::{Arm, Lengths, code, derive};

fn main() -> pieper::Result<()> {
    let mut out = String::from(
        "| arm | joints | T ms | forward sheet ms | inverse sheet ms | code * + |\n|---|---|---|---|---|---|\n",
    );
    let ms = |start: Instant| start.elapsed().max(Duration::from_nanos(1)).as_secs_f64() * 1e3;
    for robot in pieper_robots::ALL {
        let described = robot.robot();
        let start = Instant::now();
        let arm = Arm::new(&described, Lengths::Symbols)?;
        arm.tool_pose()?;
        let pose = ms(start);
        let start = Instant::now();
        derive::sheet(&arm, derive::Scope::Forward)?.print(Format::Text);
        let forward = ms(start);
        let start = Instant::now();
        let inverse = match derive::sheet(&arm, derive::Scope::Inverse) {
            Ok(sheet) => {
                sheet.print(Format::Text);
                format!("{:.1}", ms(start))
            }
            Err(_) => format!("none ({:.1})", ms(start)),
        };
        let code::Operations {
            multiplications,
            additions,
        } = code::operations(&arm);
        let _ = writeln!(
            out,
            "| {} | {} | {pose:.2} | {forward:.1} | {inverse} | {multiplications} {additions} |",
            robot.id,
            arm.dof()
        );
    }
    print_out(&out);
    Ok(())
}

#[allow(clippy::print_stdout, reason = "an example shows its answer")]
fn print_out(text: &str) {
    print!("{text}");
}
