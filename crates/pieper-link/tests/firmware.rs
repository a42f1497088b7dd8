//! The reference firmware: compiled for this computer and run, compiled for an ATmega328P and run in simavr; a session with each.

// Tests may unwrap, and so may their helper functions.
#![allow(clippy::unwrap_used, clippy::expect_used)]
#![allow(clippy::print_stderr, reason = "a test that is left out says so")]

use std::io::{Read as _, Write as _};
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::time::{Duration, Instant};

use pieper_link::protocol::packets::{Deframer, Packet as _, ToDevice, ToHost};
use pieper_link::transport::Address;
use pieper_link::{Arm, Kind, Options, Phase, Session, Status};

fn firmware() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../firmware")
}

/// A folder for what is compiled; it stays, as the compiler's other output does.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Runs a compiler. `None` where there is none: the test command installs those of the continuous integration.
fn compile(program: &str, arguments: &[&str]) -> Option<()> {
    let ran = Command::new(program)
        .args(arguments)
        .current_dir(firmware())
        .output();
    let Ok(ran) = ran else {
        eprintln!("without {program} this is not tried");
        return None;
    };
    let said = String::from_utf8_lossy(&ran.stderr).into_owned();
    assert!(ran.status.success(), "{program}: {said}");
    Some(())
}

/// The firmware as a program of this computer.
fn for_host() -> Option<PathBuf> {
    let program = folder("firmware-host").join(format!("servos-{}", std::process::id()));
    let path = program.display().to_string();
    compile(
        "cc",
        &[
            "-std=c99",
            "-O2",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-o",
            &path,
            "host.c",
            "pieper_packets.c",
        ],
    )?;
    Some(program)
}

/// A program behind a socket: its standard input and output are the line.
struct Line {
    child: Arc<std::sync::Mutex<Child>>,
    address: Address,
}

impl Line {
    fn start(mut command: Command) -> Self {
        let mut child = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let (mut input, mut output) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = listener.local_addr().unwrap().port();
        std::thread::spawn(move || {
            let (socket, _) = listener.accept().unwrap();
            socket.set_nodelay(true).unwrap();
            let mut down = socket.try_clone().unwrap();
            std::thread::spawn(move || {
                let mut buffer = [0; 4096];
                while let Ok(count @ 1..) = output.read(&mut buffer) {
                    // Drained to the end: a program whose output nobody takes is killed before its last words.
                    let _ = down.write_all(&buffer[..count]);
                }
            });
            let mut up = socket;
            let mut buffer = [0; 4096];
            while let Ok(count @ 1..) = up.read(&mut buffer) {
                if input.write_all(&buffer[..count]).is_err() {
                    return;
                }
            }
        });
        Self {
            child: Arc::new(std::sync::Mutex::new(child)),
            address: Address::Tcp(format!("127.0.0.1:{port}")),
        }
    }

    /// What the program says at its end, which comes when its input ends.
    fn said(self) -> String {
        let mut text = String::new();
        let mut child = self.child.lock().unwrap();
        child
            .stderr
            .take()
            .unwrap()
            .read_to_string(&mut text)
            .unwrap();
        text
    }
}

impl Drop for Line {
    fn drop(&mut self) {
        let mut child = self.child.lock().unwrap();
        let _ = child.kill();
        let _ = child.wait();
    }
}

fn arm() -> Arc<Arm> {
    let robot = pieper_robots::find("abb-paper").unwrap().robot();
    Arc::new(Arm::of(&robot).unwrap())
}

fn connect(line: &Line) -> Session {
    let options = Options {
        share: 0.5,
        ..Options::default()
    };
    let session = Session::connect(&line.address, Kind::Packets, arm(), &options).unwrap();
    session.wait_connected(Duration::from_secs(10)).unwrap();
    session
}

fn drive(session: &Session, is_so: impl Fn(&Status) -> bool) -> Status {
    let end = Instant::now() + Duration::from_secs(20);
    loop {
        session.beat();
        let status = session.status();
        if is_so(&status) {
            return status;
        }
        assert!(Instant::now() < end, "it did not come to that: {status:?}");
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// The whole of a session: who it is, arming, moving there, silence.
fn session_with(line: &Line) -> [f64; 6] {
    let session = connect(line);
    let identity = session.status().identity.unwrap();
    assert!(identity.starts_with("six servos, 6 motors"), "{identity}");
    session.arm().unwrap();
    let mut q = session.status().measured.unwrap();
    for (k, q) in q.iter_mut().enumerate() {
        *q += 0.1 * (k as f64 - 2.0);
    }
    session.set_target(&q).unwrap();
    drive(&session, |status| {
        status.phase == Phase::Holding
            && status
                .measured
                .as_ref()
                .is_some_and(|at| at.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-4))
    });
    let mut motors = [0.0; 6];
    arm().transmission.motors(&q, &mut motors).unwrap().unwrap();
    // Nobody is there any more: the session stops, and tells the controller.
    let status = session.wait(Duration::from_secs(5), |status| !status.phase.is_live());
    assert!(status.sentence.unwrap().contains("has been silent"));
    // It can be armed again: no session before it is in its way.
    session.arm().unwrap();
    drive(&session, |status| status.sent > 40);
    motors
}

#[test]
fn a_session_with_it_on_this_computer() {
    let Some(program) = for_host() else {
        return;
    };
    let line = Line::start(Command::new(&program));
    session_with(&line);
    drop(line);
    let _ = std::fs::remove_file(program);
}

/// Any bytes, with good packets between them: it answers the good ones, and nothing else happens. With the sanitizers, where the
/// compiler has them.
#[test]
fn any_bytes_are_survived() {
    let program = folder("firmware-sanitized").join(format!("servos-{}", std::process::id()));
    let path = program.display().to_string();
    let Some(()) = compile(
        "cc",
        &[
            "-std=c99",
            "-O1",
            "-g",
            "-fsanitize=address,undefined",
            "-fno-sanitize-recover",
            "-o",
            &path,
            "host.c",
            "pieper_packets.c",
        ],
    ) else {
        return;
    };
    let mut child = Command::new(&program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    let mut output = child.stdout.take().unwrap();
    let reader = std::thread::spawn(move || {
        let mut bytes = Vec::new();
        output.read_to_end(&mut bytes).unwrap();
        bytes
    });
    let mut random = 99_u64;
    let mut next = move || {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        random
    };
    let mut bytes = Vec::new();
    for round in 0..2000_u32 {
        bytes.clear();
        let length = next() % 200;
        bytes.extend((0..length).map(|_| next() as u8));
        bytes.push(0);
        // A packet of ours, damaged in one place, and one that is not.
        let at = bytes.len();
        ToDevice::Arm { session: 1 }.encode(round as u16, &mut bytes);
        bytes[at + 3] ^= 1 << (next() % 8);
        if round % 20 == 0 {
            ToDevice::Hello.encode(round as u16, &mut bytes);
        }
        input.write_all(&bytes).unwrap();
    }
    std::thread::sleep(Duration::from_millis(200));
    drop(input);
    let status = child.wait().unwrap();
    let mut said = String::new();
    child
        .stderr
        .take()
        .unwrap()
        .read_to_string(&mut said)
        .unwrap();
    assert!(status.success(), "{said}");
    let (mut capabilities, mut states) = (0, 0);
    Deframer::default().push(&reader.join().unwrap(), |packet| {
        match ToHost::decode(packet.expect("what it sends is whole"))
            .unwrap()
            .1
        {
            ToHost::Capabilities(of) => {
                capabilities += 1;
                assert_eq!((of.ranges.len(), of.name.as_str()), (6, "six servos"));
            }
            ToHost::State(state) => {
                states += 1;
                assert_eq!(state.session, 0, "it was armed by a damaged packet");
            }
            ToHost::Refused { .. } => {}
        }
    });
    assert_eq!(capabilities, 100);
    assert!(states > 3, "{states}");
    let _ = std::fs::remove_file(program);
}

/// On the board's own processor: the servos' pulses are those of the angles that were sent.
#[test]
fn a_session_with_it_on_an_avr() {
    let folder = folder("firmware-avr");
    let elf = folder.join("servos.elf").display().to_string();
    let avr = compile(
        "avr-gcc",
        &[
            "-mmcu=atmega328p",
            "-DF_CPU=16000000UL",
            "-std=c99",
            "-Os",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-o",
            &elf,
            "servos_atmega328p.c",
            "pieper_packets.c",
        ],
    );
    if avr.is_none() || !Path::new("/usr/include/simavr/sim_avr.h").exists() {
        eprintln!("without simavr it is not run there");
        return;
    }
    let simulator = folder.join("simulate_avr").display().to_string();
    compile(
        "cc",
        &[
            "-std=c99",
            "-O2",
            "-o",
            &simulator,
            "simulate_avr.c",
            "-lsimavr",
            "-lelf",
        ],
    )
    .unwrap();
    let mut command = Command::new(&simulator);
    command.arg(&elf);
    let line = Line::start(command);
    let motors = session_with(&line);
    let said = line.said();
    let pulses: Vec<f64> = said
        .lines()
        .map(|line| line.parse().expect(&said))
        .collect();
    assert_eq!(pulses.len(), 6, "{said}");
    for (pulse, motor) in pulses.iter().zip(motors) {
        let wanted = 544.0 + motor / std::f64::consts::PI * (2400.0 - 544.0);
        // The pin is moved by interrupts, which wait for one another: the median of nine pulses.
        assert!((pulse - wanted).abs() < 5.0, "{pulses:?} {motors:?}");
    }
}
