//! A motion, sampled: joint values and poses of the tool at every moment, and the reference positions among them.

use pieper::kinematics;
use pieper::model::Chain;
use pieper::motion::{Law, State};
use pieper::spatial::Pose;

use super::progress::Progress;
use crate::error::Failure;

/// A moment of the motion that has a name.
#[derive(Clone, Debug)]
pub(super) struct Mark {
    pub(super) label: String,
    /// Which sample it is.
    pub(super) sample: usize,
}

/// The samples of a motion.
pub(super) struct Recording {
    pub(super) times: Vec<f64>,
    pub(super) joints: Vec<Vec<f64>>,
    pub(super) poses: Vec<Pose>,
    /// The reference positions, at least one.
    pub(super) marks: Vec<Mark>,
}

impl Recording {
    /// Samples a motion. `names` are the moments that are reference positions, each among `times`; where none is, the
    /// first and the last moment are.
    pub(super) fn make(
        chain: &Chain,
        law: &Law,
        names: &[(f64, String)],
        times: Vec<f64>,
        progress: &mut Progress,
    ) -> Result<Self, Failure> {
        let mut state = State::default();
        let mut joints = Vec::with_capacity(times.len());
        let mut poses = Vec::with_capacity(times.len());
        for &time in &times {
            law.at(time, &mut state);
            poses.push(kinematics::tool_pose(chain, &state.position)?);
            joints.push(state.position.clone());
        }
        let mark = |(moment, label): &(f64, String)| Mark {
            label: label.clone(),
            sample: times.partition_point(|time| time < moment),
        };
        let marks = match names.is_empty() {
            false => names.iter().map(mark).collect(),
            true => ends(times.len()),
        };
        progress.advance();
        Ok(Self {
            times,
            joints,
            poses,
            marks,
        })
    }

    pub(super) fn duration(&self) -> f64 {
        match &self.times[..] {
            [first, .., last] => last - first,
            _ => 0.0,
        }
    }

    pub(super) fn time(&self, mark: &Mark) -> f64 {
        self.times[mark.sample]
    }

    /// The marks, if there are at most so many; else every second, fifth, tenth, ... of them, and the last.
    pub(super) fn some_marks(&self, most: usize) -> Vec<&Mark> {
        let last = self.marks.len() - 1;
        let mut steps = (0..18).flat_map(|power| [1, 2, 5].map(|step| step * 10_usize.pow(power)));
        let step = steps.find(|step| last.div_ceil(*step) < most).unwrap_or(1);
        let mut kept: Vec<&Mark> = self.marks.iter().step_by(step).collect();
        if !last.is_multiple_of(step) {
            kept.push(&self.marks[last]);
        }
        kept
    }
}

fn ends(samples: usize) -> Vec<Mark> {
    let mark = |label: &str, sample| Mark {
        label: label.to_owned(),
        sample,
    };
    let mut ends = vec![mark("start", 0), mark("end", samples - 1)];
    ends.dedup_by_key(|mark| mark.sample);
    ends
}
