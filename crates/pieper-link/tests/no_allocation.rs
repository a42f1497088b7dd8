//! A cycle allocates nothing: neither in the protocols' state machines, nor in the guard.

// Tests may unwrap, and so may their helper functions.
#![allow(clippy::unwrap_used, clippy::expect_used)]
#![allow(
    unsafe_code,
    reason = "an allocator that counts is unsafe to write, and does nothing else"
)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::sync::Arc;
use std::time::Duration;

use pieper::motion::{Law, Profile};
use pieper_link::protocol::{Event, Setup};
use pieper_link::safety::{Envelope, Guard, Phase};
use pieper_link::simulator::device;
use pieper_link::{Arm, Kind};

struct Counting;

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call is the system allocator's own, which keeps the contract; a number is counted beside it.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let _ = COUNT.try_with(|count| count.set(count.get() + 1));
        // SAFETY: the caller's promise is passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        // SAFETY: the caller's promise is passed on.
        unsafe { System.dealloc(place, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn cycles_allocate_nothing(kind: Kind) {
    let robot = pieper_robots::find(kind.robot()).unwrap().robot();
    let arm = Arc::new(Arm::of(&robot).unwrap());
    let setup = Setup {
        motors: arm.motors(),
        poses_of: None,
        nonce: 5,
    };
    let mut host = kind.host(setup).unwrap();
    let mut controller = device(kind, &arm).unwrap();
    let mut guard = Guard::new(Envelope::of(Arc::clone(&arm), 1.0));
    let (mut out, mut back, mut events) = (
        Vec::with_capacity(4096),
        Vec::with_capacity(4096),
        Vec::with_capacity(64),
    );
    let mut is_armed = false;
    let (mut allocated, mut cycles) = (0, 0);
    // The controller's own cycle.
    for tick in 0..1000_u32 {
        let now = Duration::from_millis(4) * tick;
        controller.tick(now, &mut back);
        let before = COUNT.with(Cell::get);
        host.poll(now, &mut out, &mut events);
        if !back.is_empty() {
            host.receive(now, &back, &mut events);
        }
        back.clear();
        let mut is_measured = false;
        for event in events.drain(..) {
            match event {
                Event::Measured => is_measured = true,
                Event::Armed => guard.armed(now),
                Event::Identified(_) => {}
                other => panic!("{other:?}"),
            }
        }
        if is_measured {
            guard.measure(now, host.measured().unwrap()).unwrap();
            guard.watch_error();
        }
        guard.beat(now);
        guard.watch(now, host.patience());
        if is_measured
            && host.is_ready()
            && let Some(point) = guard.next(Duration::from_millis(4))
        {
            host.set_point(now, point.motors, point.over, &mut out);
        }
        let after = COUNT.with(Cell::get);
        if is_measured && tick > 100 {
            allocated += after - before;
            cycles += 1;
        }
        if tick == 50 {
            guard.arm_if_allowed(now, host.patience()).unwrap();
            host.arm(now, &mut out, &mut events);
            is_armed = true;
        }
        if is_armed && guard.phase() == Phase::Holding && tick < 100 {
            let q = guard.commanded().unwrap().to_vec();
            let mut there = q.clone();
            there[0] += 0.1;
            let law = Law::new(vec![0.0, 2.0], vec![q, there], Profile::Cubic);
            guard.play(law.unwrap()).unwrap();
        }
        if !out.is_empty() {
            controller.receive(now, &out, &mut back);
        }
        out.clear();
    }
    assert!(cycles > 150, "{kind}: {cycles}");
    assert_ne!(guard.phase(), Phase::Stopped, "{:?}", guard.reason());
    assert_eq!(allocated, 0, "{kind}: in {cycles} cycles");
}

#[test]
fn egm() {
    cycles_allocate_nothing(Kind::Egm);
}

#[test]
fn packets() {
    cycles_allocate_nothing(Kind::Packets);
}
