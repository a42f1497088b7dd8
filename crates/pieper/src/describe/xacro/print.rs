//! Elements as text.

use crate::describe::urdf::escape;
use crate::describe::urdf::xml::{Element, Node};

/// The document of this root, indented by two spaces for each level.
pub(super) fn document(root: &Element) -> String {
    let mut out = String::from("<?xml version=\"1.0\"?>\n");
    element(root, 0, &mut out);
    out
}

fn element(element: &Element, depth: usize, out: &mut String) {
    let indent = |out: &mut String, depth| out.extend(std::iter::repeat_n("  ", depth));
    indent(out, depth);
    out.push('<');
    out.push_str(&element.name);
    for attribute in &element.attributes {
        out.push(' ');
        out.push_str(&attribute.name);
        out.push_str("=\"");
        out.push_str(&escape(&attribute.value));
        out.push('"');
    }
    if element.children.is_empty() {
        out.push_str("/>\n");
        return;
    }
    out.push('>');
    // Text alone stays on the line: spaces around it would become part of it.
    let has_elements = element.elements().next().is_some();
    if has_elements {
        out.push('\n');
    }
    for child in &element.children {
        match child {
            Node::Element(child) => self::element(child, depth + 1, out),
            Node::Text(text, _) if !has_elements => out.push_str(&escape(text)),
            Node::Text(text, _) => {
                indent(out, depth + 1);
                out.push_str(&escape(text.trim()));
                out.push('\n');
            }
        }
    }
    if has_elements {
        indent(out, depth);
    }
    out.push_str("</");
    out.push_str(&element.name);
    out.push_str(">\n");
}
