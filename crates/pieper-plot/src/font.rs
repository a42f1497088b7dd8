//! The one embedded font: widths for placing labels, outlines for bitmaps.

use std::fmt::Write as _;
use std::sync::OnceLock;

use ttf_parser::{Face, OutlineBuilder};

static FACE: OnceLock<Option<Face<'static>>> = OnceLock::new();

/// The families figures ask a viewer for. All are as wide as the embedded font or narrower, so
/// places found with its widths hold.
pub(crate) const FAMILIES: &str =
    "system-ui, -apple-system, 'Segoe UI', Roboto, Helvetica, Arial, 'DejaVu Sans', sans-serif";

/// How much wider than the embedded font a viewer's bold letters may be.
pub(crate) const BOLDER: f64 = 1.12;

/// Half the height of a digit, in units of the font size: how far below its middle a line of text
/// has its baseline.
pub(crate) const HALF_DIGIT: f64 = 0.36;

fn face() -> Option<&'static Face<'static>> {
    FACE.get_or_init(|| Face::parse(include_bytes!("../assets/DejaVuSans-subset.ttf"), 0).ok())
        .as_ref()
}

/// The width of a line of text.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    match face() {
        Some(face) => {
            let units: u32 = text.chars().map(|c| u32::from(advance(face, c))).sum();
            f64::from(units) * size / f64::from(face.units_per_em())
        }
        None => 0.6 * size * text.chars().count() as f64,
    }
}

/// The width a line of bold text may have: viewers' bold letters are wider than the embedded font's.
pub(crate) fn bold_width(text: &str, size: f64) -> f64 {
    width(text, size) * BOLDER
}

/// The text, cut with an ellipsis where it is wider than `room`.
pub(crate) fn fit(text: &str, size: f64, room: f64) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let mut kept = text.to_owned();
    while kept.pop().is_some() && width(&kept, size) + size > room {}
    kept.truncate(kept.trim_end().len());
    kept.push('\u{2026}');
    kept
}

/// SVG path data of a line of text whose baseline starts at `origin`.
pub(crate) fn outline(text: &str, size: f64, origin: [f64; 2]) -> String {
    let Some(face) = face() else {
        return String::new();
    };
    let mut pen = Pen {
        data: String::new(),
        scale: size / f64::from(face.units_per_em()),
        origin,
    };
    for c in text.chars() {
        // Glyph 0 is the box that stands for a missing letter.
        face.outline_glyph(face.glyph_index(c).unwrap_or_default(), &mut pen);
        pen.origin[0] += f64::from(advance(face, c)) * pen.scale;
    }
    pen.data
}

fn advance(face: &Face<'_>, c: char) -> u16 {
    let glyph = face.glyph_index(c).unwrap_or_default();
    face.glyph_hor_advance(glyph).unwrap_or_default()
}

struct Pen {
    data: String,
    scale: f64,
    origin: [f64; 2],
}

impl Pen {
    fn push(&mut self, command: char, points: &[(f32, f32)]) {
        self.data.push(command);
        for &(x, y) in points {
            // Fonts count upwards, pictures downwards.
            let x = self.origin[0] + f64::from(x) * self.scale;
            let y = self.origin[1] - f64::from(y) * self.scale;
            let _ = write!(self.data, "{x:.3} {y:.3} ");
        }
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.push('M', &[(x, y)]);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.push('L', &[(x, y)]);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.push('Q', &[(x1, y1), (x, y)]);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.push('C', &[(x1, y1), (x2, y2), (x, y)]);
    }
    fn close(&mut self) {
        self.data.push('Z');
    }
}
