//! One file that shows the present view without a server: the page, the state, the meshes and the motion's pictures.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Map, Value, json};

use super::assets;
use crate::sections::Section;
use crate::session::Session;

/// Pictures of the motion that go with it, at most, and per second.
const MOST_PICTURES: f64 = 360.0;
const RATE: f64 = 20.0;

/// The file. It carries no token and no script text.
///
/// # Errors
/// A sentence if the page is not built into this program.
pub(super) fn file(session: &Session) -> Result<String, String> {
    let missing = || "the page is not built into this program".to_owned();
    let index = assets::text("index.html").ok_or_else(missing)?;
    let [mut style, mut script] = [String::new(), String::new()];
    for name in assets::named_in(&index) {
        let text = assets::text(&name).ok_or_else(missing)?;
        match name.rsplit('.').next() {
            Some("css") => style.push_str(&text),
            Some("js") => script.push_str(&text),
            _ => {}
        }
    }
    // Nothing inside may end the element that it stands in.
    let snapshot = snapshot(session).to_string().replace('<', "\\u003c");
    let script = script.replace("</script", "<\\/script");
    let title = format!("{} - pieper studio", session.arm.robot.name)
        .replace('&', "&amp;")
        .replace('<', "&lt;");
    Ok(format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:\">\n\
         <title>{title}</title>\n<style>{style}</style></head>\n<body><div id=\"app\"></div>\n\
         <script type=\"application/json\" id=\"snapshot\">{snapshot}</script>\n\
         <script type=\"module\">{script}</script></body></html>\n"
    ))
}

fn snapshot(session: &Session) -> Value {
    let mut sections = Map::new();
    for section in Section::ALL {
        match section {
            // The list of other arms, the script and what was logged are nobody else's business.
            Section::Frame
            | Section::Script
            | Section::Log
            | Section::Robots
            | Section::History => {}
            _ => {
                sections.insert(section.name().to_owned(), session.section(section));
            }
        }
    }
    let meshes = session
        .arm
        .meshes
        .iter()
        .map(|(name, bytes)| (name.clone(), json!(STANDARD.encode(bytes))));
    json!({
        "sections": sections,
        "frame": STANDARD.encode(session.frame(1)),
        "ghosts": STANDARD.encode(session.ghost_frame(1)),
        "meshes": meshes.collect::<Map<_, _>>(),
        "samples": session.motion.samples(&session.arm, 30.0),
        "pictures": session.pictures(RATE, MOST_PICTURES).iter().map(|picture| json!(STANDARD.encode(picture))).collect::<Value>(),
    })
}
