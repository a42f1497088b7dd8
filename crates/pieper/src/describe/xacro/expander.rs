//! The state of an expansion, and the bounds it keeps.

use std::collections::{BTreeMap, BTreeSet};

use super::resources::Resources;
use super::scope::Scopes;
use super::value::Value;
use crate::describe::urdf::xml::{Attribute, Spot};
use crate::error::{Error, Result};

/// Nested elements, macro calls, includes, properties that need others and brackets of expressions, all together: each
/// takes up to 4 KiB of the stack without optimisation, and a thread has 2 MiB.
const MAX_DEPTH: usize = 400;

/// Work done, in bytes handled or about a nanosecond: several times what the largest descriptions in use take, small
/// enough to say no within a second to one that doubles itself.
const MAX_WORK: usize = 1 << 27;

/// What an element costs in that measure: about the memory it takes.
pub(super) const ELEMENT_WORK: usize = 512;

pub(super) struct Expander<'a> {
    pub(super) resources: &'a dyn Resources,
    pub(super) scopes: Scopes,
    /// Values of `$(arg name)`: those given, and the defaults met so far.
    pub(super) arguments: BTreeMap<String, String>,
    /// Arguments that the description declares or uses.
    pub(super) known: BTreeSet<String>,
    /// The files being read, outermost first.
    pub(super) files: Vec<String>,
    /// The macros being expanded, outermost first.
    pub(super) calls: Vec<String>,
    /// Folders of packages found so far.
    packages: BTreeSet<String>,
    /// Namespace declarations of included files.
    pub(super) namespaces: Vec<Attribute>,
    /// Depth of the element being written.
    pub(super) nesting: usize,
    depth: usize,
    work: usize,
}

/// Where a text stands that is being evaluated.
pub(super) struct Site<'a> {
    pub(super) spot: Spot,
    pub(super) text: &'a str,
    pub(super) scope: usize,
}

impl Site<'_> {
    #[cold]
    pub(super) fn error(&self, message: impl Into<String>) -> Error {
        self.spot.error(self.text, message)
    }
}

impl<'a> Expander<'a> {
    pub(super) fn new(
        file_name: &str,
        arguments: &[(&str, &str)],
        resources: &'a dyn Resources,
    ) -> Self {
        let own = |&(name, value): &(&str, &str)| (name.to_owned(), value.to_owned());
        Self {
            resources,
            scopes: Scopes::new(),
            arguments: arguments.iter().map(own).collect(),
            known: BTreeSet::new(),
            files: vec![file_name.to_owned()],
            calls: Vec::new(),
            packages: BTreeSet::new(),
            namespaces: Vec::new(),
            nesting: 0,
            depth: 0,
            work: 0,
        }
    }

    /// One level deeper; [`leave`](Self::leave) goes back. After an error nobody does: it ends the expansion.
    pub(super) fn enter(&mut self, spot: &Spot) -> Result<()> {
        self.depth += 1;
        if self.depth <= MAX_DEPTH {
            return Ok(());
        }
        let deepest: Vec<&str> = self
            .calls
            .iter()
            .rev()
            .take(5)
            .map(String::as_str)
            .collect();
        let chain: Vec<&str> = deepest.into_iter().rev().collect();
        Err(if chain.is_empty() {
            spot.error("", "expressions and properties are nested too deeply")
        } else {
            let chain = chain.join(" -> ");
            spot.error(
                chain,
                "macro calls are nested too deeply; these are the last ones",
            )
        })
    }

    pub(super) fn leave(&mut self) {
        self.depth -= 1;
    }

    /// Counts work; an error when there was too much of it.
    pub(super) fn charge(&mut self, work: usize, spot: &Spot) -> Result<()> {
        self.work = self.work.saturating_add(work);
        if self.work > MAX_WORK {
            let elements = MAX_WORK / ELEMENT_WORK;
            let text = format!(
                "the description becomes too large: the bound is about {elements} elements"
            );
            return Err(spot.error("", text));
        }
        Ok(())
    }

    pub(super) fn charge_values(&mut self, values: &[&Value], spot: &Spot) -> Result<()> {
        let weight = values.iter().map(|value| value.weight()).sum::<usize>();
        self.charge(10 + weight, spot)
    }

    /// The folder of a package.
    pub(super) fn package(&mut self, name: &str, site: &Site<'_>) -> Result<String> {
        let folder = self.resources.package(name).ok_or_else(|| {
            Error::resource(site.text, "there is no package of this name").at(site.spot.place())
        })?;
        self.packages.insert(folder.clone());
        Ok(folder)
    }

    /// A file name as seen from the file being read. What begins with a package's folder stays as it is, even if
    /// the caller gave that as a relative one.
    pub(super) fn path(&self, name: &str) -> String {
        let begins = |folder: &String| {
            name.strip_prefix(folder)
                .is_some_and(|n| n.starts_with('/'))
        };
        let is_absolute = name.starts_with(['/', '\\']) || name.contains(':');
        match self.folder() {
            Some(folder) if !is_absolute && !self.packages.iter().any(begins) => {
                format!("{folder}/{name}")
            }
            _ => name.to_owned(),
        }
    }

    /// The folder of the file being read; `None` if its name has none.
    pub(super) fn folder(&self) -> Option<&str> {
        let file = self.files.last()?;
        Some(&file[..file.rfind(['/', '\\'])?])
    }

    /// The text of a file that the place refers to.
    pub(super) fn read(&mut self, path: &str, spot: &Spot) -> Result<String> {
        let text = self
            .resources
            .read(path)
            .map_err(|error| error.at(spot.place()))?;
        self.charge(text.len(), spot)?;
        Ok(text)
    }
}
