//! State packets: a compact binary protocol for small controllers, `docs/link.md` byte by byte.
//!
//! A frame is a packet with its checksum, byte-stuffed so that zero only ends it: whoever joins late, or loses bytes, is
//! in step again after the next zero.

mod frame;
mod host;
mod message;

pub use frame::{Damage, Deframer, frame};
pub use host::PacketHost;
pub use message::{
    AXES, Axes, Capabilities, Code, Malformed, Mode, Packet, State, ToDevice, ToHost, VERSION,
};
