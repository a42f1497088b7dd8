//! A step sheet: headings, sentences, equations and matrices, in one form for every format.

mod html;
mod latex;
mod live;
mod markdown;
mod text;

use crate::form::Form;
use crate::names::Names;

/// A document to be printed.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Its title.
    pub title: String,
    /// What the formulas' quantities are called.
    pub names: Names,
    /// Its parts in order.
    pub blocks: Vec<Block>,
}

/// A part of a sheet.
#[derive(Clone, Debug)]
pub enum Block {
    /// A heading of level 1 (a section) or 2 (a step).
    Heading(u8, String),
    /// A paragraph.
    Text(Vec<Inline>),
    /// Points.
    List(Vec<Vec<Inline>>),
    /// `left = right`
    Equation(Form, Form),
    /// `left = [rows]`
    Matrix(Vec<Form>, Vec<Vec<Form>>),
    /// A table with its head.
    Table(Vec<Form>, Vec<Vec<Form>>),
}

/// A piece of a sentence.
#[derive(Clone, Debug)]
pub enum Inline {
    /// Words.
    Text(String),
    /// A formula.
    Math(Form),
    /// An equation.
    Equality(Form, Form),
}

/// The formats a sheet can be printed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// For a terminal.
    Text,
    /// Markdown with mathematics between dollar signs.
    Markdown,
    /// A LaTeX document.
    Latex,
    /// A self-contained page; its mathematics is MathML, which browsers draw themselves.
    Html,
}

impl Sheet {
    /// The sheet in a format.
    pub fn print(&self, format: Format) -> String {
        match format {
            Format::Text => text::print(self),
            Format::Markdown => markdown::print(self),
            Format::Latex => latex::print(self),
            Format::Html => html::print(self),
        }
    }
}

/// A sentence of words alone.
pub(crate) fn words(text: impl Into<String>) -> Vec<Inline> {
    vec![Inline::Text(text.into())]
}

/// A matrix fits on a page if no row has more characters than this, in plain text.
const MATRIX_WIDTH: usize = 78;

/// Whether a matrix fits on a page.
pub(crate) fn fits(rows: &[Vec<Form>], names: &Names) -> bool {
    let column = |at: usize| {
        let cells = rows.iter().filter_map(|row| row.get(at));
        cells
            .map(|cell| crate::print::text(cell, names).chars().count())
            .max()
            .unwrap_or(0)
    };
    (0..rows.first().map_or(0, Vec::len))
        .map(|at| column(at) + 2)
        .sum::<usize>()
        <= MATRIX_WIDTH
}
