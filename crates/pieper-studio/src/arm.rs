//! An arm, prepared once for everything the studio asks of it.

use std::collections::HashMap;

use nalgebra::Isometry3;
use pieper::describe::{Expr, Form, Robot, urdf};
use pieper::ik::{Search, Solver};
use pieper::kinematics;
use pieper::model::{Chain, JointKind};
use pieper_scene::{Bars, Body, Frames, Mesh, Picker, outline};

use crate::command::Load;

/// Where the files of a description lie: a mesh's address in, its bytes or a sentence out.
pub type Fetch = dyn Fn(&str) -> Result<Vec<u8>, String> + Send + Sync;

/// An arm with its solver, its body and what is drawn around it.
pub struct Arm {
    /// The name it was asked for by: a built-in's, or a file's.
    pub(crate) id: String,
    pub(crate) robot: Robot,
    pub(crate) chain: Chain,
    pub(crate) solver: Solver,
    pub(crate) search: Search,
    pub(crate) body: Body,
    pub(crate) frames: Frames,
    /// The four-bar linkages that are drawn: three links for each, behind those of the frames.
    pub(crate) bars: Vec<Bars>,
    pub(crate) picker: Picker,
    pub(crate) outline: Vec<[f64; 2]>,
    pub(crate) reach: f64,
    /// The meshes as bytes, by their names.
    pub(crate) meshes: HashMap<String, Vec<u8>>,
    /// For each link the names of its parts' meshes.
    pub(crate) names: Vec<Vec<String>>,
    /// For each link the variable that moves it last.
    pub(crate) mover: Vec<Option<usize>>,
}

impl Arm {
    /// Prepares a robot; `fetch` finds the meshes that its description names.
    ///
    /// # Errors
    /// A sentence: a symbol without a value, a chain without joints.
    pub fn new(id: &str, robot: Robot, fetch: &Fetch) -> Result<Self, String> {
        let missing = robot.missing_parameters();
        if !missing.is_empty() {
            return Err(format!(
                "{id}: {} has no value: give one, as in --set {}=0.3",
                missing.join(", "),
                missing[0]
            ));
        }
        let text = |error: pieper::Error| format!("{id}: {error}");
        let chain = robot.chain().map_err(text)?;
        let described = match &robot.form {
            Form::Tree { tree, .. } => {
                Body::of_tree(tree, fetch).map(|body| (body, Frames::of_tree(tree, &chain)))
            }
            _ => None,
        };
        let (body, frames) = match described {
            Some((body, frames)) if !body.is_bare() => (body, frames),
            described => {
                // Not one mesh could be had: a body made from the geometry says more than blocks.
                let problems = described.map_or_else(Vec::new, |(body, _)| body.problems);
                let body = Body {
                    problems,
                    ..Body::of_chain(&chain, &robot.up.axis())
                };
                (body, Frames::Axes)
            }
        };
        let bars = match frames {
            Frames::Axes => Bars::of(&chain, &robot.transmission().map_err(text)?),
            Frames::Tree { .. } => Vec::new(),
        };
        let body = body.with_bars(&bars);
        let mut meshes = HashMap::new();
        let mut name = |mesh: &Mesh| {
            let name = mesh.hash();
            meshes
                .entry(name.clone())
                .or_insert_with(|| mesh.to_bytes());
            name
        };
        let names = body
            .links
            .iter()
            .map(|parts| parts.iter().map(|part| name(&part.mesh)).collect())
            .collect();
        let own = (0..frames.count(&chain))
            .map(|link| mover(&chain, &frames, link))
            .collect();
        let mover = with_bars(own, &bars);
        let reach = kinematics::reach(&chain).map_err(text)?.from_base;
        Ok(Self {
            id: id.to_owned(),
            solver: Solver::new(&chain).map_err(text)?,
            search: Search::new(&chain).map_err(text)?,
            picker: Picker::new(&body),
            outline: outline::outline(&chain),
            reach: if reach.is_finite() { reach } else { 1.0 },
            robot,
            chain,
            body,
            frames,
            bars,
            meshes,
            names,
            mover,
        })
    }

    /// The arm that a page asks for: a built-in one, or a file's text.
    pub(crate) fn load(wanted: &Load) -> Result<Self, String> {
        let (id, robot) = match (&wanted.robot, &wanted.file) {
            (Some(id), None) => {
                let built_in = pieper_robots::find(id);
                let built_in = built_in
                    .ok_or_else(|| format!("{id}: there is no built-in arm of that name"))?;
                (id.clone(), built_in.robot())
            }
            (None, Some(file)) => {
                let ending = file
                    .name
                    .rsplit('.')
                    .next()
                    .unwrap_or_default()
                    .to_ascii_lowercase();
                let robot = match ending.as_str() {
                    "toml" => Robot::from_toml(&file.name, &file.text),
                    "urdf" | "xml" => urdf::read(&file.name, &file.text)
                        .and_then(|tree| Robot::of_tree(tree, None, None)),
                    _ => return Err(format!("{}: a .toml or .urdf file was expected", file.name)),
                };
                (file.name.clone(), robot.map_err(|error| error.to_string())?)
            }
            _ => return Err("load: either robot or file was expected".to_owned()),
        };
        let mut values = Vec::new();
        for (name, value) in &wanted.values {
            let expr = Expr::parse(value).map_err(|error| format!("{name} = {value}: {error}"))?;
            values.push((name.as_str(), expr));
        }
        let robot = robot
            .with_parameters(values)
            .map_err(|error| error.to_string())?;
        // A page cannot make this program read files: meshes come with arms given on the command line.
        Self::new(&id, robot, &|_| {
            Err("meshes are read only for an arm given on the command line".to_owned())
        })
    }

    /// What of its looks could not be had, a sentence each.
    pub fn problems(&self) -> &[String] {
        &self.body.problems
    }

    /// The number of joint values.
    pub(crate) fn dof(&self) -> usize {
        self.chain.dof()
    }

    /// The poses of all links.
    pub(crate) fn poses(&self, q: &[f64]) -> Vec<Isometry3<f64>> {
        let mut poses = Vec::new();
        self.frames.at(&self.chain, q, &mut poses);
        for bars in &self.bars {
            let bars = bars.poses(&poses, q);
            poses.extend(bars);
        }
        poses
    }

    /// The number of the arm's own links: those behind are bars.
    pub(crate) fn links(&self) -> usize {
        self.mover.len() - 3 * self.bars.len()
    }

    /// The link that moves as one touches it: of a bar, the one that its linkage drives.
    pub(crate) fn link_of(&self, touched: usize) -> usize {
        let bar = touched.checked_sub(self.links()).map(|bar| bar / 3);
        bar.and_then(|bar| self.bars.get(bar))
            .map_or(touched, Bars::driven)
    }

    /// Zero, or the limit nearest to it.
    pub(crate) fn zero(&self) -> Vec<f64> {
        self.chain
            .variables()
            .iter()
            .map(|v| {
                v.limits
                    .map_or(0.0, |l| 0.0_f64.clamp(l.lower(), l.upper()))
            })
            .collect()
    }

    /// A value within the joint's limits.
    pub(crate) fn clamp(&self, joint: usize, value: f64) -> f64 {
        self.chain.variables()[joint]
            .limits
            .map_or(value, |l| value.clamp(l.lower(), l.upper()))
    }

    /// The range of a slider.
    pub(crate) fn range(&self, joint: usize) -> ([f64; 2], bool) {
        let variable = &self.chain.variables()[joint];
        match variable.limits {
            Some(limits) => ([limits.lower(), limits.upper()], false),
            None if variable.kind == JointKind::Prismatic => ([-self.reach, self.reach], true),
            None => ([-std::f64::consts::PI, std::f64::consts::PI], true),
        }
    }
}

/// The bars move with what they drive.
fn with_bars(mut mover: Vec<Option<usize>>, bars: &[Bars]) -> Vec<Option<usize>> {
    for bars in bars {
        let driven = mover[bars.driven()];
        mover.extend([driven; 3]);
    }
    mover
}

/// The variable that moves a link last before it, if any does.
fn mover(chain: &Chain, frames: &Frames, link: usize) -> Option<usize> {
    match frames {
        Frames::Axes => Some(
            chain
                .canonical()
                .steps
                .get(link.checked_sub(1)?)?
                .drive
                .variable,
        ),
        Frames::Tree {
            tree, variables, ..
        } => {
            let mut at = link;
            while let Some(joint) = tree.carrier(at) {
                if let Some(variable) = joint.drive.and_then(|drive| variables[drive.variable]) {
                    return Some(variable);
                }
                at = joint.parent;
            }
            None
        }
    }
}
