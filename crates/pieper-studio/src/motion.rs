//! Keyframes and tables as a motion, and where its clock stands.

use pieper::describe::{MotionTable, MotionValues};
use pieper::ik::Solver;
use pieper::kinematics::tool_pose;
use pieper::motion::{Law, Profile, State, TrackOptions, stations};
use pieper::spatial::Pose;
use serde::Serialize;

use crate::arm::Arm;

/// A posture at a time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Keyframe {
    pub(crate) id: u32,
    pub(crate) t: f64,
    pub(crate) q: Vec<f64>,
    pub(crate) label: String,
}

/// The motion of the studio.
#[derive(Clone, Debug)]
pub(crate) struct Motion {
    pub(crate) keyframes: Vec<Keyframe>,
    pub(crate) profile: Profile,
    pub(crate) name: Option<String>,
    next: u32,
    pub(crate) playing: bool,
    pub(crate) time: f64,
    pub(crate) speed: f64,
    pub(crate) repeat: bool,
    /// Grows with every change of the motion itself.
    pub(crate) revision: u32,
    law: Option<Law>,
    pub(crate) problem: Option<String>,
}

impl Default for Motion {
    fn default() -> Self {
        Self {
            keyframes: Vec::new(),
            profile: Profile::Quintic,
            name: None,
            next: 1,
            playing: false,
            time: 0.0,
            speed: 1.0,
            repeat: false,
            revision: 0,
            law: None,
            problem: None,
        }
    }
}

/// Time between a keyframe and the next added one, seconds.
const GAP: f64 = 2.0;

/// The most samples handed out.
const MOST_SAMPLES: f64 = 4000.0;

/// The most rows of a table that are shown as keyframes one can edit.
const MOST_ROWS: usize = 20_000;

impl Motion {
    /// Begins anew, as another motion.
    pub(crate) fn forget(&mut self) {
        *self = Self {
            revision: self.revision + 1,
            ..Self::default()
        };
    }

    /// Its end.
    pub(crate) fn duration(&self) -> f64 {
        self.keyframes.last().map_or(0.0, |keyframe| keyframe.t)
    }

    /// Makes the motion anew after its keyframes have changed.
    pub(crate) fn rebuild(&mut self) {
        self.revision += 1;
        self.keyframes.sort_by(|a, b| a.t.total_cmp(&b.t));
        let times: Vec<f64> = self.keyframes.iter().map(|k| k.t).collect();
        let rows = self.keyframes.iter().map(|k| k.q.clone()).collect();
        self.problem = None;
        self.law = match self.keyframes.len() {
            0 => None,
            _ => match Law::new(times, rows, self.profile) {
                Ok(law) => Some(law),
                Err(error) => {
                    self.problem = Some(error.to_string());
                    None
                }
            },
        };
        self.time = self.time.min(self.duration());
        if self.law.is_none() || self.keyframes.len() < 2 {
            self.playing = false;
        }
    }

    /// Adds a posture, at the end or at a time.
    pub(crate) fn add(&mut self, t: Option<f64>, q: Vec<f64>, label: Option<String>) -> u32 {
        let t = t.unwrap_or_else(|| self.keyframes.last().map_or(0.0, |last| last.t + GAP));
        let id = self.next;
        self.next += 1;
        let label = label.unwrap_or_else(|| format!("{id}"));
        self.keyframes.retain(|k| (k.t - t).abs() > 1e-9);
        self.keyframes.push(Keyframe { id, t, q, label });
        self.rebuild();
        id
    }

    /// The motion as it is, between two keyframes or more.
    pub(crate) fn law(&self) -> Option<&Law> {
        self.law.as_ref()
    }

    /// Joint values at a time.
    pub(crate) fn at(&self, t: f64) -> Option<Vec<f64>> {
        let mut state = State::default();
        self.law.as_ref()?.at(t, &mut state);
        Some(state.position)
    }

    /// Lets `dt` seconds pass on the viewer's clock.
    pub(crate) fn advance(&mut self, dt: f64) {
        let (time, end) = (self.time + dt * self.speed, self.duration());
        if time <= end {
            self.time = time;
        } else if self.repeat && end > 0.0 {
            self.time = time % end;
        } else {
            self.time = end;
            self.playing = false;
        }
    }

    /// A table in place of the keyframes.
    pub(crate) fn of_table(
        arm: &Arm,
        name: &str,
        text: &str,
    ) -> Result<Vec<(f64, Vec<f64>, String)>, String> {
        let table =
            MotionTable::from_csv(name, text, &arm.chain).map_err(|error| error.to_string())?;
        if table.times.len() > MOST_ROWS {
            return Err(format!(
                "{name}: it has {} rows, at most {MOST_ROWS} are shown; `pieper run` takes more",
                table.times.len()
            ));
        }
        let poses = match table.values {
            MotionValues::Joints(rows) => {
                return Ok(rows_of(&table.times, rows, table.marks.as_deref()));
            }
            MotionValues::Poses(poses) => poses,
            MotionValues::Points(points) => points.iter().map(|points| points.pose).collect(),
        };
        let solver: &Solver = &arm.solver;
        match stations(solver, &poses, &TrackOptions::default())
            .map_err(|error| error.to_string())?
        {
            pieper::motion::Stations::Rows(rows) => {
                Ok(rows_of(&table.times, rows, table.marks.as_deref()))
            }
            pieper::motion::Stations::Unreachable { index, reason } => Err(format!(
                "{name}: row {}, t = {} s: {reason}",
                index + 1,
                table.times[index]
            )),
        }
    }

    /// Values, rates and accelerations of the joints, and the tool's way, at evenly spaced times.
    pub(crate) fn samples(&self, arm: &Arm, rate: f64) -> Samples {
        let end = self.duration();
        let mut samples = Samples {
            q: vec![Vec::new(); arm.dof()],
            qd: vec![Vec::new(); arm.dof()],
            qdd: vec![Vec::new(); arm.dof()],
            ..Samples::default()
        };
        let Some(law) = self.law.as_ref().filter(|_| end > 0.0) else {
            return samples;
        };
        let count = (end * rate).ceil().clamp(2.0, MOST_SAMPLES) as usize;
        let mut state = State::default();
        for k in 0..=count {
            let t = end * k as f64 / count as f64;
            law.at(t, &mut state);
            samples.t.push(t);
            let tracks = [&mut samples.q, &mut samples.qd, &mut samples.qdd];
            let values = [&state.position, &state.rate, &state.acceleration];
            for (track, values) in tracks.into_iter().zip(values) {
                for (joint, value) in track.iter_mut().zip(values) {
                    joint.push(*value);
                }
            }
            // Never refused: a law's values are finite and as many as the arm's.
            let pose = tool_pose(&arm.chain, &state.position).unwrap_or_else(|_| Pose::identity());
            samples.tool.push(pose.translation.vector.into());
        }
        samples.tool_speed = (0..=count).map(|k| samples.speed(k)).collect();
        samples
    }
}

/// A motion at many times.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct Samples {
    /// Seconds.
    pub(crate) t: Vec<f64>,
    /// By joint, then by time.
    pub(crate) q: Vec<Vec<f64>>,
    pub(crate) qd: Vec<Vec<f64>>,
    pub(crate) qdd: Vec<Vec<f64>>,
    pub(crate) tool: Vec<[f64; 3]>,
    pub(crate) tool_speed: Vec<f64>,
}

impl Samples {
    /// The tool's speed by the samples beside one.
    fn speed(&self, k: usize) -> f64 {
        let (before, behind) = (k.saturating_sub(1), (k + 1).min(self.tool.len() - 1));
        let (a, b) = (self.tool[before], self.tool[behind]);
        let length = (0..3).map(|i| (b[i] - a[i]).powi(2)).sum::<f64>().sqrt();
        length / (self.t[behind] - self.t[before])
    }
}

fn rows_of(
    times: &[f64],
    rows: Vec<Vec<f64>>,
    marks: Option<&[String]>,
) -> Vec<(f64, Vec<f64>, String)> {
    let label = |k: usize| {
        marks
            .and_then(|marks| marks.get(k))
            .cloned()
            .unwrap_or_default()
    };
    times
        .iter()
        .zip(rows)
        .enumerate()
        .map(|(k, (&t, q))| (t, q, label(k)))
        .collect()
}
