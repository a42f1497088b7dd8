//! The report: text, figures, matrices and tables in one HTML file that needs nothing else.

mod content;
mod style;

pub use content::{Matrix, Section, Table};

use std::fmt::Write as _;

use crate::svg::escape;

/// A report under construction.
///
/// Everything handed in is text, never markup: it is escaped. The page refers to no other file and
/// runs no script; it follows the reader's light or dark theme (a switch, or `data-theme` on the
/// `html` element, overrides it) and prints on white paper.
///
/// ```
/// use pieper_plot::{Matrix, Report, Section, Table};
///
/// let html = Report::new("Annin Robotics AR3")
///     .lead("Seven reference positions, one joint per second.")
///     .fact("Samples", "301")
///     .section(
///         Section::new("Poses")
///             .paragraph("The tool's frame in the base's.")
///             .matrices(vec![Matrix::of_numbers("T₆(0)", "t = 0 s", &[[1.0, 0.0], [0.0, 1.0]], 4)])
///             .table(Table::new("Joint angles", ["t, s", "q₁, °"]).row(["0", "0"]).row(["1", "−90"])),
///     )
///     .to_html();
/// assert!(html.starts_with("<!DOCTYPE html>"));
/// ```
#[derive(Clone, Debug)]
pub struct Report {
    title: String,
    lead: String,
    facts: Vec<(String, String)>,
    sections: Vec<Section>,
    footer: String,
}

impl Report {
    /// An empty report.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            lead: String::new(),
            facts: Vec::new(),
            sections: Vec::new(),
            footer: String::new(),
        }
    }

    /// The sentence or two under the title.
    #[must_use]
    pub fn lead(mut self, text: impl Into<String>) -> Self {
        self.lead = text.into();
        self
    }

    /// Adds a named value to the summary at the top.
    #[must_use]
    pub fn fact(mut self, name: impl Into<String>, value: impl Into<String>) -> Self {
        self.facts.push((name.into(), value.into()));
        self
    }

    /// Adds a section.
    #[must_use]
    pub fn section(mut self, section: Section) -> Self {
        self.sections.push(section);
        self
    }

    /// The line at the foot of the page, such as the command that made it.
    #[must_use]
    pub fn footer(mut self, text: impl Into<String>) -> Self {
        self.footer = text.into();
        self
    }

    /// The page; the same text for the same content, byte for byte.
    pub fn to_html(&self) -> String {
        let title = escape(&self.title);
        let mut out = String::with_capacity(256 * 1024);
        let _ = write!(
            out,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"color-scheme\" content=\"light dark\">\n\
             <title>{title}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>{}</style>\n\
             </head>\n<body>\n",
            style::sheet()
        );
        self.write_header(&mut out, &title);
        self.write_contents(&mut out);
        out.push_str("<main>\n");
        let mut figures = 0;
        for (index, section) in self.sections.iter().enumerate() {
            section.write(&mut out, index + 1, &mut figures);
        }
        out.push_str("</main>\n");
        if !self.footer.is_empty() {
            let _ = writeln!(out, "<footer>{}</footer>", escape(&self.footer));
        }
        out.push_str("</body>\n</html>\n");
        out
    }

    fn write_header(&self, out: &mut String, title: &str) {
        let _ = write!(out, "<header>\n{}<h1>{title}</h1>\n", style::SWITCH);
        if !self.lead.is_empty() {
            let _ = writeln!(out, "<p class=\"lead\">{}</p>", escape(&self.lead));
        }
        if !self.facts.is_empty() {
            out.push_str("<dl>\n");
            for (name, value) in &self.facts {
                let _ = writeln!(
                    out,
                    "<div><dt>{}</dt><dd>{}</dd></div>",
                    escape(name),
                    escape(value)
                );
            }
            out.push_str("</dl>\n");
        }
        out.push_str("</header>\n");
    }

    fn write_contents(&self, out: &mut String) {
        if self.sections.len() < 2 {
            return;
        }
        out.push_str("<nav aria-label=\"Contents\">\n<ol>\n");
        for (index, section) in self.sections.iter().enumerate() {
            let (number, heading) = (index + 1, escape(section.heading()));
            let _ = writeln!(out, "<li><a href=\"#section-{number}\">{heading}</a></li>");
        }
        out.push_str("</ol>\n</nav>\n");
    }
}
