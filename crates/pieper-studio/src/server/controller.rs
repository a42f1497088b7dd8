//! The real arm beside the one in the picture: WIRE.md section 7.
//!
//! Off until somebody connects; shows only until somebody arms; moves only while a window holds the button and is heard of.

use std::collections::VecDeque;
use std::str::FromStr as _;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use axum::extract::ws::Message;
use pieper_link::simulator::{Place, Served};
use pieper_link::transport::{self, Address};
use pieper_link::{Kind, Options, Phase, Session, Status, records};
use serde::Deserialize;
use serde_json::{Value, json};
use tokio::sync::Notify;

use super::State;
use crate::arm::Arm;
use crate::command::Command;
use crate::frames;
use crate::quantity::Quantity;

/// The time between two looks at the arm.
const LOOK: Duration = Duration::from_millis(33);

/// How long a controller may take to answer.
const ANSWER: Duration = Duration::from_secs(6);

/// The share of the arm's rates that it follows with.
const SHARE: f64 = 0.25;

/// Sentences that are kept.
const SAID: usize = 8;

/// What can be asked, by names that begin with `controller_`.
#[derive(Debug, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
pub(super) enum Ask {
    Ports {},
    Connect {
        address: String,
        protocol: String,
    },
    Disconnect {},
    Arm {},
    Disarm {},
    Beat {
        hold: bool,
        #[serde(default)]
        run: bool,
    },
    Play {},
    Stop {},
}

#[derive(Default)]
pub(super) struct Controller {
    inner: Mutex<Inner>,
    /// Grows with every connection asked for: one that was overtaken is dropped.
    asked: AtomicU64,
    /// Something was asked, or has come of it.
    changed: Notify,
}

#[derive(Default)]
struct Inner {
    link: Option<Link>,
    is_connecting: bool,
    said: VecDeque<String>,
    /// Whether the button is held, and whether it counts: what undo changed is not followed before the next press.
    is_held: bool,
    is_void: bool,
    /// Whether the arm may use all of its rates, for a motion.
    is_full: bool,
    /// The posture that was last asked for.
    target: Vec<f64>,
}

struct Link {
    session: Arc<Session>,
    arm: Arc<Arm>,
    address: String,
    kind: Kind,
    /// A controller that is not there, if it was asked for.
    _simulated: Option<Served>,
}

impl Controller {
    fn inner(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn session(&self) -> Result<Arc<Session>, String> {
        let inner = self.inner();
        let link = inner.link.as_ref();
        link.map(|link| Arc::clone(&link.session))
            .ok_or_else(|| "no controller is connected: connect one first".to_owned())
    }

    fn say(&self, text: impl Into<String>) {
        let mut inner = self.inner();
        let text = text.into();
        if inner.said.back() != Some(&text) {
            inner.said.push_back(text);
            while inner.said.len() > SAID {
                inner.said.pop_front();
            }
        }
    }

    /// What is held does not count any more: something else than the person's hand moved the arm in the picture.
    pub(super) fn void(&self) {
        self.inner().is_void = true;
    }

    fn drop_link(&self) {
        self.asked.fetch_add(1, Ordering::SeqCst);
        let link = {
            let mut inner = self.inner();
            inner.is_connecting = false;
            inner.is_held = false;
            inner.link.take()
        };
        // Closing waits for the arm's driver: nobody else should.
        if let Some(link) = link {
            let _ = link.session.stop();
            std::thread::spawn(move || drop(link));
        }
    }
}

/// Does what is asked; `None` for what is no command of a controller.
pub(super) fn apply(state: &Arc<State>, message: &Value) -> Option<Result<Value, String>> {
    let name = message.get("do").and_then(Value::as_str)?;
    let short = name.strip_prefix("controller_")?;
    let mut message = message.clone();
    message["do"] = json!(short);
    let ask = serde_json::from_value::<Ask>(message).map_err(|error| error.to_string());
    let result = ask.and_then(|ask| obey(state, ask));
    state.controller.changed.notify_one();
    Some(result)
}

fn obey(state: &Arc<State>, ask: Ask) -> Result<Value, String> {
    let controller = &state.controller;
    match ask {
        Ask::Ports {} => {
            let port = |(path, what)| json!({"path": path, "what": what});
            let protocol = |kind: &Kind| json!({"name": kind.name(), "summary": kind.summary()});
            return Ok(json!({
                "ports": transport::list()?.into_iter().map(port).collect::<Value>(),
                "protocols": Kind::ALL.iter().map(protocol).collect::<Value>(),
            }));
        }
        Ask::Connect { address, protocol } => {
            connect(state, &address, Kind::from_str(&protocol)?)?;
        }
        Ask::Disconnect {} => controller.drop_link(),
        Ask::Arm {} => {
            let session = controller.session()?;
            let state = Arc::clone(state);
            // It waits for the controller's answer.
            std::thread::spawn(move || {
                if let Err(refusal) = session.arm() {
                    state.controller.say(refusal.0);
                }
            });
        }
        Ask::Disarm {} => controller.session()?.disarm().map_err(|r| r.0)?,
        Ask::Beat { hold, run } => beat(state, hold, run)?,
        Ask::Play {} => play(state)?,
        Ask::Stop {} => {
            controller.inner().is_held = false;
            controller.session()?.stop().map_err(|r| r.0)?;
        }
    }
    Ok(Value::Null)
}

fn connect(state: &Arc<State>, address: &str, kind: Kind) -> Result<(), String> {
    state.controller.drop_link();
    let arm = Arc::clone(&state.hub.session().arm);
    let driven = Arc::new(pieper_link::Arm::of(&arm.robot).map_err(|error| error.to_string())?);
    let is_simulated = address == "simulated";
    let place = match is_simulated {
        true => None,
        false => Some(Address::from_str(address)?),
    };
    let turn = state.controller.asked.load(Ordering::SeqCst);
    state.controller.inner().is_connecting = true;
    let state = Arc::clone(state);
    let name = address.to_owned();
    // Opening a line may take seconds.
    std::thread::spawn(move || {
        let made = open(place, kind, &driven);
        let controller = &state.controller;
        let mut inner = controller.inner();
        if controller.asked.load(Ordering::SeqCst) != turn {
            return;
        }
        inner.is_connecting = false;
        match made {
            Ok((session, simulated)) => {
                inner.said.clear();
                inner.target.clear();
                inner.link = Some(Link {
                    session: Arc::new(session),
                    arm,
                    address: name,
                    kind,
                    _simulated: simulated,
                });
            }
            Err(text) => {
                drop(inner);
                controller.say(text);
            }
        }
        controller.changed.notify_one();
    });
    Ok(())
}

/// A session that has heard from its controller; with a controller of its own where none was named.
fn open(
    place: Option<Address>,
    kind: Kind,
    arm: &Arc<pieper_link::Arm>,
) -> Result<(Session, Option<Served>), String> {
    let options = Options {
        share: SHARE,
        record: Some(records::new(kind)),
        ..Options::default()
    };
    let (session, simulated) = match (place, kind) {
        (Some(address), _) => {
            let session = Session::connect(&address, kind, Arc::clone(arm), &options)?;
            (session, None)
        }
        (None, Kind::Egm) => {
            let address = Address::Udp("127.0.0.1:6510".to_owned());
            let session = Session::connect(&address, kind, Arc::clone(arm), &options)?;
            let calls = Place::Calls("127.0.0.1:6510".to_owned());
            (session, Some(Served::start(kind, arm, &calls)?))
        }
        (None, _) => {
            let served = Served::start(kind, arm, &Place::Tcp(0))?;
            let session = Session::connect(served.address(), kind, Arc::clone(arm), &options)?;
            (session, Some(served))
        }
    };
    session.wait_connected(ANSWER)?;
    Ok((session, simulated))
}

/// A window is there; while it holds one button, the arm goes where the picture's arm is, and while it holds the other, the motion
/// runs.
fn beat(state: &Arc<State>, hold: bool, run: bool) -> Result<(), String> {
    let q = state.hub.session().q.clone();
    let controller = &state.controller;
    let session = controller.session()?;
    session.beat();
    let (follows, lets_go) = {
        let mut inner = controller.inner();
        if hold && !inner.is_held {
            // A new press: whatever was void is forgotten.
            inner.is_void = false;
            inner.target.clear();
        }
        let was_held = std::mem::replace(&mut inner.is_held, hold);
        let counts = hold && !inner.is_void;
        let is_new = inner.target != q;
        if counts && is_new {
            inner.target.clone_from(&q);
        }
        (counts && is_new, was_held && !counts)
    };
    let status = session.status();
    if follows && matches!(status.phase, Phase::Holding | Phase::Moving) {
        session.set_target(&q).map_err(|refusal| refusal.0)?;
    }
    // A motion runs as long as its button is held.
    if status.phase == Phase::Playing && !run {
        return session.stop().map_err(|refusal| refusal.0);
    }
    // Let go on the way: it comes to rest where it is.
    if lets_go && let (Phase::Moving, Some(here)) = (status.phase, status.commanded) {
        session.set_target(&here).map_err(|refusal| refusal.0)?;
    }
    Ok(())
}

/// Runs the picture's motion on the arm, if it may be and the arm is at its start.
fn play(state: &Arc<State>) -> Result<(), String> {
    let session = state.controller.session()?;
    let law = state.hub.session().motion.law().cloned();
    let law = law.ok_or("there is no motion: two keyframes or a table make one")?;
    session.set_share(1.0).map_err(|refusal| refusal.0)?;
    state.controller.inner().is_full = true;
    session.play(law).map_err(|refusal| refusal.0)?;
    // The arm in the picture runs ahead of the real one by its lag, and no more.
    let mut shown = state.hub.session();
    let speed = Command::Speed { to: Quantity(1.0) };
    for command in [speed, Command::StopMotion {}, Command::Play {}] {
        shown.apply(command)?;
    }
    drop(shown);
    state.hub.wake();
    Ok(())
}

/// The section's value.
pub(super) fn value(controller: &Controller) -> Value {
    let inner = controller.inner();
    let said: Vec<&String> = inner.said.iter().collect();
    let Some(link) = &inner.link else {
        let phase = if inner.is_connecting {
            "connecting"
        } else {
            "off"
        };
        return json!({"phase": phase, "said": said});
    };
    let status = link.session.status();
    json!({
        "phase": status.phase.name(), "live": status.phase.is_live(), "held": inner.is_held && !inner.is_void,
        "address": link.address, "protocol": link.kind.name(), "controller": status.identity,
        "sentence": status.sentence, "said": said,
        "measured": status.measured, "commanded": status.commanded,
        "error": status.error.map(|(joint, error)| json!({"joint": joint, "error": error})),
        "lag": status.lag, "latency": status.latency.map(|latency| latency.as_secs_f64()),
        "progress": status.progress, "sent": status.sent, "late": status.late, "dropped": status.dropped.0,
    })
}

/// What a window that has just come is told.
pub(super) fn whole(controller: &Controller) -> Vec<Message> {
    let mut last = Value::Null;
    messages(controller, &mut last, 0)
}

/// The section where it has changed, and where the real arm is.
fn messages(controller: &Controller, last: &mut Value, sequence: u32) -> Vec<Message> {
    let value = value(controller);
    if value == *last {
        return Vec::new();
    }
    let text = json!({"section": "controller", "value": value}).to_string();
    *last = value;
    let poses = {
        let inner = controller.inner();
        inner.link.as_ref().and_then(|link| {
            let measured = link.session.status().measured?;
            Some((link.arm.poses(&measured), link.arm.mover.len()))
        })
    };
    let frame = match poses {
        Some((poses, links)) => frames::real(sequence, links, &[poses]),
        None => frames::real(sequence, 0, &[]),
    };
    vec![Message::Text(text.into()), Message::Binary(frame.into())]
}

/// Looks at the arm while one is connected, and tells the windows.
pub(super) async fn run(state: Arc<State>) {
    let mut last = value(&state.controller);
    let mut sequence = 0;
    loop {
        // Without a controller there is nothing to look at.
        let is_off = state.controller.inner().link.is_none();
        match is_off {
            true => state.controller.changed.notified().await,
            false => tokio::time::sleep(LOOK).await,
        }
        settle(&state);
        sequence += 1;
        let messages = messages(&state.controller, &mut last, sequence);
        if !messages.is_empty() {
            state.hub.tell(messages);
        }
    }
}

/// After a motion the arm follows slowly again; another arm in the picture ends the connection.
fn settle(state: &Arc<State>) {
    let shown = Arc::clone(&state.hub.session().arm);
    let (status, is_other): (Option<(Arc<Session>, Status)>, bool) = {
        let inner = state.controller.inner();
        match &inner.link {
            None => (None, false),
            Some(link) => {
                let status = link.session.status();
                let is_other = !Arc::ptr_eq(&link.arm, &shown);
                (Some((Arc::clone(&link.session), status)), is_other)
            }
        }
    };
    if is_other {
        state.controller.drop_link();
        state
            .controller
            .say("another arm was loaded: the controller was let go");
        return;
    }
    if let Some((session, status)) = status
        && status.phase != Phase::Playing
        && std::mem::take(&mut state.controller.inner().is_full)
    {
        // One that moves again already keeps its speed until it rests.
        let _ = session.set_share(SHARE);
    }
}
