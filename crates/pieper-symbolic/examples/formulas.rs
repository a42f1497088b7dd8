//! `cargo run --release -p pieper-symbolic --example formulas -- ar3`: the tool's pose as formulas.

use pieper_symbolic::{Arm, Lengths, basis, form, print};

fn main() -> pieper::Result<()> {
    let id = std::env::args().nth(1).unwrap_or_else(|| "ar3".to_owned());
    let Some(robot) = pieper_robots::find(&id) else {
        return Err(pieper::Error::input(id, "no built-in robot has this name"));
    };
    let start = std::time::Instant::now();
    let arm = Arm::new(&robot.robot(), Lengths::Symbols)?;
    let pose = arm.tool_pose()?;
    let sums = basis::cumulative(&arm);
    let mut out = String::new();
    for column in 0..4 {
        for row in 0..3 {
            let short = sums.rewrite(&pose.0[row][column]);
            let text = print::text(&form::of(&arm.names, &short), &arm.names);
            out.push_str(&format!("t{}{} = {text}\n", row + 1, column + 1));
        }
    }
    print_out(&format!("{out}{:?}\n", start.elapsed()));
    Ok(())
}

#[allow(clippy::print_stdout, reason = "an example shows its answer")]
fn print_out(text: &str) {
    print!("{text}");
}
