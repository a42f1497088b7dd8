//! Sections and what stands in them.

use std::fmt::Write as _;

use crate::figure::{Figure, Theme};
use crate::svg::escape;
use crate::ticks::minus;

/// Tables up to this length are shown; longer ones are folded under their first rows.
const LONG: usize = 14;
/// How many rows of a long table are shown.
const SHOWN: usize = 6;

/// Matrices of at most so many characters in a row stand three abreast, wider ones two.
const NARROW: usize = 20;

/// A section of a report: a heading and its content, in the order it was added.
#[derive(Clone, Debug)]
pub struct Section {
    heading: String,
    content: Vec<Content>,
}

#[derive(Clone, Debug)]
enum Content {
    Paragraph(String),
    Warnings(Vec<String>),
    Figure { svg: String, caption: String },
    Matrices(Vec<Matrix>),
    Table(Table),
}

impl Section {
    /// An empty section.
    pub fn new(heading: impl Into<String>) -> Self {
        Self {
            heading: heading.into(),
            content: Vec::new(),
        }
    }

    /// Adds a paragraph.
    #[must_use]
    pub fn paragraph(self, text: impl Into<String>) -> Self {
        self.with(Content::Paragraph(text.into()))
    }

    /// Adds a list of warnings, set off from the text.
    #[must_use]
    pub fn warnings<S: Into<String>>(self, texts: impl IntoIterator<Item = S>) -> Self {
        self.with(Content::Warnings(texts.into_iter().map(S::into).collect()))
    }

    /// Adds a figure; figures are numbered through the report.
    #[must_use]
    pub fn figure(self, figure: &Figure, caption: impl Into<String>) -> Self {
        let svg = figure.to_svg(Theme::Page);
        let caption = caption.into();
        self.with(Content::Figure { svg, caption })
    }

    /// Adds matrices, side by side where there is room.
    #[must_use]
    pub fn matrices(self, matrices: Vec<Matrix>) -> Self {
        self.with(Content::Matrices(matrices))
    }

    /// Adds a table; the rows of a long one are folded.
    #[must_use]
    pub fn table(self, table: Table) -> Self {
        self.with(Content::Table(table))
    }

    fn with(mut self, content: Content) -> Self {
        self.content.push(content);
        self
    }

    pub(super) fn heading(&self) -> &str {
        &self.heading
    }

    pub(super) fn write(&self, out: &mut String, number: usize, figures: &mut usize) {
        let heading = escape(&self.heading);
        let _ = writeln!(out, "<section id=\"section-{number}\">\n<h2>{heading}</h2>");
        for content in &self.content {
            match content {
                Content::Paragraph(text) => {
                    let _ = writeln!(out, "<p>{}</p>", escape(text));
                }
                Content::Warnings(texts) => {
                    out.push_str("<ul class=\"warnings\">\n");
                    for text in texts {
                        let _ = writeln!(out, "<li>{}</li>", escape(text));
                    }
                    out.push_str("</ul>\n");
                }
                Content::Figure { svg, caption } => {
                    *figures += 1;
                    let _ = writeln!(
                        out,
                        "<figure><div class=\"sheet\">{svg}</div>\n<figcaption><b>Figure {figures}.</b> {}</figcaption></figure>",
                        escape(caption)
                    );
                }
                Content::Matrices(matrices) => {
                    let class = match matrices.iter().any(|matrix| matrix.width() > NARROW) {
                        true => "matrices general",
                        false => "matrices",
                    };
                    let _ = writeln!(out, "<div class=\"{class}\">");
                    matrices.iter().for_each(|matrix| matrix.write(out));
                    out.push_str("</div>\n");
                }
                Content::Table(table) => table.write(out),
            }
        }
        out.push_str("</section>\n");
    }
}

/// A matrix with its name, typeset with brackets.
#[derive(Clone, Debug)]
pub struct Matrix {
    name: String,
    note: String,
    rows: Vec<Vec<String>>,
}

impl Matrix {
    /// A matrix of entries as they are to be read. `note` says when or where; it may be empty.
    pub fn new(name: impl Into<String>, note: impl Into<String>, rows: Vec<Vec<String>>) -> Self {
        Self {
            name: name.into(),
            note: note.into(),
            rows,
        }
    }

    /// A matrix of numbers, with at most `decimals` decimals; whole numbers are written without.
    pub fn of_numbers<const N: usize>(
        name: impl Into<String>,
        note: impl Into<String>,
        rows: &[[f64; N]],
        decimals: usize,
    ) -> Self {
        let write = |value: &f64| {
            let text = format!("{value:.decimals$}");
            let short = if text.contains('.') {
                text.trim_end_matches('0').trim_end_matches('.')
            } else {
                &text
            };
            minus(short)
        };
        let rows = rows.iter().map(|row| row.iter().map(write).collect());
        Self::new(name, note, rows.collect())
    }

    /// The characters in a row, every column as wide as its widest entry.
    fn width(&self) -> usize {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let widest = |column: usize| {
            let entries = self.rows.iter().filter_map(|row| row.get(column));
            entries
                .map(|entry| entry.chars().count())
                .max()
                .unwrap_or(0)
        };
        (0..columns).map(widest).sum()
    }

    fn write(&self, out: &mut String) {
        let _ = write!(
            out,
            "<div class=\"matrix\"><span class=\"name\">{}",
            escape(&self.name)
        );
        if !self.note.is_empty() {
            let _ = write!(out, "<small>{}</small>", escape(&self.note));
        }
        out.push_str("</span><table>");
        for row in &self.rows {
            out.push_str("<tr>");
            for entry in row {
                let _ = write!(out, "<td>{}</td>", escape(entry));
            }
            out.push_str("</tr>");
        }
        out.push_str("</table></div>\n");
    }
}

/// A table with a line of headings.
#[derive(Clone, Debug)]
pub struct Table {
    caption: String,
    head: Vec<String>,
    rows: Vec<Vec<String>>,
    /// Columns of words rather than numbers.
    words: Vec<usize>,
}

impl Table {
    /// A table without rows.
    pub fn new<S: Into<String>>(
        caption: impl Into<String>,
        head: impl IntoIterator<Item = S>,
    ) -> Self {
        Self {
            caption: caption.into(),
            head: head.into_iter().map(S::into).collect(),
            rows: Vec::new(),
            words: Vec::new(),
        }
    }

    /// Makes some columns, counted from 0, columns of words: set from the left, long ones in several lines.
    #[must_use]
    pub fn words(mut self, columns: impl IntoIterator<Item = usize>) -> Self {
        self.words.extend(columns);
        self
    }

    /// Adds a row. Numbers keep the plain minus sign, so that cells paste into a spreadsheet; only a
    /// rounded "-0.00" loses it.
    #[must_use]
    pub fn row<S: Into<String>>(mut self, cells: impl IntoIterator<Item = S>) -> Self {
        self.rows.push(
            cells
                .into_iter()
                .map(|cell| unsigned_zero(cell.into()))
                .collect(),
        );
        self
    }

    fn write(&self, out: &mut String) {
        if self.rows.len() <= LONG {
            self.write_rows(out, &self.rows, &self.caption);
            return;
        }
        let first = format!(
            "{} (first {SHOWN} of {} rows)",
            self.caption,
            self.rows.len()
        );
        self.write_rows(out, &self.rows[..SHOWN], &first);
        let _ = writeln!(
            out,
            "<details><summary>All {} rows</summary>",
            self.rows.len()
        );
        self.write_rows(out, &self.rows, &self.caption);
        out.push_str("</details>\n");
    }

    fn write_rows(&self, out: &mut String, rows: &[Vec<String>], caption: &str) {
        let _ = write!(
            out,
            "<div class=\"wide\"><table class=\"data\"><caption>{}</caption>\n<thead><tr>",
            escape(caption)
        );
        let class = |column: usize| match self.words.contains(&column) {
            true => " class=\"words\"",
            false => "",
        };
        for (column, cell) in self.head.iter().enumerate() {
            let (class, text) = (class(column), escape(cell));
            let _ = write!(out, "<th scope=\"col\"{class}>{text}</th>");
        }
        out.push_str("</tr></thead>\n<tbody>\n");
        for row in rows {
            out.push_str("<tr>");
            for (column, cell) in row.iter().enumerate() {
                let _ = write!(out, "<td{}>{}</td>", class(column), escape(cell));
            }
            out.push_str("</tr>\n");
        }
        out.push_str("</tbody></table></div>\n");
    }
}

fn unsigned_zero(cell: String) -> String {
    match cell.strip_prefix('-') {
        Some(digits) if digits.parse() == Ok(0.0) => digits.to_owned(),
        _ => cell,
    }
}
