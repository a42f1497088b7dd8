//! Screw axes: the product of exponentials.

use nalgebra::{Rotation3, Unit, Vector3};

use super::dh::{FrameExpr, JointExpr};
use super::expr::{Expr, Values};
use crate::error::{Error, Result};
use crate::model::{Chain, ChainParts, Drive, Joint, JointKind, Motion};
use crate::spatial::{self, Pose};

/// An arm as axes in its zero pose:
/// `T = base * Trans(p_1) M(h_1) Trans(p_2) M(h_2) ... Trans(p_n) M(h_n) * tool`,
/// where `M(h)` turns about or slides along the unit axis `h` by `offset + sign * q`.
#[derive(Clone, Debug, PartialEq)]
pub struct ScrewTable {
    /// The screws, base to tool.
    pub screws: Vec<Screw>,
    /// From the world to the frame in which the axes stand.
    pub base: FrameExpr,
    /// From the last axis point to the tool, its orientation in the zero pose.
    pub tool: FrameExpr,
}

/// One axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Screw {
    /// Direction of the axis in the zero pose, base axes.
    pub h: [Expr; 3],
    /// From a point on the axis before (or the base) to a point on this one, zero pose, base axes.
    pub p: [Expr; 3],
    /// Whether the joint turns or slides.
    pub kind: JointKind,
    /// +1 or -1: the direction in which the joint variable enters.
    pub sign: f64,
    /// Displacement at joint variable zero.
    pub offset: Expr,
    /// The joint's name, limits and rates.
    pub joint: JointExpr,
}

impl ScrewTable {
    /// The screws as a chain. Link frames are named `1`..`n`: at each axis point, parallel to the base in the zero pose.
    ///
    /// # Errors
    /// A missing-value error for symbols without a value; a model error for an axis of length zero.
    pub fn chain(&self, values: &Values) -> Result<Chain> {
        let mut parts = ChainParts {
            variables: Vec::with_capacity(self.screws.len()),
            joints: Vec::with_capacity(self.screws.len()),
            base: self.base.pose(values)?,
            tool: self.tool.pose(values)?,
        };
        for (index, screw) in self.screws.iter().enumerate() {
            parts
                .variables
                .push(screw.joint.variable(screw.kind, values)?);
            parts.joints.push(screw.joint(index, values)?);
        }
        Chain::new(parts)
    }

    /// The screws of any chain, with the same tool pose at every joint vector.
    ///
    /// # Errors
    /// A model error for a variable that drives several joints, or enters with a factor other than +1 or -1.
    pub fn of_chain(chain: &Chain) -> Result<Self> {
        let mut screws = Vec::with_capacity(chain.dof());
        // Frames with every displacement, offsets included, at zero.
        let mut frame = Pose::identity();
        let mut last_point = Vector3::zeros();
        for joint in chain.joints() {
            frame *= joint.before;
            if let (Some(axis), Some(drive)) = (joint.motion.axis(), joint.motion.drive()) {
                let variable = &chain.variables()[drive.variable];
                if drive.variable != screws.len() || drive.factor.abs() != 1.0 {
                    let text =
                        "screws need one axis for each variable, in order, with factor +1 or -1";
                    return Err(Error::model(format!("joint {}", variable.name), text));
                }
                let kind = match joint.motion {
                    Motion::Slide(..) => JointKind::Prismatic,
                    _ => JointKind::Revolute,
                };
                let h: [f64; 3] = (frame.rotation * axis.into_inner()).into();
                let point = frame.translation.vector;
                let p: [f64; 3] = (point - last_point).into();
                last_point = point;
                screws.push(Screw {
                    h: h.map(Expr::number),
                    p: p.map(Expr::number),
                    kind,
                    sign: drive.factor,
                    offset: Expr::number(drive.offset),
                    joint: JointExpr::of_variable(variable),
                });
            }
            frame *= joint.after;
        }
        frame *= chain.tool();
        let tool = spatial::shift(-last_point) * frame;
        Ok(Self {
            screws,
            base: FrameExpr::of_pose(chain.base()),
            tool: FrameExpr::of_pose(&tool),
        })
    }

    /// Every symbol the geometry uses, each once.
    pub fn symbols(&self) -> Vec<&str> {
        let screws = self
            .screws
            .iter()
            .flat_map(|s| s.h.iter().chain(&s.p).chain([&s.offset]));
        let frames = [&self.base, &self.tool]
            .into_iter()
            .flat_map(FrameExpr::exprs);
        super::expr::unique_symbols(screws.chain(frames))
    }
}

impl Screw {
    fn joint(&self, index: usize, values: &Values) -> Result<Joint> {
        let vector = |exprs: &[Expr; 3]| -> Result<Vector3<f64>> {
            let [x, y, z] = exprs;
            Ok(Vector3::new(
                x.evaluate(values)?,
                y.evaluate(values)?,
                z.evaluate(values)?,
            ))
        };
        let direction = vector(&self.h)?;
        let name = &self.joint.name;
        let axis = unit_axis(direction)
            .ok_or_else(|| Error::model(format!("joint {name}"), "its axis h has length zero"))?;
        let drive = Drive {
            variable: index,
            factor: self.sign,
            offset: spatial::snap(self.offset.evaluate(values)?),
        };
        let motion = match self.kind {
            JointKind::Prismatic => Motion::Slide(axis, drive),
            _ => Motion::Turn(axis, drive),
        };
        let before = Pose::from_parts(vector(&self.p)?.into(), Rotation3::identity());
        Ok(Joint {
            name: name.clone(),
            link: (index + 1).to_string(),
            before,
            motion,
            after: Pose::identity(),
        })
    }
}

/// A direction as a unit vector; one that is so already, to rounding, keeps its digits.
fn unit_axis(direction: Vector3<f64>) -> Option<Unit<Vector3<f64>>> {
    let length = direction.norm();
    if (length - 1.0).abs() <= 2.0 * f64::EPSILON {
        return Some(Unit::new_unchecked(direction));
    }
    (length > 0.0 && length.is_finite()).then(|| Unit::new_unchecked(direction / length))
}
