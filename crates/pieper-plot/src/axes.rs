//! A flat panel: two scales, a grid, tick labels and axis names.

use crate::font;
use crate::ink::Ink;
use crate::scene::{Anchor, Form, Point, Rect, Scene, Stroke, Text};
use crate::ticks::Ticks;

/// The size of tick labels and legends; names of axes and marks are one larger.
pub(crate) const SMALL: f64 = 12.0;
pub(crate) const NORMAL: f64 = 13.0;

/// Values to picture coordinates along one axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    pub(crate) values: [f64; 2],
    pub(crate) places: [f64; 2],
}

impl Scale {
    pub(crate) fn at(&self, value: f64) -> f64 {
        let share = (value - self.values[0]) / (self.values[1] - self.values[0]);
        self.places[0] + share * (self.places[1] - self.places[0])
    }
}

/// A flat panel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axes {
    pub(crate) area: Rect,
    pub(crate) x: Scale,
    pub(crate) y: Scale,
}

impl Axes {
    pub(crate) fn new(area: Rect, x: [f64; 2], y: [f64; 2]) -> Self {
        let x = Scale {
            values: x,
            places: [area.left, area.right()],
        };
        let y = Scale {
            values: y,
            places: [area.bottom(), area.top],
        };
        Self { area, x, y }
    }

    pub(crate) fn at(&self, [x, y]: Point) -> Point {
        [self.x.at(x), self.y.at(y)]
    }

    /// The paper of the panel with its grid lines; data are drawn over it.
    pub(crate) fn ground(&self, scene: &mut Scene, x: &Ticks, y: &Ticks) {
        let Rect { left, top, .. } = self.area;
        let (right, bottom) = (self.area.right(), self.area.bottom());
        scene.shape(Form::Rect(self.area, 0.0), Some(Ink::Wall), None);
        for &value in &x.values {
            let at = self.x.at(value);
            scene.line([at, top], [at, bottom], Stroke::solid(Ink::Grid, 1.0));
        }
        for &value in &y.values {
            let at = self.y.at(value);
            let ink = if value == 0.0 { Ink::Axis } else { Ink::Grid };
            scene.line([left, at], [right, at], Stroke::solid(ink, 1.0));
        }
        scene.shape(
            Form::Rect(self.area, 0.0),
            None,
            Some(Stroke::solid(Ink::Axis, 1.0)),
        );
    }

    /// Tick labels and name under the panel.
    pub(crate) fn label_x(&self, scene: &mut Scene, ticks: &Ticks, name: &str) {
        let bottom = self.area.bottom();
        for (value, label) in ticks.values.iter().zip(ticks.labels()) {
            let at = [self.x.at(*value), bottom + 6.0 + SMALL];
            let text = Text::new(at, label, SMALL).anchor(Anchor::Middle);
            scene.text(text.ink(Ink::Muted));
        }
        let at = [self.area.center()[0], bottom + 26.0 + NORMAL];
        scene.text(Text::new(at, name, NORMAL).anchor(Anchor::Middle));
    }

    /// The room that tick labels and name take left of a panel.
    pub(crate) fn gutter(ticks: &Ticks) -> f64 {
        ticks.widest_label() + 18.0 + NORMAL + 12.0
    }

    /// Tick labels and name left of the panel.
    pub(crate) fn label_y(&self, scene: &mut Scene, ticks: &Ticks, name: &str) {
        let left = self.area.left;
        for (value, label) in ticks.values.iter().zip(ticks.labels()) {
            let at = [left - 7.0, self.y.at(*value) + font::HALF_DIGIT * SMALL];
            let text = Text::new(at, label, SMALL).anchor(Anchor::End);
            scene.text(text.ink(Ink::Muted));
        }
        let at = [left - ticks.widest_label() - 18.0, self.area.center()[1]];
        let name = font::fit(name, NORMAL, self.area.height + 20.0);
        let text = Text::new(at, name, NORMAL).anchor(Anchor::Middle);
        scene.text(text.upwards());
    }
}
