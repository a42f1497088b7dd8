//! What a polynomial's quantities are called and stand for.

/// An angle whose sine and cosine are quantities of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Angle(pub(crate) u8);

/// A quantity of a polynomial: the sine or cosine of an [`Angle`], a root, or a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Var(pub(crate) u8);

/// Angles a polynomial can have.
pub const MAX_ANGLES: usize = 24;
/// Symbols a polynomial can have.
pub const MAX_SYMBOLS: usize = 78;
/// Quantities a polynomial can have.
pub(crate) const SLOTS: usize = 2 * MAX_ANGLES + 2 + MAX_SYMBOLS;

const ROOT2: u8 = 2 * MAX_ANGLES as u8;
const FIRST_SYMBOL: u8 = ROOT2 + 2;

/// What a quantity is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VarKind {
    /// The sine of an angle.
    Sin(Angle),
    /// The cosine of an angle.
    Cos(Angle),
    /// The square root of 2 or 3.
    Root(u8),
    /// A symbol, by its index.
    Symbol(usize),
}

impl Angle {
    /// Its sine.
    pub fn sin(self) -> Var {
        Var(2 * self.0)
    }

    /// Its cosine.
    pub fn cos(self) -> Var {
        Var(2 * self.0 + 1)
    }
}

impl Var {
    /// The square root of 2.
    pub const ROOT2: Self = Self(ROOT2);
    /// The square root of 3.
    pub const ROOT3: Self = Self(ROOT2 + 1);

    /// What it is.
    pub fn kind(self) -> VarKind {
        match self.0 {
            slot if slot < ROOT2 && slot.is_multiple_of(2) => VarKind::Sin(Angle(slot / 2)),
            slot if slot < ROOT2 => VarKind::Cos(Angle(slot / 2)),
            ROOT2 => VarKind::Root(2),
            slot if slot < FIRST_SYMBOL => VarKind::Root(3),
            slot => VarKind::Symbol((slot - FIRST_SYMBOL) as usize),
        }
    }

    /// The angle whose sine or cosine it is.
    pub fn angle(self) -> Option<Angle> {
        match self.kind() {
            VarKind::Sin(angle) | VarKind::Cos(angle) => Some(angle),
            _ => None,
        }
    }

    pub(crate) fn slot(self) -> usize {
        self.0 as usize
    }

    fn symbol(index: usize) -> Self {
        Self(FIRST_SYMBOL + index as u8)
    }
}

/// What an angle stands for.
#[derive(Clone, Debug, PartialEq)]
pub enum AngleMeaning {
    /// The variable of a joint, counted from 0.
    Joint(usize),
    /// A sum of joint variables with signs +1 or -1: parallel axes.
    Sum(Vec<(usize, i8)>),
    /// A named angle of the table.
    Parameter(String),
    /// A constant angle that is no multiple of 15 degrees, as text and in radians.
    Constant(String, f64),
}

/// What a symbol stands for.
#[derive(Clone, Debug, PartialEq)]
pub enum SymbolMeaning {
    /// A named length of the table.
    Parameter,
    /// The variable of a joint that slides, counted from 0.
    Joint(usize),
    /// A formula of the table that is no polynomial, as text.
    Formula(String),
    /// A quantity that a derivation introduces.
    Auxiliary,
}

/// The angles and symbols of an arm's polynomials.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Names {
    angles: Vec<AngleMeaning>,
    symbols: Vec<(String, SymbolMeaning)>,
}

impl Names {
    /// The angle with this meaning, new or known; `None` when there is room for no more.
    pub fn angle(&mut self, meaning: AngleMeaning) -> Option<Angle> {
        if let Some(known) = self.find_angle(&meaning) {
            return Some(known);
        }
        if self.angles.len() == MAX_ANGLES {
            return None;
        }
        self.angles.push(meaning);
        Some(Angle(self.angles.len() as u8 - 1))
    }

    /// The known angle with this meaning.
    pub fn find_angle(&self, meaning: &AngleMeaning) -> Option<Angle> {
        let position = self.angles.iter().position(|known| known == meaning);
        position.map(|index| Angle(index as u8))
    }

    /// The symbol of this name, new or known; `None` when there is room for no more.
    pub fn symbol(&mut self, name: &str, meaning: SymbolMeaning) -> Option<Var> {
        if let Some(known) = self.find_symbol(name) {
            return Some(known);
        }
        if self.symbols.len() == MAX_SYMBOLS {
            return None;
        }
        self.symbols.push((name.to_owned(), meaning));
        Some(Var::symbol(self.symbols.len() - 1))
    }

    /// The known symbol of this name.
    pub fn find_symbol(&self, name: &str) -> Option<Var> {
        let position = self.symbols.iter().position(|(known, _)| known == name);
        position.map(Var::symbol)
    }

    /// All angles with their meanings.
    pub fn angles(&self) -> impl Iterator<Item = (Angle, &AngleMeaning)> {
        self.angles
            .iter()
            .enumerate()
            .map(|(index, meaning)| (Angle(index as u8), meaning))
    }

    /// All symbols with names and meanings.
    pub fn symbols(&self) -> impl Iterator<Item = (Var, &str, &SymbolMeaning)> {
        let all = self.symbols.iter().enumerate();
        all.map(|(index, (name, meaning))| (Var::symbol(index), name.as_str(), meaning))
    }

    /// What an angle stands for.
    pub fn meaning(&self, angle: Angle) -> &AngleMeaning {
        &self.angles[angle.0 as usize]
    }

    /// A symbol's name; empty for a quantity that is none.
    pub fn name(&self, var: Var) -> &str {
        match var.kind() {
            VarKind::Symbol(index) => self.symbols.get(index).map_or("", |(name, _)| name),
            _ => "",
        }
    }

    /// What a symbol stands for.
    pub fn symbol_meaning(&self, var: Var) -> Option<&SymbolMeaning> {
        match var.kind() {
            VarKind::Symbol(index) => self.symbols.get(index).map(|(_, meaning)| meaning),
            _ => None,
        }
    }

    /// The joint whose variable the quantity is made of, if it is that of one joint alone.
    pub fn joint_of(&self, var: Var) -> Option<usize> {
        match (var.angle(), self.symbol_meaning(var)) {
            (Some(angle), _) => match self.meaning(angle) {
                AngleMeaning::Joint(joint) => Some(*joint),
                _ => None,
            },
            (None, Some(SymbolMeaning::Joint(joint))) => Some(*joint),
            _ => None,
        }
    }
}
