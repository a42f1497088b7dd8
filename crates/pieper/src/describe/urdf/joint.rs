//! One `<joint>`, as far as it can be read without the others.

use nalgebra::UnitVector3;

use super::value::{axis, numbers, optional, origin};
use super::xml::{Attribute, Element};
use crate::error::Result;
use crate::model::{JointKind, Limits, Variable};
use crate::spatial::Pose;

/// A joint whose links and mimicked joint are still names.
pub(super) struct RawJoint<'a> {
    pub(super) element: &'a Element,
    pub(super) name: &'a str,
    pub(super) parent: &'a Attribute,
    pub(super) child: &'a Attribute,
    pub(super) origin: Pose,
    /// `None` for a fixed joint.
    pub(super) moving: Option<Moving<'a>>,
}

/// What a joint that moves has besides.
pub(super) struct Moving<'a> {
    pub(super) axis: UnitVector3<f64>,
    /// The variable it has if it is independent.
    pub(super) variable: Variable,
    pub(super) mimic: Option<Mimic<'a>>,
}

/// `multiplier * (displacement of joint) + offset`.
pub(super) struct Mimic<'a> {
    pub(super) joint: &'a Attribute,
    pub(super) multiplier: f64,
    pub(super) offset: f64,
}

pub(super) fn joint(element: &Element) -> Result<RawJoint<'_>> {
    let name = name(element)?;
    let end = |tag: &str| {
        element
            .child(tag)
            .ok_or_else(|| element.error(format!("an element <{tag} link=\"...\"/> was expected")))?
            .required("link")
    };
    Ok(RawJoint {
        element,
        name,
        parent: end("parent")?,
        child: end("child")?,
        origin: origin(element)?,
        moving: kind(element)?
            .map(|kind| moving(element, name, kind))
            .transpose()?,
    })
}

/// The name of a link, joint or robot.
pub(super) fn name(element: &Element) -> Result<&str> {
    let attribute = element.required("name")?;
    if attribute.value.trim().is_empty() {
        return Err(attribute.error("a name was expected"));
    }
    Ok(&attribute.value)
}

fn kind(element: &Element) -> Result<Option<JointKind>> {
    const READ: &str = "revolute, continuous, prismatic and fixed are read";
    let attribute = element.required("type")?;
    match attribute.value.as_str() {
        "fixed" => Ok(None),
        "revolute" => Ok(Some(JointKind::Revolute)),
        "continuous" => Ok(Some(JointKind::Continuous)),
        "prismatic" => Ok(Some(JointKind::Prismatic)),
        kind @ ("floating" | "planar") => {
            let freedoms = if kind == "planar" { "three" } else { "six" };
            let text = format!("{freedoms} degrees of freedom are more than a joint of an arm has");
            Err(attribute.error(format!("{text}; {READ}")))
        }
        _ => Err(attribute.error(format!("no such joint type; {READ}"))),
    }
}

fn moving<'a>(element: &'a Element, name: &str, kind: JointKind) -> Result<Moving<'a>> {
    let mut variable = Variable::new(name, kind);
    if let Some(limit) = element.child("limit") {
        if kind != JointKind::Continuous {
            variable.limits = limits(limit)?;
        }
        // Zero stands for "not known" in exported files: a joint that may not move is written as fixed.
        variable.velocity = optional(limit, "velocity")?.filter(|&velocity| velocity > 0.0);
    }
    Ok(Moving {
        axis: axis(element)?,
        variable,
        mimic: element.child("mimic").map(mimic).transpose()?,
    })
}

/// An end that is left out is zero, as the format says; with both left out there is no range.
fn limits(limit: &Element) -> Result<Option<Limits>> {
    let (lower, upper) = (optional(limit, "lower")?, optional(limit, "upper")?);
    if lower.or(upper).is_none() {
        return Ok(None);
    }
    let (lower, upper) = (lower.unwrap_or_default(), upper.unwrap_or_default());
    let limits = Limits::new(lower, upper).map_err(|_| {
        let text = format!("the lower limit {lower} lies above the upper limit {upper}");
        limit.error(text)
    })?;
    Ok(Some(limits))
}

fn mimic(element: &Element) -> Result<Mimic<'_>> {
    let or = |name, default| {
        let value = element.attribute(name).map(numbers).transpose()?;
        Ok(value.map_or(default, |[value]: [f64; 1]| value))
    };
    Ok(Mimic {
        joint: element.required("joint")?,
        multiplier: or("multiplier", 1.0)?,
        offset: or("offset", 0.0)?,
    })
}
