//! The built page, inside the program.

use axum::body::Body;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use rust_embed::RustEmbed;

use super::security;

#[derive(RustEmbed)]
#[folder = "page/dist"]
struct Page;

/// Where the page's styles made at run time find their nonce.
const NONCE: &str = "{{nonce}}";

/// The page itself, with a fresh nonce.
pub(super) fn index() -> Response {
    let Some(file) = Page::get("index.html") else {
        return (
            StatusCode::NOT_FOUND,
            "the page is not built into this program",
        )
            .into_response();
    };
    let nonce = security::random_hex().unwrap_or_default();
    let text = String::from_utf8_lossy(&file.data).replace(NONCE, &nonce);
    let mut response = Response::new(Body::from(text));
    let headers = response.headers_mut();
    headers.insert(
        header::CONTENT_TYPE,
        HeaderValue::from_static("text/html; charset=utf-8"),
    );
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("no-store"));
    security::harden(headers, Some(&nonce));
    response
}

/// A file beside it.
pub(super) fn file(path: &str) -> Response {
    let Some(file) = Page::get(path) else {
        return (StatusCode::NOT_FOUND, "there is no such file").into_response();
    };
    let kind = match path.rsplit('.').next() {
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("svg") => "image/svg+xml",
        Some("html") => "text/html; charset=utf-8",
        _ => "application/octet-stream",
    };
    let mut response = Response::new(Body::from(file.data));
    response
        .headers_mut()
        .insert(header::CONTENT_TYPE, HeaderValue::from_static(kind));
    // Their names are hashes of their contents.
    response.headers_mut().insert(
        header::CACHE_CONTROL,
        HeaderValue::from_static("public, max-age=31536000, immutable"),
    );
    response
}

/// A file's text.
pub(super) fn text(path: &str) -> Option<String> {
    let file = Page::get(path)?;
    Some(String::from_utf8_lossy(&file.data).into_owned())
}

/// The files beside it that the page loads, in order.
pub(super) fn named_in(index: &str) -> Vec<String> {
    let ends = index.split("./assets/").skip(1);
    let names = ends.filter_map(|rest| rest.split('"').next());
    names.map(|name| format!("assets/{name}")).collect()
}
