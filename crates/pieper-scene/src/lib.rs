//! What an arm looks like and what a ray touches: everything a viewer shows, made without a viewer.
//!
//! An arm that is only a table gets a body from its geometry ([`Body::of_chain`]); one with a URDF gets the shapes and meshes
//! that it names ([`Body::of_tree`]). Either way a [`Body`] is a list of links with coloured [`Mesh`]es, moved by
//! [`Frames`], and touched by a [`Picker`].
//!
//! No files are read here: whoever has them hands in a function.

pub mod mesh;

pub mod shapes;

pub mod formats;

pub mod frames;

pub mod body;

pub mod pick;

pub mod outline;

pub use body::{Bars, Body, Color, Part};
pub use frames::Frames;
pub use mesh::Mesh;
pub use pick::{Hit, Picker};
