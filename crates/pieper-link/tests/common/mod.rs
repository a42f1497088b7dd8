//! A simulated controller and a session with it.

#![allow(dead_code, reason = "each test file uses a part")]

use std::sync::Arc;
use std::sync::atomic::{AtomicU16, Ordering};
use std::time::{Duration, Instant};

use pieper_link::simulator::{Place, Served};
use pieper_link::{Arm, Kind, Options, Session, Status};

/// How long something may take that should not take long, on a busy machine.
pub(crate) const PATIENCE: Duration = Duration::from_secs(20);

pub(crate) struct Rig {
    pub(crate) kind: Kind,
    pub(crate) arm: Arc<Arm>,
    pub(crate) served: Served,
    pub(crate) session: Session,
}

/// The arm that a kind is tried with.
pub(crate) fn arm_of(kind: Kind) -> Arc<Arm> {
    let robot = pieper_robots::find(kind.robot()).unwrap().robot();
    Arc::new(Arm::of(&robot).unwrap())
}

/// Ports for the tests that wait for datagrams, each its own.
static PORT: AtomicU16 = AtomicU16::new(0);

fn port() -> u16 {
    let index = PORT.fetch_add(1, Ordering::SeqCst);
    // Tests of one file run in one process, or each in its own.
    20_000 + (std::process::id() as u16 % 2000) * 16 + index
}

impl Rig {
    pub(crate) fn new(kind: Kind) -> Self {
        Self::with(kind, |_| {})
    }

    pub(crate) fn with(kind: Kind, change: impl FnOnce(&mut Options)) -> Self {
        let arm = arm_of(kind);
        let mut options = Options {
            share: 1.0,
            ..Options::default()
        };
        change(&mut options);
        let (served, session) = match kind {
            Kind::Egm => {
                let place = format!("127.0.0.1:{}", port());
                let address = format!("udp:{place}").parse().unwrap();
                let session = Session::connect(&address, kind, Arc::clone(&arm), &options);
                let served = Served::start(kind, &arm, &Place::Calls(place)).unwrap();
                (served, session)
            }
            _ => {
                // Half of them over a terminal, half over a socket.
                let place = match kind {
                    Kind::Ar4 | Kind::Ros | Kind::Servo => Place::Terminal,
                    _ => Place::Tcp(0),
                };
                let served = Served::start(kind, &arm, &place).unwrap();
                let session = Session::connect(served.address(), kind, Arc::clone(&arm), &options);
                (served, session)
            }
        };
        let session = session.unwrap();
        session.wait_connected(PATIENCE).unwrap();
        Self {
            kind,
            arm,
            served,
            session,
        }
    }

    pub(crate) fn measured(&self) -> Vec<f64> {
        self.session.status().measured.unwrap()
    }

    /// This far from a place, every joint towards the inside of its range.
    pub(crate) fn towards(&self, from: &[f64], by: f64) -> Vec<f64> {
        let ways = from.iter().zip(self.signs());
        ways.map(|(q, sign)| q + by * sign).collect()
    }

    /// Towards the inside of every joint's range.
    fn signs(&self) -> Vec<f64> {
        let variables = self.arm.chain.variables().iter();
        let here = self.measured();
        variables
            .zip(here)
            .map(|(variable, q)| match variable.limits {
                Some(limits) if q > f64::midpoint(limits.lower(), limits.upper()) => -1.0,
                _ => 1.0,
            })
            .collect()
    }

    /// Beats until something shows. Panics with what showed instead.
    pub(crate) fn drive(
        &self,
        patience: Duration,
        mut is_so: impl FnMut(&Status) -> bool,
    ) -> Status {
        let end = Instant::now() + patience;
        loop {
            self.session.beat();
            let status = self.session.status();
            if is_so(&status) {
                return status;
            }
            assert!(
                Instant::now() < end,
                "{}: it did not come to that: {status:?}",
                self.kind
            );
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    /// Where the simulated motors have the joints.
    pub(crate) fn joints_of_motors(&self) -> Vec<f64> {
        let mut q = vec![0.0; self.arm.dof()];
        let motors = self.served.motors();
        let answer = self.arm.transmission.joints(&motors, &mut q);
        answer.unwrap().expect("the motors are within reach");
        q
    }
}
