//! Scripts: the person's Python in a supervised process of its own.
//!
//! `python3 -I -u` runs `mathmodel.py`, which fetches the script and answers for the module `mathmodel` by lines of JSON on two extra
//! pipes. The process has its own group: Stop interrupts it, and half a second later kills all of it. Whatever a script does to
//! itself, the studio stays.

mod calls;
mod child;

pub(crate) use child::{Host, Running, find_python, run};

use serde_json::{Value, json};

/// The bootstrap that the child runs.
const BOOTSTRAP: &str = include_str!("script/mathmodel.py");

/// What is known of scripts here.
#[derive(Clone, Debug, Default)]
pub(crate) struct Status {
    pub(crate) running: bool,
    /// Where and why the last run failed.
    pub(crate) error: Option<(Option<u32>, String)>,
    /// How it ended, in words.
    pub(crate) ended: Option<String>,
    pub(crate) python: Option<Python>,
}

/// The Python that scripts run in.
#[derive(Clone, Debug)]
pub(crate) struct Python {
    pub(crate) program: Option<String>,
    pub(crate) version: String,
    pub(crate) numpy: bool,
}

impl Status {
    /// For the page.
    pub(crate) fn value(&self, text: &str) -> Value {
        let error = self
            .error
            .as_ref()
            .map(|(line, text)| json!({"line": line, "text": text}));
        let python = self.python.as_ref().map(|python| {
            let sentence = match (&python.program, python.numpy) {
                (Some(_), true) => format!("Python {} with numpy", python.version),
                (Some(_), false) => format!("Python {} (numpy is not installed)", python.version),
                (None, _) => "No Python 3 was found on this computer: install one (python3) to run scripts".to_owned(),
            };
            json!({"found": python.program.is_some(), "version": python.version, "numpy": python.numpy, "sentence": sentence})
        });
        json!({"text": text, "running": self.running, "error": error, "ended": self.ended, "python": python})
    }
}

/// Scripts to begin with.
pub(crate) fn examples() -> Value {
    json!([
        {"name": "The paper's example", "text": include_str!("script/examples/paper.py")},
        {"name": "A circle", "text": include_str!("script/examples/circle.py")},
        {"name": "Every solution", "text": include_str!("script/examples/solutions.py")},
        {"name": "Keyframes", "text": include_str!("script/examples/keyframes.py")},
    ])
}

/// What the module `mathmodel` offers.
pub(crate) fn help() -> Value {
    let rows = [
        (
            "chain1(angle) .. chain12(angle)",
            "sets a joint, in degrees (millimetres for one that slides)",
            "mathmodel.chain2(45)",
        ),
        (
            "joint(n), joint(n, value)",
            "reads or sets joint n, counted from 1",
            "mathmodel.joint(3, -20)",
        ),
        (
            "joints(), joints(values)",
            "reads or sets all joints",
            "mathmodel.joints([0, 10, 20, 0, 30, 0])",
        ),
        (
            "tool()",
            "x, y, z in millimetres, roll, pitch, yaw in degrees",
            "x, y, z, *turn = mathmodel.tool()",
        ),
        (
            "matrix()",
            "the tool's pose as four rows, in metres",
            "mathmodel.matrix()[0][3]",
        ),
        (
            "move(x, y, z, roll, pitch, yaw)",
            "brings the tool there; without the last three it keeps its orientation",
            "mathmodel.move(300, 0, 400)",
        ),
        (
            "solutions()",
            "every set of joint values for the present pose",
            "len(mathmodel.solutions())",
        ),
        (
            "pause(ms)",
            "waits; the speed of playback scales it",
            "mathmodel.pause(20)",
        ),
        (
            "time()",
            "seconds since the script began",
            "mathmodel.time()",
        ),
        (
            "keyframe(t)",
            "adds the present posture to the motion",
            "mathmodel.keyframe(2.0)",
        ),
        (
            "limits()",
            "lower and upper limit of every joint",
            "mathmodel.limits()[0]",
        ),
    ];
    rows.iter()
        .map(|(name, does, example)| json!({"name": name, "does": does, "example": example}))
        .collect()
}
