//! What an arm looks like.

mod bars;
mod described;
mod procedural;

pub use bars::Bars;

use std::sync::Arc;

use nalgebra::Isometry3;

use crate::Mesh;

/// Red, green, blue, opacity; 0 to 1, as screens show them (sRGB).
pub type Color = [f32; 4];

/// Housings and limbs of a body made from a table.
pub const SHELL: Color = [0.87, 0.88, 0.90, 1.0];
/// What turns or slides in them.
pub const DARK: Color = [0.20, 0.22, 0.26, 1.0];
/// The mark that tells the tool.
pub const ACCENT: Color = [0.96, 0.47, 0.13, 1.0];
/// What stands in for a mesh that could not be had.
pub const PLACEHOLDER: Color = [0.80, 0.62, 0.25, 0.6];

/// A mesh on a link.
#[derive(Clone, Debug)]
pub struct Part {
    /// What it is, for whoever looks for it.
    pub name: String,
    /// The triangles.
    pub mesh: Arc<Mesh>,
    /// One colour.
    pub color: Color,
    /// From the link's frame to the mesh's.
    pub placed: Isometry3<f64>,
    /// Whether it is for collision rather than for looks.
    pub collision: bool,
}

/// The parts of every link, in the order of the frames they hang on.
#[derive(Clone, Debug, Default)]
pub struct Body {
    /// One list for each frame.
    pub links: Vec<Vec<Part>>,
    /// What could not be shown as described: one sentence each.
    pub problems: Vec<String>,
}

impl Body {
    /// The number of triangles, those for collision left out.
    pub fn triangles(&self) -> usize {
        self.shown().map(|(_, part)| part.mesh.triangles()).sum()
    }

    /// The parts for looks, with the index of their link.
    pub fn shown(&self) -> impl Iterator<Item = (usize, &Part)> {
        let of_link = |(link, parts)| std::iter::repeat(link).zip::<&Vec<Part>>(parts);
        self.links
            .iter()
            .enumerate()
            .flat_map(of_link)
            .filter(|(_, part)| !part.collision)
    }

    /// Whether nothing of it is more than a block that stands in for something.
    pub fn is_bare(&self) -> bool {
        self.shown().all(|(_, part)| part.color == PLACEHOLDER)
    }

    /// The same body with one part for each link and colour: what is drawn in one go.
    fn merged(mut self) -> Self {
        for parts in &mut self.links {
            let mut merged: Vec<(Color, bool, Mesh, String)> = Vec::new();
            for part in parts.iter() {
                let found = merged
                    .iter()
                    .position(|m| m.0 == part.color && m.1 == part.collision);
                let index = found.unwrap_or_else(|| {
                    merged.push((
                        part.color,
                        part.collision,
                        Mesh::default(),
                        part.name.clone(),
                    ));
                    merged.len() - 1
                });
                merged[index].2.append(&part.mesh, &part.placed);
            }
            let part = |(color, collision, mesh, name)| Part {
                name,
                mesh: Arc::new(mesh),
                color,
                placed: Isometry3::identity(),
                collision,
            };
            *parts = merged.into_iter().map(part).collect();
        }
        self
    }
}
