//! Mesh files: STL, OBJ, Collada, glTF.

mod dae;
mod gltf;
mod obj;
mod stl;

use crate::body::Color;
use crate::{Mesh, mesh};

/// Edges of read meshes that bend by more are drawn sharp.
pub(crate) const CREASE: f64 = 0.5;

/// A mesh of one colour out of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// In metres, as far as the file says what its unit is.
    pub mesh: Mesh,
    /// The colour, if the file names one.
    pub color: Option<Color>,
}

/// Triangles of one colour, still loose.
type Loose = Vec<(Vec<[[f64; 3]; 3]>, Option<Color>)>;

/// Reads a mesh file by its ending, or by its beginning where the ending says nothing.
///
/// # Errors
/// A sentence: an unknown format, what is wrong and where, a mesh without triangles or with too many.
pub fn read(name: &str, bytes: &[u8]) -> Result<Vec<Piece>, String> {
    let ending = name
        .rsplit('.')
        .next()
        .unwrap_or_default()
        .to_ascii_lowercase();
    let loose = match ending.as_str() {
        "stl" => stl::read(bytes)?,
        "obj" => obj::read(bytes)?,
        "dae" => dae::read(bytes)?,
        "gltf" | "glb" => gltf::read(bytes)?,
        _ => {
            return Err(format!(
                "files that end in .{ending} are not read: .stl, .obj, .dae, .gltf or .glb was expected"
            ));
        }
    };
    let count: usize = loose.iter().map(|(triangles, _)| triangles.len()).sum();
    if count > mesh::MOST_TRIANGLES {
        return Err(format!(
            "it has {count} triangles, at most {} are taken",
            mesh::MOST_TRIANGLES
        ));
    }
    let pieces: Vec<Piece> = loose
        .into_iter()
        .map(|(triangles, color)| Piece {
            mesh: Mesh::of_triangles(&triangles, CREASE),
            color,
        })
        .filter(|piece| piece.mesh.triangles() > 0)
        .collect();
    if pieces.is_empty() {
        return Err("it has no triangles".to_owned());
    }
    Ok(pieces)
}
