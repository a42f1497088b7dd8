//! A body for an arm that is only a table.

use std::sync::Arc;

use nalgebra::{Isometry3, Point3, Translation3, Unit, Vector3};
use pieper::model::{Chain, LinkShape};

use super::{ACCENT, Body, Color, DARK, Part, SHELL};
use crate::frames::isometry;
use crate::{Mesh, shapes};

impl Body {
    /// A body from a chain's geometry, on [`Frames::Axes`](crate::Frames::Axes).
    ///
    /// Each joint is a drum about its axis, held by the link before it; what turns in it are two dark caps. Links run along the
    /// common normals as tapered tubes, thinner towards the tool. Joints that slide are a sleeve with a rod, or a rail with a
    /// carriage where nothing turns before them. The foot stands on the ground: square to `up`, an axis of the base.
    ///
    /// ```
    /// use pieper_scene::Body;
    /// let ar3 = pieper_robots::find("ar3").unwrap().robot().chain()?;
    /// let body = Body::of_chain(&ar3, &nalgebra::Vector3::z_axis());
    /// assert_eq!(body.links.len(), 7);
    /// # Ok::<(), pieper::Error>(())
    /// ```
    pub fn of_chain(chain: &Chain, up: &Unit<Vector3<f64>>) -> Self {
        let builder = Builder::new(chain);
        let links = (0..=chain.canonical().steps.len())
            .map(|link| builder.link(link, up))
            .collect();
        Self {
            links,
            problems: Vec::new(),
        }
        .merged()
    }
}

/// One joint as a drum: where it stands on its axis, in the frame before its motion.
struct Drum {
    radius: f64,
    /// Height of its middle over the frame's origin.
    middle: f64,
    turns: bool,
    /// Travel of a joint that slides.
    travel: [f64; 2],
    /// A rail rather than a sleeve with a rod.
    rail: bool,
}

struct Builder<'a> {
    chain: &'a Chain,
    drums: Vec<Drum>,
}

/// The first drum's radius as part of the arm's whole length, and the last one's.
const RADII: [f64; 2] = [0.072, 0.034];

/// Lengths of drums in their radii.
const DRUM: f64 = 2.1;
/// How far the caps stand out of them.
const CAP: f64 = 0.16;

impl<'a> Builder<'a> {
    fn new(chain: &'a Chain) -> Self {
        let canonical = chain.canonical();
        let count = canonical.steps.len();
        let size = whole_length(chain);
        let radius = |index: usize| {
            let part = index as f64 / count.saturating_sub(1).max(1) as f64;
            size * (RADII[0] + (RADII[1] - RADII[0]) * part.sqrt())
        };
        let mut drums: Vec<Drum> = Vec::new();
        for (index, step) in canonical.steps.iter().enumerate() {
            let radius = radius(index);
            let spacing = index.checked_sub(1).map(|before| {
                let link = isometry(&canonical.link(before));
                (
                    link.translation.vector.norm(),
                    drums.get(before).map_or(0.0, |drum| drum.middle),
                )
            });
            // Axes that meet in a point would have their drums in each other: the later one moves out along its axis.
            let out = match step.link {
                LinkShape::Dh { d, .. } => d,
                LinkShape::General(pose) => pose.translation.vector.z,
            };
            let crowded = spacing.is_some_and(|(gap, _)| gap < 1.2 * radius);
            let middle = if crowded && out.abs() > radius {
                out.signum() * (1.25 * radius).min(0.7 * out.abs())
            } else {
                0.0
            };
            let limits = chain.variables()[step.drive.variable].limits;
            let travel = limits.map_or([0.0, 0.4 * size], |l| {
                let at = |q: f64| step.drive.factor * q + step.drive.offset;
                let ends = [at(l.lower()), at(l.upper())];
                [ends[0].min(ends[1]), ends[0].max(ends[1])]
            });
            drums.push(Drum {
                radius,
                middle,
                turns: step.turns,
                travel,
                rail: !step.turns && !canonical.steps[..index].iter().any(|step| step.turns),
            });
        }
        Self { chain, drums }
    }

    fn link(&self, link: usize, up: &Unit<Vector3<f64>>) -> Vec<Part> {
        let mut parts = Vec::new();
        match link {
            0 => self.foot(up, &mut parts),
            _ => self.moving(link - 1, &mut parts),
        }
        parts
    }

    /// The base: a foot on the ground and a column to the first joint, where it stands away from it.
    fn foot(&self, up: &Unit<Vector3<f64>>, parts: &mut Vec<Part>) {
        let Some(drum) = self.drums.first() else {
            return;
        };
        // Frame 0 is that of the first axis; the world's origin is where the arm is bolted down.
        let world = isometry(&self.chain.canonical().base).inverse();
        let ground = Point3::from(world.translation.vector);
        let r = drum.radius;
        if drum.rail {
            return self.hold(drum, Isometry3::identity(), parts);
        }
        let up = world * up.into_inner();
        let plate = Isometry3::from_parts(ground.into(), shapes::pointing(&up));
        let foot = [
            (0.0, 0.0),
            (1.75 * r, 0.0),
            (1.75 * r, 0.12 * r),
            (1.62 * r, 0.25 * r),
            (1.3 * r, 0.3 * r),
            (1.12 * r, 0.55 * r),
            (0.0, 0.55 * r),
        ];
        push(parts, "foot", shapes::turned(&foot), DARK, plate);
        let top = Point3::new(0.0, 0.0, 0.0);
        // Its round end stays above the ground.
        let column = (top - ground).norm();
        if let Some(upward) = (top - ground).try_normalize(1.05 * r) {
            let start = ground + upward * (1.05 * r).min(column);
            self.tube(&start, &top, (1.05 * r, 1.05 * r), parts);
            let sleeve = Isometry3::from_parts(start.into(), shapes::pointing(&upward));
            let height = 1.05 * r;
            push(
                parts,
                "column",
                shapes::cylinder(1.05 * r, height, 0.0),
                SHELL,
                sleeve * Translation3::new(0.0, 0.0, -0.5 * height),
            );
        }
        if let Some(up_frame) = shapes::along(&ground, &top).or(Some(plate)) {
            let away = (top - ground).norm();
            if away < 0.5 * r {
                // The first joint stands on the ground: a low turntable.
                let table =
                    Isometry3::from_parts(Translation3::from(ground.coords), up_frame.rotation);
                push(
                    parts,
                    "turntable",
                    shapes::cylinder(1.15 * r, 1.3 * r, 0.12 * r),
                    SHELL,
                    table * Translation3::new(0.0, 0.0, 0.65 * r),
                );
            } else {
                self.hold(drum, Isometry3::identity(), parts);
            }
        }
    }

    /// What moves with joint `index`: its caps, the limb behind it, and what holds the next joint.
    fn moving(&self, index: usize, parts: &mut Vec<Part>) {
        let drum = &self.drums[index];
        let r = drum.radius;
        let axis = |z: f64| Point3::new(0.0, 0.0, z);
        if drum.turns {
            let caps = shapes::cylinder(0.8 * r, (DRUM + 2.0 * CAP) * r, 0.1 * r);
            let first_on_ground =
                index == 0 && self.chain.canonical().base.translation.vector.norm() < 0.5 * r;
            if !first_on_ground {
                push(
                    parts,
                    "caps",
                    caps,
                    DARK,
                    Translation3::new(0.0, 0.0, drum.middle).into(),
                );
            }
        } else if drum.rail {
            push(
                parts,
                "carriage",
                shapes::block([2.4 * r, 2.4 * r, 2.0 * r], 0.2 * r),
                DARK,
                Isometry3::identity(),
            );
        } else {
            // The rod sticks out of its sleeve by as much as it may be drawn in.
            let back = (drum.travel[1] - drum.travel[0]) + 1.2 * r;
            push(
                parts,
                "rod",
                shapes::cylinder(0.55 * r, back + 0.6 * r, 0.05 * r),
                DARK,
                Translation3::new(0.0, 0.0, -0.5 * (back - 0.6 * r)).into(),
            );
        }
        let link = isometry(&self.chain.canonical().link(index));
        let (corner, end) = self.way(index, &link);
        let next = self.drums.get(index + 1);
        let thin = 0.66 * r;
        let start = axis(if drum.turns { drum.middle } else { 0.0 });
        match next {
            Some(next) => {
                let thinner = 0.66 * next.radius;
                self.tube(&start, &corner, (thin, 0.5 * (thin + thinner)), parts);
                let target = link * Point3::new(0.0, 0.0, next.middle);
                self.tube(&corner, &end, (0.5 * (thin + thinner), thinner), parts);
                self.tube(&end, &target, (thinner, thinner), parts);
                self.hold(next, link, parts);
            }
            None => self.hand(&start, &corner, &link, r, parts),
        }
    }

    /// The corner of a link on its own axis and its end on the next: along the axis first, then across.
    fn way(&self, index: usize, link: &Isometry3<f64>) -> (Point3<f64>, Point3<f64>) {
        let end = Point3::from(link.translation.vector);
        let along = match self.chain.canonical().steps[index].link {
            LinkShape::Dh { d, .. } => d,
            LinkShape::General(pose) => pose.translation.vector.z,
        };
        (Point3::new(0.0, 0.0, along), end)
    }

    /// The last link: a tapered hand, the flange, and a mark that shows how it is turned.
    fn hand(
        &self,
        start: &Point3<f64>,
        corner: &Point3<f64>,
        link: &Isometry3<f64>,
        r: f64,
        parts: &mut Vec<Part>,
    ) {
        let tool = Point3::from(link.translation.vector);
        // The flange stands where the last stretch ends, across it; of a hand without length, across the tool's z.
        let from = if (tool - corner).norm() > 0.3 * r {
            corner
        } else {
            start
        };
        let facing = (tool - from)
            .try_normalize(0.3 * r)
            .unwrap_or_else(|| link * Vector3::z());
        let thick = 0.28 * r;
        let neck = tool - facing * thick;
        if from == corner {
            self.tube(start, corner, (0.6 * r, 0.5 * r), parts);
        }
        self.tube(from, &neck, (0.6 * r, 0.42 * r), parts);
        let flange = Isometry3::from_parts(
            (tool - facing * (0.5 * thick)).into(),
            shapes::pointing(&facing),
        );
        push(
            parts,
            "flange",
            shapes::cylinder(0.72 * r, thick, 0.06 * r),
            DARK,
            flange,
        );
        // The mark lies to the tool's x.
        let side = link * Vector3::x();
        let side = (side - facing * side.dot(&facing))
            .try_normalize(0.1)
            .unwrap_or_else(|| link * Vector3::y());
        let mark =
            Isometry3::from_parts((tool + side * (0.46 * r)).into(), shapes::pointing(&facing));
        push(
            parts,
            "mark",
            shapes::cylinder(0.13 * r, 0.12 * r, 0.02 * r),
            ACCENT,
            mark,
        );
        push(
            parts,
            "ring",
            shapes::turned(&[
                (0.60 * r, -0.5 * thick),
                (0.735 * r, -0.28 * thick),
                (0.735 * r, 0.28 * thick),
                (0.60 * r, 0.5 * thick),
            ]),
            ACCENT,
            flange,
        );
    }

    /// What holds a joint, `at` its frame before it moves: a drum, a sleeve, or a rail.
    fn hold(&self, drum: &Drum, at: Isometry3<f64>, parts: &mut Vec<Part>) {
        let r = drum.radius;
        let middle = at * Translation3::new(0.0, 0.0, drum.middle);
        if drum.turns {
            push(
                parts,
                "drum",
                shapes::cylinder(r, DRUM * r, 0.16 * r),
                SHELL,
                middle,
            );
        } else if drum.rail {
            let [low, high] = drum.travel;
            let length = high - low + 3.0 * r;
            let rail = at * Translation3::new(0.0, 0.0, 0.5 * (low + high));
            push(
                parts,
                "rail",
                shapes::block([1.3 * r, 1.3 * r, length], 0.1 * r),
                SHELL,
                rail,
            );
        } else {
            push(
                parts,
                "sleeve",
                shapes::cylinder(1.05 * r, 1.8 * r, 0.16 * r),
                SHELL,
                middle,
            );
        }
    }

    fn tube(
        &self,
        from: &Point3<f64>,
        to: &Point3<f64>,
        (a, b): (f64, f64),
        parts: &mut Vec<Part>,
    ) {
        let length = (to - from).norm();
        if length < 0.15 * a {
            return;
        }
        if let Some(frame) = shapes::along(from, to) {
            push(parts, "limb", shapes::limb(a, b, length), SHELL, frame);
        }
    }
}

fn push(parts: &mut Vec<Part>, name: &str, mesh: Mesh, color: Color, placed: Isometry3<f64>) {
    parts.push(Part {
        name: name.to_owned(),
        mesh: Arc::new(mesh),
        color,
        placed,
        collision: false,
    });
}

/// The length of the arm stretched along its links, slides half drawn out; something where it has none.
fn whole_length(chain: &Chain) -> f64 {
    let canonical = chain.canonical();
    let mut length = canonical.base.translation.vector.norm();
    for (index, step) in canonical.steps.iter().enumerate() {
        let link = canonical.link(index).translation.vector;
        length += link.xy().norm() + link.z.abs();
        if !step.turns {
            let limits = chain.variables()[step.drive.variable].limits;
            length += limits.map_or(0.0, |l| 0.5 * (l.upper() - l.lower()).abs());
        }
    }
    if length > 1e-9 && length.is_finite() {
        length
    } else {
        1.0
    }
}

/// The radius of the drum of one joint.
pub(super) fn radius_at(chain: &Chain, step: usize) -> f64 {
    Builder::new(chain).drums[step].radius
}

/// How far the drum of one joint and its cap reach along the axis, from the frame's origin.
pub(super) fn half_width(chain: &Chain, step: usize) -> f64 {
    let drum = &Builder::new(chain).drums[step];
    drum.middle + drum.radius * (0.5 * DRUM + CAP)
}
