//! An arm as formulas: its table with named lengths, ready for the kernel.

use pieper::describe::dh::{DhRow, DhTable, FrameExpr, Moves};
use pieper::describe::{Convention, Form, Robot};
use pieper::kinematics::kernel::Turn;
use pieper::spatial::Quarters;
use pieper::{Error, Result};

use crate::angle;
use crate::names::{Angle, AngleMeaning, Names, SymbolMeaning, Var, VarKind};
use crate::number;
use crate::poly::Poly;
use crate::table::Entries;
use crate::transform::{PolyFrame, Transform, identity_frame};

/// What becomes of named lengths that have a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lengths {
    /// They stay symbols.
    Symbols,
    /// Their values take their place; those without a value stay symbols.
    Numbers,
}

/// An arm's table as formulas.
#[derive(Clone, Debug)]
pub struct Arm {
    /// The arm's name.
    pub title: String,
    /// What the quantities are called.
    pub names: Names,
    /// The convention of the table.
    pub convention: Convention,
    /// The rows, base to tool.
    pub rows: Vec<Row>,
    /// From the world to the first row's frame, if that is not the identity.
    pub base: Option<Transform>,
    /// From the last row's frame to the tool, if that is not the identity.
    pub tool: Option<Transform>,
    /// Runs of joints with parallel axes: the joints that turn, with the sign each enters the common sum with.
    pub parallel: Vec<Vec<(usize, i8)>>,
    /// The table as written: theta, d, a, alpha, the joint variable put back in.
    pub printed: Vec<[String; 4]>,
    /// The values of the parameters that have one.
    pub values: Vec<(String, f64)>,
    /// Whether the table was computed from another description.
    pub computed_table: bool,
}

/// A row as formulas.
#[derive(Clone, Debug)]
pub struct Row {
    /// Whether the joint turns; otherwise it slides.
    pub turns: bool,
    /// The direction in which the variable enters: +1 or -1.
    pub sign: i8,
    /// The turn about z, the joint variable included.
    pub theta: Turn<Poly>,
    /// The constant part of that turn.
    pub offset: Turn<Poly>,
    /// The shift along z, the joint variable included.
    pub d: Poly,
    /// The shift along x.
    pub a: Poly,
    /// The turn about x.
    pub alpha: Turn<Poly>,
}

impl Row {
    /// The turn about x in right angles, where it is a multiple of one.
    pub fn quarters(&self) -> Option<Quarters> {
        let value = |poly: &Poly| poly.constant().map(|value| number::to_f64(&value));
        Quarters::of(value(&self.alpha.sin)?, value(&self.alpha.cos)?)
    }
}

/// Sums of parallel axes are named for runs of up to this many.
const MAX_SUMS: usize = 4;

impl Arm {
    /// The formulas of an arm. One that is no table (screws, URDF) gets a standard one, of numbers.
    ///
    /// # Errors
    /// A model error for a table with more symbols or angles than there is room for; as [`Robot::chain`] where the
    /// table has to be computed.
    pub fn new(robot: &Robot, lengths: Lengths) -> Result<Self> {
        match &robot.form {
            Form::Dh(table) => Self::of_table(robot, table, lengths, false),
            Form::Screws(_) | Form::Tree { .. } => {
                let table = DhTable::of_chain(&robot.chain()?, Convention::Standard)?;
                Self::of_table(robot, &table, lengths, true)
            }
        }
    }

    fn of_table(
        robot: &Robot,
        table: &DhTable,
        lengths: Lengths,
        computed_table: bool,
    ) -> Result<Self> {
        let mut names = Names::default();
        let room = |found: Option<_>| {
            found.ok_or_else(|| {
                Error::model(
                    robot.name.clone(),
                    "it has more joints than formulas have room for",
                )
            })
        };
        for (index, row) in table.rows.iter().enumerate() {
            match row.moves {
                Moves::Theta => room(names.angle(AngleMeaning::Joint(index)).map(|_| ()))?,
                Moves::D => {
                    let name = format!("q{}", index + 1);
                    room(names.symbol(&name, SymbolMeaning::Joint(index)).map(|_| ()))?;
                }
            }
        }
        let mut entries = Entries {
            names: &mut names,
            parameters: &robot.parameters,
            lengths,
        };
        let rows = table.rows.iter().enumerate();
        let rows = rows
            .map(|(index, row)| entries.row(index, row))
            .collect::<Result<Vec<_>>>()?;
        let base = entries.fixed(&table.base)?;
        let tool = entries.fixed(&table.tool)?;
        let parallel = parallel_runs(table.convention, &rows);
        for run in &parallel {
            for sum in sums_of(run) {
                // Without room for its name a sum stays expanded.
                let _ = names.angle(AngleMeaning::Sum(sum));
            }
        }
        let printed = table
            .rows
            .iter()
            .enumerate()
            .map(|(index, row)| printed(index, row))
            .collect();
        let values = robot.values()?.into_iter().collect();
        Ok(Self {
            title: robot.name.clone(),
            names,
            convention: table.convention,
            rows,
            base,
            tool,
            parallel,
            printed,
            values,
            computed_table,
        })
    }

    /// The number of joints.
    pub fn dof(&self) -> usize {
        self.rows.len()
    }

    /// The angle that is a joint's variable, if the joint turns.
    pub fn joint_angle(&self, joint: usize) -> Option<Angle> {
        self.names.find_angle(&AngleMeaning::Joint(joint))
    }

    /// Row `index`'s matrix `A`, from the convention's template.
    pub fn link(&self, index: usize) -> Transform {
        let mut frame = identity_frame();
        self.append(&mut frame, index);
        Transform::of_frame(&frame)
    }

    /// Runs the library's kernel over one row.
    fn append(&self, frame: &mut PolyFrame, index: usize) {
        let row = &self.rows[index];
        let about_x = |frame: &mut PolyFrame| match row.quarters() {
            Some(quarters) => frame.turn_x_quarters(quarters),
            None => frame.turn_x(&row.alpha),
        };
        match self.convention {
            Convention::Standard => {
                frame.turn_z(&row.theta);
                frame.shift_z(&row.d);
                frame.shift_x(&row.a);
                about_x(frame);
            }
            Convention::Modified => {
                about_x(frame);
                frame.shift_x(&row.a);
                frame.turn_z(&row.theta);
                frame.shift_z(&row.d);
            }
        }
    }

    /// The product of the rows' matrices from row `first` up to but without row `end`.
    pub fn product(&self, first: usize, end: usize) -> Transform {
        let mut frame = identity_frame();
        (first..end).for_each(|index| self.append(&mut frame, index));
        Transform::of_frame(&frame)
    }

    /// The tool's pose: `base * A_1 ... A_n * tool`.
    ///
    /// # Errors
    /// A model error if an entry outgrows [`MAX_TERMS`](crate::poly::MAX_TERMS).
    pub fn tool_pose(&self) -> Result<Transform> {
        let mut frame = self
            .base
            .as_ref()
            .map_or_else(identity_frame, Transform::frame);
        (0..self.dof()).for_each(|index| self.append(&mut frame, index));
        if let Some(tool) = &self.tool {
            frame.append(&tool.0);
        }
        let pose = Transform::of_frame(&frame);
        self.not_swollen(pose.is_swollen()).map(|()| pose)
    }

    pub(crate) fn not_swollen(&self, swollen: bool) -> Result<()> {
        if !swollen {
            return Ok(());
        }
        let most = crate::poly::MAX_TERMS;
        let is_numeric = self
            .names
            .symbols()
            .all(|(.., meaning)| matches!(meaning, SymbolMeaning::Joint(_)));
        let instead = match is_numeric {
            true => {
                "its axes are neither parallel nor do they meet; `pieper codegen` writes it as code, link by link, and `pieper ik` solves it"
            }
            false => {
                "with fewer joints, or with numbers for its lengths (--numeric), it may be written down"
            }
        };
        let text = format!("a formula of it has more than {most} terms: {instead}");
        Err(Error::model(self.title.clone(), text))
    }

    /// The first three rows of the tool's pose in numbers, link by link: no formula is multiplied out.
    pub fn pose_at(&self, q: &[f64], parameter: &impl Fn(&str) -> f64) -> [[f64; 4]; 3] {
        let numbers = |transform: &Transform| {
            let entry = |poly: &Poly| poly.evaluate(&0.0, |var| self.value_at(var, q, parameter));
            transform.0.each_ref().map(|row| row.each_ref().map(entry))
        };
        let links = (0..self.dof()).map(|index| self.link(index));
        let all = self.base.iter().cloned().chain(links);
        let all = all.chain(self.tool.iter().cloned());
        let mut pose = numbers(&Transform::identity());
        for next in all.map(|transform| numbers(&transform)) {
            pose = std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    let turned: f64 = (0..3).map(|k| pose[i][k] * next[k][j]).sum();
                    turned + if j == 3 { pose[i][3] } else { 0.0 }
                })
            });
        }
        pose
    }

    /// The value of every quantity at a joint vector, by `parameter` for the symbols of the table.
    pub fn value_at(&self, var: Var, q: &[f64], parameter: &impl Fn(&str) -> f64) -> f64 {
        match var.kind() {
            VarKind::Sin(angle) => self.angle_at(angle, q, parameter).sin(),
            VarKind::Cos(angle) => self.angle_at(angle, q, parameter).cos(),
            VarKind::Root(square) => f64::from(square).sqrt(),
            VarKind::Symbol(_) => match self.names.symbol_meaning(var) {
                Some(SymbolMeaning::Joint(joint)) => q.get(*joint).copied().unwrap_or(f64::NAN),
                _ => parameter(self.names.name(var)),
            },
        }
    }

    fn angle_at(&self, angle: Angle, q: &[f64], parameter: &impl Fn(&str) -> f64) -> f64 {
        let joint = |joint: &usize| q.get(*joint).copied().unwrap_or(f64::NAN);
        match self.names.meaning(angle) {
            AngleMeaning::Joint(index) => joint(index),
            AngleMeaning::Sum(sum) => sum
                .iter()
                .map(|(index, sign)| f64::from(*sign) * joint(index))
                .sum(),
            AngleMeaning::Parameter(name) => parameter(name),
            AngleMeaning::Constant(_, value) => *value,
        }
    }

    /// The value of a table's parameter, formulas included; NaN where it has none.
    pub fn parameter(&self, name: &str) -> f64 {
        let known = |name: &str| {
            self.values
                .iter()
                .find(|(known, _)| known == name)
                .map(|(_, value)| *value)
        };
        if let Some(value) = known(name) {
            return value;
        }
        let formula = self
            .names
            .find_symbol(name)
            .and_then(|var| self.names.symbol_meaning(var));
        let Some(SymbolMeaning::Formula(text)) = formula else {
            return f64::NAN;
        };
        let values = self.values.iter().cloned().collect();
        let value = pieper::describe::Expr::parse(text).and_then(|expr| expr.evaluate(&values));
        value.unwrap_or(f64::NAN)
    }
}

impl Entries<'_> {
    fn row(&mut self, index: usize, row: &DhRow) -> Result<Row> {
        let offset = self.angle(&row.theta)?;
        let d = self.length(&row.d)?;
        let sign = if row.sign < 0.0 { -1 } else { 1 };
        let (mut theta, mut shift) = (offset.clone(), d);
        match row.moves {
            Moves::Theta => {
                if let Some(angle) = self.names.find_angle(&AngleMeaning::Joint(index)) {
                    let own = angle::turn(angle);
                    let own = if sign < 0 { angle::opposite(&own) } else { own };
                    theta = angle::sum(&offset, &own);
                }
            }
            Moves::D => {
                if let Some(var) = self.names.find_symbol(&format!("q{}", index + 1)) {
                    shift = shift + Poly::var(var).scaled(&number::whole(i64::from(sign)));
                }
            }
        }
        let (a, alpha) = (self.length(&row.a)?, self.angle(&row.alpha)?);
        Ok(Row {
            turns: row.moves == Moves::Theta,
            sign,
            theta,
            offset,
            d: shift,
            a,
            alpha,
        })
    }

    /// A fixed transform; `None` for the identity.
    fn fixed(&mut self, frame: &FrameExpr) -> Result<Option<Transform>> {
        if frame.is_identity() {
            return Ok(None);
        }
        let [roll, pitch, yaw] = &frame.rpy;
        let mut turned = identity_frame();
        turned.turn_z(&self.angle(yaw)?);
        // A turn about y is one about x between two quarter turns about z.
        turned.turn_z(&angle::fifteen_degrees(6));
        turned.turn_x(&self.angle(pitch)?);
        turned.turn_z(&angle::fifteen_degrees(-6));
        turned.turn_x(&self.angle(roll)?);
        for (component, length) in turned.p.iter_mut().zip(&frame.xyz) {
            *component = self.length(length)?;
        }
        let fixed = Transform::of_frame(&turned);
        Ok((fixed != Transform::identity()).then_some(fixed))
    }
}

/// Runs of neighbouring joints with parallel axes, two that turn at least.
fn parallel_runs(convention: Convention, rows: &[Row]) -> Vec<Vec<(usize, i8)>> {
    let mut runs: Vec<Vec<(usize, i8)>> = Vec::new();
    let (mut run, mut facing) = (Vec::new(), 1_i8);
    for (index, row) in rows.iter().enumerate() {
        let twist = match convention {
            Convention::Standard if index == 0 => None,
            Convention::Standard => Some(&rows[index - 1].alpha),
            Convention::Modified => (index > 0).then_some(&row.alpha),
        };
        match twist
            .filter(|twist| twist.sin.is_zero())
            .and_then(|twist| twist.cos.constant())
        {
            Some(cos) => facing *= if number::is_negative(&cos) { -1 } else { 1 },
            None => {
                runs.push(std::mem::take(&mut run));
                facing = 1;
            }
        }
        if row.turns {
            run.push((index, facing * row.sign));
        }
    }
    runs.push(run);
    runs.retain(|run| run.len() > 1);
    for run in &mut runs {
        let first = run[0].1;
        run.iter_mut().for_each(|(_, sign)| *sign *= first);
    }
    runs
}

/// The sums of a run that deserve a name, the first sign positive.
fn sums_of(run: &[(usize, i8)]) -> Vec<Vec<(usize, i8)>> {
    let starts = if run.len() > MAX_SUMS { 1 } else { run.len() };
    let all = (0..starts).flat_map(|start| (start + 2..=run.len()).map(move |end| (start, end)));
    all.map(|(start, end)| positive(&run[start..end])).collect()
}

/// A sum or its opposite, whichever starts with a plus.
pub(crate) fn positive(sum: &[(usize, i8)]) -> Vec<(usize, i8)> {
    let first = sum.first().map_or(1, |(_, sign)| *sign);
    sum.iter()
        .map(|&(joint, sign)| (joint, sign * first))
        .collect()
}

fn printed(index: usize, row: &DhRow) -> [String; 4] {
    let moving = row.moving_entry(index).to_string();
    let (theta, d) = match row.moves {
        Moves::Theta => (moving, row.d.to_string()),
        Moves::D => (row.theta.to_string(), moving),
    };
    [theta, d, row.a.to_string(), row.alpha.to_string()]
}
