//! Who may move the arm, and when it stops.

use std::sync::Arc;
use std::time::Duration;

use pieper::motion::{Law, State};

use super::envelope::{Envelope, Refusal};
use super::follower::Follower;
use crate::arm::Arm;

/// The longest silence of the one who drives the arm.
pub const HEARTBEAT: Duration = Duration::from_millis(250);

/// How far a joint may be from where it was sent, radians or metres, beside what [`LAG`] explains.
const ASTRAY: [f64; 2] = [0.12, 0.03];

/// The lag that is taken for granted, seconds: what a joint travels in this time at its largest rate is no error.
const LAG: f64 = 0.12;

/// How near the start of a motion must be to the place where the arm is, radians or metres.
const START: [f64; 2] = [0.01, 0.001];

/// How far a measured joint may be from the one before, radians or metres, beside what it can travel meanwhile; and how many
/// measurements in a row must say so before it is believed. Text and EGM have no checksum: a flipped bit is a number too.
const LEAP: [f64; 2] = [0.3, 0.1];
const BELIEVED: u32 = 4;

/// What the arm may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Nobody has answered yet.
    Connecting,
    /// The arm is shown; nothing is sent that moves it.
    Watching,
    /// The controller was asked to take set-points.
    Arming,
    /// Armed, and at rest.
    Holding,
    /// On the way to a target.
    Moving,
    /// Running a motion.
    Playing,
    /// Stopped; it can be armed again.
    Stopped,
    /// The connection is gone.
    Lost,
}

impl Phase {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Connecting => "connecting",
            Self::Watching => "watching",
            Self::Arming => "arming",
            Self::Holding => "holding",
            Self::Moving => "moving",
            Self::Playing => "playing",
            Self::Stopped => "stopped",
            Self::Lost => "lost",
        }
    }

    /// Whether set-points may go out.
    pub fn is_live(self) -> bool {
        matches!(self, Self::Holding | Self::Moving | Self::Playing)
    }
}

/// A set-point that has passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetPoint<'a> {
    /// Motor values, radians or metres.
    pub motors: &'a [f64],
    /// The time that the way there takes.
    pub over: Duration,
}

/// Decides what is sent to an arm. Pure: times come in, since the connection was made.
pub struct Guard {
    envelope: Envelope,
    phase: Phase,
    reason: Option<String>,
    measured: Vec<f64>,
    measured_at: Option<Duration>,
    commanded: Vec<f64>,
    next: Vec<f64>,
    motors: Vec<f64>,
    follower: Follower,
    motion: Option<Law>,
    elapsed: f64,
    state: State,
    heard: Duration,
    is_first: bool,
    /// Measurements in a row that were too far from the last one.
    leaps: u32,
}

impl Guard {
    /// A guard of an arm that nobody has heard of yet.
    pub fn new(envelope: Envelope) -> Self {
        let dof = envelope.arm().dof();
        Self {
            envelope,
            phase: Phase::Connecting,
            reason: None,
            measured: vec![0.0; dof],
            measured_at: None,
            commanded: vec![0.0; dof],
            next: vec![0.0; dof],
            motors: vec![0.0; dof],
            follower: Follower::new(dof),
            motion: None,
            elapsed: 0.0,
            state: State::default(),
            heard: Duration::ZERO,
            is_first: false,
            leaps: 0,
        }
    }

    /// What the arm may do.
    pub fn phase(&self) -> Phase {
        self.phase
    }

    /// Why it stopped, the last time it did.
    pub fn reason(&self) -> Option<&str> {
        self.reason.as_deref()
    }

    /// The joints as measured.
    pub fn measured(&self) -> Option<&[f64]> {
        self.measured_at.map(|_| self.measured.as_slice())
    }

    /// The joints as commanded, while armed.
    pub fn commanded(&self) -> Option<&[f64]> {
        self.phase.is_live().then_some(self.commanded.as_slice())
    }

    /// How far the motion is, and how long it takes, seconds.
    pub fn progress(&self) -> Option<[f64; 2]> {
        let law = self.motion.as_ref()?;
        let times = law.times();
        Some([self.elapsed, times[times.len() - 1] - times[0]])
    }

    /// The arm.
    pub fn arm(&self) -> &Arc<Arm> {
        self.envelope.arm()
    }

    /// The bounds.
    pub fn envelope(&self) -> &Envelope {
        &self.envelope
    }

    /// Where the motors are; whether that is believed. A leap is only when it is told again.
    ///
    /// # Errors
    /// A sentence where no joint values belong to these motor values; the arm is then stopped.
    pub fn measure(&mut self, now: Duration, motors: &[f64]) -> Result<bool, Refusal> {
        let arm = Arc::clone(self.envelope.arm());
        // As good as the values of a chain without a linkage are, a motor a hair past its window still has a joint value.
        let answer = match arm.transmission.is_direct() {
            true => {
                self.next.copy_from_slice(motors);
                Ok(Ok(()))
            }
            false => arm.transmission.joints(motors, &mut self.next),
        };
        let refused = match answer {
            Err(error) => Some(error.to_string()),
            Ok(Err(past)) => Some(past.to_string()),
            Ok(Ok(())) => self
                .next
                .iter()
                .any(|q| !q.is_finite())
                .then(|| "the controller told a position that is no number".to_owned()),
        };
        if let Some(text) = refused {
            let text = format!("the measured position makes no sense: {text}");
            self.stop(&text);
            return Err(Refusal(text));
        }
        let leaps = self.measured_at.is_some_and(|at| {
            let dt = now.saturating_sub(at).as_secs_f64();
            (0..arm.dof()).any(|joint| {
                let bound = LEAP[usize::from(!arm.is_angle(joint))];
                let way = (self.next[joint] - self.measured[joint]).abs();
                way > self.envelope.rates()[joint].mul_add(dt, bound)
            })
        });
        self.leaps = if leaps { self.leaps + 1 } else { 0 };
        if leaps && self.leaps < BELIEVED {
            return Ok(false);
        }
        std::mem::swap(&mut self.measured, &mut self.next);
        self.measured_at = Some(now);
        self.leaps = 0;
        if self.phase == Phase::Connecting {
            self.phase = Phase::Watching;
        }
        Ok(true)
    }

    /// Whether the arm may be armed: somebody has told where it is, just now.
    ///
    /// # Errors
    /// A refusal in words.
    pub fn arm_if_allowed(&mut self, now: Duration, patience: Duration) -> Result<(), Refusal> {
        match (self.phase, self.measured_at) {
            (Phase::Lost, _) => Err(Refusal("the connection is gone: connect again".to_owned())),
            (_, None) => Err(Refusal(
                "the controller has not told where the arm is: it cannot be armed".to_owned(),
            )),
            (_, Some(at)) if now.saturating_sub(at) > patience => Err(Refusal(
                "the controller is silent: it cannot be armed".to_owned(),
            )),
            (phase, _) if phase.is_live() => Err(Refusal("the arm is armed already".to_owned())),
            _ => {
                self.phase = Phase::Arming;
                self.reason = None;
                self.heard = now;
                Ok(())
            }
        }
    }

    /// The controller takes set-points: the first is where the arm is.
    pub fn armed(&mut self, now: Duration) {
        if self.phase != Phase::Arming {
            return;
        }
        self.commanded.copy_from_slice(&self.measured);
        self.follower.rest(&self.measured);
        self.motion = None;
        self.is_first = true;
        self.heard = now;
        self.phase = Phase::Holding;
    }

    /// Another share of the arm's rates and accelerations, 0.01 to 1.
    ///
    /// # Errors
    /// A refusal: the arm is moving.
    pub fn set_share(&mut self, share: f64) -> Result<(), Refusal> {
        if matches!(self.phase, Phase::Moving | Phase::Playing) {
            return Err(Refusal(
                "the arm is moving: its speed is changed at rest".to_owned(),
            ));
        }
        self.envelope = Envelope::of(Arc::clone(self.envelope.arm()), share);
        Ok(())
    }

    /// A place to go to, by rates and accelerations within the envelope.
    ///
    /// # Errors
    /// A refusal in words: not armed, a motion is running, or the place is not allowed.
    pub fn target(&mut self, q: &[f64]) -> Result<(), Refusal> {
        self.needs_arming()?;
        if self.phase == Phase::Playing {
            return Err(Refusal(
                "a motion is running: stop it before moving the arm elsewhere".to_owned(),
            ));
        }
        self.envelope.allows(q)?;
        self.follower.aim(&self.commanded, q, self.envelope.rates());
        self.phase = Phase::Moving;
        Ok(())
    }

    /// A motion to run, which begins where the arm is.
    ///
    /// # Errors
    /// A refusal in words: not armed, not at rest, a motion beyond the envelope, or one that begins elsewhere.
    pub fn play(&mut self, law: Law) -> Result<(), Refusal> {
        self.needs_arming()?;
        if self.phase != Phase::Holding {
            return Err(Refusal(
                "the arm is moving: a motion begins at rest".to_owned(),
            ));
        }
        self.envelope.allows_motion(&law)?;
        let arm = self.envelope.arm();
        for (joint, (start, here)) in law.rows()[0].iter().zip(&self.commanded).enumerate() {
            let bound = START[usize::from(!arm.is_angle(joint))];
            if (start - here).abs() > bound {
                return Err(Refusal(format!(
                    "the motion begins with {} at {}, it is at {}: move there first",
                    arm.joint_name(joint),
                    arm.shown(joint, *start),
                    arm.shown(joint, *here)
                )));
            }
        }
        self.motion = Some(law);
        self.elapsed = 0.0;
        self.phase = Phase::Playing;
        Ok(())
    }

    /// The one who drives the arm is there.
    pub fn beat(&mut self, now: Duration) {
        self.heard = now;
    }

    /// Stops: no set-point goes out any more.
    pub fn stop(&mut self, reason: &str) {
        if matches!(
            self.phase,
            Phase::Arming | Phase::Holding | Phase::Moving | Phase::Playing
        ) {
            self.phase = Phase::Stopped;
            self.reason = Some(reason.to_owned());
        }
    }

    /// Lets go.
    pub fn disarm(&mut self) {
        if !matches!(self.phase, Phase::Connecting | Phase::Lost) {
            self.phase = Phase::Watching;
        }
    }

    /// The connection is gone.
    pub fn lose(&mut self, reason: &str) {
        self.phase = Phase::Lost;
        self.reason = Some(reason.to_owned());
    }

    /// Looks at the clock: whether somebody has been silent for too long.
    pub fn watch(&mut self, now: Duration, patience: Duration) {
        if !self.phase.is_live() && self.phase != Phase::Arming {
            return;
        }
        let silence = now.saturating_sub(self.heard);
        if silence > HEARTBEAT {
            self.stop(&format!(
                "whoever drives the arm has been silent for {} ms",
                silence.as_millis()
            ));
            return;
        }
        let age = now.saturating_sub(self.measured_at.unwrap_or_default());
        if age > patience {
            self.stop(&format!(
                "the controller has told no position for {} ms: is it on, is the cable in?",
                age.as_millis()
            ));
        }
    }

    /// Whether a joint is too far from where it was sent; for controllers that follow set-points one by one.
    pub fn watch_error(&mut self) {
        if !self.phase.is_live() {
            return;
        }
        let arm = self.envelope.arm();
        for joint in 0..arm.dof() {
            let error = (self.commanded[joint] - self.measured[joint]).abs();
            let bound = self.envelope.rates()[joint]
                .mul_add(LAG, ASTRAY[usize::from(!arm.is_angle(joint))]);
            if error > bound {
                let text = format!(
                    "{} is {} from where it was sent: is it blocked, has it lost steps?",
                    arm.joint_name(joint),
                    arm.shown(joint, error)
                );
                return self.stop(&text);
            }
        }
    }

    /// The next set-point of a controller that takes one every so often, `dt` after the one before.
    ///
    /// Times longer than the heartbeat mean that this program was held up: the arm is stopped rather than made to catch up.
    pub fn next(&mut self, dt: Duration) -> Option<SetPoint<'_>> {
        if !self.phase.is_live() {
            return None;
        }
        if dt > HEARTBEAT {
            self.stop(&format!(
                "this program was held up for {} ms",
                dt.as_millis()
            ));
            return None;
        }
        if std::mem::take(&mut self.is_first) {
            self.next.copy_from_slice(&self.commanded);
            return self.send(dt);
        }
        self.advance(dt);
        self.send(dt)
    }

    /// The next move of a controller that takes whole moves, no longer than `longest`. `None` at rest.
    pub fn next_move(&mut self, longest: Duration) -> Option<SetPoint<'_>> {
        self.is_first = false;
        let over = match (&self.motion, self.phase) {
            (Some(law), Phase::Playing) => {
                // A move ends at a row, so that the rows' poses are met.
                let times = law.times();
                let now = times[0] + self.elapsed;
                let row = times.iter().find(|&&time| time > now + 1e-9);
                let left = row.map_or(longest, |time| Duration::from_secs_f64(time - now));
                longest.min(left)
            }
            (_, Phase::Moving) => longest,
            _ => return None,
        };
        self.advance(over);
        self.send(over)
    }

    /// Computes where to be after `dt`, into `next`.
    fn advance(&mut self, dt: Duration) {
        self.next.copy_from_slice(&self.commanded);
        match (&self.motion, self.phase) {
            (Some(law), Phase::Playing) => {
                let times = law.times();
                self.elapsed += dt.as_secs_f64();
                law.at(times[0] + self.elapsed, &mut self.state);
                self.next.copy_from_slice(&self.state.position);
                if times[0] + self.elapsed >= times[times.len() - 1] {
                    self.follower.rest(&self.next);
                    self.motion = None;
                    self.phase = Phase::Holding;
                }
            }
            (_, Phase::Moving) => {
                let (rates, accelerations) = (self.envelope.rates(), self.envelope.accelerations());
                self.follower
                    .advance(&mut self.next, dt.as_secs_f64(), rates, accelerations);
                if self.follower.is_there(&self.next) {
                    self.phase = Phase::Holding;
                }
            }
            _ => {}
        }
    }

    /// The last look at a set-point before it goes.
    fn send(&mut self, over: Duration) -> Option<SetPoint<'_>> {
        let seconds = over.as_secs_f64().max(1e-4);
        let arm = Arc::clone(self.envelope.arm());
        // Standing still is always allowed: also where a hand has put a joint beyond its limit.
        let step = match self.commanded == self.next {
            true => Ok(()),
            false => self
                .envelope
                .allows_step(&self.commanded, &self.next, seconds),
        };
        let passed = step.and_then(|()| {
            let answer = arm.transmission.motors(&self.next, &mut self.motors);
            let answer = answer.map_err(|error| Refusal(error.to_string()))?;
            answer.map_err(|past| Refusal(past.to_string()))
        });
        if let Err(refusal) = passed {
            self.stop(&refusal.0);
            return None;
        }
        self.commanded.copy_from_slice(&self.next);
        Some(SetPoint {
            motors: &self.motors,
            over,
        })
    }

    fn needs_arming(&self) -> Result<(), Refusal> {
        match self.phase.is_live() {
            true => Ok(()),
            false => Err(Refusal(
                "the arm is not armed: nothing moves before that".to_owned(),
            )),
        }
    }
}
