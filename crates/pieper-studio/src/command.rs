//! What can be asked of a session, as WIRE.md section 4 lists it.

use serde::Deserialize;

use crate::quantity::Quantity;

/// One command. Unknown names and fields are errors that name them.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
#[allow(missing_docs, reason = "WIRE.md describes each")]
pub enum Command {
    Joints {
        q: Vec<Quantity>,
        gesture: Option<String>,
    },
    Joint {
        joint: usize,
        value: Quantity,
        gesture: Option<String>,
    },
    Named {
        to: Named,
    },
    SetHome {},
    Unlock {
        on: bool,
    },
    Tool(Box<ToolGoal>),
    Method {
        to: MethodName,
    },
    Solution {
        index: usize,
    },
    Family {
        index: usize,
        at: Quantity,
        gesture: Option<String>,
    },
    Ghosts {
        on: bool,
    },
    Pick(Ray),
    Grab {
        origin: [f64; 3],
        direction: [f64; 3],
        #[serde(default)]
        arm: bool,
    },
    Drag(Ray),
    Release {
        #[serde(default)]
        cancel: bool,
    },
    Load(Box<Load>),
    MotionTable {
        name: String,
        text: String,
    },
    Keyframe {
        op: KeyframeOp,
        /// Its `id`. Not called that here, since a message's own `id` is that of its answer.
        keyframe: Option<u32>,
        t: Option<Quantity>,
        label: Option<String>,
        gesture: Option<String>,
    },
    Law {
        to: String,
    },
    Play {},
    Pause {},
    StopMotion {},
    Seek {
        t: Quantity,
    },
    Step {
        by: i32,
    },
    Speed {
        to: Quantity,
    },
    Loop {
        on: bool,
    },
    Samples {
        rate: Option<Quantity>,
    },
    ScriptSave {
        text: String,
    },
    Formulas {
        scope: FormulaScope,
    },
    FormulaValues {
        scope: FormulaScope,
    },
    ScriptExamples {},
    ScriptHelp {},
    Undo {},
    Redo {},
    Open {
        text: String,
    },
}

/// Postures with a name.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Named {
    /// The person's own.
    Home,
    /// All joints at zero, or at the limit nearest to it.
    Zero,
    /// Anywhere within the limits.
    Random,
}

/// Which formulas.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum FormulaScope {
    /// From joint values to the pose.
    Forward,
    /// From the pose to joint values.
    Inverse,
}

/// How rotations are represented.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum MethodName {
    /// Rotation matrices.
    #[default]
    Matrix,
    /// Unit quaternions.
    Quaternion,
}

/// A ray in the base frame.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ray {
    /// Where it starts.
    pub origin: [f64; 3],
    /// Where it goes; any length.
    pub direction: [f64; 3],
}

/// A wanted pose of the tool: what is left out stays.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs, reason = "WIRE.md describes each")]
pub struct ToolGoal {
    pub position: Option<[Quantity; 3]>,
    pub rpy: Option<[Quantity; 3]>,
    pub quaternion: Option<[f64; 4]>,
    pub axis_angle: Option<[Quantity; 4]>,
    pub matrix: Option<Vec<Vec<f64>>>,
    #[serde(default)]
    pub frame: Frame,
    pub gesture: Option<String>,
}

/// In whose axes a pose of the tool is given.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Frame {
    /// The base's.
    #[default]
    Base,
    /// The tool's own: a displacement.
    Tool,
}

/// Which arm.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs, reason = "WIRE.md describes each")]
pub struct Load {
    pub robot: Option<String>,
    pub file: Option<FileText>,
    #[serde(default)]
    pub values: std::collections::BTreeMap<String, String>,
}

/// A file's name and content.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs, reason = "the words say it")]
pub struct FileText {
    pub name: String,
    pub text: String,
}

/// What happens to a keyframe.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs, reason = "WIRE.md describes each")]
pub enum KeyframeOp {
    Add,
    Move,
    Set,
    Rename,
    Remove,
    Clear,
    Goto,
}
