//! Forward kinematics with as few operations as can be: the rows' product from tool to base.

use pieper::describe::Convention;
use pieper::kinematics::kernel::Turn;
use pieper::spatial::Quarters;

use super::graph::{Graph, Id, Operations};
use crate::angle;
use crate::arm::{Arm, positive};
use crate::names::AngleMeaning;
use crate::poly::Poly;
use crate::transform::Transform;

/// The rows of the pose's matrix as nodes of a graph.
pub(crate) struct Forward {
    pub(crate) graph: Graph,
    pub(crate) pose: [[Id; 4]; 3],
}

/// The operations of the generated forward kinematics.
pub fn operations(arm: &Arm) -> Operations {
    let forward = best(arm);
    forward.graph.operations(forward.pose.as_flattened())
}

/// The way with fewest operations: all columns, or two of them and the third by a cross product.
pub(crate) fn best(arm: &Arm) -> Forward {
    let base = forward(arm);
    let mut found: Option<(usize, Forward)> = None;
    for crossed in [None, Some(0), Some(1), Some(2)] {
        let mut other = Forward {
            graph: base.graph.clone(),
            pose: base.pose,
        };
        if let Some(column) = crossed {
            cross(&mut other, column);
        }
        translate(arm, &mut other);
        let total = other.graph.operations(other.pose.as_flattened()).total();
        if found.as_ref().is_none_or(|(least, _)| total < *least) {
            found = Some((total, other));
        }
    }
    found.map_or(base, |(_, forward)| forward)
}

/// Column `at` of the rotation as the cross product of the two behind it, cyclically.
fn cross(forward: &mut Forward, at: usize) {
    let (a, b) = ((at + 1) % 3, (at + 2) % 3);
    let Forward { graph, pose } = forward;
    let entries = *pose;
    for row in 0..3 {
        let (i, j) = ((row + 1) % 3, (row + 2) % 3);
        let first = graph.mul(entries[i][a], entries[j][b]);
        let second = graph.mul(entries[j][a], entries[i][b]);
        pose[row][at] = graph.sub(first, second);
    }
}

/// Adds the last row's shifts: they are along columns of the rotation that is there already.
fn translate(arm: &Arm, forward: &mut Forward) {
    let Some(shift) = last_shift(arm) else { return };
    let Forward { graph, pose } = forward;
    for row in pose.iter_mut() {
        for (column, length) in shift.iter().enumerate() {
            let length = graph.poly(&arm.names, length);
            let part = graph.mul(length, row[column]);
            row[3] = graph.add(row[3], part);
        }
    }
}

/// Where the tool point is, seen from the last row's joint axis, in the tool's axes; `None` where the position is
/// carried along as it is.
fn last_shift(arm: &Arm) -> Option<[Poly; 3]> {
    let last = arm
        .rows
        .last()
        .filter(|_| arm.tool.is_none() && arm.convention == Convention::Standard)?;
    if !last.turns {
        return None;
    }
    // Rz(theta) Tz(d) Tx(a) Rx(alpha): the shift (a, 0, d) in the axes behind Rx.
    Some([
        last.a.clone(),
        &last.d * &last.alpha.sin,
        &last.d * &last.alpha.cos,
    ])
}

/// A turn about z that waits for the ones before it, and shifts that wait with it.
struct Pending {
    offset: Turn<Poly>,
    sum: Vec<(usize, i8)>,
    shifts: Vec<Shift>,
}

/// A shift that waits, and the part of the sum that turns it: of the joints before it.
struct Shift {
    x: Poly,
    z: Poly,
    offset: Turn<Poly>,
    joints: Vec<(usize, i8)>,
}

struct Builder<'a> {
    arm: &'a Arm,
    graph: Graph,
    /// Rows of rotation and position.
    rows: [[Id; 4]; 3],
    pending: Option<Pending>,
}

fn forward(arm: &Arm) -> Forward {
    let mut graph = Graph::default();
    let (zero, one) = (graph.zero(), graph.number(crate::number::whole(1)));
    let rows = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { one } else { zero }));
    let mut builder = Builder {
        arm,
        graph,
        rows,
        pending: None,
    };
    if let Some(tool) = &arm.tool {
        builder.rigid(tool);
    }
    for index in (0..arm.dof()).rev() {
        builder.row(index);
    }
    builder.flush();
    if let Some(base) = &arm.base {
        builder.rigid(base);
    }
    Forward {
        graph: builder.graph,
        pose: builder.rows,
    }
}

impl Builder<'_> {
    fn row(&mut self, index: usize) {
        let row = &self.arm.rows[index];
        let is_last = index + 1 == self.arm.dof() && last_shift(self.arm).is_some();
        let (a, d) = if is_last {
            (Poly::zero(), Poly::zero())
        } else {
            (row.a.clone(), row.d.clone())
        };
        let own = if row.turns {
            vec![(index, row.sign)]
        } else {
            Vec::new()
        };
        match self.arm.convention {
            Convention::Standard => {
                self.about_x(&row.alpha, row.quarters());
                self.shift(a, d);
                self.about_z(&row.offset, &own);
            }
            Convention::Modified => {
                self.shift(Poly::zero(), d);
                self.about_z(&row.offset, &own);
                self.shift(a, Poly::zero());
                self.about_x(&row.alpha, row.quarters());
            }
        }
    }

    fn about_z(&mut self, offset: &Turn<Poly>, own: &[(usize, i8)]) {
        let pending = self.pending.get_or_insert_with(|| Pending {
            offset: angle::still(),
            sum: Vec::new(),
            shifts: Vec::new(),
        });
        pending.offset = angle::sum(offset, &pending.offset);
        pending.sum.splice(0..0, own.iter().copied());
        for shift in &mut pending.shifts {
            shift.offset = angle::sum(offset, &shift.offset);
            shift.joints.splice(0..0, own.iter().copied());
        }
    }

    fn shift(&mut self, a: Poly, d: Poly) {
        if a.is_zero() && d.is_zero() {
            return;
        }
        match &mut self.pending {
            Some(pending) => pending.shifts.push(Shift {
                x: a,
                z: d,
                offset: angle::still(),
                joints: Vec::new(),
            }),
            None => {
                let (a, d) = (
                    self.graph.poly(&self.arm.names, &a),
                    self.graph.poly(&self.arm.names, &d),
                );
                self.rows[0][3] = self.graph.add(self.rows[0][3], a);
                self.rows[2][3] = self.graph.add(self.rows[2][3], d);
            }
        }
    }

    fn about_x(&mut self, turn: &Turn<Poly>, quarters: Option<Quarters>) {
        if quarters == Some(Quarters::None) {
            return;
        }
        self.flush();
        let (sin, cos) = self.turn(turn);
        self.mix(1, 2, sin, cos);
    }

    /// Rows i and j become `cos i - sin j` and `sin i + cos j`.
    fn mix(&mut self, i: usize, j: usize, sin: Id, cos: Id) {
        for column in 0..4 {
            let pair = (self.rows[i][column], self.rows[j][column]);
            (self.rows[i][column], self.rows[j][column]) = self.graph.turned((sin, cos), pair);
        }
    }

    fn turn(&mut self, turn: &Turn<Poly>) -> (Id, Id) {
        (
            self.graph.poly(&self.arm.names, &turn.sin),
            self.graph.poly(&self.arm.names, &turn.cos),
        )
    }

    /// Does what waits: turns once by the sum, then adds the shifts, each turned by its part of the sum.
    fn flush(&mut self) {
        let Some(pending) = self.pending.take() else {
            return;
        };
        let total = self.total(&pending.offset, &pending.sum);
        let (sin, cos) = self.turn(&total);
        self.mix(0, 1, sin, cos);
        for shift in &pending.shifts {
            let (a, d) = (&shift.x, &shift.z);
            let partial = self.total(&shift.offset, &shift.joints);
            let (sin, cos) = self.turn(&partial);
            let (a, d) = (
                self.graph.poly(&self.arm.names, a),
                self.graph.poly(&self.arm.names, d),
            );
            for (row, factor) in [(0, cos), (1, sin)] {
                let part = self.graph.mul(a, factor);
                self.rows[row][3] = self.graph.add(self.rows[row][3], part);
            }
            self.rows[2][3] = self.graph.add(self.rows[2][3], d);
        }
    }

    /// A constant turn and a sum of joints, by the sum's name where it has one.
    fn total(&self, offset: &Turn<Poly>, sum: &[(usize, i8)]) -> Turn<Poly> {
        let names = &self.arm.names;
        let sign = sum.first().map_or(1, |(_, sign)| *sign);
        let named = match sum {
            [] => None,
            [(joint, _)] => names.find_angle(&AngleMeaning::Joint(*joint)),
            sum => names.find_angle(&AngleMeaning::Sum(positive(sum))),
        };
        let turn = match named {
            Some(angle) => {
                let turn = angle::turn(angle);
                if sign < 0 {
                    angle::opposite(&turn)
                } else {
                    turn
                }
            }
            None => crate::basis::expanded(names, sum).unwrap_or_else(angle::still),
        };
        angle::sum(offset, &turn)
    }

    fn rigid(&mut self, transform: &Transform) {
        let entries = transform.0.each_ref().map(|row| {
            row.each_ref()
                .map(|entry| self.graph.poly(&self.arm.names, entry))
        });
        let rows = self.rows;
        for i in 0..3 {
            for column in 0..4 {
                let mut sum = if column == 3 {
                    entries[i][3]
                } else {
                    self.graph.zero()
                };
                for k in 0..3 {
                    let part = self.graph.mul(entries[i][k], rows[k][column]);
                    sum = self.graph.add(sum, part);
                }
                self.rows[i][column] = sum;
            }
        }
    }
}
