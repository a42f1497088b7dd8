use std::hint::black_box;
fn main(){ let chain = pieper_robots::find("ar3").unwrap().robot().chain().unwrap();
 let mut random = fastrand::Rng::with_seed(1);
    let inputs: Vec<[f64; 6]> = (0..1024).map(|_| std::array::from_fn(|_| 3.0 * (2.0 * random.f64() - 1.0))).collect();
 for _ in 0..20000 { for q in &inputs { black_box(pieper::kinematics::tool_pose(&chain, black_box(q)).unwrap()); } } }
