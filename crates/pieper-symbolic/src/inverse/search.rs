//! The search for equations with one unknown.

use pieper::{Error, Result};

use super::probe::Probe;
use super::{Defined, Inverse, Rule, Source, Step, without_base_and_tool};
use crate::arm::Arm;
use crate::basis;
use crate::names::{Names, SymbolMeaning, Var};
use crate::number;
use crate::poly::Poly;
use crate::transform::Transform;

pub(super) struct Search<'a> {
    pub(super) arm: &'a Arm,
    pub(super) names: Names,
    /// The known matrix that equals the product of the rows `first..end`.
    known: Transform,
    first: usize,
    end: usize,
    pub(super) solved: Vec<bool>,
    steps: Vec<Step>,
    level: usize,
    /// The position column of the known matrix times the inverse of the last row left, in symbols of its own.
    point: Option<[Poly; 3]>,
    pub(super) probe: Probe,
    target: [[Var; 4]; 3],
    /// Whether equations without an unknown are noted, and those noted: after how many steps.
    collects: bool,
    conditions: Vec<(usize, Source, Poly)>,
}

const LEVELS: [&str; 8] = ["u", "v", "w", "m", "g", "h", "y", "z"];

/// All joints, each by an equation with one unknown.
pub(super) fn run(arm: &Arm) -> Result<Inverse> {
    let mut search = Search::begin(arm)?;
    search.all()?;
    let mut inverse = search.finish();
    drop_unused(&mut inverse.steps, Vec::new(), 0);
    Ok(inverse)
}

/// All joints but one, as if that were known.
pub(super) struct Assumed {
    pub(super) inverse: Inverse,
    /// The equations without an unknown, each with the number of steps after which it is one, and its source.
    pub(super) conditions: Vec<(usize, Source, Poly)>,
    /// The joint vector that equations were tried on.
    pub(super) q: Vec<f64>,
    /// What to say where no equation tells the right values of that joint.
    pub(super) stuck: Error,
}

/// Solves for all joints but this one.
pub(super) fn run_assuming(arm: &Arm, joint: usize) -> Result<Assumed> {
    let mut search = Search::begin(arm)?;
    search.solved[joint] = true;
    search.collects = true;
    search.peel()?;
    search.all()?;
    Ok(Assumed {
        stuck: search.stuck(),
        conditions: std::mem::take(&mut search.conditions),
        q: search.probe.q.clone(),
        inverse: search.finish(),
    })
}

impl<'a> Search<'a> {
    fn begin(arm: &'a Arm) -> Result<Self> {
        let mut names = arm.names.clone();
        let full = || {
            Error::model(
                arm.title.clone(),
                "it has more symbols than formulas have room for",
            )
        };
        let mut target = [[Var::ROOT2; 4]; 3];
        for (row, axis) in ["x", "y", "z"].iter().enumerate() {
            for (column, vector) in ["n", "s", "a", "p"].iter().enumerate() {
                let name = format!("{vector}_{axis}");
                if names.find_symbol(&name).is_some() {
                    return Err(Error::model(
                        name,
                        "a table's symbol has the name of an entry of the target",
                    ));
                }
                target[row][column] = names
                    .symbol(&name, SymbolMeaning::Auxiliary)
                    .ok_or_else(full)?;
            }
        }
        let given = Transform(target.map(|row| row.map(Poly::var)));
        let probe = Probe::new(arm, &names, &target)?;
        let mut search = Self {
            arm,
            names,
            known: given.clone(),
            target,
            first: 0,
            end: arm.dof(),
            solved: vec![false; arm.dof()],
            steps: Vec::new(),
            level: 0,
            point: None,
            probe,
            collects: false,
            conditions: Vec::new(),
        };
        if arm.base.is_some() || arm.tool.is_some() {
            search.known = without_base_and_tool(arm, &given);
            search.define()?;
        } else {
            search.define_point("w")?;
        }
        Ok(search)
    }

    /// Solves all joints that are left.
    fn all(&mut self) -> Result<()> {
        while self.solved.contains(&false) {
            self.collect();
            let Some(best) = self.best() else {
                return Err(self.stuck());
            };
            self.solved[best.joint] = true;
            self.steps.push(Step::Joint {
                joint: best.joint,
                rule: best.rule,
                source: best.source,
            });
            self.peel()?;
        }
        self.collect();
        Ok(())
    }

    fn finish(self) -> Inverse {
        Inverse {
            arm: self.arm.clone(),
            names: self.names,
            target: self.target,
            steps: self.steps,
        }
    }

    /// Notes the equations without an unknown: some are true whatever the joint that is taken as known, and some only where it is right.
    fn collect(&mut self) {
        if !self.collects {
            return;
        }
        let mut found = Vec::new();
        for (source, known, product) in self.equations() {
            for row in 0..3 {
                for column in 0..4 {
                    let poly = &known.0[row][column] - &product.0[row][column];
                    if poly.vars().is_empty() || !self.unknowns(&poly).is_empty() {
                        continue;
                    }
                    let entries = vec![(row, column)];
                    found.push((
                        Source {
                            entries,
                            ..source.clone()
                        },
                        poly,
                    ));
                }
            }
            for rows in [&[0, 1][..], &[0, 2], &[1, 2], &[0, 1, 2]] {
                let square = |entry: &Poly| entry * entry;
                let sum = |of: &Transform| {
                    rows.iter()
                        .fold(Poly::zero(), |sum, &row| sum + square(&of.0[row][3]))
                };
                let poly = sum(&known) - sum(&product);
                if poly.vars().is_empty() || !self.unknowns(&poly).is_empty() {
                    continue;
                }
                let entries = rows.iter().map(|&row| (row, 3)).collect();
                let squares = true;
                found.push((
                    Source {
                        entries,
                        squares,
                        ..source.clone()
                    },
                    poly,
                ));
            }
        }
        let at = self.steps.len();
        self.conditions
            .extend(found.into_iter().map(|(source, poly)| (at, source, poly)));
    }

    fn stuck(&self) -> Error {
        let left: Vec<String> = (0..self.solved.len())
            .filter(|&joint| !self.solved[joint])
            .map(|joint| format!("q{}", joint + 1))
            .collect();
        let text = format!(
            "no equation with a single unknown is left for {}: the arm has no closed form of this kind; `pieper ik` solves \
             it all the same, by elimination or by one unknown",
            left.join(", ")
        );
        Error::model(self.arm.title.clone(), text)
    }

    /// The joint variables in a polynomial that are not solved yet.
    pub(super) fn unknowns(&self, poly: &Poly) -> Vec<usize> {
        let mut joints: Vec<usize> = poly
            .vars()
            .into_iter()
            .filter_map(|var| self.names.joint_of(var))
            .collect();
        joints.retain(|&joint| !self.solved[joint]);
        joints.dedup();
        joints.sort_unstable();
        joints.dedup();
        joints
    }

    /// Takes solved rows at the ends over to the known side.
    fn peel(&mut self) -> Result<()> {
        let (first, end) = (self.first, self.end);
        while self.first < self.end && self.solved[self.first] {
            self.first += 1;
        }
        while self.first < self.end && self.solved[self.end - 1] {
            self.end -= 1;
        }
        if self.first == self.end || (first, end) == (self.first, self.end) {
            return Ok(());
        }
        let left = self.arm.product(first, self.first).inverse();
        let right = self.arm.product(self.end, end).inverse();
        self.known = left.times(&self.known).times(&right);
        let sums = basis::cumulative(self.arm);
        self.known = self.known.map(|entry| {
            let short = sums.rewrite(entry);
            if short.terms().len() < entry.terms().len() {
                short
            } else {
                entry.clone()
            }
        });
        self.define()
    }

    /// Gives the entries of the known matrix names of their own, where they are more than one quantity.
    fn define(&mut self) -> Result<()> {
        let letter = LEVELS
            .iter()
            .skip(self.level)
            .find(|letter| self.names.find_symbol(&format!("{letter}11")).is_none());
        let Some(letter) = letter else {
            return Err(self.stuck());
        };
        self.level += 1;
        let mut quantities = Vec::new();
        let mut known = self.known.clone();
        for row in 0..3 {
            for column in 0..4 {
                let entry = &mut known.0[row][column];
                let is_simple = entry.constant().is_some()
                    || matches!(entry.terms(), [term] if term.monomial.degree() == 1
                        && number::magnitude(&term.coefficient) == number::whole(1));
                if is_simple {
                    continue;
                }
                let name = format!("{letter}{}{}", row + 1, column + 1);
                let Some(var) = self.names.symbol(&name, SymbolMeaning::Auxiliary) else {
                    return Err(self.stuck());
                };
                quantities.push((var, std::mem::replace(entry, Poly::var(var))));
            }
        }
        self.known = known;
        if !quantities.is_empty() {
            self.probe.learn(self.arm, &quantities);
            let what = Defined::Known {
                first: self.first,
                end: self.end,
            };
            self.steps.push(Step::Define { what, quantities });
        }
        self.define_point(letter)
    }

    /// Names the wrist centre, where the last row does not move it.
    fn define_point(&mut self, letter: &str) -> Result<()> {
        self.point = None;
        if self.end - self.first < 2 {
            return Ok(());
        }
        let known = self.known.times(&self.arm.link(self.end - 1).inverse());
        let mut point = [0, 1, 2].map(|row| known.0[row][3].clone());
        if point.iter().any(|entry| !self.unknowns(entry).is_empty()) {
            return Ok(());
        }
        let mut quantities = Vec::new();
        for (entry, axis) in point.iter_mut().zip(["x", "y", "z"]) {
            if entry.terms().len() < 2 {
                continue;
            }
            let name = format!("{letter}_{axis}");
            let Some(var) = self.names.symbol(&name, SymbolMeaning::Auxiliary) else {
                return Err(self.stuck());
            };
            quantities.push((var, std::mem::replace(entry, Poly::var(var))));
        }
        self.point = Some(point);
        if !quantities.is_empty() {
            self.probe.learn(self.arm, &quantities);
            let what = Defined::Point {
                first: self.first,
                end: self.end,
            };
            self.steps.push(Step::Define { what, quantities });
        }
        Ok(())
    }

    /// The equations at hand: the known matrix against the rows left, with the outer rows on either side.
    pub(super) fn equations(&self) -> Vec<(Source, Transform, Transform)> {
        let (first, end) = (self.first, self.end);
        let mut found = Vec::new();
        for (left, right) in [(false, false), (true, false), (false, true), (true, true)] {
            let rows = (
                first + usize::from(left),
                end.saturating_sub(usize::from(right)),
            );
            if rows.0 > rows.1 || (left && right && end - first < 2) {
                continue;
            }
            let mut known = self.known.clone();
            if right {
                known = known.times(&self.arm.link(end - 1).inverse());
                if let Some(point) = &self.point {
                    known
                        .0
                        .iter_mut()
                        .zip(point)
                        .for_each(|(row, entry)| row[3] = entry.clone());
                }
            }
            if left {
                known = self.arm.link(first).inverse().times(&known);
            }
            let source = Source {
                moved: (left, right),
                rows,
                entries: Vec::new(),
                squares: false,
            };
            found.push((source, known, self.arm.product(rows.0, rows.1)));
        }
        found
    }
}

impl Rule {
    /// Every polynomial in the rule.
    pub(crate) fn polys(&self) -> Vec<&Poly> {
        match self {
            Self::Two {
                a,
                b,
                k,
                sine_square,
            } => [a, b, k].into_iter().chain(sine_square).collect(),
            Self::One { sin, cos } => vec![sin, cos],
            Self::Slide { above, below } => vec![above, below],
            Self::Square { coefficients } => coefficients.iter().collect(),
        }
    }
}

/// Leaves out what no later step uses, and what is not used elsewhere; how many of the first `at` steps stay.
pub(super) fn drop_unused(steps: &mut Vec<Step>, mut used: Vec<Var>, at: usize) -> usize {
    for step in steps.iter_mut().rev() {
        match step {
            Step::Define { quantities, .. } => {
                quantities.retain(|(var, _)| used.contains(var));
                used.extend(quantities.iter().flat_map(|(_, poly)| poly.vars()));
            }
            Step::Joint { rule, .. } => {
                used.extend(rule.polys().iter().flat_map(|poly| poly.vars()))
            }
        }
    }
    let stays =
        |step: &Step| !matches!(step, Step::Define { quantities, .. } if quantities.is_empty());
    let left = steps[..at].iter().filter(|step| stays(step)).count();
    steps.retain(stays);
    left
}
