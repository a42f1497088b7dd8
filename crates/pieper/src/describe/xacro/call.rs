//! Calls of macros: values, defaults and blocks for their parameters.

use std::rc::Rc;

use super::evaluate::literal;
use super::expander::{Expander, Site};
use super::parameter;
use super::scope::{Block, Entry, Macro};
use super::value::Value;
use crate::describe::urdf::xml::{Element, Node};
use crate::error::Result;

impl Expander<'_> {
    /// Appends what a macro makes of a call.
    pub(super) fn call_macro(
        &mut self,
        name: &str,
        element: &Element,
        scope: usize,
        out: &mut Element,
    ) -> Result<()> {
        let Some((home, called)) = self.scopes.macro_named(scope, name) else {
            let names = self.scopes.macro_names(scope);
            let there = match names.len() {
                0 => "none is defined here".to_owned(),
                _ => format!("those defined here are {}", names.join(", ")),
            };
            return Err(element.error(format!("there is no macro {name}; {there}")));
        };
        let blocks = self.blocks(element, scope)?;
        let mut values = self.given(&called, element, scope)?;
        self.defaults(&called, element, scope, &mut values)?;
        let count = self.scopes.count();
        let inner = self.scopes.open(home, false);
        for (name, value) in values {
            self.scopes.set(inner, &name, Entry::Value(value));
        }
        self.hand_blocks(&called, element, inner, blocks)?;
        self.calls.push(name.to_owned());
        self.children(&called.body.children, inner, out)?;
        self.calls.pop();
        self.scopes.close(count);
        Ok(())
    }

    /// The elements within a macro call, expanded where they stand.
    fn blocks(&mut self, element: &Element, scope: usize) -> Result<Vec<Rc<Element>>> {
        let mut holder = element.bare();
        self.children(&element.children, scope, &mut holder)?;
        let blocks = holder.children.into_iter().filter_map(|node| match node {
            Node::Element(element) => Some(element),
            Node::Text(..) => None,
        });
        Ok(blocks.collect())
    }

    /// The values that a call gives.
    fn given(
        &mut self,
        called: &Macro,
        element: &Element,
        scope: usize,
    ) -> Result<Vec<(String, Value)>> {
        let mut values = Vec::new();
        for attribute in &element.attributes {
            let is_call = element.name == "xacro:call" && attribute.name == "macro";
            if is_call || attribute.name.starts_with("xmlns") {
                continue;
            }
            let takes = |p: &parameter::Parameter| {
                matches!(p.kind, parameter::Kind::Value { .. }) && p.name == attribute.name
            };
            if !called.parameters.iter().any(takes) {
                let names: Vec<&str> = called.parameters.iter().map(|p| p.name.as_str()).collect();
                let has = match names.len() {
                    0 => "it has none".to_owned(),
                    _ => format!("its parameters are {}", names.join(", ")),
                };
                let text = format!("the macro {} has no such parameter; {has}", called.name);
                return Err(attribute.error(text));
            }
            let value = self.attribute(attribute, scope)?;
            values.push((attribute.name.clone(), literal(value, &attribute.spot)?));
        }
        Ok(values)
    }

    /// Adds the values that a call leaves to their defaults.
    fn defaults(
        &mut self,
        called: &Macro,
        element: &Element,
        scope: usize,
        values: &mut Vec<(String, Value)>,
    ) -> Result<()> {
        let written = called.body.attribute("params");
        let spot = written.map_or(&called.body.spot, |params| &params.spot);
        for parameter in &called.parameters {
            let parameter::Kind::Value { forward, default } = &parameter.kind else {
                continue;
            };
            let name = &parameter.name;
            if values.iter().any(|(given, _)| given == name) {
                continue;
            }
            let site = Site {
                spot: element.spot.clone(),
                text: &element.name,
                scope,
            };
            let forwarded = if *forward {
                self.property(name, &site)?
            } else {
                None
            };
            let value = match (forwarded, default) {
                (Some(value), _) => value,
                (None, Some(text)) => literal(self.text(text, spot, scope)?, spot)?,
                (None, None) => {
                    return Err(element.error(format!(
                        "the macro {} expects a value for its parameter {name}",
                        called.name
                    )));
                }
            };
            values.push((name.clone(), value));
        }
        Ok(())
    }

    /// Hands the blocks of a call to the macro's block parameters, in order.
    fn hand_blocks(
        &mut self,
        called: &Macro,
        element: &Element,
        inner: usize,
        blocks: Vec<Rc<Element>>,
    ) -> Result<()> {
        let mut blocks = blocks.into_iter();
        for parameter in &called.parameters {
            let parameter::Kind::Block { contents } = parameter.kind else {
                continue;
            };
            let Some(block) = blocks.next() else {
                let text = format!(
                    "the macro {} expects an element {} within",
                    called.name, parameter.name
                );
                return Err(element.error(text));
            };
            let block = Block {
                element: block,
                contents,
            };
            self.scopes.set_block(inner, &parameter.name, block);
        }
        match blocks.next() {
            None => Ok(()),
            Some(block) => Err(block.error(format!("the macro {} does not use it", called.name))),
        }
    }
}
