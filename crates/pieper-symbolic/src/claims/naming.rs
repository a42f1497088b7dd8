//! What a name in a claim stands for: joint variables, sines and cosines by their shorthands, named lengths, entries.

use pieper::error::{Error, Result};

use super::ast::{Expr, Node};
use super::meaning::{Leaf, Linear, Meaning, entry_index};
use super::token::joined;
use crate::basis;
use crate::names::{AngleMeaning, SymbolMeaning};
use crate::number::{self, Rational};
use crate::poly::Poly;

/// Names that papers give joint variables.
const JOINT_NAMES: [&str; 8] = ["q", "theta", "Theta", "phi", "Phi", "θ", "φ", "vartheta"];

impl Meaning<'_> {
    fn joint(&self, joint: usize) -> Leaf {
        match self.arm.joint_angle(joint) {
            Some(angle) => Leaf::Angle(Linear {
                half_turns: Rational::ZERO,
                terms: vec![(angle, number::whole(1))],
            }),
            None => {
                let slide = self.arm.names.find_symbol(&format!("q{}", joint + 1));
                Leaf::Poly(slide.map_or_else(Poly::zero, Poly::var))
            }
        }
    }

    pub(crate) fn leaf(&self, expr: &Expr, base: &str, index: &str) -> Result<Leaf> {
        if let Some((_, image)) = self.maps.iter().find(|((b, i), _)| b == base && i == index) {
            return self.mapped(image);
        }
        // A whole matrix may be mapped: then s13 is its entry.
        let matrix = self
            .maps
            .iter()
            .find(|((b, i), _)| b == base && i.is_empty());
        if let (Some((_, image)), Some((row, column))) = (matrix, entry_index(index))
            && let Node::Name(base, index) = &image.node
        {
            return self
                .matrix_entry(expr, base, index, row, column)
                .map(Leaf::Poly);
        }
        self.parameter(base, index, true)
            .or_else(|| self.shorthand(base, index))
            .or_else(|| self.variable(base, index))
            .or_else(|| self.quantity(base, index))
            .or_else(|| self.parameter(base, index, false))
            .or_else(|| matches!((base, index), ("pi" | "π", "")).then(half_turn))
            .ok_or_else(|| self.unknown(expr, base, index))
    }

    fn mapped(&self, image: &Expr) -> Result<Leaf> {
        if let Some(linear) = self.linear(image)? {
            return Ok(Leaf::Angle(linear));
        }
        if let Node::Name(base, index) = &image.node {
            return self.leaf(image, base, index);
        }
        match self.fraction(image)? {
            Some(fraction) if fraction.below == Poly::one() => Ok(Leaf::Poly(fraction.above)),
            _ => Err(self.error(image, "a polynomial, an angle or a matrix was expected")),
        }
    }

    /// A length or angle of the table; `exact` as it is written there, otherwise without regard to case.
    fn parameter(&self, base: &str, index: &str, exact: bool) -> Option<Leaf> {
        let is_same = |name: &str| {
            let plain = |text: &str| text.replace('_', "");
            match exact {
                true => plain(name) == format!("{base}{}", plain(index)),
                false => plain(name).eq_ignore_ascii_case(&format!("{base}{}", plain(index))),
            }
        };
        let mut symbols = self.arm.names.symbols();
        if let Some((var, ..)) = symbols
            .find(|(_, name, meaning)| **meaning == SymbolMeaning::Parameter && is_same(name))
        {
            return Some(Leaf::Poly(Poly::var(var)));
        }
        let mut angles = self.arm.names.angles();
        let (angle, _) = angles.find(
            |(_, meaning)| matches!(meaning, AngleMeaning::Parameter(name) if is_same(name)),
        )?;
        Some(Leaf::Angle(Linear {
            half_turns: Rational::ZERO,
            terms: vec![(angle, number::whole(1))],
        }))
    }

    /// `s1`, `c23`: sine and cosine of a joint or of a sum of parallel ones, with the table's signs.
    fn shorthand(&self, base: &str, index: &str) -> Option<Leaf> {
        let is_sin = match base {
            "s" | "S" => true,
            "c" | "C" => false,
            _ => return None,
        };
        if !self.shorthand || index.is_empty() {
            return None;
        }
        let turn = basis::expanded(&self.arm.names, &self.joints_of(index)?)?;
        Some(Leaf::Poly(if is_sin { turn.sin } else { turn.cos }))
    }

    /// The joints an index names: `23` those of parallel axes with the table's signs, `2-3` as it says.
    fn joints_of(&self, index: &str) -> Option<Vec<(usize, i8)>> {
        let mut joints = Vec::new();
        let mut sign = None;
        let separated = index.contains(['_', '+', '-']);
        for part in index.split_inclusive(['_', '+', '-']) {
            let digits = part.trim_end_matches(['_', '+', '-']);
            let numbers: Vec<&str> = match separated || digits.len() < 2 {
                true => vec![digits],
                false => (0..digits.len())
                    .map(|at| digits.get(at..=at).unwrap_or(""))
                    .collect(),
            };
            for number in numbers {
                let joint = number
                    .parse::<usize>()
                    .ok()
                    .filter(|joint| (1..=self.arm.dof()).contains(joint))?;
                joints.push((joint - 1, sign));
            }
            sign = match part.chars().last() {
                Some('+') => Some(1),
                Some('-') => Some(-1),
                _ => None,
            };
        }
        let is_twice = |at: usize| {
            joints[..at]
                .iter()
                .any(|(joint, _): &(usize, Option<i8>)| *joint == joints[at].0)
        };
        if (0..joints.len()).any(is_twice) {
            return None;
        }
        let run = |joint: usize| {
            self.arm
                .parallel
                .iter()
                .find(|run| run.iter().any(|(one, _)| *one == joint))
        };
        let first = joints.first()?.0;
        let shared = run(first).filter(|run| {
            joints
                .iter()
                .all(|(joint, _)| run.iter().any(|(one, _)| one == joint))
        });
        let table_sign = |joint: usize| {
            let found = shared.and_then(|run| run.iter().find(|(one, _)| *one == joint));
            found.map_or(1, |(_, sign)| *sign)
        };
        let lead = table_sign(first);
        Some(
            joints
                .into_iter()
                .map(|(joint, sign)| (joint, sign.unwrap_or(table_sign(joint) * lead)))
                .collect(),
        )
    }

    fn variable(&self, base: &str, index: &str) -> Option<Leaf> {
        let joint = index
            .parse::<usize>()
            .ok()
            .filter(|joint| (1..=self.arm.dof()).contains(joint))?
            - 1;
        let slides = !self.arm.rows[joint].turns;
        let named = JOINT_NAMES.contains(&base) || (slides && base == "d");
        named.then(|| self.joint(joint))
    }

    /// Entries and matrices: `t11`, `x_c`, `n_x`, `A5`, `T6`, `R36`, `J11`.
    fn quantity(&self, base: &str, index: &str) -> Option<Leaf> {
        let count = self.arm.dof();
        let axis = |index: &str| ["x", "y", "z"].iter().position(|known| *known == index);
        let single = |index: &str| {
            index
                .parse::<usize>()
                .ok()
                .filter(|one| (1..=count).contains(one))
        };
        let pair = |index: &str| {
            let (a, b) = (
                index.get(..1)?.parse::<usize>().ok()?,
                index.get(1..)?.parse::<usize>().ok()?,
            );
            (a < b && b <= count).then_some((a, b))
        };
        match (base, index) {
            ("x" | "y" | "z", "c") => axis(base).map(|row| Leaf::Poly(self.pose.entry(row, 3))),
            ("n" | "s" | "a" | "p", index) if axis(index).is_some() => {
                let column = ["n", "s", "a", "p"]
                    .iter()
                    .position(|known| *known == base)?;
                axis(index).map(|row| Leaf::Poly(self.pose.entry(row, column)))
            }
            ("t" | "T", index) if entry_index(index).is_some() => entry_index(index)
                .map(|(row, column)| Leaf::Poly(self.pose.entry(row - 1, column - 1))),
            ("T", "") => Some(Leaf::Matrix(Box::new(self.pose.clone()))),
            ("T", index) if single(index).is_some() => {
                single(index).map(|end| Leaf::Matrix(Box::new(self.arm.product(0, end))))
            }
            ("T" | "R", index) => {
                pair(index).map(|(first, end)| Leaf::Matrix(Box::new(self.arm.product(first, end))))
            }
            ("A", index) => single(index).map(|one| Leaf::Matrix(Box::new(self.arm.link(one - 1)))),
            ("J", index) => {
                let (row, column) = (
                    index.get(..1)?.parse::<usize>().ok()?,
                    index.get(1..)?.parse::<usize>().ok()?,
                );
                let inside = (1..=6).contains(&row) && (1..=count).contains(&column);
                inside.then(|| {
                    Leaf::Poly(crate::jacobian::in_base(self.arm).0[row - 1][column - 1].clone())
                })
            }
            _ => None,
        }
    }

    fn unknown(&self, expr: &Expr, base: &str, index: &str) -> Error {
        let name = joined(base, index);
        let mut known: Vec<String> = self.known_names();
        known.sort_by_key(|known| (edit_distance(&name, known), known.clone()));
        known.truncate(3);
        self.error(
            expr,
            &format!(
                "it stands for nothing here; the nearest names are {}",
                known.join(", ")
            ),
        )
    }

    fn known_names(&self) -> Vec<String> {
        let parameters = self.arm.names.symbols().map(|(_, name, _)| name.to_owned());
        let angles = self
            .arm
            .names
            .angles()
            .filter_map(|(_, meaning)| match meaning {
                AngleMeaning::Parameter(name) => Some(name.clone()),
                _ => None,
            });
        let joints = (1..=self.arm.dof()).flat_map(|joint| {
            let short: &[&str] = if self.shorthand {
                &["q", "s", "c", "A"]
            } else {
                &["q", "A"]
            };
            short
                .iter()
                .map(move |base| format!("{base}{joint}"))
                .collect::<Vec<_>>()
        });
        let entries = (1..=3).flat_map(|row| (1..=4).map(move |column| format!("t{row}{column}")));
        parameters
            .chain(angles)
            .chain(joints)
            .chain(entries)
            .collect()
    }
}

fn half_turn() -> Leaf {
    Leaf::Angle(Linear {
        half_turns: number::whole(1),
        terms: Vec::new(),
    })
}

/// The number of single-character changes between two short names.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().take(100).enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replace = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = replace.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
