//! Solids that bodies are made of, each around its own frame.

use std::f64::consts::{PI, TAU};

use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};

use crate::mesh::Mesh;

/// Corners on a full turn.
const AROUND: usize = 40;

/// Edges that bend by more are drawn sharp.
pub const CREASE: f64 = 0.6;

/// A profile of `(radius, z)` turned about z. The profile runs from the bottom to the top with its outside to the right; it is
/// closed where its ends have radius 0.
pub fn turned(profile: &[(f64, f64)]) -> Mesh {
    let at = |(radius, z): (f64, f64), k: usize| {
        let (sin, cos) = (k as f64 * TAU / AROUND as f64).sin_cos();
        [radius * cos, radius * sin, z]
    };
    let mut triangles = Vec::new();
    for pair in profile.windows(2) {
        for k in 0..AROUND {
            let next = (k + 1) % AROUND;
            let (a, b) = (at(pair[0], k), at(pair[0], next));
            let (c, d) = (at(pair[1], next), at(pair[1], k));
            triangles.push([a, b, c]);
            triangles.push([a, c, d]);
        }
    }
    Mesh::of_triangles(&triangles, CREASE)
}

/// A cylinder along z, its centre at the origin, its edges rounded off by `bevel`.
pub fn cylinder(radius: f64, length: f64, bevel: f64) -> Mesh {
    let (half, bevel) = (0.5 * length, bevel.min(0.5 * length).min(radius));
    let mut profile = vec![(0.0, -half)];
    let steps = if bevel > 0.0 { 4 } else { 0 };
    for (centre, from) in [(-half + bevel, -0.5 * PI), (half - bevel, 0.0)] {
        for k in 0..=steps {
            let angle = from + 0.5 * PI * k as f64 / steps.max(1) as f64;
            profile.push((
                radius - bevel + bevel * angle.cos(),
                centre + bevel * angle.sin(),
            ));
        }
    }
    profile.push((0.0, half));
    turned(&profile)
}

/// A sphere.
pub fn sphere(radius: f64) -> Mesh {
    let rings = AROUND / 2;
    let profile: Vec<(f64, f64)> = (0..=rings)
        .map(|k| {
            let angle = PI * k as f64 / rings as f64 - 0.5 * PI;
            let radius_here = if k == 0 || k == rings {
                0.0
            } else {
                radius * angle.cos()
            };
            (radius_here, radius * angle.sin())
        })
        .collect();
    turned(&profile)
}

/// A cone-like tube between two balls: from radius `a` at the origin to radius `b` at height `length`, rounded at both ends.
pub fn limb(a: f64, b: f64, length: f64) -> Mesh {
    let steps = 6;
    let mut profile = Vec::new();
    for k in 0..=steps {
        let angle = -0.5 * PI * (1.0 - k as f64 / steps as f64);
        profile.push((if k == 0 { 0.0 } else { a * angle.cos() }, a * angle.sin()));
    }
    for k in 0..=steps {
        let angle = 0.5 * PI * k as f64 / steps as f64;
        profile.push((
            if k == steps { 0.0 } else { b * angle.cos() },
            length + b * angle.sin(),
        ));
    }
    turned(&profile)
}

/// A box about the origin with edges cut off by `bevel`.
pub fn block(size: [f64; 3], bevel: f64) -> Mesh {
    let half = size.map(|edge| 0.5 * edge);
    let bevel = half.iter().fold(bevel, |least, h| least.min(*h));
    // Three rectangles meet at each corner: the outermost faces, drawn in by the bevel.
    let corner = |sign: [f64; 3], outer: usize| -> [f64; 3] {
        std::array::from_fn(|k| sign[k] * (half[k] - if k == outer { 0.0 } else { bevel }))
    };
    let mut triangles = Vec::new();
    let mut quad = |q: [[f64; 3]; 4]| {
        // Outward whatever the order: the solid is convex about the origin.
        let [a, b, c, d] = q.map(Vector3::from);
        let outward = (b - a).cross(&(c - a)).dot(&(a + b + c + d)) >= 0.0;
        let q = if outward { q } else { [q[3], q[2], q[1], q[0]] };
        triangles.push([q[0], q[1], q[2]]);
        triangles.push([q[0], q[2], q[3]]);
    };
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for side in [-1.0, 1.0] {
            let signed = |su: f64, sv: f64| {
                let mut sign = [0.0; 3];
                (sign[axis], sign[u], sign[v]) = (side, su, sv);
                sign
            };
            let around = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            quad(around.map(|(su, sv)| corner(signed(su, sv), axis)));
            // The edge towards u on this side.
            for su in [-1.0, 1.0] {
                let (low, high) = (signed(su, -1.0), signed(su, 1.0));
                quad([
                    corner(low, axis),
                    corner(high, axis),
                    corner(high, u),
                    corner(low, u),
                ]);
            }
        }
    }
    for k in 0..8 {
        let sign: [f64; 3] = std::array::from_fn(|bit| if k >> bit & 1 == 1 { 1.0 } else { -1.0 });
        let [a, b, c] = [0, 1, 2].map(|outer| corner(sign, outer));
        let [p, q, r] = [a, b, c].map(Vector3::from);
        let outward = (q - p).cross(&(r - p)).dot(&(p + q + r)) >= 0.0;
        triangles.push(if outward { [a, b, c] } else { [a, c, b] });
    }
    Mesh::of_triangles(&triangles, 0.3)
}

/// The frame at `from` whose z axis points to `to`; `None` where they coincide.
pub fn along(from: &Point3<f64>, to: &Point3<f64>) -> Option<Isometry3<f64>> {
    let direction = (to - from).try_normalize(1e-12)?;
    Some(Isometry3::from_parts((*from).into(), pointing(&direction)))
}

/// A turn that brings z to a direction of length 1.
pub fn pointing(direction: &Vector3<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::rotation_between(&Vector3::z(), direction)
        .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI))
}
