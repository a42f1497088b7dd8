//! XML as we keep it: elements that know where they were written, however often a macro copies them.

use std::rc::Rc;

use roxmltree::{Document, ParsingOptions};

use crate::error::{Error, Place, Result};

/// Elements nested deeper than this are refused: our own functions recurse, and no description comes near.
pub(in crate::describe) const MAX_DEPTH: usize = 200;

/// More elements, texts and attributes than this in one file are refused; the largest public descriptions have some 10,000.
const MAX_NODES: u32 = 1_000_000;

/// More attributes in one tag, or namespace declarations in one file, are refused: the parser compares each with each.
const MAX_ATTRIBUTES: usize = 1000;

/// A file's name and text.
#[derive(Debug)]
pub(in crate::describe) struct Source {
    pub(in crate::describe) name: String,
    text: String,
}

/// A place in a source, as a byte offset: turned into line and column only when an error needs them.
#[derive(Clone, Debug)]
pub(in crate::describe) struct Spot {
    pub(in crate::describe) source: Rc<Source>,
    offset: usize,
}

impl Spot {
    /// An error at this place; `subject` is the offending text.
    #[cold]
    pub(in crate::describe) fn error(
        &self,
        subject: impl Into<String>,
        message: impl Into<String>,
    ) -> Error {
        Error::parse(self.place(), shorten(subject.into()), message)
    }

    /// Line and column.
    #[cold]
    pub(in crate::describe) fn place(&self) -> Place {
        Place::of_offset(&self.source.name, &self.source.text, self.offset)
    }

    /// The place `bytes` further on.
    pub(in crate::describe) fn plus(&self, bytes: usize) -> Self {
        Self {
            source: Rc::clone(&self.source),
            offset: self.offset + bytes,
        }
    }
}

/// A text for an error message: one line, not too long.
fn shorten(text: String) -> String {
    const LONGEST: usize = 100;
    if text.chars().nth(LONGEST).is_none() && !text.contains('\n') {
        return text;
    }
    let words: Vec<&str> = text.split_whitespace().collect();
    let line = words.join(" ");
    match line.char_indices().nth(LONGEST) {
        None => line,
        Some((end, _)) => format!("{}...", &line[..end]),
    }
}

/// `name="value"` in a start tag. The spot is the value's.
#[derive(Clone, Debug)]
pub(in crate::describe) struct Attribute {
    pub(in crate::describe) name: String,
    pub(in crate::describe) value: String,
    pub(in crate::describe) spot: Spot,
}

impl Attribute {
    /// The attribute as written, for an error message.
    pub(in crate::describe) fn text(&self) -> String {
        format!("{}=\"{}\"", self.name, self.value)
    }

    /// An error at the attribute's value.
    #[cold]
    pub(in crate::describe) fn error(&self, message: impl Into<String>) -> Error {
        self.spot.error(self.text(), message)
    }
}

/// An element, its name as written, prefix included: xacro goes by the prefix, not by what it is bound to.
#[derive(Clone, Debug)]
pub(in crate::describe) struct Element {
    pub(in crate::describe) name: String,
    pub(in crate::describe) attributes: Vec<Attribute>,
    pub(in crate::describe) children: Vec<Node>,
    pub(in crate::describe) spot: Spot,
}

/// What an element contains. Comments and processing instructions are dropped.
#[derive(Clone, Debug)]
pub(in crate::describe) enum Node {
    /// Shared, so that a macro's body is copied for nothing.
    Element(Rc<Element>),
    Text(String, Spot),
}

impl Element {
    /// The attribute of this name.
    pub(in crate::describe) fn attribute(&self, name: &str) -> Option<&Attribute> {
        self.attributes.iter().find(|a| a.name == name)
    }

    /// The attribute of this name, which must be there.
    pub(in crate::describe) fn required(&self, name: &str) -> Result<&Attribute> {
        self.attribute(name)
            .ok_or_else(|| self.error(format!("an attribute {name}=\"...\" was expected")))
    }

    /// The element without attributes and contents.
    pub(in crate::describe) fn bare(&self) -> Self {
        Self {
            name: self.name.clone(),
            attributes: Vec::new(),
            children: Vec::new(),
            spot: self.spot.clone(),
        }
    }

    /// The child elements.
    pub(in crate::describe) fn elements(&self) -> impl Iterator<Item = &Self> {
        self.children.iter().filter_map(|node| match node {
            Node::Element(element) => Some(&**element),
            Node::Text(..) => None,
        })
    }

    /// The first child element of this name.
    pub(in crate::describe) fn child(&self, name: &str) -> Option<&Self> {
        self.elements().find(|element| element.name == name)
    }

    /// An error at the element; the text shows the start tag's name.
    #[cold]
    pub(in crate::describe) fn error(&self, message: impl Into<String>) -> Error {
        let subject = match self.attribute("name") {
            Some(name) => format!("<{} name=\"{}\">", self.name, name.value),
            None => format!("<{}>", self.name),
        };
        self.spot.error(subject, message)
    }
}

/// The root element of a text.
///
/// # Errors
/// What is not well-formed, with its place; a document type (entities are how a small file becomes a huge one);
/// too many or too deeply nested elements.
pub(in crate::describe) fn parse(file_name: &str, text: &str) -> Result<Element> {
    // A byte order mark takes no column.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let source = Rc::new(Source {
        name: file_name.to_owned(),
        text: text.to_owned(),
    });
    check_counts(&source)?;
    let options = ParsingOptions {
        allow_dtd: false,
        nodes_limit: MAX_NODES,
        ..ParsingOptions::default()
    };
    let document =
        Document::parse_with_options(text, options).map_err(|error| syntax(&source, error))?;
    element(&document.root_element(), &source, 0)
}

fn check_counts(source: &Rc<Source>) -> Result<()> {
    let error = |offset, what: &str| {
        let spot = Spot {
            source: Rc::clone(source),
            offset,
        };
        Err(spot.error("", format!("there are more than {MAX_ATTRIBUTES} {what}")))
    };
    if let Some((offset, _)) = source.text.match_indices("xmlns").nth(MAX_ATTRIBUTES) {
        return error(offset, "namespace declarations");
    }
    // No attribute is without two quotes, and none holds a `<`.
    let mut offset = 0;
    for tag in source.text.split('<') {
        let quotes = tag.bytes().filter(|byte| matches!(byte, b'"' | b'\''));
        if tag.len() > 2 * MAX_ATTRIBUTES && quotes.count() > 2 * MAX_ATTRIBUTES {
            return error(offset, "attributes in one tag");
        }
        offset += tag.len() + 1;
    }
    Ok(())
}

#[cold]
fn syntax(source: &Rc<Source>, error: roxmltree::Error) -> Error {
    let at = |offset| Spot {
        source: Rc::clone(source),
        offset,
    };
    match error {
        roxmltree::Error::DtdDetected => {
            let offset = source.text.find("<!DOCTYPE").unwrap_or_default();
            at(offset).error(
                "<!DOCTYPE",
                "document types and their entities are not read",
            )
        }
        roxmltree::Error::NodesLimitReached => {
            at(0).error("", format!("it has more than {MAX_NODES} nodes"))
        }
        roxmltree::Error::NoRootNode => at(0).error("", "no XML element was found"),
        roxmltree::Error::UnclosedRootNode => {
            at(source.text.len()).error("end of file", "the closing tag of the root is missing")
        }
        _ => {
            let position = error.pos();
            let place = Place {
                file: source.name.clone(),
                line: position.row as usize,
                column: position.col as usize,
            };
            // The parser's sentence has the position that our place already names.
            let text = error.to_string();
            let sentence = text.replace(&format!(" at {position}"), "");
            Error::parse(place, "XML", shorten(sentence))
        }
    }
}

fn element(node: &roxmltree::Node<'_, '_>, source: &Rc<Source>, depth: usize) -> Result<Element> {
    let spot = |offset| Spot {
        source: Rc::clone(source),
        offset,
    };
    let start = node.range().start;
    let mut built = Element {
        name: tag_name(&source.text[start..]).to_owned(),
        attributes: declarations(node, source, &spot(start)),
        children: Vec::new(),
        spot: spot(start),
    };
    if depth > MAX_DEPTH {
        return Err(built.error(format!("elements are nested more than {MAX_DEPTH} deep")));
    }
    built
        .attributes
        .extend(node.attributes().map(|attribute| Attribute {
            name: source.text[attribute.range_qname()].to_owned(),
            value: attribute.value().to_owned(),
            spot: spot(attribute.range_value().start),
        }));
    for child in node.children() {
        if child.is_element() {
            let child = element(&child, source, depth + 1)?;
            built.children.push(Node::Element(Rc::new(child)));
        } else if let Some(text) = child.text().filter(|_| child.is_text()) {
            let at = spot(child.range().start);
            built.children.push(Node::Text(text.to_owned(), at));
        }
    }
    Ok(built)
}

/// The name of the start tag that `text` begins with, prefix included.
fn tag_name(text: &str) -> &str {
    let name = text.strip_prefix('<').unwrap_or(text);
    let end = name.find(|c: char| c.is_ascii_whitespace() || c == '/' || c == '>');
    &name[..end.unwrap_or(name.len())]
}

/// The namespace declarations that an element adds to its parent's, as the attributes they are written as.
fn declarations(node: &roxmltree::Node<'_, '_>, source: &Source, spot: &Spot) -> Vec<Attribute> {
    let range = node.range();
    let tag_end = node
        .first_child()
        .map_or(range.end, |child| child.range().start);
    if !source.text[range.start..tag_end].contains("xmlns") {
        return Vec::new();
    }
    let inherited = |space: &roxmltree::Namespace<'_>| {
        node.parent_element()
            .is_some_and(|parent| parent.lookup_namespace_uri(space.name()) == Some(space.uri()))
    };
    node.namespaces()
        .filter(|space| space.name() != Some("xml") && !inherited(space))
        .map(|space| Attribute {
            name: match space.name() {
                Some(prefix) => format!("xmlns:{prefix}"),
                None => "xmlns".to_owned(),
            },
            value: space.uri().to_owned(),
            spot: spot.clone(),
        })
        .collect()
}
