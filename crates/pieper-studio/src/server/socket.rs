//! One window's WebSocket.

use std::sync::Arc;

use axum::extract::ws::{Message, WebSocket};
use futures_util::{SinkExt as _, StreamExt as _};
use serde_json::{Value, json};
use tokio::sync::broadcast::error::RecvError;

use super::{State, controller};
use crate::command::Command;

/// Serves one window until it goes.
pub(super) async fn serve(socket: WebSocket, state: Arc<State>) {
    let (mut out, mut incoming) = socket.split();
    let mut changes = state.hub.listen();
    let told = state.hub.whole();
    for message in told.into_iter().chain(controller::whole(&state.controller)) {
        if out.send(message).await.is_err() {
            return;
        }
    }
    loop {
        tokio::select! {
            message = incoming.next() => {
                let answer = match message {
                    Some(Ok(Message::Text(text))) => answer(&state, &text),
                    Some(Ok(Message::Close(_)) | Err(_)) | None => return,
                    Some(Ok(_)) => continue,
                };
                if let Some(answer) = answer && out.send(Message::Text(answer.into())).await.is_err() {
                    return;
                }
            }
            change = changes.recv() => {
                let messages = match change {
                    Ok(messages) => messages.to_vec(),
                    // Too slow: everything anew.
                    Err(RecvError::Lagged(_)) => state.hub.whole(),
                    Err(RecvError::Closed) => return,
                };
                for message in messages {
                    if out.send(message).await.is_err() {
                        return;
                    }
                }
            }
        }
    }
}

/// The answer to a text, if it wants one.
fn answer(state: &Arc<State>, text: &str) -> Option<String> {
    let mut message: Value = match serde_json::from_str(text) {
        Ok(message) => message,
        Err(error) => {
            return Some(json!({"ack": null, "error": format!("no JSON: {error}")}).to_string());
        }
    };
    if let Some(time) = message.get("ping") {
        return Some(json!({"pong": time}).to_string());
    }
    let id = message
        .as_object_mut()
        .and_then(|object| object.remove("id"));
    let result = apply(state, message);
    let id = id?;
    Some(match result {
        Ok(value) => json!({"ack": id, "value": value}).to_string(),
        Err(error) => json!({"ack": id, "error": error}).to_string(),
    })
}

/// Does a command, and wakes whoever tells the windows.
pub(super) fn apply(state: &Arc<State>, message: Value) -> Result<Value, String> {
    if let Some(result) = controller::apply(state, &message) {
        return result;
    }
    match message.get("do").and_then(Value::as_str) {
        // What these bring back or change, no hand has moved: a real arm does not follow it.
        Some("undo" | "redo" | "open" | "load") => state.controller.void(),
        // These two start and stop processes, which a session knows nothing of.
        Some("script_run") => {
            let text = message
                .get("text")
                .and_then(Value::as_str)
                .ok_or("script_run: a text was expected")?;
            let result = state.run_script(text.to_owned());
            state.hub.wake();
            return result;
        }
        Some("script_stop") => {
            state.stop_script();
            return Ok(Value::Null);
        }
        _ => {}
    }
    let command: Command = serde_json::from_value(message).map_err(|error| error.to_string())?;
    let result = state.hub.session().apply(command);
    state.hub.wake();
    result
}
