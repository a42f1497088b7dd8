//! Every sample as comma-separated values, in digits that read back to the same number.

use std::fmt::Write as _;

use nalgebra::UnitQuaternion;

use super::{Run, matrices};

/// Column names of the pose: the tool's point, and the direction cosines of its unit vectors.
const POSE: &str = "x,y,z,ix,iy,iz,jx,jy,jz,kx,ky,kz";

pub(super) fn csv(run: &Run) -> String {
    let joints: Vec<_> = (1..=run.chain.dof()).map(|k| format!("q{k}")).collect();
    let mut out = format!("t,mark,{},{POSE}\n", joints.join(","));
    let recording = &run.recording;
    let mut marks = recording.marks.iter().peekable();
    for (index, time) in recording.times.iter().enumerate() {
        let mark = marks.next_if(|mark| mark.sample == index);
        let label = mark.map_or(String::new(), |mark| cell(&mark.label));
        let _ = write!(out, "{},{label}", number(*time));
        for q in &recording.joints[index] {
            let _ = write!(out, ",{}", number(*q));
        }
        let rows = matrices::rows(&recording.poses[index]);
        for column in [3, 0, 1, 2] {
            for row in &rows[..3] {
                let _ = write!(out, ",{}", number(row[column]));
            }
        }
        out.push('\n');
    }
    out
}

/// The motion of the joints itself, in as few rows as describe it: a table that can be run.
pub(super) fn joints(run: &Run) -> String {
    let names: Vec<_> = (1..=run.chain.dof()).map(|k| format!("q{k}")).collect();
    let mut out = format!("t,mark,{}\n", names.join(","));
    let recording = &run.recording;
    let mut marks = recording.marks.iter().peekable();
    for (&time, row) in run.law.times().iter().zip(run.law.rows()) {
        let mark = marks.next_if(|mark| recording.time(mark) == time);
        let label = mark.map_or(String::new(), |mark| cell(&mark.label));
        let _ = write!(out, "{},{label}", number(time));
        for q in row {
            let _ = write!(out, ",{}", number(*q));
        }
        out.push('\n');
    }
    out
}

/// The tool's pose at every sample: a table that can be run, which leads back to joint values.
pub(super) fn poses(run: &Run) -> String {
    let mut out = String::from("t,mark,x,y,z,qw,qx,qy,qz\n");
    let recording = &run.recording;
    let mut marks = recording.marks.iter().peekable();
    for (index, time) in recording.times.iter().enumerate() {
        let mark = marks.next_if(|mark| mark.sample == index);
        let label = mark.map_or(String::new(), |mark| cell(&mark.label));
        let pose = &recording.poses[index];
        let turn = UnitQuaternion::from_rotation_matrix(&pose.rotation);
        let [x, y, z] = pose.translation.vector.into();
        let _ = write!(out, "{},{label}", number(*time));
        for value in [x, y, z, turn.w, turn.i, turn.j, turn.k] {
            let _ = write!(out, ",{}", number(value));
        }
        out.push('\n');
    }
    out
}

/// The shortest digits that read back to the same number, without negative zeros.
pub(super) fn number(value: f64) -> String {
    let value = value + 0.0;
    match value != 0.0 && value.abs() < 1e-5 {
        true => format!("{value:e}"),
        false => value.to_string(),
    }
}

/// A text as a cell, in quotes where it needs them.
pub(super) fn cell(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}
