//! The header of a motion table: what each column holds.

use super::MotionValues;
use super::cells::Cell;
use crate::error::{Error, Place, Result};
use crate::model::Chain;

/// What the columns are together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Layout {
    /// A value for each variable of the chain.
    Joints,
    /// `x,y,z,qw,qx,qy,qz`
    PoseQuaternion,
    /// `x,y,z,roll,pitch,yaw`
    PoseAngles,
    /// `Dx,Dy,Dz,Kx,Ky,Kz,Ex,Ey,Ez`
    Points,
}

impl Layout {
    pub(super) fn no_values(self) -> MotionValues {
        match self {
            Self::Joints => MotionValues::Joints(Vec::new()),
            Self::PoseQuaternion | Self::PoseAngles => MotionValues::Poses(Vec::new()),
            Self::Points => MotionValues::Points(Vec::new()),
        }
    }
}

/// What a number of the file is given in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unit {
    /// Radians, metres, seconds, or none.
    Si,
    Degrees,
    Millimetres,
}

impl Unit {
    pub(super) fn to_si(self, value: f64) -> f64 {
        match self {
            Self::Si => value,
            Self::Degrees => value.to_radians(),
            Self::Millimetres => value / 1000.0,
        }
    }
}

/// What a value of the layout is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quantity {
    Angle,
    Length,
    Number,
}

/// A value that a row of the layout must have, and the names of columns that give it.
#[derive(Clone)]
struct Slot {
    names: Vec<String>,
    quantity: Quantity,
}

/// One column.
pub(super) struct Column {
    pub(super) name: String,
    pub(super) kind: Kind,
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Time,
    Mark,
    Value { slot: usize, unit: Unit },
}

/// A header that was understood: every column known, none missing.
pub(super) struct Header {
    pub(super) columns: Vec<Column>,
    pub(super) layout: Layout,
    /// How many values a row has.
    pub(super) count: usize,
}

impl Header {
    pub(super) fn has_mark(&self) -> bool {
        self.columns.iter().any(|column| column.kind == Kind::Mark)
    }

    pub(super) fn read(file: &str, text: &str, cells: &[Cell<'_>], chain: &Chain) -> Result<Self> {
        let (layout, slots) = choose(cells, chain);
        let place = |cell: &Cell<'_>| Place::of_offset(file, text, cell.start);
        let mut columns: Vec<Column> = Vec::with_capacity(cells.len());
        for cell in cells {
            let kind = find(&slots, &cell.text)
                .map_err(|problem| Error::parse(place(cell), cell.shown(), problem))?;
            let Some(kind) = kind else {
                let expected = expected(layout, &slots, cells);
                return Err(Error::parse(place(cell), cell.shown(), expected));
            };
            if let Some(first) = columns.iter().find(|column| same(column.kind, kind)) {
                let text = format!("a second column for what the column {} holds", first.name);
                return Err(Error::parse(place(cell), cell.shown(), text));
            }
            columns.push(Column {
                name: cell.text.clone().into_owned(),
                kind,
            });
        }
        let line = Place {
            column: 0,
            ..cells.first().map(place).unwrap_or_default()
        };
        if !columns.iter().any(|column| column.kind == Kind::Time) {
            let text = "a column t was expected: the time in seconds";
            return Err(Error::parse(line, "", text));
        }
        for (index, slot) in slots.iter().enumerate() {
            let given =
                |column: &Column| matches!(column.kind, Kind::Value { slot, .. } if slot == index);
            if !columns.iter().any(given) {
                let names = slot.names.join(" or ");
                return Err(Error::parse(
                    line,
                    "",
                    format!("a column {names} was expected"),
                ));
            }
        }
        Ok(Self {
            columns,
            layout,
            count: slots.len(),
        })
    }
}

/// The layout that the names of the columns fit best. The pose's names are fixed, so a header that has all of them
/// is one even where joints bear such names (a gantry's x, y, z); in all other doubts joints are meant.
fn choose(cells: &[Cell<'_>], chain: &Chain) -> (Layout, Vec<Slot>) {
    let mut best = (Layout::Joints, joints(chain));
    let found = |slots: &[Slot]| {
        let is_value =
            |cell: &&Cell<'_>| matches!(find(slots, &cell.text), Ok(Some(Kind::Value { .. })));
        cells.iter().filter(is_value).count()
    };
    let mut most = found(&best.1);
    for layout in [Layout::PoseAngles, Layout::PoseQuaternion, Layout::Points] {
        let slots = fixed(layout);
        let count = found(&slots);
        if count > most || count >= slots.len() {
            most = count;
            best = (layout, slots);
        }
    }
    best
}

fn joints(chain: &Chain) -> Vec<Slot> {
    let slot = |(index, variable): (usize, &crate::model::Variable)| {
        let mut names = vec![format!("q{}", index + 1), variable.name.clone()];
        names.dedup();
        let quantity = match variable.kind.is_angular() {
            true => Quantity::Angle,
            false => Quantity::Length,
        };
        Slot { names, quantity }
    };
    chain.variables().iter().enumerate().map(slot).collect()
}

fn fixed(layout: Layout) -> Vec<Slot> {
    use Quantity::{Angle, Length, Number};
    let slots = |names: &[&str], quantity| {
        let slot = |name: &&str| Slot {
            names: vec![(*name).to_owned()],
            quantity,
        };
        names.iter().map(slot).collect::<Vec<_>>()
    };
    let position = slots(&["x", "y", "z"], Length);
    match layout {
        Layout::Joints => Vec::new(),
        Layout::PoseAngles => [position, slots(&["roll", "pitch", "yaw"], Angle)].concat(),
        Layout::PoseQuaternion => [position, slots(&["qw", "qx", "qy", "qz"], Number)].concat(),
        Layout::Points => slots(
            &["Dx", "Dy", "Dz", "Kx", "Ky", "Kz", "Ex", "Ey", "Ez"],
            Length,
        ),
    }
}

/// What a column of that name holds; `None` if there is no such column, an error if its unit cannot be.
fn find(slots: &[Slot], name: &str) -> Result<Option<Kind>, String> {
    match name {
        "t" => return Ok(Some(Kind::Time)),
        "mark" => return Ok(Some(Kind::Mark)),
        _ => {}
    }
    // A joint's own name counts before its number, should somebody have called the second joint q1.
    let by_name = |name: &str| {
        let own = slots
            .iter()
            .position(|slot| slot.names.last().is_some_and(|own| own == name));
        own.or_else(|| {
            slots
                .iter()
                .position(|slot| slot.names.iter().any(|n| n == name))
        })
    };
    let value = |slot, unit| Ok(Some(Kind::Value { slot, unit }));
    if let Some(slot) = by_name(name) {
        return value(slot, Unit::Si);
    }
    let units = [
        ("_deg", Unit::Degrees, Quantity::Angle),
        ("_mm", Unit::Millimetres, Quantity::Length),
    ];
    for (ending, unit, quantity) in units {
        let Some(slot) = name.strip_suffix(ending).and_then(by_name) else {
            continue;
        };
        return match slots[slot].quantity {
            is if is == quantity => value(slot, unit),
            Quantity::Angle => {
                Err("this is an angle: radians, or degrees with _deg, were expected".into())
            }
            Quantity::Length => {
                Err("this is a length: metres, or millimetres with _mm, were expected".into())
            }
            Quantity::Number => Err("this is a number without a unit".into()),
        };
    }
    Ok(None)
}

fn same(a: Kind, b: Kind) -> bool {
    match (a, b) {
        (Kind::Value { slot: a, .. }, Kind::Value { slot: b, .. }) => a == b,
        _ => a == b,
    }
}

/// What stands in a header of this layout.
fn expected(layout: Layout, slots: &[Slot], cells: &[Cell<'_>]) -> String {
    if let [only] = cells
        && let Some(other) = [';', '\t', ' ']
            .into_iter()
            .find(|&other| only.text.contains(other))
    {
        return format!("columns separated by commas were expected, not by {other:?}");
    }
    let names = |pick: fn(&Slot) -> Option<&String>| {
        let names: Vec<_> = slots.iter().filter_map(pick).map(String::as_str).collect();
        names.join(", ")
    };
    let (numbered, own) = (
        names(|slot| slot.names.first()),
        names(|slot| slot.names.get(1)),
    );
    let list = match (layout, own.is_empty()) {
        (Layout::Joints, false) => format!("{numbered} (or {own})"),
        _ => numbered,
    };
    let units = match layout {
        Layout::Joints => ", angles also with _deg and lengths with _mm",
        _ => "",
    };
    format!("an unknown column: t, {list} and mark were expected{units}")
}
