//! Sheets in LaTeX, compiled.

use pieper_symbolic::derive::{Scope, sheet};
use pieper_symbolic::sheet::Format;
use pieper_symbolic::{Arm, Lengths};

use crate::code::{Folder, is_missing, run};

/// Every sheet is a page of its own that TeX takes without a word: no error, no box that sticks out of the page by much.
#[test]
fn latex_compiles() {
    if is_missing("pdflatex") {
        return;
    }
    let folder = Folder::new("latex");
    for id in [
        "ar3", "six-axis", "puma560", "ur5", "cobra600", "stanford", "jaco2",
    ] {
        let robot = pieper_robots::find(id).unwrap().robot();
        let arm = Arm::new(&robot, Lengths::Symbols).unwrap();
        for (scope, kind) in [(Scope::Forward, "forward"), (Scope::Inverse, "inverse")] {
            let file = format!("{id}-{kind}.tex");
            folder.write(&file, &sheet(&arm, scope).unwrap().print(Format::Latex));
            let arguments = ["-interaction=nonstopmode", "-halt-on-error", &file];
            let log = run("pdflatex", &arguments, folder.path());
            assert!(log.contains("Output written on"), "{file}: {log}");
            // A point is a third of a millimetre; the margins are some 70.
            let wide = log.lines().filter_map(|line| {
                let rest = line.strip_prefix("Overfull \\hbox (")?;
                rest.split_once("pt")?.0.parse::<f64>().ok()
            });
            let widest = wide.fold(0.0, f64::max);
            assert!(widest < 40.0, "{file}: a line sticks out by {widest} pt");
        }
    }
}
