//! The kinematic family of an arm, for `pieper info`.

use std::fmt::Write as _;

use pieper::ik::Solver;
use pieper::model::Chain;
use serde_json::{Value, json};

/// The family with its evidence; null for an arm that no solver takes.
pub(crate) fn family_document(chain: &Chain) -> Value {
    let Ok(solver) = Solver::new(chain) else {
        return Value::Null;
    };
    let choice = solver.choice();
    json!({
        "name": choice.class.to_string(),
        "solver": choice.name,
        "deviation": choice.slack,
        "evidence": solver.structure().evidence(choice.class),
    })
}

/// The same for a person.
pub(crate) fn family_text(chain: &Chain) -> String {
    let solver = match Solver::new(chain) {
        Ok(solver) => solver,
        Err(error) => return format!("\nkinematic family\n  none: {error}\n"),
    };
    let choice = solver.choice();
    let mut out = format!(
        "\nkinematic family\n  {}, solver {}\n",
        choice.class, choice.name
    );
    for sentence in solver.structure().evidence(choice.class) {
        let _ = writeln!(out, "  {sentence}");
    }
    out
}
