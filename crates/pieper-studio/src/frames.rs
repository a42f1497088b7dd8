//! Poses as the page draws them: WIRE.md section 5.

use nalgebra::Isometry3;

/// Kind 1: where the arm is.
pub(crate) const POSE: u8 = 1;
/// Kind 2: where its other solutions are.
pub(crate) const GHOSTS: u8 = 2;

/// Kind 3: where the real arm is.
pub(crate) const REAL: u8 = 3;

/// The first 16 bytes of a frame.
fn head(kind: u8, playing: bool, links: usize, sequence: u32, time: f64) -> Vec<u8> {
    let mut out = vec![kind, u8::from(playing)];
    out.extend((links as u16).to_le_bytes());
    out.extend(sequence.to_le_bytes());
    out.extend(time.to_le_bytes());
    out
}

fn push_matrices(out: &mut Vec<u8>, poses: &[Isometry3<f64>]) {
    for pose in poses {
        // nalgebra's own order is by columns.
        for value in pose.to_homogeneous().as_slice() {
            out.extend((*value as f32).to_le_bytes());
        }
    }
}

/// A pose frame.
pub(crate) fn pose(
    playing: bool,
    sequence: u32,
    time: f64,
    q: &[f64],
    poses: &[Isometry3<f64>],
) -> Vec<u8> {
    let mut out = head(POSE, playing, poses.len(), sequence, time);
    out.extend((q.len() as u32).to_le_bytes());
    for value in q {
        out.extend((*value as f32).to_le_bytes());
    }
    push_matrices(&mut out, poses);
    out
}

/// A frame of ghosts, each the poses of all links.
pub(crate) fn ghosts(sequence: u32, links: usize, ghosts: &[Vec<Isometry3<f64>>]) -> Vec<u8> {
    arms(GHOSTS, sequence, links, ghosts)
}

/// A frame of the real arm: one or none.
pub(crate) fn real(sequence: u32, links: usize, arm: &[Vec<Isometry3<f64>>]) -> Vec<u8> {
    arms(REAL, sequence, links, arm)
}

fn arms(kind: u8, sequence: u32, links: usize, ghosts: &[Vec<Isometry3<f64>>]) -> Vec<u8> {
    let mut out = head(kind, false, links, sequence, 0.0);
    out.extend((ghosts.len() as u32).to_le_bytes());
    for poses in ghosts {
        push_matrices(&mut out, poses);
    }
    out
}
