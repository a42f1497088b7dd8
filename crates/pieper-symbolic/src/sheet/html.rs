//! Sheets as a self-contained page. Browsers draw MathML themselves; nothing is fetched.

use super::{Block, Inline, Sheet};
use crate::form::Form;
use crate::names::Names;
use crate::print::{escape, mathml as formula};

const STYLE: &str = "\
:root{color-scheme:light dark;--ink:#1c2733;--paper:#fff;--soft:#5b6b7b;--line:#d5dce3;--band:#f3f6f9}
@media (prefers-color-scheme:dark){:root{--ink:#e4e9ee;--paper:#14181d;--soft:#9aa8b5;--line:#323c46;--band:#1c2229}}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,sans-serif}
main{max-width:60rem;margin:0 auto;padding:2.5rem 1.5rem 5rem}
h1{font-size:1.8rem;line-height:1.2;margin:0 0 1.2rem}
h2{font-size:1.25rem;margin:2.6rem 0 .8rem;padding-top:.8rem;border-top:1px solid var(--line)}
h3{font-size:1.05rem;margin:1.8rem 0 .5rem}
p{margin:.5rem 0}
math{font-size:1.06em}
.formula{margin:.45rem 0 .45rem 2.2rem;text-indent:-1.6rem;line-height:1.75}
.wide{overflow-x:auto;margin:.8rem 0;padding:.2rem 0}
table.dh{border-collapse:collapse;margin:.8rem 0}
table.dh th,table.dh td{padding:.25rem 1rem;text-align:center;border-bottom:1px solid var(--line)}
table.dh th{border-bottom:2px solid var(--soft);font-weight:600}
mtable.m{margin:0 .2em}
mtable.m mtd{padding:.2em .55em}
ul{margin:.4rem 0;padding-left:1.4rem}
@media print{main{max-width:none;padding:0}h2{break-after:avoid}}";

pub(super) fn print(sheet: &Sheet) -> String {
    let title = escape(&sheet.title);
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>{STYLE}</style></head>\n<body><main>\n<h1>{title}</h1>\n"
    );
    out.push_str(&blocks(sheet, ""));
    out.push_str("</main></body></html>\n");
    out
}

/// The parts of a sheet, something behind each equation.
pub(super) fn blocks(sheet: &Sheet, behind: &str) -> String {
    let names = &sheet.names;
    let mut out = String::new();
    for block in &sheet.blocks {
        match block {
            Block::Heading(1, text) => out.push_str(&format!("<h2>{}</h2>\n", escape(text))),
            Block::Heading(_, text) => out.push_str(&format!("<h3>{}</h3>\n", escape(text))),
            Block::Text(inlines) => out.push_str(&format!("<p>{}</p>\n", sentence(inlines, names))),
            Block::List(points) => {
                out.push_str("<ul>\n");
                points.iter().for_each(|point| {
                    out.push_str(&format!("<li>{}</li>\n", sentence(point, names)))
                });
                out.push_str("</ul>\n");
            }
            Block::Equation(left, right) => {
                out.push_str(&format!(
                    "<div class=\"formula\">{}{behind}</div>\n",
                    breakable(left, right, names)
                ));
            }
            Block::Matrix(left, rows) => {
                let left: Vec<String> = left.iter().map(|form| formula(form, names)).collect();
                out.push_str(&format!(
                    "<div class=\"wide\"><math display=\"block\"><mrow>{}<mo>=</mo>{}</mrow></math></div>\n",
                    left.join("<mo>=</mo>"),
                    matrix(rows, names)
                ));
            }
            Block::Table(head, rows) => {
                out.push_str("<div class=\"wide\"><table class=\"dh\"><thead>");
                out.push_str(&row("th", head, names));
                out.push_str("</thead><tbody>\n");
                rows.iter()
                    .for_each(|cells| out.push_str(&row("td", cells, names)));
                out.push_str("</tbody></table></div>\n");
            }
        }
    }
    out
}

fn math(inner: &str) -> String {
    format!("<math><mrow>{inner}</mrow></math>")
}

/// An equation whose terms are elements of their own: a browser breaks the line between them, not within.
fn breakable(left: &Form, right: &Form, names: &Names) -> String {
    let mut out = math(&format!("{}<mo>=</mo>", formula(left, names)));
    let terms: &[Form] = match right {
        Form::Sum(terms) => terms,
        one => std::slice::from_ref(one),
    };
    for (index, term) in terms.iter().enumerate() {
        let text = match (index, term) {
            (0, term) => formula(term, names),
            // The product below binds tighter than the sign, so it needs no brackets.
            (_, Form::Neg(inner)) => {
                format!("<mo form=\"infix\">&#8722;</mo>{}", grouped(inner, names))
            }
            (_, term) => format!("<mo form=\"infix\">+</mo>{}", formula(term, names)),
        };
        out.push(' ');
        out.push_str(&math(&text));
    }
    out
}

fn grouped(form: &Form, names: &Names) -> String {
    match form {
        Form::Sum(_) | Form::PlusMinus(..) => {
            format!("<mo>(</mo>{}<mo>)</mo>", formula(form, names))
        }
        form => formula(form, names),
    }
}

fn sentence(inlines: &[Inline], names: &Names) -> String {
    let one = |inline: &Inline| match inline {
        Inline::Text(text) => escape(text),
        Inline::Math(form) => math(&formula(form, names)),
        Inline::Equality(left, right) => math(&format!(
            "{}<mo>=</mo>{}",
            formula(left, names),
            formula(right, names)
        )),
    };
    inlines.iter().map(one).collect()
}

fn matrix(rows: &[Vec<Form>], names: &Names) -> String {
    let cell = |cell: &Form| format!("<mtd>{}</mtd>", formula(cell, names));
    let row = |row: &Vec<Form>| format!("<mtr>{}</mtr>", row.iter().map(cell).collect::<String>());
    let rows: String = rows.iter().map(row).collect();
    format!("<mo>[</mo><mtable class=\"m\">{rows}</mtable><mo>]</mo>")
}

fn row(tag: &str, cells: &[Form], names: &Names) -> String {
    let cell = |cell: &Form| format!("<{tag}>{}</{tag}>", math(&formula(cell, names)));
    format!("<tr>{}</tr>\n", cells.iter().map(cell).collect::<String>())
}
