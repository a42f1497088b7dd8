//! One session, many windows: what changed goes to all, at most once for each picture.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use axum::extract::ws::Message;
use serde_json::json;
use tokio::sync::{Notify, broadcast};

use super::State;
use crate::sections::Section;
use crate::session::Session;

/// The shortest time between two sendings.
const PICTURE: Duration = Duration::from_millis(16);

/// Sendings that a slow window may lag behind before it is told everything anew.
const BACKLOG: usize = 64;

pub(super) struct Hub {
    session: Mutex<Session>,
    changed: Notify,
    sent: broadcast::Sender<Arc<Vec<Message>>>,
    sequence: Mutex<u32>,
}

impl Hub {
    pub(super) fn new(session: Session) -> Self {
        Self {
            session: Mutex::new(session),
            changed: Notify::new(),
            sent: broadcast::channel(BACKLOG).0,
            sequence: Mutex::new(0),
        }
    }

    /// The session. One that a panic left behind is used on: its state was whole before each command.
    pub(super) fn session(&self) -> MutexGuard<'_, Session> {
        self.session.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Says that something may have changed.
    pub(super) fn wake(&self) {
        self.changed.notify_one();
    }

    /// Tells all windows at once.
    pub(super) fn tell(&self, messages: Vec<Message>) {
        // Without windows there is nobody to tell.
        let _ = self.sent.send(Arc::new(messages));
    }

    pub(super) fn listen(&self) -> broadcast::Receiver<Arc<Vec<Message>>> {
        self.sent.subscribe()
    }

    fn next(&self) -> u32 {
        let mut sequence = self.sequence.lock().unwrap_or_else(PoisonError::into_inner);
        *sequence = sequence.wrapping_add(1);
        *sequence
    }

    /// Everything, for a window that has just come.
    pub(super) fn whole(&self) -> Vec<Message> {
        self.messages(&self.session(), &Section::ALL)
    }

    fn messages(&self, session: &Session, sections: &[Section]) -> Vec<Message> {
        let mut out = Vec::new();
        for section in Section::ALL
            .into_iter()
            .filter(|section| sections.contains(section))
        {
            match section {
                Section::Frame => out.push(Message::Binary(session.frame(self.next()).into())),
                _ => {
                    let text =
                        json!({"section": section.name(), "value": session.section(section)})
                            .to_string();
                    out.push(Message::Text(text.into()));
                }
            }
            if section == Section::Ik {
                out.push(Message::Binary(session.ghost_frame(self.next()).into()));
            }
        }
        out
    }
}

/// Sends what changed, and lets time pass while a motion plays; sleeps otherwise.
pub(super) async fn run(state: Arc<State>) {
    let hub = &state.hub;
    let mut last = Instant::now();
    loop {
        let playing = hub.session().is_playing();
        if playing {
            tokio::time::sleep(PICTURE).await;
        } else {
            hub.changed.notified().await;
            last = last.max(Instant::now().checked_sub(PICTURE).unwrap_or(last));
        }
        let messages = {
            let mut session = hub.session();
            let now = Instant::now();
            session.advance(now.duration_since(last).as_secs_f64());
            last = now;
            let changed = session.take_changes();
            hub.messages(&session, &changed)
        };
        if !messages.is_empty() {
            hub.tell(messages);
            if !playing {
                tokio::time::sleep(PICTURE).await;
            }
        }
    }
}
