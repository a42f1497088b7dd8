//! Xacro, the macro language in which most arms are described: [`expand`] gives URDF text, [`read`] a tree.
//!
//! Read are properties (lazy and eager, defaults, blocks, scopes), arguments, macros (defaults, forwarded values,
//! blocks), conditions, includes (optional, with a namespace), calls by a computed name, `xacro:element` and
//! `xacro:attribute`, `$(find)`, `$(arg)`, `$(env)`, `$(optenv)`, `$(dirname)`, `$(eval)`, YAML files with units, and the
//! part of Python's expressions that descriptions use: arithmetic, comparisons, conditions, texts, lists, dictionaries,
//! the functions of `math`.
//!
//! Not read are comprehensions, `lambda`, formatting with `%`, file name patterns in includes, and expressions in
//! comments. A tuple is a list. Integers have 64 bits. A macro found in a namespace also sees the macros around it.
//!
//! The order matters, as in xacro itself: what is used must have been defined before.

mod call;
mod evaluate;
mod expand;
mod expander;
mod expr;
mod function;
mod interpret;
mod operator;
mod parameter;
mod print;
mod resources;
mod scope;
mod syntax;
mod text;
mod token;
mod value;
mod yaml;

use expander::Expander;
pub use resources::{NoResources, Resources};

use super::urdf;
use super::urdf::xml::{self, Element};
use crate::error::{Error, Result};
use crate::model::Tree;

/// Expands a xacro into the URDF text that it stands for.
///
/// `file_name` is what errors call the text and what relative file names start from; `arguments` are values for
/// `<xacro:arg>`, by name; `resources` are the files and packages that it refers to.
///
/// ```
/// use pieper::describe::xacro::{self, NoResources};
/// let text = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
///   <xacro:arg name="prefix" default=""/>
///   <xacro:macro name="part" params="name">
///     <link name="$(arg prefix)${name}"/>
///   </xacro:macro>
///   <xacro:part name="base"/>
/// </robot>"#;
/// let urdf = xacro::expand("arm.xacro", text, &[("prefix", "left_")], &NoResources)?;
/// assert!(urdf.contains(r#"<link name="left_base"/>"#));
/// # Ok::<(), pieper::Error>(())
/// ```
///
/// # Errors
/// A parse error with file, line and column of what was written, also in an included file; a resource error for a file,
/// package or environment variable that cannot be had; an input error for an argument that the description does not
/// have. A description that calls itself without end or grows beyond all bounds is an error too.
pub fn expand(
    file_name: &str,
    text: &str,
    arguments: &[(&str, &str)],
    resources: &dyn Resources,
) -> Result<String> {
    Ok(print::document(&expanded(
        file_name, text, arguments, resources,
    )?))
}

/// Reads a xacro as a tree: [`expand`] and [`urdf::read`] in one, with places in the xacro for the mistakes of both.
///
/// ```
/// use pieper::describe::xacro::{self, NoResources};
/// let text = r#"<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
///   <link name="base"/>
///   <link name="arm"/>
///   <joint name="turn" type="revolute">
///     <parent link="base"/> <child link="arm"/>
///     <origin xyz="0 0 ${2 * 0.3}"/>
///     <limit lower="${-radians(170)}" upper="${radians(170)}" effort="1" velocity="1"/>
///   </joint>
/// </robot>"#;
/// let tree = xacro::read("arm.xacro", text, &[], &NoResources)?;
/// assert_eq!(tree.joints()[0].origin.translation.z, 0.6);
/// # Ok::<(), pieper::Error>(())
/// ```
///
/// # Errors
/// Those of [`expand`] and of [`urdf::read`].
pub fn read(
    file_name: &str,
    text: &str,
    arguments: &[(&str, &str)],
    resources: &dyn Resources,
) -> Result<Tree> {
    urdf::robot(&expanded(file_name, text, arguments, resources)?)
}

fn expanded(
    file_name: &str,
    text: &str,
    arguments: &[(&str, &str)],
    resources: &dyn Resources,
) -> Result<Element> {
    let root = xml::parse(file_name, text)?;
    let mut expander = Expander::new(file_name, arguments, resources);
    let expanded = expander.root(&root)?;
    match arguments
        .iter()
        .find(|(name, _)| !expander.known.contains(*name))
    {
        None => Ok(expanded),
        Some((name, _)) => {
            let known: Vec<&str> = expander.known.iter().map(String::as_str).collect();
            let there = match known.len() {
                0 => "it has none".to_owned(),
                _ => format!("it has {}", known.join(", ")),
            };
            let text = format!("the description has no argument of this name; {there}");
            Err(Error::input(format!("argument {name}"), text))
        }
    }
}
