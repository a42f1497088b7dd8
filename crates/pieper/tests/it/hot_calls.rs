//! Nothing on a hot path allocates.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use crate::support::arms;
use pieper::kinematics::batch::{JointBatch, PoseBatch, tool_poses};
use pieper::kinematics::{
    Directions, Jacobian, Reference, joint_torques, pose_and_jacobian, tool_pose,
    tool_pose_by_quaternions, twist,
};

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

struct Counting;

// SAFETY: every call is handed to the system's allocator unchanged; counting touches no memory of it.
#[allow(
    unsafe_code,
    reason = "an allocator cannot be written without it; it exists in this test only"
)]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let _ = ALLOCATIONS.try_with(|count| count.set(count.get() + 1));
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller's promises are passed on.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

pub(crate) fn allocations(mut call: impl FnMut()) -> usize {
    let before = ALLOCATIONS.with(Cell::get);
    call();
    ALLOCATIONS.with(Cell::get) - before
}

#[test]
fn hot_calls_allocate_nothing() {
    assert!(
        allocations(|| drop(std::hint::black_box(Box::new(1)))) > 0,
        "the counter counts"
    );
    for (id, chain) in arms() {
        let n = chain.dof();
        let q = vec![0.3; n];
        let mut torques = vec![0.0; n];
        let mut jacobian = Jacobian::zeros(n);
        let (batch, mut poses) = (JointBatch::zeros(n, 100), PoseBatch::zeros(100));
        let count = allocations(|| {
            let pose = tool_pose(&chain, &q).unwrap();
            tool_pose_by_quaternions(&chain, &q).unwrap();
            pose_and_jacobian(&chain, &q, Reference::Base, &mut jacobian).unwrap();
            pose_and_jacobian(&chain, &q, Reference::Tool, &mut jacobian).unwrap();
            let velocity = twist(&jacobian, &q).unwrap();
            joint_torques(&jacobian, &velocity, &mut torques).unwrap();
            std::hint::black_box(Directions::of(&pose));
            tool_poses(&chain, &batch, &mut poses).unwrap();
        });
        assert_eq!(count, 0, "{id}");
    }
}
