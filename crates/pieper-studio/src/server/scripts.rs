//! The one script that may run at a time, and what the windows hear of it.

use std::sync::{Arc, Mutex, PoisonError};

use axum::extract::ws::Message;
use serde_json::{Value, json};

use super::State;
use crate::script::{self, Running};
use crate::session::Session;

#[derive(Default)]
pub(super) struct Scripts {
    running: Mutex<Option<Running>>,
}

/// The studio as a script sees it.
struct Host(Arc<State>);

impl script::Host for Host {
    fn with(&self, action: &mut dyn FnMut(&mut Session)) {
        action(&mut self.0.hub.session());
        self.0.hub.wake();
    }

    fn console(&self, stream: &'static str, text: &str) {
        let text = json!({"event": "console", "stream": stream, "text": text}).to_string();
        self.0.hub.tell(vec![Message::Text(text.into())]);
    }
}

impl State {
    /// Looks for Python, once, away from whoever waits.
    pub(super) fn look_for_python(self: &Arc<Self>) {
        let state = Arc::clone(self);
        std::thread::spawn(move || {
            let python = script::find_python();
            state.hub.session().python_found(python);
            state.hub.wake();
        });
    }

    /// Runs a script; one that runs already is an error.
    pub(super) fn run_script(self: &Arc<Self>, text: String) -> Result<Value, String> {
        let mut running = self
            .scripts
            .running
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        let python = {
            let mut session = self.hub.session();
            if session.is_script_running() {
                return Err("a script is running: stop it first".to_owned());
            }
            let python = session
                .python()
                .ok_or("Python is still being looked for: try again in a moment")?;
            session.script_begins(text.clone());
            python
        };
        match script::run(&python, text, Arc::new(Host(Arc::clone(self)))) {
            Ok(started) => {
                *running = Some(started);
                Ok(Value::Null)
            }
            Err(error) => {
                self.hub.session().script_ended(None, &error);
                Err(error)
            }
        }
    }

    /// Stops the script that runs, if one does.
    pub(super) fn stop_script(&self) {
        let running = self
            .scripts
            .running
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        if let Some(running) = running.as_ref() {
            running.stop();
        }
    }
}
