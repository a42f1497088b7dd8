//! The labels of marked moments, over the first panel.

use super::{TimeChart, TimeMark, WIDTH};
use crate::axes::{Axes, SMALL};
use crate::font;
use crate::ink::Ink;
use crate::labels;
use crate::scene::{Form, Rect, Scene, Stroke, Text};

/// The label of marks that stand close together.
struct Pill {
    places: Vec<f64>,
    labels: Vec<String>,
}

impl Pill {
    fn text(&self) -> String {
        let labels: Vec<&str> = self.labels.iter().map(String::as_str).collect();
        font::fit(&labels::join(&labels), SMALL, 200.0)
    }

    /// The frame around the label, inside the picture.
    fn frame(&self, y: f64) -> Rect {
        let middle = self.places.iter().sum::<f64>() / self.places.len() as f64;
        let width = (font::bold_width(&self.text(), SMALL) + 10.0).max(20.0);
        let middle = middle.clamp(2.0 + width / 2.0, WIDTH - 2.0 - width / 2.0);
        Rect::around([middle, y], width, 20.0)
    }
}

/// The labels of marks, in small frames on the upper ends of their lines.
pub(super) fn draw(scene: &mut Scene, chart: &TimeChart, axes: &Axes) {
    let y = axes.area.top - 14.0;
    let mut marks: Vec<&TimeMark> = chart.marks.iter().collect();
    marks.sort_by(|a, b| a.time.total_cmp(&b.time));
    let mut pills: Vec<Pill> = Vec::new();
    for mark in marks {
        let mut pill = Pill {
            places: vec![axes.x.at(mark.time)],
            labels: vec![mark.label.clone()],
        };
        // A label that would touch the one before it joins it, which may then touch the next.
        while let Some(last) = pills.pop_if(|last| last.frame(y).right() + 2.0 > pill.frame(y).left)
        {
            pill.places.splice(0..0, last.places);
            pill.labels.splice(0..0, last.labels);
        }
        pills.push(pill);
    }
    for pill in pills {
        let frame = pill.frame(y);
        let rim = Stroke::solid(Ink::Muted, 1.0);
        scene.shape(Form::Rect(frame, 10.0), Some(Ink::Paper), Some(rim));
        scene.text(Text::centered(frame.center(), pill.text(), SMALL).bold());
    }
}
