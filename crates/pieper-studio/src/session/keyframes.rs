//! The motion: keyframes, tables, and the clock.

use pieper::motion::Profile;
use serde_json::{Value, json};

use super::Session;
use crate::command::KeyframeOp;
use crate::motion::Motion;
use crate::sections::Section;

/// The latest time of a keyframe: a day.
const LATEST: f64 = 86_400.0;

impl Session {
    pub(super) fn keyframe(
        &mut self,
        op: KeyframeOp,
        id: Option<u32>,
        t: Option<f64>,
        label: Option<String>,
        gesture: Option<&str>,
    ) -> Result<Value, String> {
        if let Some(t) = t.filter(|t| !(0.0..=LATEST).contains(t)) {
            return Err(format!("t = {t}: a time from 0 to {LATEST} s was expected"));
        }
        let place = || -> Result<usize, String> {
            let id = id.ok_or("keyframe: the id of one was expected")?;
            let place = self.motion.keyframes.iter().position(|k| k.id == id);
            place.ok_or_else(|| format!("keyframe {id}: there is no such keyframe"))
        };
        let mut value = Value::Null;
        match op {
            KeyframeOp::Add => {
                self.remember("add keyframe", None);
                let id = self.motion.add(t, self.q.clone(), label);
                let at = self
                    .motion
                    .keyframes
                    .iter()
                    .find(|k| k.id == id)
                    .map_or(0.0, |k| k.t);
                self.motion.time = at;
                value = json!({"id": id});
            }
            KeyframeOp::Move => {
                let (place, t) = (place()?, t.ok_or("t: a time was expected")?);
                if self
                    .motion
                    .keyframes
                    .iter()
                    .enumerate()
                    .any(|(k, other)| k != place && (other.t - t).abs() < 1e-6)
                {
                    return Err(format!("t = {t} s: there is another keyframe at that time"));
                }
                self.remember("move keyframe", gesture);
                self.motion.keyframes[place].t = t;
            }
            KeyframeOp::Set => {
                let place = place()?;
                self.remember("set keyframe", None);
                self.motion.keyframes[place].q.clone_from(&self.q);
            }
            KeyframeOp::Rename => {
                let (place, label) = (place()?, label.ok_or("label: a name was expected")?);
                self.remember("rename keyframe", None);
                self.motion.keyframes[place].label = label.chars().take(80).collect();
            }
            KeyframeOp::Remove => {
                let place = place()?;
                self.remember("remove keyframe", None);
                self.motion.keyframes.remove(place);
            }
            KeyframeOp::Clear => {
                self.remember("clear motion", None);
                self.motion.keyframes.clear();
                self.motion.name = None;
            }
            KeyframeOp::Goto => {
                let t = self.motion.keyframes[place()?].t;
                self.seek(t);
                return Ok(Value::Null);
            }
        }
        self.motion.rebuild();
        self.touch(&[Section::Motion]);
        Ok(value)
    }

    pub(super) fn table(&mut self, name: &str, text: &str) -> Result<Value, String> {
        let rows = Motion::of_table(&self.arm, name, text)?;
        let count = rows.len();
        self.remember("motion table", None);
        self.motion.keyframes.clear();
        for (t, q, label) in rows {
            self.motion.keyframes.push(crate::motion::Keyframe {
                id: self.motion.keyframes.len() as u32 + 1,
                t,
                q,
                label,
            });
        }
        self.motion.profile = Profile::Linear;
        self.motion.name = Some(name.to_owned());
        self.motion.time = 0.0;
        self.motion.rebuild();
        self.seek(0.0);
        Ok(json!({"rows": count}))
    }

    pub(super) fn law(&mut self, to: &str) -> Result<Value, String> {
        let profile = Profile::ALL
            .into_iter()
            .find(|profile| profile.name() == to);
        let names = Profile::ALL.map(Profile::name).join(", ");
        self.motion.profile =
            profile.ok_or_else(|| format!("{to}: one of {names} was expected"))?;
        self.motion.rebuild();
        self.touch(&[Section::Motion]);
        Ok(Value::Null)
    }

    pub(super) fn play(&mut self) -> Result<Value, String> {
        if self.motion.keyframes.len() < 2 {
            return Err("a motion of two keyframes or more was expected: add the present posture as a keyframe, move, add again".to_owned());
        }
        if let Some(problem) = &self.motion.problem {
            return Err(problem.clone());
        }
        if self.motion.time >= self.motion.duration() {
            self.motion.time = 0.0;
        }
        self.remember("play", Some("play"));
        self.missed = None;
        self.motion.playing = true;
        self.touch(&[Section::Motion, Section::Frame]);
        Ok(Value::Null)
    }

    pub(super) fn seek(&mut self, t: f64) {
        self.motion.time = t.clamp(0.0, self.motion.duration());
        if let Some(q) = self.motion.at(self.motion.time) {
            let playing = self.motion.playing;
            self.remember("seek", Some("play"));
            self.set(q);
            self.motion.playing = playing;
        }
        self.touch(&[Section::Motion]);
    }
}
