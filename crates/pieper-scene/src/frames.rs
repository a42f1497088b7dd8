//! Where links are.

use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use pieper::model::{Chain, Tree};
use pieper::spatial::{Pose, shift, sin_cos_exact, turn};

/// Which frames the links of a [`Body`](crate::Body) hang on.
#[derive(Clone, Debug)]
pub enum Frames {
    /// The base, then for each joint of a chain that moves the frame behind its motion: z is the joint's axis.
    Axes,
    /// The links of a tree, of which the chain's variables are the first few that are its own; others stand at zero.
    Tree {
        /// The tree.
        tree: Box<Tree>,
        /// For each variable of the tree the one of the chain that is the same.
        variables: Vec<Option<usize>>,
        /// From the world of the chain to the tree's root at all variables zero.
        root: Isometry3<f64>,
    },
}

impl Frames {
    /// The frames of a tree's links as `chain`, taken out of it, moves them.
    pub fn of_tree(tree: &Tree, chain: &Chain) -> Self {
        let place = |name: &str| chain.variables().iter().position(|v| v.name == name);
        let variables: Vec<Option<usize>> =
            tree.variables().iter().map(|v| place(&v.name)).collect();
        let zeros = vec![0.0; variables.len()];
        // The chain may begin at an inner link: that one stands at the chain's base.
        let first = chain.joints().first().map(|joint| joint.name.as_str());
        let parent = tree
            .joints()
            .iter()
            .find(|joint| Some(joint.name.as_str()) == first);
        let root = match (parent, tree.link_poses(&zeros)) {
            (Some(joint), Ok(poses)) => isometry(&(chain.base() * poses[joint.parent].inverse())),
            _ => isometry(chain.base()),
        };
        Self::Tree {
            tree: Box::new(tree.clone()),
            variables,
            root,
        }
    }

    /// How many there are.
    pub fn count(&self, chain: &Chain) -> usize {
        match self {
            Self::Axes => chain.canonical().steps.len() + 1,
            Self::Tree { tree, .. } => tree.links().len(),
        }
    }

    /// The poses of all links in the world, into `out`. Joint values must fit the chain.
    pub fn at(&self, chain: &Chain, q: &[f64], out: &mut Vec<Isometry3<f64>>) {
        out.clear();
        match self {
            Self::Axes => {
                let canonical = chain.canonical();
                let mut pose = canonical.base;
                out.push(isometry(&pose));
                for (index, step) in canonical.steps.iter().enumerate() {
                    let by = step.drive.displacement(q);
                    let z = Vector3::z_axis();
                    pose *= match step.turns {
                        true => turn(&z, sin_cos_exact(by)),
                        false => shift(by * *z),
                    };
                    out.push(isometry(&pose));
                    pose *= canonical.link(index);
                }
            }
            Self::Tree {
                tree,
                variables,
                root,
            } => {
                let all: Vec<f64> = variables
                    .iter()
                    .map(|v| v.and_then(|v| q.get(v)).copied().unwrap_or(0.0))
                    .collect();
                match tree.link_poses(&all) {
                    Ok(poses) => out.extend(poses.iter().map(|pose| root * isometry(pose))),
                    Err(_) => out.extend(tree.links().iter().map(|_| *root)),
                }
            }
        }
    }
}

/// The same motion with its turn as a quaternion.
pub fn isometry(pose: &Pose) -> Isometry3<f64> {
    Isometry3::from_parts(
        pose.translation,
        UnitQuaternion::from_rotation_matrix(&pose.rotation),
    )
}
