//! A body from the shapes and meshes that a URDF names.

use std::collections::HashMap;
use std::sync::Arc;

use pieper::model::{Geometry, Shape, Tree};

use super::{Body, Color, DARK, PLACEHOLDER, Part, SHELL};
use crate::formats::{self, Piece};
use crate::frames::isometry;
use crate::{Mesh, shapes};

/// Where a mesh's bytes come from: its address as the description writes it (or, for what a mesh file names itself, that file's
/// address with the last part replaced), and back the bytes or a sentence why not.
pub(super) type Fetch<'a> = &'a dyn Fn(&str) -> Result<Vec<u8>, String>;

impl Body {
    /// The body that a tree describes, on [`Frames::Tree`](crate::Frames::Tree). `None` if it names no shapes at all.
    ///
    /// What cannot be had or read is named in [`Body::problems`] and shown as a block.
    pub fn of_tree(tree: &Tree, fetch: Fetch<'_>) -> Option<Self> {
        if tree
            .links()
            .iter()
            .all(|link| link.shapes.iter().all(|shape| shape.collision))
        {
            return None;
        }
        let mut body = Self::default();
        let mut known: HashMap<String, Result<Vec<Piece>, String>> = HashMap::new();
        for (index, link) in tree.links().iter().enumerate() {
            let color = if index % 2 == 0 { SHELL } else { DARK };
            let mut parts = Vec::new();
            for shape in &link.shapes {
                pieces(
                    shape,
                    &link.name,
                    color,
                    fetch,
                    &mut known,
                    &mut parts,
                    &mut body.problems,
                );
            }
            body.links.push(parts);
        }
        Some(body.merged())
    }
}

fn pieces(
    shape: &Shape,
    link: &str,
    color: Color,
    fetch: Fetch<'_>,
    known: &mut HashMap<String, Result<Vec<Piece>, String>>,
    parts: &mut Vec<Part>,
    problems: &mut Vec<String>,
) {
    let mut push = |mesh: Mesh, color: Color| {
        parts.push(Part {
            name: link.to_owned(),
            mesh: Arc::new(mesh),
            color,
            placed: isometry(&shape.origin),
            collision: shape.collision,
        });
    };
    match &shape.geometry {
        Geometry::Box { size } => push(shapes::block(*size, 0.0), color),
        Geometry::Cylinder { radius, length } => {
            push(shapes::cylinder(*radius, *length, 0.0), color)
        }
        Geometry::Sphere { radius } => push(shapes::sphere(*radius), color),
        Geometry::Mesh { uri, scale } => {
            let read = known
                .entry(uri.clone())
                .or_insert_with(|| fetch(uri).and_then(|bytes| formats::read(uri, &bytes)));
            match read {
                Ok(pieces) => {
                    for piece in pieces.iter() {
                        push(scaled(&piece.mesh, *scale), piece.color.unwrap_or(color));
                    }
                }
                Err(why) => {
                    let sentence =
                        format!("link {link}: mesh {uri}: {why}; a block stands in for it");
                    if !problems.contains(&sentence) {
                        problems.push(sentence);
                    }
                    push(shapes::block([PLACE; 3], 0.1 * PLACE), PLACEHOLDER);
                }
            }
        }
    }
}

/// The edge of a block that stands in for a mesh, metres.
const PLACE: f64 = 0.05;

/// The mesh stretched along its axes; turned inside out again where that mirrors it.
fn scaled(mesh: &Mesh, scale: [f64; 3]) -> Mesh {
    if scale == [1.0; 3] {
        return mesh.clone();
    }
    let mirrored = scale.iter().product::<f64>() < 0.0;
    let triangle = |t: usize| {
        let [a, b, c] = mesh
            .triangle(t)
            .map(|p| std::array::from_fn(|k| p[k] * scale[k]));
        if mirrored { [a, c, b] } else { [a, b, c] }
    };
    let triangles: Vec<[[f64; 3]; 3]> = (0..mesh.triangles()).map(triangle).collect();
    Mesh::of_triangles(&triangles, formats::CREASE)
}
