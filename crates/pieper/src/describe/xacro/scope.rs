//! Where names are looked up: the file's scope, one for each macro call, one for each namespace.

use std::collections::HashMap;
use std::rc::Rc;

use super::parameter::Parameter;
use super::value::Value;
use crate::describe::urdf::xml::{Element, Spot};

/// The scope of the whole description.
pub(super) const GLOBAL: usize = 0;

/// What a name stands for.
#[derive(Clone, Debug)]
pub(super) enum Entry {
    /// A text that is evaluated when it is first needed.
    Lazy(Rc<str>, Spot),
    /// Being evaluated.
    Busy,
    Value(Value),
    /// What a file included with `ns` defines.
    Namespace(usize),
}

/// An element handed to a macro or kept in a property.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) element: Rc<Element>,
    /// Whether the contents are meant rather than the element.
    pub(super) contents: bool,
}

#[derive(Debug)]
pub(super) struct Macro {
    pub(super) name: String,
    pub(super) parameters: Vec<Parameter>,
    pub(super) body: Rc<Element>,
}

#[derive(Debug, Default)]
pub(super) struct Scope {
    parent: Option<usize>,
    is_namespace: bool,
    names: HashMap<String, Entry>,
    blocks: HashMap<String, Block>,
    macros: HashMap<String, Rc<Macro>>,
}

/// All scopes there are; a macro call's is gone after the call.
#[derive(Debug)]
pub(super) struct Scopes(Vec<Scope>);

impl Scopes {
    pub(super) fn new() -> Self {
        Self(vec![Scope::default()])
    }

    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    pub(super) fn open(&mut self, parent: usize, is_namespace: bool) -> usize {
        self.0.push(Scope {
            parent: Some(parent),
            is_namespace,
            ..Scope::default()
        });
        self.0.len() - 1
    }

    /// Forgets the scopes from `count` on.
    pub(super) fn close(&mut self, count: usize) {
        self.0.truncate(count);
    }

    /// The scope and those around it, inside out.
    fn outward(&self, scope: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(scope), |&scope| self.0[scope].parent)
    }

    /// What a name stands for, and in which scope.
    pub(super) fn find(&self, scope: usize, name: &str) -> Option<(usize, &Entry)> {
        self.outward(scope)
            .find_map(|scope| Some((scope, self.0[scope].names.get(name)?)))
    }

    pub(super) fn set(&mut self, scope: usize, name: &str, entry: Entry) {
        self.0[scope].names.insert(name.to_owned(), entry);
    }

    /// Removes a property here and in all scopes around.
    pub(super) fn remove(&mut self, scope: usize, name: &str) {
        let scopes: Vec<usize> = self.outward(scope).collect();
        for scope in scopes {
            self.0[scope].names.remove(name);
            self.0[scope].blocks.remove(name);
        }
    }

    pub(super) fn block(&self, scope: usize, name: &str) -> Option<&Block> {
        self.outward(scope)
            .find_map(|scope| self.0[scope].blocks.get(name))
    }

    pub(super) fn set_block(&mut self, scope: usize, name: &str, block: Block) {
        self.0[scope].blocks.insert(name.to_owned(), block);
    }

    pub(super) fn set_macro(&mut self, scope: usize, called: Macro) {
        self.0[scope]
            .macros
            .insert(called.name.clone(), Rc::new(called));
    }

    /// A macro by its name, perhaps behind namespaces and dots, and the scope it was defined for.
    pub(super) fn macro_named(&self, scope: usize, name: &str) -> Option<(usize, Rc<Macro>)> {
        let plain = |from: usize, name: &str| {
            self.outward(from)
                .find_map(|at| self.0[at].macros.get(name).cloned())
        };
        if let Some(found) = plain(scope, name) {
            return Some((scope, found));
        }
        let (spaces, last) = name.rsplit_once('.')?;
        let mut at = scope;
        for space in spaces.split('.') {
            match self.find(at, space)? {
                (_, &Entry::Namespace(inner)) => at = inner,
                _ => return None,
            }
        }
        plain(at, last).map(|found| (at, found))
    }

    /// Where a property for the caller goes: past the namespaces, unless one itself asks.
    pub(super) fn caller(&self, scope: usize) -> usize {
        let mut target = self.0[scope].parent.unwrap_or(GLOBAL);
        if !self.0[scope].is_namespace {
            while self.0[target].is_namespace {
                target = self.0[target].parent.unwrap_or(GLOBAL);
            }
        }
        target
    }

    /// The names of all macros in sight, sorted.
    pub(super) fn macro_names(&self, scope: usize) -> Vec<String> {
        let mut names: Vec<String> = self
            .outward(scope)
            .flat_map(|scope| self.0[scope].macros.keys().cloned())
            .collect();
        names.sort();
        names.dedup();
        names
    }
}
