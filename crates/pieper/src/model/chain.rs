//! An open kinematic chain.

use super::canonical::Canonical;
use super::joint::{Joint, Variable};
use crate::error::{Error, Result};
use crate::spatial::Pose;

/// What a chain is made of; [`Chain::new`] checks it.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainParts {
    /// The independent variables, in the order of the joint vector.
    pub variables: Vec<Variable>,
    /// The joints from base to tool, fixed ones among them.
    pub joints: Vec<Joint>,
    /// From the world to the first joint's parent link.
    pub base: Pose,
    /// From the last link to the tool centre point.
    pub tool: Pose,
}

/// An open chain of revolute, continuous, prismatic, fixed and mimic joints with base and tool transforms.
///
/// Immutable and valid: every transform is finite and rigid, every axis a unit vector, every variable drives
/// at least one joint. The form the kernels work on is prepared once, here.
///
/// ```
/// use nalgebra::{Rotation3, Translation3};
/// use pieper::model::{Chain, ChainParts, Drive, Joint, JointKind, Motion, Variable};
/// use pieper::spatial::Pose;
///
/// let arm = Chain::new(ChainParts {
///     variables: vec![Variable::new("q1", JointKind::Revolute)],
///     joints: vec![Joint {
///         name: "q1".into(),
///         link: "1".into(),
///         before: Pose::identity(),
///         motion: Motion::turn_z(Drive { variable: 0, factor: 1.0, offset: 0.0 }),
///         after: Pose::from_parts(Translation3::new(0.3, 0.0, 0.0), Rotation3::identity()),
///     }],
///     base: Pose::identity(),
///     tool: Pose::identity(),
/// })?;
/// assert_eq!(arm.dof(), 1);
/// # Ok::<(), pieper::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Chain {
    parts: ChainParts,
    canonical: Canonical,
}

impl Chain {
    /// A chain of these parts, checked.
    ///
    /// # Errors
    /// A model error names the first joint or variable that is not valid: a transform or drive that is not
    /// finite, an axis that is no unit vector, a variable that drives nothing, no variable at all.
    pub fn new(parts: ChainParts) -> Result<Self> {
        check(&parts)?;
        let canonical = Canonical::of(&parts);
        Ok(Self { parts, canonical })
    }

    /// The number of independent variables: the length of the joint vector.
    pub fn dof(&self) -> usize {
        self.parts.variables.len()
    }

    /// The independent variables, in the order of the joint vector.
    pub fn variables(&self) -> &[Variable] {
        &self.parts.variables
    }

    /// The joints from base to tool, fixed ones among them.
    pub fn joints(&self) -> &[Joint] {
        &self.parts.joints
    }

    /// From the world to the first joint's parent link.
    pub fn base(&self) -> &Pose {
        &self.parts.base
    }

    /// From the last link to the tool centre point.
    pub fn tool(&self) -> &Pose {
        &self.parts.tool
    }

    /// The parts, to make a changed chain of.
    pub fn parts(&self) -> &ChainParts {
        &self.parts
    }

    /// The same chain as a product of motions about or along z and constant links: what kernels work on.
    pub fn canonical(&self) -> &Canonical {
        &self.canonical
    }

    /// An error unless `q` has one finite value for each variable.
    ///
    /// # Errors
    /// An input error with both counts, or with the joint whose value is not finite.
    pub fn check_joint_values(&self, q: &[f64]) -> Result<()> {
        self.check_joint_count(q)?;
        match q.iter().position(|value| !value.is_finite()) {
            None => Ok(()),
            Some(index) => Err(self.not_finite(index, q[index])),
        }
    }

    /// An error unless `q` has one value for each variable.
    pub(crate) fn check_joint_count(&self, q: &[f64]) -> Result<()> {
        if q.len() == self.dof() {
            Ok(())
        } else {
            Err(self.wrong_count(q.len()))
        }
    }

    /// The error that names the first value of `q` that is not finite or drives a joint out of all bounds.
    #[cold]
    pub(crate) fn not_finite_error(&self, q: &[f64]) -> Error {
        let index = q.iter().position(|value| !value.is_finite());
        // Finite values whose displacement overflows: the largest is to blame.
        let largest = || (0..q.len()).max_by(|&a, &b| q[a].abs().total_cmp(&q[b].abs()));
        let index = index.or_else(largest).unwrap_or(0);
        self.not_finite(index, q[index])
    }

    /// The variables that `q` takes outside their limits, as sentences for a person.
    pub fn limit_violations(&self, q: &[f64]) -> Vec<String> {
        let named = self.variables().iter().zip(q);
        named
            .filter_map(|(variable, &value)| {
                let limits = variable.limits.filter(|limits| !limits.contains(value))?;
                let unit = variable.kind.unit();
                let (lower, upper) = (limits.lower(), limits.upper());
                Some(format!(
                    "{} = {value} {unit} lies outside its limits [{lower}, {upper}] {unit}",
                    variable.name
                ))
            })
            .collect()
    }

    #[cold]
    fn wrong_count(&self, given: usize) -> Error {
        let names: Vec<_> = self.variables().iter().map(|v| v.name.as_str()).collect();
        let expected = format!("{} were expected ({})", self.dof(), names.join(", "));
        Error::input("joint values", format!("{expected}, {given} were given"))
    }

    #[cold]
    fn not_finite(&self, index: usize, value: f64) -> Error {
        let name = &self.variables()[index].name;
        Error::input(
            format!("joint value {name} = {value}"),
            "a finite number was expected",
        )
    }
}

fn check(parts: &ChainParts) -> Result<()> {
    if parts.variables.is_empty() {
        return Err(Error::model("chain", "it has no joint that moves"));
    }
    check_finite("base", &parts.base)?;
    check_finite("tool", &parts.tool)?;
    for joint in &parts.joints {
        check_joint(parts, joint)?;
    }
    let mut driven = vec![false; parts.variables.len()];
    for drive in parts.joints.iter().filter_map(|joint| joint.motion.drive()) {
        driven[drive.variable] = true;
    }
    match parts
        .variables
        .iter()
        .zip(driven)
        .find(|(_, driven)| !driven)
    {
        None => Ok(()),
        Some((variable, _)) => Err(Error::model(
            format!("variable {}", variable.name),
            "it drives no joint",
        )),
    }
}

fn check_joint(parts: &ChainParts, joint: &Joint) -> Result<()> {
    let name = || format!("joint {}", joint.name);
    check_finite(&name(), &joint.before)?;
    check_finite(&name(), &joint.after)?;
    let Some(drive) = joint.motion.drive() else {
        return Ok(());
    };
    if !(drive.factor.is_finite() && drive.offset.is_finite()) {
        return Err(Error::model(name(), "its factor and offset must be finite"));
    }
    if drive.variable >= parts.variables.len() {
        let count = parts.variables.len();
        let text = format!("it names variable {} of {count}", drive.variable + 1);
        return Err(Error::model(name(), text));
    }
    if !joint
        .motion
        .axis()
        .is_some_and(|axis| (axis.norm() - 1.0).abs() < AXIS_TOLERANCE)
    {
        return Err(Error::model(name(), "its axis is not a unit vector"));
    }
    Ok(())
}

/// How far an axis may be from unit length: rounding of a normalised vector, no more.
const AXIS_TOLERANCE: f64 = 1e-12;

fn check_finite(subject: &str, pose: &Pose) -> Result<()> {
    let mut entries = pose
        .rotation
        .matrix()
        .iter()
        .chain(pose.translation.vector.iter());
    if entries.all(|entry| entry.is_finite()) {
        Ok(())
    } else {
        Err(Error::model(
            subject,
            "its transform has an entry that is not a finite number",
        ))
    }
}
