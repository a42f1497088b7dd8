//! Charts over time.

use pieper_plot::{Theme, TimeMark, time_chart};
use roxmltree::Document;

use crate::sample::chart;
use crate::svg::texts;

#[test]
fn what_cannot_be_drawn_is_refused_with_its_place() {
    type Spoil = fn(&mut pieper_plot::TimeChart);
    let cases: [(Spoil, &str); 6] = [
        (|c| c.times.clear(), "times"),
        (|c| c.times.swap(0, 1), "ascending"),
        (|c| c.panels.clear(), "series"),
        (
            |c| c.panels[1].series[0].values.truncate(3),
            "301 values were expected, 3 were given",
        ),
        (
            |c| c.panels[1].series[0].values[7] = f64::NAN,
            "series d: number 7 (from 0) is NaN",
        ),
        (|c| c.marks[3].time = f64::INFINITY, "mark 3"),
    ];
    for (spoil, expected) in cases {
        let mut chart = chart();
        spoil(&mut chart);
        let error = time_chart(&chart).unwrap_err();
        assert!(error.is_input());
        assert!(error.to_string().contains(expected), "{error}");
    }
}

#[test]
fn marks_too_close_for_two_labels_share_one() {
    let mut chart = chart();
    chart.marks = [1.0, 1.0, 1.01, 4.0]
        .into_iter()
        .enumerate()
        .map(|(label, time)| TimeMark {
            label: label.to_string(),
            time,
        })
        .collect();
    let svg = time_chart(&chart).unwrap().to_svg(Theme::Page);
    let document = Document::parse(&svg).unwrap();
    assert!(texts(&document).any(|text| text.text() == Some("0\u{2013}2")));
}

#[test]
fn long_recordings_stay_small_files() {
    let mut chart = chart();
    chart.times = (0..200_000).map(|k| 1e-4 * f64::from(k)).collect();
    let noise = chart.times.iter().map(|t| (1e5 * t).sin()).collect();
    chart.panels.truncate(1);
    chart.panels[0].series.truncate(1);
    chart.panels[0].series[0].values = noise;
    let svg = time_chart(&chart).unwrap().to_svg(Theme::Page);
    assert!(svg.len() < 200_000, "{}", svg.len());
}
