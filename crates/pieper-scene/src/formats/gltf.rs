//! glTF and GLB: the default scene's meshes with their base colours; buffers inside the file.

use base64::Engine as _;
use gltf::accessor::{DataType, Dimensions};
use gltf::json::validation::Checked;
use gltf::mesh::{Mode, Semantic};
use gltf::{Accessor, Document, Gltf, Node, Primitive};
use nalgebra::{Matrix4, Point3};

use super::{Gathered, Loose};

/// Nodes inside nodes, at most.
const DEEPEST: usize = 64;

pub(super) fn read(bytes: &[u8]) -> Result<Loose, String> {
    let Gltf { document, blob } =
        Gltf::from_slice_without_validation(bytes).map_err(|error| error.to_string())?;
    let json = document.into_json();
    positions_are_there(&json)?;
    let document = Document::from_json(json).map_err(|error| error.to_string())?;
    accessors_are_inside(&document)?;
    let mut buffers = Vec::new();
    for buffer in document.buffers() {
        let data = match buffer.source() {
            gltf::buffer::Source::Bin => blob
                .clone()
                .ok_or("it names a binary part that it does not have")?,
            gltf::buffer::Source::Uri(uri) => {
                let data = uri
                    .split_once(";base64,")
                    .filter(|(head, _)| head.starts_with("data:"));
                let (_, data) = data.ok_or_else(|| format!("its buffer {uri} lies outside the file: a .glb, or buffers inside, were expected"))?;
                base64::engine::general_purpose::STANDARD
                    .decode(data)
                    .map_err(|error| format!("a buffer: {error}"))?
            }
        };
        if data.len() < buffer.length() {
            return Err(format!(
                "a buffer has {} bytes, {} were announced",
                data.len(),
                buffer.length()
            ));
        }
        buffers.push(data);
    }
    let scene = document
        .default_scene()
        .or_else(|| document.scenes().next())
        .ok_or("it has no scene")?;
    let mut out = Gathered::default();
    for node in scene.nodes() {
        visit(&node, &Matrix4::identity(), DEEPEST, &buffers, &mut out)?;
    }
    Ok(out.pieces)
}

/// The crate's own check looks up the positions' accessor before it knows that there is one, and panics.
fn positions_are_there(json: &gltf::json::Root) -> Result<(), String> {
    let primitives = json.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let positions =
        primitives.filter_map(|p| p.attributes.get(&Checked::Valid(Semantic::Positions)));
    let count = json.accessors.len();
    match positions.map(|index| index.value()).find(|i| *i >= count) {
        None => Ok(()),
        Some(index) => Err(format!(
            "a mesh's positions are accessor {index}, there are {count}"
        )),
    }
}

/// What is read lies within what is there: the crate's reader takes it for granted.
fn accessors_are_inside(document: &Document) -> Result<(), String> {
    for view in document.views() {
        let end = view.offset().checked_add(view.length());
        if end.is_none_or(|end| end > view.buffer().length()) {
            return Err(format!(
                "view {} reaches past the end of its buffer",
                view.index()
            ));
        }
    }
    for accessor in document.accessors() {
        let index = accessor.index();
        if accessor.count() == 0 {
            return Err(format!("accessor {index} is empty"));
        }
        if accessor.sparse().is_some() {
            return Err(format!("accessor {index} is sparse, which is not read"));
        }
        let Some(view) = accessor.view() else {
            continue;
        };
        let stride = view.stride().unwrap_or(accessor.size());
        if stride < accessor.size() {
            return Err(format!("accessor {index}'s numbers overlap in their view"));
        }
        let gaps = (accessor.count() - 1).checked_mul(stride);
        let size = gaps.and_then(|gaps| gaps.checked_add(accessor.size()));
        let end = size.and_then(|size| size.checked_add(accessor.offset()));
        if end.is_none_or(|end| end > view.length()) {
            return Err(format!("accessor {index} reaches past the end of its view"));
        }
    }
    Ok(())
}

fn visit(
    node: &Node<'_>,
    above: &Matrix4<f64>,
    depth: usize,
    buffers: &[Vec<u8>],
    out: &mut Gathered,
) -> Result<(), String> {
    let depth = depth
        .checked_sub(1)
        .ok_or("its nodes are nested too deeply")?;
    out.enter()?;
    let columns = node.transform().matrix();
    let own = Matrix4::from_fn(|i, j| f64::from(columns[j][i]));
    let place = above * own;
    for primitive in node.mesh().iter().flat_map(gltf::Mesh::primitives) {
        let color = primitive
            .material()
            .pbr_metallic_roughness()
            .base_color_factor();
        out.add(triangles(&primitive, &place, buffers)?, Some(screen(color)))?;
    }
    for child in node.children() {
        visit(&child, &place, depth, buffers, out)?;
    }
    Ok(())
}

fn triangles(
    primitive: &Primitive<'_>,
    place: &Matrix4<f64>,
    buffers: &[Vec<u8>],
) -> Result<Vec<[[f64; 3]; 3]>, String> {
    if primitive.mode() != Mode::Triangles {
        // Points and lines are no surface; strips and fans are hardly ever written.
        return Ok(Vec::new());
    }
    let is = |accessor: &Accessor<'_>, of: &[DataType], shape: Dimensions| {
        of.contains(&accessor.data_type()) && accessor.dimensions() == shape
    };
    // Other types the crate's reader takes for a mistake of its own, and panics.
    let positions = primitive.get(&Semantic::Positions);
    if !positions.is_some_and(|a| is(&a, &[DataType::F32], Dimensions::Vec3)) {
        return Err("positions of three 32-bit numbers were expected".to_owned());
    }
    let whole = [DataType::U8, DataType::U16, DataType::U32];
    if primitive
        .indices()
        .is_some_and(|a| !is(&a, &whole, Dimensions::Scalar))
    {
        return Err("indices that are unsigned whole numbers were expected".to_owned());
    }
    let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
    let positions = reader.read_positions().ok_or("a mesh without positions")?;
    let points: Vec<[f64; 3]> = positions
        .map(|p| {
            place
                .transform_point(&Point3::from(p.map(f64::from)))
                .coords
                .into()
        })
        .collect();
    let indices: Vec<usize> = match reader.read_indices() {
        Some(indices) => indices.into_u32().map(|index| index as usize).collect(),
        None => (0..points.len()).collect(),
    };
    let point = |index: &usize| {
        points
            .get(*index)
            .copied()
            .ok_or_else(|| format!("corner {index} is not there, there are {}", points.len()))
    };
    let mirrored = place.fixed_view::<3, 3>(0, 0).determinant() < 0.0;
    let triangle = |t: &[usize; 3]| {
        let [a, b, c] = [point(&t[0])?, point(&t[1])?, point(&t[2])?];
        Ok(if mirrored { [a, c, b] } else { [a, b, c] })
    };
    indices.as_chunks::<3>().0.iter().map(triangle).collect()
}

/// A linear colour as screens show it.
fn screen([r, g, b, opacity]: [f32; 4]) -> [f32; 4] {
    let curve = |x: f32| {
        if x <= 0.003_130_8 {
            12.92 * x
        } else {
            1.055 * x.powf(1.0 / 2.4) - 0.055
        }
    };
    [curve(r), curve(g), curve(b), opacity]
}
