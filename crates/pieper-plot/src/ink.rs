//! The colours by their job, each with a light and a dark form.
//!
//! Shapes name a job, never a colour: a style sheet decides. Series colours are those of Okabe and
//! Ito, darkened (light theme) or lightened (dark theme) where thin lines would have too little
//! contrast, and then checked by simulation: under each of the three kinds of colour-blindness any two
//! of the first six differ by 14 units of CIELAB or more. Dashes and markers tell series apart a
//! second time.

use std::fmt::Write as _;

/// What a stroke or a fill is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ink {
    Paper,
    Text,
    Muted,
    Axis,
    Grid,
    Wall,
    Path,
    Hidden,
    Shadow,
    Link,
    Edge,
    Joint,
    Cap,
    Slider,
    SliderCap,
    ToolX,
    ToolY,
    ToolZ,
    Series(u8),
}

/// How many series colours there are before they repeat.
pub(crate) const SERIES: u8 = 8;

/// One row per ink: name in style sheets, light, dark.
const TABLE: [(Ink, &str, &str, &str); 26] = [
    (Ink::Paper, "paper", "#ffffff", "#15181d"),
    (Ink::Text, "text", "#1d2228", "#e6e8eb"),
    (Ink::Muted, "muted", "#59626d", "#a3acb7"),
    (Ink::Axis, "axis", "#8a929c", "#6d7681"),
    (Ink::Grid, "grid", "#e1e5ea", "#343b45"),
    (Ink::Wall, "wall", "#f6f7f9", "#1b1f25"),
    (Ink::Path, "path", "#0072b2", "#56b4e9"),
    (Ink::Hidden, "hidden", "#8fbfdb", "#3f7394"),
    (Ink::Shadow, "shadow", "#cfd5dc", "#363d47"),
    (Ink::Link, "link", "#b4bfca", "#77838f"),
    (Ink::Edge, "edge", "#3b4550", "#0d0f12"),
    (Ink::Joint, "joint", "#e8a33d", "#d9952f"),
    (Ink::Cap, "cap", "#f9cf8b", "#f3bf6c"),
    (Ink::Slider, "slider", "#b4578c", "#b4578c"),
    (Ink::SliderCap, "slider-cap", "#e3a9c8", "#dd9cbf"),
    (Ink::ToolX, "tool-x", "#d55e00", "#ff8a4c"),
    (Ink::ToolY, "tool-y", "#009e73", "#3ccb9e"),
    (Ink::ToolZ, "tool-z", "#0072b2", "#56b4e9"),
    (Ink::Series(0), "series-0", "#005b99", "#4aa3dc"),
    (Ink::Series(1), "series-1", "#d55e00", "#ff8a4c"),
    (Ink::Series(2), "series-2", "#008a63", "#3ccb9e"),
    (Ink::Series(3), "series-3", "#cc79a7", "#e39ac9"),
    (Ink::Series(4), "series-4", "#7a4b1e", "#f2b632"),
    (Ink::Series(5), "series-5", "#4aa8e8", "#a5dbff"),
    (Ink::Series(6), "series-6", "#4d5560", "#c3cad2"),
    (Ink::Series(7), "series-7", "#b88000", "#c99a6b"),
];

impl Ink {
    fn row(self) -> (&'static str, &'static str) {
        let found = TABLE.iter().find(|row| row.0 == self);
        found.map_or(("text", "#1d2228"), |row| (row.1, row.2))
    }

    /// The name in class attributes and CSS variables.
    pub(crate) fn name(self) -> &'static str {
        self.row().0
    }

    /// The colour on white paper.
    pub(crate) fn light(self) -> &'static str {
        self.row().1
    }
}

/// `--pp-NAME:COLOUR;` for every ink, on light paper.
pub(crate) fn light_variables() -> String {
    variables(|row| row.2)
}

/// `--pp-NAME:COLOUR;` for every ink, on dark paper.
pub(crate) fn dark_variables() -> String {
    variables(|row| row.3)
}

fn variables(colour: impl Fn(&(Ink, &str, &'static str, &'static str)) -> &'static str) -> String {
    TABLE.iter().fold(String::new(), |mut out, row| {
        let _ = write!(out, "--pp-{}:{};", row.1, colour(row));
        out
    })
}

/// The rules that make shapes follow the variables of the page around them.
pub(crate) fn page_rules() -> String {
    rules(|row| format!("var(--pp-{})", row.1))
}

/// The rules that give shapes their colours on dark paper.
pub(crate) fn dark_rules() -> String {
    rules(|row| row.3.to_owned())
}

fn rules(colour: impl Fn(&(Ink, &str, &str, &str)) -> String) -> String {
    TABLE.iter().fold(String::new(), |mut out, row| {
        let (name, colour) = (row.1, colour(row));
        let _ = write!(
            out,
            ".pp-s-{name}{{stroke:{colour}}}.pp-f-{name}{{fill:{colour}}}"
        );
        out
    })
}
