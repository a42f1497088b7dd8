//! The unit sphere and what lies on its far side.

use std::f64::consts::{PI, TAU};

use crate::axes::NORMAL;
use crate::ink::Ink;
use crate::scene::{Scene, Stroke, Text};
use crate::view::{Camera, Lens, Vec3, add, dot};

/// Stretches of a line on the sphere, each wholly on the near or wholly on the far side.
pub(crate) struct Stretch {
    pub(crate) points: Vec<Vec3>,
    pub(crate) hidden: bool,
}

/// Whether a point of the sphere is on the far side; the silhouette itself is seen.
pub(crate) fn hidden(camera: &Camera, point: Vec3) -> bool {
    camera.depth(point) < -1e-6
}

/// Cuts a line where it passes the silhouette.
pub(crate) fn stretches(camera: &Camera, line: &[Vec3]) -> Vec<Stretch> {
    let mut out: Vec<Stretch> = Vec::new();
    for &point in line {
        let hidden = hidden(camera, point);
        match out.last_mut() {
            Some(stretch) if stretch.hidden == hidden => stretch.points.push(point),
            Some(stretch) => {
                let Some(&last) = stretch.points.last() else {
                    continue;
                };
                let [from, to] = [camera.depth(last), camera.depth(point)];
                let share = (from / (from - to)).clamp(0.0, 1.0);
                let border = add(last, add(point, last, -1.0), share);
                stretch.points.push(border);
                out.push(Stretch {
                    points: vec![border, point],
                    hidden,
                });
            }
            None => out.push(Stretch {
                points: vec![point],
                hidden,
            }),
        }
    }
    out
}

/// Draws the ball with its near meridians and parallels.
pub(crate) fn ball(scene: &mut Scene, lens: &Lens) {
    let center = lens.at([0.0; 3]);
    scene.disc(center, lens.scale, Ink::Wall, None);
    let near = Stroke::solid(Ink::Grid, 1.0);
    for line in grid() {
        for stretch in stretches(&lens.camera, &line) {
            if !stretch.hidden {
                scene.polyline(lens.line(&stretch.points), near);
            }
        }
    }
    scene.ring(center, lens.scale, Stroke::solid(Ink::Axis, 1.0));
}

/// Meridians and parallels 30 degrees apart.
fn grid() -> Vec<Vec<Vec3>> {
    let at = |latitude: f64, longitude: f64| {
        let ([sin_u, cos_u], [sin_v, cos_v]) = (sin_cos(latitude), sin_cos(longitude));
        [cos_u * cos_v, cos_u * sin_v, sin_u]
    };
    let meridian = |k: u32| {
        let longitude = TAU * f64::from(k) / 12.0;
        let latitudes = (0..=36).map(move |j| PI * (f64::from(j) / 36.0 - 0.5));
        latitudes.map(|latitude| at(latitude, longitude)).collect()
    };
    let parallel = |k: u32| {
        let latitude = PI * (f64::from(k) / 6.0 - 0.5);
        let longitudes = (0..=72).map(|j| TAU * f64::from(j) / 72.0);
        longitudes
            .map(|longitude| at(latitude, longitude))
            .collect()
    };
    (0..12).map(meridian).chain((1..6).map(parallel)).collect()
}

fn sin_cos(angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [sin, cos]
}

/// Draws the axes of the frame the directions are measured in: faint inside the ball, and an
/// outer piece with the axis's name.
pub(crate) fn axes(scene: &mut Scene, lens: &Lens, names: [&str; 3]) {
    for (k, name) in names.into_iter().enumerate() {
        let axis: Vec3 = [0, 1, 2].map(|j| if j == k { 1.0 } else { 0.0 });
        let [x, y] = lens.camera.see(axis);
        let seen = x.hypot(y).max(1e-9);
        // An axis that points away comes out from behind the silhouette, others out of the surface.
        let surface = if dot(lens.camera.toward, axis) < 0.0 {
            1.0 / seen
        } else {
            1.0
        };
        let [outer, label] =
            [1.17 / seen, 1.28 / seen].map(|length| lens.at(axis.map(|x| x * length)));
        let inner = lens.at(axis.map(|x| x * surface));
        let faint = Stroke::dashed(Ink::Axis, 0.8, &[2.0, 3.0]);
        scene.line(lens.at([0.0; 3]), inner, faint);
        scene.line(inner, outer, Stroke::solid(Ink::Muted, 1.2));
        scene.text(Text::centered(label, name, NORMAL));
    }
}
