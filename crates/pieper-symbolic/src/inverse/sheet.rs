//! The closed-form inverse as numbered steps for a reader.

use super::{Defined, Inverse, OneUnknown, Rule, Source, Step};
use crate::basis;
use crate::derive::{indexed, text};
use crate::form::{self, Form};
use crate::names::Var;
use crate::poly::Poly;
use crate::sheet::{Block, Inline, words};

/// Writes the steps.
pub(crate) fn write(inverse: &Inverse) -> Vec<Block> {
    let mut writer = Writer {
        inverse,
        blocks: Vec::new(),
    };
    writer.given("a solution of its own");
    writer.steps(&inverse.steps, 0);
    writer.closing();
    writer.blocks
}

/// Writes the steps of which one joint is the beginning, and the equation for it.
pub(crate) fn write_one_unknown(of: &OneUnknown) -> Vec<Block> {
    let mut writer = Writer {
        inverse: &of.inverse,
        blocks: Vec::new(),
    };
    writer.given("a function of its own");
    writer.assumption(of.joint);
    let (before, after) = of.inverse.steps.split_at(of.at);
    writer.steps(before, 1);
    writer.equation(of);
    writer.steps(after, before.len() + 2);
    writer.closing();
    writer.blocks
}

/// Arguments of more letters than this together are written on lines of their own.
const LONG: usize = 80;

struct Writer<'a> {
    inverse: &'a Inverse,
    blocks: Vec<Block>,
}

impl Writer<'_> {
    /// Steps, the first of which has the number behind `before`.
    fn steps(&mut self, steps: &[Step], before: usize) {
        let writer = self;
        for (index, step) in steps.iter().enumerate() {
            let number = before + index + 1;
            match step {
                Step::Define {
                    what: Defined::Known { first, end },
                    quantities,
                } => writer.define(number, (*first, *end), quantities),
                Step::Define {
                    what: Defined::Point { first, end },
                    quantities,
                } => writer.point(number, (*first, *end), quantities),
                Step::Joint {
                    joint,
                    rule,
                    source,
                } => writer.joint(number, *joint, rule, source),
            }
        }
    }

    fn assumption(&mut self, joint: usize) {
        let q = Form::Joint(joint);
        self.heading(2, format!("Step 1: q{} as if it were known", joint + 1));
        self.say(vec![
            text("No equation has a single unknown here. With "),
            Inline::Math(q.clone()),
            text(" taken as known the other joints follow one by one, and an equation is left over that only the right values of "),
            Inline::Math(q),
            text(" satisfy. The steps up to it are a function to be computed for a value from -pi to pi, once for each combination of signs."),
        ]);
    }

    fn equation(&mut self, of: &OneUnknown) {
        let q = Form::Joint(of.joint);
        self.heading(
            2,
            format!("Step {}: the equation for q{}", of.at + 2, of.joint + 1),
        );
        let sentence = self.source(&of.source);
        self.say(sentence);
        let left = self.form(&of.equation);
        self.blocks.push(Block::Equation(left, Form::whole(0)));
        self.say(vec![
            text("Every root counts: look for changes of sign on a fine grid and refine them by bisection or Newton's steps; where two roots lie close together the left side touches zero without a change of sign. `pieper ik` finds all of them by elimination. With a root for "),
            Inline::Math(q),
            text(" the remaining steps are in closed form:"),
        ]);
    }

    fn heading(&mut self, level: u8, text: String) {
        self.blocks.push(Block::Heading(level, text));
    }

    fn say(&mut self, inlines: Vec<Inline>) {
        self.blocks.push(Block::Text(inlines));
    }

    fn form(&self, poly: &Poly) -> Form {
        form::of(
            &self.inverse.names,
            &basis::shortest(&self.inverse.arm, poly),
        )
    }

    fn given(&mut self, of_signs: &str) {
        self.heading(1, "What is given".to_owned());
        let mut rows: Vec<Vec<Form>> = self
            .inverse
            .target
            .iter()
            .map(|row| row.iter().map(|var| Form::Var(*var)).collect())
            .collect();
        rows.push([0, 0, 0, 1].map(Form::whole).to_vec());
        let name = Form::name("T");
        self.blocks.push(Block::Matrix(vec![name], rows));
        let count = self.inverse.most();
        self.say(words(format!(
            "The pose the tool is to take. Below, K is what is known of the product of the rows that are left: T at first. Every +- is a branch; each combination of signs is {of_signs}, {count} at \
             most. Angles are meant in (-pi, pi]."
        )));
        self.heading(1, "The steps".to_owned());
    }

    fn define(&mut self, number: usize, (first, end): (usize, usize), quantities: &[(Var, Poly)]) {
        let count = self.inverse.arm.dof();
        let whole = (first, end) == (0, count);
        let title = match whole {
            true => format!("Step {number}: take base and tool off"),
            false => format!("Step {number}: bring the solved rows over"),
        };
        self.heading(2, title);
        let mut product: Vec<Form> = Vec::new();
        let inverse_of = |name: Form| Form::Inverse(Box::new(name));
        if whole {
            product.extend([
                inverse_of(Form::name("B")),
                Form::name("T"),
                inverse_of(Form::name("E")),
            ]);
        } else {
            product.extend(
                (0..first)
                    .rev()
                    .map(|row| inverse_of(indexed("A", row + 1))),
            );
            product.push(Form::name("T"));
            product.extend(
                (end..count)
                    .rev()
                    .map(|row| inverse_of(indexed("A", row + 1))),
            );
        }
        let left: Vec<Form> = (first..end).map(|row| indexed("A", row + 1)).collect();
        let sentence = vec![
            text("What is left to solve: "),
            Inline::Equality(Form::Product(left), Form::Product(product)),
            text(
                ". Of this known matrix the following entries are needed; the index is row and column:",
            ),
        ];
        self.say(sentence);
        for (var, poly) in quantities {
            let right = self.form(poly);
            self.blocks.push(Block::Equation(Form::Var(*var), right));
        }
    }

    fn point(&mut self, number: usize, (first, end): (usize, usize), quantities: &[(Var, Poly)]) {
        self.heading(2, format!("Step {number}: the origin of frame {}", end - 1));
        self.say(words(format!(
            "The last unsolved joint, q{end}, does not move this point: in the axes of frame {first} it is"
        )));
        for (var, poly) in quantities {
            let right = self.form(poly);
            self.blocks.push(Block::Equation(Form::Var(*var), right));
        }
    }

    fn source(&self, source: &Source) -> Vec<Inline> {
        let (first, end) = source.rows;
        let mut left = Vec::new();
        if source.moved.0 {
            left.push(Form::Inverse(Box::new(indexed("A", first))));
        }
        left.push(Form::name("K"));
        if source.moved.1 {
            left.push(Form::Inverse(Box::new(indexed("A", end + 1))));
        }
        let rows: Vec<Form> = (first..end).map(|row| indexed("A", row + 1)).collect();
        let rows = if rows.is_empty() {
            Form::whole(1)
        } else {
            Form::Product(rows)
        };
        let entries: Vec<String> = source
            .entries
            .iter()
            .map(|(row, column)| format!("({},{})", row + 1, column + 1))
            .collect();
        let list = match entries.split_last() {
            Some((last, rest)) if !rest.is_empty() => {
                format!("entries {} and {last}", rest.join(", "))
            }
            _ => format!("entry {}", entries.join("")),
        };
        let what = match source.squares {
            true => format!("The squares of {list} added up, known parts on one side, in"),
            false => format!("From {list} of"),
        };
        vec![
            text(format!("{what} ")),
            Inline::Equality(Form::Product(left), rows),
            text(":"),
        ]
    }

    fn joint(&mut self, number: usize, joint: usize, rule: &Rule, source: &Source) {
        let q = Form::Joint(joint);
        self.heading(2, format!("Step {number}: q{}", joint + 1));
        let sentence = self.source(source);
        self.say(sentence);
        match rule {
            Rule::Two {
                a,
                b,
                k,
                sine_square,
            } => self.two(joint, [a, b, k], sine_square.as_ref()),
            Rule::One { sin, cos } => {
                let width = |poly: &Poly| {
                    let form = self.form(poly);
                    crate::print::text(&form, &self.inverse.names)
                        .chars()
                        .count()
                };
                let most = match width(sin) + width(cos) > LONG {
                    true => 1,
                    false => usize::MAX,
                };
                let arguments = [("Y", sin), ("X", cos)]
                    .map(|(name, poly)| self.named(name, joint, poly, most))
                    .to_vec();
                self.blocks
                    .push(Block::Equation(q.clone(), Form::Call("atan2", arguments)));
                let may_vanish = sin.constant().is_none() && cos.constant().is_none();
                if may_vanish && !self.is_unit(sin, cos) {
                    self.say(vec![
                        text("Degenerate case: where both arguments are 0, any "),
                        Inline::Math(q),
                        text(" will do: choose it, for instance as it was before; the next steps give what goes with it."),
                    ]);
                }
            }
            Rule::Slide { above, below } => {
                let right = match below.constant() {
                    Some(value) => self.form(&above.scaled(&(crate::number::whole(1) / value))),
                    None => self.form(above).over(self.form(below)),
                };
                self.blocks.push(Block::Equation(q, right));
            }
            Rule::Square { coefficients } => {
                let [c, b, a] = coefficients.each_ref().map(|poly| self.form(poly));
                for (name, form) in [("K_2", a), ("K_1", b), ("K_0", c)] {
                    self.blocks.push(Block::Equation(Form::name(name), form));
                }
                let four =
                    Form::Product(vec![Form::whole(4), Form::name("K_2"), Form::name("K_0")]);
                let square = Form::Power(Box::new(Form::name("K_1")), 2);
                let root = Form::Sum(vec![square, Form::Neg(Box::new(four))]).root();
                let above = Form::Neg(Box::new(Form::name("K_1"))).plus_minus(root);
                let below = Form::Product(vec![Form::whole(2), Form::name("K_2")]);
                self.blocks.push(Block::Equation(q, above.over(below)));
            }
        }
    }

    /// A polynomial, by a name of its own where it has more than so many terms.
    fn named(&mut self, name: &str, joint: usize, poly: &Poly, most: usize) -> Form {
        if poly.terms().len() <= most {
            return self.form(poly);
        }
        let name = Form::Name(format!("{name}_{}", joint + 1));
        let right = self.form(poly);
        self.blocks.push(Block::Equation(name.clone(), right));
        name
    }

    fn two(&mut self, joint: usize, [a, b, k]: [&Poly; 3], sine_square: Option<&Poly>) {
        let q = Form::Joint(joint);
        let angle = self.inverse.arm.joint_angle(joint);
        let (sin, cos) = match angle {
            Some(angle) => (Form::Var(angle.sin()), Form::Var(angle.cos())),
            None => return,
        };
        if let Some(square) = sine_square {
            self.blocks.push(Block::Equation(cos, self.form(k)));
            let arguments = vec![self.form(square).root(), self.form(k)];
            self.blocks.push(Block::Equation(
                q.clone(),
                Form::PlusMinus(
                    Box::new(Form::Sum(Vec::new())),
                    Box::new(Form::Call("atan2", arguments)),
                ),
            ));
            self.say(vec![
                text("The sine's square is written with the other entries of its line, which keeps its digits where the cosine loses them. Degenerate case: "),
                Inline::Equality(sin, Form::whole(0)),
                text(" merges the branches, and the axes on both sides of this joint are in line."),
            ]);
            return;
        }
        if b.is_zero() && a.terms().len() == 1 {
            return self.cosine(q, cos, a, k);
        }
        let (x, y, w) = (
            self.named("X", joint, a, 1),
            self.named("Y", joint, b, 1),
            self.named("W", joint, k, 1),
        );
        let term = |factor: &Form, of: Form| match factor {
            Form::Number(value) if *value == crate::number::whole(1) => of,
            Form::Neg(inner) => Form::Neg(Box::new(Form::Product(vec![(**inner).clone(), of]))),
            factor => Form::Product(vec![factor.clone(), of]),
        };
        let mut left = Vec::new();
        if !a.is_zero() {
            left.push(term(&x, cos));
        }
        if !b.is_zero() {
            left.push(term(&y, sin));
        }
        let left = if left.len() == 1 {
            left.remove(0)
        } else {
            Form::Sum(left)
        };
        self.blocks.push(Block::Equation(left, w.clone()));
        let square = |form: &Form| {
            // The sign of what is squared does not matter.
            let inner = if let Form::Neg(inner) = form {
                inner.clone()
            } else {
                Box::new(form.clone())
            };
            Form::Power(inner, 2)
        };
        let mut radius: Vec<Form> = Vec::new();
        if !a.is_zero() {
            radius.push(square(&x));
        }
        if !b.is_zero() {
            radius.push(square(&y));
        }
        if !k.is_zero() {
            radius.push(Form::Neg(Box::new(square(&w))));
        }
        let root = if radius.len() == 1 {
            radius.remove(0)
        } else {
            Form::Sum(radius)
        };
        let middle = Form::Call("atan2", vec![y.clone(), x.clone()]);
        let half = match k.is_zero() {
            true => Form::name("pi").over(Form::whole(2)),
            false => Form::Call("atan2", vec![root.clone().root(), w]),
        };
        self.blocks
            .push(Block::Equation(q.clone(), middle.plus_minus(half)));
        let mut sentence = Vec::new();
        if !k.is_zero() {
            sentence.push(text("Out of reach where the root's argument is negative; the branches merge where it is 0. "));
        }
        if a.constant().is_none() || b.constant().is_none() {
            sentence.push(text("Degenerate case: "));
            let zero = [(a, &x), (b, &y)]
                .into_iter()
                .filter(|(poly, _)| !poly.is_zero());
            for (index, (_, form)) in zero.enumerate() {
                if index > 0 {
                    sentence.push(text(" and "));
                }
                let inner = if let Form::Neg(inner) = form {
                    (**inner).clone()
                } else {
                    form.clone()
                };
                sentence.push(Inline::Equality(inner, Form::whole(0)));
            }
            sentence.push(text(": then any "));
            sentence.push(Inline::Math(q));
            sentence.push(text(" will do, if it is reached at all."));
        }
        if !sentence.is_empty() {
            self.say(sentence);
        }
    }

    /// `a cos q = k` with a product of lengths for a.
    fn cosine(&mut self, q: Form, cos: Form, a: &Poly, k: &Poly) {
        let value = self.form(k);
        let value = if *a == Poly::one() {
            value
        } else {
            value.over(self.form(a))
        };
        self.blocks.push(Block::Equation(cos.clone(), value));
        let square = Form::Neg(Box::new(Form::Power(Box::new(cos.clone()), 2)));
        let root = Form::Sum(vec![Form::whole(1), square]).root();
        let call = Form::Call("atan2", vec![root, cos.clone()]);
        let nothing = Box::new(Form::Sum(Vec::new()));
        self.blocks
            .push(Block::Equation(q, Form::PlusMinus(nothing, Box::new(call))));
        self.say(vec![
            text("Out of reach where the square of "),
            Inline::Math(cos),
            text(" is more than 1; the branches merge where it is 1, with the arm stretched or folded."),
        ]);
    }

    /// Whether sine and cosine are entries of a rotation with nothing between: they cannot vanish together.
    fn is_unit(&self, sin: &Poly, cos: &Poly) -> bool {
        let single = |poly: &Poly| matches!(poly.terms(), [term] if term.monomial.degree() == 1);
        let steps = self.inverse.steps.len();
        let last = matches!(self.inverse.steps.get(steps - 1), Some(Step::Joint { rule: Rule::One { sin: s, cos: c }, .. }) if s == sin && c == cos);
        last && (single(sin) || single(cos))
    }

    fn closing(&mut self) {
        self.heading(1, "To be sure".to_owned());
        self.say(words(
            "Put each solution back into the forward formulas: an arm with fewer than six joints reaches only some poses, and \
             the steps use only as many equations as they need.",
        ));
    }
}
