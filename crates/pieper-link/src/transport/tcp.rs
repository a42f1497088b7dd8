//! TCP, for controllers behind a network, and for simulators.

use std::io::{self, Read, Write};
use std::net::{TcpListener, TcpStream, ToSocketAddrs};
use std::time::Duration;

use super::{Transport, ended, is_pause};

/// How long a connection may take, and a write.
const PATIENCE: Duration = Duration::from_secs(3);

/// One end of a TCP connection.
pub struct TcpCable(TcpStream);

pub(super) fn connect(place: &str) -> Result<TcpCable, String> {
    let fail = |error: io::Error| {
        format!(
            "tcp:{place}: no connection ({error}): is the controller, or its simulator, running there?"
        )
    };
    let mut addresses = place.to_socket_addrs().map_err(fail)?;
    let address = addresses
        .next()
        .ok_or_else(|| format!("tcp:{place}: this host has no address"))?;
    let stream = TcpStream::connect_timeout(&address, PATIENCE).map_err(fail)?;
    TcpCable::new(stream).map_err(fail)
}

impl TcpCable {
    fn new(stream: TcpStream) -> io::Result<Self> {
        // Set-points are small and must not wait for more.
        stream.set_nodelay(true)?;
        stream.set_write_timeout(Some(PATIENCE))?;
        Ok(Self(stream))
    }
}

impl Transport for TcpCable {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> io::Result<usize> {
        // A timeout of zero would mean for ever.
        self.0
            .set_read_timeout(Some(wait.max(Duration::from_micros(500))))?;
        match self.0.read(buffer) {
            Ok(0) => Err(ended()),
            Ok(count) => Ok(count),
            Err(error) if is_pause(&error) => Ok(0),
            Err(error) => Err(error),
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.0.write_all(bytes)
    }
}

/// Where a simulated controller waits for one program at a time.
pub struct TcpDoor {
    listener: TcpListener,
}

impl TcpDoor {
    /// Waits on 127.0.0.1; on a port that is free where `port` is 0.
    ///
    /// # Errors
    /// The port is taken.
    pub fn new(port: u16) -> io::Result<Self> {
        let listener = TcpListener::bind(("127.0.0.1", port))?;
        listener.set_nonblocking(true)?;
        Ok(Self { listener })
    }

    /// The port.
    ///
    /// # Errors
    /// The operating system does not tell.
    pub fn port(&self) -> io::Result<u16> {
        Ok(self.listener.local_addr()?.port())
    }

    /// Who has come, if somebody has.
    ///
    /// # Errors
    /// The listener is gone.
    pub fn accept(&self) -> io::Result<Option<TcpCable>> {
        match self.listener.accept() {
            Ok((stream, _)) => {
                stream.set_nonblocking(false)?;
                TcpCable::new(stream).map(Some)
            }
            Err(error) if is_pause(&error) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Sends away whoever has come while another is being served.
    ///
    /// # Errors
    /// The listener is gone.
    pub fn turn_away(&self) -> io::Result<()> {
        while let Some(cable) = self.accept()? {
            drop(cable);
        }
        Ok(())
    }
}
