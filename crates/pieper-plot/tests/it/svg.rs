//! Every figure as a file.

use pieper_plot::{Figure, Theme};
use roxmltree::{Document, Node};

use crate::sample;

pub(crate) fn number(node: Node<'_, '_>, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

pub(crate) fn texts<'a, 'input>(
    document: &'a Document<'input>,
) -> impl Iterator<Item = Node<'a, 'input>> {
    document
        .descendants()
        .filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "text")))
}

#[test]
fn files_are_well_formed_and_their_text_is_inside() {
    for figure in sample::figures() {
        for theme in [Theme::Standalone, Theme::Page] {
            let svg = figure.to_svg(theme);
            assert!(!svg.contains("NaN") && !svg.contains("inf"));
            check_inside(&Document::parse(&svg).unwrap());
        }
    }
}

/// Text is taken as wide as the widest common fonts would set it.
fn check_inside(document: &Document<'_>) {
    let view: Vec<f64> = document
        .root_element()
        .attribute("viewBox")
        .unwrap()
        .split(' ')
        .map(|side| side.parse().unwrap())
        .collect();
    let [left, top, width, height] = view[..] else {
        panic!("a view box has four numbers");
    };
    for text in texts(document) {
        let content = text.text().unwrap_or_default();
        let size = number(text, "font-size");
        let narrow = |c: char| " iljtfr.,'".contains(c);
        let long: f64 = content
            .chars()
            .map(|c| if narrow(c) { 0.4 } else { 0.62 })
            .sum();
        let long = long * size;
        let before = match text.attribute("text-anchor") {
            Some("middle") => long / 2.0,
            Some("end") => long,
            _ => 0.0,
        };
        let (x, y) = (number(text, "x"), number(text, "y"));
        let (from, to) = if text.has_attribute("transform") {
            assert!(x - size >= left && x <= left + width, "{content}");
            assert!(y - before >= top && y + before <= top + height, "{content}");
            continue;
        } else {
            (x - before, x - before + long)
        };
        assert!(
            from >= left && to <= left + width,
            "{content}: {from} to {to}"
        );
        assert!(
            y - 0.8 * size >= top && y + 0.2 * size <= top + height,
            "{content} at {y}"
        );
    }
}

#[test]
fn the_same_data_give_the_same_bytes() {
    let all = |figures: Vec<Figure>| -> Vec<String> {
        figures
            .iter()
            .map(|figure| figure.to_svg(Theme::Standalone))
            .collect()
    };
    assert_eq!(all(sample::figures()), all(sample::figures()));
    let [first, again] =
        [sample::figures(), sample::figures()].map(|all| all[0].to_png(1.0).unwrap());
    assert_eq!(first, again);
}

#[test]
fn a_page_decides_the_colours_of_its_figures() {
    for figure in sample::figures() {
        let svg = figure.to_svg(Theme::Page);
        let document = Document::parse(&svg).unwrap();
        for node in document.descendants() {
            assert!(!node.has_tag_name(("http://www.w3.org/2000/svg", "style")));
            for (attribute, prefix) in [("fill", "pp-f-"), ("stroke", "pp-s-")] {
                let colour = node.attribute(attribute).unwrap_or("none");
                let classes = node.attribute("class").unwrap_or_default();
                assert_eq!(colour != "none", classes.contains(prefix), "{classes}");
            }
        }
    }
}

#[test]
fn bitmaps_show_something_at_the_scale_asked_for() {
    for figure in sample::figures() {
        let png = figure.to_png(0.5).unwrap();
        let pixels = resvg::tiny_skia::Pixmap::decode_png(&png).unwrap();
        assert_eq!(pixels.width(), (figure.width() * 0.5).round() as u32);
        assert!((f64::from(pixels.height()) - figure.height() * 0.5).abs() <= 1.0);
        let white = |p: &&resvg::tiny_skia::PremultipliedColorU8| {
            [p.red(), p.green(), p.blue(), p.alpha()] == [255; 4]
        };
        let count = pixels.pixels().iter().filter(white).count();
        // Not blank, and mostly paper: a figure, not a black square.
        assert!(count > pixels.pixels().len() / 4, "{}", figure.title());
        assert!(
            count < pixels.pixels().len() * 99 / 100,
            "{}",
            figure.title()
        );
        assert!(pixels.pixels().iter().all(|p| p.alpha() == 255));
    }
}

#[test]
fn impossible_scales_are_refused() {
    let figure = &sample::figures()[0];
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY, 17.0] {
        assert!(figure.to_png(scale).unwrap_err().is_input());
    }
    assert!(figure.to_png(1e-6).unwrap_err().is_render());
}
