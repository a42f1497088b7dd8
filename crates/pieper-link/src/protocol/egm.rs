//! ABB Externally Guided Motion: one protobuf message (proto2, package `abb.egm`) a datagram, 250 times a second, and the
//! controller begins.
//!
//! The messages are written and read by [`wire`], a reader of protobuf's fields that allocates nothing: the generated code of the
//! usual libraries puts every repeated field on the heap, in every cycle. It is checked against Google's own implementation,
//! byte for byte.

mod host;
mod message;
pub mod wire;

pub use host::EgmHost;
pub use message::{
    Clock, Header, Joints, MessageKind, Motors, Planned, Pose, Rapid, Robot, Running, Sensor,
};

/// The most joints in one list.
pub const JOINTS: usize = 12;
