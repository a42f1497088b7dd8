//! Forward kinematics of the AR3 beside the peers: `cargo run --release --manifest-path bench/Cargo.toml --bin fk`

use std::f64::consts::FRAC_PI_2;
use std::hint::black_box;

use nalgebra::{Matrix4, Vector3};
use pieper::kinematics::batch::{self, JointBatch, PoseBatch};
use pieper::kinematics::{self, Jacobian, Reference};
use pieper_bench::{Contender, print, race};
use rs_opw_kinematics::kinematic_traits::Kinematics;
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;

const POSES: usize = 1024;
const ROUNDS: usize = 2000;

fn main() {
    let chain = pieper_robots::find("ar3").expect("built in").robot().chain().expect("numbers");
    let mut random = fastrand::Rng::with_seed(1);
    let inputs: Vec<[f64; 6]> = (0..POSES).map(|_| std::array::from_fn(|_| 3.0 * (2.0 * random.f64() - 1.0))).collect();
    let opw = OPWKinematics::new(Parameters {
        a1: 0.079,
        a2: 0.0,
        b: 0.0,
        c1: 0.164,
        c2: 0.305,
        c3: 0.222,
        c4: 0.0777,
        offsets: [-FRAC_PI_2, -FRAC_PI_2, 0.0, 0.0, 0.0, 0.0],
        sign_corrections: [1, -1, 1, 1, 1, 1],
        dof: 6,
    });
    let k = k_chain();
    for q in &inputs {
        let ours = kinematics::tool_pose(&chain, q).unwrap().translation.vector;
        let theirs = opw.forward(q).translation;
        assert!((ours - Vector3::new(theirs.x, theirs.y, theirs.z)).norm() < 1e-12, "the peer computes another arm");
        k.set_joint_positions_unchecked(q);
        let theirs = k.end_transform().translation;
        assert!((ours - Vector3::new(theirs.x, theirs.y, theirs.z)).norm() < 1e-12, "the peer computes another arm");
        assert!((ours - naive(q).fixed_view::<3, 1>(0, 3)).norm() < 1e-12);
    }

    let mut many = JointBatch::zeros(6, POSES);
    inputs.iter().enumerate().for_each(|(index, q)| many.set(index, q));
    let mut poses = PoseBatch::zeros(POSES);
    let mut jacobian = Jacobian::zeros(6);
    let mut contenders = [
        Contender::new("six libm sincos alone", POSES, || {
            inputs.iter().for_each(|q| {
                black_box(black_box(q).map(f64::sin_cos));
            });
        }),
        Contender::new("naive DH product", POSES, || inputs.iter().for_each(|q| { black_box(naive(black_box(q))); })),
        Contender::new("k 0.32", POSES, || {
            inputs.iter().for_each(|q| {
                k.set_joint_positions_unchecked(black_box(q));
                black_box(k.end_transform());
            });
        }),
        Contender::new("rs-opw-kinematics 3.0", POSES, || {
            inputs.iter().for_each(|q| { black_box(opw.forward(black_box(q))); });
        }),
        Contender::new("pieper, one pose", POSES, || {
            inputs.iter().for_each(|q| { black_box(kinematics::tool_pose(&chain, black_box(q)).unwrap()); });
        }),
        Contender::new("pieper, pose and Jacobian", POSES, || {
            inputs.iter().for_each(|q| {
                let pose = kinematics::pose_and_jacobian(&chain, black_box(q), Reference::Base, &mut jacobian);
                black_box((pose.unwrap(), &jacobian));
            });
        }),
        Contender::new("pieper, batch", POSES, || {
            batch::tool_poses(&chain, black_box(&many), &mut poses).unwrap();
            black_box(&poses);
        }),
    ];
    let times = race(&mut contenders, ROUNDS);
    print(&format!("Forward kinematics of the AR3, {POSES} random poses, one thread"), &times, "rs-opw-kinematics 3.0");
}

/// The product of six 4x4 matrices written out from the table.
fn naive(q: &[f64; 6]) -> Matrix4<f64> {
    let rows = [
        (FRAC_PI_2 + q[0], 0.164, 0.079, FRAC_PI_2),
        (q[1], 0.0, 0.305, 0.0),
        (FRAC_PI_2 - q[2], 0.0, 0.0, FRAC_PI_2),
        (q[3], 0.222, 0.0, -FRAC_PI_2),
        (-q[4], 0.0, 0.0, FRAC_PI_2),
        (FRAC_PI_2 + q[5], 0.0777, 0.0, FRAC_PI_2),
    ];
    rows.iter().fold(Matrix4::identity(), |pose, &(theta, d, a, alpha)| {
        let ((st, ct), (sa, ca)) = (theta.sin_cos(), alpha.sin_cos());
        pose * Matrix4::new(
            ct, -st * ca, st * sa, a * ct, //
            st, ct * ca, -ct * sa, a * st, //
            0.0, sa, ca, d, //
            0.0, 0.0, 0.0, 1.0,
        )
    })
}

/// The same table for `k`: a row is a turn about z and a fixed joint.
fn k_chain() -> k::SerialChain<f64> {
    // k has a nalgebra of its own, of another version.
    use k::nalgebra::{Unit, Vector3};
    use k::{Isometry3, JointType, Node, NodeBuilder, Translation3, UnitQuaternion, connect};
    let rows = [
        (FRAC_PI_2, 1.0, 0.164, 0.079, FRAC_PI_2),
        (0.0, 1.0, 0.0, 0.305, 0.0),
        (FRAC_PI_2, -1.0, 0.0, 0.0, FRAC_PI_2),
        (0.0, 1.0, 0.222, 0.0, -FRAC_PI_2),
        (0.0, -1.0, 0.0, 0.0, FRAC_PI_2),
        (FRAC_PI_2, 1.0, 0.0777, 0.0, FRAC_PI_2),
    ];
    let mut nodes: Vec<Node<f64>> = Vec::new();
    let mut link = Isometry3::identity();
    let mut push = |node: Node<f64>| {
        if let Some(last) = nodes.last() {
            connect!(last => node);
        }
        nodes.push(node);
    };
    for (index, (offset, sign, d, a, alpha)) in rows.into_iter().enumerate() {
        // The row's own offset joins the link before it, which keeps k at one node a joint.
        let origin = link * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), offset);
        let axis = Unit::new_normalize(Vector3::z() * sign);
        push(
            NodeBuilder::new()
                .name(&format!("q{}", index + 1))
                .joint_type(JointType::Rotational { axis })
                .translation(origin.translation)
                .rotation(origin.rotation)
                .into_node(),
        );
        link = Isometry3::from_parts(
            Translation3::new(a, 0.0, d),
            UnitQuaternion::from_axis_angle(&Vector3::x_axis(), alpha),
        );
    }
    push(
        NodeBuilder::new()
            .name("tool")
            .joint_type(JointType::Fixed)
            .translation(link.translation)
            .rotation(link.rotation)
            .into_node(),
    );
    k::SerialChain::from_end(nodes.last().expect("seven nodes"))
}
