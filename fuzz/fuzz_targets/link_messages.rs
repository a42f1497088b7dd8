//! Any bytes as messages: what reads, is written and read again as it was.

#![no_main]

use libfuzzer_sys::fuzz_target;
use pieper_link::protocol::packets::{Deframer, Packet, ToDevice, ToHost};
use pieper_link::protocol::{ar3, ar4, egm, ros};

fn again<P: Packet + PartialEq + std::fmt::Debug>(packet: &[u8]) {
    let Ok((sequence, message)) = P::decode(packet) else {
        return;
    };
    let mut bytes = Vec::new();
    message.encode(sequence, &mut bytes);
    Deframer::default().push(&bytes, |packet| {
        assert_eq!(P::decode(packet.unwrap()), Ok((sequence, P::decode(packet.unwrap()).unwrap().1)));
    });
}

fuzz_target!(|data: &[u8]| {
    again::<ToDevice>(data);
    again::<ToHost>(data);
    Deframer::default().push(data, |packet| drop(packet.map(<[u8]>::len)));
    if let Some(robot) = egm::Robot::read(data) {
        let mut bytes = Vec::new();
        robot.write(&mut bytes);
        let mut twice = Vec::new();
        egm::Robot::read(&bytes).unwrap().write(&mut twice);
        assert_eq!(bytes, twice);
    }
    if let Some(sensor) = egm::Sensor::read(data) {
        let mut bytes = Vec::new();
        sensor.write(&mut bytes);
        let mut twice = Vec::new();
        egm::Sensor::read(&bytes).unwrap().write(&mut twice);
        assert_eq!(bytes, twice);
    }
    if let Ok(text) = std::str::from_utf8(data) {
        if let Some(reply) = ar4::Reply::read(text) {
            assert!(ar4::Reply::read(&reply.write()).is_some());
        }
        let _ = ar4::Command::read(text);
        if let Some(ask) = ar3::Ask::read(text) {
            assert_eq!(ar3::Ask::read(&ask.write()), Some(ask));
        }
        let _ = ar3::Reply::read(text);
        let _ = ros::read(text);
        let _ = pieper_link::Record::read(text);
        let _ = text.parse::<pieper_link::transport::Address>();
    }
});
