//! The step sheet of an arm: from its table to the formulas of its pose and its Jacobian.

use pieper::Result;
use pieper::describe::{Convention, Expr};

use crate::arm::Arm;
use crate::basis::{self, Basis};
use crate::determinant::{Determinant, determinant};
use crate::form::{self, Form};
use crate::inverse::{self, OneUnknown};
use crate::jacobian;
use crate::names::{AngleMeaning, Names, SymbolMeaning, VarKind};
use crate::number;
use crate::poly::Poly;
use crate::sheet::{Block, Inline, Sheet, fits, words};
use crate::transform::Transform;

/// What a step sheet holds beyond the pose and the Jacobian.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// The forward way: table, matrices, pose, Jacobian, singular configurations.
    Forward,
    /// The inverse way alone, as numbered steps.
    Inverse,
}

/// The step sheet of an arm.
///
/// # Errors
/// A model error if a formula outgrows [`MAX_TERMS`](crate::poly::MAX_TERMS); for the inverse way one that says why
/// there is no closed form, and what exists instead.
///
/// ```
/// use pieper_symbolic::sheet::Format;
/// use pieper_symbolic::{Arm, Lengths, derive};
/// let robot = pieper_robots::find("cobra600").unwrap().robot();
/// let sheet = derive::sheet(&Arm::new(&robot, Lengths::Symbols)?, derive::Scope::Forward)?;
/// assert!(sheet.print(Format::Text).contains("t14 = a1*c1 + a2*c12"));
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn sheet(arm: &Arm, scope: Scope) -> Result<Sheet> {
    let mut writer = Writer {
        arm,
        sums: basis::cumulative(arm),
        blocks: Vec::new(),
    };
    // An arm that swells is told so before anything of it is grouped for print.
    arm.tool_pose()?;
    writer.notation();
    let title = match scope {
        Scope::Forward => {
            writer.table();
            writer.links();
            writer.products()?;
            writer.pose()?;
            writer.jacobian()?;
            "forward kinematics"
        }
        Scope::Inverse => {
            let (steps, names) = inverse_steps(arm)?;
            writer.table();
            return Ok(Sheet {
                title: format!("{}: inverse kinematics", arm.title),
                names,
                blocks: [writer.blocks, steps].concat(),
            });
        }
    };
    let blocks = writer.blocks;
    Ok(Sheet {
        title: format!("{}: {title}", arm.title),
        names: arm.names.clone(),
        blocks,
    })
}

/// The closed form, or else the equation with one unknown.
fn inverse_steps(arm: &Arm) -> Result<(Vec<Block>, Names)> {
    let closed = match inverse::derive(arm) {
        Ok(inverse) => return Ok((inverse::write(&inverse), inverse.names)),
        Err(error) => error,
    };
    match OneUnknown::derive(arm) {
        Ok(found) => Ok((inverse::write_one_unknown(&found), found.inverse.names)),
        // Why there is no closed form says more than why this fails too.
        Err(_) => Err(closed),
    }
}

pub(crate) struct Writer<'a> {
    pub(crate) arm: &'a Arm,
    sums: Basis,
    pub(crate) blocks: Vec<Block>,
}

pub(crate) fn text(text: impl Into<String>) -> Inline {
    Inline::Text(text.into())
}

/// A name with an index: `A_3`.
pub(crate) fn indexed(base: &str, index: usize) -> Form {
    Form::Name(format!("{base}_{index}"))
}

impl Writer<'_> {
    pub(crate) fn heading(&mut self, level: u8, text: impl Into<String>) {
        self.blocks.push(Block::Heading(level, text.into()));
    }

    pub(crate) fn say(&mut self, inlines: Vec<Inline>) {
        self.blocks.push(Block::Text(inlines));
    }

    /// In sums of parallel angles where that is shorter.
    pub(crate) fn form(&self, poly: &Poly) -> Form {
        let sums = self.sums.rewrite(poly);
        let is_shorter = sums.terms().len() <= poly.terms().len();
        form::of(&self.arm.names, if is_shorter { &sums } else { poly })
    }

    fn notation(&mut self) {
        let mut sentence = vec![
            text("Notation: "),
            Inline::Math(Form::name("s_i")),
            text(" and "),
            Inline::Math(Form::name("c_i")),
            text(" are the sine and cosine of "),
            Inline::Math(Form::name("q_i")),
        ];
        let sums: Vec<_> = self
            .arm
            .parallel
            .iter()
            .flat_map(|run| (2..=run.len()).map(|end| run[..end].to_vec()))
            .collect();
        for sum in &sums {
            let Some(angle) = self.arm.names.find_angle(&AngleMeaning::Sum(sum.clone())) else {
                continue;
            };
            sentence.push(text("; "));
            sentence.push(Inline::Math(Form::Var(angle.sin())));
            sentence.push(text(" and "));
            sentence.push(Inline::Math(Form::Var(angle.cos())));
            sentence.push(text(" those of "));
            sentence.push(Inline::Math(Form::joints(sum)));
        }
        sentence.push(text(if sums.is_empty() {
            "."
        } else {
            " (parallel axes: their angles add up)."
        }));
        self.say(sentence);
        let known: Vec<(String, f64)> = self
            .arm
            .names
            .symbols()
            .filter(|(_, _, meaning)| {
                matches!(
                    meaning,
                    SymbolMeaning::Parameter | SymbolMeaning::Formula(_)
                )
            })
            .map(|(_, name, _)| (name.to_owned(), self.arm.parameter(name)))
            .chain(
                self.arm
                    .names
                    .angles()
                    .filter_map(|(_, meaning)| match meaning {
                        AngleMeaning::Parameter(name) => {
                            Some((name.clone(), self.arm.parameter(name)))
                        }
                        _ => None,
                    }),
            )
            .collect();
        if known.is_empty() {
            return;
        }
        let mut sentence = vec![text("Named lengths and angles (metres, radians): ")];
        for (index, (name, value)) in known.into_iter().enumerate() {
            if index > 0 {
                sentence.push(text(", "));
            }
            sentence.push(match number::of_f64(value) {
                Some(value) => Inline::Equality(Form::Name(name), Form::number(&value)),
                None => Inline::Math(Form::Name(name)),
            });
        }
        sentence.push(text("."));
        self.say(sentence);
    }

    fn table(&mut self) {
        self.heading(1, "The table");
        let convention = match self.arm.convention {
            Convention::Standard => {
                "Denavit-Hartenberg, standard (distal): A = Rz(theta) Tz(d) Tx(a) Rx(alpha)."
            }
            Convention::Modified => {
                "Denavit-Hartenberg, modified (Craig): A = Rx(alpha) Tx(a) Rz(theta) Tz(d)."
            }
        };
        self.say(words(convention));
        if self.arm.computed_table {
            self.say(words("The arm was not described by a table; this one was computed from its links, as numbers."));
        }
        let head = ["i", "theta", "d", "a", "alpha"].map(Form::name).to_vec();
        let rows = self.arm.printed.iter().enumerate().map(|(index, row)| {
            let cells = row.iter().map(|cell| {
                Expr::parse(cell).map_or_else(|_| Form::name(cell), |expr| of_expr(&expr))
            });
            std::iter::once(Form::whole(index as i64 + 1))
                .chain(cells)
                .collect()
        });
        let rows = rows.collect();
        self.blocks.push(Block::Table(head, rows));
    }

    fn matrix(&mut self, left: Vec<Form>, transform: &Transform) {
        let rows: Vec<Vec<Form>> = (0..4)
            .map(|row| {
                (0..4)
                    .map(|column| self.form(&transform.entry(row, column)))
                    .collect()
            })
            .collect();
        if fits(&rows, &self.arm.names) {
            self.blocks.push(Block::Matrix(left, rows));
            return;
        }
        let Some(name) = left.first().cloned() else {
            return;
        };
        let mut sentence = vec![Inline::Math(name)];
        left.into_iter()
            .skip(1)
            .for_each(|form| sentence.extend([text(" = "), Inline::Math(form)]));
        sentence.push(text(", entry by entry ("));
        sentence.push(Inline::Math(Form::Entry("t".to_owned(), 1, 1)));
        sentence.push(text(" is in row 1, column 1; the last row is 0 0 0 1):"));
        self.say(sentence);
        for column in 0..4 {
            for row in 0..3 {
                let entry = Form::Entry("t".to_owned(), row + 1, column + 1);
                self.blocks
                    .push(Block::Equation(entry, rows[row][column].clone()));
            }
        }
    }

    fn links(&mut self) {
        self.heading(1, "The rows' matrices");
        let (sin, cos) = (
            |name| Form::Call("sin", vec![Form::name(name)]),
            |name| Form::Call("cos", vec![Form::name(name)]),
        );
        let (a, d) = (Form::name("a"), Form::name("d"));
        let product = |x: Form, y: Form| Form::Product(vec![x, y]);
        let minus = |x: Form| Form::Neg(Box::new(x));
        let zero = || Form::whole(0);
        let rows = match self.arm.convention {
            Convention::Standard => vec![
                vec![
                    cos("theta"),
                    minus(product(sin("theta"), cos("alpha"))),
                    product(sin("theta"), sin("alpha")),
                    product(a.clone(), cos("theta")),
                ],
                vec![
                    sin("theta"),
                    product(cos("theta"), cos("alpha")),
                    minus(product(cos("theta"), sin("alpha"))),
                    product(a, sin("theta")),
                ],
                vec![zero(), sin("alpha"), cos("alpha"), d],
            ],
            Convention::Modified => vec![
                vec![cos("theta"), minus(sin("theta")), zero(), a],
                vec![
                    product(sin("theta"), cos("alpha")),
                    product(cos("theta"), cos("alpha")),
                    minus(sin("alpha")),
                    minus(product(d.clone(), sin("alpha"))),
                ],
                vec![
                    product(sin("theta"), sin("alpha")),
                    product(cos("theta"), sin("alpha")),
                    cos("alpha"),
                    product(d, cos("alpha")),
                ],
            ],
        };
        self.say(words("Every row of the table goes into one template:"));
        let last = vec![zero(), zero(), zero(), Form::whole(1)];
        self.blocks.push(Block::Matrix(
            vec![Form::name("A")],
            [rows, vec![last]].concat(),
        ));
        self.say(words("Row by row:"));
        for index in 0..self.arm.dof() {
            self.matrix(vec![indexed("A", index + 1)], &self.arm.link(index));
        }
    }

    fn products(&mut self) -> Result<()> {
        let count = self.arm.dof();
        if count < 3 {
            return Ok(());
        }
        self.heading(1, "The partial products");
        for end in 2..count {
            let product = self.arm.product(0, end);
            self.arm.not_swollen(product.is_swollen())?;
            let factors = (1..=end).map(|index| indexed("A", index)).collect();
            self.matrix(vec![indexed("T", end), Form::Product(factors)], &product);
        }
        Ok(())
    }

    fn pose(&mut self) -> Result<()> {
        let count = self.arm.dof();
        self.heading(1, "The tool's pose");
        let mut factors: Vec<Form> = (1..=count).map(|index| indexed("A", index)).collect();
        if let Some(base) = self.arm.base.clone() {
            self.say(words("The arm stands on a base of its own:"));
            self.matrix(vec![Form::name("B")], &base);
            factors.insert(0, Form::name("B"));
        }
        if let Some(tool) = self.arm.tool.clone() {
            self.say(words("A tool is fixed behind the last row:"));
            self.matrix(vec![Form::name("E")], &tool);
            factors.push(Form::name("E"));
        }
        let pose = self.arm.tool_pose()?;
        self.say(vec![
            Inline::Equality(Form::name("T"), Form::Product(factors)),
            text(", entry by entry. The first three columns are the direction cosines: "),
            Inline::Math(Form::name("t_ij")),
            text(" is the cosine of the angle between axis i of the base and axis j of the tool."),
        ]);
        let columns = [
            "n, the tool's x axis seen from the base",
            "s, the tool's y axis",
            "a, the tool's z axis",
            "p, the tool's point (x, y, z)",
        ];
        for (column, meaning) in columns.iter().enumerate() {
            self.heading(2, *meaning);
            for row in 0..3 {
                let right = self.form(&pose.0[row][column]);
                self.blocks.push(Block::Equation(
                    Form::Entry("t".to_owned(), row + 1, column + 1),
                    right,
                ));
            }
        }
        Ok(())
    }

    fn jacobian(&mut self) -> Result<()> {
        self.heading(1, "The Jacobian");
        let jacobian = jacobian::in_base(self.arm);
        let swollen = jacobian.0.iter().flatten().any(Poly::is_swollen);
        self.arm.not_swollen(swollen)?;
        self.say(words(
            "Velocity of the tool point (rows 1 to 3) and angular velocity (rows 4 to 6) in the base's axes, a column for \
             each joint: (z x (p - o), z) for one that turns about the axis z through o, (z, 0) for one that slides. Entries \
             that are not listed are 0.",
        ));
        for column in 0..self.arm.dof() {
            for row in 0..6 {
                let entry = &jacobian.0[row][column];
                if !entry.is_zero() {
                    let right = self.form(entry);
                    self.blocks.push(Block::Equation(
                        Form::Entry("J".to_owned(), row + 1, column + 1),
                        right,
                    ));
                }
            }
        }
        self.heading(1, "Singular configurations");
        match determinant(self.arm) {
            Some(determinant) => self.singular(&determinant),
            None => {
                let text = match self.arm.dof() > 6 {
                    true => {
                        "The arm has more joints than a pose needs: its Jacobian is not square, and no determinant tells \
                             where it is singular. `pieper fk --jacobian` measures it at a joint vector."
                    }
                    false => {
                        "The Jacobian has no square part that would give one determinant. `pieper fk --jacobian` \
                              measures it at a joint vector."
                    }
                };
                self.say(words(text));
            }
        }
        Ok(())
    }

    fn singular(&mut self, determinant: &Determinant) {
        if determinant.number == number::Rational::ZERO {
            self.say(words("The determinant is 0 at every joint vector: the arm cannot follow every velocity anywhere."));
            return;
        }
        self.say(vec![
            text("The determinant does not depend on the axes and the point it is taken for. In the axes of frame "),
            Inline::Math(Form::whole(determinant.frame as i64)),
            text(" and for the origin of frame "),
            Inline::Math(Form::whole(determinant.point as i64)),
            text(" the matrix falls into blocks:"),
        ]);
        let mut factors: Vec<Form> = Vec::new();
        for (factor, _) in &determinant.factors {
            let power = form::of(&self.arm.names, factor);
            match factors.last_mut() {
                Some(Form::Power(base, exponent)) if **base == power => *exponent += 1,
                Some(last) if *last == power => *last = Form::Power(Box::new(power), 2),
                _ => factors.push(power),
            }
        }
        let is_one = number::magnitude(&determinant.number) == number::whole(1);
        if !is_one || factors.is_empty() {
            factors.insert(0, Form::number(&number::magnitude(&determinant.number)));
        }
        let product = form::signed(
            number::is_negative(&determinant.number),
            Form::Product(factors),
        );
        self.blocks.push(Block::Equation(
            Form::Call("det", vec![Form::name("J")]),
            product,
        ));
        let mut points: Vec<Vec<Inline>> = Vec::new();
        let mut seen: Vec<&Poly> = Vec::new();
        for (factor, joints) in &determinant.factors {
            if !seen.contains(&factor) {
                seen.push(factor);
                points.extend(self.singular_where(factor, joints));
            }
        }
        match points.is_empty() {
            true => self.say(words(
                "No factor holds a joint variable: the arm has no singular configuration.",
            )),
            false => {
                self.say(words("It is singular exactly where a factor vanishes:"));
                self.blocks.push(Block::List(points));
            }
        }
    }

    /// Where a factor vanishes; nothing for a length.
    fn singular_where(&self, factor: &Poly, joints: &[usize]) -> Option<Vec<Inline>> {
        let is_variable = |var: &crate::names::Var| {
            let joint = self.arm.names.joint_of(*var).is_some();
            joint || basis::is_sum(&self.arm.names, *var)
        };
        if !factor.vars().iter().any(is_variable) {
            return None;
        }
        let zero = || Form::whole(0);
        let mut point = vec![Inline::Equality(form::of(&self.arm.names, factor), zero())];
        let single = factor.vars();
        if let ([var], 1) = (&single[..], factor.terms().len())
            && let Some(angle) = var.angle()
        {
            let of = match self.arm.names.meaning(angle) {
                AngleMeaning::Joint(joint) => Form::Joint(*joint),
                AngleMeaning::Sum(sum) => Form::joints(sum),
                _ => Form::whole(0),
            };
            let pi = || Form::name("pi");
            let half = || pi().over(Form::whole(2));
            let (one, other) = match var.kind() {
                VarKind::Sin(_) => (zero(), pi()),
                _ => (half(), Form::Neg(Box::new(half()))),
            };
            point.extend([
                text(": "),
                Inline::Equality(of, one),
                text(" or "),
                Inline::Math(other),
            ]);
        }
        let list: Vec<String> = joints.iter().map(|joint| (joint + 1).to_string()).collect();
        let names = match list.split_last() {
            Some((last, rest)) if !rest.is_empty() => {
                format!("joints {} and {last}", rest.join(", "))
            }
            _ => format!("joint {}", list.join("")),
        };
        point.push(text(format!(" (from the block of {names})")));
        Some(point)
    }
}

/// A table's entry as a formula.
fn of_expr(expr: &Expr) -> Form {
    use pieper::describe::expr::{Operator, Unit};
    match expr {
        Expr::Number(value, unit) => {
            let number = number::of_f64(*value)
                .map_or_else(|| Form::name("?"), |value| Form::number(&value));
            match unit {
                Unit::None => number,
                unit => {
                    let name = Unit::NAMED
                        .iter()
                        .find(|(_, known)| known == unit)
                        .map_or("", |(name, _)| name);
                    Form::Product(vec![number, Form::name(name)])
                }
            }
        }
        Expr::Pi => Form::name("pi"),
        Expr::Symbol(name) => match name
            .strip_prefix('q')
            .and_then(|index| index.parse::<usize>().ok())
        {
            Some(joint) if joint > 0 => Form::Joint(joint - 1),
            _ => Form::name(name),
        },
        Expr::Neg(inner) => form::signed(true, of_expr(inner)),
        Expr::Binary(operator, left, right) => {
            let (left, right) = (of_expr(left), of_expr(right));
            match operator {
                Operator::Add => Form::Sum(vec![left, right]),
                Operator::Sub => Form::Sum(vec![left, form::signed(true, right)]),
                Operator::Mul => Form::Product(vec![left, right]),
                Operator::Div => match left {
                    Form::Neg(inner) => form::signed(true, inner.over(right)),
                    left => left.over(right),
                },
                Operator::Pow => match right {
                    Form::Number(value) => match u32::try_from(value.numerator().clone()) {
                        Ok(exponent) if value.is_int() => Form::Power(Box::new(left), exponent),
                        _ => Form::name(expr.to_string()),
                    },
                    _ => Form::name(expr.to_string()),
                },
            }
        }
        Expr::Call(function, arguments) => {
            Form::Call(function.name(), arguments.iter().map(of_expr).collect())
        }
    }
}
