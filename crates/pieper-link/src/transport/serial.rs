//! Serial lines, and pseudo-terminals that look like one.

use std::io::{self, Write};
use std::time::Duration;

use serialport::SerialPort;

use super::{Transport, ended, is_pause};

/// A serial port that may hold a controller, and what is known of it.
pub fn list() -> Result<Vec<(String, String)>, String> {
    let ports = serialport::available_ports()
        .map_err(|error| format!("the serial ports could not be listed: {error}"))?;
    let describe = |kind: serialport::SerialPortType| match kind {
        serialport::SerialPortType::UsbPort(usb) => {
            let named = [usb.manufacturer, usb.product];
            let named: Vec<_> = named.into_iter().flatten().collect();
            match named.is_empty() {
                true => format!("USB {:04x}:{:04x}", usb.vid, usb.pid),
                false => named.join(" "),
            }
        }
        serialport::SerialPortType::BluetoothPort => "Bluetooth".to_owned(),
        serialport::SerialPortType::PciPort => "built in".to_owned(),
        serialport::SerialPortType::Unknown => String::new(),
    };
    Ok(ports
        .into_iter()
        .map(|port| (port.port_name, describe(port.port_type)))
        .collect())
}

struct Serial(Box<dyn SerialPort>);

pub(super) fn open(path: &str, baud: u32) -> Result<Box<dyn Transport>, String> {
    let port = serialport::new(path, baud)
        .timeout(Duration::from_millis(20))
        .open();
    match port {
        Ok(port) => Ok(Box::new(Serial(port))),
        Err(error) => {
            let hint = match error.kind() {
                serialport::ErrorKind::NoDevice => {
                    "no controller is there; `pieper link list` shows the ports that are"
                }
                serialport::ErrorKind::Io(io::ErrorKind::PermissionDenied) => {
                    "you may not use it: on Linux, join the group dialout and log in again"
                }
                serialport::ErrorKind::Io(io::ErrorKind::NotFound) => {
                    "there is no such port; `pieper link list` shows those that are"
                }
                _ => "is another program using it?",
            };
            Err(format!("{path}: it could not be opened ({error}): {hint}"))
        }
    }
}

fn read(port: &mut dyn SerialPort, buffer: &mut [u8], wait: Duration) -> io::Result<usize> {
    port.set_timeout(wait)?;
    match port.read(buffer) {
        Ok(0) => Err(ended()),
        Ok(count) => Ok(count),
        Err(error) if is_pause(&error) => Ok(0),
        Err(error) => Err(error),
    }
}

impl Transport for Serial {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> io::Result<usize> {
        read(self.0.as_mut(), buffer, wait)
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.0.write_all(bytes)
    }
}

/// The controller's end of a pseudo-terminal; the other end has a path that is opened like a serial port.
pub struct Terminal {
    controller: serialport::TTYPort,
    path: String,
}

impl Terminal {
    /// A new one.
    ///
    /// # Errors
    /// The operating system has none.
    pub fn new() -> io::Result<Self> {
        // The program's end is let go here: whoever opens it by its path has it for itself.
        let (controller, line) = serialport::TTYPort::pair()?;
        let path = line.name();
        let path = path.ok_or_else(|| io::Error::other("the pseudo-terminal has no path"))?;
        Ok(Self { controller, path })
    }

    /// What a program opens.
    pub fn path(&self) -> &str {
        &self.path
    }
}

impl Transport for Terminal {
    // Both ends of a pseudo-terminal have one setting: what the program has set.
    fn rate(&self) -> Option<u32> {
        self.controller.baud_rate().ok()
    }

    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> io::Result<usize> {
        read(&mut self.controller, buffer, wait)
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        // A terminal that nobody reads fills up: a controller's line would not wait either.
        match self.controller.write_all(bytes) {
            Err(error) if is_pause(&error) => Ok(()),
            other => other,
        }
    }
}
