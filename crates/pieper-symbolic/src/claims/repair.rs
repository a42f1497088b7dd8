//! The smallest change that makes a claim true: a sign, a sine for a cosine, a wrong index.

use pieper::Result;

use super::ast::{Expr, Node};
use super::meaning::{Leaf, Meaning, Sample, entry_index};
use crate::number;

/// A change that makes a formula right.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Edit {
    /// What kind of slip it is.
    pub(crate) what: String,
    /// The smallest sum or product around it, as it stands.
    pub(crate) before: String,
    /// The same, right.
    pub(crate) after: String,
    /// Where it stands.
    pub(crate) offset: usize,
    /// The whole formula, right.
    pub(crate) fixed: Expr,
}

/// One possible slip.
struct Slip {
    path: Vec<usize>,
    node: Node,
    what: String,
    /// How likely a slip it is; smaller is likelier.
    rank: u8,
}

/// Two slips at once are tried for formulas of up to this many single ones.
const MAX_PAIRS: usize = 150;

/// The smallest change after which `is_right` says yes; `is_near` is a quick test that lets everything right pass.
pub(crate) fn find(
    meaning: &Meaning<'_>,
    side: &Expr,
    is_near: impl Fn(&Expr) -> bool,
    is_right: impl Fn(&Expr) -> Result<bool>,
) -> Result<Option<Edit>> {
    let mut slips = slips(meaning, side);
    slips.sort_by_key(|slip| slip.rank);
    for slip in &slips {
        let Some(fixed) = side.with(&slip.path, slip.node.clone()) else {
            continue;
        };
        if is_near(&fixed) && is_right(&fixed)? {
            return Ok(Some(edit(side, fixed, &slip.path, slip.what.clone())));
        }
    }
    let likely: Vec<&Slip> = slips.iter().filter(|slip| slip.rank < 2).collect();
    if likely.len() > MAX_PAIRS {
        return Ok(None);
    }
    for (index, first) in likely.iter().enumerate() {
        let Some(half) = side.with(&first.path, first.node.clone()) else {
            continue;
        };
        for second in &likely[..index] {
            // A change inside or around the other one would undo it.
            let nested =
                first.path.starts_with(&second.path) || second.path.starts_with(&first.path);
            let Some(fixed) = (!nested)
                .then(|| half.with(&second.path, second.node.clone()))
                .flatten()
            else {
                continue;
            };
            if is_near(&fixed) && is_right(&fixed)? {
                let what = format!("{}; {}", second.what, first.what);
                return Ok(Some(edit(
                    side,
                    fixed,
                    &common(&first.path, &second.path),
                    what,
                )));
            }
        }
    }
    Ok(None)
}

fn common(a: &[usize], b: &[usize]) -> Vec<usize> {
    a.iter()
        .zip(b)
        .take_while(|(a, b)| a == b)
        .map(|(a, _)| *a)
        .collect()
}

fn edit(side: &Expr, fixed: Expr, path: &[usize], what: String) -> Edit {
    // Show the sum around the slip, where there is one that is not the whole formula; or else the product.
    let is_sum = |length: &usize| {
        side.at(&path[..*length])
            .is_some_and(|part| matches!(part.node, Node::Add(..) | Node::Sub(..) | Node::Neg(_)))
    };
    let mut shown = (0..=path.len()).rev().find(is_sum).unwrap_or(0);
    // A chain of sums is one sum to a reader.
    while shown > 0 && is_sum(&(shown - 1)) {
        shown -= 1;
    }
    let too_long = |length: usize| {
        side.at(&path[..length])
            .is_some_and(|part| part.text().len() > 40)
    };
    while shown < path.len() && too_long(shown) {
        shown += 1;
    }
    let text = |expr: &Expr| expr.at(&path[..shown]).map_or_else(String::new, Expr::text);
    let offset = side.at(path).map_or(side.offset, |part| part.offset);
    Edit {
        what,
        before: text(side),
        after: text(&fixed),
        offset,
        fixed,
    }
}

fn slips(meaning: &Meaning<'_>, side: &Expr) -> Vec<Slip> {
    let mut found = Vec::new();
    for path in side.paths() {
        let Some(part) = side.at(&path) else { continue };
        let mut add = |node: Node, what: String, rank: u8| {
            found.push(Slip {
                path: path.clone(),
                node,
                what,
                rank,
            })
        };
        match &part.node {
            Node::Add(a, b) => add(
                Node::Sub(a.clone(), b.clone()),
                format!("the sign of {}", b.text()),
                0,
            ),
            Node::Sub(a, b) => add(
                Node::Add(a.clone(), b.clone()),
                format!("the sign of {}", b.text()),
                0,
            ),
            Node::Neg(a) => {
                add(a.node.clone(), format!("the sign of {}", a.text()), 0);
                if let Node::Number(_) = a.node {
                    add(
                        Node::Number(number::whole(0)),
                        format!("0 for {}", part.text()),
                        3,
                    );
                }
            }
            Node::Call(name, arguments)
                if arguments.len() == 1 && matches!(name.as_str(), "sin" | "cos") =>
            {
                let other = if name == "sin" { "cos" } else { "sin" };
                add(
                    Node::Call(other.to_owned(), arguments.clone()),
                    format!("{other} for {name}"),
                    1,
                );
            }
            Node::Name(base, index) => names(meaning, part, base, index, &mut add),
            Node::Number(value) => {
                // -0 is the business of the sign in front.
                let is_negated = path.split_last().and_then(|(_, above)| side.at(above));
                let is_negated = is_negated.is_some_and(|above| matches!(above.node, Node::Neg(_)));
                for other in [0, 1, -1, 2]
                    .into_iter()
                    .filter(|other| *other > 0 || !is_negated)
                {
                    if *value != number::whole(other) {
                        add(
                            Node::Number(number::whole(other)),
                            format!("{other} for {}", part.text()),
                            3,
                        );
                    }
                }
            }
            Node::Power(a, exponent) => {
                for other in [exponent.saturating_sub(1), exponent + 1] {
                    add(Node::Power(a.clone(), other), "the exponent".to_owned(), 2);
                }
            }
            _ => {}
        }
        // A term without a sign may lack one.
        let is_term = |path: &[usize]| match path.split_last() {
            None => true,
            Some((0, above)) => side
                .at(above)
                .is_some_and(|above| matches!(above.node, Node::Add(..) | Node::Sub(..))),
            Some(_) => false,
        };
        let is_sum = matches!(part.node, Node::Add(..) | Node::Sub(..) | Node::Neg(_));
        if is_term(&path) && !is_sum {
            found.push(Slip {
                path: path.clone(),
                node: Node::Neg(Box::new(part.clone())),
                what: format!("the sign of {}", part.text()),
                rank: 0,
            });
        }
    }
    found
}

/// Slips of one name: the other function, another index, another length.
fn names(
    meaning: &Meaning<'_>,
    part: &Expr,
    base: &str,
    index: &str,
    add: &mut impl FnMut(Node, String, u8),
) {
    let arm = meaning.arm;
    let mut replace = |base: &str, index: String, rank: u8| {
        let what = format!("{} for {}", super::token::joined(base, &index), part.text());
        add(Node::Name(base.to_owned(), index), what, rank);
    };
    if let Ok(Leaf::Matrix(_)) | Err(_) = meaning.leaf(part, base, index) {
        return;
    }
    let is_parameter = arm
        .names
        .symbols()
        .any(|(_, name, _)| name == super::token::joined(base, index));
    let short = meaning.shorthand && matches!(base, "s" | "c" | "S" | "C") && !is_parameter;
    if entry_index(index).is_some() && !short {
        for row in 1..=3 {
            for column in 1..=4 {
                replace(base, format!("{row}{column}"), 2);
            }
        }
        return;
    }
    let joints = (1..=arm.dof()).map(|joint| joint.to_string());
    let sums = arm.parallel.iter().flat_map(|run| {
        let starts = 0..run.len().min(3);
        starts.flat_map(move |start| {
            (start + 2..=run.len()).map(move |end| {
                run[start..end]
                    .iter()
                    .map(|(j, _)| (j + 1).to_string())
                    .collect()
            })
        })
    });
    if short {
        let other = match base {
            "s" => "c",
            "c" => "s",
            "S" => "C",
            _ => "S",
        };
        replace(other, index.to_owned(), 1);
        joints
            .chain(sums)
            .filter(|one| one != index)
            .for_each(|one: String| replace(base, one, 2));
        return;
    }
    match meaning.leaf(part, base, index) {
        Ok(Leaf::Angle(_)) => joints
            .filter(|one| one != index)
            .for_each(|one| replace(base, one, 2)),
        Ok(Leaf::Poly(_)) => {
            let all: Vec<String> = arm
                .names
                .symbols()
                .map(|(_, name, _)| name.to_owned())
                .collect();
            for name in all
                .iter()
                .filter(|name| **name != super::token::joined(base, index))
            {
                if let super::token::Kind::Name(base, index) = super::plain::name(name) {
                    replace(&base, index, 2);
                }
            }
        }
        _ => {}
    }
}

/// Whether two formulas agree at samples, to rounding.
pub(crate) fn agree(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * (1.0 + a.abs().max(b.abs()))
}

/// The difference of two angles, in (-pi, pi].
pub(crate) fn angle_difference(a: f64, b: f64) -> f64 {
    let difference = a - b;
    difference.sin().atan2(difference.cos())
}

/// Values at the samples; `None` where a formula has none.
pub(crate) fn values(meaning: &Meaning<'_>, expr: &Expr, samples: &[Sample]) -> Option<Vec<f64>> {
    samples
        .iter()
        .map(|sample| meaning.value(expr, sample).ok())
        .collect()
}
