//! Small data of the right shape.

use pieper_plot::{
    Arm, ArmJoint, ArmViews, Figure, JointKind, Panel, PathMark, PathViews, Series, Space,
    TimeChart, TimeMark, ToolFrame, arm_views, path_views, time_chart,
};

pub(crate) fn chart() -> TimeChart {
    let times: Vec<f64> = (0..=300).map(|k| 0.02 * f64::from(k)).collect();
    let wave = |turn: f64| times.iter().map(|t| 90.0 * (t + turn).sin()).collect();
    TimeChart {
        title: "Joints & \"angles\" <1>".into(),
        panels: vec![
            Panel::new(
                "Angle",
                "°",
                (0..9)
                    .map(|k| Series::new(format!("q{k}"), wave(f64::from(k))))
                    .collect(),
            ),
            Panel::new("Travel", "mm", vec![Series::new("d", wave(0.5))]),
        ],
        marks: (0..7)
            .map(|k| TimeMark {
                label: k.to_string(),
                time: f64::from(k),
            })
            .collect(),
        times,
    }
}

pub(crate) fn path(space: Space) -> PathViews {
    let path: Vec<[f64; 3]> = (0..=200)
        .map(|k| 0.05 * f64::from(k))
        .map(|t| {
            [
                t.sin() * (0.3 * t).cos(),
                t.cos() * (0.3 * t).cos(),
                (0.3 * t).sin(),
            ]
        })
        .collect();
    PathViews {
        title: "Path".into(),
        axes: ["x₀".into(), "y₀".into(), "z₀".into()],
        space,
        marks: [0, 0, 50, 50, 50, 120, 200]
            .into_iter()
            .enumerate()
            .map(|(label, index)| PathMark {
                label: label.to_string(),
                at: path[index],
            })
            .collect(),
        path,
    }
}

pub(crate) fn arms(count: usize) -> ArmViews {
    let arm = |k: usize| {
        let reach = 0.2 + 0.03 * k as f64;
        Arm {
            label: k.to_string(),
            note: format!("t = {k} s"),
            points: vec![[0.0; 3], [0.0, 0.0, 0.3], [reach, 0.1, 0.3]],
            joints: vec![
                ArmJoint {
                    at: [0.0; 3],
                    axis: [0.0, 0.0, 1.0],
                    kind: JointKind::Revolute,
                },
                ArmJoint {
                    at: [0.0, 0.0, 0.3],
                    axis: [0.0, 1.0, 0.0],
                    kind: JointKind::Revolute,
                },
                ArmJoint {
                    at: [0.0, 0.0, 0.3],
                    axis: [reach, 0.1, 0.0],
                    kind: JointKind::Prismatic,
                },
            ],
            tool: ToolFrame {
                at: [reach, 0.1, 0.3],
                axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            },
        }
    };
    ArmViews {
        title: "Arm".into(),
        arms: (0..count).map(arm).collect(),
        path: vec![[0.2, 0.1, 0.3], [0.4, 0.1, 0.3]],
    }
}

/// Residuals: numbers that need powers of ten.
fn tiny() -> TimeChart {
    let mut chart = chart();
    for series in chart.panels.iter_mut().flat_map(|panel| &mut panel.series) {
        series.values.iter_mut().for_each(|value| *value *= 3e-9);
    }
    chart.times.iter_mut().for_each(|time| *time *= 1e9);
    chart.marks.clear();
    chart
}

/// Long names, and marks that crowd.
fn awkward() -> TimeChart {
    let mut chart = chart();
    let long = "a name that nobody would give to anything, and yet it may be in a file ".repeat(4);
    chart.title.clone_from(&long);
    chart.panels[0].name.clone_from(&long);
    chart.panels[0].series[2].name.clone_from(&long);
    chart.panels[1].unit = "rad/s".into();
    for mark in &mut chart.marks {
        mark.label = format!("{} {}", mark.label, &long[..20]);
    }
    chart
}

/// One figure of every kind, with paths that have no extent among them.
pub(crate) fn figures() -> Vec<Figure> {
    let mut views = Vec::new();
    for space in [Space::Positions, Space::Directions] {
        let whole = path(space);
        let point = PathViews {
            path: vec![whole.path[0]; 3],
            marks: vec![],
            ..whole.clone()
        };
        let one = PathViews {
            path: vec![whole.path[0]],
            ..point.clone()
        };
        let line = (0..10).map(|k| [0.1 * f64::from(k), 0.0, 0.0]).collect();
        let line = PathViews {
            path: line,
            ..point.clone()
        };
        views.extend([whole, point, one, line]);
    }
    let far = path(Space::Positions);
    let far = PathViews {
        path: far
            .path
            .iter()
            .map(|p| p.map(|x| 1e-6 * x - 1234.5))
            .collect(),
        marks: vec![],
        ..far
    };
    views.push(far);
    let mut moment = chart();
    moment.times.truncate(1);
    for series in moment.panels.iter_mut().flat_map(|panel| &mut panel.series) {
        series.values.truncate(1);
    }
    let charts = [chart(), moment, tiny(), awkward()].map(|chart| time_chart(&chart).unwrap());
    let paths = views.iter().map(|views| path_views(views).unwrap());
    let arms = [1, 2, 7].map(|count| arm_views(&arms(count)).unwrap());
    charts.into_iter().chain(paths).chain(arms).collect()
}
