//! What became of every branch along a path of the tool: for people, for programs, and for the report.

use std::fmt::Write as _;

use pieper::model::Chain;
use pieper::motion::{End, Gap, Track};
use pieper_plot::{Section, Table};
use serde_json::{Value, json};

use super::figures::Drawing;
use super::motion::Path;
use super::{Run, names};
use crate::text as columns;

/// The names of the files.
pub(super) const TEXT: &str = "certificate.txt";
pub(super) const JSON: &str = "certificate.json";

/// The name of the figure.
pub(super) const FIGURE: &str = "branches";

/// More branches than these are not listed in the report; the files have them all.
const MOST_LISTED: usize = 64;

/// More parts of a path without joint values than these are only counted.
const MOST_GAPS: usize = 8;

/// A path with the words that go with it.
pub(super) struct Certificate<'a> {
    pub(super) robot: &'a str,
    pub(super) motion: &'a str,
    pub(super) chain: &'a Chain,
    pub(super) path: &'a Path,
}

fn seconds(t: f64) -> String {
    format!("{} s", names::trimmed(t, 6))
}

/// A length or an angle too small for the units of the rest.
fn small(value: f64, unit: &str) -> String {
    match value {
        0.0 => format!("0 {unit}"),
        value => format!("{value:.1e} {unit}"),
    }
}

impl Certificate<'_> {
    fn span(&self) -> [f64; 2] {
        let times = &self.path.times;
        [times[0], times[times.len() - 1]]
    }

    /// The answer in one or two sentences.
    pub(super) fn verdict(&self) -> Vec<String> {
        let tracks = &self.path.tracks;
        let [start, end] = self.span();
        let (from, to) = (seconds(start), seconds(end));
        let Some(best) = tracks.best() else {
            let mut out = vec![format!(
                "No continuous motion of the joints follows the whole path from t = {from} to t = {to}."
            )];
            out.extend(self.latest());
            out.extend(tracks.gaps.iter().take(MOST_GAPS).map(|gap| self.gap(gap)));
            if tracks.gaps.len() > MOST_GAPS {
                out.push(format!(
                    "There are {} more such parts: {JSON} has them all.",
                    tracks.gaps.len() - MOST_GAPS
                ));
            }
            return out;
        };
        let mut out = format!(
            "A continuous motion follows the whole path from t = {from} to t = {to}: branch {}",
            self.name(tracks.best.unwrap_or(0))
        );
        let _ = write!(
            out,
            "; the largest rate of a joint is {} % of its limit",
            names::trimmed(100.0 * best.rate, 1)
        );
        out.push('.');
        let mut out = vec![out];
        out.extend(best.stops.iter().map(|stop| self.stop(stop)));
        out
    }

    fn stop(&self, &(time, turned): &(f64, f64)) -> String {
        format!(
            "At t = {} the arm stops and turns joints by {}° with its tool at rest: the path arrives at a singularity and leaves it in different directions.",
            seconds(time),
            names::trimmed(turned.to_degrees(), 3)
        )
    }

    /// How far the branch got that got farthest.
    fn latest(&self) -> Option<String> {
        let tracks = &self.path.tracks.tracks;
        let [start, _] = self.span();
        let alive =
            (0..tracks.len()).filter(|&k| tracks[k].from() <= start && tracks[k].to() > start);
        let last = alive.max_by(|&a, &b| tracks[a].to().total_cmp(&tracks[b].to()))?;
        let End::Dies { time, event } = &tracks[last].end else {
            return None;
        };
        Some(format!(
            "The one that gets farthest, branch {}, ends at t = {}: {}.",
            self.name(last),
            seconds(*time),
            event.sentence(self.chain)
        ))
    }

    fn gap(&self, gap: &Gap) -> String {
        let (from, to) = (seconds(gap.from), seconds(gap.to));
        match gap.worst {
            Some(worst) => format!(
                "From t = {from} to t = {to} the path cannot be reached at all; where it is worst: {worst}."
            ),
            None => format!(
                "From t = {from} to t = {to} there are joint values for the path, but none within the joints' limits."
            ),
        }
    }

    /// A branch's number and name.
    fn name(&self, index: usize) -> String {
        format!("{} ({})", index + 1, self.path.tracks.tracks[index].branch)
    }

    /// What becomes of a branch, and when.
    fn fate(&self, track: &Track) -> (String, String) {
        match &track.end {
            End::Alive => ("end".to_owned(), "lives to the end".to_owned()),
            End::Dies { time, event } => (seconds(*time), event.sentence(self.chain)),
        }
    }

    /// The nearest alternative, as sentences; empty where the path is followed.
    fn alternative(&self) -> Vec<String> {
        let tracks = &self.path.tracks;
        if self.path.is_followed() || tracks.legs.is_empty() {
            return Vec::new();
        }
        let mut out = Vec::new();
        for leg in &tracks.legs {
            let switch = tracks
                .switches
                .iter()
                .find(|switch| switch.time == leg.from);
            if let Some(switch) = switch {
                let joints = switch.travel.iter().zip(self.chain.variables());
                let moved = joints.map(|(way, variable)| match variable.kind.is_angular() {
                    true => format!("{}°", names::trimmed(way.to_degrees(), 1)),
                    false => format!("{} mm", names::trimmed(1000.0 * way, 1)),
                });
                out.push(format!(
                    "At t = {} change branches off the path: the joints move by {}.",
                    seconds(switch.time),
                    moved.collect::<Vec<_>>().join(", ")
                ));
            }
            out.push(format!(
                "From t = {} to t = {} follow the path in branch {}.",
                seconds(leg.from),
                seconds(leg.to),
                self.name(leg.track)
            ));
            let stops = &tracks.tracks[leg.track].stops;
            let on_leg = stops
                .iter()
                .filter(|stop| (leg.from..=leg.to).contains(&stop.0));
            out.extend(on_leg.map(|stop| self.stop(stop)));
        }
        out
    }

    fn accuracy(&self) -> String {
        let path = self.path;
        let deviation = &path.tracks.deviation;
        let tolerance = path.options.tolerance;
        let (position, angle) = (
            small(deviation.position, "m"),
            small(deviation.angle, "rad"),
        );
        let count = names::count(path.times.len(), "row", "rows");
        format!(
            "Between {count} the tool goes straight and turns about one axis. Measured at eight places between neighbouring knots of the joint motion, it is off that path by at most {position} and {angle} (allowed: {} and {}). {} poses were solved.",
            small(tolerance, "m"),
            small(tolerance, "rad"),
            path.tracks.solves
        )
    }

    /// The whole certificate as text.
    pub(super) fn text(&self) -> String {
        let mut out = format!("{}: certificate of {}\n\n", self.robot, self.motion);
        let lines = |out: &mut String, lines: &[String]| {
            lines.iter().for_each(|line| {
                let _ = writeln!(out, "{line}");
            });
        };
        lines(&mut out, &self.verdict());
        let alternative = self.alternative();
        if !alternative.is_empty() {
            out.push_str("\nThe nearest alternative\n");
            alternative.iter().for_each(|line| {
                let _ = writeln!(out, "  {line}");
            });
        }
        let _ = writeln!(out, "\n{}", self.accuracy());
        let [start, _] = self.span();
        let tracks = self.path.tracks.tracks.iter().enumerate();
        let (first, later): (Vec<_>, Vec<_>) = tracks.partition(|(_, t)| t.from() <= start);
        for (heading, list) in [
            ("Branches at the start of the path", first),
            (
                "Branches that begin later, or come back within the limits",
                later,
            ),
        ] {
            if list.is_empty() {
                continue;
            }
            let _ = writeln!(out, "\n{heading}");
            let mut rows = vec![
                ["", "branch", "from", "to", "rate", "travel"]
                    .map(str::to_owned)
                    .to_vec(),
            ];
            let mut fates = vec!["what becomes of it".to_owned()];
            for (index, track) in list {
                let (to, fate) = self.fate(track);
                rows.push(vec![
                    (index + 1).to_string(),
                    track.branch.clone(),
                    seconds(track.from()),
                    to,
                    format!("{} %", names::trimmed(100.0 * track.rate, 1)),
                    names::trimmed(track.travel, 3),
                ]);
                fates.push(fate);
            }
            for (line, fate) in columns::table(&rows).lines().zip(fates) {
                let _ = writeln!(out, "{line}  {fate}");
            }
        }
        out.push_str("\nrate: the largest rate of a joint, as part of its limit (180 deg/s or 1 m/s where it has none)\n");
        out.push_str(
            "travel: the sum over all joints, radians (a slide's length as part of the arm's)\n",
        );
        out
    }

    /// The whole certificate for programs.
    pub(super) fn document(&self) -> Value {
        let path = self.path;
        let tracks = &path.tracks;
        let branch = |(index, track): (usize, &Track)| {
            let (dies_at, why) = match &track.end {
                End::Alive => (Value::Null, Value::Null),
                End::Dies { time, event } => (json!(time), json!(event.sentence(self.chain))),
            };
            let stops = track
                .stops
                .iter()
                .map(|(t, turned)| json!({"t": t, "turned": turned}));
            json!({
                "number": index + 1,
                "branch": track.branch,
                "from": track.from(),
                "to": track.to(),
                "alive": track.end == End::Alive,
                "dies_at": dies_at,
                "why": why,
                "stops": stops.collect::<Value>(),
                "rate": track.rate,
                "travel": track.travel,
                "q_start": track.rows.first(),
                "q_end": track.rows.last(),
            })
        };
        let leg = |leg: &pieper::motion::Leg| json!({"number": leg.track + 1, "from": leg.from, "to": leg.to});
        let switch =
            |switch: &pieper::motion::Switch| json!({"t": switch.time, "travel": switch.travel});
        let gap = |gap: &Gap| {
            let why = match gap.worst {
                Some(worst) => worst.to_string(),
                None => "every solution lies outside the joints' limits".to_owned(),
            };
            json!({"from": gap.from, "to": gap.to, "why": why})
        };
        let [from, to] = self.span();
        json!({
            "robot": self.robot,
            "motion": self.motion,
            "units": "metres, radians, seconds",
            "followed": path.is_followed(),
            "verdict": self.verdict(),
            "from": from,
            "to": to,
            "chosen": tracks.best.map(|index| index + 1),
            "covered": path.covered,
            "tolerance": path.options.tolerance,
            "deviation": {
                "position": tracks.deviation.position,
                "angle": tracks.deviation.angle,
                "t": tracks.deviation.time,
            },
            "poses_solved": tracks.solves,
            "branches": tracks.tracks.iter().enumerate().map(branch).collect::<Value>(),
            "alternative": {
                "legs": tracks.legs.iter().map(leg).collect::<Value>(),
                "switches": tracks.switches.iter().map(switch).collect::<Value>(),
                "gaps": tracks.gaps.iter().map(gap).collect::<Value>(),
            },
        })
    }
}

/// The report's section on the path.
pub(super) fn section(run: &Run, path: &Path, drawn: &[Drawing]) -> Section {
    let certificate = run.certificate(path);
    let mut section = Section::new("Certificate");
    let verdict = certificate.verdict();
    section = match path.is_followed() {
        true => verdict.into_iter().fold(section, Section::paragraph),
        false => section.warnings(verdict),
    };
    let alternative = certificate.alternative();
    if !alternative.is_empty() {
        section = section.paragraph(format!(
            "The nearest alternative: {}",
            alternative.join(" ")
        ));
    }
    section = section.paragraph(certificate.accuracy());
    if let Some(drawing) = drawn.iter().find(|drawing| drawing.name == FIGURE) {
        section = section.figure(&drawing.figure, &drawing.caption);
    }
    let all = path.tracks.tracks.len();
    let caption = match all > MOST_LISTED {
        true => format!("Branches (the first {MOST_LISTED} of {all}; {JSON} has them all)"),
        false => "Branches".to_owned(),
    };
    let head = [
        "",
        "Branch",
        "from",
        "to",
        "largest rate",
        "travel",
        "what becomes of it",
    ];
    let table = Table::new(caption, head).words([1, 6]);
    let tracks = path.tracks.tracks.iter().take(MOST_LISTED).enumerate();
    section.table(tracks.fold(table, |table, (index, track)| {
        let (to, fate) = certificate.fate(track);
        table.row([
            (index + 1).to_string(),
            track.branch.clone(),
            seconds(track.from()),
            to,
            format!("{} %", names::trimmed(100.0 * track.rate, 1)),
            names::trimmed(track.travel, 2),
            fate,
        ])
    }))
}
