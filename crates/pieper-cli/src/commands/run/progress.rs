//! A bar on standard error once the work has taken a second; none if nobody watches.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// Pieces of work in a run: the poses, and for each of eight figures drawing and writing it, and the rest.
const PIECES: u64 = 18;

/// What finding joint values for a path of the tool counts.
const TRACKING: u64 = 40;

pub(super) struct Progress {
    started: Instant,
    done: u64,
    pieces: u64,
    bar: Option<ProgressBar>,
}

impl Progress {
    pub(super) fn new() -> Self {
        Self {
            started: Instant::now(),
            done: 0,
            pieces: PIECES,
            bar: None,
        }
    }

    /// Such a share of finding joint values is done.
    pub(super) fn track(&mut self, share: f64) {
        self.pieces = PIECES + TRACKING;
        self.done = (share * TRACKING as f64) as u64;
        self.show();
    }

    /// A piece of the work is done.
    pub(super) fn advance(&mut self) {
        self.done += 1;
        self.show();
    }

    fn show(&mut self) {
        if let Some(bar) = &self.bar {
            bar.set_position(self.done);
        } else if self.started.elapsed() > Duration::from_secs(1) {
            let bar = ProgressBar::new(self.pieces).with_position(self.done);
            if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} {elapsed}") {
                bar.set_style(style);
            }
            self.bar = Some(bar);
        }
    }

    pub(super) fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
