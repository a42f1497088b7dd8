//! What `pieper ik` answers, for people and for programs.

use std::fmt::Write as _;

use pieper::Result;
use pieper::ik::{self, Nearest, Ranking, Solution, Solutions, Solver, Status};
use pieper::model::Chain;
use pieper::spatial::Pose;
use pieper::transmission::Transmission;
use serde_json::{Map, Value, json};

use crate::commands::motors::Motors;
use crate::text;

/// Members of a family that are listed.
const SAMPLES: usize = 12;

/// Everything known about one pose.
pub(super) struct Answer {
    status: Status,
    solutions: Vec<Solution>,
    families: Vec<Members>,
    reason: Option<String>,
    nearest: Option<Nearest>,
    /// Isolated solutions left out because no copy of them lies within the limits.
    outside: usize,
    /// The same for families.
    families_outside: usize,
    /// The motors at each solution; none if they drive their joints directly.
    motors: Vec<Motors>,
}

/// What is wanted of an answer.
pub(super) struct Wish<'a> {
    pub(super) seed: Option<&'a [f64]>,
    pub(super) ranking: Option<Ranking<'a>>,
    /// Only what lies within the limits.
    pub(super) limits: bool,
}

struct Members {
    q: Vec<f64>,
    free: Vec<f64>,
    branch: String,
    samples: Vec<Vec<f64>>,
    ranges: Vec<ik::Range>,
    closest: Option<Vec<f64>>,
}

impl Answer {
    pub(super) fn compute(solver: &Solver, pose: &Pose, wish: &Wish<'_>) -> Result<Self> {
        let found = solver.solve(pose)?;
        let chain = solver.chain();
        let mut solutions = found.as_slice().to_vec();
        let mut outside = 0;
        if wish.limits {
            solutions = ik::windings(chain, &found);
            outside = found
                .iter()
                .filter(|one| !solutions.iter().any(|copy| copy.branch == one.branch))
                .count();
        }
        if let Some(ranking) = wish.ranking {
            ik::rank(chain, &mut solutions, ranking);
        }
        let families = members(solver, &found, wish)?;
        let nearest = match (found.status(), found.nearest()) {
            (Status::Unreachable, None) => Some(solver.nearest(pose)?),
            (_, nearest) => nearest.copied(),
        };
        Ok(Self {
            status: found.status(),
            solutions,
            families_outside: found.families().len() - families.len(),
            families,
            reason: found.reason().map(|reason| reason.to_string()),
            nearest,
            outside,
            motors: Vec::new(),
        })
    }

    /// The same with the motors' values. What a drive cannot reach lies outside the limits, and is left out with
    /// `--limits`.
    pub(super) fn driven_by(mut self, drives: Option<&Transmission>, limits: bool) -> Result<Self> {
        let Some(drives) = drives else {
            return Ok(self);
        };
        let mut left_out = Vec::new();
        for mut solution in std::mem::take(&mut self.solutions) {
            let motors = Motors::at(drives, solution.q())?;
            solution.within_limits &= motors.are_reached();
            if limits && !motors.are_reached() {
                left_out.push(solution);
                continue;
            }
            self.solutions.push(solution);
            self.motors.push(motors);
        }
        // Copies by whole turns are one solution.
        left_out.dedup_by(|a, b| a.branch == b.branch);
        let is_gone = |one: &&Solution| self.solutions.iter().all(|copy| copy.branch != one.branch);
        self.outside += left_out.iter().filter(is_gone).count();
        Ok(self)
    }

    pub(super) fn is_reached(&self) -> bool {
        self.status != Status::Unreachable
    }

    /// The fields of the contract.
    pub(super) fn fields(&self, chain: &Chain, deg: bool) -> Map<String, Value> {
        let shown = |q: &[f64]| Value::from(in_units(chain, q, deg));
        let solution = |(index, s): (usize, &Solution)| {
            let mut out = json!({
                "q": shown(s.q()),
                "residual": s.residual,
                "branch": s.branch.to_string(),
                "multiplicity": s.multiplicity,
                "within_limits": s.within_limits,
            });
            if let (Some(motors), Some(out)) = (self.motors.get(index), out.as_object_mut()) {
                out.extend(motors.fields(deg));
            }
            out
        };
        let family = |family: &Members| {
            let samples: Vec<Value> = family.samples.iter().map(|q| shown(q)).collect();
            let range =
                |range: &ik::Range| json!({"from": shown(&range.from), "to": shown(&range.to)});
            let ranges: Vec<Value> = family.ranges.iter().map(range).collect();
            let mut out = json!({
                "q": shown(&family.q),
                "free": family.free,
                "branch": family.branch,
                "samples": samples,
                "ranges": ranges,
            });
            if let Some(closest) = &family.closest {
                out["nearest_to_seed"] = shown(closest);
            }
            out
        };
        let mut fields = Map::new();
        fields.insert("status".to_owned(), self.status.name().into());
        fields.insert(
            "solutions".to_owned(),
            self.solutions.iter().enumerate().map(solution).collect(),
        );
        fields.insert(
            "families".to_owned(),
            self.families.iter().map(family).collect(),
        );
        fields.insert("reason".to_owned(), json!(self.reason));
        if let Some(nearest) = &self.nearest {
            let nearest = json!({
                "q": shown(nearest.q()),
                "position_error": nearest.position_error,
                "orientation_error": nearest.orientation_error,
            });
            fields.insert("nearest".to_owned(), nearest);
        }
        fields
    }

    /// One JSON document.
    pub(super) fn document(&self, robot: &str, solver: &Solver, deg: bool) -> Value {
        let mut document = Map::new();
        document.insert("robot".to_owned(), robot.into());
        document.insert("solver".to_owned(), solver.choice().name.into());
        document.extend(self.fields(solver.chain(), deg));
        Value::Object(document)
    }

    /// Text for a person.
    pub(super) fn text(&self, robot: &str, solver: &Solver, deg: bool) -> String {
        let chain = solver.chain();
        let choice = solver.choice();
        let mut out = format!(
            "{robot}: {}\n{}, solver {}\n",
            self.status.name(),
            choice.class,
            choice.name
        );
        let unit = if deg { "degrees" } else { "radians" };
        if !self.solutions.is_empty() {
            let _ = writeln!(out, "\nsolutions ({unit}, metres)");
            out.push_str(&self.solution_table(chain, deg));
        }
        if !self.motors.is_empty() {
            let _ = writeln!(out, "\nmotors ({unit}, metres), a row for each solution");
            let rows = self.motors.iter().map(|motors| motors.cells(deg).collect());
            out.push_str(&text::table(&rows.collect::<Vec<_>>()));
            for (index, motors) in self.motors.iter().enumerate() {
                if let Some(reason) = &motors.reason {
                    let _ = writeln!(out, "  solution {}: {reason}", index + 1);
                }
            }
        }
        if self.outside > 0 {
            let _ = writeln!(out, "\n{} more lie outside the limits", self.outside);
        }
        if self.families_outside > 0 {
            let _ = writeln!(
                out,
                "\n{} families lie outside the limits",
                self.families_outside
            );
        }
        for (index, family) in self.families.iter().enumerate() {
            let _ = writeln!(
                out,
                "\nfamily {} ({}), a member, the direction in which it goes on, and more members",
                index + 1,
                family.branch
            );
            let row = |name: &str, values: &[f64]| {
                [
                    vec![name.to_owned()],
                    values.iter().map(|&x| text::number(x)).collect(),
                ]
                .concat()
            };
            let mut rows = vec![
                row("q", &in_units(chain, &family.q, deg)),
                row("free", &family.free),
            ];
            if let Some(closest) = &family.closest {
                rows.push(row("nearest to seed", &in_units(chain, closest, deg)));
            }
            for range in &family.ranges {
                rows.push(row(
                    "within limits from",
                    &in_units(chain, &range.from, deg),
                ));
                rows.push(row("to", &in_units(chain, &range.to, deg)));
            }
            rows.extend(
                family
                    .samples
                    .iter()
                    .map(|q| row("", &in_units(chain, q, deg))),
            );
            out.push_str(&text::table(&rows));
        }
        if let Some(reason) = &self.reason {
            let _ = writeln!(out, "\n{reason}");
        }
        if let Some(nearest) = &self.nearest {
            let values: Vec<String> = in_units(chain, nearest.q(), deg)
                .into_iter()
                .map(text::number)
                .collect();
            let _ = writeln!(
                out,
                "nearest: {}\n  off by {:.6} m and {:.6} rad",
                values.join("  "),
                nearest.position_error,
                nearest.orientation_error
            );
        }
        out
    }

    fn solution_table(&self, chain: &Chain, deg: bool) -> String {
        let names = chain
            .variables()
            .iter()
            .map(|variable| variable.name.clone());
        let tail = ["residual", "limits", "branch"].map(str::to_owned);
        let mut rows = vec![names.chain(tail).collect::<Vec<_>>()];
        for solution in &self.solutions {
            let values = in_units(chain, solution.q(), deg)
                .into_iter()
                .map(text::number);
            let limits = if solution.within_limits {
                "within"
            } else {
                "outside"
            };
            let mut branch = solution.branch.to_string();
            if solution.multiplicity > 1 {
                let _ = write!(branch, " ({} merge)", solution.multiplicity);
            }
            let tail = [
                format!("{:.1e}", solution.residual),
                limits.to_owned(),
                branch,
            ];
            rows.push(values.chain(tail).collect());
        }
        text::table(&rows)
    }
}

fn members(solver: &Solver, found: &Solutions, wish: &Wish<'_>) -> Result<Vec<Members>> {
    let family = |family: &ik::Family| {
        let closest = match wish.seed {
            Some(seed) => Some(solver.nearest_member(family, seed)?),
            None => None,
        };
        Ok(Members {
            q: family.q().to_vec(),
            free: family.free().to_vec(),
            branch: family.branch.to_string(),
            samples: match wish.limits {
                true => solver.samples_within(family, SAMPLES),
                false => solver.samples(family, SAMPLES),
            },
            ranges: solver.ranges(family),
            closest,
        })
    };
    let mut families = found.families().to_vec();
    if wish.limits {
        // What lies outside as a whole is left out; the rest is shown by a member within.
        families = families
            .iter()
            .filter_map(|family| solver.within_limits(family))
            .collect();
    }
    families.iter().map(family).collect()
}

/// Joint values in the units of the answer.
fn in_units(chain: &Chain, q: &[f64], deg: bool) -> Vec<f64> {
    let shown = |(value, variable): (&f64, &pieper::model::Variable)| match deg
        && variable.kind.is_angular()
    {
        true => value.to_degrees(),
        false => *value,
    };
    q.iter().zip(chain.variables()).map(shown).collect()
}
