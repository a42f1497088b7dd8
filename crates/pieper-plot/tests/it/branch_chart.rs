//! Alternatives over time.

use pieper_plot::{BranchChart, BranchLine, Theme, branch_chart};
use roxmltree::Document;

use crate::svg::texts;

fn chart(joints: usize) -> BranchChart {
    let line = |lift: f64, is_chosen| BranchLine {
        times: vec![0.0, 0.5, 1.0],
        values: (0..joints)
            .map(|joint| vec![lift, joint as f64, 2.0 * lift])
            .collect(),
        is_chosen,
        dies: !is_chosen,
    };
    BranchChart {
        title: "Ways".into(),
        joints: (0..joints)
            .map(|joint| (format!("q{joint}"), "°".into()))
            .collect(),
        lines: vec![line(10.0, true), line(-30.0, false)],
        times: [0.0, 2.0],
    }
}

#[test]
fn every_joint_has_its_panel() {
    for joints in [1, 3, 4, 6, 7, 12] {
        let figure = branch_chart(&chart(joints)).unwrap();
        let svg = figure.to_svg(Theme::Page);
        let document = Document::parse(&svg).unwrap();
        for joint in 0..joints {
            let name = format!("q{joint}, °");
            assert!(
                texts(&document).any(|text| text.text() == Some(&name)),
                "{name}"
            );
        }
        assert!(figure.to_png(1.0).unwrap().len() > 1000);
    }
}

#[test]
fn what_cannot_be_drawn_is_refused_with_its_place() {
    type Spoil = fn(&mut BranchChart);
    let cases: [(Spoil, &str); 5] = [
        (|c| c.lines.clear(), "at least one motion was expected"),
        (
            |c| c.lines[1].times.swap(0, 1),
            "motion 1: moments in ascending order were expected",
        ),
        (
            |c| c.lines[0].values[2].truncate(1),
            "motion 0: a value for each joint and moment was expected",
        ),
        (
            |c| c.lines[0].values.truncate(1),
            "motion 0: a value for each joint and moment was expected",
        ),
        (|c| c.lines[1].values[0][1] = f64::NAN, "motion 1: number 1"),
    ];
    for (spoil, expected) in cases {
        let mut chart = chart(3);
        spoil(&mut chart);
        let error = branch_chart(&chart).unwrap_err();
        assert!(error.to_string().contains(expected), "{error}");
    }
}
