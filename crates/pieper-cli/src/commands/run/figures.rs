//! The figures of a run.

use pieper::model::Chain;
use pieper::motion::State;
use pieper::motion::{End, Track};
use pieper_plot::{
    ArmViews, BranchChart, BranchLine, Figure, Panel, PathMark, PathViews, Series, Space,
    TimeChart, TimeMark, arm_views, branch_chart, path_views, time_chart,
};

use super::motion::Path;
use super::progress::Progress;
use super::recording::Mark;
use super::{Run, certificate, names, skeleton};
use crate::error::Failure;

/// More marks than these are thinned out: their labels would cover what they name.
const MOST_ARMS: usize = 16;
const MOST_MOMENTS: usize = 24;
const MOST_PLACES: usize = 24;

/// A figure, the name of its files, and what its caption says.
pub(super) struct Drawing {
    pub(super) name: &'static str,
    pub(super) figure: Figure,
    pub(super) caption: String,
}

/// Every figure, in the order of the report.
pub(super) fn draw(run: &Run, progress: &mut Progress) -> Result<Vec<Drawing>, Failure> {
    let mut drawn = Vec::new();
    let mut add = |name, caption: String, figure: pieper_plot::Result<Figure>| {
        let figure = figure.map_err(|error| Failure::input(format!("{name}: {error}")))?;
        drawn.push(Drawing {
            name,
            figure,
            caption,
        });
        progress.advance();
        Ok::<(), Failure>(())
    };
    let shown = |most: usize| thinned_note(run, most);
    let caption = format!(
        "Joint values over time; dashed lines mark the reference positions{}.",
        shown(MOST_MOMENTS)
    );
    if let Some(path) = &run.path {
        let caption = "Joint values of every branch over the time of the path. A branch ends where it meets another one, \
            where the path leaves its reach, or at a joint’s limit; crosses mark these ends."
            .to_owned();
        add(certificate::FIGURE, caption, branches(run, path))?;
    }
    add("joints", caption, joints(run))?;
    add(
        "rates",
        "Rates of the joints over time.".to_owned(),
        rates(run),
    )?;
    let caption = format!(
        "The arm at the reference positions{}, with the frame of its tool and the path of the tool’s point.",
        shown(MOST_ARMS)
    );
    add("arm", caption, arm(run))?;
    let caption = format!(
        "Path of the tool’s point in the frame of the base: axonometric view and projections of one scale. \
         Dots are the reference positions{}.",
        shown(MOST_PLACES)
    );
    add("path", caption, path(run, None))?;
    for (column, name) in ["i", "j", "k"].into_iter().enumerate() {
        let axis = ["x", "y", "z"][column];
        let caption = format!(
            "Path of the unit vector {name}, the direction of the tool’s {axis} axis, on the unit sphere."
        );
        add(name, caption, path(run, Some((column, name))))?;
    }
    Ok(drawn)
}

/// What a caption adds where not every mark is shown.
fn thinned_note(run: &Run, most: usize) -> String {
    let (kept, all) = (
        run.recording.some_marks(most).len(),
        run.recording.marks.len(),
    );
    match kept == all {
        true => String::new(),
        false => format!(" ({kept} of {all})"),
    }
}

fn title(run: &Run, what: &str) -> String {
    format!("{}: {what}", run.robot.name)
}

/// A panel for the joints that turn and one for those that slide; `value` gives a sample's values of a joint.
fn panels(
    chain: &Chain,
    value: impl Fn(usize) -> Vec<f64>,
    what: [&str; 2],
    per: &str,
) -> Vec<Panel> {
    let panel = |angular: bool| {
        let (name, unit, factor) = match angular {
            true => (what[0], "°", 180.0 / std::f64::consts::PI),
            false => (what[1], "mm", 1000.0),
        };
        let joints = chain.variables().iter().enumerate();
        let joints = joints.filter(|(_, variable)| variable.kind.is_angular() == angular);
        let series = joints.map(|(index, variable)| {
            let values = value(index).into_iter().map(|x| x * factor).collect();
            Series::new(names::joint(index, variable), values)
        });
        Panel::new(name, format!("{unit}{per}"), series.collect())
    };
    let panels = [panel(true), panel(false)];
    panels
        .into_iter()
        .filter(|panel| !panel.series.is_empty())
        .collect()
}

fn moments(run: &Run) -> Vec<TimeMark> {
    let mark = |mark: &Mark| TimeMark {
        label: mark.label.clone(),
        time: run.recording.time(mark),
    };
    let marks = run.recording.some_marks(MOST_MOMENTS);
    marks.into_iter().map(mark).collect()
}

fn joints(run: &Run) -> pieper_plot::Result<Figure> {
    let values = |joint: usize| run.recording.joints.iter().map(|q| q[joint]).collect();
    time_chart(&TimeChart {
        title: title(run, "joint values over time"),
        times: run.recording.times.clone(),
        panels: panels(&run.chain, values, ["Joint angle", "Joint travel"], ""),
        marks: moments(run),
    })
}

fn rates(run: &Run) -> pieper_plot::Result<Figure> {
    let (times, states) = rates_of(run);
    let values = |joint: usize| states.iter().map(|rate| rate[joint]).collect();
    time_chart(&TimeChart {
        title: title(run, "joint rates over time"),
        panels: panels(
            &run.chain,
            values,
            ["Rate of turning", "Rate of sliding"],
            "/s",
        ),
        times,
        marks: moments(run),
    })
}

/// Rates at every sample; twice at every row, because they may jump there.
fn rates_of(run: &Run) -> (Vec<f64>, Vec<Vec<f64>>) {
    let (mut times, mut rates, mut state) = (Vec::new(), Vec::new(), State::default());
    let rows = &run.rows;
    let mut row = 0;
    for &time in &run.recording.times {
        if rows.get(row) == Some(&time) {
            if row > 0 {
                let place = run.law.times().partition_point(|&knot| knot < time);
                run.law.arriving(place, &mut state);
                times.push(time);
                rates.push(state.rate.clone());
            }
            row += 1;
            if row == rows.len() && row > 1 {
                continue;
            }
        }
        run.law.at(time, &mut state);
        times.push(time);
        rates.push(state.rate.clone());
    }
    (times, rates)
}

fn branches(run: &Run, path: &Path) -> pieper_plot::Result<Figure> {
    let variables = run.chain.variables();
    let joints = variables.iter().enumerate().map(|(index, variable)| {
        let unit = if variable.kind.is_angular() {
            "°"
        } else {
            "mm"
        };
        (names::joint(index, variable), unit.to_owned())
    });
    let line = |times: Vec<f64>, rows: &[Vec<f64>], is_chosen: bool, dies: bool| BranchLine {
        times,
        values: (0..run.chain.dof())
            .map(|joint| {
                let factor = match variables[joint].kind.is_angular() {
                    true => 180.0 / std::f64::consts::PI,
                    false => 1000.0,
                };
                rows.iter().map(|row| factor * row[joint]).collect()
            })
            .collect(),
        is_chosen,
        dies,
    };
    let tracks = &path.tracks;
    // A branch that is outside its limits from the start has a moment, but no course.
    let has_course = |track: &&Track| track.times.len() > 1 || path.times.len() == 1;
    let all = tracks.tracks.iter().filter(has_course);
    let mut lines: Vec<BranchLine> = all
        .map(|track| {
            line(
                track.times.clone(),
                &track.rows,
                false,
                track.end != End::Alive,
            )
        })
        .collect();
    for leg in &tracks.legs {
        let (times, rows) = tracks.tracks[leg.track].part(leg.from, leg.to);
        lines.push(line(times, &rows, true, false));
    }
    branch_chart(&BranchChart {
        title: title(run, "joint values of all branches"),
        joints: joints.collect(),
        lines,
        times: [path.times[0], path.times[path.times.len() - 1]],
    })
}

fn arm(run: &Run) -> pieper_plot::Result<Figure> {
    let recording = &run.recording;
    let arm = |mark: &Mark| {
        let note = format!("t = {} s", names::trimmed(recording.time(mark), 3));
        let (q, tool) = (
            &recording.joints[mark.sample],
            &recording.poses[mark.sample],
        );
        skeleton::arm(&run.chain, q, tool, mark.label.clone(), note)
    };
    arm_views(&ArmViews {
        title: title(run, "the arm at the reference positions"),
        arms: recording
            .some_marks(MOST_ARMS)
            .into_iter()
            .map(arm)
            .collect(),
        path: positions(run, None),
    })
}

/// Points of the tool, or of one of its unit vectors.
fn positions(run: &Run, axis: Option<usize>) -> Vec<[f64; 3]> {
    let poses = run.recording.poses.iter();
    let point = |pose: &pieper::spatial::Pose| match axis {
        None => pose.translation.vector.into(),
        Some(column) => pose.rotation.matrix().column(column).into_owned().into(),
    };
    poses.map(point).collect()
}

fn path(run: &Run, axis: Option<(usize, &str)>) -> pieper_plot::Result<Figure> {
    let path = positions(run, axis.map(|(column, _)| column));
    let marks = run.recording.some_marks(MOST_PLACES);
    let marks = marks.into_iter().map(|mark| PathMark {
        label: mark.label.clone(),
        at: path[mark.sample],
    });
    path_views(&PathViews {
        title: match axis {
            None => title(run, "path of the tool’s point"),
            Some((_, name)) => title(run, &format!("path of the unit vector {name}")),
        },
        axes: ["x₀".into(), "y₀".into(), "z₀".into()],
        space: match axis {
            None => Space::Positions,
            Some(_) => Space::Directions,
        },
        marks: marks.collect(),
        path,
    })
}
