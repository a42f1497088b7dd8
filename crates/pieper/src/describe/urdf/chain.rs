//! A chain of any origin, written as URDF.

use std::collections::HashSet;

use nalgebra::Vector3;

use super::write::{Moving, Writer};
use crate::model::{Chain, Drive, Joint, JointKind, Motion, Variable};
use crate::spatial::{self, Pose};

/// Writes a chain as the URDF of a robot called `name`, from its root link `base_link` to a link `tool`.
///
/// Reading it back and taking the chain between these two links gives the same joint vector and, to rounding, the
/// same frame for every link. URDF is narrower than a chain, so some joints become several:
///
/// - a base that is not the identity is a fixed joint to a link `mount`; the tool is a fixed joint;
/// - a joint with a transform behind its motion, as in a Denavit-Hartenberg row, gets a link `<link>_axis` that moves
///   and carries the link itself;
/// - a factor of -1 turns the axis round, an offset goes into the joint's origin;
/// - joints that share a variable mimic the joint of its name. If the chain has no joint of that name that moves by
///   the plain variable, a joint is made that moves a link `<variable>_variable` without effect.
///
/// A name that is taken gets a number behind it. Limits and velocities are written as [`write`](super::write()) does.
///
/// ```
/// # let text = r#"<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="continuous">
/// #   <parent link="a"/><child link="b"/><origin xyz="1 0 0"/><axis xyz="0 1 0"/></joint></robot>"#;
/// # let tree = pieper::describe::urdf::read("r.urdf", text)?;
/// # let chain = tree.chain(0, 1)?;
/// use pieper::describe::urdf;
/// let written = urdf::write_chain("arm", &chain);
/// let again = urdf::read("arm.urdf", &written)?;
/// let again = again.chain(again.link_index("base_link")?, again.link_index("tool")?)?;
/// assert_eq!(again.variables(), chain.variables());
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn write_chain(name: &str, chain: &Chain) -> String {
    let plan = Plan::of(chain);
    let mut out = Writer::new(name);
    for link in plan.links() {
        out.link(link, &[]);
    }
    for step in &plan.steps {
        out.joint(
            &step.name,
            [step.parent.as_str(), step.child.as_str()],
            &step.origin,
            step.moving
                .as_ref()
                .map(|moving| moving.named(&plan, chain))
                .as_ref(),
        );
    }
    out.finish()
}

/// The joints of the URDF, in order.
struct Plan {
    root: String,
    variables: Vec<String>,
    steps: Vec<Step>,
}

struct Step {
    name: String,
    parent: String,
    child: String,
    origin: Pose,
    moving: Option<Move>,
}

struct Move {
    turns: bool,
    axis: Vector3<f64>,
    drive: Drive,
    follows: bool,
}

impl Move {
    fn named<'a>(&self, plan: &'a Plan, chain: &'a Chain) -> Moving<'a> {
        let leader = plan.variables[self.drive.variable].as_str();
        Moving {
            turns: self.turns,
            axis: self.axis,
            variable: &chain.variables()[self.drive.variable],
            follows: self.follows.then_some((leader, self.drive)),
        }
    }
}

impl Plan {
    fn of(chain: &Chain) -> Self {
        let mut links = Names::default();
        let mut joints = Names::default();
        let link_names: Vec<String> = chain
            .joints()
            .iter()
            .map(|joint| links.take(&joint.link, "link"))
            .collect();
        let variables: Vec<String> = chain
            .variables()
            .iter()
            .map(|variable| joints.take(&variable.name, "joint"))
            .collect();
        let mut plan = Self {
            root: links.take("base_link", "base_link"),
            variables,
            steps: Vec::new(),
        };
        let tip = links.take("tool", "tool");
        let mut last = plan.root.clone();
        let owners = owners(chain);
        for (index, owner) in owners.iter().enumerate() {
            if owner.is_none() {
                plan.add_variable(index, &chain.variables()[index], &mut links);
            }
        }
        if *chain.base() != Pose::identity() {
            let mount = links.take("mount", "mount");
            plan.fixed(
                joints.take("base_joint", "base_joint"),
                &mut last,
                mount,
                chain.base(),
            );
        }
        for (index, (joint, link)) in chain.joints().iter().zip(link_names).enumerate() {
            let owned = owners.iter().position(|&owner| owner == Some(index));
            let name = match owned {
                Some(variable) => plan.variables[variable].clone(),
                None => joints.take(&joint.name, "joint"),
            };
            let Some(step) = moving(joint, owned.is_none()) else {
                plan.fixed(name, &mut last, link, &(joint.before * joint.after));
                continue;
            };
            let direct = joint.after == Pose::identity();
            let moved = if direct {
                link.clone()
            } else {
                links.take(&format!("{link}_axis"), "axis")
            };
            plan.steps.push(Step {
                name,
                parent: std::mem::replace(&mut last, moved.clone()),
                child: moved,
                ..step
            });
            if !direct {
                let name = joints.take(&format!("{}_fixed", joint.name), "fixed");
                plan.fixed(name, &mut last, link, &joint.after);
            }
        }
        let name = joints.take("tool_joint", "tool_joint");
        plan.fixed(name, &mut last, tip, chain.tool());
        plan
    }

    /// The links, in the order of the joints that carry them.
    fn links(&self) -> impl Iterator<Item = &str> {
        let children = self.steps.iter().map(|step| step.child.as_str());
        std::iter::once(self.root.as_str()).chain(children)
    }

    fn fixed(&mut self, name: String, last: &mut String, child: String, origin: &Pose) {
        self.steps.push(Step {
            name,
            parent: std::mem::replace(last, child.clone()),
            child,
            origin: *origin,
            moving: None,
        });
    }

    /// A joint that has no effect but to give the others a variable to follow.
    fn add_variable(&mut self, index: usize, variable: &Variable, links: &mut Names) {
        let drive = Drive {
            variable: index,
            factor: 1.0,
            offset: 0.0,
        };
        self.steps.push(Step {
            name: self.variables[index].clone(),
            parent: self.root.clone(),
            child: links.take(&format!("{}_variable", variable.name), "variable"),
            origin: Pose::identity(),
            moving: Some(Move {
                turns: variable.kind.is_angular(),
                axis: Vector3::z(),
                drive,
                follows: false,
            }),
        });
    }
}

/// For each variable the joint that has its name and moves by it, or against it, but for an offset.
fn owners(chain: &Chain) -> Vec<Option<usize>> {
    let owns = |joint: &Joint, index: usize, variable: &Variable| {
        let same_kind = match joint.motion {
            Motion::Fixed => false,
            Motion::Turn(..) => variable.kind != JointKind::Prismatic,
            Motion::Slide(..) => variable.kind == JointKind::Prismatic,
        };
        let drive = joint.motion.drive();
        let plain = drive.is_some_and(|d| d.variable == index && d.factor.abs() == 1.0);
        same_kind && plain && joint.name == variable.name
    };
    chain
        .variables()
        .iter()
        .enumerate()
        .map(|(index, variable)| {
            let mut joints = chain.joints().iter();
            joints.position(|joint| owns(joint, index, variable))
        })
        .collect()
}

/// A joint that moves, without its names; `None` for a fixed one.
fn moving(joint: &Joint, follows: bool) -> Option<Step> {
    let (axis, drive) = (joint.motion.axis()?, *joint.motion.drive()?);
    let turns = matches!(joint.motion, Motion::Turn(..));
    let mut origin = joint.before;
    let mut direction = axis.into_inner();
    if !follows {
        if drive.offset != 0.0 {
            origin *= if turns {
                spatial::turn(axis, spatial::sin_cos_exact(drive.offset))
            } else {
                spatial::shift(direction * drive.offset)
            };
        }
        direction *= drive.factor;
    }
    Some(Step {
        name: String::new(),
        parent: String::new(),
        child: String::new(),
        origin,
        moving: Some(Move {
            turns,
            axis: direction,
            drive,
            follows,
        }),
    })
}

/// Names that are taken.
#[derive(Default)]
struct Names(HashSet<String>);

impl Names {
    /// `name`, or `fallback` for an empty one, with the first free number behind it if it is taken.
    fn take(&mut self, name: &str, fallback: &str) -> String {
        let name = if name.trim().is_empty() {
            fallback
        } else {
            name
        };
        let mut free = name.to_owned();
        let mut number = 2;
        while !self.0.insert(free.clone()) {
            free = format!("{name}_{number}");
            number += 1;
        }
        free
    }
}
