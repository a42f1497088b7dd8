//! Labels of marked points: merged where points coincide, placed where nothing is covered.

use std::f64::consts::TAU;

use crate::axes::NORMAL;
use crate::font;
use crate::ink::Ink;
use crate::scene::{Point, Rect, Scene, Stroke, Text};

/// Marked points nearer than this in the picture share one label.
const COINCIDE: f64 = 7.0;
/// Distances of a label's middle from its point that are tried, nearest first.
const DISTANCES: [f64; 5] = [15.0, 20.0, 27.0, 36.0, 48.0];
/// Directions that are tried at each distance.
const DIRECTIONS: u32 = 24;

/// A marked point and its label.
#[derive(Clone, Debug)]
pub(crate) struct Tag {
    pub(crate) at: Point,
    pub(crate) text: String,
    /// Whether every mark of the label is on the far side of the sphere.
    pub(crate) hidden: bool,
}

/// One tag for each group of marks that coincide in the picture, in the order of first marks.
pub(crate) fn merge(marks: Vec<Tag>) -> Vec<Tag> {
    let mut groups: Vec<Vec<Tag>> = Vec::new();
    for mark in marks {
        let near = |group: &&mut Vec<Tag>| {
            let [a, b] = [group[0].at, mark.at];
            (a[0] - b[0]).hypot(a[1] - b[1]) < COINCIDE
        };
        match groups.iter_mut().find(near) {
            Some(group) => group.push(mark),
            None => groups.push(vec![mark]),
        }
    }
    groups
        .into_iter()
        .map(|group| Tag {
            at: group[0].at,
            hidden: group.iter().all(|mark| mark.hidden),
            text: join(
                &group
                    .iter()
                    .map(|mark| mark.text.as_str())
                    .collect::<Vec<_>>(),
            ),
        })
        .collect()
}

/// "0, 4" and, for three or more numbers in sequence, "3–6". A name that comes again is not repeated.
pub(crate) fn join(labels: &[&str]) -> String {
    let mut once: Vec<&str> = Vec::new();
    for label in labels {
        if !once.contains(label) {
            once.push(label);
        }
    }
    // Only what reads the same as a number: "01" is a name.
    let number = |label: &&str| {
        label
            .parse()
            .ok()
            .filter(|n: &i64| n.to_string() == **label)
    };
    let numbers: Option<Vec<i64>> = once.iter().map(number).collect();
    let Some(numbers) = numbers else {
        return once.join(", ");
    };
    let mut parts = Vec::new();
    for run in numbers.chunk_by(|a, b| a.checked_add(1) == Some(*b)) {
        match run {
            [first, _, .., last] => parts.push(format!("{first}\u{2013}{last}")),
            run => parts.extend(run.iter().map(i64::to_string)),
        }
    }
    parts.join(", ")
}

/// Draws dots and labels over the lines of a panel, inside `bounds`.
pub(crate) fn draw(scene: &mut Scene, tags: &[Tag], lines: &[Vec<Point>], bounds: &Rect) {
    let dots: Vec<Rect> = tags
        .iter()
        .map(|tag| Rect::around(tag.at, 12.0, 12.0))
        .collect();
    let mut taken: Vec<Rect> = Vec::new();
    for tag in tags {
        let (width, height) = (font::bold_width(&tag.text, NORMAL) + 4.0, NORMAL + 2.0);
        let place = |step: u32, distance: f64| {
            let (sin, cos) = (TAU * (f64::from(step) + 0.5) / f64::from(DIRECTIONS)).sin_cos();
            // Wide labels keep their edge, not their middle, at the distance.
            let reach = distance + (width / 2.0 - 8.0).max(0.0) * cos.abs();
            Rect::around(
                [tag.at[0] + reach * cos, tag.at[1] - distance * sin],
                width,
                height,
            )
        };
        let cost = |rect: &Rect, distance: f64| {
            let outside = if bounds.holds(rect) { 0.0 } else { 1e5 };
            let labels: f64 = taken.iter().map(|other| rect.overlap(other)).sum();
            let marks: f64 = dots.iter().map(|dot| rect.overlap(dot)).sum();
            let crossed: f64 = lines
                .iter()
                .flat_map(|line| line.windows(2))
                .map(|ends| rect.length_inside(ends[0], ends[1]))
                .sum();
            outside + 50.0 * labels + 20.0 * marks + 4.0 * crossed + distance
        };
        let best = DISTANCES
            .into_iter()
            .flat_map(|distance| (0..DIRECTIONS).map(move |step| (step, distance)))
            .map(|(step, distance)| (place(step, distance), distance))
            .map(|(rect, distance)| (cost(&rect, distance), rect, distance))
            .min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, rect, distance)) = best {
            if distance > DISTANCES[1] {
                scene.line(tag.at, rect.center(), Stroke::solid(Ink::Axis, 0.8));
            }
            taken.push(rect);
        }
    }
    for tag in tags {
        dot(scene, tag.at, tag.hidden);
    }
    for (tag, rect) in tags.iter().zip(&taken) {
        scene.text(
            Text::centered(rect.center(), &tag.text, NORMAL)
                .bold()
                .halo(Ink::Wall),
        );
    }
}

/// The sign of a marked point; hollow where it is on the far side.
pub(crate) fn dot(scene: &mut Scene, at: Point, hidden: bool) {
    let rim = Stroke::solid(Ink::Paper, 1.2);
    if hidden {
        scene.disc(at, 3.6, Ink::Paper, Some(Stroke::solid(Ink::Text, 1.3)));
    } else {
        scene.disc(at, 4.2, Ink::Text, Some(rim));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_join_as_people_write_them() {
        let cases: [(&[&str], &str); 9] = [
            (&["3"], "3"),
            (&["0", "4"], "0, 4"),
            (&["2", "3"], "2, 3"),
            (&["3", "4", "5", "6"], "3–6"),
            (&["0", "1", "3", "4", "5"], "0, 1, 3–5"),
            (&["pick", "2"], "pick, 2"),
            (&["above", "pick", "above"], "above, pick"),
            (&["01", "02"], "01, 02"),
            (&["9223372036854775807", "8"], "9223372036854775807, 8"),
        ];
        for (labels, expected) in cases {
            assert_eq!(join(labels), expected);
        }
    }
}
