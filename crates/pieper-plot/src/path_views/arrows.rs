//! Arrow heads that show which way a path runs.

use crate::ink::Ink;
use crate::scene::{Point, Scene, Stroke};

/// Distance between arrow heads along a stretch between marks.
const ARROWS: f64 = 240.0;
/// Shorter stretches have none.
const SHORT: f64 = 34.0;
/// How far arrow heads keep from marks and from each other.
const APART: f64 = 17.0;

/// Places and directions of arrow heads at equal distances along a line. A head that would cover
/// something at `taken` moves aside along the line, where there is room.
pub(super) fn places(line: &[Point], taken: &mut Vec<Point>) -> Vec<(Point, Point)> {
    let total: f64 = line.windows(2).map(|ends| distance(ends[0], ends[1])).sum();
    if total < SHORT {
        return Vec::new();
    }
    let count = (total / ARROWS).round().max(1.0);
    let spacing = total / count;
    let mut heads = Vec::new();
    for k in 0..count as u32 {
        let middle = (f64::from(k) + 0.5) * spacing;
        let shifts = [0.0, -0.1, 0.1, -0.2, 0.2, -0.3, 0.3];
        let places = shifts.map(|shift| along(line, middle + shift * spacing));
        let free = places
            .iter()
            .flatten()
            .find(|(at, _)| taken.iter().all(|other| distance(*at, *other) > APART));
        if let Some((at, way)) = free.or(places[0].as_ref()) {
            taken.push(*at);
            heads.push((*at, *way));
        }
    }
    heads
}

fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The place at a length along a line, and the line's direction there.
fn along(line: &[Point], length: f64) -> Option<(Point, Point)> {
    let mut left = length;
    for ends in line.windows(2) {
        let here = distance(ends[0], ends[1]);
        if left <= here && here > 0.0 {
            let way = [0, 1].map(|k| (ends[1][k] - ends[0][k]) / here);
            return Some(([0, 1].map(|k| ends[0][k] + left * way[k]), way));
        }
        left -= here;
    }
    None
}

pub(super) fn draw(scene: &mut Scene, at: Point, [x, y]: Point, ink: Ink) {
    let corner = |along: f64, across: f64| {
        [
            at[0] + along * x - across * y,
            at[1] + along * y + across * x,
        ]
    };
    let head = vec![
        corner(7.0, 0.0),
        corner(-5.0, 5.0),
        corner(-2.5, 0.0),
        corner(-5.0, -5.0),
    ];
    scene.polygon(head, ink, Some(Stroke::solid(Ink::Wall, 0.8)));
}
