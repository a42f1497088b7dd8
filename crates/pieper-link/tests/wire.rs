//! Bytes, both ways: round trips, what is damaged, and independent implementations.

// Tests may unwrap, and so may their helper functions.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::time::Duration;

use pieper_link::protocol::packets::{
    AXES, Axes, Capabilities, Code, Damage, Deframer, Mode, Packet, State, ToDevice, ToHost, frame,
};
use pieper_link::protocol::{Event, Setup, ar3, ar4, egm, ros};
use pieper_link::simulator::device;
use pieper_link::{Arm, Kind};

/// Numbers that are the same in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }

    fn angle(&mut self) -> f64 {
        (self.next() % 12_000_000) as f64 * 1e-6 - 6.0
    }

    fn axes(&mut self) -> Axes {
        let count = self.below(AXES + 1);
        Axes::of(&(0..count).map(|_| self.angle()).collect::<Vec<_>>()).unwrap()
    }

    fn program_says(&mut self) -> ToDevice {
        let (session, time) = (self.next() as u32, self.next() as u32);
        match self.below(6) {
            0 => ToDevice::Hello,
            1 => ToDevice::Arm { session },
            2 => ToDevice::Heartbeat { session, time },
            3 => ToDevice::Stop,
            4 => ToDevice::Disarm,
            _ => ToDevice::SetPoint {
                session,
                time,
                axes: self.axes(),
            },
        }
    }

    fn controller_says(&mut self) -> ToHost {
        match self.below(3) {
            0 => ToHost::Refused {
                sequence: self.next() as u16,
                code: Code::TooFast,
                axis: self.next() as u8,
            },
            1 => ToHost::Capabilities(Capabilities {
                versions: [1, 3],
                period: 20,
                timeout: 250,
                measures: self.below(2) == 1,
                ranges: (0..self.below(AXES + 1))
                    .map(|k| [-(k as i32), k as i32])
                    .collect(),
                name: "x".repeat(self.below(25)),
            }),
            _ => ToHost::State(State {
                clock: self.next() as u32,
                session: self.next() as u32,
                taken: self.next() as u32,
                mode: Mode::Armed,
                code: Code::HeartbeatLost,
                axes: self.axes(),
            }),
        }
    }
}

fn packets_of(bytes: &[u8]) -> Vec<Result<Vec<u8>, Damage>> {
    let mut found = Vec::new();
    Deframer::default().push(bytes, |packet| found.push(packet.map(<[u8]>::to_vec)));
    found
}

#[test]
fn every_packet_comes_back_as_it_was() {
    let mut random = Random(7);
    for sequence in 0..20_000_u32 {
        let sequence = sequence as u16;
        let mut bytes = Vec::new();
        let (to_device, to_host) = (random.program_says(), random.controller_says());
        to_device.encode(sequence, &mut bytes);
        to_host.encode(sequence, &mut bytes);
        let found = packets_of(&bytes);
        assert_eq!(found.len(), 2);
        let read = ToDevice::decode(found[0].as_ref().unwrap());
        assert_eq!(read, Ok((sequence, to_device)));
        let read = ToHost::decode(found[1].as_ref().unwrap());
        assert_eq!(read, Ok((sequence, to_host)));
    }
}

/// One flipped bit, wherever it is: the packet is dropped, and the next one is read.
#[test]
fn one_flipped_bit_never_passes() {
    let mut random = Random(11);
    let mut bytes = Vec::new();
    for _ in 0..200 {
        bytes.clear();
        let message = random.program_says();
        message.encode(1, &mut bytes);
        let length = bytes.len();
        ToDevice::Hello.encode(2, &mut bytes);
        for bit in 0..8 * (length - 1) {
            let mut damaged = bytes.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            let found = packets_of(&damaged);
            // A flip may make a zero, which ends the frame early, and two bad ones of it.
            let (last, before) = found.split_last().unwrap();
            assert!(before.iter().all(Result::is_err), "{message:?}, bit {bit}");
            let read = ToDevice::decode(last.as_ref().unwrap());
            assert_eq!(read, Ok((2, ToDevice::Hello)));
        }
    }
}

/// Whatever comes before: after the next zero it is in step again.
#[test]
fn it_is_in_step_after_the_next_zero() {
    let mut random = Random(13);
    for _ in 0..2000 {
        let noise: Vec<u8> = (0..random.below(400))
            .map(|_| random.next() as u8)
            .collect();
        let mut bytes = noise;
        bytes.push(0);
        ToDevice::Stop.encode(9, &mut bytes);
        let found = packets_of(&bytes);
        let last = found.last().unwrap().as_ref().unwrap();
        assert_eq!(ToDevice::decode(last), Ok((9, ToDevice::Stop)));
    }
    // Longer than any packet, without a zero.
    assert_eq!(
        packets_of(&[&[1; 500][..], &[0]].concat()),
        [Err(Damage::Overlong)]
    );
    let mut bytes = Vec::new();
    frame(&[7; 161], &mut bytes);
    assert!(bytes.is_empty(), "what is too long is not sent");
}

/// The checksum is the one it says: of "123456789" it is 0x29B1.
#[test]
fn the_checksum_is_the_known_one() {
    let mut bytes = Vec::new();
    frame(b"123456789", &mut bytes);
    assert_eq!(bytes, b"\x0c123456789\xb1\x29\x00");
}

/// Any bytes, to every host and every device: nothing panics, nothing moves, nothing is armed.
#[test]
fn any_bytes_are_survived() {
    let mut random = Random(17);
    for kind in Kind::ALL {
        let robot = pieper_robots::find(kind.robot()).unwrap().robot();
        let arm = Arm::of(&robot).unwrap();
        let mut host = kind
            .host(Setup {
                motors: arm.motors(),
                poses_of: None,
                nonce: 3,
            })
            .unwrap();
        let mut controller = device(kind, &arm).unwrap();
        let before = controller.motors();
        let (mut out, mut events) = (Vec::new(), Vec::new());
        for tick in 0..3000_u32 {
            let now = Duration::from_millis(7) * tick;
            let length = random.below(120);
            let alphabet = b"ABCDEFGHIJKLMNOPQRST0123456789.-\r\n \x00\x08\x0a\x12";
            let bytes: Vec<u8> = (0..length)
                .map(|_| match random.below(4) {
                    0 => random.next() as u8,
                    _ => alphabet[random.below(alphabet.len())],
                })
                .collect();
            host.poll(now, &mut out, &mut events);
            host.receive(now, &bytes, &mut events);
            controller.receive(now, &bytes, &mut out);
            controller.tick(now, &mut out);
            assert!(!events.contains(&Event::Armed));
            events.clear();
            out.clear();
        }
        assert_eq!(before, controller.motors(), "{kind}");
    }
}

#[test]
fn replies_of_the_text_protocols_come_back_as_they_were() {
    let mut random = Random(19);
    for _ in 0..5000 {
        let mut position = ar4::Position::default();
        for value in position.joints.iter_mut().chain(&mut position.tool) {
            *value = (random.angle() * 100.0).round() / 100.0;
        }
        position.was_slower = random.below(2) == 1;
        match random.below(3) {
            0 => position.is_stopped = true,
            1 => position.collided[random.below(6)] = true,
            _ => {}
        }
        let reply = ar4::Reply::Position(position);
        assert_eq!(ar4::Reply::read(&reply.write()), Some(reply));
        let mut counts = [0; 6];
        counts.fill_with(|| random.below(40_000) as i32 - 20_000);
        let mut by = counts;
        by.rotate_left(2);
        let ask = ar3::Ask::Move {
            by,
            speed: 1 + random.below(100) as u8,
            to: counts,
        };
        assert_eq!(ar3::Ask::read(&ask.write()), Some(ask));
        let reply = ar3::Reply::Differs([true, false, false, true, false, true], counts);
        assert_eq!(ar3::Reply::read(&reply.write()), Some(reply));
        let degrees = [0.5, -1.25, 3.0, 90.0, -90.0, f64::from(counts[0])];
        let line = ros::write("MT", &degrees);
        assert_eq!(ros::read(line.strip_prefix("MT").unwrap()), Some(degrees));
    }
    for error in ["EL010000", "ER", "EA3", "EB", "ES", "EG", "EC000001"] {
        let reply = ar4::Reply::read(error).unwrap();
        assert_eq!(ar4::Reply::read(&reply.write()), Some(reply), "{error}");
    }
    // As the firmware writes it, with what a parser must not stumble over.
    let line = "A0.000B-1.500C2.000D0.000E90.000F0.000G286.830H0.000I438.520J0.000K180.000L0.000M1Nspeed O 5OEC010000P0.00Q1.25R0.00";
    let Some(ar4::Reply::Position(at)) = ar4::Reply::read(&line.replace("speed O 5", "")) else {
        panic!("it was not read");
    };
    assert!(at.was_slower && at.collided[1] && at.joints[7] == 1.25);
    for damaged in [
        "",
        "A",
        "E",
        "EX",
        "EL2",
        "A0.000B0.000",
        &line[1..],
        &line.replace('C', "X"),
        &line.replace("2.000", "NaN"),
    ] {
        assert_eq!(ar4::Reply::read(damaged), None, "{damaged}");
    }
}

/// The vector of the specification, 67 bytes.
const VECTOR: &str = "0a0708011 0e8071803 12380a36 090000000000000000 0900000000000024c0 090000000000003440 \
                      090000000000000000 090000000000003e40 090000000000c04640";

fn vector() -> Vec<u8> {
    let digits: Vec<u8> = VECTOR.bytes().filter(u8::is_ascii_hexdigit).collect();
    let byte = |pair: &[u8]| u8::from_str_radix(std::str::from_utf8(pair).unwrap(), 16).unwrap();
    digits.chunks(2).map(byte).collect()
}

fn sensor() -> egm::Sensor {
    egm::Sensor {
        header: egm::Header {
            sequence: 1,
            time: 1000,
            kind: egm::MessageKind::Correction,
        },
        planned: Some(egm::Planned {
            joints: Some(egm::Joints::of([0.0, -10.0, 20.0, 0.0, 30.0, 45.5])),
            ..egm::Planned::default()
        }),
        speeds: None,
    }
}

#[test]
fn egm_agrees_with_the_vector() {
    let mut bytes = Vec::new();
    sensor().write(&mut bytes);
    assert_eq!(bytes.len(), 67);
    assert_eq!(bytes, vector());
    assert_eq!(egm::Sensor::read(&bytes), Some(sensor()));
}

#[test]
fn egm_reads_packed_lists_and_skips_what_it_does_not_know() {
    // Joints packed into one field, a fixed32, text and a nested message of unknown numbers.
    let mut joints = vec![0x0a, 16];
    joints.extend(1.5_f64.to_le_bytes());
    joints.extend((-2.5_f64).to_le_bytes());
    let mut planned = vec![0x0a, joints.len() as u8];
    planned.extend(&joints);
    let mut bytes = vec![0x0a, 2, 0x08, 5, 0x12, planned.len() as u8];
    bytes.extend(&planned);
    bytes.extend([
        0xa5, 0x06, 1, 2, 3, 4, 0xaa, 0x06, 2, b'h', b'i', 0xb0, 0x06, 0xff, 0x01,
    ]);
    let sensor = egm::Sensor::read(&bytes).unwrap();
    assert_eq!(sensor.header.sequence, 5);
    let planned = sensor.planned.unwrap();
    assert_eq!(planned.joints.unwrap().degrees(), [1.5, -2.5]);
    // Cut anywhere, it is either a shorter message or none, and never a panic.
    for end in 0..bytes.len() {
        let _ = egm::Sensor::read(&bytes[..end]);
    }
    assert_eq!(egm::Sensor::read(&bytes[..bytes.len() - 1]), None);
}
