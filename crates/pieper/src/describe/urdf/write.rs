//! Links and joints into URDF text.

use std::fmt::Write;

use nalgebra::Vector3;

use crate::model::{Drive, Geometry, JointKind, Limits, Shape, Tree, TreeJoint, Variable};
use crate::spatial::{self, Pose};

/// Writes a tree as URDF: the same links, joints and shapes in the same order.
///
/// Numbers are written in the shortest form that reads back as the same number; positions and axes come back exactly,
/// rotations to rounding, as they pass through roll, pitch and yaw. The format demands an effort, a velocity and,
/// for a joint that slides, a range: an unknown effort or velocity is written as 0, an unlimited slide as one of
/// a kilometre either way. Accelerations have no place in it.
///
/// ```
/// # let text = r#"<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="continuous">
/// #   <parent link="a"/><child link="b"/><axis xyz="0 1 0"/></joint></robot>"#;
/// use pieper::describe::urdf;
/// let tree = urdf::read("r.urdf", text)?;
/// assert_eq!(urdf::read("again.urdf", &urdf::write(&tree))?, tree);
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn write(tree: &Tree) -> String {
    let mut out = Writer::new(tree.name());
    for link in tree.links() {
        out.link(&link.name, &link.shapes);
    }
    for joint in tree.joints() {
        let name = |link: usize| tree.links()[link].name.as_str();
        out.joint(
            &joint.name,
            [name(joint.parent), name(joint.child)],
            &joint.origin,
            kind(joint, tree.variables()).as_ref(),
        );
    }
    out.finish()
}

fn kind<'a>(joint: &TreeJoint, variables: &'a [Variable]) -> Option<Moving<'a>> {
    let (axis, drive) = (joint.axis?, joint.drive?);
    let variable = &variables[drive.variable];
    Some(Moving {
        turns: joint.turns,
        axis: axis.into_inner(),
        variable,
        follows: (variable.name != joint.name).then_some((&variable.name, drive)),
    })
}

/// What is written of a joint that moves.
pub(super) struct Moving<'a> {
    pub(super) turns: bool,
    pub(super) axis: Vector3<f64>,
    pub(super) variable: &'a Variable,
    /// The joint that moves by the variable, if it is not this one, and how this one follows.
    pub(super) follows: Option<(&'a str, Drive)>,
}

/// The range written for a joint that slides without limits: metres either way.
const UNLIMITED: f64 = 1000.0;

/// A URDF in the making.
pub(super) struct Writer(String);

impl Writer {
    pub(super) fn new(name: &str) -> Self {
        let name = escape(if name.is_empty() { "robot" } else { name });
        Self(format!(
            "<?xml version=\"1.0\"?>\n<robot name=\"{name}\">\n"
        ))
    }

    pub(super) fn finish(mut self) -> String {
        self.0.push_str("</robot>\n");
        self.0
    }

    fn line(&mut self, indent: usize, text: &str) {
        self.0.extend(std::iter::repeat_n("  ", indent));
        self.0.push_str(text);
        self.0.push('\n');
    }

    pub(super) fn link(&mut self, name: &str, shapes: &[Shape]) {
        let name = escape(name);
        if shapes.is_empty() {
            return self.line(1, &format!("<link name=\"{name}\"/>"));
        }
        self.line(1, &format!("<link name=\"{name}\">"));
        for shape in shapes {
            let tag = if shape.collision {
                "collision"
            } else {
                "visual"
            };
            self.line(2, &format!("<{tag}>"));
            self.origin(3, &shape.origin);
            let geometry = geometry(&shape.geometry);
            self.line(3, &format!("<geometry>{geometry}</geometry>"));
            self.line(2, &format!("</{tag}>"));
        }
        self.line(1, "</link>");
    }

    pub(super) fn joint(
        &mut self,
        name: &str,
        [parent, child]: [&str; 2],
        origin: &Pose,
        moving: Option<&Moving<'_>>,
    ) {
        let limits = moving.and_then(Moving::limits);
        let kind = match moving {
            None => "fixed",
            Some(moving) if !moving.turns => "prismatic",
            Some(moving) if limits.is_none() || moving.is_continuous() => "continuous",
            Some(_) => "revolute",
        };
        self.line(
            1,
            &format!("<joint name=\"{}\" type=\"{kind}\">", escape(name)),
        );
        self.line(2, &format!("<parent link=\"{}\"/>", escape(parent)));
        self.line(2, &format!("<child link=\"{}\"/>", escape(child)));
        self.origin(2, origin);
        if let Some(moving) = moving {
            self.line(
                2,
                &format!("<axis xyz=\"{}\"/>", numbers(moving.axis.as_slice())),
            );
            self.limit(kind, limits, moving);
            self.mimic(moving);
        }
        self.line(1, "</joint>");
    }

    fn limit(&mut self, kind: &str, limits: Option<Limits>, moving: &Moving<'_>) {
        let velocity = moving
            .variable
            .velocity
            .filter(|_| moving.follows.is_none());
        let range = match limits {
            _ if kind == "continuous" => None,
            Some(limits) => Some((limits.lower(), limits.upper())),
            None => Some((-UNLIMITED, UNLIMITED)),
        };
        if range.is_none() && velocity.is_none() {
            return;
        }
        let range = range.map_or_else(String::new, |(lower, upper)| {
            format!("lower=\"{}\" upper=\"{}\" ", number(lower), number(upper))
        });
        let velocity = number(velocity.unwrap_or_default());
        self.line(
            2,
            &format!("<limit {range}effort=\"0\" velocity=\"{velocity}\"/>"),
        );
    }

    fn mimic(&mut self, moving: &Moving<'_>) {
        if let Some((leader, drive)) = moving.follows {
            let (factor, offset) = (number(drive.factor), number(drive.offset));
            let leader = escape(leader);
            self.line(
                2,
                &format!("<mimic joint=\"{leader}\" multiplier=\"{factor}\" offset=\"{offset}\"/>"),
            );
        }
    }

    fn origin(&mut self, indent: usize, pose: &Pose) {
        if *pose == Pose::identity() {
            return;
        }
        let xyz = numbers(pose.translation.vector.as_slice());
        let rpy = numbers(&spatial::to_rpy(&pose.rotation));
        self.line(indent, &format!("<origin xyz=\"{xyz}\" rpy=\"{rpy}\"/>"));
    }
}

impl Moving<'_> {
    fn is_continuous(&self) -> bool {
        self.follows.is_none() && self.variable.kind == JointKind::Continuous
    }

    /// The variable's limits, or what they allow the joint that follows it.
    fn limits(&self) -> Option<Limits> {
        let limits = self.variable.limits?;
        let Some((_, drive)) = self.follows else {
            return Some(limits);
        };
        let end = |value: f64| drive.factor.mul_add(value, drive.offset);
        let (a, b) = (end(limits.lower()), end(limits.upper()));
        Limits::new(a.min(b), a.max(b)).ok()
    }
}

fn geometry(geometry: &Geometry) -> String {
    match geometry {
        Geometry::Mesh { uri, scale } => {
            let scale = if *scale == [1.0; 3] {
                String::new()
            } else {
                format!(" scale=\"{}\"", numbers(scale))
            };
            format!("<mesh filename=\"{}\"{scale}/>", escape(uri))
        }
        Geometry::Box { size } => format!("<box size=\"{}\"/>", numbers(size)),
        Geometry::Cylinder { radius, length } => {
            let (radius, length) = (number(*radius), number(*length));
            format!("<cylinder radius=\"{radius}\" length=\"{length}\"/>")
        }
        Geometry::Sphere { radius } => format!("<sphere radius=\"{}\"/>", number(*radius)),
    }
}

fn numbers(values: &[f64]) -> String {
    let words: Vec<String> = values.iter().copied().map(number).collect();
    words.join(" ")
}

/// The shortest form that reads back as the same number.
pub(super) fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    // `{:?}` is the shorter one for very large and very small numbers, which it writes with an exponent.
    let scientific = format!("{value:?}");
    if scientific.contains('e') {
        scientific
    } else {
        value.to_string()
    }
}

/// A text as an attribute's value; what XML cannot hold becomes the replacement character.
pub(in crate::describe) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\t' | '\n' | '\r' => {
                // Written plainly they would be read as spaces. Writing to a string does not fail.
                let _ = write!(out, "&#{};", u32::from(c));
            }
            '\0'..'\x20' | '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            _ => out.push(c),
        }
    }
    out
}
