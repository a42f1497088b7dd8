//! The project file: what a person would not like to lose.

use serde::Deserialize;
use serde_json::{Value, json};

use super::Session;
use crate::arm::Arm;
use crate::command::Load;
use crate::motion::Keyframe;
use crate::sections::Section;

/// The version written, and the only one read.
const VERSION: u32 = 1;

#[derive(Deserialize)]
struct Project {
    pieper_studio: u32,
    robot: String,
    q: Vec<f64>,
    home: Vec<f64>,
    #[serde(default)]
    keyframes: Vec<Saved>,
    #[serde(default)]
    law: Option<String>,
    #[serde(default)]
    script: String,
}

#[derive(Deserialize)]
struct Saved {
    t: f64,
    q: Vec<f64>,
    #[serde(default)]
    label: String,
}

impl Session {
    /// The project file's content.
    pub fn project(&self) -> Value {
        json!({
            "pieper_studio": VERSION,
            "robot": self.arm.id,
            "q": self.q,
            "home": self.home,
            "law": self.motion.profile.name(),
            "keyframes": self.motion.keyframes.iter().map(|k| json!({"t": k.t, "q": k.q, "label": k.label})).collect::<Value>(),
            "script": self.script,
        })
    }

    /// Goes on with a project file's content.
    ///
    /// # Errors
    /// A sentence that says what is wrong with it; then nothing has changed.
    pub fn open(&mut self, text: &str) -> Result<Value, String> {
        let project: Project =
            serde_json::from_str(text).map_err(|error| format!("the project file: {error}"))?;
        if project.pieper_studio != VERSION {
            return Err(format!(
                "the project file is of version {}, {VERSION} was expected",
                project.pieper_studio
            ));
        }
        let other = (project.robot != self.arm.id).then(|| {
            Arm::load(&Load {
                robot: Some(project.robot.clone()),
                file: None,
                values: Default::default(),
            })
        });
        let other = other.transpose()?;
        let dof = other.as_ref().map_or(self.arm.dof(), Arm::dof);
        let rows = project
            .keyframes
            .iter()
            .map(|saved| &saved.q)
            .chain([&project.q, &project.home]);
        let fits = |q: &Vec<f64>| q.len() == dof && q.iter().all(|value| value.is_finite());
        if !rows.into_iter().all(fits) || project.keyframes.iter().any(|saved| !saved.t.is_finite())
        {
            return Err(format!(
                "the project file: {dof} finite joint values were expected in every posture"
            ));
        }
        match other {
            Some(arm) => self.put(arm),
            None => self.remember("open", None),
        }
        self.home = project.home;
        self.script = project.script;
        self.motion.keyframes = project
            .keyframes
            .into_iter()
            .enumerate()
            .map(|(k, saved)| Keyframe {
                id: k as u32 + 1,
                t: saved.t,
                q: saved.q,
                label: saved.label,
            })
            .collect();
        self.motion.rebuild();
        if let Some(law) = project.law {
            self.law(&law)?;
        }
        let q = self.bounded(project.q);
        self.set(q);
        self.touch(&Section::ALL);
        Ok(Value::Null)
    }
}
