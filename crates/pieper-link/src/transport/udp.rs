//! UDP: whoever calls first is answered.

use std::io;
use std::net::{SocketAddr, UdpSocket};
use std::time::{Duration, Instant};

use super::{Transport, is_pause};

/// Waits for the datagrams of one caller, and answers it.
pub struct UdpListener {
    socket: UdpSocket,
    caller: Option<(SocketAddr, Instant)>,
}

/// The silence after which another caller is taken for the controller come back: restarted, it may call from another port.
const GONE: Duration = Duration::from_millis(500);

pub(super) fn listen(place: &str) -> Result<UdpListener, String> {
    let socket = UdpSocket::bind(place).map_err(|error| {
        let hint = match error.kind() {
            io::ErrorKind::AddrInUse => "another program waits there already",
            io::ErrorKind::PermissionDenied => "ports below 1024 are not for everybody",
            _ => "is it an address of this computer?",
        };
        format!("udp:{place}: it could not be opened ({error}): {hint}")
    })?;
    Ok(UdpListener {
        socket,
        caller: None,
    })
}

impl Transport for UdpListener {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> io::Result<usize> {
        self.socket
            .set_read_timeout(Some(wait.max(Duration::from_micros(500))))?;
        match self.socket.recv_from(buffer) {
            Ok((count, from)) => {
                // One controller at a time: a second one's datagrams are not taken, or it could move the arm of the first.
                let now = Instant::now();
                let is_other = |(caller, heard): (SocketAddr, Instant)| {
                    caller != from && now.duration_since(heard) < GONE
                };
                if self.caller.is_some_and(is_other) {
                    return Ok(0);
                }
                self.caller = Some((from, now));
                Ok(count)
            }
            Err(error) if is_pause(&error) || is_refusal(&error) => Ok(0),
            Err(error) => Err(error),
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        match self.caller {
            Some((caller, _)) => sent(self.socket.send_to(bytes, caller)),
            None => Ok(()),
        }
    }
}

/// Calls a listener, as a controller does.
pub struct UdpCaller(UdpSocket);

impl UdpCaller {
    /// Calls this address.
    ///
    /// # Errors
    /// No such address.
    pub fn new(place: &str) -> io::Result<Self> {
        let socket = UdpSocket::bind("0.0.0.0:0")?;
        socket.connect(place)?;
        socket.set_nonblocking(true)?;
        Ok(Self(socket))
    }
}

impl Transport for UdpCaller {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> io::Result<usize> {
        let end = Instant::now() + wait;
        loop {
            match self.0.recv(buffer) {
                Ok(count) => return Ok(count),
                Err(error) if is_pause(&error) || is_refusal(&error) => {}
                Err(error) => return Err(error),
            }
            let left = end.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Ok(0);
            }
            wait_for(&self.0, left)?;
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        sent(self.0.send(bytes))
    }
}

/// Waits for a datagram. A socket's own time-out is rounded to the kernel's ticks, up to 10 ms: too coarse for one who calls every
/// 4 ms.
#[cfg(unix)]
fn wait_for(socket: &UdpSocket, wait: Duration) -> io::Result<()> {
    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    let wait = Timespec {
        tv_sec: wait.as_secs() as _,
        tv_nsec: wait.subsec_nanos() as _,
    };
    match poll(&mut [PollFd::new(socket, PollFlags::IN)], Some(&wait)) {
        Ok(_) | Err(rustix::io::Errno::INTR) => Ok(()),
        Err(error) => Err(error.into()),
    }
}

/// Elsewhere it looks often enough.
#[cfg(not(unix))]
fn wait_for(_: &UdpSocket, wait: Duration) -> io::Result<()> {
    std::thread::sleep(wait.min(Duration::from_micros(400)));
    Ok(())
}

/// Datagrams to where nobody listens: not an error of ours, they may come.
fn is_refusal(error: &io::Error) -> bool {
    error.kind() == io::ErrorKind::ConnectionRefused
}

fn sent(result: io::Result<usize>) -> io::Result<()> {
    match result {
        Err(error) if is_refusal(&error) || is_pause(&error) => Ok(()),
        other => other.map(|_| ()),
    }
}
