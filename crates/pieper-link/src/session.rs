//! A conversation with a real arm, driven by a thread of its own.

mod record;
mod worker;

pub use record::{Entry, Record, RecordError, Sample};

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant, SystemTime};

use pieper::motion::Law;

use crate::arm::Arm;
use crate::protocol::{Kind, Setup};
use crate::safety::{Envelope, Guard, Phase, Refusal};
use crate::transport::{self, Address, Transport};
use worker::{Ask, Worker};

/// How a session is held.
#[derive(Clone, Debug)]
pub struct Options {
    /// The share of the arm's rates and accelerations that set-points may use, 0.01 to 1.
    pub share: f64,
    /// EGM: tell the controller the tool's pose rather than the joints, for a program that runs `EGMRunPose`.
    pub poses: bool,
    /// The file that the session is recorded in.
    pub record: Option<PathBuf>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            share: 0.25,
            poses: false,
            record: None,
        }
    }
}

/// What a session shows.
#[derive(Clone, Debug)]
pub struct Status {
    /// What the arm may do.
    pub phase: Phase,
    /// Whether the controller is looking for its switches, and moves by its own rules.
    pub is_homing: bool,
    /// The last thing that happened, in words: why it stopped, why the connection is gone.
    pub sentence: Option<String>,
    /// Who answered.
    pub identity: Option<String>,
    /// The joints as measured, radians and metres.
    pub measured: Option<Vec<f64>>,
    /// The joints as commanded, while armed.
    pub commanded: Option<Vec<f64>>,
    /// The time from a set-point to the first state that answers it, where the protocol tells.
    pub latency: Option<Duration>,
    /// How long the measured joints are behind the commanded ones, seconds; while they move.
    pub lag: Option<f64>,
    /// The joint that is farthest from where it was sent, and how far; while armed. Of a controller that takes whole moves, at the end of
    /// each.
    pub error: Option<(usize, f64)>,
    /// How far a motion is, and how long it takes, seconds.
    pub progress: Option<[f64; 2]>,
    /// How many set-points have gone out.
    pub sent: u64,
    /// How many cycles came later than half a period.
    pub late: u64,
    /// How many times bytes were dropped, and the last reason.
    pub dropped: (u64, Option<String>),
}

impl Status {
    fn new() -> Self {
        Self {
            phase: Phase::Connecting,
            is_homing: false,
            sentence: None,
            identity: None,
            measured: None,
            commanded: None,
            latency: None,
            lag: None,
            error: None,
            progress: None,
            sent: 0,
            late: 0,
            dropped: (0, None),
        }
    }
}

/// What the thread and its owner share.
struct Shared {
    status: Mutex<Status>,
    stop: AtomicBool,
    close: AtomicBool,
}

impl Shared {
    /// The status. A thread that panicked with it in hand has left it whole: it is only written field by field.
    fn status(&self) -> MutexGuard<'_, Status> {
        self.status.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A connection to an arm. Dropped, it stops the arm and closes the cable.
///
/// A connection shows only: [`Session::arm`] comes before anything moves, and [`Session::beat`] at least every
/// 250 ms after that.
pub struct Session {
    shared: Arc<Shared>,
    asks: Sender<Ask>,
    thread: Option<JoinHandle<()>>,
    start: Instant,
}

/// How long the thread may take to answer: it never waits longer than a cycle.
const ANSWER: Duration = Duration::from_secs(2);

impl Session {
    /// Opens the cable and begins the conversation.
    ///
    /// # Errors
    /// A sentence: the port cannot be opened, the protocol cannot carry this arm, the record cannot be written.
    pub fn connect(
        address: &Address,
        kind: Kind,
        arm: Arc<Arm>,
        options: &Options,
    ) -> Result<Self, String> {
        // What cannot work is told before the port is touched.
        let nonce = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
        let nonce = nonce.map_or(1, |time| time.as_nanos() as u32);
        let host = kind.host(Setup {
            motors: arm.motors(),
            poses_of: options.poses.then(|| Arc::clone(&arm)),
            nonce,
        })?;
        let cable = transport::open(address, kind)?;
        Self::over(cable, host, address, kind, arm, options)
    }

    fn over(
        cable: Box<dyn Transport>,
        host: Box<dyn crate::protocol::Host>,
        address: &Address,
        kind: Kind,
        arm: Arc<Arm>,
        options: &Options,
    ) -> Result<Self, String> {
        let record = match &options.record {
            Some(path) => Some(record::Recorder::begin(path, &arm, kind, address)?),
            None => None,
        };
        let shared = Arc::new(Shared {
            status: Mutex::new(Status::new()),
            stop: AtomicBool::new(false),
            close: AtomicBool::new(false),
        });
        let (asks, heard) = channel();
        let start = Instant::now();
        let guard = Guard::new(Envelope::of(arm, options.share));
        let worker = Worker::new(
            cable,
            host,
            guard,
            Arc::clone(&shared),
            heard,
            record,
            start,
        );
        let thread = std::thread::Builder::new()
            .name("pieper-link".to_owned())
            .spawn(move || worker.run())
            .map_err(|error| format!("no thread could be started: {error}"))?;
        Ok(Self {
            shared,
            asks,
            thread: Some(thread),
            start,
        })
    }

    /// Waits until the controller has told where the arm is.
    ///
    /// # Errors
    /// A sentence where it has not in this time: what was heard instead, and what to look at.
    pub fn wait_connected(&self, patience: Duration) -> Result<(), String> {
        let status = self.wait(patience, |status| status.phase != Phase::Connecting);
        match status.phase {
            Phase::Connecting => {
                let heard = match &status.dropped {
                    (0, _) => "nothing was heard".to_owned(),
                    (count, Some(last)) => format!(
                        "{count} times something was heard that it does not say, last {last}"
                    ),
                    (count, None) => {
                        format!("{count} times something was heard that it does not say")
                    }
                };
                let said = status.sentence.map(|text| format!(" ({text})"));
                Err(format!(
                    "no controller answered within {:.1} s: {heard}{}: is it on, is this its port, its rate and its protocol? \
                     For EGM only the controller's own program can begin: start it there",
                    patience.as_secs_f64(),
                    said.unwrap_or_default()
                ))
            }
            Phase::Lost => Err(status.sentence.unwrap_or_default()),
            _ => Ok(()),
        }
    }

    /// What there is to see now.
    pub fn status(&self) -> Status {
        self.shared.status().clone()
    }

    /// Arms: the first set-point is the measured position, and nothing else moves before it is told where to go.
    ///
    /// # Errors
    /// A refusal in words.
    pub fn arm(&self) -> Result<(), Refusal> {
        self.ask(Ask::Arm)?;
        // Whoever waits here is there.
        let status = self.wait(ANSWER, |status| {
            self.beat();
            status.phase != Phase::Arming
        });
        match status.phase {
            phase if phase.is_live() => Ok(()),
            _ => {
                let _ = self.stop();
                let said = status.sentence;
                Err(Refusal(said.unwrap_or_else(|| {
                    "the controller did not answer the arming".to_owned()
                })))
            }
        }
    }

    /// Has the controller find its switches with these joints, which is how an arm that was switched on learns where it is. Returns at once:
    /// [`Status::is_homing`] tells how long it lasts, [`Status::sentence`] afterwards what went wrong.
    ///
    /// The controller drives the joints by its own rules: no limit and no rate of the description is kept, and whether
    /// anything ends it early is the controller's affair. The emergency stop belongs within reach.
    ///
    /// # Errors
    /// A refusal in words: armed, no such joints, a controller without that command.
    pub fn home(&self, joints: &[bool]) -> Result<(), Refusal> {
        self.ask(|answer| Ask::Home(joints.to_vec(), answer))
    }

    /// Moves to joint values, within rates and accelerations; a new target may come on the way.
    ///
    /// # Errors
    /// A refusal in words: not armed, out of limits, a motion running.
    pub fn set_target(&self, q: &[f64]) -> Result<(), Refusal> {
        self.ask(|answer| Ask::Target(q.to_vec(), answer))
    }

    /// Changes the share of the arm's rates and accelerations that set-points may use, while the arm is at rest.
    ///
    /// # Errors
    /// A refusal in words: it moves.
    pub fn set_share(&self, share: f64) -> Result<(), Refusal> {
        self.ask(|answer| Ask::Share(share, answer))
    }

    /// Runs a motion that begins where the arm is.
    ///
    /// # Errors
    /// A refusal in words: not armed, beyond limits or rates, begins elsewhere.
    pub fn play(&self, law: Law) -> Result<(), Refusal> {
        self.ask(|answer| Ask::Play(law, answer))
    }

    /// The one who drives the arm is there. At most 250 ms may lie between two of these while it is armed.
    pub fn beat(&self) {
        let _ = self.asks.send(Ask::Beat(self.start.elapsed()));
    }

    /// Stops the arm, whatever it does. Does not wait for anything.
    ///
    /// # Errors
    /// The connection is gone, and with it the arm's driver: it is stopped already.
    pub fn stop(&self) -> Result<(), Refusal> {
        self.shared.stop.store(true, Ordering::SeqCst);
        let is_gone = self.thread.as_ref().is_none_or(JoinHandle::is_finished);
        match is_gone {
            true => Err(Refusal("the connection is gone".to_owned())),
            false => Ok(()),
        }
    }

    /// Lets go: the arm holds where it is, and the connection shows only.
    ///
    /// # Errors
    /// The connection is gone.
    pub fn disarm(&self) -> Result<(), Refusal> {
        self.ask(Ask::Disarm)
    }

    /// Waits until something shows, or for so long.
    pub fn wait(&self, patience: Duration, is_so: impl Fn(&Status) -> bool) -> Status {
        let end = Instant::now() + patience;
        loop {
            let status = self.status();
            if is_so(&status) || Instant::now() >= end {
                return status;
            }
            std::thread::sleep(Duration::from_millis(2));
        }
    }

    fn ask(&self, ask: impl FnOnce(Sender<Result<(), Refusal>>) -> Ask) -> Result<(), Refusal> {
        let (answer, answered) = channel();
        let gone = || Refusal("the connection is gone: connect again".to_owned());
        self.asks.send(ask(answer)).map_err(|_| gone())?;
        answered.recv_timeout(ANSWER).map_err(|_| gone())?
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        self.shared.close.store(true, Ordering::SeqCst);
        if let Some(thread) = self.thread.take() {
            // A thread that panicked has let go of the cable already.
            let _ = thread.join();
        }
    }
}
