//! The step sheet beside the picture, with the current numbers put in.

use pieper_symbolic::derive::{self, Scope};
use pieper_symbolic::sheet::Sheet;
use pieper_symbolic::{Arm as Table, Lengths};
use serde_json::{Value, json};

use super::Session;
use crate::command::FormulaScope;

/// The sheets of one arm, derived when they are first asked for.
#[derive(Default)]
pub(super) struct Sheets {
    /// The revision of the arm that they belong to.
    revision: u32,
    forward: Option<(Table, Sheet)>,
    inverse: Option<(Table, Sheet)>,
}

impl Session {
    pub(super) fn formulas(&mut self, scope: FormulaScope) -> Result<Value, String> {
        let (_, sheet) = self.sheet(scope)?;
        Ok(json!({"title": sheet.title, "html": sheet.fragment()}))
    }

    pub(super) fn formula_values(&mut self, scope: FormulaScope) -> Result<Value, String> {
        let q = self.q.clone();
        let (table, sheet) = self.sheet(scope)?;
        Ok(json!(sheet.values(table, &q)))
    }

    fn sheet(&mut self, scope: FormulaScope) -> Result<&(Table, Sheet), String> {
        if self.sheets.revision != self.revision {
            self.sheets = Sheets {
                revision: self.revision,
                ..Sheets::default()
            };
        }
        let (place, scope) = match scope {
            FormulaScope::Forward => (&mut self.sheets.forward, Scope::Forward),
            FormulaScope::Inverse => (&mut self.sheets.inverse, Scope::Inverse),
        };
        match place {
            Some(known) => Ok(known),
            None => {
                let text = |error: pieper::Error| error.to_string();
                let table = Table::new(&self.arm.robot, Lengths::Symbols).map_err(text)?;
                let sheet = derive::sheet(&table, scope).map_err(text)?;
                Ok(place.insert((table, sheet)))
            }
        }
    }
}
