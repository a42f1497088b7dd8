//! Sines and cosines of constant angles, exactly where they are multiples of 15 degrees, and sums of angles.

use pieper::kinematics::kernel::Turn;

use crate::names::{Angle, Var};
use crate::number;
use crate::poly::Poly;

/// The turn by nothing.
pub(crate) fn still() -> Turn<Poly> {
    Turn {
        sin: Poly::zero(),
        cos: Poly::one(),
    }
}

/// The turn by an angle.
pub(crate) fn turn(angle: Angle) -> Turn<Poly> {
    Turn {
        sin: Poly::var(angle.sin()),
        cos: Poly::var(angle.cos()),
    }
}

/// The turn by the opposite angle.
pub(crate) fn opposite(turn: &Turn<Poly>) -> Turn<Poly> {
    Turn {
        sin: -turn.sin.clone(),
        cos: turn.cos.clone(),
    }
}

/// The turn by the sum of two angles.
pub(crate) fn sum(a: &Turn<Poly>, b: &Turn<Poly>) -> Turn<Poly> {
    Turn {
        sin: &a.sin * &b.cos + &a.cos * &b.sin,
        cos: &a.cos * &b.cos - &a.sin * &b.sin,
    }
}

/// The turn by `steps` times 15 degrees, in roots of 2 and 3.
pub(crate) fn fifteen_degrees(steps: i64) -> Turn<Poly> {
    Turn {
        sin: sine(steps),
        cos: sine(steps + 6),
    }
}

fn sine(steps: i64) -> Poly {
    let steps = steps.rem_euclid(24);
    if steps > 12 {
        return -sine(steps - 12);
    }
    let (root2, root3) = (Poly::var(Var::ROOT2), Poly::var(Var::ROOT3));
    let half = number::ratio(1, 2);
    let quarter = number::ratio(1, 4);
    match steps.min(12 - steps) {
        0 => Poly::zero(),
        1 => (&root2 * &root3 - root2).scaled(&quarter),
        2 => Poly::number(half),
        3 => root2.scaled(&half),
        4 => root3.scaled(&half),
        5 => (&root2 * &root3 + root2).scaled(&quarter),
        _ => Poly::one(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_sines_are_the_sines() {
        for steps in -30..30_i64 {
            let turn = fifteen_degrees(steps);
            let value = |var: Var| {
                if var == Var::ROOT2 {
                    2_f64.sqrt()
                } else {
                    3_f64.sqrt()
                }
            };
            let angle = steps as f64 * std::f64::consts::PI / 12.0;
            assert!(
                (turn.sin.evaluate(&0.0, value) - angle.sin()).abs() < 1e-14,
                "{steps}"
            );
            assert!(
                (turn.cos.evaluate(&0.0, value) - angle.cos()).abs() < 1e-14,
                "{steps}"
            );
            assert_eq!(&turn.sin * &turn.sin + &turn.cos * &turn.cos, Poly::one());
        }
    }
}
