//! A picture as data: shapes and lines of text in picture coordinates (x right, y down).

use crate::font;
use crate::ink::Ink;

/// A place in a picture.
pub(crate) type Point = [f64; 2];

/// The shapes of one picture, in drawing order.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) items: Vec<Item>,
}

#[derive(Clone, Debug)]
pub(crate) enum Item {
    /// Opens a named group: a panel, for readers of the file and for tests.
    Open(String),
    Close,
    Shape(Shape),
    Text(Text),
}

#[derive(Clone, Debug)]
pub(crate) struct Shape {
    pub(crate) form: Form,
    pub(crate) fill: Option<Ink>,
    pub(crate) stroke: Option<Stroke>,
}

#[derive(Clone, Debug)]
pub(crate) enum Form {
    Polyline(Vec<Point>),
    Polygon(Vec<Point>),
    Circle(Point, f64),
    Rect(Rect, f64),
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Stroke {
    pub(crate) ink: Ink,
    pub(crate) width: f64,
    pub(crate) dash: &'static [f64],
}

impl Stroke {
    pub(crate) const fn solid(ink: Ink, width: f64) -> Self {
        Self::dashed(ink, width, &[])
    }

    pub(crate) const fn dashed(ink: Ink, width: f64, dash: &'static [f64]) -> Self {
        Self { ink, width, dash }
    }
}

/// A line of text. `at` is on the baseline.
#[derive(Clone, Debug)]
pub(crate) struct Text {
    pub(crate) at: Point,
    pub(crate) content: String,
    pub(crate) size: f64,
    pub(crate) ink: Ink,
    pub(crate) anchor: Anchor,
    pub(crate) weight: Weight,
    pub(crate) turn: Turn,
    /// A rim in the colour of the ground, so that text reads where it crosses a line.
    pub(crate) halo: Option<Ink>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Weight {
    Normal,
    Bold,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Turn {
    Level,
    /// Reads from bottom to top, as beside a vertical axis.
    Upwards,
}

impl Text {
    pub(crate) fn new(at: Point, content: impl Into<String>, size: f64) -> Self {
        Self {
            at,
            content: content.into(),
            size,
            ink: Ink::Text,
            anchor: Anchor::Start,
            weight: Weight::Normal,
            turn: Turn::Level,
            halo: None,
        }
    }

    /// Text whose middle, in both directions, is at `center`.
    pub(crate) fn centered(center: Point, content: impl Into<String>, size: f64) -> Self {
        let at = [center[0], center[1] + font::HALF_DIGIT * size];
        Self::new(at, content, size).anchor(Anchor::Middle)
    }

    pub(crate) fn ink(self, ink: Ink) -> Self {
        Self { ink, ..self }
    }
    pub(crate) fn anchor(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }
    pub(crate) fn bold(self) -> Self {
        let weight = Weight::Bold;
        Self { weight, ..self }
    }
    pub(crate) fn upwards(self) -> Self {
        let turn = Turn::Upwards;
        Self { turn, ..self }
    }
    pub(crate) fn halo(self, ground: Ink) -> Self {
        let halo = Some(ground);
        Self { halo, ..self }
    }
}

impl Scene {
    /// An empty picture; its sides are whole numbers, so that bitmaps have no half-covered edge.
    pub(crate) fn new(width: f64, height: f64) -> Self {
        Self {
            width: width.ceil(),
            height: height.ceil(),
            items: Vec::new(),
        }
    }

    pub(crate) fn open(&mut self, name: impl Into<String>) {
        self.items.push(Item::Open(name.into()));
    }

    pub(crate) fn close(&mut self) {
        self.items.push(Item::Close);
    }

    pub(crate) fn text(&mut self, text: Text) {
        self.items.push(Item::Text(text));
    }

    pub(crate) fn line(&mut self, from: Point, to: Point, stroke: Stroke) {
        self.polyline(vec![from, to], stroke);
    }

    pub(crate) fn polyline(&mut self, points: Vec<Point>, stroke: Stroke) {
        self.shape(Form::Polyline(points), None, Some(stroke));
    }

    pub(crate) fn polygon(&mut self, points: Vec<Point>, fill: Ink, stroke: Option<Stroke>) {
        self.shape(Form::Polygon(points), Some(fill), stroke);
    }

    pub(crate) fn shape(&mut self, form: Form, fill: Option<Ink>, stroke: Option<Stroke>) {
        self.items.push(Item::Shape(Shape { form, fill, stroke }));
    }

    pub(crate) fn disc(&mut self, center: Point, radius: f64, fill: Ink, stroke: Option<Stroke>) {
        self.shape(Form::Circle(center, radius), Some(fill), stroke);
    }

    pub(crate) fn ring(&mut self, center: Point, radius: f64, stroke: Stroke) {
        self.shape(Form::Circle(center, radius), None, Some(stroke));
    }
}

/// An upright rectangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rect {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl Rect {
    pub(crate) const fn new(left: f64, top: f64, width: f64, height: f64) -> Self {
        Self {
            left,
            top,
            width,
            height,
        }
    }

    pub(crate) fn around(center: Point, width: f64, height: f64) -> Self {
        let left = center[0] - width / 2.0;
        Self::new(left, center[1] - height / 2.0, width, height)
    }

    pub(crate) fn right(&self) -> f64 {
        self.left + self.width
    }

    pub(crate) fn bottom(&self) -> f64 {
        self.top + self.height
    }

    pub(crate) fn center(&self) -> Point {
        [self.left + self.width / 2.0, self.top + self.height / 2.0]
    }

    pub(crate) fn holds(&self, other: &Rect) -> bool {
        other.left >= self.left
            && other.top >= self.top
            && other.right() <= self.right()
            && other.bottom() <= self.bottom()
    }

    pub(crate) fn overlap(&self, other: &Rect) -> f64 {
        let width = self.right().min(other.right()) - self.left.max(other.left);
        let height = self.bottom().min(other.bottom()) - self.top.max(other.top);
        width.max(0.0) * height.max(0.0)
    }

    /// How much of the stretch from `a` to `b` lies inside (Liang and Barsky's clipping).
    pub(crate) fn length_inside(&self, a: Point, b: Point) -> f64 {
        let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        let borders = [
            (-dx, a[0] - self.left),
            (dx, self.right() - a[0]),
            (-dy, a[1] - self.top),
            (dy, self.bottom() - a[1]),
        ];
        for (speed, room) in borders {
            if speed == 0.0 {
                if room < 0.0 {
                    return 0.0;
                }
            } else if speed < 0.0 {
                from = from.max(room / speed);
            } else {
                to = to.min(room / speed);
            }
        }
        (to - from).max(0.0) * dx.hypot(dy)
    }
}
