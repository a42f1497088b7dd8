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

/// What a file's tree of nodes shows. A node may stand in many places, and what is in it with it: a small file can ask for a picture
/// without end, so what is repeated counts each time.
#[derive(Default)]
struct Gathered {
    pieces: Loose,
    nodes: usize,
    triangles: usize,
}

impl Gathered {
    /// One more node.
    fn enter(&mut self) -> Result<(), String> {
        self.nodes += 1;
        match self.nodes <= MOST_NODES {
            true => Ok(()),
            false => Err(format!(
                "it shows more than {MOST_NODES} nodes, those counted each time that stand in several places"
            )),
        }
    }

    fn add(&mut self, triangles: Vec<[[f64; 3]; 3]>, color: Option<Color>) -> Result<(), String> {
        self.triangles += triangles.len();
        check_count(self.triangles)?;
        self.pieces.push((triangles, color));
        Ok(())
    }
}

const MOST_NODES: usize = 100_000;

fn check_count(triangles: usize) -> Result<(), String> {
    match triangles <= mesh::MOST_TRIANGLES {
        true => Ok(()),
        false => Err(format!(
            "it has {triangles} triangles or more, at most {} are taken",
            mesh::MOST_TRIANGLES
        )),
    }
}

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
    check_count(loose.iter().map(|(triangles, _)| triangles.len()).sum())?;
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
