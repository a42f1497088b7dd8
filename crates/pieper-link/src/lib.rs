//! A real arm follows: controllers' protocols, simulators of the controllers, and the safety between.
//!
//! - [`protocol`]: what controllers speak, as state machines. Bytes in, events out; usable without the rest.
//! - [`safety`]: what may be sent to an arm. One place decides it.
//! - [`simulator`]: controllers that are not there, on real sockets and pseudo-terminals, with faults on demand.
//! - [`transport`]: the cables.
//! - [`matching`]: servos and joints, at their extreme positions.
//! - [`Session`]: a thread that drives one arm, and records what it did, by default in the folder of [`records`].
//!
//! ```
//! use std::sync::Arc;
//! use std::time::Duration;
//! use pieper::describe::Robot;
//! use pieper_link::{Arm, Kind, Options, Session, simulator::{Place, Served}};
//!
//! let robot = Robot::from_toml("two.toml", r#"
//! name = "two links"
//! convention = "standard"
//! [[joint]]
//! theta = "q1"
//! a = 0.3
//! limits = [-1, 1]
//! [[joint]]
//! theta = "q2"
//! a = 0.2
//! "#)?;
//! let arm = Arc::new(Arm::of(&robot)?);
//! // A controller that is not there, and a session with it.
//! let controller = Served::start(Kind::Packets, &arm, &Place::Tcp(0))?;
//! let session = Session::connect(controller.address(), Kind::Packets, arm, &Options::default())?;
//! session.wait_connected(Duration::from_secs(3))?;
//! // A connection shows only: nothing moves before the arm is armed.
//! assert!(session.set_target(&[0.1, 0.0]).is_err());
//! session.arm()?;
//! assert!(session.set_target(&[2.0, 0.0]).is_err(), "outside its limits");
//! session.set_target(&[0.05, 0.0])?;
//! let status = session.wait(Duration::from_secs(3), |status| {
//!     session.beat();
//!     status.measured.as_ref().is_some_and(|q| (q[0] - 0.05).abs() < 1e-3)
//! });
//! assert!((status.measured.unwrap()[0] - 0.05).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arm;
pub mod matching;
pub mod protocol;
pub mod records;
pub mod safety;
mod session;
pub mod simulator;
pub mod transport;

pub use arm::{Arm, MotorOf};
pub use protocol::Kind;
pub use safety::Phase;
pub use session::{Entry, Options, Record, RecordError, Sample, Session, Status};
