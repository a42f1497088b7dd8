//! Windows on one studio.

use std::time::{Duration, Instant};

use futures_util::{SinkExt as _, StreamExt as _};
use serde_json::{Value, json};
use tokio_tungstenite::tungstenite::{Message, client::IntoClientRequest as _};

use crate::support::{Served, serve};

pub(crate) type Window =
    tokio_tungstenite::WebSocketStream<tokio_tungstenite::MaybeTlsStream<tokio::net::TcpStream>>;

pub(crate) async fn open(studio: &Served) -> Window {
    let mut request = format!("ws://127.0.0.1:{}/ws", studio.port)
        .into_client_request()
        .unwrap();
    let bearer = format!("Bearer {}", studio.token).parse().unwrap();
    request.headers_mut().insert("Authorization", bearer);
    tokio_tungstenite::connect_async(request).await.unwrap().0
}

pub(crate) async fn say(window: &mut Window, message: Value) {
    window
        .send(Message::Text(message.to_string().into()))
        .await
        .unwrap();
}

/// Reads until a text satisfies the condition.
pub(crate) async fn until(window: &mut Window, mut wanted: impl FnMut(&Value) -> bool) -> Value {
    let deadline = Duration::from_secs(10);
    loop {
        let message = tokio::time::timeout(deadline, window.next())
            .await
            .expect("an answer in time")
            .unwrap()
            .unwrap();
        if let Message::Text(text) = message {
            let value: Value = serde_json::from_str(&text).unwrap();
            if wanted(&value) {
                return value;
            }
        }
    }
}

pub(crate) fn is_pose(value: &Value, joint: usize, at: f64) -> bool {
    value["section"] == "pose" && (value["value"]["q"][joint].as_f64().unwrap() - at).abs() < 1e-9
}

#[tokio::test]
async fn a_new_window_is_told_everything_and_two_stay_in_step() {
    let studio = serve("ar3");
    let (mut one, mut two) = (open(&studio).await, open(&studio).await);
    for name in [
        "robots", "robot", "pose", "ik", "motion", "script", "history", "log",
    ] {
        until(&mut two, |value| value["section"] == name).await;
    }
    say(
        &mut one,
        json!({"id": 7, "do": "joint", "joint": 0, "value": "30deg"}),
    )
    .await;
    let ack = until(&mut one, |value| value.get("ack").is_some()).await;
    assert_eq!(ack, json!({"ack": 7, "value": null}));
    for window in [&mut one, &mut two] {
        until(window, |value| is_pose(value, 0, 30_f64.to_radians())).await;
    }
    // A cut cable: the next connection has the whole state.
    drop(one);
    let mut three = open(&studio).await;
    until(&mut three, |value| is_pose(value, 0, 30_f64.to_radians())).await;
    let history = until(&mut three, |value| value["section"] == "history").await;
    assert_eq!(history["value"]["undo"], "J1");
}

#[tokio::test]
async fn whatever_is_said_is_answered() {
    let studio = serve("irb120");
    let mut window = open(&studio).await;
    let mut random = fastrand::Rng::with_seed(4);
    let words = [
        "joints", "joint", "tool", "grab", "drag", "release", "seek", "load", "open", "keyframe",
        "family", "solution", "law", "step", "undo", "fly",
    ];
    let fields = [
        "q",
        "joint",
        "value",
        "position",
        "rpy",
        "quaternion",
        "matrix",
        "origin",
        "direction",
        "t",
        "by",
        "index",
        "at",
        "text",
        "op",
        "robot",
        "to",
    ];
    for round in 0..1500 {
        let mut message = serde_json::Map::new();
        message.insert("id".into(), json!(round));
        message.insert("do".into(), json!(words[random.usize(..words.len())]));
        for _ in 0..random.usize(..4) {
            message.insert(
                fields[random.usize(..fields.len())].into(),
                anything(&mut random, 2),
            );
        }
        say(&mut window, Value::Object(message)).await;
        until(&mut window, |value| value["ack"] == round).await;
    }
    for text in ["", "null", "[]", "7", "{", "{\"id\": 1}"] {
        window.send(Message::Text(text.into())).await.unwrap();
    }
    say(&mut window, json!({"ping": 1.5})).await;
    until(&mut window, |value| value["pong"] == 1.5).await;
}

fn anything(random: &mut fastrand::Rng, depth: usize) -> Value {
    match random.usize(..if depth == 0 { 6 } else { 8 }) {
        0 => Value::Null,
        1 => json!(random.bool()),
        2 => json!(random.i64(-3..9)),
        3 => json!((random.f64() - 0.5) * 10_f64.powi(random.i32(-12..300))),
        4 => json!(
            [
                "90deg", "pi/0", "home", "add", "matrix", "", "\u{0}", "1e999"
            ][random.usize(..8)]
        ),
        5 => json!({"name": "x.urdf", "text": "<robot"}),
        _ => (0..random.usize(..7))
            .map(|_| anything(random, depth - 1))
            .collect(),
    }
}

#[tokio::test]
async fn a_motion_plays_by_the_program_s_clock() {
    let studio = serve("ar3");
    let mut window = open(&studio).await;
    say(&mut window, json!({"do": "keyframe", "op": "add", "t": 0})).await;
    say(
        &mut window,
        json!({"do": "joint", "joint": 0, "value": 0.6}),
    )
    .await;
    say(
        &mut window,
        json!({"do": "keyframe", "op": "add", "t": 0.5}),
    )
    .await;
    let start = Instant::now();
    say(&mut window, json!({"id": 1, "do": "play"})).await;
    let (mut acknowledged, mut arrived) = (false, false);
    until(&mut window, |value| {
        acknowledged |= value["ack"] == 1;
        arrived |= acknowledged && is_pose(value, 0, 0.6);
        let motion = &value["value"];
        acknowledged
            && value["section"] == "motion"
            && motion["playing"] == false
            && motion["time"] == 0.5
    })
    .await;
    assert!(arrived && start.elapsed() >= Duration::from_millis(450));
    assert!(start.elapsed() < Duration::from_secs(5));
}

#[tokio::test]
async fn a_four_bar_drive_is_three_more_links() {
    let studio = serve("abb-paper");
    let mut window = open(&studio).await;
    let robot = until(&mut window, |value| value["section"] == "robot").await;
    let links = robot["value"]["links"].as_array().unwrap();
    let names: Vec<&str> = links.iter().map(|l| l["name"].as_str().unwrap()).collect();
    assert_eq!(names.len(), 10, "{names:?}");
    assert_eq!(names[7..], ["crank of m3", "coupler of m3", "rocker of m3"]);
    // Touched, they move what they drive.
    assert!(links[7..].iter().all(|link| link["joint"] == 2));
    assert!(
        links[7..]
            .iter()
            .all(|link| !link["parts"].as_array().unwrap().is_empty())
    );
}
