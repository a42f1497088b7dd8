//! Sheets as a LaTeX document that compiles as it is.

use super::{Block, Inline, Sheet};
use crate::form::Form;
use crate::names::Names;
use crate::print::latex as formula;

const HEAD: &str = r"\documentclass[11pt,a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
\usepackage{amsmath}
\usepackage[margin=22mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt plus 2pt}
\setcounter{MaxMatrixCols}{12}
% Long formulas break at their signs, with the rest of the lines indented.
\newcommand{\formula}[1]{{\hangindent=3em\hangafter=1\raggedright$\displaystyle #1$\par}}
\relpenalty=200 \binoppenalty=100
";

pub(super) fn print(sheet: &Sheet) -> String {
    let names = &sheet.names;
    let title = escape(&sheet.title);
    let mut out =
        format!("{HEAD}\\begin{{document}}\n\\begin{{center}}\\LARGE {title}\\end{{center}}\n");
    for block in &sheet.blocks {
        out.push('\n');
        match block {
            Block::Heading(1, text) => out.push_str(&format!("\\section*{{{}}}\n", escape(text))),
            Block::Heading(_, text) => {
                out.push_str(&format!("\\subsection*{{{}}}\n", escape(text)))
            }
            Block::Text(inlines) => out.push_str(&format!("{}\n", sentence(inlines, names))),
            Block::List(points) => {
                out.push_str("\\begin{itemize}\\setlength{\\itemsep}{1pt}\n");
                points.iter().for_each(|point| {
                    out.push_str(&format!("\\item {}\n", sentence(point, names)))
                });
                out.push_str("\\end{itemize}\n");
            }
            Block::Equation(left, right) => {
                out.push_str(&format!(
                    "\\formula{{{} = {}}}\n",
                    formula(left, names),
                    formula(right, names)
                ));
            }
            Block::Matrix(left, rows) => {
                let left: Vec<String> = left.iter().map(|form| formula(form, names)).collect();
                out.push_str(&format!(
                    "\\[ {} = {} \\]\n",
                    left.join(" = "),
                    matrix(rows, names)
                ));
            }
            Block::Table(head, rows) => {
                out.push_str(&format!(
                    "\\begin{{center}}\\begin{{tabular}}{{{}}}\n",
                    "c".repeat(head.len())
                ));
                out.push_str(&row(head, names));
                out.push_str("\\hline\n");
                rows.iter()
                    .for_each(|cells| out.push_str(&row(cells, names)));
                out.push_str("\\end{tabular}\\end{center}\n");
            }
        }
    }
    out.push_str("\\end{document}\n");
    out
}

pub(super) fn matrix(rows: &[Vec<Form>], names: &Names) -> String {
    let row = |row: &Vec<Form>| {
        row.iter()
            .map(|cell| formula(cell, names))
            .collect::<Vec<_>>()
            .join(" & ")
    };
    let rows: Vec<String> = rows.iter().map(row).collect();
    format!(
        "\\begin{{bmatrix}} {} \\end{{bmatrix}}",
        rows.join(" \\\\ ")
    )
}

fn sentence(inlines: &[Inline], names: &Names) -> String {
    let one = |inline: &Inline| match inline {
        Inline::Text(text) => escape(text),
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
        .map(|cell| format!("${}$", formula(cell, names)))
        .collect();
    format!("{} \\\\\n", cells.join(" & "))
}

/// Words with LaTeX's special characters made harmless, and what is no Latin letter spelt out.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' => out.push_str("\\textbackslash{}"),
            '^' => out.push_str("\\textasciicircum{}"),
            '~' => out.push_str("\\textasciitilde{}"),
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => {
                out.push('\\');
                out.push(c);
            }
            c if c.is_ascii() || ('\u{a1}'..='\u{17f}').contains(&c) => out.push(c),
            _ => out.push('?'),
        }
    }
    out
}
