//! The Jacobian's determinant in factors: seen from the frame and point where it falls apart best.
//!
//! A change of axes or of the reference point does not change the determinant, but it makes entries vanish: at the
//! wrist centre of an industrial arm the matrix splits into the arm's block and the wrist's. The blocks of a matrix
//! with zeros are those of Dulmage and Mendelsohn (1958).

use crate::arm::Arm;
use crate::basis;
use crate::jacobian::{Jacobian, View};
use crate::names::Angle;
use crate::number::{self, Rational};
use crate::poly::{Monomial, Poly};

/// A determinant as a product.
#[derive(Clone, Debug)]
pub struct Determinant {
    /// The frame whose axes were taken, counted from 0, the base's.
    pub frame: usize,
    /// The frame whose origin was the reference point.
    pub point: usize,
    /// A number in front.
    pub number: Rational,
    /// The factors, each with the joints (from 0) of the block it comes from.
    pub factors: Vec<(Poly, Vec<usize>)>,
}

/// The determinant of the Jacobian; `None` where it is not square. Rows that vanish for every joint vector are left
/// out, so that a SCARA's four by four matrix has one.
pub fn determinant(arm: &Arm) -> Option<Determinant> {
    let count = arm.dof();
    let mut best: Option<(usize, usize, usize, Jacobian, Vec<Block>)> = None;
    for frame in 0..=count {
        let view = View::from(arm, frame);
        for point in 0..=count {
            let jacobian = view.jacobian(arm, point);
            let rows: Vec<usize> = (0..6)
                .filter(|&row| jacobian.0[row].iter().any(|entry| !entry.is_zero()))
                .collect();
            if rows.len() != count {
                continue;
            }
            let blocks = blocks(&jacobian, rows, (0..count).collect());
            let cost = |block: &Block| {
                let terms = entries(&jacobian, block)
                    .map(|entry| entry.terms().len())
                    .sum::<usize>();
                block.rows.len().pow(3) * 100 + terms
            };
            let cost = blocks.iter().map(cost).sum();
            if best.as_ref().is_none_or(|(least, ..)| cost < *least) {
                best = Some((cost, frame, point, jacobian, blocks));
            }
        }
    }
    let (_, frame, point, jacobian, blocks) = best?;
    let order = |of: fn(&Block) -> &Vec<usize>| {
        blocks
            .iter()
            .flat_map(|block| of(block).clone())
            .collect::<Vec<_>>()
    };
    let odd = inversions(&order(|block| &block.rows)) + inversions(&order(|block| &block.columns));
    let mut result = Determinant {
        frame,
        point,
        number: number::whole(if odd.is_multiple_of(2) { 1 } else { -1 }),
        factors: Vec::new(),
    };
    for block in &blocks {
        let value = block_determinant(&jacobian, block)?;
        if value.is_swollen() {
            return None;
        }
        factor(arm, value, &block.columns, &mut result);
    }
    Some(result)
}

/// Rows and columns of a diagonal block.
struct Block {
    rows: Vec<usize>,
    columns: Vec<usize>,
}

fn entries<'a>(jacobian: &'a Jacobian, block: &'a Block) -> impl Iterator<Item = &'a Poly> {
    block.rows.iter().flat_map(move |&row| {
        block
            .columns
            .iter()
            .map(move |&column| &jacobian.0[row][column])
    })
}

/// Splits off the smallest set of rows that live in as many columns, again and again.
fn blocks(jacobian: &Jacobian, mut rows: Vec<usize>, mut columns: Vec<usize>) -> Vec<Block> {
    let mut found = Vec::new();
    while !rows.is_empty() {
        let lives_in = |chosen: &[usize]| -> Vec<usize> {
            let occurs = |column: &&usize| {
                chosen
                    .iter()
                    .any(|&row| !jacobian.0[row][**column].is_zero())
            };
            columns.iter().filter(occurs).copied().collect()
        };
        let mut subsets: Vec<u32> = (1..1_u32 << rows.len()).collect();
        subsets.sort_by_key(|subset| subset.count_ones());
        let split = subsets.into_iter().find_map(|subset| {
            let chosen: Vec<usize> = (0..rows.len())
                .filter(|bit| subset >> bit & 1 == 1)
                .map(|bit| rows[bit])
                .collect();
            let inside = lives_in(&chosen);
            // Fewer columns than rows: the determinant is zero, whatever block shows it.
            (inside.len() <= chosen.len()).then_some((chosen, inside))
        });
        let (chosen, mut inside) = split.unwrap_or_else(|| (rows.clone(), columns.clone()));
        let spare = columns
            .iter()
            .filter(|column| !inside.contains(column))
            .copied();
        let missing: Vec<usize> = spare.take(chosen.len() - inside.len()).collect();
        inside.extend(missing);
        rows.retain(|row| !chosen.contains(row));
        columns.retain(|column| !inside.contains(column));
        found.push(Block {
            rows: chosen,
            columns: inside,
        });
    }
    found
}

fn inversions(order: &[usize]) -> usize {
    let later = |at: usize| {
        order[at + 1..]
            .iter()
            .filter(|&&other| other < order[at])
            .count()
    };
    (0..order.len()).map(later).sum()
}

/// Laplace's expansion by rows, each set of columns once.
fn block_determinant(jacobian: &Jacobian, block: &Block) -> Option<Poly> {
    let size = block.columns.len();
    let mut minors: Vec<Option<Poly>> = vec![None; 1 << size];
    minors[0] = Some(Poly::one());
    for subset in 1_usize..1 << size {
        let row = block.rows[size - subset.count_ones() as usize];
        let mut total = Poly::zero();
        let members: Vec<usize> = (0..size).filter(|bit| subset >> bit & 1 == 1).collect();
        for (place, &member) in members.iter().enumerate() {
            let entry = &jacobian.0[row][block.columns[member]];
            if entry.is_zero() {
                continue;
            }
            let product = entry * minors[subset & !(1 << member)].as_ref()?;
            total = if place % 2 == 0 {
                total + product
            } else {
                total - product
            };
        }
        minors[subset] = Some(total);
    }
    minors.pop().flatten()
}

/// Takes numbers, lengths, sines and cosines out of a block's determinant.
fn factor(arm: &Arm, value: Poly, joints: &[usize], into: &mut Determinant) {
    let mut rest = value;
    if rest.is_zero() {
        into.number = Rational::ZERO;
        return;
    }
    let angles: Vec<Angle> = arm.names.angles().map(|(angle, _)| angle).collect();
    // In single angles first, then in whichever sums make it shortest.
    for _ in 0..2 {
        for &angle in &angles {
            while let Some(quotient) = divided_by_sine(&rest, angle) {
                into.factors.push((Poly::var(angle.sin()), joints.to_vec()));
                rest = quotient;
            }
        }
        let common = rest.common_monomial();
        for (var, exponent) in common.powers() {
            (0..exponent).for_each(|_| into.factors.push((Poly::var(var), joints.to_vec())));
        }
        rest = rest.divided(&common).unwrap_or(rest);
        rest = basis::shortest(arm, &rest);
    }
    let Some(first) = rest.terms().first() else {
        return;
    };
    let magnitude = number::magnitude(&first.coefficient);
    let alike = rest
        .terms()
        .iter()
        .all(|term| number::magnitude(&term.coefficient) == magnitude);
    let negative = number::is_negative(&first.coefficient);
    let scale = if alike {
        first.coefficient.clone()
    } else {
        number::whole(if negative { -1 } else { 1 })
    };
    rest = rest.scaled(&(number::whole(1) / &scale));
    into.number *= scale;
    if rest != Poly::one() {
        into.factors.push((rest, joints.to_vec()));
    }
}

/// `poly / sin(angle)`, if it divides: with `P = P0 + s P1` that is `P1 + s P0 / (1 - c^2)`.
fn divided_by_sine(poly: &Poly, angle: Angle) -> Option<Poly> {
    let (with, without) = poly.split(|monomial| monomial.exponent(angle.sin()) > 0);
    if !poly.contains_angle(angle) || (without.is_zero() && with.is_zero()) {
        return None;
    }
    let degree = without.degree_in(angle.cos());
    let mut coefficients: Vec<Poly> = (0..=degree)
        .map(|power| without.coefficient_of(angle.cos(), power))
        .collect();
    let cosine = Poly::var(angle.cos());
    let mut quotient = Poly::zero();
    while coefficients.len() > 2 {
        let power = coefficients.len() - 3;
        let top = -coefficients.pop()?;
        coefficients[power] = &coefficients[power] - &top;
        quotient = quotient + &top * &cosine.power(power as u32);
    }
    if !coefficients.iter().all(Poly::is_zero) {
        return None;
    }
    let lower = with.divided(&Monomial::of(angle.sin()))?;
    Some(lower + Poly::var(angle.sin()) * quotient)
}
