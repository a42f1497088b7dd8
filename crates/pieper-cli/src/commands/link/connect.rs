//! `pieper link connect`

use std::time::{Duration, Instant};

use clap::Args;
use pieper_link::Phase;

use super::line::Line;
use super::live::{self, Live};
use crate::error::{Failure, Outcome};
use crate::output;

/// Show where a real arm is, and move nothing
#[derive(Args)]
#[command(after_help = "\
Examples, with `pieper link simulate ar4 --tcp 7004` running:
  pieper link connect --to tcp:127.0.0.1:7004 --seconds 2
  pieper link connect --to tcp:127.0.0.1:7004 --protocol ar4 --seconds 2 --json")]
pub(crate) struct Arguments {
    #[command(flatten)]
    line: Line,

    /// For how long (default: until Ctrl+C)
    #[arg(long, value_name = "S")]
    seconds: Option<f64>,

    /// One JSON document at the end
    #[arg(long)]
    json: bool,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        live::catch_interrupts();
        let connected = self.line.connect(0.25)?;
        let (session, arm) = (&connected.session, &connected.arm);
        let begun = Instant::now();
        let end = self
            .seconds
            .map(|seconds| Duration::from_secs_f64(seconds.clamp(0.0, 1e6)));
        let mut live = Live::new(self.json);
        if !self.json {
            let who = session.status().identity.unwrap_or_default();
            output::answer(&format!("{}: {who}\n", connected.address))?;
        }
        let status = live.until(session, arm, |status| {
            let is_over = end.is_some_and(|end| begun.elapsed() >= end);
            is_over || status.phase == Phase::Lost
        })?;
        live.finish();
        if self.json {
            output::document(&live::document(&connected, &status))?;
        }
        match status.phase {
            Phase::Lost => Err(Failure::World(status.sentence.unwrap_or_default())),
            _ => Ok(Outcome::Done),
        }
    }
}
