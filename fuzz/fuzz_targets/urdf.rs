//! Any text: reading it never panics, and what reads can be written and read again as the same tree.

#![no_main]

use libfuzzer_sys::fuzz_target;
use pieper::describe::urdf;

fuzz_target!(|text: &str| {
    let tree = match urdf::read("f.urdf", text) {
        Ok(tree) => tree,
        Err(error) => {
            assert!(error.place().is_some(), "{error}");
            return;
        }
    };
    let written = urdf::write(&tree);
    let again = urdf::read("again.urdf", &written).unwrap_or_else(|e| panic!("{e}\n{written}"));
    assert_eq!(again.joints().len(), tree.joints().len());
    let names = |tree: &pieper::model::Tree| {
        let links = tree.links().iter().map(|link| link.name.clone());
        links.collect::<Vec<_>>()
    };
    assert_eq!(names(&tree), names(&again));
    let q = vec![0.5; tree.variables().len()];
    let (poses, poses_again) = (tree.link_poses(&q).unwrap(), again.link_poses(&q).unwrap());
    for (a, b) in poses.iter().zip(&poses_again) {
        let off = (a.rotation.matrix() - b.rotation.matrix()).amax();
        // Rounding of each rotation, along the longest chain.
        assert!(off.is_nan() || off < 1e-14 * poses.len() as f64, "{off:e}\n{written}");
    }
    if let Ok(chain) = tree.chain(tree.root(), tree.default_tip()) {
        let text = urdf::write_chain(tree.name(), &chain);
        urdf::read("chain.urdf", &text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    }
});
