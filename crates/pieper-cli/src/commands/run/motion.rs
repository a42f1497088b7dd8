//! The motion that a table asks for: joint values as they are given, or found for a path of the tool.

use pieper::describe::{MotionTable, MotionValues};
use pieper::ik::Solver;
use pieper::model::Chain;
use pieper::motion::{Law, Leg, PoseLaw, Profile, Stations, TrackOptions, Tracks, stations, track};

use super::progress::Progress;
use crate::error::Failure;

/// Tables without marks and with more rows than these have two reference positions, the first row and the last: a pose
/// for each would make large files that nobody reads.
const MOST_UNMARKED: usize = 24;

/// What a table's rows become.
pub(super) struct Motion {
    /// Joint values over time.
    pub(super) law: Law,
    /// The times of the table's rows, as far as the motion goes.
    pub(super) rows: Vec<f64>,
    /// The reference positions.
    pub(super) marks: Vec<(f64, String)>,
    /// What to say where only two of many rows are reference positions.
    pub(super) note: Option<String>,
    /// For a path of the tool: what became of it.
    pub(super) path: Option<Path>,
}

/// A path of the tool, and the joint motions found for it.
pub(super) struct Path {
    pub(super) tracks: Tracks,
    pub(super) options: TrackOptions,
    /// Times of the table.
    pub(super) times: Vec<f64>,
    /// The part of the path that the motion covers; `None` if there is no motion at all.
    pub(super) covered: Option<[f64; 2]>,
    /// Moments at which the path waits, and for how long.
    pub(super) waits: Vec<Wait>,
}

/// The joints move while the path waits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wait {
    pub(super) time: f64,
    pub(super) duration: f64,
}

impl Path {
    /// Whether a continuous motion follows the whole path.
    pub(super) fn is_followed(&self) -> bool {
        self.tracks.best.is_some()
    }

    /// When the motion is where the path is at time `t`: later by all waits before.
    fn clock(&self, t: f64) -> f64 {
        let before = self.waits.iter().filter(|wait| wait.time < t);
        t + before.map(|wait| wait.duration).sum::<f64>()
    }
}

/// How a path is to be followed.
pub(super) struct Wishes {
    pub(super) profile: Profile,
    /// Whether the joints go straight between poses, not the tool.
    pub(super) joints_go_straight: bool,
    pub(super) options: TrackOptions,
}

/// Reads a table's values as a motion.
pub(super) fn of(
    chain: &Chain,
    table: MotionTable,
    wishes: Wishes,
    progress: &mut Progress,
) -> Result<Found, Failure> {
    let (names, note) = reference_positions(&table);
    let poses = match table.values {
        MotionValues::Joints(rows) => {
            return between_stations(
                Stations::Rows(rows),
                table.times,
                &names,
                note,
                wishes.profile,
            );
        }
        MotionValues::Poses(poses) => poses,
        MotionValues::Points(points) => points.iter().map(|points| points.pose).collect(),
    };
    let solver = Solver::new(chain)?;
    if wishes.joints_go_straight {
        let found = stations(&solver, &poses, &wishes.options)?;
        return between_stations(found, table.times, &names, note, wishes.profile);
    }
    let law = PoseLaw::new(table.times, poses, wishes.profile)?;
    let tracks = track(&solver, &law, &wishes.options, &mut |share| {
        progress.track(share);
    })?;
    let mut path = Path {
        tracks,
        options: wishes.options,
        times: law.times().to_vec(),
        covered: None,
        waits: Vec::new(),
    };
    let Some(law) = execute(chain, &mut path)? else {
        return Ok(Found::Nothing(Box::new(path)));
    };
    let [from, to] = path.covered.unwrap_or_default();
    let moment = |t: f64| (from..=to).contains(&t).then(|| path.clock(t));
    let (first, last) = (law.times()[0], law.times()[law.times().len() - 1]);
    let mut rows: Vec<f64> = path.times.iter().filter_map(|&t| moment(t)).collect();
    // Where the motion starts late or ends early, these moments count as rows.
    if rows.first() != Some(&first) {
        rows.insert(0, first);
    }
    if rows.last() != Some(&last) {
        rows.push(last);
    }
    Ok(Found::Motion(Box::new(Motion {
        marks: named(&names, &path.times, moment),
        law,
        rows,
        note,
        path: Some(path),
    })))
}

/// A motion that goes straight in joint space from pose to pose.
fn between_stations(
    found: Stations,
    times: Vec<f64>,
    names: &[(usize, String)],
    note: Option<String>,
    profile: Profile,
) -> Result<Found, Failure> {
    let rows = match found {
        Stations::Rows(rows) => rows,
        Stations::Unreachable { index, reason } => {
            return Ok(Found::Unreachable {
                row: index + 1,
                time: times[index],
                reason,
            });
        }
    };
    Ok(Found::Motion(Box::new(Motion {
        law: Law::new(times.clone(), rows, profile)?,
        marks: named(names, &times, Some),
        rows: times,
        note,
        path: None,
    })))
}

/// What a table led to.
pub(super) enum Found {
    /// A motion of the joints.
    Motion(Box<Motion>),
    /// A pose that the arm cannot take, where every one was to be met.
    Unreachable {
        /// Counted from 1.
        row: usize,
        time: f64,
        reason: String,
    },
    /// No part of the path can be reached.
    Nothing(Box<Path>),
}

fn reference_positions(table: &MotionTable) -> (Vec<(usize, String)>, Option<String>) {
    let all = table.reference_positions();
    let rows = table.times.len();
    if table.marks.is_some() || rows <= MOST_UNMARKED {
        return (all, None);
    }
    let ends = [all[0].clone(), all[rows - 1].clone()].to_vec();
    let note = format!(
        "The table has no column mark and {rows} rows, so only its first and its last row are reference positions."
    );
    (ends, Some(note))
}

fn named(
    names: &[(usize, String)],
    times: &[f64],
    moment: impl Fn(f64) -> Option<f64>,
) -> Vec<(f64, String)> {
    let named = names.iter().filter_map(|(row, name)| {
        let moment = moment(times[*row])?;
        Some((moment, name.clone()))
    });
    named.collect()
}

/// Values this little outside a limit are at it.
const AT_LIMIT: f64 = 1e-8;

/// Turning on the spot and changing branches is done at this part of the joints' largest rates.
const UNHURRIED: f64 = 0.5;

/// The longest motion along legs of a path without a gap between them. The path waits where joints turn on the spot and
/// where one leg changes to the next.
fn execute(chain: &Chain, path: &mut Path) -> Result<Option<Law>, Failure> {
    let (mut times, mut rows): (Vec<f64>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
    let mut delay = 0.0;
    let gaps = &path.tracks.gaps;
    let is_broken = |a: &Leg, b: &Leg| gaps.iter().any(|gap| a.to <= gap.from && gap.to <= b.from);
    let stretches = path.tracks.legs.chunk_by(|a, b| !is_broken(a, b));
    let span = |legs: &[Leg]| legs[legs.len() - 1].to - legs[0].from;
    // Of equal ones the first.
    let longest = stretches.reduce(|a, b| if span(b) > span(a) { b } else { a });
    let Some(legs) = longest else {
        return Ok(None);
    };
    for leg in legs {
        let (moments, values) = path.tracks.tracks[leg.track].part(leg.from, leg.to);
        for (time, mut row) in moments.into_iter().zip(values) {
            into_limits(chain, &mut row);
            if let (Some(last), Some(before)) = (times.last(), rows.last())
                && time + delay <= *last
            {
                let duration = duration(chain, before, &row);
                if duration == 0.0 {
                    continue;
                }
                delay += duration;
                path.waits.push(Wait { time, duration });
            }
            times.push(time + delay);
            rows.push(row);
        }
    }
    path.covered = Some([legs[0].from, legs[legs.len() - 1].to]);
    Ok(Some(Law::new(times, rows, Profile::Linear)?))
}

fn into_limits(chain: &Chain, row: &mut [f64]) {
    for (value, variable) in row.iter_mut().zip(chain.variables()) {
        if let Some(limits) = variable.limits {
            let near = value.clamp(limits.lower(), limits.upper());
            if (near - *value).abs() < AT_LIMIT {
                *value = near;
            }
        }
    }
}

fn duration(chain: &Chain, from: &[f64], to: &[f64]) -> f64 {
    let joints = chain.variables().iter().zip(from.iter().zip(to));
    joints.fold(0.0, |longest: f64, (variable, (a, b))| {
        let usual = match variable.kind.is_angular() {
            true => std::f64::consts::PI,
            false => 1.0,
        };
        let rate = variable
            .velocity
            .filter(|rate| *rate > 0.0)
            .unwrap_or(usual);
        longest.max((b - a).abs() / (UNHURRIED * rate))
    })
}
