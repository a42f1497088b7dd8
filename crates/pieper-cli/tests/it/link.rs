//! `pieper link`, with simulated controllers on real sockets.

use std::io::{BufRead as _, BufReader, Write as _};
use std::process::{Child, Command, Stdio};

use crate::support::{Ended, Temporary, pieper, state};

/// A simulated controller that runs, and where.
struct Simulated {
    child: Child,
    address: String,
}

fn program() -> Command {
    let mut program = Command::new(env!("CARGO_BIN_EXE_pieper"));
    program.env("XDG_STATE_HOME", state());
    program
}

impl Simulated {
    fn start(kind: &str, more: &[&str]) -> Self {
        let mut child = program()
            .args(["link", "simulate", kind, "--tcp", "0"])
            .args(more)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap())
            .read_line(&mut line)
            .unwrap();
        let address = line.trim().to_owned();
        Self { child, address }
    }

    fn fault(&mut self, name: &str) {
        writeln!(self.child.stdin.as_mut().unwrap(), "{name}").unwrap();
    }
}

impl Drop for Simulated {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn json(ended: &Ended) -> serde_json::Value {
    serde_json::from_str(&ended.stdout).expect(&ended.stderr)
}

/// A short motion of an AR4.
const MOTION: &str = "t,J1_deg,J2_deg,J3_deg,J4_deg,J5_deg,J6_deg\n0,0,0,0,0,0,0\n1.5,-20,10,-5,10,20,30\n3,0,0,0,0,0,0\n";

#[test]
fn a_motion_is_checked_before_anything_is_connected() {
    let ended = pieper(&[
        "link",
        "send",
        "examples/ar4-programme.csv",
        "--protocol",
        "ar4",
    ]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(
        ended.stdout.contains("nothing was sent"),
        "{}",
        ended.stdout
    );
    let ended = pieper(&[
        "link",
        "send",
        "examples/ar3-programme.csv",
        "--protocol",
        "ar4",
    ]);
    assert_eq!(ended.code, 1);
    assert!(
        ended.stderr.contains("J3 = 90.00° is outside its limits"),
        "{}",
        ended.stderr
    );
    let ended = pieper(&[
        "link",
        "send",
        "examples/ar4-programme.csv",
        "--protocol",
        "ar4",
        "--speed",
        "3",
    ]);
    assert_eq!(ended.code, 1);
    assert!(
        ended
            .stderr
            .contains("of its speed the motion could be run"),
        "{}",
        ended.stderr
    );
    let ended = pieper(&[
        "link",
        "send",
        "examples/ar3-poses.csv",
        "--protocol",
        "ar3",
    ]);
    assert_eq!(ended.code, 2);
    assert!(
        ended
            .stderr
            .contains("a table of joint values was expected"),
        "{}",
        ended.stderr
    );
}

#[test]
fn a_motion_is_run_recorded_and_plotted() {
    let folder = Temporary::new();
    let motion = folder.file("motion.csv", MOTION);
    let record = folder.path("session.jsonl");
    let simulated = Simulated::start("ar4", &[]);
    let to = simulated.address.as_str();
    // The protocol is found by trying.
    let ended = pieper(&[
        "link", "send", &motion, "--to", to, "--arm", "--record", &record,
    ]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(ended.stderr.contains("trying ar4"), "{}", ended.stderr);
    assert!(
        ended.stdout.contains("an AR4 (firmware 4.x)"),
        "{}",
        ended.stdout
    );
    assert!(ended.stdout.contains("playing"), "{}", ended.stdout);
    assert!(ended.stdout.contains("done: "), "{}", ended.stdout);
    let out = folder.path("out");
    let ended = pieper(&["link", "log", &record, "--out", &out, "--json"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let log = json(&ended);
    assert_eq!(log["protocol"], "ar4");
    assert!(log["duration"].as_f64().unwrap() > 1.5);
    // Of whole moves the ends are compared: to what the wire's three decimals are worth.
    for error in log["worst_errors"].as_array().unwrap() {
        assert!(error.as_f64().unwrap() < 1e-4, "{log}");
    }
    // The motion that was recorded can be checked and sent again.
    let again = format!("{out}/motion.csv");
    let ended = pieper(&["run", "ar4", &again, "--out", &folder.path("run")]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let figure = std::fs::read(format!("{out}/tracking.png")).unwrap();
    assert!(
        png::Decoder::new(std::io::Cursor::new(figure))
            .read_info()
            .is_ok()
    );
}

#[test]
fn nothing_moves_without_arm() {
    let simulated = Simulated::start("packets", &["--robot", "ar4"]);
    let line = [
        "--to",
        &simulated.address,
        "--protocol",
        "packets",
        "--robot",
        "ar4",
    ];
    let jog = |more: &[&str]| {
        let words = [&["link", "jog", "J1", "10deg", "--speed", "1"], more, &line].concat();
        pieper(&words)
    };
    let ended = jog(&[]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(
        ended.stdout.contains("nothing was sent"),
        "{}",
        ended.stdout
    );
    let where_is = || {
        let words = [
            &["link", "connect", "--seconds", "0.3", "--json"],
            &line[..],
        ]
        .concat();
        json(&pieper(&words))["measured"][0].as_f64().unwrap()
    };
    assert_eq!(where_is(), 0.0);
    let ended = jog(&["--arm"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!((where_is() - 10_f64.to_radians()).abs() < 1e-4);
    let words = [&["link", "jog", "J1", "900deg", "--arm"], &line[..]].concat();
    let ended = pieper(&words);
    assert_eq!(ended.code, 1);
    assert!(
        ended.stderr.contains("outside its limits"),
        "{}",
        ended.stderr
    );
}

#[test]
fn a_pulled_plug_stops_with_a_sentence() {
    let folder = Temporary::new();
    let motion = folder.file("motion.csv", MOTION);
    let mut simulated = Simulated::start("packets", &["--robot", "ar4"]);
    let child = program()
        .args(["link", "send", &motion, "--to", &simulated.address, "--arm"])
        .args(["--protocol", "packets", "--robot", "ar4"])
        .args(["--record", &folder.path("session.jsonl")])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(1500));
    simulated.fault("unplug");
    let ended = child.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(3));
    let said = String::from_utf8(ended.stderr).unwrap();
    assert!(said.contains("is the cable in"), "{said}");
    assert!(said.contains("session.jsonl"), "{said}");
    // What was recorded up to then can be read.
    let ended = pieper(&["link", "log", &folder.path("session.jsonl")]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(ended.stdout.contains("is the cable in"), "{}", ended.stdout);
}

#[test]
fn servos_are_matched_at_their_ends() {
    let folder = Temporary::new();
    let simulated = Simulated::start("servo", &["--robot", "abb-paper"]);
    let file = folder.path("matched.toml");
    let mut child = program()
        .args([
            "link",
            "map",
            "--robot",
            "abb-paper",
            "--protocol",
            "servo",
            "--arm",
        ])
        .args(["--to", &simulated.address, "--out", &file])
        .args(["--record", &folder.path("session.jsonl")])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // The first servo turns the other way and is geared down, the others stay as they are.
    let typed = "120\n= -40\n60\n= 50\n+5\n\nskip\nskip\nskip\nskip\nskip\n";
    child
        .stdin
        .take()
        .unwrap()
        .write_all(typed.as_bytes())
        .unwrap();
    let ended = child.wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&ended.stderr).into_owned();
    assert_eq!(ended.status.code(), Some(0), "{said}");
    assert!(said.contains("the other way"), "{said}");
    // 60 degrees of the servo for 90 of the joint, and 120 - 40 * 2/3 at its zero.
    let ended = pieper(&["fk", &file, "--q", "0,90,0,0,0,0", "--deg", "--json"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let motor = json(&ended)["motors"][0].as_f64().unwrap();
    assert!((motor - (120.0 - 40.0 * 2.0 / 3.0)).abs() < 0.02, "{motor}");
}

#[test]
fn every_example_in_help_works_as_typed() {
    for command in ["list", "simulate", "connect", "jog", "send"] {
        let help = pieper(&["link", command, "--help"]).stdout;
        let examples = help.lines().map(str::trim);
        for example in examples.filter(|line| line.starts_with("pieper link ")) {
            let simulated = Simulated::start("ar4", &[]);
            let example = example
                .replace("tcp:127.0.0.1:7004", &simulated.address)
                .replace("--tcp 7001", "--tcp 0");
            // The programme takes a while: its first seconds are run as another test's.
            if example.contains("send") && example.contains("--arm") {
                continue;
            }
            let words: Vec<&str> = example.split_whitespace().skip(1).collect();
            let ended = pieper(&words);
            assert_eq!(ended.code, 0, "{example}: {}", ended.stderr);
        }
    }
}
