//! Sheets as Markdown with mathematics between dollar signs, as GitHub and notebooks draw it.

use super::{Block, Inline, Sheet};
use crate::form::Form;
use crate::names::Names;
use crate::print::latex as formula;

pub(super) fn print(sheet: &Sheet) -> String {
    let names = &sheet.names;
    let mut out = format!("# {}\n", sheet.title);
    for block in &sheet.blocks {
        out.push('\n');
        match block {
            Block::Heading(level, text) => {
                out.push_str(&format!("{} {text}\n", "#".repeat(usize::from(*level) + 1)))
            }
            Block::Text(inlines) => out.push_str(&format!("{}\n", sentence(inlines, names))),
            Block::List(points) => {
                points
                    .iter()
                    .for_each(|point| out.push_str(&format!("- {}\n", sentence(point, names))));
            }
            Block::Equation(left, right) => {
                out.push_str(&format!(
                    "$$ {} = {} $$\n",
                    formula(left, names),
                    formula(right, names)
                ));
            }
            Block::Matrix(left, rows) => {
                let left: Vec<String> = left.iter().map(|form| formula(form, names)).collect();
                out.push_str(&format!(
                    "$$ {} = {} $$\n",
                    left.join(" = "),
                    super::latex::matrix(rows, names)
                ));
            }
            Block::Table(head, rows) => {
                out.push_str(&row(head, names));
                out.push_str(&format!("|{}\n", "---|".repeat(head.len())));
                rows.iter()
                    .for_each(|cells| out.push_str(&row(cells, names)));
            }
        }
    }
    out
}

fn sentence(inlines: &[Inline], names: &Names) -> String {
    let one = |inline: &Inline| match inline {
        Inline::Text(text) => text.clone(),
        Inline::Math(form) => format!("${}$", formula(form, names)),
        Inline::Equality(left, right) => {
            format!("${} = {}$", formula(left, names), formula(right, names))
        }
    };
    inlines.iter().map(one).collect()
}

fn row(cells: &[Form], names: &Names) -> String {
    let cells: Vec<String> = cells
        .iter()
        .map(|cell| format!(" ${}$ ", formula(cell, names)))
        .collect();
    format!("|{}|\n", cells.join("|"))
}
