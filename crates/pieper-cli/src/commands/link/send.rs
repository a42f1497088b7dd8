//! `pieper link send`

use std::path::PathBuf;
use std::sync::Arc;

use clap::{Args, ValueEnum};
use pieper::describe::{MotionTable, MotionValues};
use pieper::motion::{Law, Profile};
use pieper_link::safety::Envelope;
use pieper_link::{Phase, Status};
use serde_json::json;

use super::line::{Connected, Line};
use super::live::{self, Live};
use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::read_text;

/// Run a motion table on an arm
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper link send examples/ar4-programme.csv --protocol ar4
  pieper link send examples/ar4-programme.csv --protocol ar4 --speed 0.5

With `pieper link simulate ar4 --tcp 7004` running:
  pieper link send examples/ar4-programme.csv --to tcp:127.0.0.1:7004 --protocol ar4 --arm

Without --arm the motion is checked against limits, rates and accelerations, and nothing is sent. With it the arm first goes to the \
motion's first row, by at most a quarter of its rates. A table of poses becomes one of joints by `pieper run`, which writes joints.csv.")]
pub(crate) struct Arguments {
    /// A motion table of joint values: CSV with the columns t, q1, q2, ...
    #[arg(value_name = "MOTION")]
    motion: PathBuf,

    #[command(flatten)]
    line: Line,

    /// Arm the controller: what moves in the program moves in reality
    #[arg(long)]
    arm: bool,

    /// The course of the moves between rows
    #[arg(long, value_name = "PROFILE", default_value = "cubic")]
    profile: Course,

    /// How fast, 1 as the table says
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    speed: f64,

    /// One JSON document at the end
    #[arg(long)]
    json: bool,
}

/// The course of a move in time. Rates that jump are no choice: no arm can follow them.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Course {
    /// Smooth start and stop at every row
    Cubic,
    /// Accelerations start and stop smoothly too
    Quintic,
    /// A third of the time speeding up, a third at constant rate, a third slowing down
    Trapezoid,
}

/// The share of the arm's rates that it goes to the start of a motion with.
const APPROACH: f64 = 0.25;

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        live::catch_interrupts();
        // A connection shows only: it may be made before the motion is known to be allowed, and it tells which arm is there.
        let connected = match self.arm {
            true => Some(self.line.connect(1.0)?),
            false => None,
        };
        let arm = match &connected {
            Some(connected) => Arc::clone(&connected.arm),
            None => self.line.which.arm(self.line.kind())?,
        };
        let law = self.law(&arm)?;
        if let Err(refusal) = Envelope::of(Arc::clone(&arm), 1.0).allows_motion(&law) {
            let text = format!("{}: refused: {refusal}", self.motion.display());
            match self.json {
                true => output::document(&json!({ "error": text }))?,
                false => output::error(&text),
            }
            return Ok(Outcome::Negative);
        }
        let times = law.times();
        let duration = times[times.len() - 1] - times[0];
        let what = format!(
            "{}: {} rows, {duration:.1} s, within the limits of {}",
            self.motion.display(),
            times.len(),
            arm.name
        );
        let Some(connected) = connected else {
            match self.json {
                true => output::document(&json!({
                    "rows": times.len(), "duration": duration, "allowed": true, "sent": 0,
                }))?,
                false => output::answer(&format!(
                    "{what}; nothing was sent: --arm and --to run it\n"
                ))?,
            }
            return Ok(Outcome::Done);
        };
        if !self.json {
            let who = connected.session.status().identity.unwrap_or_default();
            output::answer(&format!("{what}\n{}: {who}\n", connected.address))?;
        }
        let mut live = Live::new(self.json);
        let status = self.play(&connected, law, &mut live)?;
        live.finish();
        // The arm holds where it is, whatever the answer; a connection that is gone holds too.
        let _ = connected.session.disarm();
        self.report(&connected, &status, &live)
    }

    /// The motion, at the speed asked for.
    fn law(&self, arm: &pieper_link::Arm) -> Result<Law, Failure> {
        if !(self.speed > 0.0 && self.speed <= 100.0) {
            return Err(Failure::input(format!(
                "--speed {}: a factor above 0 and at most 100 was expected",
                self.speed
            )));
        }
        let name = self.motion.display().to_string();
        let table = MotionTable::from_csv(&name, &read_text(&self.motion)?, &arm.chain)?;
        let MotionValues::Joints(rows) = table.values else {
            return Err(Failure::input(format!(
                "{name}: a table of joint values was expected: `pieper run` makes one, joints.csv, of a table of poses"
            )));
        };
        let times = table.times.iter().map(|time| time / self.speed).collect();
        let profile = match self.profile {
            Course::Cubic => Profile::Cubic,
            Course::Quintic => Profile::Quintic,
            Course::Trapezoid => Profile::Trapezoid,
        };
        Ok(Law::new(times, rows, profile)?)
    }

    /// Goes to the first row, slowly, and runs the motion.
    fn play(&self, connected: &Connected, law: Law, live: &mut Live) -> Result<Status, Failure> {
        let (session, arm) = (&connected.session, &connected.arm);
        let refused = |refusal: pieper_link::safety::Refusal| Failure::World(refusal.0);
        session.arm().map_err(refused)?;
        session.set_share(APPROACH).map_err(refused)?;
        session.set_target(&law.rows()[0]).map_err(refused)?;
        let there = live.until(session, arm, |status| status.phase != Phase::Moving)?;
        if there.phase != Phase::Holding {
            return Ok(there);
        }
        live.until(session, arm, live::settled())?;
        session.set_share(1.0).map_err(refused)?;
        session.play(law).map_err(refused)?;
        let status = live.until(session, arm, |status| status.phase != Phase::Playing)?;
        match status.phase {
            Phase::Holding => live.until(session, arm, live::settled()),
            _ => Ok(status),
        }
    }

    fn report(
        &self,
        connected: &Connected,
        status: &Status,
        live: &Live,
    ) -> Result<Outcome, Failure> {
        let is_done = status.phase == Phase::Holding;
        if self.json {
            let mut document = live::document(connected, status);
            document["completed"] = json!(is_done);
            document["worst_error"] = json!(live.worst(&connected.arm));
            output::document(&document)?;
        }
        let record = connected.record.display();
        if !is_done {
            let said = status.sentence.clone().unwrap_or_default();
            return Err(Failure::World(format!(
                "{said}; the session is recorded in {record}"
            )));
        }
        if !self.json {
            let mut parts = vec![format!("done: {} set-points sent", status.sent)];
            if let Some(worst) = live.worst(&connected.arm) {
                parts.push(format!("at most {worst} from where it was sent"));
            }
            if status.late > 0 {
                parts.push(format!("{} of them late", status.late));
            }
            output::answer(&format!("{}\nrecorded in {record}\n", parts.join(", ")))?;
        }
        Ok(Outcome::Done)
    }
}
