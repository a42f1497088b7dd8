//! Elements into elements.

use std::rc::Rc;

use super::evaluate::literal;
use super::expander::{ELEMENT_WORK, Expander};
use super::parameter;
use super::scope::{Block, Entry, GLOBAL, Macro};
use super::token::is_name;
use super::value::Value;
use crate::describe::urdf::xml::{self, Attribute, Element, MAX_DEPTH, Node};
use crate::error::Result;

impl Expander<'_> {
    /// The root, expanded. Its own attributes come last: many name the robot by an argument declared below.
    pub(super) fn root(&mut self, root: &Element) -> Result<Element> {
        let mut contents = root.bare();
        self.children(&root.children, GLOBAL, &mut contents)?;
        let mut out = self.start(root, GLOBAL)?;
        out.children = contents.children;
        for made in contents.attributes {
            out.attributes.retain(|other| other.name != made.name);
            out.attributes.push(made);
        }
        for declaration in std::mem::take(&mut self.namespaces) {
            if out.attribute(&declaration.name).is_none() {
                out.attributes.push(declaration);
            }
        }
        Ok(out)
    }

    /// Appends what the nodes expand to.
    pub(super) fn children(
        &mut self,
        nodes: &[Node],
        scope: usize,
        out: &mut Element,
    ) -> Result<()> {
        self.enter(&out.spot)?;
        for node in nodes {
            match node {
                Node::Element(element) => self.element(element, scope, out)?,
                Node::Text(text, spot) => {
                    let text = self.text(text, spot, scope)?.text();
                    if !text.trim().is_empty() {
                        out.children.push(Node::Text(text, spot.clone()));
                    }
                }
            }
        }
        self.leave();
        Ok(())
    }

    fn element(&mut self, element: &Rc<Element>, scope: usize, out: &mut Element) -> Result<()> {
        self.charge(ELEMENT_WORK, &element.spot)?;
        let Some(word) = element.name.strip_prefix("xacro:") else {
            let copy = self.start(element, scope)?;
            return self.plain(copy, element, scope, out);
        };
        match word {
            "property" => self.set_property(element, scope),
            "arg" => self.set_argument(element, scope),
            "macro" => self.set_macro(element, scope),
            "include" => self.include(element, scope, out),
            "if" | "unless" => {
                if self.condition(element, scope)? == (word == "if") {
                    self.children(&element.children, scope, out)?;
                }
                Ok(())
            }
            "insert_block" => self.insert_block(element, scope, out),
            "element" => self.make_element(element, scope, out),
            "attribute" => self.make_attribute(element, scope, out),
            "call" => {
                let name = self.attribute(element.required("macro")?, scope)?.text();
                self.call_macro(&name, element, scope, out)
            }
            name => self.call_macro(name, element, scope, out),
        }
    }

    fn make_element(&mut self, element: &Element, scope: usize, out: &mut Element) -> Result<()> {
        let name = self.written_name(element.required("xacro:name")?, scope)?;
        let mut copy = self.start(element, scope)?;
        copy.name = name;
        self.plain(copy, element, scope, out)
    }

    fn make_attribute(&mut self, element: &Element, scope: usize, out: &mut Element) -> Result<()> {
        let name = self.written_name(element.required("name")?, scope)?;
        let value = element.required("value")?;
        let attribute = Attribute {
            name,
            value: self.attribute(value, scope)?.text(),
            spot: value.spot.clone(),
        };
        out.attributes.retain(|other| other.name != attribute.name);
        out.attributes.push(attribute);
        Ok(())
    }

    /// An element without its children, attributes evaluated.
    fn start(&mut self, element: &Element, scope: usize) -> Result<Element> {
        let mut attributes = Vec::with_capacity(element.attributes.len());
        for attribute in &element.attributes {
            if attribute.name.starts_with("xacro:") || attribute.name == "xmlns:xacro" {
                continue;
            }
            let value = self.attribute(attribute, scope)?.text();
            self.charge(ELEMENT_WORK / 4 + value.len(), &attribute.spot)?;
            attributes.push(Attribute {
                name: attribute.name.clone(),
                value,
                spot: attribute.spot.clone(),
            });
        }
        Ok(Element {
            attributes,
            ..element.bare()
        })
    }

    fn plain(
        &mut self,
        mut copy: Element,
        element: &Element,
        scope: usize,
        out: &mut Element,
    ) -> Result<()> {
        self.nesting += 1;
        if self.nesting > MAX_DEPTH {
            let text = format!("elements become nested more than {MAX_DEPTH} deep");
            return Err(element.error(text));
        }
        self.children(&element.children, scope, &mut copy)?;
        self.nesting -= 1;
        out.children.push(Node::Element(Rc::new(copy)));
        Ok(())
    }

    /// The name of an element or attribute that is made: without a prefix, whose meaning the file may not know.
    fn written_name(&mut self, attribute: &Attribute, scope: usize) -> Result<String> {
        let name = self.attribute(attribute, scope)?.text();
        let part = |c: char| c.is_alphanumeric() || "_-.".contains(c);
        let starts = name.starts_with(|c: char| c.is_alphabetic() || c == '_');
        if starts && !name.starts_with("xmlns") && name.chars().all(part) {
            Ok(name)
        } else {
            Err(attribute.error(format!(
                "a name without a prefix was expected, not '{name}'"
            )))
        }
    }

    fn condition(&mut self, element: &Element, scope: usize) -> Result<bool> {
        let attribute = element.required("value")?;
        let value = self.attribute(attribute, scope)?;
        truth(&value).ok_or_else(|| {
            attribute.error(format!(
                "true or false was expected, not {}",
                value.described()
            ))
        })
    }

    fn set_argument(&mut self, element: &Element, scope: usize) -> Result<()> {
        let name = element.required("name")?.value.clone();
        if let (Some(default), false) = (
            element.attribute("default"),
            self.arguments.contains_key(&name),
        ) {
            let value = self.attribute(default, scope)?.text();
            self.arguments.insert(name.clone(), value);
        }
        self.known.insert(name);
        Ok(())
    }

    fn set_macro(&mut self, element: &Rc<Element>, scope: usize) -> Result<()> {
        let attribute = element.required("name")?;
        let name = attribute
            .value
            .strip_prefix("xacro:")
            .unwrap_or(&attribute.value);
        if name == "call" || name.contains('.') {
            return Err(
                attribute.error("a macro cannot be called 'call', nor have a dot in its name")
            );
        }
        let parameters = match element.attribute("params") {
            None => Vec::new(),
            Some(params) => parameter::parse(&params.value)
                .map_err(|rest| params.error(format!("a parameter was expected at '{rest}'")))?,
        };
        let defined = Macro {
            name: name.to_owned(),
            parameters,
            body: Rc::clone(element),
        };
        self.scopes.set_macro(scope, defined);
        Ok(())
    }

    fn set_property(&mut self, element: &Rc<Element>, scope: usize) -> Result<()> {
        let attribute = element.required("name")?;
        let name = self.attribute(attribute, scope)?.text();
        if !is_name(&name) || name.starts_with("__") {
            return Err(attribute.error(format!(
                "a name without a prefix was expected, not '{name}'"
            )));
        }
        let (value, default) = (element.attribute("value"), element.attribute("default"));
        let remove = self.flag(element, "remove", false, scope)?;
        if usize::from(remove) + usize::from(value.is_some()) + usize::from(default.is_some()) > 1 {
            return Err(element.error("only one of value, default and remove was expected"));
        }
        if remove {
            self.scopes.remove(scope, &name);
            return Ok(());
        }
        if default.is_some() && self.scopes.find(scope, &name).is_some() {
            return Ok(());
        }
        let (target, is_local) = match element.attribute("scope").map(|a| (a, a.value.as_str())) {
            None => (scope, true),
            Some((_, "global")) => (GLOBAL, false),
            Some((_, "parent")) => (self.scopes.caller(scope), false),
            Some((attribute, _)) => {
                return Err(attribute.error("scope=\"parent\" or scope=\"global\" was expected"));
            }
        };
        let Some(value) = value.or(default) else {
            let block = Block {
                element: Rc::clone(element),
                contents: true,
            };
            self.scopes.set_block(target, &name, block);
            return Ok(());
        };
        let lazy = is_local && self.flag(element, "lazy_eval", true, scope)?;
        let entry = if lazy {
            // A text without its quotes is looked at again when it is used: quotes alone do not keep `'1'` a text.
            match literal(Value::Str(value.value.as_str().into()), &value.spot)? {
                Value::Str(text) => Entry::Lazy(text, value.spot.clone()),
                plain => Entry::Value(plain),
            }
        } else {
            let evaluated = self.attribute(value, scope)?;
            Entry::Value(literal(evaluated, &value.spot)?)
        };
        self.scopes.set(target, &name, entry);
        Ok(())
    }

    /// An attribute that is true or false.
    fn flag(&mut self, element: &Element, name: &str, default: bool, scope: usize) -> Result<bool> {
        let Some(attribute) = element.attribute(name) else {
            return Ok(default);
        };
        let value = self.attribute(attribute, scope)?;
        truth(&value).ok_or_else(|| attribute.error("true or false was expected"))
    }

    fn include(&mut self, element: &Element, scope: usize, out: &mut Element) -> Result<()> {
        let attribute = element.required("filename")?;
        let name = self.attribute(attribute, scope)?.text();
        if name.contains(['*', '?', '[']) {
            return Err(attribute.error("patterns of file names are not read: name each file"));
        }
        let path = self.path(&name);
        if self.files.contains(&path) {
            let chain = format!("{} -> {path}", self.files.join(" -> "));
            return Err(attribute.error(format!("files include each other in a circle: {chain}")));
        }
        let inner = match element.attribute("ns") {
            None => scope,
            Some(ns) => {
                let name = self.attribute(ns, scope)?.text();
                let inner = self.scopes.open(scope, true);
                self.scopes.set(scope, &name, Entry::Namespace(inner));
                inner
            }
        };
        let optional = self.flag(element, "optional", false, scope)?;
        let text = match self.read(&path, &attribute.spot) {
            Ok(text) => text,
            Err(error) if optional && error.is_resource() => return Ok(()),
            Err(error) => return Err(error),
        };
        let root = xml::parse(&path, &text)?;
        let declared = root.attributes.iter();
        let declared = declared.filter(|a| a.name.starts_with("xmlns:") && a.name != "xmlns:xacro");
        self.namespaces.extend(declared.cloned());
        self.files.push(path);
        self.children(&root.children, inner, out)?;
        self.files.pop();
        Ok(())
    }

    fn insert_block(&mut self, element: &Element, scope: usize, out: &mut Element) -> Result<()> {
        let attribute = element.required("name")?;
        let name = self.attribute(attribute, scope)?.text();
        let block = self.scopes.block(scope, &name).cloned();
        let block = block.ok_or_else(|| attribute.error("there is no block of this name here"))?;
        self.enter(&element.spot)?;
        if block.contents {
            self.children(&block.element.children, scope, out)?;
        } else {
            self.element(&block.element, scope, out)?;
        }
        self.leave();
        Ok(())
    }
}

/// What counts as true and false for a condition; `None` for a text that is neither.
fn truth(value: &Value) -> Option<bool> {
    match value {
        Value::Str(text) => match &**text {
            "true" | "True" => Some(true),
            "false" | "False" => Some(false),
            number => number.trim().parse().ok().map(|int: i64| int != 0),
        },
        value => Some(value.truth()),
    }
}
