//! `pieper link simulate`

use std::io::BufRead as _;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use clap::Args;
use pieper_link::Kind;
use pieper_link::simulator::{Fault, Place, Served};

use super::line::Which;
use crate::error::{Failure, Outcome};
use crate::output;

/// Serve a simulated controller, with faults on demand
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper link simulate ar4 --seconds 1
  pieper link simulate packets --tcp 7001 --fault estop@0.5 --seconds 1
  pieper link simulate egm --call 127.0.0.1:6510 --robot irb120 --seconds 1

The first line of the output is the address for --to. Without --tcp the line is a pseudo-terminal, which is opened like a serial port. \
While it runs, the name of a fault and Enter lets it happen: corrupt, truncate, duplicate, reorder, flood, mute, unplug, reset, estop, \
lose-steps, clock-jump.")]
pub(crate) struct Arguments {
    /// What it speaks: ar4, ar3, ros, servo, egm, packets
    #[arg(value_name = "KIND")]
    kind: Kind,

    #[command(flatten)]
    which: Which,

    /// Serve on this TCP port of this computer (0: one that is free), instead of a pseudo-terminal
    #[arg(long, value_name = "PORT", conflicts_with = "call")]
    tcp: Option<u16>,

    /// EGM: the program to call
    #[arg(long, value_name = "HOST:PORT")]
    call: Option<String>,

    /// Something that goes wrong, so many seconds after the start (repeatable)
    #[arg(long, value_name = "FAULT@SECONDS", value_parser = fault)]
    fault: Vec<(Fault, f64)>,

    /// For how long (default: until Ctrl+C)
    #[arg(long, value_name = "S")]
    seconds: Option<f64>,
}

/// Where ABB's own examples expect their sensor.
const EGM: &str = "127.0.0.1:6510";

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let arm = self.which.arm(self.kind)?;
        let place = match (self.kind, self.tcp, &self.call) {
            (_, _, Some(call)) => Place::Calls(call.clone()),
            (Kind::Egm, ..) => Place::Calls(EGM.to_owned()),
            (_, Some(port), _) => Place::Tcp(port),
            _ => Place::Terminal,
        };
        let served = Served::start(self.kind, &arm, &place).map_err(Failure::World)?;
        output::answer(&format!("{}\n", served.address()))?;
        output::note(&format!(
            "a simulated controller that speaks {}, with {}; a fault's name and Enter lets it happen",
            self.kind, arm.name
        ));
        self.serve(&served);
        Ok(Outcome::Done)
    }

    fn serve(&self, served: &Served) {
        let begun = Instant::now();
        let typed = typed();
        let mut waiting = self.fault.clone();
        while served.is_running() {
            let now = begun.elapsed().as_secs_f64();
            if self.seconds.is_some_and(|end| now >= end) {
                return;
            }
            waiting.retain(|(fault, at)| {
                let is_due = now >= *at;
                if is_due {
                    output::note(&format!("{fault} at {now:.1} s"));
                    served.inject(*fault);
                }
                !is_due
            });
            while let Ok(line) = typed.try_recv() {
                match line.parse::<Fault>() {
                    Ok(fault) => served.inject(fault),
                    Err(error) => output::warning(&error),
                }
            }
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}

/// Lines that are typed while it runs.
fn typed() -> Receiver<String> {
    let (send, receive) = channel();
    // It waits for a line that may never come, and ends with the program.
    std::thread::spawn(move || {
        for line in std::io::stdin().lock().lines().map_while(Result::ok) {
            let line = line.trim().to_owned();
            if !line.is_empty() && send.send(line).is_err() {
                return;
            }
        }
    });
    receive
}

/// `estop@1.5`, or `estop` for at once.
fn fault(text: &str) -> Result<(Fault, f64), String> {
    let (fault, at) = text.split_once('@').unwrap_or((text, "0"));
    let at = at.parse().ok().filter(|at: &f64| *at >= 0.0);
    let at = at.ok_or_else(|| format!("{text}: seconds were expected after @"))?;
    Ok((fault.parse()?, at))
}
