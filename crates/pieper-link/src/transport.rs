//! Cables: serial lines, TCP, UDP, and pseudo-terminals. The only part of the crate that touches the outside world.

mod address;
mod serial;
mod tcp;
mod udp;

pub use address::Address;
pub use serial::{Terminal, list};
pub use tcp::{TcpCable, TcpDoor};
pub use udp::{UdpCaller, UdpListener};

use std::io;
use std::time::Duration;

use crate::protocol::Kind;

/// A cable that carries bytes both ways; of a datagram protocol, one datagram at a time.
pub trait Transport: Send {
    /// Bytes that came, waiting for them no longer than `wait`. Zero if none did.
    ///
    /// # Errors
    /// The cable is gone.
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> io::Result<usize>;

    /// Sends bytes.
    ///
    /// # Errors
    /// The cable is gone.
    fn write(&mut self, bytes: &[u8]) -> io::Result<()>;

    /// The rate that a serial line is set to at this end, bits per second, where it has one.
    fn rate(&self) -> Option<u32> {
        None
    }
}

/// Opens a cable to a controller.
///
/// # Errors
/// A sentence: no such port, in use by another program, refused; with the remedy.
pub fn open(address: &Address, kind: Kind) -> Result<Box<dyn Transport>, String> {
    if matches!(address, Address::Udp(_)) != (kind == Kind::Egm) {
        return Err(match kind {
            Kind::Egm => format!(
                "{address}: EGM comes over UDP, and the controller calls: give udp:6510, or the port that its \
                 UdpUc device is configured for"
            ),
            _ => format!(
                "{address}: {kind} goes over a serial line or TCP: give a port such as /dev/ttyACM0, or tcp:HOST:PORT"
            ),
        });
    }
    match address {
        Address::Serial { path, baud } => {
            let baud = baud.unwrap_or(kind.baud());
            serial::open(path, baud)
        }
        Address::Tcp(place) => tcp::connect(place).map(|cable| Box::new(cable) as Box<_>),
        Address::Udp(place) => udp::listen(place).map(|cable| Box::new(cable) as Box<_>),
    }
}

/// What a cable's end means: `Ok(0)` from a stream is its end.
fn ended() -> io::Error {
    io::Error::new(io::ErrorKind::UnexpectedEof, "the other end has closed")
}

/// Whether an error only says that nothing came in time.
fn is_pause(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut | io::ErrorKind::Interrupted
    )
}
