//! The report page.

use pieper_plot::{Matrix, Report, Section, Table};

use crate::sample;

fn report() -> String {
    let mut figures = Section::new("Figures <&>");
    for figure in sample::figures() {
        figures = figures.figure(&figure, "Caption with <script>alert('x')</script>");
    }
    let rows = (0..50).fold(Table::new("Angles", ["t", "q"]), |table, k| {
        table.row([k.to_string(), "-0.000".to_owned()])
    });
    Report::new("Title <b>&\"'")
        .lead("Lead & lead")
        .fact("Joints", "6 <")
        .section(figures)
        .section(Section::new("Data").matrices(vec![identity()]).table(rows))
        .to_html()
}

fn identity() -> Matrix {
    Matrix::of_numbers("T₆", "t < 1", &[[1.0, -0.000_01], [0.5, -1.0]], 4)
}

#[test]
fn the_page_needs_nothing_else() {
    let html = report().replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    for reference in [
        "http:",
        "https:",
        "src=",
        "<script",
        "@import",
        "url(",
        "<link rel=\"stylesheet\"",
    ] {
        assert!(!html.contains(reference), "{reference}");
    }
}

#[test]
fn text_is_never_markup() {
    let html = report();
    for text in [
        "Title &lt;b&gt;&amp;&quot;&#39;",
        "Lead &amp; lead",
        "6 &lt;",
        "&lt;script&gt;",
        "t &lt; 1",
    ] {
        assert!(html.contains(text), "{text}");
    }
}

#[test]
fn every_element_is_closed() {
    let html = report();
    let tags = [
        "section",
        "figure",
        "figcaption",
        "table",
        "tr",
        "td",
        "details",
        "nav",
        "svg",
        "g",
        "div",
    ];
    for tag in tags {
        let opened =
            html.matches(&format!("<{tag}>")).count() + html.matches(&format!("<{tag} ")).count();
        assert_eq!(opened, html.matches(&format!("</{tag}>")).count(), "{tag}");
    }
}

#[test]
fn long_tables_are_folded_and_matrices_have_true_minus_signs() {
    let html = report();
    assert!(html.contains("<summary>All 50 rows</summary>"));
    assert!(!html.contains("-0.000"));
    assert!(html.contains("<tr><td>1</td><td>0</td></tr><tr><td>0.5</td><td>\u{2212}1</td></tr>"));
}

#[test]
fn the_same_content_gives_the_same_bytes() {
    assert_eq!(report(), report());
}

#[test]
fn columns_of_words_are_marked_as_such() {
    let table = Table::new("Branches", ["number", "what becomes of it"])
        .words([1])
        .row(["1", "ends"]);
    let html = Report::new("Title")
        .section(Section::new("S").table(table))
        .to_html();
    assert!(html.contains("<th scope=\"col\">number</th><th scope=\"col\" class=\"words\">"));
    assert!(html.contains("<td>1</td><td class=\"words\">ends</td>"));
}
