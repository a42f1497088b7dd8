//! The studio's two waits: what the pointer's ray meets, and a command's way to the program and back.
//!
//! `cargo run --release --bin studio`

use std::f64::consts::{PI, TAU};
use std::sync::Arc;
use std::time::{Duration, Instant};

use nalgebra::{Isometry3, Point3, Vector3};
use pieper_scene::{Body, Mesh, Part, Picker};
use pieper_studio::{Arm, Options, Session, Studio};
use tungstenite::client::IntoClientRequest as _;
use tungstenite::{Message, stream::MaybeTlsStream};

fn main() {
    println!("| what | median | 95 % | 99 % | asked |");
    println!("|---|---|---|---|---|");
    pick();
    round_trip();
}

/// A row of the table; the times are sorted.
fn row(what: &str, mut times: Vec<Duration>, asked: &str) {
    times.sort_unstable();
    let us = |share: f64| {
        let at = ((times.len() - 1) as f64 * share) as usize;
        format!("{:.1} us", times[at].as_secs_f64() * 1e6)
    };
    println!("| {what} | {} | {} | {} | {asked} |", us(0.5), us(0.95), us(0.99));
}

/// A ball with hills, of about this many triangles: no box around a part of it is empty.
fn hills(triangles: usize) -> Mesh {
    let rings = ((triangles / 4) as f64).sqrt() as usize;
    let place = |ring: usize, step: usize| {
        let (tilt, turn) = (PI * ring as f64 / rings as f64, TAU * step as f64 / (2 * rings) as f64);
        let radius = 0.3 + 0.02 * (40.0 * tilt).sin() * (23.0 * turn).cos();
        [tilt.sin() * turn.cos(), tilt.sin() * turn.sin(), tilt.cos()].map(|x| radius * x)
    };
    let mut all = Vec::new();
    for ring in 0..rings {
        for step in 0..2 * rings {
            let [a, b] = [place(ring, step), place(ring, step + 1)];
            let [c, d] = [place(ring + 1, step), place(ring + 1, step + 1)];
            all.extend([[a, c, d], [a, d, b]]);
        }
    }
    Mesh::of_triangles(&all, 0.5)
}

fn pick() {
    let mesh = Arc::new(hills(200_000));
    let part = Part {
        name: "hills".to_owned(),
        mesh: Arc::clone(&mesh),
        color: pieper_scene::body::SHELL,
        placed: Isometry3::identity(),
        collision: false,
    };
    let body = Body { links: vec![vec![part]], problems: Vec::new() };
    let start = Instant::now();
    let picker = Picker::new(&body);
    let prepared = start.elapsed();
    let poses = [Isometry3::translation(0.1, 0.2, 0.3)];
    let mut random = fastrand::Rng::with_seed(1);
    let mut cube = |size: f64| Vector3::from_fn(|_, _| size * (random.f64() - 0.5));
    let mut hits = 0;
    let times = (0..20_000).map(|_| {
        let (from, to) = (Point3::from(cube(4.0)), poses[0] * Point3::from(cube(0.8)));
        let start = Instant::now();
        let hit = picker.pick(&from, &(to - from), &poses);
        let took = start.elapsed();
        hits += usize::from(hit.is_some());
        took
    });
    let times = times.collect();
    let what = format!("pick, {} triangles, {hits} of 20000 rays meet one (prepared in {:.0} ms)", mesh.triangles(), prepared.as_secs_f64() * 1e3);
    row(&what, times, "1 ms");
}

fn round_trip() {
    let robot = pieper_robots::find("ar3").expect("it is built in").robot();
    let arm = Arm::new("ar3", robot, &|_| Err("no files here".to_owned())).expect("it is an arm");
    let studio = Studio::bind(Session::new(arm), &Options::default()).expect("a free port");
    let url = studio.url();
    std::thread::spawn(move || studio.serve());
    let (address, token) = url.split_once("/#token=").expect("a token");
    let mut request = format!("{}/ws", address.replace("http", "ws")).into_client_request().expect("an address");
    let bearer = format!("Bearer {token}").parse().expect("plain letters");
    request.headers_mut().insert("Authorization", bearer);
    let (mut socket, _) = tungstenite::connect(request).expect("it listens");
    if let MaybeTlsStream::Plain(stream) = socket.get_mut() {
        stream.set_nodelay(true).expect("a socket");
    }
    let times = (0..1_000).map(|number| {
        let at = 0.2 * f64::from(number) % 60.0;
        let start = Instant::now();
        let text = format!(r#"{{"id": {number}, "do": "joint", "joint": 0, "value": "{at}deg"}}"#);
        socket.send(Message::Text(text.into())).expect("it listens");
        // The new pose, which is what the picture follows: the acknowledgement comes before it.
        let wanted = at.to_radians();
        loop {
            let Message::Text(text) = socket.read().expect("it answers") else { continue };
            let value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
            let there = value["value"]["q"][0].as_f64();
            if value["section"] == "pose" && there.is_some_and(|q| (q - wanted).abs() < 1e-9) {
                break;
            }
        }
        let took = start.elapsed();
        // Not sooner than the next picture: what comes between two is sent with the second.
        std::thread::sleep(Duration::from_millis(20));
        took
    });
    let times = times.collect();
    row("a slider's value to the program, the pose back", times, "2 ms");
}
