//! The studio: one arm, what a person does with it, and a server that shows it to a page on this computer.
//!
//! [`Session`] is the state and everything that can be done to it, without sockets, threads or a clock; `server` is the thin layer
//! that speaks HTTP and WebSocket as `WIRE.md` in this crate says. The page, in `page/`, draws and sends gestures; it computes no
//! kinematics.

mod arm;
mod command;
mod drag;
mod frames;
mod history;
mod motion;
mod quantity;
mod script;
mod sections;
mod server;
mod session;

pub use arm::{Arm, Fetch};
pub use command::Command;
pub use server::{Options, Studio};
pub use session::Session;
