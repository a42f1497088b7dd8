//! From a path of the tool to continuous motions of the joints.
//!
//! All solutions are found at moments along the path, and each is linked with what it goes on as at the next moment.
//! Intervals are halved until the links are beyond doubt: the joints change by little, and moving them straight from
//! one moment to the next keeps the tool on its path. What is still open in an interval of no length is an event: two
//! branches meet and end, or the path leaves what a branch can reach.
//!
//! Where infinitely many solutions hang together (a straight wrist), the motion passes through the member that both
//! sides lead to. Where the sides lead to different members, the arm must stop and turn without moving its tool.
//!
//! ```
//! use pieper::describe::Robot;
//! use pieper::ik::Solver;
//! use pieper::kinematics::tool_pose;
//! use pieper::motion::{PoseLaw, Profile, TrackOptions, track};
//! let text = "name = 'elbow'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5\n[[joint]]\ntheta = 'q2'\na = 0.4";
//! let chain = Robot::from_toml("elbow.toml", text)?.chain()?;
//! let solver = Solver::new(&chain)?;
//! let rows = [[0.0, 0.7], [0.001, 0.7]].map(|q| tool_pose(&chain, &q)).into_iter().collect::<Result<_, _>>()?;
//! let law = PoseLaw::new(vec![0.0, 1.0], rows, Profile::Linear)?;
//! let tracks = track(&solver, &law, &TrackOptions::default(), &mut |_| ())?;
//! let best = tracks.best().expect("it is a short way");
//! assert!((best.rows[0][1] - 0.7).abs() < 1e-9);
//! # Ok::<(), pieper::Error>(())
//! ```

mod compose;
mod ending;
mod finish;
mod grid;
mod link;
mod plan;
mod redundant;
mod sample;
mod space;
mod standing;
mod stations;
mod strand;
mod windings;

use super::PoseLaw;
use crate::error::{Error, Result};
use crate::ik::{JointVector, Solver};
use compose::Motion;
pub use ending::{End, Event};
pub use plan::{Gap, Leg, Switch};
use sample::Sampler;
use space::Space;
use standing::Home;
pub use stations::{Stations, stations};

/// How a path is tracked.
#[derive(Clone, Debug, PartialEq)]
pub struct TrackOptions {
    /// How far the tool may be off the path between rows, in metres and in radians. At the rows it is exact.
    pub tolerance: f64,
    /// Joint values that the motion should start near.
    pub start: Option<Vec<f64>>,
    /// The most poses that are solved.
    pub budget: usize,
}

impl Default for TrackOptions {
    /// A tenth of a millimetre (and of a milliradian), no wish for the start, 300,000 poses.
    fn default() -> Self {
        Self {
            tolerance: 1e-4,
            start: None,
            budget: 300_000,
        }
    }
}

/// A continuous motion of the joints along the path, or along a part of it, within all limits.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// The name of the branch it starts in. It may go on in another: through a straight wrist, `flip` becomes `noflip`.
    pub branch: String,
    /// Moments, in seconds; equal ones are a standing turn.
    pub times: Vec<f64>,
    /// Joint values at these moments, radians and metres; straight between them. Angles go on without wrapping.
    pub rows: Vec<Vec<f64>>,
    /// How it ends.
    pub end: End,
    /// Moments at which the arm stops and turns its joints with the tool at rest, and the largest joint travel there.
    pub stops: Vec<(f64, f64)>,
    /// The largest rate of a joint, as part of its limit (of pi rad/s or 1 m/s where it has none).
    pub rate: f64,
    /// The sum of all joints' travel: radians, and metres by the arm's extent.
    pub travel: f64,
}

impl Track {
    /// When it starts.
    pub fn from(&self) -> f64 {
        self.times.first().copied().unwrap_or(0.0)
    }

    /// When it ends.
    pub fn to(&self) -> f64 {
        self.times.last().copied().unwrap_or(0.0)
    }

    /// Joint values at time `t`, before a standing turn if there is one; outside, those at the nearer end.
    pub fn at(&self, t: f64) -> Vec<f64> {
        let last = self.times.len() - 1;
        let after = self.times.partition_point(|&time| time < t).min(last);
        let Some(before) = after.checked_sub(1).filter(|_| t <= self.times[after]) else {
            return self.rows[after].clone();
        };
        let share = (t - self.times[before]) / (self.times[after] - self.times[before]);
        let pairs = self.rows[before].iter().zip(&self.rows[after]);
        pairs.map(|(a, b)| a + share * (b - a)).collect()
    }
}

impl Track {
    /// The part from one time to another: moments and joint values, with the ends between knots found on the straight
    /// line between them.
    pub fn part(&self, from: f64, to: f64) -> (Vec<f64>, Vec<Vec<f64>>) {
        let (mut times, mut rows) = (Vec::new(), Vec::new());
        let mut add = |time: f64, row: Vec<f64>| {
            times.push(time);
            rows.push(row);
        };
        if !self.times.contains(&from) {
            add(from.max(self.from()), self.at(from));
        }
        for (&time, row) in self.times.iter().zip(&self.rows) {
            if (from..=to).contains(&time) {
                add(time, row.clone());
            }
        }
        if !self.times.contains(&to) {
            add(to.min(self.to()), self.at(to));
        }
        (times, rows)
    }
}

/// How far the tool is off its path at most.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviation {
    /// Metres.
    pub position: f64,
    /// Radians.
    pub angle: f64,
    /// When.
    pub time: f64,
}

/// What became of all branches along a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Tracks {
    /// All motions: first those from the path's start on, then those that begin later.
    pub tracks: Vec<Track>,
    /// Index of the best motion that lives from the start of the path to its end.
    pub best: Option<usize>,
    /// The nearest alternative where none does: motions one after the other.
    pub legs: Vec<Leg>,
    /// Where the legs change from one motion to the next, off the path.
    pub switches: Vec<Switch>,
    /// Parts of the path for which there are no joint values at all.
    pub gaps: Vec<Gap>,
    /// What the best motion, or else the legs, miss the path by, measured at eight places between neighbouring knots.
    pub deviation: Deviation,
    /// How many poses were solved.
    pub solves: usize,
}

impl Tracks {
    /// The best motion, if one lives through the whole path: without stops if there is one; with a wish for the start,
    /// the one that starts nearest to it; then the one whose largest rate, relative to the limits, is smallest
    /// (differences below one per cent do not count); then the one of least travel.
    pub fn best(&self) -> Option<&Track> {
        self.best.map(|index| &self.tracks[index])
    }
}

/// Finds all continuous motions of the joints that move the tool along `law`.
///
/// An arm of up to six joints is followed in all its branches. One of more joints has infinitely many motions; there
/// the motion goes from each solution listed for the start, or from the one nearest to the wish for the start, always
/// by the least change of joints.
///
/// `progress` is told the share that is done, now and then.
///
/// # Errors
/// An input error for a tolerance that is not above zero, for a wish of the wrong length, and where the path needs
/// more poses than the budget has: the text names where refinement stopped.
pub fn track(
    solver: &Solver,
    law: &PoseLaw,
    options: &TrackOptions,
    progress: &mut dyn FnMut(f64),
) -> Result<Tracks> {
    if !(options.tolerance.is_finite() && options.tolerance > 0.0) {
        let subject = format!("tolerance {}", options.tolerance);
        return Err(Error::input(
            subject,
            "a finite number above 0 was expected",
        ));
    }
    let chain = solver.chain();
    if let Some(start) = &options.start {
        chain.check_joint_values(start)?;
    }
    let space = Space::new(chain);
    let home = Home {
        q: space.vector(options.start.as_deref().unwrap_or(&[])),
        is_asked_for: options.start.is_some(),
    };
    let mut sampler = Sampler::new(&space, law, solver);
    let mut found = Found::default();
    if chain.dof() > 6 {
        found.motions = redundant::motions(&mut sampler, &home, options, progress)?;
    } else {
        found.grid = grid::sample(&mut sampler, options.tolerance, options.budget, progress)?;
        found.strands = strand::strands(&found.grid);
        found.motions = compose::motions(
            &sampler,
            &found.grid,
            &found.strands,
            &home,
            options.tolerance,
        )?;
    }
    conclude(&mut sampler, &found, &home, options)
}

/// What tracking found, before limits.
#[derive(Default)]
struct Found {
    grid: grid::Grid,
    strands: Vec<strand::Strand>,
    motions: Vec<Motion>,
}

/// Cuts the motions at the limits, measures them and chooses.
fn conclude(
    sampler: &mut Sampler<'_>,
    found: &Found,
    home: &Home,
    options: &TrackOptions,
) -> Result<Tracks> {
    let (space, law) = (sampler.space, sampler.law);
    let mut tracks = Vec::new();
    let mut none_within = Vec::new();
    for motion in &found.motions {
        let pieces = windings::pieces(space, &motion.knots, &home.q);
        none_within.extend(ending::dead_at_start(
            space,
            motion,
            &pieces,
            law.times()[0],
        ));
        for piece in pieces {
            let end = match piece.stop {
                Some(stop) => ending::at_limit(&stop),
                None => ending::of(sampler, found, motion),
            };
            let knots = finish::thinned(space, law, &piece.knots, options.tolerance)?;
            tracks.push(make(space, motion.branch.to_string(), &knots, end));
        }
    }
    tracks.extend(none_within);
    let (start, finish) = (law.times()[0], law.times()[law.times().len() - 1]);
    tracks.sort_by_key(|track| track.from() > start);
    let best = choose(space, &tracks, home, start);
    let mut out = Tracks {
        tracks,
        best,
        legs: Vec::new(),
        switches: Vec::new(),
        gaps: Vec::new(),
        deviation: Deviation::default(),
        solves: 0,
    };
    match best {
        Some(index) => out.legs.push(Leg {
            track: index,
            from: start,
            to: finish,
        }),
        None => plan::plan(sampler, &mut out)?,
    }
    for leg in &out.legs {
        let track = &out.tracks[leg.track];
        let (times, rows) = track.part(leg.from, leg.to);
        let knots: Vec<compose::Knot> = times
            .iter()
            .zip(&rows)
            .map(|(&time, row)| compose::Knot {
                time,
                q: space.vector(row),
            })
            .collect();
        let (miss, time) = finish::deviation(space, law, &knots)?;
        let worst = &mut out.deviation;
        if miss.position > worst.position || miss.angle > worst.angle {
            worst.time = time;
        }
        worst.position = worst.position.max(miss.position);
        worst.angle = worst.angle.max(miss.angle);
    }
    out.solves = sampler.solves;
    Ok(out)
}

fn make(space: &Space<'_>, branch: String, knots: &[compose::Knot], end: End) -> Track {
    let (rate, travel) = finish::effort(space, knots);
    let mut stops: Vec<(f64, f64)> = Vec::new();
    for pair in knots.windows(2).filter(|pair| pair[0].time == pair[1].time) {
        let turned = space.size(&space::minus(&pair[1].q, &pair[0].q));
        match stops.last_mut().filter(|stop| stop.0 == pair[0].time) {
            Some(stop) => stop.1 += turned,
            None => stops.push((pair[0].time, turned)),
        }
    }
    let row = |q: &JointVector| q[..space.dof()].iter().map(|x| x + 0.0).collect();
    Track {
        branch,
        times: knots.iter().map(|knot| knot.time).collect(),
        rows: knots.iter().map(|knot| row(&knot.q)).collect(),
        end,
        stops,
        rate,
        travel,
    }
}

/// Rates that differ by less than this part are equal: they are measured on straight pieces.
const SAME_RATE: f64 = 0.01;

/// The best motion that lives through the whole path.
fn choose(space: &Space<'_>, tracks: &[Track], home: &Home, start: f64) -> Option<usize> {
    let distance = |track: &Track| match home.is_asked_for {
        true => space.size(&space::minus(&space.vector(&track.rows[0]), &home.q)),
        false => 0.0,
    };
    let better = |a: &Track, b: &Track| {
        let (near, other) = (distance(a), distance(b));
        if a.stops.len() != b.stops.len() {
            return a.stops.len() < b.stops.len();
        }
        if (near - other).abs() > 1e-9 {
            return near < other;
        }
        match (a.rate - b.rate).abs() > SAME_RATE * a.rate.max(b.rate) {
            true => a.rate < b.rate,
            false => a.travel < b.travel,
        }
    };
    let alive =
        (0..tracks.len()).filter(|&k| tracks[k].from() <= start && tracks[k].end == End::Alive);
    alive.fold(None, |best, k| match best {
        Some(kept) if !better(&tracks[k], &tracks[kept]) => Some(kept),
        _ => Some(k),
    })
}
