//! Rows of samples with their names, broken where the picture ends.

use crate::axes::SMALL;
use crate::font;
use crate::scene::{Scene, Text};

/// The height of a row.
pub(crate) const ROW: f64 = 24.0;
const GAP: f64 = 24.0;

/// Left edge and row of each of a sequence of entries, between two borders.
fn flow(widths: impl IntoIterator<Item = f64>, [left, right]: [f64; 2]) -> Vec<(f64, usize)> {
    let (mut x, mut row) = (left, 0);
    let mut places = Vec::new();
    for width in widths {
        if x + width > right && x > left {
            (x, row) = (left, row + 1);
        }
        places.push((x, row));
        x += width + GAP;
    }
    places
}

/// Draws a sample from a left edge, around a middle height.
type Sample<'a> = Box<dyn Fn(&mut Scene, f64, f64) + 'a>;

/// An entry: the width of its sample, what draws it, and a name.
pub(crate) struct Entry<'a> {
    width: f64,
    sample: Sample<'a>,
    name: String,
}

impl<'a> Entry<'a> {
    pub(crate) fn new(
        width: f64,
        name: impl Into<String>,
        sample: impl Fn(&mut Scene, f64, f64) + 'a,
    ) -> Self {
        Self {
            width,
            sample: Box::new(sample),
            name: name.into(),
        }
    }

    fn whole(&self) -> f64 {
        self.width + 7.0 + font::width(&self.name, SMALL)
    }

    /// The same entry with a name that fits between the borders.
    pub(crate) fn fitted(mut self, [left, right]: [f64; 2]) -> Self {
        self.name = font::fit(&self.name, SMALL, right - left - self.width - 7.0);
        self
    }
}

/// How high the entries will be.
pub(crate) fn height(entries: &[Entry<'_>], borders: [f64; 2]) -> f64 {
    let places = flow(entries.iter().map(Entry::whole), borders);
    places
        .last()
        .map_or(0.0, |(_, row)| ROW * (*row as f64 + 1.0))
}

/// Draws the entries, the first row's upper edge at `top`.
pub(crate) fn draw(scene: &mut Scene, entries: &[Entry<'_>], borders: [f64; 2], top: f64) {
    let places = flow(entries.iter().map(Entry::whole), borders);
    for (entry, (x, row)) in entries.iter().zip(places) {
        let y = top + ROW * (row as f64 + 0.5);
        (entry.sample)(scene, x, y);
        let at = [x + entry.width + 7.0, y + font::HALF_DIGIT * SMALL];
        scene.text(Text::new(at, &entry.name, SMALL));
    }
}
