//! The tool's poses at the reference positions, as text, LaTeX and JSON.

use std::fmt::Write as _;

use pieper::spatial::Pose;
use serde_json::{Value, json};

use super::recording::Mark;
use super::{Run, names};
use crate::text as columns;

/// A pose's matrix by rows, without negative zeros.
pub(super) fn rows(pose: &Pose) -> [[f64; 4]; 4] {
    let matrix = pose.to_homogeneous();
    [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| matrix[(i, j)] + 0.0))
}

/// A mark's matrix, time and joint values, in full precision.
pub(super) fn entry(run: &Run, mark: &Mark) -> Value {
    let recording = &run.recording;
    let q: Vec<f64> = recording.joints[mark.sample]
        .iter()
        .map(|q| q + 0.0)
        .collect();
    json!({
        "mark": mark.label,
        "t": recording.time(mark),
        "q": q,
        "pose": rows(&recording.poses[mark.sample]),
    })
}

pub(super) fn json(run: &Run) -> String {
    let marks = run.recording.marks.iter().map(|mark| entry(run, mark));
    let document = json!({
        "robot": run.robot.name,
        "motion": run.motion,
        "units": "metres, radians, seconds",
        "marks": marks.collect::<Value>(),
    });
    format!("{document:#}\n")
}

/// The joint values of a mark, as people read them.
fn joints(run: &Run, mark: &Mark, degree: &str, between: &str) -> String {
    let named = run
        .chain
        .variables()
        .iter()
        .zip(&run.recording.joints[mark.sample]);
    let shown = named.map(|(variable, &value)| match variable.kind.is_angular() {
        true => format!("{}{degree}", names::trimmed(value.to_degrees(), 3)),
        false => format!("{} mm", names::trimmed(1000.0 * value, 3)),
    });
    shown.collect::<Vec<_>>().join(between)
}

pub(super) fn text(run: &Run) -> String {
    let mut out = format!(
        "{}: poses of the tool at the reference positions of {}\n\
         columns n, s, a (the tool's x, y, z) and p in metres, in the frame of the base\n",
        run.robot.name, run.motion
    );
    for mark in &run.recording.marks {
        let (label, t) = (&mark.label, names::trimmed(run.recording.time(mark), 6));
        let q = joints(run, mark, " deg", ", ");
        let cells =
            rows(&run.recording.poses[mark.sample]).map(|row| row.map(columns::number).to_vec());
        let _ = write!(
            out,
            "\nT{}({label}), t = {t} s, q = ({q})\n{}",
            run.chain.dof(),
            columns::table(&cells)
        );
    }
    out
}

pub(super) fn latex(run: &Run) -> String {
    let mut out = format!(
        "% {}: poses of the tool at the reference positions of {}\n\
         % Columns n, s, a and p in metres. Compiles as it is; or \\input{{matrices}} in a document that uses amsmath.\n{ALONE}",
        one_line(&run.robot.name),
        one_line(&run.motion)
    );
    for mark in &run.recording.marks {
        let t = names::trimmed(run.recording.time(mark), 6);
        let rows = rows(&run.recording.poses[mark.sample]);
        let rows = rows.map(|row| row.map(|entry| names::trimmed(entry, 6)).join(" & "));
        let _ = write!(
            out,
            "\n% t = {t} s, q = ({})\n\\[\n  T_{{{}}}({}) = \\begin{{bmatrix}}\n    {}\n  \\end{{bmatrix}}\n\\]\n",
            joints(run, mark, " deg", ", "),
            run.chain.dof(),
            label(&mark.label),
            rows.join(" \\\\\n    ")
        );
    }
    out.push_str("\n\\pieperend\n");
    out
}

/// A document of its own, unless one has begun: `\@nodocument` is `\relax` from then on.
const ALONE: &str = r"\let\pieperend\relax
\expandafter\ifx\csname @nodocument\endcsname\relax\else
  \documentclass{article}
  \usepackage{amsmath}
  \begin{document}
  \def\pieperend{\end{document}}
\fi
";

fn one_line(text: &str) -> String {
    text.replace(['\n', '\r'], " ")
}

/// A mark's name in a formula.
fn label(text: &str) -> String {
    if text.chars().all(|c| c.is_ascii_digit()) {
        return text.to_owned();
    }
    let mut out = String::from("\\text{");
    for c in text.chars() {
        match c {
            '\\' => out.push_str("\\textbackslash{}"),
            '~' => out.push_str("\\textasciitilde{}"),
            '^' => out.push_str("\\textasciicircum{}"),
            '<' => out.push_str("\\textless{}"),
            '>' => out.push_str("\\textgreater{}"),
            '|' => out.push_str("\\textbar{}"),
            // Beyond Latin letters a plain LaTeX has no glyphs, and stops.
            c if c > '\u{17f}' => out.push('?'),
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => out.extend(['\\', c]),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out.push('}');
    out
}
