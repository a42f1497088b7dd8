//! Live numbers while an arm is watched or moved.

use std::io::{IsTerminal as _, stdout};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use pieper_link::{Arm, Phase, Session, Status};
use serde_json::{Value, json};

use super::line::Connected;
use crate::error::Failure;
use crate::output;

/// How often the arm's driver is heard of, and the numbers are looked at.
const BEAT: Duration = Duration::from_millis(40);

/// Ctrl+C was pressed.
static STOP: AtomicBool = AtomicBool::new(false);

/// Makes Ctrl+C stop the arm before the program ends.
pub(super) fn catch_interrupts() {
    // Without it, Ctrl+C still ends the program, and silence stops the arm.
    let _ = ctrlc::set_handler(|| STOP.store(true, Ordering::SeqCst));
}

/// Shows numbers, in one line of a terminal, or a line a second elsewhere.
pub(super) struct Live {
    bar: Option<ProgressBar>,
    is_quiet: bool,
    said: Instant,
    is_first: bool,
    /// The worst over the whole time: the joint and the error.
    worst: Option<(usize, f64)>,
}

impl Live {
    pub(super) fn new(is_quiet: bool) -> Self {
        let bar = (!is_quiet && stdout().is_terminal()).then(|| {
            let bar = ProgressBar::new_spinner();
            if let Ok(style) = ProgressStyle::with_template("{spinner} {wide_msg}") {
                bar.set_style(style);
            }
            bar
        });
        Self {
            bar,
            is_quiet,
            said: Instant::now(),
            is_first: true,
            worst: None,
        }
    }

    /// Beats and shows until something is so, or Ctrl+C is pressed: then the arm is stopped. The last that showed.
    pub(super) fn until(
        &mut self,
        session: &Session,
        arm: &Arm,
        mut is_so: impl FnMut(&Status) -> bool,
    ) -> Result<Status, Failure> {
        let mut is_stopping = false;
        loop {
            session.beat();
            let status = session.status();
            self.show(&status, arm)?;
            if is_so(&status) || (is_stopping && !status.phase.is_live()) {
                return Ok(status);
            }
            if STOP.load(Ordering::SeqCst) && !is_stopping {
                is_stopping = true;
                // A connection that is gone has stopped already, and shows so.
                let _ = session.stop();
            }
            std::thread::sleep(BEAT);
        }
    }

    fn show(&mut self, status: &Status, arm: &Arm) -> Result<(), Failure> {
        if let Some((joint, error)) = status.error {
            let is_worse = self
                .worst
                .is_none_or(|(_, worst)| error.abs() > worst.abs());
            if is_worse {
                self.worst = Some((joint, error));
            }
        }
        let is_due = self.is_first || self.said.elapsed() >= Duration::from_secs(1);
        match &self.bar {
            Some(bar) => {
                bar.set_message(line(status, arm));
                bar.tick();
            }
            None if !self.is_quiet && is_due => {
                self.said = Instant::now();
                self.is_first = false;
                output::answer(&format!("{}\n", line(status, arm)))?;
            }
            None => {}
        }
        Ok(())
    }

    /// Clears the live line.
    pub(super) fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }

    /// The worst tracking error so far, in words.
    pub(super) fn worst(&self, arm: &Arm) -> Option<String> {
        let (joint, error) = self.worst?;
        Some(format!(
            "{} ({})",
            arm.shown(joint, error.abs()),
            arm.joint_name(joint)
        ))
    }
}

/// One line of numbers.
fn line(status: &Status, arm: &Arm) -> String {
    let mut parts = vec![status.phase.name().to_owned()];
    if let Some([at, of]) = status.progress {
        parts.push(format!("{at:.1} of {of:.1} s"));
    }
    if let Some(q) = &status.measured {
        let joint = |(joint, value): (usize, &f64)| arm.shown(joint, *value);
        parts.push(
            q.iter()
                .enumerate()
                .map(joint)
                .collect::<Vec<_>>()
                .join(" "),
        );
    }
    if let Some((joint, error)) = status.error.filter(|_| status.phase != Phase::Watching) {
        parts.push(format!("error {}", arm.shown(joint, error.abs())));
    }
    if let Some(lag) = status.lag.filter(|_| status.phase.is_live()) {
        parts.push(format!("lag {:.0} ms", lag * 1e3));
    }
    if let Some(latency) = status.latency {
        parts.push(format!("answer {:.1} ms", latency.as_secs_f64() * 1e3));
    }
    if status.dropped.0 > 0 {
        parts.push(format!("{} dropped", status.dropped.0));
    }
    parts.join("  ")
}

/// A status for other programs.
pub(super) fn document(connected: &Connected, status: &Status) -> Value {
    let seconds = |time: Duration| time.as_secs_f64();
    json!({
        "robot": connected.arm.name,
        "protocol": connected.kind.name(),
        "address": connected.address.to_string(),
        "controller": status.identity,
        "phase": status.phase.name(),
        "sentence": status.sentence,
        "measured": status.measured,
        "commanded": status.commanded,
        "latency": status.latency.map(seconds),
        "lag": status.lag,
        "sent": status.sent,
        "late": status.late,
        "dropped": status.dropped.0,
        "record": connected.record.display().to_string(),
    })
}

/// Whether the measured joints have arrived where they were sent, or half a second has passed: some controllers lag.
pub(super) fn settled() -> impl FnMut(&Status) -> bool {
    let begun = Instant::now();
    move |status| {
        let is_near = status.error.is_some_and(|(_, error)| error.abs() < 1e-3);
        is_near || !status.phase.is_live() || begun.elapsed() > Duration::from_millis(500)
    }
}
