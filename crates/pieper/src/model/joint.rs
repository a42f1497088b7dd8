//! Joints, the variables that drive them, and their limits.

use nalgebra::{UnitVector3, Vector3};

use crate::error::{Error, Result};
use crate::spatial::{self, Pose};

/// How a variable of a chain moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// Turns, within limits if it has any.
    Revolute,
    /// Turns without end.
    Continuous,
    /// Slides.
    Prismatic,
}

impl JointKind {
    /// Whether the variable is an angle (radians) rather than a length (metres).
    pub fn is_angular(self) -> bool {
        self != Self::Prismatic
    }

    /// The unit of the variable: `"rad"` or `"m"`.
    pub fn unit(self) -> &'static str {
        if self.is_angular() { "rad" } else { "m" }
    }
}

/// A closed range of values, radians or metres. The constructor holds `lower <= upper`, both finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    lower: f64,
    upper: f64,
}

impl Limits {
    /// A range; an error if it is the wrong way round or not finite.
    ///
    /// ```
    /// let limits = pieper::model::Limits::new(-1.0, 2.0)?;
    /// assert!(limits.contains(2.0) && !limits.contains(2.1));
    /// assert!(pieper::model::Limits::new(2.0, -1.0).is_err());
    /// # Ok::<(), pieper::Error>(())
    /// ```
    pub fn new(lower: f64, upper: f64) -> Result<Self> {
        let text = || format!("limits [{lower}, {upper}]");
        if !lower.is_finite() || !upper.is_finite() {
            return Err(Error::model(text(), "both ends must be finite numbers"));
        }
        if lower > upper {
            return Err(Error::model(
                text(),
                "the lower end lies above the upper end",
            ));
        }
        Ok(Self { lower, upper })
    }

    /// The lower end.
    pub fn lower(&self) -> f64 {
        self.lower
    }

    /// The upper end.
    pub fn upper(&self) -> f64 {
        self.upper
    }

    /// Whether `value` lies in the range, ends included.
    pub fn contains(&self, value: f64) -> bool {
        (self.lower..=self.upper).contains(&value)
    }
}

/// One independent variable of a chain: an entry of the joint vector `q`.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// The joint's name, for example `q1` or `shoulder_pan_joint`.
    pub name: String,
    /// Angle or length.
    pub kind: JointKind,
    /// The range of motion, if known; `None` means unlimited.
    pub limits: Option<Limits>,
    /// Largest speed, rad/s or m/s, if known.
    pub velocity: Option<f64>,
    /// Largest acceleration, rad/s^2 or m/s^2, if known.
    pub acceleration: Option<f64>,
}

impl Variable {
    /// A variable without limits.
    pub fn new(name: impl Into<String>, kind: JointKind) -> Self {
        Self {
            name: name.into(),
            kind,
            limits: None,
            velocity: None,
            acceleration: None,
        }
    }
}

/// How a joint's displacement follows from the joint vector: `offset + factor * q[variable]`.
///
/// A Denavit-Hartenberg row `theta = pi/2 - q3` has factor -1 and offset pi/2; a URDF mimic joint shares the
/// variable of the joint it follows, with its multiplier as factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// Index into the joint vector.
    pub variable: usize,
    /// Displacement per unit of the variable.
    pub factor: f64,
    /// Displacement at variable zero.
    pub offset: f64,
}

impl Drive {
    /// The displacement at the joint vector `q`, which must be long enough.
    pub fn displacement(&self, q: &[f64]) -> f64 {
        self.factor.mul_add(q[self.variable], self.offset)
    }
}

/// What a joint does between its two fixed transforms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// Nothing.
    Fixed,
    /// Turns about the unit axis through the joint frame's origin.
    Turn(UnitVector3<f64>, Drive),
    /// Slides along the unit axis.
    Slide(UnitVector3<f64>, Drive),
}

impl Motion {
    /// A turn about the joint frame's z axis.
    pub fn turn_z(drive: Drive) -> Self {
        Self::Turn(Vector3::z_axis(), drive)
    }

    /// A slide along the joint frame's z axis.
    pub fn slide_z(drive: Drive) -> Self {
        Self::Slide(Vector3::z_axis(), drive)
    }

    /// The drive, if the joint moves.
    pub fn drive(&self) -> Option<&Drive> {
        match self {
            Self::Fixed => None,
            Self::Turn(_, drive) | Self::Slide(_, drive) => Some(drive),
        }
    }

    /// The axis, if the joint moves.
    pub fn axis(&self) -> Option<&UnitVector3<f64>> {
        match self {
            Self::Fixed => None,
            Self::Turn(axis, _) | Self::Slide(axis, _) => Some(axis),
        }
    }

    /// The rigid motion at the joint vector `q`.
    pub fn pose(&self, q: &[f64]) -> Pose {
        match self {
            Self::Fixed => Pose::identity(),
            Self::Turn(axis, drive) => spatial::turn(axis, drive.displacement(q).sin_cos()),
            Self::Slide(axis, drive) => spatial::shift(axis.into_inner() * drive.displacement(q)),
        }
    }
}

/// One joint of a chain, with the link it carries.
///
/// `parent_from_link = before * motion(q) * after`.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The joint's name.
    pub name: String,
    /// The name of the link frame after the joint: `1`..`n` for tables, the child link for URDF.
    pub link: String,
    /// From the parent link's frame to the joint's.
    pub before: Pose,
    /// What moves.
    pub motion: Motion,
    /// From the moved joint frame to the link's.
    pub after: Pose,
}

impl Joint {
    /// `parent_from_link` at the joint vector `q`.
    pub fn pose(&self, q: &[f64]) -> Pose {
        self.before * self.motion.pose(q) * self.after
    }
}
