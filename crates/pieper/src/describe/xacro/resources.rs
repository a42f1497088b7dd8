//! What a description needs from the world around it.

use crate::error::{Error, Result};

/// The files, packages and environment that a description may refer to, given by the caller: the library itself
/// reads nothing.
///
/// ```
/// use pieper::describe::xacro::{self, Resources};
///
/// struct Folder;
/// impl Resources for Folder {
///     fn read(&self, path: &str) -> pieper::Result<String> {
///         match path {
///             "robots/lengths.xacro" => Ok(r#"<robot xmlns:xacro="x">
///                 <xacro:property name="reach" value="0.3"/></robot>"#.to_owned()),
///             _ => Err(pieper::Error::resource(path, "no such file")),
///         }
///     }
///     fn package(&self, _name: &str) -> Option<String> {
///         None
///     }
/// }
/// let urdf = xacro::expand("robots/arm.xacro", r#"<robot name="arm" xmlns:xacro="x">
///     <xacro:include filename="lengths.xacro"/>
///     <link name="reach_${reach}"/></robot>"#, &[], &Folder)?;
/// assert!(urdf.contains(r#"<link name="reach_0.3"/>"#));
/// # Ok::<(), pieper::Error>(())
/// ```
pub trait Resources {
    /// The text of the file at `path`, which begins with the folder of the description's own file name, or with one
    /// that [`package`](Self::package) gave, or is absolute.
    ///
    /// # Errors
    /// A resource error that says why it cannot be had.
    fn read(&self, path: &str) -> Result<String>;

    /// The folder of a package, as in `$(find name)` and `package://name/...`; `None` if there is no such package.
    fn package(&self, name: &str) -> Option<String>;

    /// An environment variable; `None` if it is not set, or not to be seen.
    fn environment(&self, _name: &str) -> Option<String> {
        None
    }
}

/// No files, no packages: for a description that stands alone.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoResources;

impl Resources for NoResources {
    fn read(&self, path: &str) -> Result<String> {
        Err(Error::resource(path, "no files can be read here"))
    }

    fn package(&self, _name: &str) -> Option<String> {
        None
    }
}
