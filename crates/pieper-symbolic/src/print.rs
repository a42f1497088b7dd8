//! Formulas as text, as LaTeX and as MathML.

use crate::form::Form;
use crate::names::{Angle, AngleMeaning, Names, VarKind};
use crate::number;

/// A formula in plain notation: `c1*(c4*c6 - s4*c5*s6)`; what `pieper check` reads.
pub fn text(form: &Form, names: &Names) -> String {
    Plain { names }.form(form)
}

/// A formula in LaTeX's mathematics.
pub fn latex(form: &Form, names: &Names) -> String {
    Latex { names }.form(form)
}

/// A formula as the children of a `<math>` element.
pub fn mathml(form: &Form, names: &Names) -> String {
    MathMl { names }.form(form)
}

/// How tightly a formula binds.
fn binding(form: &Form) -> u8 {
    match form {
        Form::Sum(terms) if terms.len() > 1 => 0,
        Form::PlusMinus(..) => 0,
        Form::Neg(_) => 1,
        Form::Product(factors) if factors.len() > 1 => 2,
        Form::Quotient(..) => 2,
        Form::Number(value) if !value.is_int() => 2,
        _ => 3,
    }
}

/// One notation: how the leaves and the operators look.
trait Notation {
    fn leaf(&self, form: &Form) -> String;
    fn power(&self, base: String, exponent: u32) -> String;
    fn quotient(&self, above: &Form, below: &Form) -> String;
    fn inverse(&self, inner: String) -> String;
    fn root(&self, inner: String) -> String;
    fn call(&self, name: &str, arguments: Vec<String>) -> String;
    fn parenthesised(&self, inner: String) -> String;
    /// minus as a sign, plus, minus, plus-minus, times
    fn operators(&self) -> [&'static str; 5];

    fn inside(&self, form: &Form, at_least: u8) -> String {
        let inner = self.form(form);
        if binding(form) < at_least {
            self.parenthesised(inner)
        } else {
            inner
        }
    }

    fn form(&self, form: &Form) -> String {
        let [sign, plus, minus, plus_minus, times] = self.operators();
        match form {
            Form::Neg(inner) => format!("{sign}{}", self.inside(inner, 2)),
            Form::Sum(terms) => {
                let mut out = String::new();
                for (index, term) in terms.iter().enumerate() {
                    match (index, term) {
                        (0, term) => out.push_str(&self.form(term)),
                        (_, Form::Neg(inner)) => {
                            out.push_str(minus);
                            out.push_str(&self.inside(inner, 1));
                        }
                        (_, term) => {
                            out.push_str(plus);
                            out.push_str(&self.inside(term, 1));
                        }
                    }
                }
                out
            }
            // Nothing in front: both signs of b.
            Form::PlusMinus(a, b) if matches!(&**a, Form::Sum(terms) if terms.is_empty()) => {
                format!("{}{}", plus_minus.trim(), self.inside(b, 2))
            }
            Form::PlusMinus(a, b) => {
                format!("{}{plus_minus}{}", self.inside(a, 0), self.inside(b, 1))
            }
            Form::Product(factors) => {
                let factors: Vec<String> = factors
                    .iter()
                    .map(|factor| self.inside(factor, 2))
                    .collect();
                factors.join(times)
            }
            Form::Power(base, exponent) => self.power(self.inside(base, 3), *exponent),
            Form::Quotient(above, below) => self.quotient(above, below),
            Form::Inverse(inner) => self.inverse(self.inside(inner, 3)),
            Form::Root(inner) => self.root(self.form(inner)),
            Form::Call(name, arguments) => {
                let arguments = arguments
                    .iter()
                    .map(|argument| self.form(argument))
                    .collect();
                self.call(name, arguments)
            }
            leaf => self.leaf(leaf),
        }
    }
}

/// The index of an angle's shorthand: `23` for q2 - q3; underscores where joints have two digits.
pub(crate) fn index_of(names: &Names, angle: Angle) -> Option<String> {
    match names.meaning(angle) {
        AngleMeaning::Joint(joint) => Some((joint + 1).to_string()),
        AngleMeaning::Sum(sum) => {
            let digits: Vec<String> = sum
                .iter()
                .map(|(joint, _)| (joint + 1).to_string())
                .collect();
            let separator = if digits.iter().any(|one| one.len() > 1) {
                "_"
            } else {
                ""
            };
            Some(digits.join(separator))
        }
        AngleMeaning::Parameter(_) | AngleMeaning::Constant(..) => None,
    }
}

struct Plain<'a> {
    names: &'a Names,
}

impl Notation for Plain<'_> {
    fn leaf(&self, form: &Form) -> String {
        match form {
            Form::Number(value) => number::text(value),
            Form::Var(var) => match var.kind() {
                VarKind::Sin(angle) | VarKind::Cos(angle) => {
                    let is_sin = matches!(var.kind(), VarKind::Sin(_));
                    match (index_of(self.names, angle), self.names.meaning(angle)) {
                        (Some(index), _) => format!("{}{index}", if is_sin { "s" } else { "c" }),
                        (_, AngleMeaning::Parameter(name) | AngleMeaning::Constant(name, _)) => {
                            format!("{}({name})", if is_sin { "sin" } else { "cos" })
                        }
                        _ => String::new(),
                    }
                }
                VarKind::Root(square) => format!("sqrt({square})"),
                VarKind::Symbol(_) => self.names.name(*var).to_owned(),
            },
            Form::Joint(joint) => format!("q{}", joint + 1),
            Form::Name(name) => name.clone(),
            Form::Entry(name, row, column) => format!("{name}{row}{column}"),
            _ => String::new(),
        }
    }

    fn power(&self, base: String, exponent: u32) -> String {
        format!("{base}^{exponent}")
    }

    fn quotient(&self, above: &Form, below: &Form) -> String {
        format!("{}/{}", self.inside(above, 2), self.inside(below, 3))
    }

    fn inverse(&self, inner: String) -> String {
        format!("{inner}^-1")
    }

    fn root(&self, inner: String) -> String {
        format!("sqrt({inner})")
    }

    fn call(&self, name: &str, arguments: Vec<String>) -> String {
        format!("{name}({})", arguments.join(", "))
    }

    fn parenthesised(&self, inner: String) -> String {
        format!("({inner})")
    }

    fn operators(&self) -> [&'static str; 5] {
        ["-", " + ", " - ", " +- ", "*"]
    }
}

/// A name taken apart: its letters and its index.
pub(crate) fn split_name(name: &str) -> (&str, &str) {
    if let Some((base, index)) = name
        .split_once('_')
        .filter(|(base, index)| !base.is_empty() && !index.is_empty())
    {
        return (base, index);
    }
    let letters = name
        .find(|c: char| c.is_ascii_digit())
        .unwrap_or(name.len());
    name.split_at(letters)
}

/// Greek letters by their names.
const GREEK: [(&str, char); 24] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("varphi", 'φ'),
];

fn greek(name: &str) -> Option<char> {
    GREEK
        .iter()
        .find(|(known, _)| *known == name)
        .map(|(_, letter)| *letter)
}

/// A name in LaTeX: `a_{1}`, `\delta`, `\mathrm{len}_{2}`.
pub fn latex_name(name: &str) -> String {
    let (base, index) = split_name(name);
    let escaped = |text: &str| text.replace('_', "\\_");
    let base = match greek(base) {
        Some(_) => format!("\\{base}"),
        None if base.chars().count() <= 1 => base.to_owned(),
        None => format!("\\mathrm{{{}}}", escaped(base)),
    };
    match index {
        "" => base,
        index if index.chars().count() > 1 && !index.bytes().all(|b| b.is_ascii_digit()) => {
            format!("{base}_{{\\mathrm{{{}}}}}", escaped(index))
        }
        index => format!("{base}_{{{index}}}"),
    }
}

struct Latex<'a> {
    names: &'a Names,
}

impl Notation for Latex<'_> {
    fn leaf(&self, form: &Form) -> String {
        match form {
            Form::Number(value) if value.is_int() => value.to_string(),
            Form::Number(value) => match number::text(value).split_once('/') {
                Some((above, below)) => format!("\\tfrac{{{above}}}{{{below}}}"),
                None => number::text(value),
            },
            Form::Var(var) => match var.kind() {
                VarKind::Sin(angle) | VarKind::Cos(angle) => {
                    let is_sin = matches!(var.kind(), VarKind::Sin(_));
                    match (index_of(self.names, angle), self.names.meaning(angle)) {
                        (Some(index), _) => {
                            let index = index.replace('_', ",");
                            format!("{}_{{{index}}}", if is_sin { "s" } else { "c" })
                        }
                        (_, AngleMeaning::Parameter(name)) => {
                            format!(
                                "{}{}",
                                if is_sin { "\\sin " } else { "\\cos " },
                                latex_name(name)
                            )
                        }
                        (_, AngleMeaning::Constant(text, _)) => {
                            let text = text.replace("*pi", "\\pi").replace('*', "\\,");
                            format!("{}({text})", if is_sin { "\\sin" } else { "\\cos" })
                        }
                        _ => String::new(),
                    }
                }
                VarKind::Root(square) => format!("\\sqrt{{{square}}}"),
                VarKind::Symbol(_) => latex_name(self.names.name(*var)),
            },
            Form::Joint(joint) => format!("q_{{{}}}", joint + 1),
            Form::Name(name) => latex_name(name),
            Form::Entry(name, row, column) => format!("{name}_{{{row}{column}}}"),
            _ => String::new(),
        }
    }

    fn power(&self, base: String, exponent: u32) -> String {
        format!("{base}^{{{exponent}}}")
    }

    fn quotient(&self, above: &Form, below: &Form) -> String {
        format!("\\frac{{{}}}{{{}}}", self.form(above), self.form(below))
    }

    fn inverse(&self, inner: String) -> String {
        format!("{inner}^{{-1}}")
    }

    fn root(&self, inner: String) -> String {
        format!("\\sqrt{{{inner}}}")
    }

    fn call(&self, name: &str, arguments: Vec<String>) -> String {
        let name = if name == "atan2" {
            "\\operatorname{atan2}".to_owned()
        } else {
            format!("\\{name}")
        };
        match &arguments[..] {
            [one] if is_name(one) => format!("{name} {one}"),
            _ => format!("{name}\\left({}\\right)", arguments.join(",\\, ")),
        }
    }

    // Plain parentheses: \left and \right would forbid the line breaks a long formula needs.
    fn parenthesised(&self, inner: String) -> String {
        format!("({inner})")
    }

    fn operators(&self) -> [&'static str; 5] {
        ["-", " + ", " - ", " \\pm ", "\\,"]
    }
}

/// Whether LaTeX text is one letter, Latin or Greek.
fn is_name(text: &str) -> bool {
    let word = text.strip_prefix('\\').unwrap_or(text);
    word.len() == 1
        || (text.starts_with('\\') && word.bytes().all(|byte| byte.is_ascii_alphabetic()))
}

struct MathMl<'a> {
    names: &'a Names,
}

/// A name as MathML.
pub fn mathml_name(name: &str) -> String {
    let (base, index) = split_name(name);
    let base = greek(base).map_or_else(|| escape(base), String::from);
    match index {
        "" => format!("<mi>{base}</mi>"),
        index => subscript(&format!("<mi>{base}</mi>"), &escape(index)),
    }
}

fn subscript(base: &str, index: &str) -> String {
    let tag = if index.bytes().all(|byte| byte.is_ascii_digit()) {
        "mn"
    } else {
        "mi"
    };
    format!("<msub>{base}<{tag}>{index}</{tag}></msub>")
}

/// Text safe inside XML.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

impl Notation for MathMl<'_> {
    fn leaf(&self, form: &Form) -> String {
        match form {
            Form::Number(value) if value.is_int() => format!("<mn>{value}</mn>"),
            Form::Number(value) => match number::text(value).split_once('/') {
                Some((above, below)) => format!("<mfrac><mn>{above}</mn><mn>{below}</mn></mfrac>"),
                None => format!("<mn>{}</mn>", number::text(value)),
            },
            Form::Var(var) => match var.kind() {
                VarKind::Sin(angle) | VarKind::Cos(angle) => {
                    let is_sin = matches!(var.kind(), VarKind::Sin(_));
                    match (index_of(self.names, angle), self.names.meaning(angle)) {
                        (Some(index), _) => {
                            subscript(if is_sin { "<mi>s</mi>" } else { "<mi>c</mi>" }, &index)
                        }
                        (_, AngleMeaning::Parameter(name)) => {
                            let function = if is_sin { "sin" } else { "cos" };
                            format!(
                                "<mrow><mi>{function}</mi><mo>&#8289;</mo>{}</mrow>",
                                mathml_name(name)
                            )
                        }
                        (_, AngleMeaning::Constant(text, _)) => {
                            let function = if is_sin { "sin" } else { "cos" };
                            let text = escape(&text.replace("*pi", "π").replace('*', " "));
                            format!(
                                "<mrow><mi>{function}</mi><mo>(</mo><mtext>{text}</mtext><mo>)</mo></mrow>"
                            )
                        }
                        _ => String::new(),
                    }
                }
                VarKind::Root(square) => format!("<msqrt><mn>{square}</mn></msqrt>"),
                VarKind::Symbol(_) => mathml_name(self.names.name(*var)),
            },
            Form::Joint(joint) => subscript("<mi>q</mi>", &(joint + 1).to_string()),
            Form::Name(name) => mathml_name(name),
            Form::Entry(name, row, column) => subscript(
                &format!("<mi>{}</mi>", escape(name)),
                &format!("{row}{column}"),
            ),
            _ => String::new(),
        }
    }

    fn power(&self, base: String, exponent: u32) -> String {
        format!("<msup><mrow>{base}</mrow><mn>{exponent}</mn></msup>")
    }

    fn quotient(&self, above: &Form, below: &Form) -> String {
        format!(
            "<mfrac><mrow>{}</mrow><mrow>{}</mrow></mfrac>",
            self.form(above),
            self.form(below)
        )
    }

    fn inverse(&self, inner: String) -> String {
        format!(
            "<msup><mrow>{inner}</mrow><mrow><mo form=\"prefix\">&#8722;</mo><mn>1</mn></mrow></msup>"
        )
    }

    fn root(&self, inner: String) -> String {
        format!("<msqrt>{inner}</msqrt>")
    }

    fn call(&self, name: &str, arguments: Vec<String>) -> String {
        let name = format!("<mspace width=\"0.17em\"/><mi>{name}</mi><mo>&#8289;</mo>");
        match &arguments[..] {
            [one] if one.matches("<mi>").count() == 1 && !one.contains("<mo") => {
                format!("{name}<mspace width=\"0.17em\"/>{one}")
            }
            _ => format!("{name}<mo>(</mo>{}<mo>)</mo>", arguments.join("<mo>,</mo>")),
        }
    }

    fn parenthesised(&self, inner: String) -> String {
        format!("<mo>(</mo>{inner}<mo>)</mo>")
    }

    fn operators(&self) -> [&'static str; 5] {
        [
            "<mo form=\"prefix\">&#8722;</mo>",
            "<mo>+</mo>",
            "<mo>&#8722;</mo>",
            "<mo>&#177;</mo>",
            "<mo>&#8290;</mo>",
        ]
    }
}
