//! Measurements as a table.

use std::fmt::Write as _;

use nalgebra::UnitQuaternion;
use pieper::calibration::{Measurement, Model, Seen};

/// Column names of the joints: degrees and millimetres, as people read them.
pub(super) fn joint_names(model: &Model) -> Vec<String> {
    let name = |variable: &pieper::model::Variable| match variable.kind.is_angular() {
        true => format!("{}_deg", variable.name),
        false => format!("{}_mm", variable.name),
    };
    model.chain().variables().iter().map(name).collect()
}

/// Joint values in those units.
pub(super) fn joints(model: &Model, q: &[f64], decimals: usize) -> String {
    let cell = |(value, variable): (&f64, &pieper::model::Variable)| {
        let shown = match variable.kind.is_angular() {
            true => value.to_degrees(),
            false => value * 1e3,
        };
        format!("{shown:.decimals$}")
    };
    let cells = q.iter().zip(model.chain().variables()).map(cell);
    cells.collect::<Vec<_>>().join(",")
}

/// A table of measurements of one kind, with the true numbers as comments where they are known.
pub(super) fn csv(model: &Model, measurements: &[Measurement], truth: Option<&[f64]>) -> String {
    let mut out = format!(
        "# Simulated measurements of an {} whose numbers are a little off.\n",
        model.robot().name
    );
    for (parameter, value) in model.parameters().iter().zip(truth.unwrap_or_default()) {
        let off = value - parameter.nominal;
        let (off, unit) = match parameter.is_angle {
            true => (off.to_degrees(), "deg"),
            false => (off * 1e3, "mm"),
        };
        let _ = writeln!(out, "# truth: {} {off:+.4} {unit}", parameter.name);
    }
    let seen = match measurements.first().map(|m| &m.seen) {
        Some(Seen::Pose(_)) => "x_mm,y_mm,z_mm,qw,qx,qy,qz",
        Some(Seen::Position { .. }) => "x_mm,y_mm,z_mm,px_mm,py_mm,pz_mm",
        Some(Seen::Distance { .. }) => "distance_mm,anchor",
        Some(Seen::Plane { .. }) => "plane",
        _ => "contact",
    };
    let _ = writeln!(
        out,
        "{},{seen},sigma_mm,sigma_angle_deg",
        joint_names(model).join(",")
    );
    let mm = |xyz: [f64; 3]| {
        let [x, y, z] = xyz.map(|v| v * 1e3);
        format!("{x:.5},{y:.5},{z:.5}")
    };
    for measurement in measurements {
        let cells = match &measurement.seen {
            Seen::Pose(pose) => {
                let q = UnitQuaternion::from_rotation_matrix(&pose.rotation);
                format!(
                    "{},{:.9},{:.9},{:.9},{:.9}",
                    mm(pose.translation.vector.into()),
                    q.w,
                    q.i,
                    q.j,
                    q.k
                )
            }
            Seen::Position { point, at } => format!("{},{}", mm(*point), mm(*at)),
            Seen::Distance {
                anchor, distance, ..
            } => format!("{:.5},{anchor}", distance * 1e3),
            Seen::Plane { plane, .. } => plane.clone(),
            Seen::Contact { contact, .. } => contact.clone(),
        };
        let _ = writeln!(
            out,
            "{},{cells},{},{}",
            joints(model, &measurement.joints, 8),
            measurement.sigma * 1e3,
            measurement.sigma_angle.to_degrees()
        );
    }
    out
}
