//! Where a controller is.

use std::fmt;
use std::str::FromStr;

/// The address of a controller, as a person writes it.
///
/// ```
/// use pieper_link::transport::Address;
/// assert!(matches!("/dev/ttyACM0".parse(), Ok(Address::Serial { baud: None, .. })));
/// assert!(matches!("COM3@57600".parse(), Ok(Address::Serial { baud: Some(57600), .. })));
/// assert_eq!("udp:6510".parse::<Address>()?.to_string(), "udp:0.0.0.0:6510");
/// assert!("ttyACM0".parse::<Address>().is_err());
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Address {
    /// A serial port; at its protocol's rate, or at this.
    Serial {
        /// Such as `/dev/ttyACM0` or `COM3`.
        path: String,
        /// Bits per second.
        baud: Option<u32>,
    },
    /// A TCP server, `host:port`.
    Tcp(String),
    /// Where to wait for datagrams, `address:port`.
    Udp(String),
}

impl FromStr for Address {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let is_port = |port: &str| port.parse::<u16>().is_ok();
        if let Some(place) = text.strip_prefix("tcp:") {
            let port = place.rsplit_once(':').map(|(_, port)| port);
            return match port.is_some_and(is_port) {
                true => Ok(Self::Tcp(place.to_owned())),
                false => Err(format!("{text}: tcp:HOST:PORT was expected")),
            };
        }
        if let Some(place) = text.strip_prefix("udp:") {
            return match place.rsplit_once(':') {
                None if is_port(place) => Ok(Self::Udp(format!("0.0.0.0:{place}"))),
                Some((_, port)) if is_port(port) => Ok(Self::Udp(place.to_owned())),
                _ => Err(format!("{text}: udp:PORT or udp:ADDRESS:PORT was expected")),
            };
        }
        let (path, baud) = match text.rsplit_once('@') {
            None => (text, None),
            Some((path, baud)) => {
                let rate = baud
                    .parse()
                    .ok()
                    .filter(|rate| (300..=4_000_000).contains(rate));
                let rate = rate.ok_or_else(|| {
                    format!("{text}: after @ a rate from 300 to 4000000 was expected")
                })?;
                (path, Some(rate))
            }
        };
        let is_serial = path.starts_with('/') || path.to_ascii_uppercase().starts_with("COM");
        match is_serial {
            true => Ok(Self::Serial {
                path: path.to_owned(),
                baud,
            }),
            false => Err(format!(
                "{text}: a serial port (/dev/ttyACM0, COM3), tcp:HOST:PORT or udp:PORT was expected; \
                 `pieper link list` shows the ports"
            )),
        }
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Serial { path, baud: None } => f.write_str(path),
            Self::Serial {
                path,
                baud: Some(baud),
            } => write!(f, "{path}@{baud}"),
            Self::Tcp(place) => write!(f, "tcp:{place}"),
            Self::Udp(place) => write!(f, "udp:{place}"),
        }
    }
}
