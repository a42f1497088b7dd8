//! `pieper link jog`

use clap::Args;
use pieper::describe::expr;
use pieper_link::Phase;

use super::line::Line;
use super::live::{self, Live};
use crate::error::{Failure, Outcome};
use crate::output;

/// Move one joint by a little
#[derive(Args)]
#[command(after_help = "\
Examples, with `pieper link simulate ar4 --tcp 7004` running:
  pieper link jog J2 -5deg --to tcp:127.0.0.1:7004 --protocol ar4 --arm

Without --arm nothing moves.")]
pub(crate) struct Arguments {
    /// The joint, by its name or its number from 1
    #[arg(value_name = "JOINT")]
    joint: String,

    /// How far: 5deg, -0.1, 10mm
    #[arg(value_name = "BY", allow_hyphen_values = true)]
    by: String,

    #[command(flatten)]
    line: Line,

    /// Arm the controller: what moves in the program moves in reality
    #[arg(long)]
    arm: bool,

    /// The share of the arm's rates and accelerations that may be used, up to 1
    #[arg(long, value_name = "SHARE", default_value_t = 0.25)]
    speed: f64,

    /// One JSON document at the end
    #[arg(long)]
    json: bool,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        live::catch_interrupts();
        let by = self.by()?;
        let connected = self.line.connect(self.speed)?;
        let (session, arm) = (&connected.session, &connected.arm);
        let joint = super::joint_of(arm, &self.joint)?;
        let mut q = session.status().measured.unwrap_or_default();
        let from = q[joint];
        q[joint] += by;
        let (name, a, b) = (
            arm.joint_name(joint),
            arm.shown(joint, from),
            arm.shown(joint, q[joint]),
        );
        if !self.arm {
            output::answer(&format!(
                "{name} would move from {a} to {b}; nothing was sent: --arm moves it\n"
            ))?;
            return Ok(Outcome::Done);
        }
        session.arm().map_err(|refusal| Failure::World(refusal.0))?;
        if let Err(refusal) = session.set_target(&q) {
            // It is disarmed by the connection's end too; said, it is sure.
            let _ = session.disarm();
            output::error(&format!("refused: {refusal}"));
            return Ok(Outcome::Negative);
        }
        let mut live = Live::new(self.json);
        let status = live.until(session, arm, |status| status.phase != Phase::Moving)?;
        live.finish();
        let status = match status.phase {
            Phase::Holding => live.until(session, arm, live::settled())?,
            _ => status,
        };
        if self.json {
            output::document(&live::document(&connected, &status))?;
        }
        if status.phase != Phase::Holding {
            return Err(Failure::World(status.sentence.unwrap_or_default()));
        }
        // The arm holds where it is, whatever the answer.
        let _ = session.disarm();
        if !self.json {
            let now = status.measured.map_or(q[joint], |q| q[joint]);
            output::answer(&format!(
                "{name} moved from {a} to {}\n",
                arm.shown(joint, now)
            ))?;
        }
        Ok(Outcome::Done)
    }

    fn by(&self) -> Result<f64, Failure> {
        expr::typed(&self.by).map_err(|error| Failure::input(format!("BY = {error}")))
    }
}
