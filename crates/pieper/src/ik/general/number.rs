//! What the resultant is computed in: a register of doubles, or two registers whose sum holds twice the digits.

use pulp::Simd;

use super::tolerances::TOLERANCES;
use crate::ik::lanes::{Lane, Mask, Turn};

/// The arithmetic of one number in each lane.
pub(super) trait Number<S: Simd>: Copy {
    /// Pivots that differ by more than this lose too many digits.
    const PIVOT_RATIO: f64;
    fn of(lane: Lane<S>) -> Self;
    /// Cosine and sine of a turn, to the digits that there are.
    fn circle(turn: Turn<S>) -> (Self, Self);
    /// Rounded to one double.
    fn rounded(self) -> Lane<S>;
    fn plus(self, other: Self) -> Self;
    fn times(self, other: Self) -> Self;
    fn inverse(self) -> Self;
    fn negative(self) -> Self;
    /// `yes` where the mask holds, `no` elsewhere.
    fn pick(mask: Mask<S>, yes: Self, no: Self) -> Self;

    /// `self * factor + addend`.
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        addend.plus(self.times(factor))
    }

    /// `from - self * factor`.
    #[inline(always)]
    fn subtract_product(self, factor: Self, from: Self) -> Self {
        from.plus(self.times(factor).negative())
    }
}

impl<S: Simd> Number<S> for Lane<S> {
    const PIVOT_RATIO: f64 = TOLERANCES.pivot_ratio;

    #[inline(always)]
    fn of(lane: Self) -> Self {
        lane
    }

    #[inline(always)]
    fn circle(turn: Turn<S>) -> (Self, Self) {
        (turn.cos, turn.sin)
    }

    #[inline(always)]
    fn rounded(self) -> Self {
        self
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        self + other
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        self * other
    }

    #[inline(always)]
    fn inverse(self) -> Self {
        self.constant(1.0) / self
    }

    #[inline(always)]
    fn negative(self) -> Self {
        -self
    }

    #[inline(always)]
    fn pick(mask: Mask<S>, yes: Self, no: Self) -> Self {
        mask.pick(yes, no)
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self::mul_add(self, factor, addend)
    }

    #[inline(always)]
    fn subtract_product(self, factor: Self, from: Self) -> Self {
        Self::subtract_product(self, factor, from)
    }
}

/// The sum of two doubles, the second below half a unit in the last place of the first (Dekker, Numer. Math. 18, 1971;
/// the sloppy sum and the product with a fused multiplication as in Joldes, Muller, Popescu, ACM TOMS 44, 2017).
#[derive(Clone, Copy)]
pub(super) struct Double<S: Simd> {
    head: Lane<S>,
    tail: Lane<S>,
}

impl<S: Simd> Double<S> {
    /// The sum of a head and a tail that may overlap, the head not the smaller.
    #[inline(always)]
    pub(super) fn new(head: Lane<S>, tail: Lane<S>) -> Self {
        let sum = head + tail;
        Self {
            head: sum,
            tail: tail - (sum - head),
        }
    }
}

impl<S: Simd> Number<S> for Double<S> {
    const PIVOT_RATIO: f64 = TOLERANCES.precise_pivot_ratio;

    #[inline(always)]
    fn of(lane: Lane<S>) -> Self {
        Self {
            head: lane,
            tail: lane.constant(0.0),
        }
    }

    /// Brought to unit length: structured arms make det S vanish on the circle, not beside it.
    #[inline(always)]
    fn circle(turn: Turn<S>) -> (Self, Self) {
        let (c, s) = (Self::of(turn.cos), Self::of(turn.sin));
        let minus = Self::of(turn.cos.constant(-1.0));
        let excess = c.mul_add(c, s.mul_add(s, minus)).rounded();
        let half = Self::of(excess * excess.constant(-0.5));
        (c.mul_add(half, c), s.mul_add(half, s))
    }

    #[inline(always)]
    fn rounded(self) -> Lane<S> {
        self.head
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        let sum = self.head + other.head;
        let part = sum - self.head;
        let rounding = (self.head - (sum - part)) + (other.head - part);
        Self::new(sum, rounding + (self.tail + other.tail))
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        let product = self.head * other.head;
        let rounding = self.head.fused(other.head, -product);
        let cross = self.tail.fused(other.head, self.head * other.tail);
        Self::new(product, rounding + cross)
    }

    #[inline(always)]
    fn inverse(self) -> Self {
        let one = self.head.constant(1.0);
        let first = one / self.head;
        // One Newton step: first * (2 - self * first).
        let rest = self.times(Self::of(first));
        let missing = Self::of(one).plus(rest.negative()).rounded();
        Self::new(first, first * missing)
    }

    #[inline(always)]
    fn negative(self) -> Self {
        Self {
            head: -self.head,
            tail: -self.tail,
        }
    }

    #[inline(always)]
    fn pick(mask: Mask<S>, yes: Self, no: Self) -> Self {
        Self {
            head: mask.pick(yes.head, no.head),
            tail: mask.pick(yes.tail, no.tail),
        }
    }
}
