//! Paths of the tool to motions of the joints: known motions come back, branches end where the solver says so.

use std::f64::consts::{FRAC_PI_2, PI};

use pieper::describe::{MotionTable, MotionValues};
use pieper::ik::Solver;
use pieper::kinematics::tool_pose;
use pieper::model::Chain;
use pieper::motion::{End, Event, Law, PoseLaw, Profile, State, Track, TrackOptions, Tracks, track};
use pieper::spatial::{Pose, from_xyz_rpy};

fn arm(name: &str) -> Chain {
    pieper_robots::find(name).unwrap().robot().chain().unwrap()
}

fn tracks(chain: &Chain, law: &PoseLaw, options: &TrackOptions) -> Tracks {
    let solver = Solver::new(chain).unwrap();
    track(&solver, law, options, &mut |_| ()).unwrap()
}

fn dump(chain: &Chain, tracks: &Tracks) {
    eprintln!("solves {} best {:?} deviation {:?}", tracks.solves, tracks.best, tracks.deviation);
    for (k, t) in tracks.tracks.iter().enumerate() {
        let end = match &t.end {
            End::Alive => "alive".to_owned(),
            End::Dies { time, event } => format!("dies {time}: {}", event.sentence(chain)),
        };
        eprintln!("{k} {} {}..{} n {} rate {:.3} travel {:.3} stops {:?}: {end}", t.branch, t.from(), t.to(), t.rows.len(), t.rate, t.travel, t.stops);
    }
    eprintln!("legs {:?}\nswitches {:?}\ngaps {:?}", tracks.legs, tracks.switches, tracks.gaps);
}

/// A joint motion, and its poses at so many times a second.
fn programme() -> (Chain, Law) {
    let chain = arm("ar3");
    let text = include_str!("../../../../examples/ar3-programme.csv");
    let table = MotionTable::from_csv("ar3-programme.csv", text, &chain).unwrap();
    let MotionValues::Joints(rows) = table.values else { panic!() };
    (chain, Law::new(table.times, rows, Profile::Linear).unwrap())
}

fn poses(chain: &Chain, law: &Law, times: &[f64]) -> PoseLaw {
    let mut state = State::default();
    let rows = times.iter().map(|&t| {
        law.at(t, &mut state);
        tool_pose(chain, &state.position).unwrap()
    });
    PoseLaw::new(times.to_vec(), rows.collect(), Profile::Linear).unwrap()
}

#[test]
fn the_papers_programme_comes_back() {
    let (chain, law) = programme();
    let times = pieper::motion::sample_times(law.times(), 50.0).unwrap();
    let path = poses(&chain, &law, &times);
    let found = tracks(&chain, &path, &TrackOptions::default());
    dump(&chain, &found);
    let best = found.best().unwrap();
    let mut state = State::default();
    let mut worst = 0.0_f64;
    for &t in &times {
        law.at(t, &mut state);
        for (a, b) in best.at(t).iter().zip(&state.position) {
            worst = worst.max((a - b).abs());
        }
    }
    assert!(worst < 1e-9, "{worst:e}");
}

#[test]
fn explore_rows() {
    let (chain, law) = programme();
    let times = pieper::motion::sample_times(law.times(), 50.0).unwrap();
    let solver = Solver::new(&chain).unwrap();
    let mut state = State::default();
    for &t in times.iter().take(155).step_by(7) {
        law.at(t, &mut state);
        let found = solver.solve(&tool_pose(&chain, &state.position).unwrap()).unwrap();
        eprintln!("t {t} {:?}", found.status());
        for f in found.families() { eprintln!("   F {} {:?} free {:?} res {:.1e}", f.branch, f.q(), f.free(), f.residual); }
        for f in &found { eprintln!("   S {} {:?} m {} res {:.1e}", f.branch, f.q(), f.multiplicity, f.residual); }
    }
}

#[test]
fn explore() {
    for (name, from, to) in [
        ("irb120", [0.374, -0.2, 0.63, 0.0, FRAC_PI_2, 0.0], [0.374, 0.2, 0.63, 0.0, FRAC_PI_2, 0.0]),
        ("irb120", [0.3, 0.0, 0.4, 0.0, PI, 0.0], [0.7, 0.0, 0.4, 0.0, PI, 0.0]),
        ("ur5", [0.4, -0.3, 0.2, 0.0, PI, 0.0], [0.4, 0.3, 0.2, 0.0, PI, 0.0]),
        ("fanuc-crx10ia", [0.4, -0.3, 0.4, 0.0, PI, 0.0], [0.4, 0.3, 0.4, 0.0, PI, 0.0]),
        ("puma560", [0.4, -0.3, 0.2, 0.0, PI, 0.0], [0.4, 0.3, 0.2, 0.0, PI, 0.0]),
        ("iiwa7", [0.4, -0.3, 0.4, 0.0, PI, 0.0], [0.4, 0.3, 0.4, 0.0, PI, 0.0]),
    ] {
        let chain = arm(name);
        let pose = |v: [f64; 6]| from_xyz_rpy([v[0], v[1], v[2]], [v[3], v[4], v[5]]);
        let law = PoseLaw::new(vec![0.0, 2.0], vec![pose(from), pose(to)], Profile::Linear).unwrap();
        let started = std::time::Instant::now();
        let found = tracks(&chain, &law, &TrackOptions::default());
        eprintln!("=== {name} {:?}", started.elapsed());
        dump(&chain, &found);
    }
}
