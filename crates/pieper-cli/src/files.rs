//! The files and packages that a description refers to, on this machine.

use std::path::{Path, PathBuf};

use pieper::describe::xacro::Resources;
use pieper::{Error, Result};

use crate::error::Failure;
use crate::source::read_text;

/// Files by path; packages by `--package`, by `ROS_PACKAGE_PATH`, or by a folder of their name above the description.
pub(crate) struct Files {
    packages: Vec<(String, String)>,
    /// The description's own folder and those above it.
    above: Vec<PathBuf>,
    ros_path: Vec<PathBuf>,
}

impl Files {
    /// The surroundings of the description at `path`, with packages given as NAME=FOLDER.
    pub(crate) fn new(path: &Path, packages: &[String]) -> std::result::Result<Self, Failure> {
        let named = |setting: &String| match setting.split_once('=') {
            Some((_, folder)) if !Path::new(folder).is_dir() => Err(Failure::input(format!(
                "--package {setting}: there is no folder {folder}"
            ))),
            Some((name, folder)) => Ok((name.to_owned(), folder.to_owned())),
            None => Err(Failure::input(format!(
                "--package {setting}: NAME=FOLDER was expected"
            ))),
        };
        let ros_path = std::env::var_os("ROS_PACKAGE_PATH").unwrap_or_default();
        let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        Ok(Self {
            packages: packages
                .iter()
                .map(named)
                .collect::<std::result::Result<_, _>>()?,
            above: absolute.ancestors().skip(1).map(Path::to_owned).collect(),
            ros_path: std::env::split_paths(&ros_path).collect(),
        })
    }

    fn find(&self, name: &str) -> Option<PathBuf> {
        let given = self.packages.iter().find(|(known, _)| known == name);
        if let Some((_, folder)) = given {
            return Some(PathBuf::from(folder));
        }
        let itself = self.above.iter().find(|folder| folder.ends_with(name));
        let beside = || {
            let folders = self.ros_path.iter().chain(&self.above);
            folders
                .map(|folder| folder.join(name))
                .find(|folder| folder.is_dir())
        };
        itself.cloned().or_else(beside)
    }
}

impl Resources for Files {
    fn read(&self, path: &str) -> Result<String> {
        read_text(Path::new(path)).map_err(|failure| match failure {
            Failure::Input(text) | Failure::World(text) => Error::resource("", text),
            Failure::ClosedPipe => Error::resource(path, "it could not be read"),
        })
    }

    fn package(&self, name: &str) -> Option<String> {
        // A name from a description, not a path: it must not lead out of the folders searched.
        let is_plain = !name.is_empty() && !name.contains(['/', '\\']) && name != "..";
        let folder = is_plain.then(|| self.find(name)).flatten()?;
        folder.to_str().map(str::to_owned)
    }

    fn environment(&self, name: &str) -> Option<String> {
        std::env::var(name).ok()
    }
}

/// The mesh files that a description names.
pub(crate) struct Meshes {
    /// The description's own folder.
    folder: PathBuf,
    files: Files,
}

/// The largest mesh file that is read.
const LARGEST_MESH: u64 = 256 << 20;

impl Meshes {
    /// For the description at `path`.
    pub(crate) fn new(path: &Path, files: Files) -> Self {
        let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let folder = absolute.parent().map_or_else(PathBuf::new, Path::to_owned);
        Self { folder, files }
    }

    /// The bytes at an address: `package://NAME/...`, `file://...`, or a path seen from the description.
    ///
    /// # Errors
    /// A sentence that names the path tried.
    pub(crate) fn read(&self, uri: &str) -> std::result::Result<Vec<u8>, String> {
        let path = match (uri.strip_prefix("package://"), uri.strip_prefix("file://")) {
            (Some(rest), _) => {
                let (name, rest) = rest
                    .split_once('/')
                    .ok_or("package://NAME/PATH was expected")?;
                let folder = self.files.package(name);
                let folder = folder.ok_or_else(|| format!("the package {name} was not found: say where it is with --package {name}=FOLDER"))?;
                // A description must not lead out of the package that it names.
                let root = Path::new(&folder)
                    .canonicalize()
                    .map_err(|error| format!("{folder}: {error}"))?;
                let path = root.join(rest);
                let real = path
                    .canonicalize()
                    .map_err(|error| format!("{}: {error}", path.display()))?;
                if !real.starts_with(&root) {
                    return Err(format!(
                        "{} leads out of the package {name}",
                        path.display()
                    ));
                }
                real
            }
            (None, Some(rest)) => PathBuf::from(rest),
            (None, None) if uri.contains("://") => {
                return Err("only package:// and file:// are read".to_owned());
            }
            (None, None) => self.folder.join(uri),
        };
        let shown = path.display();
        let size = std::fs::metadata(&path)
            .map_err(|error| format!("{shown}: {error}"))?
            .len();
        if size > LARGEST_MESH {
            return Err(format!(
                "{shown}: it has {size} bytes, at most {LARGEST_MESH} are read"
            ));
        }
        std::fs::read(&path).map_err(|error| format!("{shown}: {error}"))
    }
}
