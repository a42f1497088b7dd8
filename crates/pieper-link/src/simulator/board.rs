//! What the simulated boards that speak lines of text have in common.

use std::time::Duration;

use crate::protocol::Lines;

/// How long a board is deaf after a reset.
const BOOTS: Duration = Duration::from_millis(800);

/// How often a board lets its motors move.
pub(super) const TICK: Duration = Duration::from_millis(5);

/// The line of a board: it is deaf while it boots, and answers lines by lines.
#[derive(Debug, Default)]
pub(super) struct Board {
    lines: Lines,
    boots_until: Duration,
}

impl Board {
    /// The board restarts: what it had half heard is forgotten.
    pub(super) fn reset(&mut self, now: Duration) {
        self.lines = Lines::default();
        self.boots_until = now + BOOTS;
    }

    /// Takes bytes; every line goes to `answer`, and what that says goes out. What is not understood is not answered.
    pub(super) fn receive(
        &mut self,
        now: Duration,
        bytes: &[u8],
        out: &mut Vec<u8>,
        mut answer: impl FnMut(&str) -> Option<String>,
    ) {
        if now < self.boots_until {
            return;
        }
        self.lines.push(bytes, |line| {
            if let Some(text) = line.ok().and_then(&mut answer) {
                say(&text, out);
            }
        });
    }
}

/// A line, as these boards end it.
pub(super) fn say(text: &str, out: &mut Vec<u8>) {
    out.extend_from_slice(text.as_bytes());
    out.extend_from_slice(b"\r\n");
}
