//! Space seen from afar: an axonometric camera and the box it looks into.

use crate::axes::{NORMAL, SMALL};
use crate::font;
use crate::ink::Ink;
use crate::scene::{Anchor, Point, Rect, Scene, Stroke, Text};
use crate::ticks::{level_ticks, ticks};

/// A place or direction in space.
pub(crate) type Vec3 = [f64; 3];

pub(crate) fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(crate) fn add(a: Vec3, b: Vec3, factor: f64) -> Vec3 {
    [0, 1, 2].map(|k| a[k] + factor * b[k])
}

pub(crate) fn norm(a: Vec3) -> f64 {
    dot(a, a).sqrt()
}

/// The unit vector along `a`; none for no length.
pub(crate) fn unit(a: Vec3) -> Option<Vec3> {
    let length = norm(a);
    (length > 1e-12).then(|| a.map(|x| x / length))
}

/// A parallel projection: which directions of space run right, up and towards the eye.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Camera {
    pub(crate) right: Vec3,
    pub(crate) up: Vec3,
    pub(crate) toward: Vec3,
}

impl Camera {
    /// From the front right, above: x runs right and to the front, y right and to the back, z up.
    pub(crate) fn axonometric() -> Self {
        let (sin_a, cos_a) = (-52.0_f64).to_radians().sin_cos();
        let (sin_e, cos_e) = 24.0_f64.to_radians().sin_cos();
        Self {
            right: [-sin_a, cos_a, 0.0],
            up: [-sin_e * cos_a, -sin_e * sin_a, cos_e],
            toward: [cos_e * cos_a, cos_e * sin_a, sin_e],
        }
    }

    /// Along an axis, with the axes `right` and `up` in the plane of the picture.
    pub(crate) fn along(right: usize, up: usize) -> Self {
        let axis = |k: usize| [0, 1, 2].map(|j| if j == k { 1.0 } else { 0.0 });
        let [right, up] = [axis(right), axis(up)];
        Self {
            right,
            up,
            toward: cross(right, up),
        }
    }

    /// Place in the plane of the picture, y upwards.
    pub(crate) fn see(&self, point: Vec3) -> Point {
        [dot(self.right, point), dot(self.up, point)]
    }

    /// The ranges that points span in the plane of the picture.
    pub(crate) fn extent(&self, points: &[Vec3]) -> [[f64; 2]; 2] {
        let span = |k: usize| {
            let places = points.iter().map(|&point| self.see(point)[k]);
            places.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| {
                [a.min(x), b.max(x)]
            })
        };
        [span(0), span(1)]
    }

    pub(crate) fn depth(&self, point: Vec3) -> f64 {
        dot(self.toward, point)
    }
}

/// A camera with a place on the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lens {
    pub(crate) camera: Camera,
    pub(crate) scale: f64,
    pub(crate) offset: Point,
}

impl Lens {
    /// Fits points into an area.
    pub(crate) fn fit(camera: Camera, points: &[Vec3], area: &Rect) -> Self {
        let [x, y] = camera.extent(points);
        let scale = (area.width / (x[1] - x[0])).min(area.height / (y[1] - y[0]));
        let center = area.center();
        Self {
            camera,
            scale,
            offset: [
                center[0] - scale * (x[0] + x[1]) / 2.0,
                center[1] + scale * (y[0] + y[1]) / 2.0,
            ],
        }
    }

    pub(crate) fn at(&self, point: Vec3) -> Point {
        let [x, y] = self.camera.see(point);
        [
            self.offset[0] + self.scale * x,
            self.offset[1] - self.scale * y,
        ]
    }

    pub(crate) fn line(&self, points: &[Vec3]) -> Vec<Point> {
        points.iter().map(|&point| self.at(point)).collect()
    }
}

pub(crate) fn corners(low: Vec3, high: Vec3) -> [Vec3; 8] {
    [0, 1, 2, 3, 4, 5, 6, 7]
        .map(|bits: usize| [0, 1, 2].map(|k| if bits >> k & 1 == 0 { low[k] } else { high[k] }))
}

/// A box whose far walls carry a grid and whose near edges carry ticks.
pub(crate) struct Room<'a> {
    pub(crate) low: Vec3,
    pub(crate) high: Vec3,
    pub(crate) names: [&'a str; 3],
    /// What a unit of the axis is in the units of the points: ticks are counted in it.
    pub(crate) unit: f64,
}

impl Room<'_> {
    /// Draws walls, grid, ticks and names for the view from the front right, above.
    pub(crate) fn draw(&self, scene: &mut Scene, lens: &Lens) {
        let (low, high) = (self.low, self.high);
        let place = |x, y, z| lens.at([x, y, z]);
        let floor = [
            place(low[0], low[1], low[2]),
            place(high[0], low[1], low[2]),
            place(high[0], high[1], low[2]),
            place(low[0], high[1], low[2]),
        ];
        let left = [
            floor[0],
            floor[3],
            place(low[0], high[1], high[2]),
            place(low[0], low[1], high[2]),
        ];
        let back = [
            floor[3],
            floor[2],
            place(high[0], high[1], high[2]),
            left[2],
        ];
        for wall in [floor, left, back] {
            scene.polygon(
                wall.to_vec(),
                Ink::Wall,
                Some(Stroke::solid(Ink::Axis, 0.8)),
            );
        }
        for axis in 0..3 {
            self.draw_axis(scene, lens, axis);
        }
    }

    fn draw_axis(&self, scene: &mut Scene, lens: &Lens, axis: usize) {
        let (low, high) = (self.low, self.high);
        // The labelled edge, and the two far edges the grid lines of this axis run along.
        let (edge, bend, end) = match axis {
            0 => (
                [0.0, low[1], low[2]],
                [0.0, high[1], low[2]],
                [0.0, high[1], high[2]],
            ),
            1 => (
                [high[0], 0.0, low[2]],
                [low[0], 0.0, low[2]],
                [low[0], 0.0, high[2]],
            ),
            _ => (
                [low[0], low[1], 0.0],
                [low[0], high[1], 0.0],
                [high[0], high[1], 0.0],
            ),
        };
        let with = |mut corner: Vec3, value: f64| {
            corner[axis] = value;
            lens.at(corner)
        };
        let ends = [low[axis], high[axis]].map(|end| end / self.unit);
        let ticks = if axis == 2 {
            ticks(ends[0], ends[1], 5, "")
        } else {
            let length = with(edge, high[axis])[0] - with(edge, low[axis])[0];
            level_ticks(ends, 5, "", length.abs())
        };
        let outward = {
            let middle = (low[axis] + high[axis]) / 2.0;
            let [from, to] = [with(bend, middle), with(edge, middle)];
            let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
            let length = dx.hypot(dy).max(1e-9);
            [dx / length, dy / length]
        };
        let beside = |at: Point, text: &str, size: f64, gap: f64| {
            let (half_width, half_height) = (font::width(text, size) / 2.0, 0.4 * size);
            let reach = gap + outward[0].abs() * half_width + outward[1].abs() * half_height;
            [at[0] + reach * outward[0], at[1] + reach * outward[1]]
        };
        for (value, label) in ticks.values.iter().zip(ticks.labels()) {
            let value = value * self.unit;
            let line = vec![with(edge, value), with(bend, value), with(end, value)];
            let center = beside(line[0], &label, SMALL, 5.0);
            scene.polyline(line, Stroke::solid(Ink::Grid, 0.9));
            scene.text(Text::centered(center, label, SMALL).ink(Ink::Muted));
        }
        if axis == 2 {
            // Over the end of the axis: beside its tick labels it would need a wide margin.
            let [x, y] = with(edge, high[axis]);
            let text = Text::new([x + 2.0, y - 9.0], self.names[axis], NORMAL);
            scene.text(text.anchor(Anchor::End));
            return;
        }
        let middle = with(edge, (low[axis] + high[axis]) / 2.0);
        let gap = 12.0 + outward[0].abs() * ticks.widest_label() + outward[1].abs() * SMALL;
        let center = beside(middle, self.names[axis], NORMAL, gap);
        scene.text(Text::centered(center, self.names[axis], NORMAL));
    }
}

/// Leaves out points that no eye can tell from their neighbours; a resting path is one point.
pub(crate) fn thinned(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    for &point in points {
        let far = |last: &Point| (point[0] - last[0]).hypot(point[1] - last[1]) > 0.4;
        if kept.last().is_none_or(far) {
            kept.push(point);
        }
    }
    if let (true, Some(last), Some(end)) = (kept.len() > 1, kept.last_mut(), points.last()) {
        *last = *end;
    }
    kept
}
