//! A finished figure and the files it becomes.

use crate::error::Result;
use crate::png;
use crate::scene::Scene;
use crate::svg::{self, Mode};

/// The height of the band over a figure that holds its title; pages have captions instead.
const TITLE_BAND: f64 = 40.0;

/// Where an SVG will be looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Theme {
    /// A file of its own: with its title, on white paper, or on dark paper where the viewer asks
    /// for dark pictures.
    Standalone,
    /// Inside a page, whose CSS variables `--pp-*` give the colours (see [`crate::Report`]); without
    /// title and paper.
    Page,
}

/// A finished figure.
///
/// Made by [`crate::time_chart`], [`crate::path_views`] and [`crate::arm_views`].
#[derive(Clone, Debug)]
pub struct Figure {
    title: String,
    scene: Scene,
}

impl Figure {
    pub(crate) fn new(title: &str, scene: Scene) -> Self {
        Self {
            title: title.to_owned(),
            scene,
        }
    }

    /// The title, as given.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The width of the stand-alone figure in pixels at scale 1.
    pub fn width(&self) -> f64 {
        self.scene.width
    }

    /// The height of the stand-alone figure in pixels at scale 1, its title included.
    pub fn height(&self) -> f64 {
        self.scene.height + TITLE_BAND
    }

    /// The figure as SVG text; the same text for the same data, byte for byte.
    pub fn to_svg(&self, theme: Theme) -> String {
        match theme {
            Theme::Standalone => svg::write(&self.scene, &self.title, TITLE_BAND, Mode::Adaptive),
            Theme::Page => svg::write(&self.scene, &self.title, 0.0, Mode::Page),
        }
    }

    /// The stand-alone figure as PNG on white, `scale` pixels per unit (2 suits screens and print).
    ///
    /// An error if the scale is not above 0 and at most 16.
    pub fn to_png(&self, scale: f64) -> Result<Vec<u8>> {
        let svg = svg::write(&self.scene, &self.title, TITLE_BAND, Mode::Outlined);
        png::render(&svg, scale)
    }
}
