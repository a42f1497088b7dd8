//! Sheets for a terminal.

use super::{Block, Inline, Sheet};
use crate::form::Form;
use crate::names::Names;
use crate::print::text as formula;

/// Sentences break at this column.
const WIDTH: usize = 100;

pub(super) fn print(sheet: &Sheet) -> String {
    let names = &sheet.names;
    let mut out = format!(
        "{}\n{}\n",
        sheet.title,
        "=".repeat(sheet.title.chars().count())
    );
    let mut after_equation = false;
    for block in &sheet.blocks {
        let is_equation = matches!(block, Block::Equation(..));
        if !(is_equation && after_equation) {
            out.push('\n');
        }
        after_equation = is_equation;
        match block {
            Block::Heading(1, text) => {
                out.push_str(&format!("{text}\n{}\n", "-".repeat(text.chars().count())))
            }
            Block::Heading(_, text) => out.push_str(&format!("* {text}\n")),
            Block::Text(inlines) => out.push_str(&wrapped(&sentence(inlines, names), "", "")),
            Block::List(points) => {
                for point in points {
                    out.push_str(&wrapped(&sentence(point, names), "  - ", "    "));
                }
            }
            Block::Equation(left, right) => {
                out.push_str(&format!(
                    "  {} = {}\n",
                    formula(left, names),
                    formula(right, names)
                ));
            }
            Block::Matrix(left, rows) => out.push_str(&matrix(left, rows, names)),
            Block::Table(head, rows) => {
                let all = [std::slice::from_ref(head), rows].concat();
                for line in aligned(&all, names) {
                    out.push_str(&format!("  {}\n", line.trim_end()));
                }
            }
        }
    }
    out
}

fn sentence(inlines: &[Inline], names: &Names) -> String {
    let one = |inline: &Inline| match inline {
        Inline::Text(text) => text.clone(),
        Inline::Math(form) => formula(form, names),
        Inline::Equality(left, right) => {
            format!("{} = {}", formula(left, names), formula(right, names))
        }
    };
    inlines.iter().map(one).collect()
}

fn wrapped(text: &str, first: &str, next: &str) -> String {
    let (mut out, mut line) = (String::new(), first.to_owned());
    for word in text.split_whitespace() {
        let is_start = line.len() == first.len().min(next.len()) || line == first || line == next;
        if !is_start && line.chars().count() + 1 + word.chars().count() > WIDTH {
            out.push_str(&line);
            out.push('\n');
            line = next.to_owned();
        } else if !is_start {
            line.push(' ');
        }
        line.push_str(word);
    }
    out.push_str(&line);
    out.push('\n');
    out
}

fn aligned(rows: &[Vec<Form>], names: &Names) -> Vec<String> {
    let cells: Vec<Vec<String>> = rows
        .iter()
        .map(|row| row.iter().map(|cell| formula(cell, names)).collect())
        .collect();
    let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
    let width = |at: usize| {
        cells
            .iter()
            .filter_map(|row| row.get(at))
            .map(|cell| cell.chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let line = |row: &Vec<String>| {
        let padded = row.iter().zip(&widths);
        padded
            .map(|(cell, width)| format!("{cell:>width$}"))
            .collect::<Vec<_>>()
            .join("  ")
    };
    cells.iter().map(line).collect()
}

fn matrix(left: &[Form], rows: &[Vec<Form>], names: &Names) -> String {
    let left: Vec<String> = left.iter().map(|form| formula(form, names)).collect();
    let mut out = format!("  {} =\n", left.join(" = "));
    let lines = aligned(rows, names);
    for line in lines {
        out.push_str(&format!("    [ {line} ]\n"));
    }
    out
}
