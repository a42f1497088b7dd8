//! `<visual>` and `<collision>`.

use super::value::{numbers, origin, size};
use super::xml::Element;
use crate::error::Result;
use crate::model::{Geometry, Shape};

/// The shapes of a link, in the order written. What has no geometry we know is left out.
pub(super) fn shapes(link: &Element) -> Result<Vec<Shape>> {
    let mut shapes = Vec::new();
    for element in link.elements() {
        let collision = match element.name.as_str() {
            "visual" => false,
            "collision" => true,
            _ => continue,
        };
        let solid = element.child("geometry").and_then(|g| g.elements().next());
        let Some(geometry) = solid.map(geometry).transpose()?.flatten() else {
            continue;
        };
        shapes.push(Shape {
            origin: origin(element)?,
            geometry,
            collision,
        });
    }
    Ok(shapes)
}

fn geometry(solid: &Element) -> Result<Option<Geometry>> {
    let geometry = match solid.name.as_str() {
        "mesh" => Geometry::Mesh {
            uri: solid.required("filename")?.value.trim().to_owned(),
            scale: solid.attribute("scale").map_or(Ok([1.0; 3]), numbers)?,
        },
        "box" => Geometry::Box {
            size: numbers(solid.required("size")?)?,
        },
        "cylinder" => Geometry::Cylinder {
            radius: size(solid, "radius")?,
            length: size(solid, "length")?,
        },
        "sphere" => Geometry::Sphere {
            radius: size(solid, "radius")?,
        },
        _ => return Ok(None),
    };
    Ok(Some(geometry))
}
