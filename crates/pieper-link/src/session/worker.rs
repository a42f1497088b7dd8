//! The thread of a session: reads, decides, sends, shows, records.

use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::sync::mpsc::{Receiver, Sender};
use std::time::{Duration, Instant};

use pieper::motion::Law;

use super::record::Recorder;
use super::{Shared, Status};
use crate::protocol::{Event, Host, Pace};
use crate::safety::{Guard, Phase, Refusal};
use crate::transport::Transport;

/// What the owner of a session wants.
pub(super) enum Ask {
    Arm(Sender<Result<(), Refusal>>),
    Share(f64, Sender<Result<(), Refusal>>),
    Target(Vec<f64>, Sender<Result<(), Refusal>>),
    Play(Law, Sender<Result<(), Refusal>>),
    Home(Vec<bool>, Sender<Result<(), Refusal>>),
    Disarm(Sender<Result<(), Refusal>>),
    /// With the time at which it was said, so that waiting in line does not make it younger.
    Beat(Duration),
}

/// The longest wait for bytes: commands are looked at this often.
const LONGEST: Duration = Duration::from_millis(10);

/// Bytes read at once.
const BUFFER: usize = 2048;

/// The share of the lag's sums that is kept from one cycle to the next.
const KEPT: f64 = 0.97;

pub(super) struct Worker {
    cable: Box<dyn Transport>,
    host: Box<dyn Host>,
    guard: Guard,
    shared: Arc<Shared>,
    asks: Receiver<Ask>,
    record: Option<Recorder>,
    start: Instant,
    out: Vec<u8>,
    events: Vec<Event>,
    /// When the last set-point went out, and when the next is due.
    last: Duration,
    due: Duration,
    was_live: bool,
    before: Vec<f64>,
    /// Sums for the lag: of error times rate, and of rate times rate.
    lag: [f64; 2],
    status: Status,
}

impl Worker {
    pub(super) fn new(
        cable: Box<dyn Transport>,
        host: Box<dyn Host>,
        guard: Guard,
        shared: Arc<Shared>,
        asks: Receiver<Ask>,
        record: Option<Recorder>,
        start: Instant,
    ) -> Self {
        Self {
            before: vec![0.0; guard.arm().dof()],
            cable,
            host,
            guard,
            shared,
            asks,
            record,
            start,
            out: Vec::with_capacity(BUFFER),
            events: Vec::with_capacity(32),
            last: Duration::ZERO,
            due: Duration::ZERO,
            was_live: false,
            lag: [0.0; 2],
            status: Status::new(),
        }
    }

    pub(super) fn run(mut self) {
        let mut buffer = [0; BUFFER];
        while self.guard.phase() != Phase::Lost {
            if self.shared.close.load(Ordering::SeqCst) {
                self.let_go();
                return;
            }
            if let Err(error) = self.turn(&mut buffer) {
                let live = self.was_live;
                let what = match live {
                    true => "the connection broke off and the arm was left to itself",
                    false => "the connection broke off",
                };
                let text = format!("{what}: {error}: is the cable in, is the controller on?");
                self.guard.lose(&text);
                self.say(text);
            }
            self.show();
        }
    }

    /// One turn: hear, decide, send.
    fn turn(&mut self, buffer: &mut [u8]) -> std::io::Result<()> {
        let now = self.now();
        self.asks(now);
        self.host.poll(now, &mut self.out, &mut self.events);
        self.flush()?;
        let wait = match self.host.pace() {
            Pace::Every(_) if self.guard.phase().is_live() => {
                self.due.saturating_sub(self.now()).min(LONGEST)
            }
            _ => LONGEST,
        };
        let count = self.cable.read(buffer, wait)?;
        let now = self.now();
        if count > 0 {
            self.host.receive(now, &buffer[..count], &mut self.events);
        }
        let is_measured = self.hear(now);
        // A stop asked for while we waited comes before anything that is sent.
        if self.shared.stop.swap(false, Ordering::SeqCst) {
            self.guard.stop("stopped by hand");
        }
        self.guard.watch(now, self.host.patience());
        self.cycle(now, is_measured);
        self.settle(now);
        self.flush()
    }

    fn now(&self) -> Duration {
        self.start.elapsed()
    }

    fn flush(&mut self) -> std::io::Result<()> {
        if !self.out.is_empty() {
            self.cable.write(&self.out)?;
            self.out.clear();
        }
        Ok(())
    }

    fn asks(&mut self, now: Duration) {
        while let Ok(ask) = self.asks.try_recv() {
            // Whoever asks and has gone needs no answer.
            match ask {
                Ask::Beat(at) => self.guard.beat(at),
                Ask::Arm(answer) => {
                    let allowed = match self.host.is_homing() {
                        true => Err(Refusal(
                            "the controller is looking for its switches: wait for it".to_owned(),
                        )),
                        false => self.guard.arm_if_allowed(now, self.host.patience()),
                    };
                    if allowed.is_ok() {
                        self.status.sentence = None;
                        self.lag = [0.0; 2];
                        self.host.arm(now, &mut self.out, &mut self.events);
                    }
                    self.show();
                    let _ = answer.send(allowed);
                }
                Ask::Share(share, answer) => {
                    let _ = answer.send(self.guard.set_share(share));
                }
                Ask::Target(q, answer) => {
                    self.note(|| format!("asked to go to {q:?}"));
                    let allowed = self.guard.target(&q);
                    self.show();
                    let _ = answer.send(allowed);
                }
                Ask::Play(law, answer) => {
                    self.note(|| format!("asked to run a motion of {} rows", law.rows().len()));
                    let allowed = self.guard.play(law);
                    self.show();
                    let _ = answer.send(allowed);
                }
                Ask::Home(joints, answer) => {
                    self.note(|| format!("asked to find the switches of {joints:?}"));
                    let allowed = self.home(&joints);
                    self.show();
                    let _ = answer.send(allowed);
                }
                Ask::Disarm(answer) => {
                    if self.guard.phase().is_live() {
                        self.host.disarm(now, &mut self.out);
                    }
                    self.guard.disarm();
                    self.was_live = false;
                    self.note(|| "disarmed".to_owned());
                    self.show();
                    let _ = answer.send(Ok(()));
                }
            }
        }
    }

    /// The controller looks for its switches. It moves by its own rules meanwhile, so nothing else may be under way.
    fn home(&mut self, joints: &[bool]) -> Result<(), Refusal> {
        match self.guard.phase() {
            Phase::Watching | Phase::Stopped => {}
            _ => {
                return Err(Refusal(
                    "homing begins where the arm is connected and not armed".to_owned(),
                ));
            }
        }
        if !joints.contains(&true) || joints.len() != self.guard.arm().dof() {
            return Err(Refusal("a joint to home was expected".to_owned()));
        }
        self.guard.disarm();
        self.status.sentence = None;
        self.host.home(joints).map_err(Refusal)
    }

    /// Takes up what the controller said; whether it told where it is.
    fn hear(&mut self, now: Duration) -> bool {
        let mut is_measured = false;
        let mut events = std::mem::take(&mut self.events);
        for event in events.drain(..) {
            match event {
                Event::Identified(text) => {
                    self.note(|| text.clone());
                    self.status.identity = Some(text);
                }
                Event::Measured => is_measured = true,
                Event::Armed => {
                    self.note(|| "armed".to_owned());
                    self.guard.armed(now);
                    self.last = now;
                    self.due = now;
                }
                Event::Refused(text) | Event::Fault(text) => {
                    let phase = self.guard.phase();
                    self.guard.stop(&text);
                    // What comes after a stop does not say why it came to it.
                    match phase.is_live()
                        || phase == Phase::Arming
                        || self.status.sentence.is_none()
                    {
                        true => self.say(text),
                        false => self.note(|| text),
                    }
                }
                Event::Noise(text) => self.drop_bytes(&text),
            }
        }
        self.events = events;
        if is_measured && let Some(motors) = self.host.measured() {
            match self.guard.measure(now, motors) {
                Err(refusal) => self.say(refusal.0),
                Ok(false) => self.drop_bytes("a position too far from the one before"),
                Ok(true) => self.compare(now),
            }
        }
        is_measured
    }

    /// Compares where the arm is with where it was sent; of whole moves, at the end of each.
    fn compare(&mut self, now: Duration) {
        let is_of_moves = matches!(self.host.pace(), Pace::Moves(_));
        if is_of_moves && !self.host.is_ready() {
            return;
        }
        self.guard.watch_error();
        let (Some(commanded), Some(measured)) = (self.guard.commanded(), self.guard.measured())
        else {
            self.status.error = None;
            return;
        };
        let errors = commanded.iter().zip(measured).map(|(c, m)| c - m);
        let worst = errors
            .enumerate()
            .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        self.status.error = worst;
        match is_of_moves {
            true => self.sample(now),
            false => self.measure_lag(),
        }
    }

    /// Sends the next set-point if it is time.
    fn cycle(&mut self, now: Duration, is_measured: bool) {
        if !self.guard.phase().is_live() || !self.host.is_ready() {
            return;
        }
        let pace = self.host.pace();
        let (is_time, period) = match pace {
            Pace::Every(period) => (now >= self.due, period),
            Pace::Answer(period) => (is_measured, period),
            Pace::Moves(longest) => (true, longest),
        };
        if !is_time {
            return;
        }
        if let Some(commanded) = self.guard.commanded() {
            self.before.copy_from_slice(commanded);
        }
        let dt = now.saturating_sub(self.last);
        let point = match pace {
            Pace::Moves(longest) => self.guard.next_move(longest),
            _ => self.guard.next(dt),
        };
        let Some(point) = point else {
            return;
        };
        self.host
            .set_point(now, point.motors, point.over, &mut self.out);
        self.status.sent += 1;
        self.last = now;
        if !matches!(pace, Pace::Moves(_)) {
            self.status.late += u64::from(dt > period.mul_f64(1.5));
            // Behind by more than a period: go on from now, and do not catch up in a rush.
            self.due = (self.due + period).max(now + period / 4);
            self.sample(now);
        }
    }

    /// What a stop means on the wire, and in words.
    fn settle(&mut self, now: Duration) {
        let is_live = self.guard.phase().is_live() || self.guard.phase() == Phase::Arming;
        if self.was_live && !is_live {
            self.host.stop(now, &mut self.out);
            if let Some(reason) = self.guard.reason() {
                let text = format!("stopped: {reason}");
                self.say(text);
            }
        }
        self.was_live = is_live;
    }

    fn let_go(&mut self) {
        let now = self.now();
        if self.was_live {
            self.host.stop(now, &mut self.out);
            // The cable may be gone: then there is nobody to tell.
            let _ = self.flush();
        }
        self.note(|| "closed".to_owned());
    }

    /// The lag is the time by which the measured joints would have to be earlier: a least-squares fit over the last cycles.
    fn measure_lag(&mut self) {
        let (Some(commanded), Some(measured)) = (self.guard.commanded(), self.guard.measured())
        else {
            return;
        };
        let mut sums = [0.0; 2];
        for joint in 0..commanded.len() {
            let rate = commanded[joint] - self.before[joint];
            sums[0] += rate * (commanded[joint] - measured[joint]);
            sums[1] += rate * rate;
        }
        let period = match self.host.pace() {
            Pace::Every(period) | Pace::Answer(period) => period.as_secs_f64(),
            Pace::Moves(_) => return,
        };
        self.lag[0] = KEPT * self.lag[0] + sums[0] * period;
        self.lag[1] = KEPT * self.lag[1] + sums[1];
        self.status.lag = (self.lag[1] > 1e-12).then(|| self.lag[0] / self.lag[1]);
    }

    fn drop_bytes(&mut self, why: &str) {
        self.status.dropped.0 += 1;
        self.note(|| why.to_owned());
        self.status.dropped.1 = Some(why.to_owned());
    }

    fn say(&mut self, text: String) {
        self.note(|| text.clone());
        self.status.sentence = Some(text);
    }

    fn note(&mut self, text: impl FnOnce() -> String) {
        let now = self.now();
        if let Some(record) = &mut self.record {
            record.note(now, text());
        }
    }

    fn sample(&mut self, now: Duration) {
        if let (Some(record), Some(commanded), Some(measured)) = (
            &mut self.record,
            self.guard.commanded(),
            self.guard.measured(),
        ) {
            record.sample(now, commanded, measured, self.host.latency());
        }
    }

    /// Shows how things stand. Nothing is allocated but where a vector comes or goes.
    fn show(&mut self) {
        let status = &mut self.status;
        let copy = |to: &mut Option<Vec<f64>>, from: Option<&[f64]>| match (to.as_mut(), from) {
            (Some(to), Some(from)) => to.copy_from_slice(from),
            (_, from) => *to = from.map(<[f64]>::to_vec),
        };
        // The last of several moves is sent, and not yet made: it is still what it was.
        status.phase = match self.guard.phase() {
            Phase::Holding
                if self.host.is_moving()
                    && matches!(status.phase, Phase::Moving | Phase::Playing) =>
            {
                status.phase
            }
            phase => phase,
        };
        status.is_homing = self.host.is_homing();
        status.latency = self.host.latency();
        status.progress = self.guard.progress();
        copy(&mut status.measured, self.guard.measured());
        copy(&mut status.commanded, self.guard.commanded());
        let mut shown = self.shared.status();
        shown.phase = status.phase;
        shown.is_homing = status.is_homing;
        shown.latency = status.latency;
        shown.lag = status.lag;
        shown.error = status.error;
        shown.progress = status.progress;
        shown.sent = status.sent;
        shown.late = status.late;
        copy(&mut shown.measured, status.measured.as_deref());
        copy(&mut shown.commanded, status.commanded.as_deref());
        let renew = |to: &mut Option<String>, from: &Option<String>| {
            if to != from {
                to.clone_from(from);
            }
        };
        renew(&mut shown.sentence, &status.sentence);
        renew(&mut shown.identity, &status.identity);
        shown.dropped.0 = status.dropped.0;
        renew(&mut shown.dropped.1, &status.dropped.1);
    }
}
