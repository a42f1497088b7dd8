//! The Jacobian as formulas, seen from any frame and for any point of the arm.

use pieper::describe::Convention;

use crate::arm::Arm;
use crate::number;
use crate::poly::Poly;
use crate::transform::Transform;

/// Six rows (velocity of a point, then angular velocity), one column for each joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Jacobian(pub Vec<Vec<Poly>>);

type Vector = [Poly; 3];

fn minus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    let entry = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [entry(1, 2), entry(2, 0), entry(0, 1)]
}

fn column(transform: &Transform, index: usize) -> Vector {
    std::array::from_fn(|row| transform.0[row][index].clone())
}

/// The frame whose z is the axis of a joint.
fn axis_frame(arm: &Arm, joint: usize) -> usize {
    match arm.convention {
        Convention::Standard => joint,
        Convention::Modified => joint + 1,
    }
}

/// Frames of the arm seen from one of them.
pub(crate) struct View {
    frames: Vec<Transform>,
}

impl View {
    /// All frames `0..=n`, seen from frame `from`.
    pub(crate) fn from(arm: &Arm, from: usize) -> Self {
        let frame = |index: usize| match index >= from {
            true => arm.product(from, index),
            false => arm.product(index, from).inverse(),
        };
        Self {
            frames: (0..=arm.dof()).map(frame).collect(),
        }
    }

    /// The Jacobian of the origin of frame `point`, in the axes of the view's own frame.
    pub(crate) fn jacobian(&self, arm: &Arm, point: usize) -> Jacobian {
        let p = column(&self.frames[point], 3);
        self.jacobian_of(arm, &p)
    }

    fn jacobian_of(&self, arm: &Arm, p: &Vector) -> Jacobian {
        let columns: Vec<[Poly; 6]> = (0..arm.dof())
            .map(|joint| {
                let frame = &self.frames[axis_frame(arm, joint)];
                let sign = number::whole(i64::from(arm.rows[joint].sign));
                let z = column(frame, 2).map(|entry| entry.scaled(&sign));
                let zero = || std::array::from_fn(|_| Poly::zero());
                let (v, w): (Vector, Vector) = match arm.rows[joint].turns {
                    true => (cross(&z, &minus(p, &column(frame, 3))), z),
                    false => (z, zero()),
                };
                let [a, b, c] = v;
                let [d, e, f] = w;
                [a, b, c, d, e, f]
            })
            .collect();
        Jacobian(
            (0..6)
                .map(|row| columns.iter().map(|column| column[row].clone()).collect())
                .collect(),
        )
    }
}

/// The Jacobian of the tool point in the base's axes, rows `vx vy vz wx wy wz`: Whitney's columns
/// `(z x (p - o), z)` for a joint that turns, `(z, 0)` for one that slides.
pub fn in_base(arm: &Arm) -> Jacobian {
    let mut view = View::from(arm, 0);
    if let Some(base) = &arm.base {
        view.frames
            .iter_mut()
            .for_each(|frame| *frame = base.times(frame));
    }
    let last = view
        .frames
        .last()
        .cloned()
        .unwrap_or_else(Transform::identity);
    let tool = match &arm.tool {
        Some(tool) => last.times(tool),
        None => last,
    };
    view.jacobian_of(arm, &column(&tool, 3))
}
