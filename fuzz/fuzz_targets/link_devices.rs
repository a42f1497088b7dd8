//! Any bytes from a program, cut anywhere, to every simulated controller: nothing panics, no motor leaves its range, and none goes
//! faster than it can.

#![no_main]

use std::sync::LazyLock;
use std::time::Duration;

use libfuzzer_sys::fuzz_target;
use pieper_link::protocol::Kind;
use pieper_link::simulator::{Fault, device};
use pieper_link::Arm;

static ARMS: LazyLock<Vec<Arm>> = LazyLock::new(|| {
    let arm = |kind: &Kind| Arm::of(&pieper_robots::find(kind.robot()).unwrap().robot()).unwrap();
    Kind::ALL.iter().map(arm).collect()
});

fuzz_target!(|data: &[u8]| {
    let Some((&head, rest)) = data.split_first() else {
        return;
    };
    let index = usize::from(head) % Kind::ALL.len();
    let mut controller = device(Kind::ALL[index], &ARMS[index]).unwrap();
    let mut out = Vec::new();
    for (tick, chunk) in rest.chunks(1 + usize::from(head % 97)).enumerate() {
        let now = Duration::from_millis(5) * tick as u32;
        controller.receive(now, chunk, &mut out);
        controller.tick(now, &mut out);
        if chunk.first() == Some(&0xfe) {
            controller.inject(now, Fault::ALL[chunk.len() % Fault::ALL.len()]);
        }
        assert!(out.len() < 1 << 20);
        out.clear();
        assert!(controller.motors().iter().all(|motor| motor.abs() < 10.0));
    }
});
