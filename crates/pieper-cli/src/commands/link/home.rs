//! `pieper link home`

use std::time::{Duration, Instant};

use clap::Args;

use super::line::Line;
use super::live::{self, Live};
use crate::error::{Failure, Outcome};
use crate::output;

/// Longer than it takes to tell a position as often as a leap needs to be believed.
const BELIEVED: Duration = Duration::from_millis(1200);

/// Have a controller find its limit switches, so that it knows where the arm is
#[derive(Args)]
#[command(after_help = "\
Examples, with `pieper link simulate ar4 --tcp 7004` running:
  pieper link home --to tcp:127.0.0.1:7004 --protocol ar4 --arm
  pieper link home J4 J5 --to tcp:127.0.0.1:7004 --protocol ar4 --arm

An AR4 that was just switched on does not know where it is; nor does one whose motors have lost steps. The controller drives the joints \
to their switches by its own rules: no limits and no rates of the robot's description are kept, and Ctrl+C does not end it. Keep \
the emergency stop within reach. Without --arm nothing moves.")]
pub(crate) struct Arguments {
    /// The joints, by their names or numbers from 1 (default: all)
    #[arg(value_name = "JOINTS")]
    joints: Vec<String>,

    #[command(flatten)]
    line: Line,

    /// Let it move
    #[arg(long)]
    arm: bool,

    /// One JSON document at the end
    #[arg(long)]
    json: bool,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        live::catch_interrupts();
        let connected = self.line.connect(1.0)?;
        let (session, arm) = (&connected.session, &connected.arm);
        let mut joints = vec![self.joints.is_empty(); arm.dof()];
        for name in &self.joints {
            joints[super::joint_of(arm, name)?] = true;
        }
        if !self.arm {
            let named = (0..arm.dof()).filter(|&joint| joints[joint]);
            let names: Vec<_> = named.map(|joint| arm.joint_name(joint)).collect();
            let names = names.join(", ");
            output::answer(&format!(
                "{names} would look for their switches; nothing was sent: --arm moves them\n"
            ))?;
            return Ok(Outcome::Done);
        }
        if let Err(refusal) = session.home(&joints) {
            output::error(&format!("refused: {refusal}"));
            return Ok(Outcome::Negative);
        }
        let mut live = Live::new(self.json);
        let status = live.until(session, arm, |status| {
            !status.is_homing || status.phase == pieper_link::Phase::Lost
        })?;
        live.finish();
        if status.is_homing && status.phase != pieper_link::Phase::Lost {
            let text =
                "this program was interrupted; the controller goes on looking for its switches";
            return Err(Failure::World(text.to_owned()));
        }
        if let Some(sentence) = status.sentence {
            return Err(Failure::World(sentence));
        }
        // A leap to the new position is believed when it has been told a few times.
        let found = Instant::now();
        let status = live.until(session, arm, |_| found.elapsed() > BELIEVED)?;
        live.finish();
        match self.json {
            true => output::document(&live::document(&connected, &status))?,
            false => {
                let places = status.measured.unwrap_or_default();
                let places = places.iter().enumerate();
                let places: Vec<_> = places.map(|(joint, q)| arm.shown(joint, *q)).collect();
                output::answer(&format!("homed: {}\n", places.join(" ")))?;
            }
        }
        Ok(Outcome::Done)
    }
}
