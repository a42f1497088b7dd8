//! A `<robot>` into a tree.

use std::collections::HashMap;

use super::joint::{self, RawJoint};
use super::mimic;
use super::shape;
use super::xml::{self, Attribute, Element};
use crate::error::{Error, Result};
use crate::model::{Tree, TreeJoint, TreeLink};

/// Reads a URDF.
///
/// Revolute, continuous, prismatic and fixed joints are read, mimic joints with their chain resolved down to the
/// joint that moves by itself. An axis that is left out is x; one that is no unit vector is normalised. A revolute or
/// prismatic joint without a range moves without limits: many public files leave it out. Shapes are kept, meshes by
/// their names only. Elements that have nothing to do with kinematics are skipped.
///
/// `file_name` is what errors call the text.
///
/// ```
/// let tree = pieper::describe::urdf::read("lift.urdf", r#"
///     <robot name="lift">
///       <link name="floor"/>
///       <link name="cabin"/>
///       <joint name="hoist" type="prismatic">
///         <parent link="floor"/> <child link="cabin"/>
///         <axis xyz="0 0 2"/>
///         <limit lower="0" upper="9" velocity="1" effort="5e3"/>
///       </joint>
///     </robot>"#)?;
/// let poses = tree.link_poses(&[3.0])?;
/// assert_eq!(poses[tree.link_index("cabin")?].translation.vector.z, 3.0);
/// # Ok::<(), pieper::Error>(())
/// ```
///
/// # Errors
/// A parse error with file, line and column: XML that is not well-formed; a number that is none; an axis of length
/// zero; a name that is missing, unknown or taken; floating and planar joints; joints that mimic each other; links
/// in a loop; more than one root.
pub fn read(file_name: &str, text: &str) -> Result<Tree> {
    robot(&xml::parse(file_name, text)?)
}

/// The tree that a `<robot>` element describes.
pub(in crate::describe) fn robot(robot: &Element) -> Result<Tree> {
    if robot.name != "robot" {
        return Err(robot.error("an element <robot> was expected"));
    }
    let (links, link_index) = links(robot)?;
    let mut joints: Vec<RawJoint<'_>> = Vec::new();
    let mut joint_index = HashMap::new();
    for element in robot.elements() {
        match element.name.as_str() {
            "joint" => {
                let joint = joint::joint(element)?;
                if joint_index.insert(joint.name, joints.len()).is_some() {
                    return Err(element.error("there is a joint of this name already"));
                }
                joints.push(joint);
            }
            name if name.starts_with("xacro:") => {
                return Err(element.error("a xacro must be expanded before it is read as URDF"));
            }
            _ => {}
        }
    }
    let (variables, drives) = mimic::resolve(&joints, &joint_index)?;
    let ends = ends(&joints, &link_index)?;
    check_tree(robot, &links, &joints, &ends)?;
    let links = links.into_iter().map(|(_, link)| link).collect();
    let joints = joints
        .iter()
        .zip(ends)
        .zip(drives)
        .map(|((raw, (parent, child)), drive)| TreeJoint {
            name: raw.name.to_owned(),
            parent,
            child,
            origin: raw.origin,
            axis: raw.moving.as_ref().map(|moving| moving.axis),
            drive,
            turns: raw
                .moving
                .as_ref()
                .is_some_and(|m| m.variable.kind.is_angular()),
        })
        .collect();
    let name = robot
        .attribute("name")
        .map_or("", |name| name.value.as_str());
    let tree = Tree::new(links, joints, variables);
    Ok(tree
        .map_err(|error| error.at(robot.spot.place()))?
        .named(name))
}

type Links<'a> = (Vec<(&'a Element, TreeLink)>, HashMap<&'a str, usize>);

fn links(robot: &Element) -> Result<Links<'_>> {
    let mut links = Vec::new();
    let mut index_of = HashMap::new();
    for element in robot.elements().filter(|element| element.name == "link") {
        let name = joint::name(element)?;
        if index_of.insert(name, links.len()).is_some() {
            return Err(element.error("there is a link of this name already"));
        }
        let link = TreeLink {
            name: name.to_owned(),
            shapes: shape::shapes(element)?,
        };
        links.push((element, link));
    }
    Ok((links, index_of))
}

/// Indices of each joint's parent and child link.
fn ends(joints: &[RawJoint<'_>], link_index: &HashMap<&str, usize>) -> Result<Vec<(usize, usize)>> {
    let index = |attribute: &Attribute| {
        let index = link_index.get(attribute.value.as_str()).copied();
        index.ok_or_else(|| attribute.error("there is no link of this name"))
    };
    let ends = joints
        .iter()
        .map(|joint| Ok((index(joint.parent)?, index(joint.child)?)));
    ends.collect()
}

/// What [`Tree::new`] checks too, but with the place in the file.
fn check_tree(
    robot: &Element,
    links: &[(&Element, TreeLink)],
    joints: &[RawJoint<'_>],
    ends: &[(usize, usize)],
) -> Result<()> {
    let mut carrier: Vec<Option<usize>> = vec![None; links.len()];
    for (index, &(_, child)) in ends.iter().enumerate() {
        if let Some(other) = carrier[child].replace(index) {
            let text = format!("joint {} carries this link already", joints[other].name);
            return Err(joints[index].child.error(text));
        }
    }
    if let Some(index) = in_loop(&carrier, ends) {
        return Err(joints[index].element.error("joint and links form a loop"));
    }
    let mut roots = (0..links.len()).filter(|&link| carrier[link].is_none());
    match (roots.next(), roots.next()) {
        (None, _) => Err(robot.error("it has no links")),
        (Some(_), None) => Ok(()),
        (Some(first), Some(second)) => Err(second_root(links[first].0, links[second].0)),
    }
}

#[cold]
fn second_root(first: &Element, second: &Element) -> Error {
    let name = first
        .attribute("name")
        .map_or("", |name| name.value.as_str());
    second.error(format!(
        "no joint carries it, nor link {name}: one root link was expected"
    ))
}

/// A joint that is part of a loop: going up from its parent leads back to it.
fn in_loop(carrier: &[Option<usize>], ends: &[(usize, usize)]) -> Option<usize> {
    // The walk on which a link was first seen. Every link is seen once, so this is linear.
    let mut seen: Vec<Option<usize>> = vec![None; carrier.len()];
    for start in 0..carrier.len() {
        let mut link = start;
        while seen[link].is_none() {
            seen[link] = Some(start);
            let Some(joint) = carrier[link] else { break };
            link = ends[joint].0;
            if seen[link] == Some(start) {
                return Some(joint);
            }
        }
    }
    None
}
