//! `report.html`: everything about a run on one page.

use pieper::describe::dh::Convention;
use pieper::describe::{Expr, Form, Robot};
use pieper::model::Variable;
use pieper_plot::{Matrix, Report, Section, Table};

use super::figures::Drawing;
use super::recording::Mark;
use super::{Run, certificate, matrices, names};
use crate::commands::info::table_rows;

/// The name of the file.
pub(super) const FILE: &str = "report.html";

/// More than these are thinned out; the files have them all.
const MOST_MATRICES: usize = 24;
const MOST_ROWS: usize = 1000;

pub(super) fn html(run: &Run, drawn: &[Drawing]) -> String {
    let mut report = Report::new(format!("{}: {}", run.robot.name, stem(&run.motion)))
        .lead(lead(run))
        .fact("Joints", joint_kinds(run))
        .fact(
            "Duration",
            format!("{} s", names::trimmed(run.recording.duration(), 3)),
        )
        .fact("Reference positions", run.recording.marks.len().to_string())
        .fact("Profile", run.profile.name())
        .fact(
            "Samples",
            format!("{} at {} per second", run.recording.times.len(), run.rate),
        );
    for (key, value) in &run.robot.datasheet {
        report = report.fact(capital(key), value);
    }
    if let Some(path) = &run.path {
        report = report.section(certificate::section(run, path, drawn));
    }
    if !run.warnings.is_empty() {
        report = report.section(limits(run));
    }
    let figure =
        |section: Section, name: &str| match drawn.iter().find(|drawing| drawing.name == name) {
            Some(drawing) => section.figure(&drawing.figure, &drawing.caption),
            None => section,
        };
    let all = |heading: &str, text: &str, names: &[&str]| {
        let section = match text {
            "" => Section::new(heading),
            text => Section::new(heading).paragraph(text),
        };
        names
            .iter()
            .fold(section, |section, name| figure(section, name))
    };
    report
        .section(all("Joint values", "", &["joints", "rates"]))
        .section(all("The arm", "", &["arm"]))
        .section(all("Path of the tool’s point", "", &["path"]))
        .section(all(
            "Orientation of the tool",
            "The tool’s unit vectors i, j, k move on the unit sphere.",
            &["i", "j", "k"],
        ))
        .section(poses(run))
        .section(directions(run))
        .section(robot(run))
        .section(samples(run))
        .footer(format!(
            "Written by pieper {} from {} and the description of {}. Figures, matrices and all samples lie beside this page as files.",
            env!("CARGO_PKG_VERSION"),
            run.motion,
            run.robot.name
        ))
        .to_html()
}

fn stem(file: &str) -> &str {
    file.rsplit_once('.').map_or(file, |(stem, _)| stem)
}

fn capital(text: &str) -> String {
    let mut rest = text.chars();
    match rest.next() {
        Some(first) => first.to_uppercase().chain(rest).collect(),
        None => String::new(),
    }
}

fn lead(run: &Run) -> String {
    let summary = run.robot.summary.trim_end_matches('.');
    let motion = format!("The motion {}: {}.", run.motion, run.summary());
    match summary {
        "" => motion,
        summary => format!("{}. {motion}", capital(summary)),
    }
}

fn joint_kinds(run: &Run) -> String {
    let turning = run
        .chain
        .variables()
        .iter()
        .filter(|v| v.kind.is_angular())
        .count();
    let sliding = run.chain.dof() - turning;
    match (turning, sliding) {
        (turning, 0) => format!("{turning} turning"),
        (0, sliding) => format!("{sliding} sliding"),
        (turning, sliding) => format!("{turning} turning, {sliding} sliding"),
    }
}

fn limits(run: &Run) -> Section {
    let text = "The motion is shown as asked for; nothing was cut off.";
    Section::new("Limits exceeded")
        .warnings(run.warnings.iter().map(|text| capital(text) + "."))
        .paragraph(text)
}

/// What a section says where not every mark is shown.
fn thinned(run: &Run, shown: usize) -> String {
    match run.recording.marks.len() {
        all if all == shown => String::new(),
        all => format!(" {shown} of {all} are shown; matrices.json has them all."),
    }
}

fn poses(run: &Run) -> Section {
    let note = run
        .note
        .as_deref()
        .map_or(String::new(), |note| format!(" {note}"));
    let marks = run.recording.some_marks(MOST_MATRICES);
    let name = names::transform(&run.chain);
    let matrix = |mark: &&Mark| {
        let note = format!("t = {} s", names::trimmed(run.recording.time(mark), 3));
        let rows = matrices::rows(&run.recording.poses[mark.sample]);
        Matrix::of_numbers(format!("{name}({})", mark.label), note, &rows, 4)
    };
    let text = format!(
        "Columns n, s, a (the tool’s axes) and p (its point, in metres) in the frame of the base.{}{note}",
        thinned(run, marks.len())
    );
    Section::new("Poses at the reference positions")
        .paragraph(text)
        .matrices(marks.iter().map(matrix).collect())
}

fn directions(run: &Run) -> Section {
    let marks = run.recording.some_marks(MOST_MATRICES);
    let axes = ["x₀", "y₀", "z₀"];
    let cosines = ["i", "j", "k"]
        .into_iter()
        .flat_map(|unit| axes.map(|axis| format!("{unit}·{axis}")));
    let head = ["Position".to_owned()].into_iter().chain(cosines);
    let caption = format!(
        "Cosines of the angles between the tool’s unit vectors and the axes of the base.{}",
        thinned(run, marks.len())
    );
    let mut table = Table::new(caption, head);
    for mark in &marks {
        let rows = matrices::rows(&run.recording.poses[mark.sample]);
        let cells = [0, 1, 2]
            .into_iter()
            .flat_map(|column| rows[..3].iter().map(move |row| row[column]));
        let cells = cells.map(|cosine| format!("{cosine:.4}"));
        table = table.row([mark.label.clone()].into_iter().chain(cells));
    }
    Section::new("Direction cosines").table(table)
}

fn robot(run: &Run) -> Section {
    let mut section = Section::new("The robot");
    section = match &run.robot.form {
        Form::Dh(dh) => {
            let text = match dh.convention {
                Convention::Standard => {
                    "Denavit-Hartenberg table, standard convention: Rz(θ) Tz(d) Tx(a) Rx(α)."
                }
                Convention::Modified => {
                    "Denavit-Hartenberg table, modified convention: Rx(α) Tx(a) Rz(θ) Tz(d)."
                }
            };
            let table = Table::new("In metres and radians", ["Row", "θ", "α", "d", "a"]);
            let rows = table_rows(dh).into_iter().enumerate();
            let table = rows.fold(table, |table, (index, [theta, d, a, alpha])| {
                let cells = [theta, alpha, d, a].map(|text| names::formula(&text));
                table.row([(index + 1).to_string()].into_iter().chain(cells))
            });
            section.paragraph(text).table(table)
        }
        Form::Screws(screws) => {
            let row = |exprs: &[Expr; 3]| {
                exprs
                    .each_ref()
                    .map(|e| names::formula(&e.to_string()))
                    .join(", ")
            };
            let table = Table::new(
                "Screw axes",
                ["Joint", "axis h", "point p from the one before"],
            );
            section.table(screws.screws.iter().fold(table, |table, screw| {
                table.row([screw.joint.name.clone(), row(&screw.h), row(&screw.p)])
            }))
        }
        Form::Tree { tree, base, tip } => {
            let (base, tip) = (&tree.links()[*base].name, &tree.links()[*tip].name);
            section.paragraph(format!(
                "The chain from {base} to {tip} of a tree of {} links.",
                tree.links().len()
            ))
        }
    };
    if let Some(text) = parameters(&run.robot) {
        section = section.paragraph(text);
    }
    section = section.table(joint_table(run));
    for text in source(&run.robot.source) {
        section = section.paragraph(text);
    }
    section
}

/// Where the numbers come from: a paragraph for each line that opens with "Table:", "Limits:" and the like.
fn source(text: &str) -> Vec<String> {
    let opens = |line: &str| {
        let head = line.split_once(": ").map(|(head, _)| head);
        head.is_some_and(|head| {
            head.len() < 30 && head.starts_with(char::is_uppercase) && !head.contains('.')
        })
    };
    let mut paragraphs: Vec<String> = Vec::new();
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty()) {
        match paragraphs.last_mut() {
            Some(last) if !opens(line) => {
                last.push(' ');
                last.push_str(line);
            }
            _ => paragraphs.push(line.to_owned()),
        }
    }
    paragraphs
}

fn parameters(robot: &Robot) -> Option<String> {
    let written = robot.parameters.iter().filter_map(|parameter| {
        let value = parameter.value.as_ref()?;
        Some(format!(
            "{} = {}",
            parameter.name,
            names::formula(&value.to_string())
        ))
    });
    let written: Vec<_> = written.collect();
    (!written.is_empty()).then(|| format!("With {}.", written.join(", ")))
}

fn joint_table(run: &Run) -> Table {
    let head = [
        "Joint",
        "Name",
        "from",
        "to",
        "in this motion",
        "largest rate",
        "limit",
    ];
    let table = Table::new("Joints: limits, and what the motion uses of them", head);
    let joints = run.chain.variables().iter().enumerate();
    joints.fold(table, |table, (index, variable)| {
        table.row(joint_row(run, index, variable))
    })
}

fn joint_row(run: &Run, index: usize, variable: &Variable) -> [String; 7] {
    let angular = variable.kind.is_angular();
    let shown = |value: f64, per: &str| match angular {
        true => format!(
            "{}°{per}",
            names::formula(&names::trimmed(value.to_degrees(), 2))
        ),
        false => format!(
            "{} mm{per}",
            names::formula(&names::trimmed(value * 1000.0, 2))
        ),
    };
    let dash = || "\u{2013}".to_owned();
    let values = || run.law.rows().iter().map(|row| row[index]);
    let (low, high) = (
        values().fold(f64::INFINITY, f64::min),
        values().fold(f64::NEG_INFINITY, f64::max),
    );
    let moves = run.law.times().windows(2).zip(run.law.rows().windows(2));
    let rates =
        moves.map(|(times, rows)| (rows[1][index] - rows[0][index]).abs() / (times[1] - times[0]));
    let rate = run.law.profile().peak_rate() * rates.fold(0.0, f64::max);
    let limits = variable.limits;
    [
        format!("q{}", names::subscript(index + 1)),
        variable.name.clone(),
        limits.map_or_else(dash, |limits| shown(limits.lower(), "")),
        limits.map_or_else(dash, |limits| shown(limits.upper(), "")),
        format!("{} to {}", shown(low, ""), shown(high, "")),
        shown(rate, "/s"),
        variable
            .velocity
            .map_or_else(dash, |limit| shown(limit, "/s")),
    ]
}

fn samples(run: &Run) -> Section {
    let recording = &run.recording;
    let joint = |(index, variable): (usize, &Variable)| {
        let unit = if variable.kind.is_angular() {
            "°"
        } else {
            "mm"
        };
        format!("q{}, {unit}", names::subscript(index + 1))
    };
    let joints = run.chain.variables().iter().enumerate().map(joint);
    let head = ["t, s".to_owned()].into_iter().chain(joints);
    let head = head.chain(["x₀, mm", "y₀, mm", "z₀, mm"].map(str::to_owned));
    let step = recording.times.len().div_ceil(MOST_ROWS);
    let mut table = Table::new("Joint values and the tool’s point", head);
    for index in (0..recording.times.len()).step_by(step) {
        let joints = run.chain.variables().iter().zip(&recording.joints[index]);
        let joints = joints.map(|(variable, &q)| match variable.kind.is_angular() {
            true => format!("{:.3}", q.to_degrees()),
            false => format!("{:.3}", q * 1000.0),
        });
        let point = recording.poses[index].translation.vector;
        let point = [point.x, point.y, point.z].map(|x| format!("{:.3}", x * 1000.0));
        let time = names::trimmed(recording.times[index], 6);
        table = table.row([time].into_iter().chain(joints).chain(point));
    }
    let text = match step {
        1 => "All digits, the direction cosines too, are in samples.csv.".to_owned(),
        step => format!(
            "Every {step}th sample; all of them, with all digits and the direction cosines, are in samples.csv."
        ),
    };
    Section::new("Samples").paragraph(text).table(table)
}
