//! `pieper link`

mod connect;
mod home;
mod jog;
mod line;
mod list;
mod live;
mod log;
mod map;
mod send;
mod simulate;

use clap::{Args, Subcommand};

use crate::error::{Failure, Outcome};

/// Real and simulated controllers: watch an arm, move it, run motions on it
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper link list
  pieper link simulate ar4 --tcp 7004                       a controller that is not there
  pieper link send examples/ar4-programme.csv --protocol ar4   check a motion; nothing is sent

With a controller on a line, real or simulated:
  pieper link connect --to tcp:127.0.0.1:7004
  pieper link send examples/ar4-programme.csv --to tcp:127.0.0.1:7004 --protocol ar4 --arm

A connection shows only. Nothing moves without --arm; the first set-point is where the arm is; joint and motor limits, rates and \
accelerations are kept; Ctrl+C, silence of either side, or a joint that does not follow stop it. Every session is recorded: \
`pieper link log` shows the last one.")]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Link,
}

#[derive(Subcommand)]
enum Link {
    /// List the serial ports and the protocols
    List(list::Arguments),
    /// Serve a simulated controller, with faults on demand
    Simulate(simulate::Arguments),
    /// Show where a real arm is, and move nothing
    Connect(connect::Arguments),
    /// Have a controller find its limit switches, so that it knows where the arm is
    Home(home::Arguments),
    /// Move one joint by a little
    Jog(jog::Arguments),
    /// Run a motion table on an arm
    Send(send::Arguments),
    /// Match servos to joints at their extreme positions
    Map(map::Arguments),
    /// Show a recorded session, plot it, or take its motion out
    Log(log::Arguments),
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        match self.command {
            Link::List(arguments) => arguments.run(),
            Link::Simulate(arguments) => arguments.run(),
            Link::Connect(arguments) => arguments.run(),
            Link::Home(arguments) => arguments.run(),
            Link::Jog(arguments) => arguments.run(),
            Link::Send(arguments) => arguments.run(),
            Link::Map(arguments) => arguments.run(),
            Link::Log(arguments) => arguments.run(),
        }
    }
}

/// A joint by its name, or its number from 1.
fn joint_of(arm: &pieper_link::Arm, name: &str) -> Result<usize, Failure> {
    let named = (0..arm.dof()).find(|&index| arm.joint_name(index) == name);
    let numbered = || {
        let number: usize = name.parse().ok()?;
        number.checked_sub(1).filter(|&index| index < arm.dof())
    };
    named.or_else(numbered).ok_or_else(|| {
        let names: Vec<_> = (0..arm.dof()).map(|index| arm.joint_name(index)).collect();
        let names = names.join(", ");
        Failure::input(format!("joint {name}: one of {names} was expected"))
    })
}
