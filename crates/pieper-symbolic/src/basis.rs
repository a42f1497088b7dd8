//! Angle sums of parallel axes: the same formula in sums instead of single angles.
//!
//! For a run of parallel axes with angles x_1, ..., x_k any k independent differences of the absolute angles
//! 0, x_1, x_1 + x_2, ... will do; each choice is a tree over these. A change of choice maps canonical forms to
//! canonical forms.

use pieper::kinematics::kernel::Turn;

use crate::angle;
use crate::arm::{Arm, positive};
use crate::names::{Angle, AngleMeaning, Names, Var, VarKind};
use crate::poly::Poly;

/// Each angle of some runs in terms of others.
#[derive(Clone, Debug, Default)]
pub struct Basis {
    images: Vec<(Angle, Turn<Poly>)>,
}

impl Basis {
    /// The formula in this basis.
    #[must_use]
    pub fn rewrite(&self, poly: &Poly) -> Poly {
        poly.substitute(|var| {
            let angle = var.angle()?;
            let (_, turn) = self.images.iter().find(|(known, _)| *known == angle)?;
            Some(match var.kind() {
                VarKind::Sin(_) => turn.sin.clone(),
                _ => turn.cos.clone(),
            })
        })
    }

    fn is_trivial(&self) -> bool {
        let is_own = |(angle, turn): &(Angle, Turn<Poly>)| turn.sin == Poly::var(angle.sin());
        self.images.iter().all(is_own)
    }
}

/// The basis of cumulative sums: q2, q2 - q3, ... in every run.
pub fn cumulative(arm: &Arm) -> Basis {
    let runs = arm.parallel.iter();
    let images = runs.filter_map(|run| {
        let edges: Vec<_> = (1..=run.len()).map(|end| (0, end)).collect();
        images(&arm.names, run, &edges)
    });
    Basis {
        images: images.flatten().collect(),
    }
}

/// The shortest form of a formula of joint angles over all bases of the arm's runs of parallel axes, and its basis.
///
/// Each run is looked at by itself: their angles are independent.
pub fn shortest(arm: &Arm, poly: &Poly) -> Poly {
    let mut best = poly.clone();
    for run in &arm.parallel {
        let concerned = run.iter().filter(|(joint, _)| {
            arm.joint_angle(*joint)
                .is_some_and(|angle| poly.contains_angle(angle))
        });
        if concerned.count() < 2 {
            continue;
        }
        let start = best.clone();
        for edges in trees(run.len()) {
            let Some(images) = images(&arm.names, run, &edges) else {
                continue;
            };
            let basis = Basis { images };
            if basis.is_trivial() {
                continue;
            }
            let other = basis.rewrite(&start);
            if !other.is_swollen() && cost(&other) < cost(&best) {
                best = other;
            }
        }
    }
    best
}

/// Terms first, then factors.
fn cost(poly: &Poly) -> (usize, u32) {
    (
        poly.terms().len(),
        poly.terms().iter().map(|term| term.monomial.degree()).sum(),
    )
}

/// A formula in sums, back in single joint angles: the form in which equality is decided.
pub fn in_joints(names: &Names, poly: &Poly) -> Poly {
    poly.substitute(|var| {
        let angle = var.angle()?;
        let AngleMeaning::Sum(sum) = names.meaning(angle) else {
            return None;
        };
        let turn = expanded(names, sum)?;
        Some(match var.kind() {
            VarKind::Sin(_) => turn.sin,
            _ => turn.cos,
        })
    })
}

/// The turn by a sum of joint variables.
pub(crate) fn expanded(names: &Names, sum: &[(usize, i8)]) -> Option<Turn<Poly>> {
    sum.iter().try_fold(angle::still(), |total, (joint, sign)| {
        let own = angle::turn(names.find_angle(&AngleMeaning::Joint(*joint))?);
        let own = if *sign < 0 {
            angle::opposite(&own)
        } else {
            own
        };
        Some(angle::sum(&total, &own))
    })
}

/// The trees over the absolute angles 0..=k, as edges from lower to higher; all of them for short runs.
fn trees(count: usize) -> Vec<Vec<(usize, usize)>> {
    if count > 3 {
        return vec![(1..=count).map(|end| (0, end)).collect()];
    }
    let all: Vec<(usize, usize)> = (0..=count)
        .flat_map(|a| (a + 1..=count).map(move |b| (a, b)))
        .collect();
    let mut found = Vec::new();
    for chosen in 0_u32..1 << all.len() {
        if chosen.count_ones() as usize != count {
            continue;
        }
        let edges: Vec<_> = (0..all.len())
            .filter(|bit| chosen >> bit & 1 == 1)
            .map(|bit| all[bit])
            .collect();
        if (0..count).all(|node| path(&edges, node, node + 1).is_some()) {
            found.push(edges);
        }
    }
    found
}

/// The joint angles of a run in terms of the tree's edges; `None` if a sum has no name.
fn images(
    names: &Names,
    run: &[(usize, i8)],
    edges: &[(usize, usize)],
) -> Option<Vec<(Angle, Turn<Poly>)>> {
    let edge_turn = |&(a, b): &(usize, usize)| -> Option<Turn<Poly>> {
        let sum = &run[a..b];
        let sign = sum.first()?.1;
        let meaning = match sum {
            [(joint, _)] => AngleMeaning::Joint(*joint),
            sum => AngleMeaning::Sum(positive(sum)),
        };
        let turn = angle::turn(names.find_angle(&meaning)?);
        Some(if sign < 0 {
            angle::opposite(&turn)
        } else {
            turn
        })
    };
    let image = |(index, (joint, sign)): (usize, &(usize, i8))| {
        let mut total = angle::still();
        for (edge, forward) in path(edges, index, index + 1)? {
            let turn = edge_turn(&edges[edge])?;
            total = angle::sum(
                &total,
                &if forward {
                    turn
                } else {
                    angle::opposite(&turn)
                },
            );
        }
        let total = if *sign < 0 {
            angle::opposite(&total)
        } else {
            total
        };
        Some((names.find_angle(&AngleMeaning::Joint(*joint))?, total))
    };
    run.iter().enumerate().map(image).collect()
}

/// The edges on the way from one node to another, each with whether it is walked forward; `None` if there is no way.
fn path(edges: &[(usize, usize)], from: usize, to: usize) -> Option<Vec<(usize, bool)>> {
    let mut ways = vec![(from, Vec::new())];
    let mut seen = vec![from];
    while let Some((node, way)) = ways.pop() {
        if node == to {
            return Some(way);
        }
        for (index, &(a, b)) in edges.iter().enumerate() {
            let next = match node {
                _ if node == a => (b, true),
                _ if node == b => (a, false),
                _ => continue,
            };
            if !seen.contains(&next.0) {
                seen.push(next.0);
                let mut longer = way.clone();
                longer.push((index, next.1));
                ways.push((next.0, longer));
            }
        }
    }
    None
}

/// Whether a quantity is the sine or cosine of a sum.
pub(crate) fn is_sum(names: &Names, var: Var) -> bool {
    var.angle()
        .is_some_and(|angle| matches!(names.meaning(angle), AngleMeaning::Sum(_)))
}
