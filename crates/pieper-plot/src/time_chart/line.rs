//! How a series is drawn: its points, its colour, its dashes and its marker.

use crate::axes::Axes;
use crate::ink::{self, Ink};
use crate::scene::{Point, Scene, Stroke};

const DASHES: [&[f64]; 6] = [
    &[],
    &[9.0, 4.0],
    &[3.0, 2.5],
    &[11.0, 3.0, 2.5, 3.0],
    &[6.0, 2.5],
    &[1.5, 2.0, 6.0, 2.0],
];

/// Leaves out what no eye can see, so that long recordings stay small files: of the points in a
/// column half a pixel wide the first, the lowest, the highest and the last are kept.
pub(super) fn thinned(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    let column = |point: &Point| (2.0 * point[0]).floor();
    for run in points.chunk_by(|a, b| column(a) == column(b)) {
        if run.len() <= 4 {
            kept.extend(run);
            continue;
        }
        let by_height = |a: &usize, b: &usize| run[*a][1].total_cmp(&run[*b][1]);
        let lowest = (0..run.len()).min_by(by_height);
        let highest = (0..run.len()).max_by(by_height);
        let mut chosen = [Some(0), lowest, highest, Some(run.len() - 1)];
        chosen.sort_unstable();
        kept.extend(chosen.into_iter().flatten().map(|index| run[index]));
        kept.dedup();
    }
    // A line needs two ends; one moment is drawn as a short dash.
    if let [only] = kept[..] {
        return vec![[only[0] - 4.0, only[1]], [only[0] + 4.0, only[1]]];
    }
    kept
}

fn series_ink(index: usize) -> Ink {
    Ink::Series((index % usize::from(ink::SERIES)) as u8)
}

pub(super) fn stroke(index: usize) -> Stroke {
    Stroke::dashed(series_ink(index), 2.0, DASHES[index % DASHES.len()])
}

pub(super) fn marker(scene: &mut Scene, [x, y]: Point, index: usize) {
    let ink = series_ink(index);
    let rim = Some(Stroke::solid(Ink::Paper, 1.0));
    let at = |offsets: &[Point]| offsets.iter().map(|[dx, dy]| [x + dx, y + dy]).collect();
    match index % 6 {
        0 => scene.disc([x, y], 4.2, ink, rim),
        1 => scene.polygon(
            at(&[[-3.8, -3.8], [3.8, -3.8], [3.8, 3.8], [-3.8, 3.8]]),
            ink,
            rim,
        ),
        2 => scene.polygon(at(&[[0.0, -5.2], [4.8, 3.6], [-4.8, 3.6]]), ink, rim),
        3 => scene.polygon(
            at(&[[0.0, -5.4], [5.4, 0.0], [0.0, 5.4], [-5.4, 0.0]]),
            ink,
            rim,
        ),
        4 => scene.polygon(at(&[[0.0, 5.2], [4.8, -3.6], [-4.8, -3.6]]), ink, rim),
        _ => scene.disc([x, y], 3.6, Ink::Paper, Some(Stroke::solid(ink, 2.0))),
    }
}

/// The height of the line at the place `x`, where the line reaches.
pub(super) fn value_at(times: &[f64], values: &[f64], axes: &Axes, x: f64) -> Option<f64> {
    let after = times.iter().position(|&time| axes.x.at(time) >= x)?;
    let before = after.checked_sub(1)?;
    let [a, b] = [before, after].map(|k| axes.at([times[k], values[k]]));
    let share = (x - a[0]) / (b[0] - a[0]);
    Some(a[1] + share * (b[1] - a[1]))
}
