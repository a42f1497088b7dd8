//! Framing: consistent overhead byte stuffing, and a checksum.

use std::fmt;

/// CRC-16/IBM-3740 (also called CCITT-FALSE): polynomial 0x1021, from 0xFFFF, not reflected.
const CRC: crc::Crc<u16> = crc::Crc::<u16>::new(&crc::CRC_16_IBM_3740);

/// The longest packet, without its checksum.
pub(super) const PACKET: usize = 160;

/// A packet with its checksum, and one byte of stuffing for each 254.
const FRAME: usize = PACKET + 2 + 2;

/// Appends a packet as a frame, its ending zero included. A packet longer than 160 bytes is not sent: none is made.
pub fn frame(packet: &[u8], out: &mut Vec<u8>) {
    let mut plain = [0; PACKET + 2];
    let mut stuffed = [0; FRAME];
    let length = packet.len();
    let Some(place) = plain.get_mut(..length + 2) else {
        return;
    };
    place[..length].copy_from_slice(packet);
    place[length..].copy_from_slice(&CRC.checksum(packet).to_le_bytes());
    if let Ok(count) = cobs::try_encode(place, &mut stuffed) {
        out.extend_from_slice(&stuffed[..count]);
        out.push(0);
    }
}

/// Why the bytes up to a zero were no packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Damage {
    /// More than the longest frame without a zero.
    Overlong,
    /// Stuffing that cannot be undone, or too short for a checksum.
    Stuffing,
    /// The checksum does not fit.
    Checksum,
}

impl fmt::Display for Damage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Overlong => "a frame longer than any packet",
            Self::Stuffing => "a frame cut short",
            Self::Checksum => "a frame whose checksum does not fit",
        })
    }
}

/// Takes a stream of bytes apart into packets.
#[derive(Debug)]
pub struct Deframer {
    stuffed: [u8; FRAME],
    length: usize,
    plain: [u8; FRAME],
}

impl Default for Deframer {
    fn default() -> Self {
        Self {
            stuffed: [0; FRAME],
            length: 0,
            plain: [0; FRAME],
        }
    }
}

impl Deframer {
    /// Takes bytes; every packet that passed its check goes to `take`, or what was wrong with the bytes up to a zero.
    ///
    /// ```
    /// use pieper_link::protocol::packets::{Deframer, frame};
    /// let mut bytes = Vec::new();
    /// frame(b"\x01\x00\x02", &mut bytes);
    /// assert!(!bytes[..bytes.len() - 1].contains(&0));
    /// let mut seen = Vec::new();
    /// Deframer::default().push(&bytes, |packet| seen.extend_from_slice(packet.unwrap_or_default()));
    /// assert_eq!(seen, b"\x01\x00\x02");
    /// ```
    pub fn push(&mut self, bytes: &[u8], mut take: impl FnMut(Result<&[u8], Damage>)) {
        for &byte in bytes {
            if byte != 0 {
                // One place past the end marks what is too long.
                if let Some(place) = self.stuffed.get_mut(self.length) {
                    *place = byte;
                }
                self.length = (self.length + 1).min(FRAME + 1);
                continue;
            }
            let length = std::mem::take(&mut self.length);
            // Zeros between frames are allowed: a sender may begin with one.
            if length > 0 {
                take(self.packet(length));
            }
        }
    }

    fn packet(&mut self, length: usize) -> Result<&[u8], Damage> {
        let stuffed = self.stuffed.get(..length).ok_or(Damage::Overlong)?;
        let report = cobs::decode(stuffed, &mut self.plain).map_err(|_| Damage::Stuffing)?;
        let plain = self
            .plain
            .get(..report.frame_size())
            .ok_or(Damage::Stuffing)?;
        let (packet, sum) = plain.split_last_chunk::<2>().ok_or(Damage::Stuffing)?;
        match CRC.checksum(packet) == u16::from_le_bytes(*sum) {
            true => Ok(packet),
            false => Err(Damage::Checksum),
        }
    }
}
