//! Any bytes from a controller, cut anywhere, to every protocol's host: nothing panics, what is measured is a number, and a host that
//! was not armed is never ready.

#![no_main]

use std::time::Duration;

use libfuzzer_sys::fuzz_target;
use pieper_link::protocol::{Kind, Setup};
use pieper_link::MotorOf;

fuzz_target!(|data: &[u8]| {
    let Some((&head, rest)) = data.split_first() else {
        return;
    };
    let kind = Kind::ALL[usize::from(head) % Kind::ALL.len()];
    let motors = (0..6).map(|k| MotorOf { name: format!("m{k}"), is_angle: true }).collect();
    let mut host = kind.host(Setup { motors, poses_of: None, nonce: 1 }).unwrap();
    let (mut out, mut events) = (Vec::new(), Vec::new());
    let is_armed = head >= 128;
    for (tick, chunk) in rest.chunks(1 + usize::from(head % 61)).enumerate() {
        let now = Duration::from_millis(13) * tick as u32;
        host.poll(now, &mut out, &mut events);
        host.receive(now, chunk, &mut events);
        assert!(events.len() < 4 * chunk.len() + 8);
        events.clear();
        if let Some(motors) = host.measured() {
            assert!(motors.iter().all(|motor| motor.is_finite()), "{motors:?}");
        }
        assert!(is_armed || !host.is_ready());
        if is_armed && tick == 3 {
            host.arm(now, &mut out, &mut events);
        }
        if host.is_ready() {
            host.set_point(now, &[0.1, 0.2, -0.3, 0.4, 0.5, -0.6], Duration::from_millis(20), &mut out);
        }
        assert!(out.len() < 1 << 16);
        out.clear();
    }
});
