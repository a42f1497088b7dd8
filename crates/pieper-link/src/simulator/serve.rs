//! A simulated controller on a real socket or pseudo-terminal, in true time.

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use super::fault::{Fault, Weather};
use super::{Device, device};
use crate::arm::Arm;
use crate::protocol::Kind;
use crate::transport::{Address, TcpDoor, Terminal, Transport, UdpCaller};

/// Where a simulated controller is served.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// A pseudo-terminal, as a serial port.
    Terminal,
    /// A TCP port on this computer; any that is free for 0.
    Tcp(u16),
    /// It calls a program that waits for datagrams there, `host:port`: EGM.
    Calls(String),
}

/// A simulated controller that runs. Dropped, it is switched off.
pub struct Served {
    address: Address,
    /// Each with a line on which to say that it has come.
    faults: Sender<(Fault, Sender<()>)>,
    motors: Arc<Mutex<Vec<f64>>>,
    off: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Served {
    /// Switches one on.
    ///
    /// # Errors
    /// A sentence: the protocol cannot carry the arm, the port is taken, the place does not suit the protocol.
    pub fn start(kind: Kind, arm: &Arm, place: &Place) -> Result<Self, String> {
        let device = device(kind, arm)?;
        let fail = |error: io::Error| format!("the simulated controller has no line: {error}");
        if (kind == Kind::Egm) != matches!(place, Place::Calls(_)) {
            return Err(match kind {
                Kind::Egm => {
                    "a controller with EGM calls a UDP port: say which, as in --call 127.0.0.1:6510"
                        .to_owned()
                }
                _ => format!(
                    "a controller that speaks {kind} has a serial line or a TCP port, it calls nobody"
                ),
            });
        }
        let (line, address) = match place {
            Place::Terminal => {
                let terminal = Terminal::new().map_err(fail)?;
                let path = terminal.path().to_owned();
                (
                    Line::Always(Box::new(terminal)),
                    Address::Serial { path, baud: None },
                )
            }
            Place::Tcp(port) => {
                let door = TcpDoor::new(*port).map_err(fail)?;
                let port = door.port().map_err(fail)?;
                (
                    Line::Door(door, None),
                    Address::Tcp(format!("127.0.0.1:{port}")),
                )
            }
            Place::Calls(place) => {
                let caller = UdpCaller::new(place).map_err(fail)?;
                (Line::Always(Box::new(caller)), Address::Udp(place.clone()))
            }
        };
        let (faults, heard) = channel();
        let motors = Arc::new(Mutex::new(device.motors()));
        let off = Arc::new(AtomicBool::new(false));
        let server = Server {
            kind,
            device,
            line,
            weather: Weather::default(),
            faults: heard,
            motors: Arc::clone(&motors),
            off: Arc::clone(&off),
        };
        let thread = std::thread::Builder::new()
            .name("pieper-simulator".to_owned())
            .spawn(move || server.run())
            .map_err(fail)?;
        Ok(Self {
            address,
            faults,
            motors,
            off,
            thread: Some(thread),
        })
    }

    /// What a program connects to. For a controller that calls: where the program has to wait.
    pub fn address(&self) -> &Address {
        &self.address
    }

    /// Lets something go wrong. It has when this returns: what is sent to the controller afterwards meets it.
    pub fn inject(&self, fault: Fault) {
        let (come, has_come) = channel();
        // One that is switched off has no weather: both lines are cut then.
        if self.faults.send((fault, come)).is_ok() {
            let _ = has_come.recv();
        }
    }

    /// Where the motors really are, radians and metres.
    pub fn motors(&self) -> Vec<f64> {
        let motors = self.motors.lock().unwrap_or_else(PoisonError::into_inner);
        motors.clone()
    }

    /// Whether it still runs: a pulled cable ends it.
    pub fn is_running(&self) -> bool {
        self.thread
            .as_ref()
            .is_some_and(|thread| !thread.is_finished())
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        self.off.store(true, Ordering::SeqCst);
        if let Some(thread) = self.thread.take() {
            // A simulator that panicked is switched off already.
            let _ = thread.join();
        }
    }
}

enum Line {
    Always(Box<dyn Transport>),
    Door(TcpDoor, Option<Box<dyn Transport>>),
}

struct Server {
    kind: Kind,
    device: Box<dyn Device>,
    line: Line,
    weather: Weather,
    faults: Receiver<(Fault, Sender<()>)>,
    motors: Arc<Mutex<Vec<f64>>>,
    off: Arc<AtomicBool>,
}

impl Server {
    fn run(mut self) {
        let start = Instant::now();
        let mut buffer = [0; 2048];
        let (mut out, mut passed) = (Vec::new(), Vec::new());
        let mut due = Duration::ZERO;
        while !self.off.load(Ordering::SeqCst) {
            let now = start.elapsed();
            while let Ok((fault, come)) = self.faults.try_recv() {
                if fault == Fault::Unplug {
                    return;
                }
                match fault.is_of_wire() {
                    true => self.weather.inject(fault),
                    false => self.device.inject(now, fault),
                }
                // Whoever did it need not have waited.
                let _ = come.send(());
            }
            let wait = due.saturating_sub(start.elapsed());
            match self.line.read(&mut buffer, wait) {
                Ok(0) => {}
                Ok(count) => {
                    if self.is_out_of_step() {
                        garble(&mut buffer[..count]);
                    }
                    self.device
                        .receive(start.elapsed(), &buffer[..count], &mut out);
                }
                // Whoever was there has gone; the next may come.
                Err(_) => self.line.let_go(),
            }
            let now = start.elapsed();
            if now >= due {
                self.device.tick(now, &mut out);
                due = (due + self.device.period()).max(now);
                let motors = self.device.motors();
                *self.motors.lock().unwrap_or_else(PoisonError::into_inner) = motors;
            }
            self.weather.pass(&out, &mut passed);
            out.clear();
            if self.is_out_of_step() {
                garble(&mut passed);
            }
            if !passed.is_empty() && self.line.write(&passed).is_err() {
                self.line.let_go();
            }
            passed.clear();
        }
    }
}

impl Server {
    /// Whether the program has set its line to another rate than this controller's. USB has none: an AR4 does not care.
    fn is_out_of_step(&self) -> bool {
        let rate = match &self.line {
            Line::Always(cable) => cable.rate(),
            Line::Door(..) => None,
        };
        self.kind != Kind::Ar4 && rate.is_some_and(|rate| rate != self.kind.baud())
    }
}

/// What bytes look like at the wrong rate: bits are sampled in the wrong places.
fn garble(bytes: &mut [u8]) {
    for (index, byte) in bytes.iter_mut().enumerate() {
        *byte = byte.rotate_left(3) ^ (0x9C_u8.rotate_left(index as u32 % 8));
    }
}

impl Line {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> io::Result<usize> {
        match self {
            Self::Always(cable) => match cable.read(buffer, wait) {
                // Nobody has the other end of the terminal open just now.
                Err(_) => {
                    std::thread::sleep(wait.min(Duration::from_millis(5)));
                    Ok(0)
                }
                read => read,
            },
            Self::Door(door, here) => match here {
                Some(cable) => {
                    door.turn_away()?;
                    cable.read(buffer, wait)
                }
                None => {
                    match door.accept()? {
                        Some(cable) => *here = Some(Box::new(cable)),
                        None => std::thread::sleep(wait),
                    }
                    Ok(0)
                }
            },
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        match self {
            Self::Always(cable) => cable.write(bytes),
            Self::Door(_, Some(cable)) => cable.write(bytes),
            Self::Door(_, None) => Ok(()),
        }
    }

    fn let_go(&mut self) {
        if let Self::Door(_, here) = self {
            *here = None;
        }
    }
}
