//! Many poses in one call, several per register, without allocation.
//!
//! Values lie joint by joint and entry by entry (structure of arrays), so that neighbouring poses fill the lanes of
//! a register. The width is chosen when the program runs: eight poses at once with AVX-512, four with AVX2, two
//! with NEON, one elsewhere.

use std::ops::Range;

use nalgebra::{Matrix3, Rotation3, Vector3};
use pulp::{Arch, Simd, WithSimd};

use super::kernel::Frame;
use super::tile::{self, TILE};
use super::{lanes, ortho, single};
use crate::error::{Error, Result};
use crate::model::{Canonical, Chain, Names, Ortho, PACK, Step};
use crate::spatial::Pose;

/// Rows of equal length, each beginning on a cache line: then no register straddles two of them.
#[derive(Clone, Debug)]
struct Rows {
    count: usize,
    stride: usize,
    /// Where the first row begins; a clone lies elsewhere and is merely slower.
    start: usize,
    values: Vec<f64>,
}

/// Doubles on a cache line.
const LINE: usize = 8;

impl Rows {
    fn zeros(rows: usize, count: usize) -> Self {
        // Rows a power of two apart would share their places in the cache: an odd number of tiles keeps them apart.
        let lines = count.div_ceil(LINE).next_multiple_of(TILE);
        let stride = LINE
            * if (lines / TILE).is_multiple_of(2) {
                lines + TILE
            } else {
                lines
            };
        let values = vec![0.0; rows * stride + LINE];
        let start = values.as_ptr().align_offset(LINE * size_of::<f64>());
        Self {
            count,
            stride,
            start: if start < LINE { start } else { 0 },
            values,
        }
    }

    #[inline(always)]
    fn row(&self, row: usize) -> &[f64] {
        &self.values[self.start + row * self.stride..][..self.count]
    }

    fn row_mut(&mut self, row: usize) -> &mut [f64] {
        &mut self.values[self.start + row * self.stride..][..self.count]
    }

    /// All rows at once, to change.
    fn rows_mut(&mut self) -> impl Iterator<Item = &mut [f64]> {
        let (count, start) = (self.count, self.start);
        let rows = self.values[start..].chunks_exact_mut(self.stride.max(1));
        rows.map(move |row| &mut row[..count])
    }
}

/// Joint vectors, joint by joint.
#[derive(Clone, Debug)]
pub struct JointBatch {
    dof: usize,
    rows: Rows,
}

impl JointBatch {
    /// Room for `count` vectors of `dof` values, all zero.
    pub fn zeros(dof: usize, count: usize) -> Self {
        Self {
            dof,
            rows: Rows::zeros(dof, count),
        }
    }

    /// The number of vectors.
    pub fn count(&self) -> usize {
        self.rows.count
    }

    /// All values of joint `joint`, one for each vector.
    #[inline(always)]
    pub fn joint(&self, joint: usize) -> &[f64] {
        self.rows.row(joint)
    }

    /// All values of joint `joint`, to change.
    pub fn joint_mut(&mut self, joint: usize) -> &mut [f64] {
        self.rows.row_mut(joint)
    }

    /// Sets vector `index`.
    pub fn set(&mut self, index: usize, q: &[f64]) {
        for (joint, &value) in q.iter().enumerate() {
            self.joint_mut(joint)[index] = value;
        }
    }
}

/// Entries of a pose's upper three rows.
pub(crate) const ENTRIES: usize = 12;

/// Poses, entry by entry: columns n, s, a, p, each downwards.
#[derive(Clone, Debug)]
pub struct PoseBatch {
    rows: Rows,
}

impl PoseBatch {
    /// Room for `count` poses.
    pub fn zeros(count: usize) -> Self {
        Self {
            rows: Rows::zeros(ENTRIES, count),
        }
    }

    /// The number of poses.
    pub fn count(&self) -> usize {
        self.rows.count
    }

    /// Entry `row`, `column` of every pose; column 3 is the position.
    pub fn entry(&self, row: usize, column: usize) -> &[f64] {
        self.rows.row(3 * column + row)
    }

    /// Pose `index`.
    pub fn get(&self, index: usize) -> Pose {
        let matrix = Matrix3::from_fn(|row, column| self.entry(row, column)[index]);
        let position = Vector3::from_fn(|row, _| self.entry(row, 3)[index]);
        Pose::from_parts(position.into(), Rotation3::from_matrix_unchecked(matrix))
    }
}

/// The tool's pose for every joint vector.
///
/// Equal to [`tool_pose`](super::tool_pose) of each to rounding. Allocates nothing.
///
/// # Errors
/// An input error if the batches' sizes do not fit, or naming the first vector with a value that is not finite.
///
/// ```
/// use pieper::kinematics::batch::{JointBatch, PoseBatch, tool_poses};
/// use pieper::describe::Robot;
/// let text = "name = 'r'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5";
/// let chain = Robot::from_toml("r.toml", text)?.chain()?;
/// let mut q = JointBatch::zeros(1, 1000);
/// q.set(7, &[0.3]);
/// let mut poses = PoseBatch::zeros(1000);
/// tool_poses(&chain, &q, &mut poses)?;
/// assert!((poses.get(7).translation.vector.x - 0.5 * 0.3_f64.cos()).abs() < 1e-15);
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn tool_poses(chain: &Chain, q: &JointBatch, poses: &mut PoseBatch) -> Result<()> {
    check_sizes(chain, q, poses)?;
    if q.count() == 0 {
        return Ok(());
    }
    let mut rows = poses.rows.rows_mut();
    let out: [&mut [f64]; ENTRIES] = std::array::from_fn(|_| rows.next().unwrap_or_default());
    run(chain.canonical(), q, 0, out)
}

/// As [`tool_poses`], over all cores.
///
/// # Errors
/// As [`tool_poses`]; of several vectors that are not finite, any one is named.
#[cfg(feature = "rayon")]
pub fn tool_poses_parallel(chain: &Chain, q: &JointBatch, poses: &mut PoseBatch) -> Result<()> {
    use rayon::prelude::*;
    check_sizes(chain, q, poses)?;
    let count = q.count();
    if count == 0 {
        return Ok(());
    }
    // Pieces small enough to share evenly, large enough that starting one does not show.
    const PIECE: usize = 4096;
    let mut pieces: Vec<[&mut [f64]; ENTRIES]> = (0..count.div_ceil(PIECE))
        .map(|_| std::array::from_fn(|_| Default::default()))
        .collect();
    for (entry, values) in poses.rows.rows_mut().take(ENTRIES).enumerate() {
        for (piece, part) in pieces.iter_mut().zip(values.chunks_mut(PIECE)) {
            piece[entry] = part;
        }
    }
    let canonical = chain.canonical();
    pieces
        .into_par_iter()
        .enumerate()
        .try_for_each(|(index, out)| run(canonical, q, index * PIECE, out))
}

fn check_sizes(chain: &Chain, q: &JointBatch, poses: &PoseBatch) -> Result<()> {
    if q.dof != chain.dof() {
        let text = format!("{} joints were expected, {} were given", chain.dof(), q.dof);
        return Err(Error::input("joint batch", text));
    }
    if poses.count() != q.count() {
        let (needed, given) = (q.count(), poses.count());
        let text = format!("room for {needed} poses was expected, there is room for {given}");
        return Err(Error::input("pose batch", text));
    }
    Ok(())
}

/// The poses of the vectors from `start` on, as many as `out` has room for.
fn run(
    canonical: &Canonical,
    q: &JointBatch,
    start: usize,
    out: [&mut [f64]; ENTRIES],
) -> Result<()> {
    let bad = Arch::new().dispatch(Batch {
        canonical,
        q,
        start,
        out,
    });
    bad.map_or(Ok(()), |index| {
        Err(Error::input(
            format!("joint vector {index}"),
            "a value is not a finite number",
        ))
    })
}

struct Batch<'a> {
    canonical: &'a Canonical,
    q: &'a JointBatch,
    start: usize,
    out: [&'a mut [f64]; ENTRIES],
}

impl WithSimd for Batch<'_> {
    /// The first vector that is not finite.
    type Output = Option<usize>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Option<usize> {
        let Self {
            canonical,
            q,
            start,
            mut out,
        } = self;
        let count = out[0].len();
        let width = S::F64_LANES;
        // A single lane has no fused multiply-add to reduce angles with: the plain way is the faster one there.
        let registers = if width > 1 { count / width } else { 0 };
        let mut done = 0;
        while done < registers {
            done = tiles(simd, canonical, q, start, &mut out, done..registers);
            if done < registers {
                let mut lanes = done * width..(done + 1) * width;
                let bad = lanes.find_map(|at| plain(canonical, q, start + at, &mut out, at));
                if bad.is_some() {
                    return bad;
                }
                done += 1;
            }
        }
        (registers * width..count).find_map(|at| plain(canonical, q, start + at, &mut out, at))
    }
}

/// Runs tiles of registers; the first register that has to go the long way, or the end.
#[inline(always)]
fn tiles<S: Simd>(
    simd: S,
    canonical: &Canonical,
    q: &JointBatch,
    start: usize,
    out: &mut [&mut [f64]; ENTRIES],
    registers: Range<usize>,
) -> usize {
    // Rows of registers, found once: finding them again for each step costs as much as the arithmetic of a link.
    let row = |variable: usize| S::as_simd_f64s(&q.joint(variable)[start..]).0;
    let mut rows: [&[S::f64s]; PACK] = [&[]; PACK];
    for (variable, place) in rows.iter_mut().enumerate().take(q.dof) {
        *place = row(variable);
    }
    let mut columns: [&mut [S::f64s]; ENTRIES] = Default::default();
    for (column, entries) in columns.iter_mut().zip(out.iter_mut()) {
        *column = S::as_mut_simd_f64s(entries).0;
    }
    if let Some(arm) = canonical.ortho() {
        return by_formulas(simd, arm, &rows, &mut columns, registers);
    }
    let names = Names::before(&canonical.steps);
    let mut first = registers.start;
    while first < registers.end {
        let last = registers.end.min(first + TILE);
        let joint = |variable: usize| match rows.get(variable) {
            Some(row) => &row[first..last],
            None => &row(variable)[first..last],
        };
        let entries = columns.each_mut().map(|column| &mut column[first..last]);
        if !tile::poses(simd, canonical, names, joint, entries) {
            return first;
        }
        first = last;
    }
    first
}

/// As [`tiles`], for the most common kind of arm.
#[inline(always)]
fn by_formulas<S: Simd>(
    simd: S,
    arm: &Ortho,
    rows: &[&[S::f64s]; PACK],
    columns: &mut [&mut [S::f64s]; ENTRIES],
    registers: Range<usize>,
) -> usize {
    let end = registers.end;
    let [a, b, c, d, e, f] = arm.variables.map(|variable| rows[variable]);
    for index in registers {
        let joints = [a[index], b[index], c[index], d[index], e[index], f[index]];
        let (Frame { x, y, z, p }, sizes) = ortho::poses(simd, arm, joints);
        let entries = [x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z, p.x, p.y, p.z];
        for (column, value) in columns.iter_mut().zip(entries) {
            column[index] = value;
        }
        if !lanes::all_small(sizes) {
            return index;
        }
    }
    end
}

/// One pose with the standard library's sine and cosine; the vector's index if a value is not finite.
fn plain(
    canonical: &Canonical,
    q: &JointBatch,
    from: usize,
    out: &mut [&mut [f64]; ENTRIES],
    to: usize,
) -> Option<usize> {
    let value = |step: &Step| {
        step.drive
            .factor
            .mul_add(q.joint(step.drive.variable)[from], step.drive.offset)
    };
    if !canonical.steps.iter().all(|step| value(step).is_finite()) {
        return Some(from);
    }
    let frame = single::tool_frame_plain(canonical, value, |_, _| {});
    for (entry, value) in [frame.x, frame.y, frame.z, frame.p]
        .into_iter()
        .flatten()
        .enumerate()
    {
        out[entry][to] = value;
    }
    None
}
