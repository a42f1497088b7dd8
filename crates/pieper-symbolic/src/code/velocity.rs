//! The Jacobian with as few operations as can be.

use pieper::describe::Convention;

use super::graph::{Graph, Id};
use crate::arm::Arm;
use crate::basis;
use crate::jacobian;
use crate::transform::Transform;

/// The rows of the Jacobian, one after the other, as nodes of a graph.
pub(crate) struct Velocity {
    pub(crate) graph: Graph,
    pub(crate) entries: Vec<Id>,
}

/// By its formulas, or, where they are long, by the frames from base to tool.
pub(crate) fn best(arm: &Arm, has_formulas: bool) -> Velocity {
    let product = by_frames(arm);
    if !has_formulas {
        return product;
    }
    let formulas = by_formulas(arm);
    let operations = |of: &Velocity| of.graph.operations(&of.entries).total();
    match operations(&formulas) <= operations(&product) {
        true => formulas,
        false => product,
    }
}

fn by_formulas(arm: &Arm) -> Velocity {
    let sums = basis::cumulative(arm);
    let jacobian = jacobian::in_base(arm);
    let mut graph = Graph::default();
    let entries = jacobian.0.iter().flatten();
    let entries = entries
        .map(|entry| graph.poly(&arm.names, &sums.rewrite(entry)))
        .collect();
    Velocity { graph, entries }
}

/// A frame: the columns of its rotation and its origin.
type Frame = [[Id; 3]; 4];

const X: usize = 0;
const Y: usize = 1;
const Z: usize = 2;
const ORIGIN: usize = 3;

struct Walk<'a> {
    arm: &'a Arm,
    graph: Graph,
    frame: Frame,
    /// The axis of each joint, against the sign of its variable, and a point on it.
    axes: Vec<[[Id; 3]; 2]>,
}

/// Whitney's columns `(z x (p - o), z)`, from axes and points that are carried along from base to tool.
fn by_frames(arm: &Arm) -> Velocity {
    let mut graph = Graph::default();
    let (zero, one) = (graph.zero(), graph.number(crate::number::whole(1)));
    let unit = |axis: usize| std::array::from_fn(|row| if row == axis { one } else { zero });
    let mut walk = Walk {
        arm,
        graph,
        frame: [unit(X), unit(Y), unit(Z), [zero; 3]],
        axes: Vec::new(),
    };
    if let Some(base) = &arm.base {
        walk.rigid(base);
    }
    (0..arm.dof()).for_each(|index| walk.row(index));
    if let Some(tool) = &arm.tool {
        walk.rigid(tool);
    }
    let Walk {
        mut graph,
        frame,
        axes,
        ..
    } = walk;
    let columns: Vec<[Id; 6]> = axes
        .iter()
        .enumerate()
        .map(|(joint, [z, origin])| {
            let z = match arm.rows[joint].sign < 0 {
                true => z.map(|entry| graph.neg(entry)),
                false => *z,
            };
            if !arm.rows[joint].turns {
                return [z[0], z[1], z[2], zero, zero, zero];
            }
            let way: [Id; 3] = std::array::from_fn(|k| graph.sub(frame[ORIGIN][k], origin[k]));
            let mut entry = |i: usize, j: usize| {
                let (one, other) = (graph.mul(z[i], way[j]), graph.mul(z[j], way[i]));
                graph.sub(one, other)
            };
            [entry(1, 2), entry(2, 0), entry(0, 1), z[0], z[1], z[2]]
        })
        .collect();
    let entries = (0..6).flat_map(|row| columns.iter().map(move |column| column[row]));
    Velocity {
        entries: entries.collect(),
        graph,
    }
}

impl Walk<'_> {
    fn row(&mut self, index: usize) {
        let arm = self.arm;
        let row = &arm.rows[index];
        let turn = |walk: &mut Self| {
            let axis = [walk.frame[Z], walk.frame[ORIGIN]];
            walk.axes.push(axis);
            let (sin, cos) = (
                walk.graph.poly(&arm.names, &row.theta.sin),
                walk.graph.poly(&arm.names, &row.theta.cos),
            );
            walk.mix(X, Y, sin, cos);
            let d = walk.graph.poly(&arm.names, &row.d);
            walk.shift(Z, d);
        };
        let twist = |walk: &mut Self| {
            let (sin, cos) = (
                walk.graph.poly(&arm.names, &row.alpha.sin),
                walk.graph.poly(&arm.names, &row.alpha.cos),
            );
            let a = walk.graph.poly(&arm.names, &row.a);
            walk.shift(X, a);
            walk.mix(Y, Z, sin, cos);
        };
        match arm.convention {
            Convention::Standard => {
                turn(self);
                twist(self);
            }
            Convention::Modified => {
                twist(self);
                turn(self);
            }
        }
    }

    /// Column i becomes `cos i + sin j`, and j `cos j - sin i`.
    fn mix(&mut self, i: usize, j: usize, sin: Id, cos: Id) {
        for row in 0..3 {
            let pair = (self.frame[j][row], self.frame[i][row]);
            (self.frame[j][row], self.frame[i][row]) = self.graph.turned((sin, cos), pair);
        }
    }

    fn shift(&mut self, axis: usize, by: Id) {
        for row in 0..3 {
            let part = self.graph.mul(by, self.frame[axis][row]);
            self.frame[ORIGIN][row] = self.graph.add(self.frame[ORIGIN][row], part);
        }
    }

    fn rigid(&mut self, transform: &Transform) {
        let before = self.frame;
        for column in X..=ORIGIN {
            for row in 0..3 {
                let mut sum = match column {
                    ORIGIN => before[ORIGIN][row],
                    _ => self.graph.zero(),
                };
                for k in 0..3 {
                    let entry = self.graph.poly(&self.arm.names, &transform.0[k][column]);
                    let part = self.graph.mul(before[k][row], entry);
                    sum = self.graph.add(sum, part);
                }
                self.frame[column][row] = sum;
            }
        }
    }
}
