//! Reads EGM messages and writes them again: lines of a message's name and its bytes in hexadecimal, in and out.
//!
//!     echo "EgmSensor 0a020805" | cargo run -p pieper-link --example egm_messages
//!
//! `tests/egm_peer.py` compares what comes out with Google's protobuf.

use std::io::{self, BufRead as _, Write as _};

use pieper_link::protocol::egm::{Robot, Sensor};

fn main() -> io::Result<()> {
    let mut out = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let line = line?;
        let again = line
            .split_once(' ')
            .and_then(|(name, text)| Some((name, bytes(text)?)))
            .and_then(|(name, bytes)| again(name, &bytes));
        match again {
            Some(bytes) => {
                let text: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
                writeln!(out, "{text}")?;
            }
            None => writeln!(out, "none")?,
        }
    }
    Ok(())
}

/// The message as it is written after it was read.
fn again(name: &str, bytes: &[u8]) -> Option<Vec<u8>> {
    let mut out = Vec::new();
    match name {
        "EgmRobot" => Robot::read(bytes)?.write(&mut out),
        "EgmSensor" => Sensor::read(bytes)?.write(&mut out),
        _ => return None,
    }
    Some(out)
}

fn bytes(text: &str) -> Option<Vec<u8>> {
    let pair = |k: usize| u8::from_str_radix(text.get(k..k + 2)?, 16).ok();
    (0..text.trim().len()).step_by(2).map(pair).collect()
}
