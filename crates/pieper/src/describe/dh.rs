//! Denavit-Hartenberg tables, standard and modified.

mod from_chain;

use nalgebra::Vector3;

use super::expr::{self, Expr, Values};
use crate::error::{Error, Result};
use crate::model::{Chain, ChainParts, Drive, Joint, JointKind, Limits, Motion, Variable};
use crate::spatial::{self, Pose};

/// Which of the two conventions a table follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Convention {
    /// Distal: `A = Rz(theta) Tz(d) Tx(a) Rx(alpha)`.
    Standard,
    /// Proximal, as in Craig's book: `A = Rx(alpha) Tx(a) Rz(theta) Tz(d)`, alpha and a of the link before the joint.
    Modified,
}

impl Convention {
    /// The word robot files use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Standard => "standard",
            Self::Modified => "modified",
        }
    }
}

/// A table of rows, with base and tool transforms. Lengths and angles may be formulas with symbols.
#[derive(Clone, Debug, PartialEq)]
pub struct DhTable {
    /// Standard or modified.
    pub convention: Convention,
    /// The rows, base to tool.
    pub rows: Vec<DhRow>,
    /// From the world to the first row's frame.
    pub base: FrameExpr,
    /// From the last row's frame to the tool centre point.
    pub tool: FrameExpr,
}

/// One row. The entry that moves holds its offset; `sign` times the joint variable is added to it.
#[derive(Clone, Debug, PartialEq)]
pub struct DhRow {
    /// Turn about z; the offset of it if `moves` is [`Moves::Theta`].
    pub theta: Expr,
    /// Shift along z; the offset of it if `moves` is [`Moves::D`].
    pub d: Expr,
    /// Shift along x.
    pub a: Expr,
    /// Turn about x.
    pub alpha: Expr,
    /// Which entry the joint variable drives.
    pub moves: Moves,
    /// +1 or -1: the direction in which the joint variable enters.
    pub sign: f64,
    /// The joint's name, limits and rates; `kind` agrees with `moves`.
    pub joint: JointExpr,
}

/// Which entry of a row the joint variable drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moves {
    /// A revolute joint.
    Theta,
    /// A prismatic joint.
    D,
}

/// A joint's name and what is known of its range.
#[derive(Clone, Debug, PartialEq)]
pub struct JointExpr {
    /// The joint's name; `q1`..`qn` unless the file gives one.
    pub name: String,
    /// Lower and upper limit.
    pub limits: Option<[Expr; 2]>,
    /// Largest speed.
    pub velocity: Option<Expr>,
    /// Largest acceleration.
    pub acceleration: Option<Expr>,
}

impl JointExpr {
    /// A joint without limits.
    pub fn named(name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            limits: None,
            velocity: None,
            acceleration: None,
        }
    }

    /// The joint as a variable of the model.
    pub(super) fn variable(&self, kind: JointKind, values: &Values) -> Result<Variable> {
        let number = |expr: &Option<Expr>| expr.as_ref().map(|e| e.evaluate(values)).transpose();
        let limits = match &self.limits {
            None => None,
            Some([lower, upper]) => {
                let (lower, upper) = (lower.evaluate(values)?, upper.evaluate(values)?);
                let limits = Limits::new(lower, upper);
                Some(
                    limits
                        .map_err(|e| Error::model(format!("joint {}", self.name), e.to_string()))?,
                )
            }
        };
        let (velocity, acceleration) = (number(&self.velocity)?, number(&self.acceleration)?);
        Ok(Variable {
            name: self.name.clone(),
            kind,
            limits,
            velocity,
            acceleration,
        })
    }
}

/// A fixed transform: position and fixed-axis roll, pitch, yaw, as formulas.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameExpr {
    /// Position.
    pub xyz: [Expr; 3],
    /// Roll, pitch, yaw: `Rz(yaw) Ry(pitch) Rx(roll)`.
    pub rpy: [Expr; 3],
}

impl Default for FrameExpr {
    fn default() -> Self {
        Self::of_pose(&Pose::identity())
    }
}

impl FrameExpr {
    /// The frame with a pose's numbers.
    pub fn of_pose(pose: &Pose) -> Self {
        let [x, y, z]: [f64; 3] = pose.translation.vector.into();
        Self {
            xyz: [x, y, z].map(Expr::number),
            rpy: spatial::to_rpy(&pose.rotation).map(Expr::number),
        }
    }

    /// The frame as a pose.
    ///
    /// # Errors
    /// As [`Expr::evaluate`].
    pub fn pose(&self, values: &Values) -> Result<Pose> {
        let numbers = |exprs: &[Expr; 3]| -> Result<[f64; 3]> {
            let [x, y, z] = exprs;
            Ok([
                x.evaluate(values)?,
                y.evaluate(values)?,
                z.evaluate(values)?,
            ])
        };
        Ok(spatial::from_xyz_rpy(
            numbers(&self.xyz)?,
            numbers(&self.rpy)?,
        ))
    }

    /// Whether the frame is the identity, as written.
    pub fn is_identity(&self) -> bool {
        self.xyz.iter().chain(&self.rpy).all(Expr::is_zero)
    }

    pub(super) fn exprs(&self) -> impl Iterator<Item = &Expr> {
        self.xyz.iter().chain(&self.rpy)
    }
}

impl DhRow {
    /// The kind of the row's joint.
    pub fn kind(&self) -> JointKind {
        match self.moves {
            Moves::Theta => JointKind::Revolute,
            Moves::D => JointKind::Prismatic,
        }
    }

    /// The entry that moves, with the joint variable `q1`, `q2`, ... of row `index` (from 0) put back in.
    pub fn moving_entry(&self, index: usize) -> Expr {
        let offset = match self.moves {
            Moves::Theta => &self.theta,
            Moves::D => &self.d,
        };
        expr::with_variable(offset, &format!("q{}", index + 1), self.sign)
    }

    fn exprs(&self) -> impl Iterator<Item = &Expr> {
        [&self.theta, &self.d, &self.a, &self.alpha].into_iter()
    }
}

impl DhTable {
    /// Every symbol the table's geometry uses, each once.
    pub fn symbols(&self) -> Vec<&str> {
        let rows = self.rows.iter().flat_map(DhRow::exprs);
        expr::unique_symbols(self.base.exprs().chain(rows).chain(self.tool.exprs()))
    }

    /// The table as a chain, with these values for its symbols. Link frames are named `1`..`n`.
    ///
    /// # Errors
    /// A missing-value error that names every symbol without a value; a model error for limits the wrong way round.
    pub fn chain(&self, values: &Values) -> Result<Chain> {
        let mut parts = ChainParts {
            variables: Vec::with_capacity(self.rows.len()),
            joints: Vec::with_capacity(self.rows.len()),
            base: self.base.pose(values)?,
            tool: self.tool.pose(values)?,
        };
        for (index, row) in self.rows.iter().enumerate() {
            parts
                .variables
                .push(row.joint.variable(row.kind(), values)?);
            parts.joints.push(self.joint(index, row, values)?);
        }
        Chain::new(parts)
    }

    fn joint(&self, index: usize, row: &DhRow, values: &Values) -> Result<Joint> {
        let number = |expr: &Expr| expr.evaluate(values);
        let (theta, d) = (spatial::snap(number(&row.theta)?), number(&row.d)?);
        let (a, alpha) = (number(&row.a)?, number(&row.alpha)?);
        let about_z = |angle| spatial::turn(&Vector3::z_axis(), spatial::sin_cos_exact(angle));
        let about_x = |angle| spatial::turn(&Vector3::x_axis(), spatial::sin_cos_exact(angle));
        let along = |x, z| spatial::shift(Vector3::new(x, 0.0, z));
        let drive = |offset| Drive {
            variable: index,
            factor: row.sign,
            offset,
        };
        // The joint moves between a part of the row before it and a part behind it.
        let (before, motion, after) = match row.moves {
            Moves::Theta => (
                Pose::identity(),
                Motion::turn_z(drive(theta)),
                along(0.0, d),
            ),
            Moves::D => (about_z(theta), Motion::slide_z(drive(d)), Pose::identity()),
        };
        let (before, after) = match self.convention {
            Convention::Standard => (before, after * along(a, 0.0) * about_x(alpha)),
            Convention::Modified => (about_x(alpha) * along(a, 0.0) * before, after),
        };
        Ok(Joint {
            name: row.joint.name.clone(),
            link: (index + 1).to_string(),
            before,
            motion,
            after,
        })
    }
}
