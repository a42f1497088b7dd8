//! The shapes of links, as far as a description names them.

use crate::spatial::Pose;

/// What a link looks like, or what it collides with.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// From the link's frame to the shape's.
    pub origin: Pose,
    /// The shape itself.
    pub geometry: Geometry,
    /// Whether the shape is for collision rather than for looks.
    pub collision: bool,
}

/// A shape around its own frame. Lengths in metres.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// A mesh, kept as written: the library reads no files.
    Mesh {
        /// What the description says: `package://...`, a path, or a URL.
        uri: String,
        /// Scale along x, y, z.
        scale: [f64; 3],
    },
    /// A box, its centre at the origin.
    Box {
        /// Edge lengths along x, y, z.
        size: [f64; 3],
    },
    /// A cylinder along z, its centre at the origin.
    Cylinder {
        /// Its radius.
        radius: f64,
        /// Its length along z.
        length: f64,
    },
    /// A sphere about the origin.
    Sphere {
        /// Its radius.
        radius: f64,
    },
}
