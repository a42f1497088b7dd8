//! `pieper check`

use std::fmt::Write as _;
use std::path::Path;

use clap::Args;
use pieper_symbolic::claims::{self, Failure as Wrong, Outcome as Holding, Verdict};
use pieper_symbolic::{Arm, Lengths};
use serde_json::{Value, json};

use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::{Source, read_text};

/// Check printed formulas against an arm: what holds, what fails, and the smallest repair
#[derive(Args)]
#[command(after_help = "\
Example:
  pieper check ar3 examples/ar3-claims.txt

A claim is an equation, one a line: t32 = s23*c5 - c23*c4*s5. Entries of the tool's pose are t11 ... t34, x_c, n_x, ...;
A5 and R36 are matrices, A5[1, 2] an entry; A5 = [c5, 0, s5, 0; ...] claims a whole one. s1, c23 are sines and cosines;
sin(q2 - q3) and named lengths do as well. Inverse formulas: q4 + q6 = atan2(R36[2, 1], -R36[3, 1]) when q5 = 0.
A line \"map NAME = FORMULA\" says what a name stands for. LaTeX as papers write it is read from .tex files.
Exit code 1 if a claim fails.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// The file of claims: plain notation, or LaTeX if its name ends in .tex
    #[arg(value_name = "CLAIMS")]
    claims: String,

    /// Read the claims as LaTeX, whatever their file is called
    #[arg(long)]
    latex: bool,

    /// Put the values of named lengths in their place
    #[arg(long)]
    numeric: bool,

    /// One JSON document
    #[arg(long)]
    json: bool,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robot = self.source.robot()?;
        let path = Path::new(&self.claims);
        let text = read_text(path)?;
        let extension = path
            .extension()
            .and_then(|extension| extension.to_str())
            .unwrap_or_default();
        let latex = self.latex || extension.eq_ignore_ascii_case("tex");
        let lengths = if self.numeric {
            Lengths::Numbers
        } else {
            Lengths::Symbols
        };
        let arm = Arm::new(&robot, lengths)?;
        let verdicts = claims::check(&arm, &self.claims, &text, latex)?;
        if verdicts.is_empty() {
            return Err(Failure::input(format!(
                "{}: it holds no claim: an equation was expected",
                self.claims
            )));
        }
        if self.json {
            output::document(&verdicts.iter().map(document).collect::<Vec<_>>().into())?;
        } else {
            let width = verdicts
                .iter()
                .map(|verdict| verdict.name.chars().count())
                .max()
                .unwrap_or(0);
            let lines: String = verdicts
                .iter()
                .map(|verdict| line(verdict, width))
                .collect();
            output::answer(&lines)?;
        }
        let fails = verdicts
            .iter()
            .any(|verdict| matches!(verdict.outcome, Holding::Fails(_)));
        Ok(if fails {
            Outcome::Negative
        } else {
            Outcome::Done
        })
    }
}

fn line(verdict: &Verdict, width: usize) -> String {
    let what = match &verdict.outcome {
        Holding::Holds => "holds".to_owned(),
        Holding::HoldsAtSamples(count) => format!(
            "holds at {count} random joint vectors (no identity of polynomials: not proved)"
        ),
        Holding::Fails(wrong) => format!("fails {}", explanation(wrong)),
    };
    format!("{:width$}  {what}\n", verdict.name)
}

fn explanation(wrong: &Wrong) -> String {
    let mut out = String::new();
    if let Some((row, column)) = wrong.entry {
        let _ = write!(out, "in entry ({row},{column}): ");
    }
    match (&wrong.repair, &wrong.right) {
        (Some(repair), _) => {
            let (line, column) = (repair.line, repair.column);
            let _ = write!(
                out,
                "repair: {} -> {} ({}; line {line}, column {column})",
                repair.before, repair.after, repair.what
            );
        }
        (None, Some(right)) => {
            let _ = write!(out, "no small repair; it is {right}");
        }
        (None, None) => out.push_str("no small repair found"),
    }
    if let Some(difference) = &wrong.difference {
        let _ = write!(out, "; difference {difference}");
    }
    let (truth, claimed) = wrong.values;
    let numbers = |values: &[f64]| {
        values
            .iter()
            .map(|value| format!("{}", rounded(*value)))
            .collect::<Vec<_>>()
            .join(",")
    };
    let _ = write!(
        out,
        "; at q = {} it is {truth:.4}, not {claimed:.4}",
        numbers(&wrong.q)
    );
    if !wrong.parameters.is_empty() {
        let set: Vec<String> = wrong
            .parameters
            .iter()
            .map(|(name, value)| format!("{name}={value}"))
            .collect();
        let _ = write!(out, " (with {})", set.join(","));
    }
    out
}

/// A joint value as short as it is meant: tenths, or six digits of a multiple of pi.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

fn document(verdict: &Verdict) -> Value {
    let mut document = json!({"claim": verdict.name, "line": verdict.line});
    match &verdict.outcome {
        Holding::Holds => document["holds"] = true.into(),
        Holding::HoldsAtSamples(count) => {
            document["holds"] = true.into();
            document["samples"] = (*count).into();
        }
        Holding::Fails(wrong) => {
            document["holds"] = false.into();
            let Wrong {
                entry,
                difference,
                q,
                parameters,
                values,
                repair,
                right,
            } = &**wrong;
            document["entry"] = json!(entry.map(|(row, column)| [row, column]));
            document["difference"] = json!(difference);
            document["q"] = json!(q);
            let parameters = parameters
                .iter()
                .map(|(name, value)| (name.clone(), json!(value)));
            document["parameters"] = Value::Object(parameters.collect());
            let finite = |value: f64| value.is_finite().then_some(value);
            document["value"] = json!(finite(values.0));
            document["claimed"] = json!(finite(values.1));
            document["right"] = json!(right);
            document["repair"] = match repair {
                None => Value::Null,
                Some(repair) => json!({
                    "what": repair.what,
                    "before": repair.before,
                    "after": repair.after,
                    "line": repair.line,
                    "column": repair.column,
                }),
            };
        }
    }
    document
}
