//! Collada: geometries, the nodes that place them, plain colours of their materials.
//!
//! As everywhere robots are described, the file's up axis is not turned: URDFs are written for readers that leave it as it is.

use std::collections::HashMap;

use nalgebra::{Matrix4, Point3, Rotation3, Unit, Vector3};
use roxmltree::{Document, Node, ParsingOptions};

use super::{Gathered, Loose};
use crate::body::Color;

/// Nodes inside nodes, at most: deeper is no arm, and a cycle has no end.
const DEEPEST: usize = 64;

pub(super) fn read(bytes: &[u8]) -> Result<Loose, String> {
    let text = std::str::from_utf8(bytes).map_err(|_| "it is not text in UTF-8".to_owned())?;
    // No document type: no entities of its own making.
    let options = ParsingOptions {
        allow_dtd: false,
        ..ParsingOptions::default()
    };
    let document =
        Document::parse_with_options(text, options).map_err(|error| error.to_string())?;
    let file = File::new(&document);
    let unit = file
        .root
        .descendants()
        .find(|node| node.has_tag_name_local("unit"));
    let metres: f64 = unit
        .and_then(|unit| unit.attribute("meter"))
        .and_then(|text| text.parse().ok())
        .unwrap_or(1.0);
    let scale = Matrix4::new_scaling(metres);
    let mut out = Gathered::default();
    let scenes: Vec<Node<'_, '_>> = file
        .root
        .descendants()
        .filter(|node| node.has_tag_name_local("visual_scene"))
        .collect();
    if scenes.is_empty() {
        for geometry in file
            .root
            .descendants()
            .filter(|node| node.has_tag_name_local("geometry"))
        {
            file.geometry(geometry, &scale, &HashMap::new(), &mut out)?;
        }
    }
    for scene in scenes {
        file.nodes(scene, &scale, DEEPEST, &mut out)?;
    }
    Ok(out.pieces)
}

/// Names without their namespaces.
trait Local {
    fn has_tag_name_local(&self, name: &str) -> bool;
}

impl Local for Node<'_, '_> {
    fn has_tag_name_local(&self, name: &str) -> bool {
        self.is_element() && self.tag_name().name() == name
    }
}

struct File<'a> {
    root: Node<'a, 'a>,
    by_id: HashMap<&'a str, Node<'a, 'a>>,
}

impl<'a> File<'a> {
    fn new(document: &'a Document<'a>) -> Self {
        let root = document.root_element();
        let by_id = root
            .descendants()
            .filter_map(|node| Some((node.attribute("id")?, node)))
            .collect();
        Self { root, by_id }
    }

    /// What `#name` refers to.
    fn refer(&self, reference: Option<&str>) -> Option<Node<'a, 'a>> {
        self.by_id.get(reference?.strip_prefix('#')?).copied()
    }

    fn child(node: Node<'a, 'a>, name: &str) -> Option<Node<'a, 'a>> {
        node.children().find(|child| child.has_tag_name_local(name))
    }

    fn nodes(
        &self,
        parent: Node<'a, 'a>,
        above: &Matrix4<f64>,
        depth: usize,
        out: &mut Gathered,
    ) -> Result<(), String> {
        let depth = depth
            .checked_sub(1)
            .ok_or("its nodes are nested too deeply, or in a circle")?;
        for node in parent.children() {
            if node.has_tag_name_local("node") {
                self.node(node, above, depth, out)?;
            }
        }
        Ok(())
    }

    fn node(
        &self,
        node: Node<'a, 'a>,
        above: &Matrix4<f64>,
        depth: usize,
        out: &mut Gathered,
    ) -> Result<(), String> {
        out.enter()?;
        let mut place = *above;
        for step in node.children() {
            place *= transform(step)?;
        }
        for child in node.children() {
            if child.has_tag_name_local("instance_geometry") {
                if let Some(geometry) = self.refer(child.attribute("url")) {
                    let bound = child
                        .descendants()
                        .filter(|node| node.has_tag_name_local("instance_material"));
                    let colors = bound
                        .filter_map(|bind| {
                            Some((
                                bind.attribute("symbol")?,
                                self.color(bind.attribute("target"))?,
                            ))
                        })
                        .collect();
                    self.geometry(geometry, &place, &colors, out)?;
                }
            } else if child.has_tag_name_local("instance_node")
                && let Some(other) = self.refer(child.attribute("url"))
            {
                let depth = depth
                    .checked_sub(1)
                    .ok_or("its nodes are nested too deeply, or in a circle")?;
                self.node(other, &place, depth, out)?;
            }
        }
        self.nodes(node, &place, depth, out)
    }

    /// The diffuse colour of a material.
    fn color(&self, material: Option<&str>) -> Option<Color> {
        let material = self.refer(material)?;
        let effect = self.refer(Self::child(material, "instance_effect")?.attribute("url"))?;
        let diffuse = effect
            .descendants()
            .find(|node| node.has_tag_name_local("diffuse"))?;
        let values = numbers(Self::child(diffuse, "color")?).ok()?;
        let part = |k: usize| {
            values
                .get(k)
                .map_or(1.0, |value| value.clamp(0.0, 1.0) as f32)
        };
        (values.len() >= 3).then(|| [part(0), part(1), part(2), part(3)])
    }

    fn geometry(
        &self,
        geometry: Node<'a, 'a>,
        place: &Matrix4<f64>,
        colors: &HashMap<&str, Color>,
        out: &mut Gathered,
    ) -> Result<(), String> {
        let Some(mesh) = Self::child(geometry, "mesh") else {
            return Ok(());
        };
        let mirrored = place.fixed_view::<3, 3>(0, 0).determinant() < 0.0;
        let mut sources: HashMap<&str, Vec<[f64; 3]>> = HashMap::new();
        for primitive in mesh.children() {
            let kind = primitive.tag_name().name();
            if !matches!(kind, "triangles" | "polylist" | "polygons") {
                continue;
            }
            let line = || {
                format!(
                    "line {}",
                    primitive
                        .document()
                        .text_pos_at(primitive.range().start)
                        .row
                )
            };
            let (corners, offset, stride) = self
                .inputs(primitive)
                .ok_or_else(|| format!("{}: {kind} without positions", line()))?;
            let key = corners.attribute("id").unwrap_or_default();
            if !sources.contains_key(key) {
                sources.insert(key, positions(corners)?);
            }
            let points = &sources[key];
            let mut triangles = Vec::new();
            for face in faces(primitive, kind, stride)? {
                let place_of = |index: &usize| -> Result<[f64; 3], String> {
                    let p = points.get(*index).ok_or_else(|| {
                        format!(
                            "{}: corner {index} is not there, there are {}",
                            line(),
                            points.len()
                        )
                    })?;
                    Ok(place.transform_point(&Point3::from(*p)).coords.into())
                };
                let face: Vec<[f64; 3]> = face
                    .iter()
                    .skip(offset)
                    .step_by(stride)
                    .map(place_of)
                    .collect::<Result<_, _>>()?;
                for k in 1..face.len().saturating_sub(1) {
                    let (b, c) = if mirrored {
                        (face[k + 1], face[k])
                    } else {
                        (face[k], face[k + 1])
                    };
                    triangles.push([face[0], b, c]);
                }
            }
            let color = primitive
                .attribute("material")
                .and_then(|symbol| colors.get(symbol))
                .copied();
            out.add(triangles, color)?;
        }
        Ok(())
    }

    /// The source of a primitive's positions, the place of their indices, and how many indices a corner has.
    fn inputs(&self, primitive: Node<'a, 'a>) -> Option<(Node<'a, 'a>, usize, usize)> {
        let inputs: Vec<Node<'_, '_>> = primitive
            .children()
            .filter(|node| node.has_tag_name_local("input"))
            .collect();
        let offset = |input: &Node<'_, '_>| {
            input
                .attribute("offset")
                .and_then(|text| text.parse::<usize>().ok())
                .unwrap_or(0)
        };
        let stride = inputs
            .iter()
            .map(offset)
            .max()?
            .checked_add(1)
            .filter(|stride| *stride <= 64)?;
        let vertex = inputs
            .iter()
            .find(|input| input.attribute("semantic") == Some("VERTEX"))?;
        let vertices = self.refer(vertex.attribute("source"))?;
        let position = vertices
            .children()
            .find(|input| input.attribute("semantic") == Some("POSITION"))?;
        Some((
            self.refer(position.attribute("source"))?,
            offset(vertex),
            stride,
        ))
    }
}

/// The points of a source.
fn positions(source: Node<'_, '_>) -> Result<Vec<[f64; 3]>, String> {
    let array = source
        .children()
        .find(|node| node.has_tag_name_local("float_array"))
        .ok_or("a source without numbers")?;
    let accessor = source
        .descendants()
        .find(|node| node.has_tag_name_local("accessor"));
    let stride = accessor
        .and_then(|accessor| accessor.attribute("stride"))
        .and_then(|text| text.parse().ok())
        .unwrap_or(3);
    let values = numbers(array)?;
    if !(3..=64).contains(&stride) {
        return Err(format!(
            "a source of positions with {stride} numbers each: three were expected"
        ));
    }
    Ok(values
        .chunks_exact(stride)
        .map(|p| [p[0], p[1], p[2]])
        .collect())
}

/// The indices of each face, all its inputs in turn.
fn faces(primitive: Node<'_, '_>, kind: &str, stride: usize) -> Result<Vec<Vec<usize>>, String> {
    let lists = primitive
        .children()
        .filter(|node| node.has_tag_name_local("p"))
        .map(indices)
        .collect::<Result<Vec<_>, _>>()?;
    match kind {
        "polygons" => Ok(lists),
        "triangles" => Ok(lists
            .iter()
            .flat_map(|list| list.chunks_exact(3 * stride))
            .map(<[usize]>::to_vec)
            .collect()),
        _ => {
            let counts = primitive
                .children()
                .find(|node| node.has_tag_name_local("vcount"));
            let counts = indices(counts.ok_or("a polylist without vcount")?)?;
            let all: Vec<usize> = lists.concat();
            let mut rest = all.as_slice();
            let mut out = Vec::with_capacity(counts.len());
            for count in counts {
                let length = count
                    .checked_mul(stride)
                    .filter(|length| *length <= rest.len());
                let (face, behind) = rest
                    .split_at(length.ok_or("a polylist has fewer corners than its vcount says")?);
                out.push(face.to_vec());
                rest = behind;
            }
            Ok(out)
        }
    }
}

/// The motion that an element of a node stands for; the identity for another.
fn transform(node: Node<'_, '_>) -> Result<Matrix4<f64>, String> {
    let wanted = match node.tag_name().name() {
        "matrix" => 16,
        "translate" | "scale" => 3,
        "rotate" => 4,
        _ => return Ok(Matrix4::identity()),
    };
    let values = numbers(node)?;
    if values.len() != wanted {
        let name = node.tag_name().name();
        return Err(format!(
            "{name}: {wanted} numbers were expected, {} are there",
            values.len()
        ));
    }
    let vector = || Vector3::new(values[0], values[1], values[2]);
    Ok(match node.tag_name().name() {
        "matrix" => Matrix4::from_row_slice(&values),
        "translate" => Matrix4::new_translation(&vector()),
        "scale" => Matrix4::new_nonuniform_scaling(&vector()),
        _ => match Unit::try_new(vector(), 1e-12) {
            Some(axis) => {
                Rotation3::from_axis_angle(&axis, values[3].to_radians()).to_homogeneous()
            }
            None => Matrix4::identity(),
        },
    })
}

fn numbers(node: Node<'_, '_>) -> Result<Vec<f64>, String> {
    words(node, "a number")
}

fn indices(node: Node<'_, '_>) -> Result<Vec<usize>, String> {
    words(node, "an index")
}

fn words<T: std::str::FromStr>(node: Node<'_, '_>, what: &str) -> Result<Vec<T>, String> {
    let text = node.text().unwrap_or_default();
    let read = |word: &str| {
        word.parse().map_err(|_| {
            let line = node.document().text_pos_at(node.range().start).row;
            format!(
                "line {line}: <{}>: \"{word}\": {what} was expected",
                node.tag_name().name()
            )
        })
    };
    text.split_whitespace().map(read).collect()
}
