//! SVG to PNG.

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use crate::error::{Error, Result};

/// Draws an outlined SVG at `scale` pixels per unit.
pub(crate) fn render(svg: &str, scale: f64) -> Result<Vec<u8>> {
    if !(scale > 0.0 && scale <= 16.0) {
        return Err(Error::input(
            "scale",
            format!("a number above 0, at most 16, was expected, {scale} was given"),
        ));
    }
    let tree = Tree::from_str(svg, &Options::default())
        .map_err(|error| Error::render(error.to_string()))?;
    let scale = scale as f32;
    let size = tree.size();
    let [width, height] = [size.width(), size.height()].map(|side| (side * scale).round() as u32);
    let mut pixels = Pixmap::new(width, height)
        .ok_or_else(|| Error::render(format!("no bitmap of {width} x {height} pixels")))?;
    // Sides that are no whole number of pixels would leave a half-covered edge.
    pixels.fill(Color::WHITE);
    resvg::render(
        &tree,
        Transform::from_scale(scale, scale),
        &mut pixels.as_mut(),
    );
    pixels
        .encode_png()
        .map_err(|error| Error::render(error.to_string()))
}
