//! A tile: a few registers of poses that go through a chain together, step by step.
//!
//! What a step is like is asked once for many poses, and a step is a few short loops: registers are independent of one
//! another, but the operations on one wait for each other, and a processor looks only so far ahead for others.
//!
//! The frames' entries stand where the poses are wanted. A twist by right angles moves none of them: it changes
//! which of the stored columns is called y and which z, and their signs; the first frame is stored so that the last
//! one's columns are what they are called.

use pulp::Simd;

use super::kernel::{Frame, Turn, combine};
use super::lanes::{self, LaneColumn, Lanes, Reduced};
use super::single;
use crate::model::{Canonical, Names, Step, StepRow};
use crate::scalar::Scalar;

/// The most registers in a tile: enough to keep the processor busy, few enough for the nearest cache.
pub(super) const TILE: usize = 16;

/// Some registers of one entry of the poses.
pub(super) type Entries<'a, S> = &'a mut [<S as Simd>::f64s];

/// The poses of up to [`TILE`] registers of joint vectors, `joint` giving those of a variable, entry by entry: columns n,
/// s, a, p, each downwards; `false`, and nothing of use stored, if an angle is too large or not finite.
#[inline(always)]
pub(super) fn poses<'a, S: Simd + 'a>(
    simd: S,
    canonical: &Canonical,
    names: Names,
    joint: impl Fn(usize) -> &'a [S::f64s],
    entries: [Entries<'_, S>; 12],
) -> bool {
    let steps = &canonical.steps[..];
    let base = single::base_frame(&canonical.base);
    let mut tile = Tile::new(simd, names, entries);
    if !upright(&base, steps) {
        tile.fill(&base);
    }
    let mut sizes = Lanes::splat(simd, 0.0);
    let mut turns = Turns::new(simd);
    for (index, step) in steps.iter().enumerate() {
        let values = joint(step.drive.variable);
        // At least the square of the largest displacement: (f q + o)^2 is at most twice the sum of both squares.
        let [factor, offset] =
            [step.drive.factor, step.drive.offset].map(|x| Lanes::splat(simd, 2.0 * x * x));
        sizes = sizes + squares(simd, values).mul_add(factor, offset);
        match StepRow::of(step) {
            Some(row) => {
                turns.set(step, tile.names.signs[0], values);
                match index == 0 && upright(&base, steps) {
                    true => tile.first_row(row, &turns, base.p),
                    false => tile.row(row, &turns),
                }
            }
            None => {
                let names = Names::before(&steps[index + 1..]);
                tile.any_step(step, values, names);
            }
        }
    }
    if canonical.tail.is_some() {
        for index in 0..tile.count {
            let mut frame = tile.get(index);
            single::append_tail(&mut frame, canonical, |value| Lanes::splat(simd, value));
            tile.set(index, &frame);
        }
    }
    let small = simd.less_than_f64s(
        sizes.value,
        simd.splat_f64s(lanes::MAX_REDUCED * lanes::MAX_REDUCED),
    );
    lanes::all_true(simd, small)
}

/// Whether the first joint turns about the world's z: the first turn then is the frame, nothing to be multiplied.
#[inline(always)]
fn upright(base: &Frame<[f64; 3]>, steps: &[Step]) -> bool {
    let is_turned = [base.x, base.y, base.z] != [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    !is_turned && steps.first().and_then(StepRow::of).is_some()
}

/// The sum of the squares of a step's values: unlike a maximum, it keeps what is not a number.
#[inline(always)]
fn squares<S: Simd>(simd: S, values: &[S::f64s]) -> Lanes<S> {
    let (fours, rest) = values.as_chunks::<4>();
    let mut sums = [Lanes::splat(simd, 0.0); 4];
    let add = |sum: &mut Lanes<S>, value: S::f64s| {
        let value = Lanes { simd, value };
        *sum = value.mul_add(value, *sum);
    };
    for [a, b, c, d] in fours {
        add(&mut sums[0], *a);
        add(&mut sums[1], *b);
        add(&mut sums[2], *c);
        add(&mut sums[3], *d);
    }
    for &value in rest {
        add(&mut sums[0], value);
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}

/// Sines and cosines of a tile.
// Aligned so that no register straddles two cache lines.
#[repr(align(64))]
struct Turns<S: Simd> {
    simd: S,
    reduced: [Reduced<S>; TILE],
    turns: [Turn<Lanes<S>>; TILE],
}

impl<S: Simd> Turns<S> {
    #[inline(always)]
    fn new(simd: S) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        Self {
            simd,
            reduced: [lanes::reduced(zero); TILE],
            turns: [Turn {
                sin: zero,
                cos: zero,
            }; TILE],
        }
    }

    /// The turns of a step, the other way round if `sign` is below zero.
    #[inline(always)]
    fn set(&mut self, step: &Step, sign: f64, values: &[S::f64s]) {
        let simd = self.simd;
        let [factor, offset] =
            [step.drive.factor, step.drive.offset].map(|value| Lanes::splat(simd, sign * value));
        for (reduced, &value) in self.reduced.iter_mut().zip(values) {
            *reduced = lanes::reduced(Lanes { simd, value }.mul_add(factor, offset));
        }
        for (turn, (reduced, _)) in self.turns.iter_mut().zip(self.reduced.iter().zip(values)) {
            *turn = reduced.sin_cos();
        }
    }
}

/// A column of the frames.
struct Stored<'a, S: Simd>([Entries<'a, S>; 3]);

impl<S: Simd> Stored<'_, S> {
    #[inline(always)]
    fn get(&self, simd: S, index: usize) -> LaneColumn<S> {
        let [x, y, z] = &self.0;
        LaneColumn {
            simd,
            x: x[index],
            y: y[index],
            z: z[index],
        }
    }

    #[inline(always)]
    fn set(&mut self, index: usize, &LaneColumn { x, y, z, .. }: &LaneColumn<S>) {
        let [xs, ys, zs] = &mut self.0;
        (xs[index], ys[index], zs[index]) = (x, y, z);
    }

    /// The same column everywhere.
    #[inline(always)]
    fn fill(&mut self, simd: S, column: [f64; 3], sign: f64) {
        for (entries, value) in self.0.iter_mut().zip(column) {
            entries.fill(simd.splat_f64s(sign * value));
        }
    }

    /// Turns two columns towards one another.
    #[inline(always)]
    fn turn(&mut self, simd: S, other: &mut Self, turns: &[Turn<Lanes<S>>]) {
        let ([a, b, c], [d, e, f]) = (&mut self.0, &mut other.0);
        // Iterators over all at once: no bounds to check in the loop.
        let first = a.iter_mut().zip(b.iter_mut()).zip(c.iter_mut());
        let second = d.iter_mut().zip(e.iter_mut()).zip(f.iter_mut());
        for ((((a, b), c), ((d, e), f)), turn) in first.zip(second).zip(turns) {
            let column = |x: &S::f64s, y: &S::f64s, z: &S::f64s| LaneColumn {
                simd,
                x: *x,
                y: *y,
                z: *z,
            };
            let (u, v) = combine(&column(a, b, c), &column(d, e, f), turn);
            (*a, *b, *c) = (u.x, u.y, u.z);
            (*d, *e, *f) = (v.x, v.y, v.z);
        }
    }

    /// Shifts origins along an axis.
    #[inline(always)]
    fn shift(&mut self, simd: S, axis: &Self, by: f64) {
        if by == 0.0 {
            return;
        }
        let by = Lanes::splat(simd, by);
        for (origins, axes) in self.0.iter_mut().zip(&axis.0) {
            for (origin, &value) in origins.iter_mut().zip(axes.iter()) {
                let before = Lanes {
                    simd,
                    value: *origin,
                };
                *origin = Lanes { simd, value }.mul_add(by, before).value;
            }
        }
    }
}

struct Tile<'a, S: Simd> {
    simd: S,
    x: Stored<'a, S>,
    y: Stored<'a, S>,
    z: Stored<'a, S>,
    p: Stored<'a, S>,
    count: usize,
    names: Names,
}

impl<'a, S: Simd> Tile<'a, S> {
    #[inline(always)]
    fn new(simd: S, names: Names, entries: [Entries<'a, S>; 12]) -> Self {
        let count = entries[0].len();
        let [a, b, c, d, e, f, g, h, i, j, k, l] = entries;
        Self {
            simd,
            x: Stored([a, b, c]),
            y: Stored([d, e, f]),
            z: Stored([g, h, i]),
            p: Stored([j, k, l]),
            count,
            names,
        }
    }

    /// The same frame everywhere.
    #[inline(always)]
    fn fill(&mut self, frame: &Frame<[f64; 3]>) {
        let simd = self.simd;
        let (y, z) = match self.names.swapped {
            true => (&mut self.z, &mut self.y),
            false => (&mut self.y, &mut self.z),
        };
        let [sign_y, sign_z] = self.names.signs;
        self.x.fill(simd, frame.x, 1.0);
        y.fill(simd, frame.y, sign_y);
        z.fill(simd, frame.z, sign_z);
        self.p.fill(simd, frame.p, 1.0);
    }

    /// As [`Tile::row`], on a frame without any turn and with its origin at `p`.
    #[inline(always)]
    fn first_row(&mut self, row: StepRow, turns: &Turns<S>, [x, y, z]: [f64; 3]) {
        let simd = self.simd;
        let (second, third) = match self.names.swapped {
            true => (&mut self.z, &mut self.y),
            false => (&mut self.y, &mut self.z),
        };
        let [sign_y, sign_z] = self.names.signs;
        // The columns (1, 0, 0) and (0, sign, 0), turned.
        let flip = |value: Lanes<S>| if sign_y < 0.0 { -value } else { value };
        let [a, b, c] = &mut self.x.0;
        for ((a, b), turn) in a.iter_mut().zip(b.iter_mut()).zip(&turns.turns) {
            (*a, *b) = (turn.cos.value, flip(turn.sin).value);
        }
        c.fill(simd.splat_f64s(0.0));
        let [a, b, c] = &mut second.0;
        for ((a, b), turn) in a.iter_mut().zip(b.iter_mut()).zip(&turns.turns) {
            (*a, *b) = ((-turn.sin).value, flip(turn.cos).value);
        }
        c.fill(simd.splat_f64s(0.0));
        third.fill(simd, [0.0, 0.0, 1.0], sign_z);
        self.p.fill(simd, [x, y, z + row.d], 1.0);
        self.p.shift(simd, &self.x, row.a);
        self.names = self.names.twisted(row.quarters);
    }

    /// The frame of register `index`.
    #[inline(always)]
    fn get(&self, index: usize) -> Frame<LaneColumn<S>> {
        let simd = self.simd;
        let (y, z) = match self.names.swapped {
            true => (&self.z, &self.y),
            false => (&self.y, &self.z),
        };
        let [sign_y, sign_z] = self.names.signs;
        Frame {
            x: self.x.get(simd, index),
            y: y.get(simd, index).signed(sign_y),
            z: z.get(simd, index).signed(sign_z),
            p: self.p.get(simd, index),
        }
    }

    #[inline(always)]
    fn set(&mut self, index: usize, frame: &Frame<LaneColumn<S>>) {
        let [sign_y, sign_z] = self.names.signs;
        let (y, z) = (frame.y.signed(sign_y), frame.z.signed(sign_z));
        let (y, z) = if self.names.swapped { (z, y) } else { (y, z) };
        self.x.set(index, &frame.x);
        self.y.set(index, &y);
        self.z.set(index, &z);
        self.p.set(index, &frame.p);
    }

    /// Runs a step that is a row. `turns` go the other way where y has the other sign.
    #[inline(always)]
    fn row(&mut self, row: StepRow, turns: &Turns<S>) {
        let simd = self.simd;
        let (y, z) = match self.names.swapped {
            true => (&mut self.z, &self.y),
            false => (&mut self.y, &self.z),
        };
        self.x.turn(simd, y, &turns.turns);
        self.p.shift(simd, z, self.names.signs[1] * row.d);
        self.p.shift(simd, &self.x, row.a);
        self.names = self.names.twisted(row.quarters);
    }

    /// Runs a step that slides, or whose link is no row; `names` are those behind it.
    #[inline(always)]
    fn any_step(&mut self, step: &Step, values: &[S::f64s], names: Names) {
        let simd = self.simd;
        let splat = |value: f64| Lanes::splat(simd, value);
        let (factor, offset) = (splat(step.drive.factor), splat(step.drive.offset));
        let before = self.names;
        for (index, &value) in values.iter().enumerate().take(self.count) {
            self.names = before;
            let mut frame = self.get(index);
            let by = Lanes { simd, value }.mul_add(factor, offset);
            if step.turns {
                frame.turn_z(&lanes::sin_cos(by));
            } else {
                frame.shift_z(&by);
            }
            single::append_link(&mut frame, &step.link, splat);
            self.names = names;
            self.set(index, &frame);
        }
    }
}
