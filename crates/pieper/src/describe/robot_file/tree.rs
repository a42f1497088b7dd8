//! A robot file that takes its chain out of a URDF or xacro.

use super::fields::{Field, Table};
use crate::describe::robot::{Form, Robot};
use crate::describe::urdf;
use crate::describe::xacro::{self, Resources};
use crate::error::{Error, Result};

/// `urdf = "arm.urdf"`, with `base` and `tip` links.
pub(super) fn form(root: &Table<'_>, field: &Field<'_>, resources: &dyn Resources) -> Result<Form> {
    for name in ["convention", "parameters", "joint", "screws", "tool"] {
        if let Some(other) = root.get(name) {
            return Err(
                other.name_error("it cannot stand beside `urdf = `: the URDF is the geometry")
            );
        }
    }
    let path = resolve(root.file, field.string()?, resources)
        .ok_or_else(|| field.error("there is no such package"))?;
    let found = |error: Error| field.error("it cannot be used").caused_by(error);
    let text = resources.read(&path).map_err(found)?;
    let tree = if path.ends_with(".xacro") {
        xacro::read(&path, &text, &[], resources)?
    } else {
        urdf::read(&path, &text)?
    };
    let link = |name: &str| root.get(name).map(|field| field.string()).transpose();
    Ok(Robot::of_tree(tree, link("base")?, link("tip")?)?.form)
}

/// The path as the caller's resources understand it; `None` for a package there is none of.
fn resolve(file: &str, path: &str, resources: &dyn Resources) -> Option<String> {
    if let Some((package, rest)) = path
        .strip_prefix("package://")
        .and_then(|p| p.split_once('/'))
    {
        return Some(format!("{}/{rest}", resources.package(package)?));
    }
    match file.rfind(['/', '\\']) {
        Some(end) if !path.starts_with('/') => Some(format!("{}{path}", &file[..=end])),
        _ => Some(path.to_owned()),
    }
}
