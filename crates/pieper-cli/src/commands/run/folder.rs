//! The folder a run writes to.

use std::fs;
use std::path::{Path, PathBuf};

use pieper_plot::Theme;

use super::figures::Drawing;
use crate::error::Failure;

/// Pixels per unit of a figure: sharp on screens and in print.
const SCALE: f64 = 2.0;

pub(super) struct Folder {
    path: PathBuf,
    written: Vec<String>,
}

impl Folder {
    /// The folder, made if it was not there.
    pub(super) fn make(path: &Path) -> Result<Self, Failure> {
        if path.exists() && !path.is_dir() {
            let name = path.display();
            return Err(Failure::input(format!(
                "{name}: a folder to write to was expected, this is a file"
            )));
        }
        fs::create_dir_all(path).map_err(|error| Failure::file("made", path.display(), &error))?;
        Ok(Self {
            path: path.to_owned(),
            written: Vec::new(),
        })
    }

    /// Writes a file, over one of that name.
    pub(super) fn write(&mut self, name: &str, content: impl AsRef<[u8]>) -> Result<(), Failure> {
        let path = self.path.join(name);
        fs::write(&path, content)
            .map_err(|error| Failure::file("written", path.display(), &error))?;
        self.written.push(name.to_owned());
        Ok(())
    }

    /// Writes a figure as SVG and as PNG.
    pub(super) fn write_figure(&mut self, drawing: &Drawing) -> Result<(), Failure> {
        let Drawing { name, figure, .. } = drawing;
        let png = figure
            .to_png(SCALE)
            .map_err(|error| Failure::World(format!("{name}.png: {error}")))?;
        self.write(&format!("{name}.svg"), figure.to_svg(Theme::Standalone))?;
        self.write(&format!("{name}.png"), png)
    }

    /// The names of the files written.
    pub(super) fn written(self) -> Vec<String> {
        self.written
    }
}
