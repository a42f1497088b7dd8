//! The routes.

use std::sync::Arc;

use axum::Router;
use axum::body::{Body, Bytes};
use axum::extract::{DefaultBodyLimit, Path, Request, State as Shared, WebSocketUpgrade};
use axum::http::{HeaderValue, StatusCode, header};
use axum::middleware::{self, Next};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use serde_json::{Value, json};

use super::{State, assets, security, share, socket};
use crate::sections::Section;

/// The largest body of a request.
const LARGEST: usize = 16 << 20;

/// The largest text of a WebSocket.
const LONGEST: usize = 1 << 20;

pub(super) fn router(state: Arc<State>) -> Router {
    let guarded = Router::new()
        .route("/api/state", get(whole))
        .route("/api/command", post(command))
        .route("/api/project.json", get(project))
        .route("/api/picture", post(picture))
        .route("/api/share.html", get(shared))
        .route("/api/export/{name}", get(export))
        .route("/api/interface", get(interface))
        .route("/mesh/{hash}", get(mesh))
        .route("/ws", get(window))
        .layer(middleware::from_fn_with_state(
            Arc::clone(&state),
            check_token,
        ));
    Router::new()
        .route("/", get(|| async { assets::index() }))
        .route(
            "/assets/{*path}",
            get(|Path(path): Path<String>| async move { assets::file(&format!("assets/{path}")) }),
        )
        .route("/api/session", post(session))
        .merge(guarded)
        .fallback(|| async { (StatusCode::NOT_FOUND, "there is nothing here") })
        .layer(DefaultBodyLimit::max(LARGEST))
        .layer(middleware::from_fn_with_state(
            Arc::clone(&state),
            check_place,
        ))
        .with_state(state)
}

/// Host and Origin of every request; the hardening headers of every answer.
async fn check_place(Shared(state): Shared<Arc<State>>, request: Request, next: Next) -> Response {
    let upgrade = request.headers().contains_key(header::UPGRADE);
    let mut response = match state
        .keys
        .check_place(request.method(), request.headers(), upgrade)
    {
        Ok(()) => next.run(request).await,
        Err(refusal) => refusal.into_response(),
    };
    if !response
        .headers()
        .contains_key(header::CONTENT_SECURITY_POLICY)
    {
        security::harden(response.headers_mut(), None);
    }
    response
}

async fn check_token(Shared(state): Shared<Arc<State>>, request: Request, next: Next) -> Response {
    match state.keys.check_token(request.headers()) {
        Ok(()) => next.run(request).await,
        Err(refusal) => refusal.into_response(),
    }
}

/// The token of the address, for a cookie.
async fn session(Shared(state): Shared<Arc<State>>, body: String) -> Response {
    let given: Value = serde_json::from_str(&body).unwrap_or_default();
    let token = given
        .get("token")
        .and_then(Value::as_str)
        .unwrap_or_default();
    if !state.keys.is_token(token) {
        return (
            StatusCode::UNAUTHORIZED,
            "this is not the token of this start: open the address that the program printed",
        )
            .into_response();
    }
    let mut response = StatusCode::NO_CONTENT.into_response();
    if let Ok(cookie) = HeaderValue::from_str(&state.keys.cookie()) {
        response.headers_mut().insert(header::SET_COOKIE, cookie);
    }
    response
}

async fn whole(Shared(state): Shared<Arc<State>>) -> Response {
    let session = state.hub.session();
    let sections = Section::ALL
        .into_iter()
        .filter(|section| *section != Section::Frame);
    let all: serde_json::Map<String, Value> = sections
        .map(|section| (section.name().to_owned(), session.section(section)))
        .collect();
    document(&Value::Object(all))
}

async fn command(Shared(state): Shared<Arc<State>>, body: String) -> Response {
    let message = serde_json::from_str(&body).map_err(|error| format!("no JSON: {error}"));
    match message.and_then(|message| socket::apply(&state, message)) {
        Ok(value) => document(&json!({"ok": true, "value": value})),
        Err(error) => (
            StatusCode::UNPROCESSABLE_ENTITY,
            document(&json!({"error": error})),
        )
            .into_response(),
    }
}

async fn project(Shared(state): Shared<Arc<State>>) -> Response {
    document(&state.hub.session().project())
}

/// The picture that `pieper studio --headless-frame` waits for.
async fn picture(Shared(state): Shared<Arc<State>>, body: Bytes) -> Response {
    match state.picture.arrive(body.to_vec()) {
        true => StatusCode::NO_CONTENT.into_response(),
        false => (StatusCode::NOT_FOUND, "no picture is waited for").into_response(),
    }
}

async fn export(Shared(state): Shared<Arc<State>>, Path(name): Path<String>) -> Response {
    match state.hub.session().export(&name) {
        Ok((kind, content)) => {
            let headers = [
                (header::CONTENT_TYPE, kind),
                (header::CONTENT_DISPOSITION, "attachment"),
                (header::CACHE_CONTROL, "no-store"),
            ];
            (headers, content).into_response()
        }
        Err(error) => (StatusCode::NOT_FOUND, error).into_response(),
    }
}

async fn shared(Shared(state): Shared<Arc<State>>) -> Response {
    let file = share::file(&state.hub.session());
    match file {
        Ok(text) => {
            let headers = [
                (header::CONTENT_TYPE, "text/html; charset=utf-8"),
                (
                    header::CONTENT_DISPOSITION,
                    "attachment; filename=\"arm.html\"",
                ),
                (header::CACHE_CONTROL, "no-store"),
            ];
            (headers, text).into_response()
        }
        Err(error) => (StatusCode::NOT_FOUND, error).into_response(),
    }
}

async fn interface() -> Response {
    (
        [(header::CONTENT_TYPE, "text/markdown; charset=utf-8")],
        include_str!("../../WIRE.md"),
    )
        .into_response()
}

async fn mesh(Shared(state): Shared<Arc<State>>, Path(hash): Path<String>) -> Response {
    let found = state.hub.session().arm.meshes.get(&hash).cloned();
    let Some(bytes) = found else {
        return (StatusCode::NOT_FOUND, "the present arm has no such mesh").into_response();
    };
    let headers = [
        (header::CONTENT_TYPE, "application/octet-stream"),
        (
            header::CACHE_CONTROL,
            "private, max-age=31536000, immutable",
        ),
    ];
    (headers, Body::from(bytes)).into_response()
}

async fn window(Shared(state): Shared<Arc<State>>, upgrade: WebSocketUpgrade) -> Response {
    upgrade
        .max_message_size(LONGEST)
        .on_upgrade(move |socket| socket::serve(socket, state))
}

fn document(value: &Value) -> Response {
    let headers = [
        (header::CONTENT_TYPE, "application/json"),
        (header::CACHE_CONTROL, "no-store"),
    ];
    (headers, value.to_string()).into_response()
}
