//! Scene to SVG text.
//!
//! Every shape carries its light colour as an attribute, which any viewer understands, and a class,
//! by which a style sheet replaces it: rules beat attributes.

use std::fmt::Write as _;

use crate::font;
use crate::ink::{self, Ink};
use crate::scene::{Anchor, Form, Item, Point, Rect, Scene, Shape, Stroke, Text, Turn, Weight};

/// Where the colours and the letters of a file come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    /// Light colours, dark ones where the viewer asks for them.
    Adaptive,
    /// The variables of the page around the picture.
    Page,
    /// Light colours, text as outlines: no font and no style sheet is needed.
    Outlined,
}

/// The size of titles.
const TITLE: f64 = 16.0;

/// Writes a scene; `above` is the height of the band over it that holds the title.
pub(crate) fn write(scene: &Scene, title: &str, above: f64, mode: Mode) -> String {
    let mut out = String::with_capacity(16 * 1024);
    let (width, height) = (scene.width, scene.height + above);
    let _ = write!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" viewBox="0 {top} {w} {h}" role="img" aria-label="{label}" font-family="{families}">"#,
        w = number(width),
        h = number(height),
        top = number(-above),
        label = escape(title),
        families = font::FAMILIES,
    );
    if mode == Mode::Adaptive {
        let _ = write!(
            out,
            "<style>@media (prefers-color-scheme:dark){{{}}}</style>",
            ink::dark_rules()
        );
    }
    if mode != Mode::Page {
        let paper = Form::Rect(Rect::new(0.0, -above, width, height), 0.0);
        shape(
            &mut out,
            &Shape {
                form: paper,
                fill: Some(Ink::Paper),
                stroke: None,
            },
        );
        let title = font::fit(title, TITLE * font::BOLDER, width - 32.0);
        let title = Text::new([16.0, -above + 27.0], title, TITLE).bold();
        text(&mut out, &title, mode);
    }
    for item in &scene.items {
        match item {
            Item::Open(name) => {
                let _ = write!(out, "\n<g data-panel=\"{}\">", escape(name));
            }
            Item::Close => out.push_str("</g>"),
            Item::Shape(it) => shape(&mut out, it),
            Item::Text(it) => text(&mut out, it, mode),
        }
    }
    out.push_str("\n</svg>");
    out
}

fn shape(out: &mut String, shape: &Shape) {
    out.push('\n');
    match &shape.form {
        Form::Polyline(points) => path(out, points, ""),
        Form::Polygon(points) => path(out, points, "Z"),
        Form::Circle([x, y], radius) => {
            let (x, y, r) = (number(*x), number(*y), number(*radius));
            let _ = write!(out, r#"<circle cx="{x}" cy="{y}" r="{r}""#);
        }
        Form::Rect(rect, corner) => {
            let _ = write!(
                out,
                r#"<rect x="{}" y="{}" width="{}" height="{}" rx="{}""#,
                number(rect.left),
                number(rect.top),
                number(rect.width),
                number(rect.height),
                number(*corner)
            );
        }
    }
    paint(out, shape.fill, shape.stroke);
    out.push_str("/>");
}

fn path(out: &mut String, points: &[Point], end: &str) {
    out.push_str("<path d=\"");
    for (index, [x, y]) in points.iter().enumerate() {
        let command = if index == 0 { 'M' } else { 'L' };
        let _ = write!(out, "{command}{} {}", number(*x), number(*y));
    }
    let _ = write!(out, "{end}\"");
}

fn paint(out: &mut String, fill: Option<Ink>, stroke: Option<Stroke>) {
    let fill_class = fill.map(|ink| format!("pp-f-{}", ink.name()));
    let stroke_class = stroke.map(|stroke| format!("pp-s-{}", stroke.ink.name()));
    let classes: Vec<String> = fill_class.into_iter().chain(stroke_class).collect();
    let _ = write!(out, r#" class="{}""#, classes.join(" "));
    let _ = write!(out, r#" fill="{}""#, fill.map_or("none", Ink::light));
    let Some(stroke) = stroke else { return };
    let _ = write!(
        out,
        r#" stroke="{}" stroke-width="{}" stroke-linejoin="round" stroke-linecap="{}""#,
        stroke.ink.light(),
        number(stroke.width),
        // Round ends would close the gaps of short dashes.
        if stroke.dash.is_empty() {
            "round"
        } else {
            "butt"
        }
    );
    if !stroke.dash.is_empty() {
        let dash: Vec<String> = stroke.dash.iter().map(|&d| number(d)).collect();
        let _ = write!(out, r#" stroke-dasharray="{}""#, dash.join(" "));
    }
}

fn text(out: &mut String, text: &Text, mode: Mode) {
    out.push('\n');
    if mode == Mode::Outlined {
        outlined(out, text);
    } else {
        lettered(out, text);
    }
}

fn lettered(out: &mut String, text: &Text) {
    let [x, y] = text.at.map(number);
    let _ = write!(
        out,
        r#"<text x="{x}" y="{y}" font-size="{}""#,
        number(text.size)
    );
    match text.anchor {
        Anchor::Start => {}
        Anchor::Middle => out.push_str(r#" text-anchor="middle""#),
        Anchor::End => out.push_str(r#" text-anchor="end""#),
    }
    if text.weight == Weight::Bold {
        out.push_str(r#" font-weight="600""#);
    }
    if text.turn == Turn::Upwards {
        let _ = write!(out, r#" transform="rotate(-90 {x} {y})""#);
    }
    paint(out, Some(text.ink), rim(text));
    if text.halo.is_some() {
        out.push_str(r#" paint-order="stroke""#);
    }
    let _ = write!(out, ">{}</text>", escape(&text.content));
}

fn outlined(out: &mut String, text: &Text) {
    let [x, y] = text.at;
    let width = font::width(&text.content, text.size);
    let start = match text.anchor {
        Anchor::Start => x,
        Anchor::Middle => x - width / 2.0,
        Anchor::End => x - width,
    };
    let data = font::outline(&text.content, text.size, [start, y]);
    let turn = match text.turn {
        Turn::Level => String::new(),
        Turn::Upwards => format!(r#" transform="rotate(-90 {} {})""#, number(x), number(y)),
    };
    if text.halo.is_some() {
        let _ = write!(out, r#"<path d="{data}"{turn}"#);
        paint(out, None, rim(text));
        out.push_str("/>");
    }
    let _ = write!(out, r#"<path d="{data}"{turn}"#);
    // The embedded font has one weight; a thin rim makes it bold.
    let bold = (text.weight == Weight::Bold).then(|| Stroke::solid(text.ink, text.size * 0.04));
    paint(out, Some(text.ink), bold);
    out.push_str("/>");
}

fn rim(text: &Text) -> Option<Stroke> {
    text.halo
        .map(|ground| Stroke::solid(ground, text.size * 0.3))
}

/// A coordinate with at most two decimals: finer than any screen, and free of rounding noise.
pub(crate) fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text {
        "-0" | "" => "0".to_owned(),
        text => text.to_owned(),
    }
}

/// Text as it stands in XML and HTML, in elements and in quoted attributes.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // XML allows no other control characters, not even escaped.
            '\t' | '\n' | '\r' => out.push(' '),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}
