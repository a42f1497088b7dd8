//! Paths in space.

use pieper_plot::{PathViews, Space, Theme, path_views};
use roxmltree::{Document, Node};

use crate::sample::path;
use crate::svg::number;

/// Pixels per unit, across and up, read from the tick labels of a panel.
fn scales(panel: Node<'_, '_>) -> [f64; 2] {
    let mut levels: [Vec<(f64, f64)>; 2] = [vec![], vec![]];
    for text in panel.descendants().filter(|node| node.has_tag_name("text")) {
        let content = text.text().unwrap_or_default().replace('\u{2212}', "-");
        // Labels of marks are bold.
        if let (Ok(value), None) = (content.parse(), text.attribute("font-weight")) {
            match text.attribute("text-anchor") {
                Some("middle") => levels[0].push((value, number(text, "x"))),
                _ => levels[1].push((value, -number(text, "y"))),
            }
        }
    }
    levels.map(|ticks| {
        let [first, .., last] = ticks[..] else {
            panic!("an axis has two ticks");
        };
        (last.1 - first.1) / (last.0 - first.0)
    })
}

#[test]
fn projections_have_one_scale() {
    let flat = |views: PathViews| PathViews {
        path: views
            .path
            .iter()
            .map(|p| [2.0 * p[0], 0.3 * p[1], 0.1])
            .collect(),
        marks: vec![],
        ..views
    };
    let cases = [
        path(Space::Positions),
        path(Space::Directions),
        flat(path(Space::Positions)),
    ];
    for views in cases {
        let svg = path_views(&views).unwrap().to_svg(Theme::Standalone);
        let document = Document::parse(&svg).unwrap();
        let panels: Vec<[f64; 2]> = document
            .descendants()
            .filter(|node| {
                node.attribute("data-panel")
                    .is_some_and(|name| name.contains('-'))
            })
            .map(scales)
            .collect();
        assert_eq!(panels.len(), 3);
        for scale in panels.as_flattened() {
            let off = scale / panels[0][0] - 1.0;
            // Coordinates are written with two decimals.
            assert!(off.abs() < 1e-3, "{panels:?}");
        }
    }
}

#[test]
fn marks_that_coincide_share_a_label() {
    let svg = path_views(&path(Space::Positions))
        .unwrap()
        .to_svg(Theme::Page);
    let count = |label: &str| svg.matches(&format!(">{label}</text>")).count();
    assert_eq!([count("0, 1"), count("2\u{2013}4")], [4, 4]);
}

#[test]
fn what_cannot_be_drawn_is_refused_with_its_place() {
    let mut views = path(Space::Positions);
    views.path[3][1] = f64::NAN;
    assert!(
        path_views(&views)
            .unwrap_err()
            .to_string()
            .contains("path: number 10")
    );
    let mut views = path(Space::Positions);
    views.marks[2].at[0] = f64::INFINITY;
    assert!(
        path_views(&views)
            .unwrap_err()
            .to_string()
            .contains("mark 2")
    );
    views.path.clear();
    assert!(path_views(&views).unwrap_err().is_input());
}
