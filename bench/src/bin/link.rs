//! The link's speed: encoding and decoding, and EGM's loop of 4 ms under load beside the kernel's own sleep.
//!
//!     cargo run --release --manifest-path bench/Cargo.toml --bin link             # a quick look: 20 s of the loop
//!     cargo run --release --manifest-path bench/Cargo.toml --bin link -- 600      # ten minutes

use std::hint::black_box;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use pieper::motion::{Law, Profile};
use pieper_bench::{Contender, print, race};
use pieper_link::protocol::packets::{Axes, Code, Deframer, Mode, Packet, State, ToDevice, ToHost};
use pieper_link::protocol::{ar4, egm};
use pieper_link::simulator::{Place, Served};
use pieper_link::transport::Address;
use pieper_link::{Arm, Kind, Options, Phase, Record, Session};

fn main() {
    codecs();
    let seconds = std::env::args().nth(1).and_then(|text| text.parse().ok());
    cycles(seconds.unwrap_or(20.0));
}

const CALLS: usize = 10_000;

fn codecs() {
    let axes = Axes::of(&[0.1, -0.2, 0.3, -0.4, 0.5, -0.6]).expect("six values fit");
    let set_point = ToDevice::SetPoint { session: 7, time: 1234, axes };
    let state = State { clock: 99, session: 7, taken: 1230, mode: Mode::Armed, code: Code::None, axes };
    let mut out = Vec::with_capacity(4096);
    let mut frames = (Deframer::default(), Deframer::default());
    let mut bytes = Vec::with_capacity(4096);
    let joints = egm::Joints::of([1.0, -2.0, 3.0, -4.0, 5.0, -6.0]);
    let planned = egm::Planned { joints: Some(joints), ..egm::Planned::default() };
    let robot = egm::Robot { feedback: Some(planned), planned: Some(planned), ..egm::Robot::default() };
    let sensor = egm::Sensor { planned: Some(planned), ..egm::Sensor::default() };
    let mut told = Vec::new();
    robot.write(&mut told);
    let position = ar4::Reply::Position(ar4::Position { joints: [1.25; 9], ..ar4::Position::default() }).write();
    let mut contenders = [
        Contender::new("set-point and state, there and back", CALLS, || {
            for _ in 0..CALLS {
                out.clear();
                set_point.encode(3, &mut out);
                frames.0.push(&out, |packet| {
                    let packet = packet.expect("it was not damaged");
                    black_box(ToDevice::decode(packet).expect("it is one"));
                });
                out.clear();
                ToHost::State(state).encode(3, &mut out);
                frames.1.push(&out, |packet| {
                    let packet = packet.expect("it was not damaged");
                    black_box(ToHost::decode(packet).expect("it is one"));
                });
            }
        }),
        Contender::new("EGM: EgmRobot read, EgmSensor written", CALLS, || {
            for _ in 0..CALLS {
                black_box(egm::Robot::read(black_box(&told)).expect("it is one"));
                bytes.clear();
                sensor.write(&mut bytes);
                black_box(&bytes);
            }
        }),
        Contender::new("AR4: a position read", CALLS, || {
            for _ in 0..CALLS {
                black_box(ar4::Reply::read(black_box(&position)).expect("it is one"));
            }
        }),
    ];
    let times = race(&mut contenders, 101);
    print("Encoding and decoding (an operation is all that the name says)", &times, "set-point and state, there and back");
}

/// Both cores are kept busy while it is looked at when a cycle comes.
fn cycles(seconds: f64) {
    let off = Arc::new(AtomicBool::new(false));
    let load: Vec<_> = (0..2)
        .map(|seed| {
            let off = Arc::clone(&off);
            std::thread::spawn(move || {
                let mut x = seed as f64;
                while !off.load(Ordering::Relaxed) {
                    for _ in 0..1000 {
                        x = black_box((x + 1.0).sin());
                    }
                }
            })
        })
        .collect();
    let sleeper = {
        let off = Arc::clone(&off);
        std::thread::spawn(move || sleep(&off))
    };
    let ours = session(seconds);
    off.store(true, Ordering::SeqCst);
    let kernel = sleeper.join().expect("it only sleeps");
    load.into_iter().for_each(|thread| thread.join().expect("it only computes"));
    println!("\nEGM at 250 Hz for {seconds} s, two cores under load: the time from one set-point to the next, ms\n");
    println!("| | cycles | median | 99 % | 99.9 % | largest | above 6 ms | above 8 ms |");
    println!("|---|---|---|---|---|---|---|---|");
    row("set-points of the session", ours);
    row("a thread that sleeps to the next 4 ms", kernel);
}

fn row(name: &str, mut intervals: Vec<f64>) {
    intervals.sort_by(f64::total_cmp);
    let at = |share: f64| intervals[((intervals.len() - 1) as f64 * share) as usize];
    let above = |bound: f64| intervals.iter().filter(|x| **x > bound).count();
    println!(
        "| {name} | {} | {:.2} | {:.2} | {:.2} | {:.2} | {} | {} |",
        intervals.len(),
        at(0.5),
        at(0.99),
        at(0.999),
        at(1.0),
        above(6.0),
        above(8.0)
    );
}

/// The kernel's own: sleep to a deadline, look at the clock.
fn sleep(off: &AtomicBool) -> Vec<f64> {
    let start = Instant::now();
    let mut intervals = Vec::new();
    let mut last = start;
    for cycle in 1.. {
        let due = start + Duration::from_millis(4) * cycle;
        std::thread::sleep(due.saturating_duration_since(Instant::now()));
        let now = Instant::now();
        intervals.push(now.duration_since(last).as_secs_f64() * 1e3);
        last = now;
        if off.load(Ordering::Relaxed) {
            break;
        }
    }
    intervals
}

/// A session with the simulated controller, which calls every 4 ms; from its record, when set-points went out.
fn session(seconds: f64) -> Vec<f64> {
    let robot = pieper_robots::find("irb120").expect("it is built in").robot();
    let arm = Arc::new(Arm::of(&robot).expect("it has numbers"));
    let record = std::env::temp_dir().join(format!("pieper-link-bench-{}.jsonl", std::process::id()));
    let options = Options { share: 1.0, record: Some(record.clone()), ..Options::default() };
    let address = Address::Udp("127.0.0.1:16510".to_owned());
    let session = Session::connect(&address, Kind::Egm, Arc::clone(&arm), &options).expect("the port is free");
    let _controller = Served::start(Kind::Egm, &arm, &Place::Calls("127.0.0.1:16510".to_owned())).expect("it starts");
    session.wait_connected(Duration::from_secs(5)).expect("the controller calls");
    session.arm().expect("it may be armed");
    let there = [0.5, 0.3, -0.4, 0.5, 0.6, -0.5].to_vec();
    let law = Law::new(vec![0.0, 2.0, 4.0], vec![vec![0.0; 6], there, vec![0.0; 6]], Profile::Quintic);
    let law = law.expect("times rise");
    let end = Instant::now() + Duration::from_secs_f64(seconds);
    let mut stops = 0;
    while Instant::now() < end {
        session.beat();
        let status = session.status();
        match status.phase {
            Phase::Holding => {
                // A refusal is only that the arm is still coming to rest.
                let _ = session.play(law.clone());
            }
            Phase::Stopped => {
                stops += 1;
                println!("stopped: {}", status.sentence.unwrap_or_default());
                let _ = session.arm();
            }
            _ => {}
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    println!("\nstops: {stops}");
    drop(session);
    let text = std::fs::read_to_string(&record).expect("it was recorded");
    let _ = std::fs::remove_file(&record);
    let record = Record::read(&text).expect("it reads");
    let times: Vec<f64> = record.samples().map(|sample| sample.time).collect();
    times.windows(2).map(|pair| (pair[1] - pair[0]) * 1e3).collect()
}
