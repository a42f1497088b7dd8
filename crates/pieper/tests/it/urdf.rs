//! URDF: what is read, and that writing and reading are each other's inverse.

use nalgebra::{Rotation3, UnitVector3, Vector3};
use pieper::describe::urdf;
use pieper::model::{
    Chain, ChainParts, Drive, Geometry, Joint, JointKind, Limits, Motion, Tree, Variable,
};
use pieper::spatial::{self, Pose};

const ARM: &str = include_str!("../data/arm.urdf");

fn arm() -> Tree {
    urdf::read("arm.urdf", ARM).unwrap()
}

/// Numbers in [-1, 1) from a seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// A value for each variable: within its limits, so that the arm keeps its size.
    fn joint_vector(&mut self, variables: &[Variable]) -> Vec<f64> {
        let mut value = |variable: &Variable| {
            let (lower, upper) = variable
                .limits
                .map_or((-3.0, 3.0), |l| (l.lower(), l.upper()));
            lower + (upper - lower) * 0.5 * (self.next() + 1.0)
        };
        variables.iter().map(&mut value).collect()
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.next())
    }

    fn pose(&mut self) -> Pose {
        let angles = self.vector() * 3.0;
        let rotation = Rotation3::from_scaled_axis(angles);
        Pose::from_parts(self.vector().into(), rotation)
    }
}

fn difference(a: &Pose, b: &Pose) -> f64 {
    (a.to_homogeneous() - b.to_homogeneous()).amax()
}

/// The frame of every link of a chain, by link name.
fn frames(chain: &Chain, q: &[f64]) -> Vec<(String, Pose)> {
    let mut pose = *chain.base();
    let mut frames = Vec::new();
    for joint in chain.joints() {
        pose *= joint.pose(q);
        frames.push((joint.link.clone(), pose));
    }
    frames.push(("tool".into(), pose * chain.tool()));
    frames
}

#[test]
fn reads_links_joints_and_variables() {
    let tree = arm();
    assert_eq!(tree.name(), "everything");
    assert_eq!(tree.links()[tree.root()].name, "floor");
    let summary: Vec<String> = tree
        .variables()
        .iter()
        .map(|v| {
            let limits = v.limits.map(|l| (l.lower(), l.upper()));
            format!("{} {:?} {limits:?} {:?}", v.name, v.kind, v.velocity)
        })
        .collect();
    let expected = [
        "turn Continuous None Some(2.5)",
        "lift Revolute Some((-1.5, 1.75)) Some(2.0)",
        "reach Prismatic Some((0.0, 0.4)) None",
        "roll Revolute None None",
        "left_finger Prismatic Some((0.0, 0.04)) Some(0.1)",
    ];
    assert_eq!(summary, expected);
    let drive = |name: &str| tree.joints().iter().find(|j| j.name == name).unwrap().drive;
    let follow = |factor, offset| {
        Some(Drive {
            variable: 4,
            factor,
            offset,
        })
    };
    assert_eq!(drive("mirror"), follow(-0.5, 0.0));
    assert_eq!(drive("right_finger"), follow(-1.0, 0.001));
}

/// A robot of joints `parent-child`, those with a `~` between them moving.
fn tip_of(joints: &str) -> String {
    let mut text = String::from("<robot name=\"r\"><link name=\"base\"/>");
    for joint in joints.split(' ') {
        let kind = if joint.contains('~') {
            "continuous"
        } else {
            "fixed"
        };
        let (parent, child) = joint.split_once(['~', '-']).unwrap();
        text += &format!(
            "<link name=\"{child}\"/><joint name=\"{child}\" type=\"{kind}\">
            <parent link=\"{parent}\"/><child link=\"{child}\"/></joint>"
        );
    }
    let tree = urdf::read("", &(text + "</robot>")).unwrap();
    tree.links()[tree.default_tip()].name.clone()
}

#[test]
fn the_default_tip_is_where_a_person_would_put_the_tool() {
    let cases = [
        ("base~a a~b b-c", "c"),
        ("base~a a~b b-c b-tool0 c-d", "tool0"),
        ("base~a a~b b-knee b-c c-d", "d"),
        // Fingers are no tips, behind whatever they are mounted on.
        ("base~a a~b b~hand hand~left hand~right", "hand"),
        (
            "base~a a~b b~c c-hand hand~left hand~right hand-tcp left-pad",
            "tcp",
        ),
        // Two arms on a torso are.
        ("base~torso torso~l1 l1~l2 l2~l3 torso~r1 r1~r2 r2~r3", "l3"),
        ("base-torso torso~l1 l1~l2 torso~r1 r1~r2 r2~r3", "r3"),
    ];
    for (joints, tip) in cases {
        assert_eq!(tip_of(joints), tip, "{joints}");
    }
    assert_eq!(arm().links()[arm().default_tip()].name, "camera");
}

#[test]
fn axes_are_unit_vectors_and_right_angles_exact() {
    let tree = arm();
    let joint = |name: &str| tree.joints().iter().find(|j| j.name == name).unwrap();
    assert_eq!(joint("lift").axis, Some(-Vector3::y_axis()));
    assert_eq!(
        joint("reach").axis.unwrap().into_inner(),
        Vector3::new(2.0, 2.0, 1.0) / 3.0
    );
    assert_eq!(joint("roll").axis, Some(Vector3::x_axis()));
    assert_eq!(joint("stand").origin.rotation * Vector3::x(), Vector3::y());
    let quarter = spatial::from_xyz_rpy([0.0; 3], [0.0, std::f64::consts::FRAC_PI_2, 0.0]);
    assert!(difference(&joint("roll").origin, &quarter) < 3e-16);
}

#[test]
fn keeps_shapes() {
    let tree = arm();
    let shapes = |name: &str| &tree.links()[tree.link_index(name).unwrap()].shapes;
    assert_eq!(
        shapes("column")[0].geometry,
        Geometry::Cylinder {
            radius: 0.08,
            length: 0.4
        }
    );
    assert_eq!(shapes("column")[0].origin.translation.z, 0.2);
    assert!(shapes("column")[1].collision);
    assert_eq!(
        shapes("column")[1].geometry,
        Geometry::Box {
            size: [0.2, 0.2, 0.4]
        }
    );
    assert_eq!(
        shapes("shoulder")[0].geometry,
        Geometry::Sphere { radius: 0.1 }
    );
    let uri = "package://everything/meshes/upper arm.stl".to_owned();
    let scale = [0.001, 0.001, -0.001];
    assert_eq!(
        shapes("upper_arm")[0].geometry,
        Geometry::Mesh { uri, scale }
    );
}

#[test]
fn link_poses_equal_the_chains_product() {
    let tree = arm();
    let mut random = Random(1);
    for tip in 0..tree.links().len() {
        let Ok(chain) = tree.chain(tree.root(), tip) else {
            continue;
        };
        for _ in 0..20 {
            let all = random.joint_vector(tree.variables());
            let index = |v: &Variable| tree.variables().iter().position(|t| t.name == v.name);
            let q: Vec<f64> = chain
                .variables()
                .iter()
                .map(|v| all[index(v).unwrap()])
                .collect();
            let poses = tree.link_poses(&all).unwrap();
            for (name, pose) in frames(&chain, &q) {
                let link = if name == "tool" {
                    tip
                } else {
                    tree.link_index(&name).unwrap()
                };
                assert_eq!(difference(&poses[link], &pose), 0.0, "{name}");
            }
        }
    }
}

#[test]
fn a_written_tree_reads_back_the_same() {
    let tree = arm();
    let text = urdf::write(&tree);
    let again = urdf::read("written.urdf", &text).unwrap();
    assert_eq!(again.links().len(), tree.links().len());
    assert_eq!(urdf::write(&again), text, "writing is a fixed point");
    let mut random = Random(2);
    for _ in 0..100 {
        let q = random.joint_vector(tree.variables());
        let (before, after) = (tree.link_poses(&q).unwrap(), again.link_poses(&q).unwrap());
        for (a, b) in before.iter().zip(&after) {
            assert!(difference(a, b) < 1e-15, "{:e}", difference(a, b));
        }
    }
    // No range at all is allowed for a revolute joint only by us: it is written as what it is.
    let kinds = |tree: &Tree| tree.variables().iter().map(|v| v.kind).collect::<Vec<_>>();
    assert_eq!(kinds(&again)[3], JointKind::Continuous);
    assert_eq!(kinds(&again)[..3], kinds(&tree)[..3]);
}

/// Writes a chain, reads it back and compares joint vectors and every frame.
fn check_chain(chain: &Chain, tolerance: f64) -> String {
    let text = urdf::write_chain("some arm", chain);
    let tree = urdf::read("written.urdf", &text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    let (base, tip) = ("base_link", "tool");
    let again = tree
        .chain(
            tree.link_index(base).unwrap(),
            tree.link_index(tip).unwrap(),
        )
        .unwrap();
    let names = |c: &Chain| {
        c.variables()
            .iter()
            .map(|v| v.name.clone())
            .collect::<Vec<_>>()
    };
    let order: Vec<usize> = names(&again)
        .iter()
        .map(|n| names(chain).iter().position(|m| m == n).unwrap())
        .collect();
    let mut random = Random(3);
    for _ in 0..50 {
        let q = random.joint_vector(chain.variables());
        let again_q: Vec<f64> = order.iter().map(|&i| q[i]).collect();
        let written = frames(&again, &again_q);
        for (name, pose) in frames(chain, &q) {
            let (_, other) = written.iter().rfind(|(n, _)| *n == name).unwrap();
            let off = difference(&pose, other);
            assert!(off < tolerance, "{name} is off by {off:e}\n{text}");
        }
    }
    text
}

#[test]
fn a_chain_from_urdf_goes_there_and_back() {
    let tree = arm();
    for tip in ["hand", "camera", "left", "right"] {
        let chain = tree.chain(0, tree.link_index(tip).unwrap()).unwrap();
        check_chain(&chain, 1e-15);
    }
}

fn joint(name: &str, random: &mut Random, motion: Motion) -> Joint {
    Joint {
        name: name.into(),
        link: format!("link {name}"),
        before: random.pose(),
        motion,
        after: random.pose(),
    }
}

#[test]
fn any_chain_can_be_written() {
    let mut random = Random(4);
    let drive = |variable, factor, offset| Drive {
        variable,
        factor,
        offset,
    };
    let axis = |random: &mut Random| UnitVector3::new_normalize(random.vector());
    let [a, b, c, d] = [(); 4].map(|()| axis(&mut random));
    let joints = vec![
        joint("q1", &mut random, Motion::Turn(a, drive(0, -1.0, 0.7))),
        joint("still", &mut random, Motion::Fixed),
        joint("q2", &mut random, Motion::Slide(b, drive(1, 1.0, -0.3))),
        joint("back", &mut random, Motion::Turn(c, drive(0, 2.0, 0.1))),
        joint("q3", &mut random, Motion::Turn(d, drive(2, 0.5, 0.2))),
        joint("tool", &mut random, Motion::Turn(a, drive(3, 1.0, 0.0))),
        joint("screw", &mut random, Motion::Slide(a, drive(2, 0.01, 0.0))),
    ];
    let kinds = [
        JointKind::Revolute,
        JointKind::Prismatic,
        JointKind::Revolute,
        JointKind::Continuous,
    ];
    let names = ["q1", "q2", "q3", "elsewhere <&\">"];
    let mut variables: Vec<Variable> = names
        .iter()
        .zip(kinds)
        .map(|(n, k)| Variable::new(*n, k))
        .collect();
    variables[0].limits = Limits::new(-1.0, 2.0).ok();
    variables[0].velocity = Some(0.1);
    let base = random.pose();
    let tool = random.pose();
    let chain = Chain::new(ChainParts {
        variables,
        joints,
        base,
        tool,
    })
    .unwrap();
    let text = check_chain(&chain, 2e-14);
    assert!(text.contains("<limit lower=\"-1\" upper=\"2\" effort=\"0\" velocity=\"0.1\"/>"));
    assert!(text.contains("<mimic joint=\"q1\" multiplier=\"2\" offset=\"0.1\"/>"));
    assert!(text.contains("<limit lower=\"-1.9\" upper=\"4.1\" effort=\"0\" velocity=\"0\"/>"));
}

#[test]
fn names_that_are_taken_get_a_number() {
    let mut random = Random(5);
    let drive = Drive {
        variable: 0,
        factor: 1.0,
        offset: 0.0,
    };
    let mut joints = vec![
        joint("tool_joint", &mut random, Motion::turn_z(drive)),
        joint("tool_joint", &mut random, Motion::Fixed),
        joint("", &mut random, Motion::Fixed),
    ];
    for (joint, link) in joints.iter_mut().zip(["base_link", "base_link", ""]) {
        joint.link = link.into();
    }
    let variables = vec![Variable::new("tool_joint", JointKind::Continuous)];
    let (base, tool) = (random.pose(), random.pose());
    let chain = Chain::new(ChainParts {
        variables,
        joints,
        base,
        tool,
    })
    .unwrap();
    let tree = urdf::read("", &urdf::write_chain("", &chain)).unwrap();
    let links: Vec<&str> = tree.links().iter().map(|l| l.name.as_str()).collect();
    let expected = [
        "base_link_3",
        "mount",
        "base_link_axis",
        "base_link",
        "base_link_2",
        "link",
        "tool",
    ];
    assert_eq!(links, expected);
    let joints: Vec<&str> = tree.joints().iter().map(|j| j.name.as_str()).collect();
    let expected = [
        "base_joint",
        "tool_joint",
        "tool_joint_fixed",
        "tool_joint_2",
        "joint",
        "tool_joint_3",
    ];
    assert_eq!(joints, expected);
}

/// Rotations near a pitch of a right angle, where roll and yaw can hardly be told apart.
#[test]
fn near_gimbal_lock_rotations_survive() {
    let mut random = Random(6);
    for exponent in 0..18 {
        for sign in [-1.0, 1.0] {
            let off = 10f64.powi(-exponent);
            let pitch = sign * (std::f64::consts::FRAC_PI_2 - off);
            let rpy = [3.0 * random.next(), pitch, 3.0 * random.next()];
            let text = format!(
                r#"<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="fixed">
                <parent link="a"/><child link="b"/><origin rpy="{} {} {}"/></joint></robot>"#,
                rpy[0], rpy[1], rpy[2]
            );
            let tree = urdf::read("", &text).unwrap();
            let again = urdf::read("", &urdf::write(&tree)).unwrap();
            let off = difference(&tree.joints()[0].origin, &again.joints()[0].origin);
            assert!(off < 1e-15, "{rpy:?}: {off:e}");
        }
    }
}
