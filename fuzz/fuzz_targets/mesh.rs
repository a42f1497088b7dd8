//! Any bytes as a mesh file, the first telling the format: reading never panics, what reads is of finite triangles that refer to
//! corners that are there, comes back from its own bytes, and can be looked at by a ray.

#![no_main]

use std::sync::Arc;

use libfuzzer_sys::fuzz_target;
use nalgebra::{Isometry3, Point3, Vector3};
use pieper_scene::{Body, Mesh, Part, Picker, formats};

fuzz_target!(|bytes: &[u8]| {
    let Some((first, bytes)) = bytes.split_first() else {
        return;
    };
    let name = ["a.stl", "a.obj", "a.dae", "a.gltf", "a.glb"][usize::from(*first) % 5];
    let pieces = match formats::read(name, bytes) {
        Ok(pieces) => pieces,
        Err(words) => return assert!(!words.is_empty()),
    };
    let mut parts = Vec::new();
    for piece in pieces {
        let mesh = piece.mesh;
        assert_eq!(mesh.positions.len(), mesh.normals.len());
        assert!(mesh.indices.iter().all(|&index| (index as usize) < mesh.positions.len()));
        assert!(mesh.positions.iter().flatten().all(|x| x.is_finite()), "{name}");
        assert!(mesh.normals.iter().flatten().all(|x| x.is_finite()), "{name}");
        assert_eq!(Mesh::from_bytes(&mesh.to_bytes()).as_ref(), Some(&mesh));
        parts.push(Part {
            name: String::new(),
            mesh: Arc::new(mesh),
            color: pieper_scene::body::SHELL,
            placed: Isometry3::identity(),
            collision: false,
        });
    }
    let body = Body { links: vec![parts], problems: Vec::new() };
    let picker = Picker::new(&body);
    for direction in [Vector3::x(), -Vector3::z(), Vector3::new(0.3, -0.4, 0.5)] {
        let hit = picker.pick(&Point3::new(-0.2, 0.1, 0.3), &direction, &[Isometry3::identity()]);
        assert!(hit.is_none_or(|hit| hit.distance >= 0.0));
    }
});
