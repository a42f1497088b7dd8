//! The studio's state, and everything that can be done to it.

mod export;
mod formulas;
mod goal;
mod keyframes;
mod project;

use std::sync::Arc;

use nalgebra::{Isometry3, Point3, Unit, Vector3};
use serde_json::{Value, json};

use crate::arm::Arm;
use crate::command::{Command, MethodName, Named, Ray};
use crate::drag::Drag;
use crate::history::History;
use crate::motion::{Keyframe, Motion};
use crate::quantity::Quantity;
use crate::script;
use crate::sections::Section;
use formulas::Sheets;

/// What undo goes back to.
#[derive(Clone)]
struct Snapshot {
    arm: Arc<Arm>,
    q: Vec<f64>,
    home: Vec<f64>,
    keyframes: Vec<Keyframe>,
}

/// A line for the person.
#[derive(Clone, Debug)]
pub(crate) struct LogLine {
    pub(crate) level: &'static str,
    pub(crate) text: String,
}

/// One arm and what a person does with it.
pub struct Session {
    pub(crate) arm: Arc<Arm>,
    pub(crate) q: Vec<f64>,
    pub(crate) home: Vec<f64>,
    pub(crate) unlocked: bool,
    pub(crate) method: MethodName,
    pub(crate) ghosts: bool,
    /// The pose last asked for, where it cannot be reached.
    pub(crate) missed: Option<Isometry3<f64>>,
    /// The place within a family that the arm was brought to: which one, and the joint values it is counted from.
    pub(crate) on_family: Option<(usize, Vec<Vec<f64>>)>,
    pub(crate) motion: Motion,
    pub(crate) script: String,
    pub(crate) script_status: script::Status,
    pub(crate) log: Vec<LogLine>,
    pub(crate) revision: u32,
    sheets: Sheets,
    history: History<Snapshot>,
    drag: Option<Drag>,
    changed: Vec<Section>,
    seed: u64,
}

/// Lines of the log that are kept.
const LOG_LINES: usize = 200;

impl Session {
    /// A session with an arm at its zero posture.
    pub fn new(arm: Arm) -> Self {
        let arm = Arc::new(arm);
        let zero = arm.zero();
        let mut session = Self {
            q: zero.clone(),
            home: zero,
            arm,
            unlocked: false,
            method: MethodName::default(),
            ghosts: false,
            missed: None,
            on_family: None,
            motion: Motion::default(),
            script: String::new(),
            script_status: script::Status::default(),
            log: Vec::new(),
            revision: 1,
            sheets: Sheets::default(),
            history: History::default(),
            drag: None,
            changed: Section::ALL.to_vec(),
            seed: 1,
        };
        session.note_problems();
        session
    }

    /// Does what a command says. The value that it answers with, or a sentence why not; then nothing has changed.
    ///
    /// # Errors
    /// A sentence that names the place and the remedy.
    pub fn apply(&mut self, command: Command) -> Result<Value, String> {
        match command {
            Command::Joints { q, gesture } => {
                let values: Vec<f64> = q.iter().map(|value| value.0).collect();
                if values.len() != self.arm.dof() {
                    return Err(format!(
                        "q: {} values were expected, {} were given",
                        self.arm.dof(),
                        values.len()
                    ));
                }
                let values = self.bounded(values);
                self.move_to(values, "joints", gesture.as_deref());
            }
            Command::Joint {
                joint,
                value,
                gesture,
            } => {
                let label = self.joint_label(joint)?;
                let mut q = self.q.clone();
                q[joint] = value.0;
                let q = self.bounded(q);
                self.move_to(q, &label, gesture.as_deref());
            }
            Command::Named { to } => {
                let (q, label) = match to {
                    Named::Home => (self.home.clone(), "home"),
                    Named::Zero => (self.arm.zero(), "zero"),
                    Named::Random => (self.random(), "random"),
                };
                self.move_to(q, label, None);
            }
            Command::SetHome {} => {
                self.remember("set home", None);
                self.home.clone_from(&self.q);
                self.touch(&[Section::Robot]);
            }
            Command::Unlock { on } => {
                self.unlocked = on;
                self.touch(&[Section::Pose]);
            }
            Command::Tool(goal) => return self.tool(&goal),
            Command::Method { to } => {
                self.method = to;
                self.touch(&[Section::Pose, Section::Ik]);
            }
            Command::Solution { index } => return self.solution(index),
            Command::Family { index, at, gesture } => {
                return self.family(index, at.0, gesture.as_deref());
            }
            Command::Ghosts { on } => {
                self.ghosts = on;
                self.touch(&[Section::Ik]);
            }
            Command::Pick(ray) => {
                return Ok(self.pick(&ray)?.map_or(Value::Null, |(value, ..)| value));
            }
            Command::Grab {
                origin,
                direction,
                arm,
            } => return self.grab(&Ray { origin, direction }, arm),
            Command::Drag(ray) => return self.drag(&ray),
            Command::Release { cancel } => self.release(cancel),
            Command::Load(wanted) => {
                let arm = Arm::load(&wanted)?;
                self.put(arm);
            }
            Command::MotionTable { name, text } => return self.table(&name, &text),
            Command::Keyframe {
                op,
                keyframe,
                t,
                label,
                gesture,
            } => {
                return self.keyframe(op, keyframe, t.map(|t| t.0), label, gesture.as_deref());
            }
            Command::Law { to } => return self.law(&to),
            Command::Play {} => return self.play(),
            Command::Pause {} => {
                self.motion.playing = false;
                self.touch(&[Section::Motion, Section::Ik, Section::Pose]);
            }
            Command::StopMotion {} => {
                self.motion.playing = false;
                self.seek(0.0);
            }
            Command::Seek { t } => self.seek(t.0),
            Command::Step { by } => {
                self.motion.playing = false;
                self.seek(self.motion.time + f64::from(by) / 30.0);
            }
            Command::Speed { to } => {
                self.motion.speed = to.0.clamp(0.1, 4.0);
                self.touch(&[Section::Motion]);
            }
            Command::Loop { on } => {
                self.motion.repeat = on;
                self.touch(&[Section::Motion]);
            }
            Command::Samples { rate } => {
                let rate = rate.map_or(60.0, |rate| rate.0.clamp(1.0, 1000.0));
                return Ok(json!(self.motion.samples(&self.arm, rate)));
            }
            Command::ScriptSave { text } => {
                self.script = text;
                self.touch(&[Section::Script]);
            }
            Command::Formulas { scope } => return self.formulas(scope),
            Command::FormulaValues { scope } => return self.formula_values(scope),
            Command::ScriptExamples {} => return Ok(script::examples()),
            Command::ScriptHelp {} => return Ok(script::help()),
            Command::Undo {} => return self.travel(true),
            Command::Redo {} => return self.travel(false),
            Command::Open { text } => return self.open(&text),
        }
        Ok(Value::Null)
    }

    /// Brings the arm to joint values as people type them: `0,45deg,pi/2`.
    ///
    /// # Errors
    /// A sentence that quotes what is no value, or says how many were expected.
    pub fn pose(&mut self, text: &str) -> Result<(), String> {
        let values = text.split(',').map(Quantity::parse);
        let q = values.collect::<Result<Vec<_>, String>>()?;
        self.apply(Command::Joints { q, gesture: None }).map(|_| ())
    }

    /// Lets time pass for a motion that plays.
    pub fn advance(&mut self, dt: f64) {
        if !self.motion.playing {
            return;
        }
        self.motion.advance(dt);
        if let Some(q) = self.motion.at(self.motion.time) {
            self.q = q;
        }
        self.touch(&[Section::Frame, Section::Pose]);
        if !self.motion.playing {
            self.touch(&[Section::Motion, Section::Ik]);
        }
    }

    /// Whether a motion plays.
    pub fn is_playing(&self) -> bool {
        self.motion.playing
    }

    /// The sections that have changed since the last call.
    pub(crate) fn take_changes(&mut self) -> Vec<Section> {
        std::mem::take(&mut self.changed)
    }

    pub(crate) fn touch(&mut self, sections: &[Section]) {
        for section in sections {
            if !self.changed.contains(section) {
                self.changed.push(*section);
            }
        }
    }

    pub(crate) fn labels(&self) -> [Option<&str>; 2] {
        self.history.labels()
    }

    /// An arm in place of the present one.
    pub fn put(&mut self, arm: Arm) {
        self.remember(&format!("load {}", arm.id), None);
        self.q = arm.zero();
        self.home = arm.zero();
        self.arm = Arc::new(arm);
        self.motion.forget();
        self.drag = None;
        self.missed = None;
        self.on_family = None;
        self.revision += 1;
        self.touch(&Section::ALL);
        self.note_problems();
    }

    fn note_problems(&mut self) {
        for text in self.arm.body.problems.clone() {
            self.say("warning", text);
        }
    }

    pub(crate) fn say(&mut self, level: &'static str, text: String) {
        if self.log.len() == LOG_LINES {
            self.log.remove(0);
        }
        self.log.push(LogLine { level, text });
        self.touch(&[Section::Log]);
    }

    /// A run of the script begins.
    pub(crate) fn script_begins(&mut self, text: String) {
        self.script = text;
        self.script_status.running = true;
        self.script_status.error = None;
        self.script_status.ended = None;
        self.touch(&[Section::Script]);
    }

    /// A run of the script has ended: where and why it failed, and how, in words.
    pub(crate) fn script_ended(&mut self, error: Option<(Option<u32>, String)>, ended: &str) {
        self.script_status.running = false;
        self.script_status.error = error;
        self.script_status.ended = Some(ended.to_owned());
        self.touch(&[Section::Script]);
    }

    pub(crate) fn is_script_running(&self) -> bool {
        self.script_status.running
    }

    /// The Python that scripts run in, once it has been looked for.
    pub(crate) fn python(&self) -> Option<script::Python> {
        self.script_status.python.clone()
    }

    pub(crate) fn python_found(&mut self, python: script::Python) {
        self.script_status.python = Some(python);
        self.touch(&[Section::Script]);
    }

    fn snapshot(&self) -> Snapshot {
        Snapshot {
            arm: Arc::clone(&self.arm),
            q: self.q.clone(),
            home: self.home.clone(),
            keyframes: self.motion.keyframes.clone(),
        }
    }

    fn remember(&mut self, label: &str, gesture: Option<&str>) {
        let before = self.snapshot();
        self.history.remember(label, gesture, before);
        self.touch(&[Section::History]);
    }

    /// Brings the arm to joint values: one step of undo.
    fn move_to(&mut self, q: Vec<f64>, label: &str, gesture: Option<&str>) {
        self.remember(label, gesture);
        self.set(q);
    }

    /// Brings the arm to joint values; whatever played stops.
    fn set(&mut self, q: Vec<f64>) {
        self.q = q;
        self.missed = None;
        self.on_family = None;
        if self.motion.playing {
            self.motion.playing = false;
            self.touch(&[Section::Motion]);
        }
        self.touch(&[Section::Frame, Section::Pose, Section::Ik]);
    }

    fn joint_label(&self, joint: usize) -> Result<String, String> {
        if joint >= self.arm.dof() {
            return Err(format!(
                "joint {joint}: the arm has joints 0 to {}",
                self.arm.dof() - 1
            ));
        }
        Ok(format!("J{}", joint + 1))
    }

    /// Within the limits, unless they are unlocked.
    fn bounded(&self, mut q: Vec<f64>) -> Vec<f64> {
        if !self.unlocked {
            q.iter_mut()
                .enumerate()
                .for_each(|(j, value)| *value = self.arm.clamp(j, *value));
        }
        q
    }

    /// A posture anywhere within the limits, another each time (Steele and Vigna's splitmix64).
    fn random(&mut self) -> Vec<f64> {
        let mut part = || {
            self.seed = self.seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = self.seed;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
        };
        let arm = Arc::clone(&self.arm);
        (0..arm.dof())
            .map(|joint| {
                let ([low, high], _) = arm.range(joint);
                low + (high - low) * part()
            })
            .collect()
    }

    fn travel(&mut self, back: bool) -> Result<Value, String> {
        let now = self.snapshot();
        let step = if back {
            self.history.undo(now)
        } else {
            self.history.redo(now)
        };
        let (label, state) = step.ok_or(if back {
            "there is nothing to undo"
        } else {
            "there is nothing to redo"
        })?;
        if !Arc::ptr_eq(&self.arm, &state.arm) {
            self.revision += 1;
            self.touch(&Section::ALL);
        }
        self.arm = state.arm;
        self.home = state.home;
        if self.motion.keyframes != state.keyframes {
            self.motion.keyframes = state.keyframes;
            self.motion.rebuild();
        }
        self.drag = None;
        self.set(state.q);
        self.touch(&[Section::Robot, Section::Motion, Section::History]);
        Ok(json!({"label": label}))
    }

    /// What a ray touches: the answer, the place, and link and joint.
    #[allow(clippy::type_complexity)]
    fn pick(
        &self,
        ray: &Ray,
    ) -> Result<Option<(Value, Point3<f64>, usize, Option<usize>)>, String> {
        let (origin, direction) = read_ray(ray)?;
        let Some(hit) = self
            .arm
            .picker
            .pick(&origin, &direction, &self.arm.poses(&self.q))
        else {
            return Ok(None);
        };
        let joint = self.arm.mover[hit.link];
        let value = json!({
            "link": hit.link, "joint": joint,
            "point": [hit.point.x, hit.point.y, hit.point.z],
            "normal": [hit.normal.x, hit.normal.y, hit.normal.z],
            "distance": hit.distance,
        });
        Ok(Some((value, hit.point, hit.link, joint)))
    }

    fn grab(&mut self, ray: &Ray, whole: bool) -> Result<Value, String> {
        let Some((value, point, link, Some(joint))) = self.pick(ray)? else {
            return Ok(Value::Null);
        };
        let label = if whole {
            "drag arm".to_owned()
        } else {
            format!("drag J{}", joint + 1)
        };
        self.remember(&label, None);
        let link = self.arm.link_of(link);
        self.drag = Some(Drag::new(&self.arm, &self.q, (link, joint), point, whole));
        Ok(value)
    }

    fn drag(&mut self, ray: &Ray) -> Result<Value, String> {
        let (origin, direction) = read_ray(ray)?;
        let drag = self
            .drag
            .take()
            .ok_or("nothing is grabbed: grab comes before drag")?;
        let q = drag.follow(&self.arm, &self.q, &origin, &direction, self.unlocked);
        self.set(q);
        let point = drag.point(&self.arm, &self.q);
        self.drag = Some(drag);
        Ok(json!({"point": [point.x, point.y, point.z]}))
    }

    fn release(&mut self, cancel: bool) {
        if let Some(drag) = self.drag.take() {
            if cancel {
                self.set(drag.before);
                let now = self.snapshot();
                // The step of the drag goes with it.
                let _ = self.history.undo(now);
            } else {
                self.history
                    .rename(format!("J{} {}", drag.joint + 1, self.shown(drag.joint)));
            }
            self.touch(&[Section::History]);
        }
    }

    /// A joint's value as people read it.
    pub(crate) fn shown(&self, joint: usize) -> String {
        let value = self.q[joint];
        match self.arm.chain.variables()[joint].kind.is_angular() {
            true => format!("{:.1}\u{b0}", value.to_degrees()),
            false => format!("{:.1} mm", value * 1000.0),
        }
    }
}

/// A ray with a direction of length 1.
fn read_ray(ray: &Ray) -> Result<(Point3<f64>, Unit<Vector3<f64>>), String> {
    let finite = ray
        .origin
        .iter()
        .chain(&ray.direction)
        .all(|x| x.is_finite());
    let direction = Unit::try_new(Vector3::from(ray.direction), 1e-12).filter(|_| finite);
    let direction = direction.ok_or("a ray with finite numbers and a direction was expected")?;
    Ok((Point3::from(ray.origin), direction))
}
