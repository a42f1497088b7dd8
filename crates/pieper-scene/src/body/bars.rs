//! The bars of four-bar linkages, which hang on no link of the arm: where they are follows from the joints.

use std::sync::Arc;

use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, Translation3, UnitQuaternion, Vector3};
use pieper::model::Chain;
use pieper::transmission::{Linkage, Transmission};

use super::procedural::{half_width, radius_at};
use super::{ACCENT, Body, Color, DARK, Part};
use crate::{Frames, Mesh, shapes};

/// Crank, coupler and rocker of one drive, beside an arm on [`Frames::Axes`](crate::Frames::Axes).
///
/// The plane of the linkage stands across the driven joint's axis, where the drums end. D lies on that axis, A on the axis of the joint that
/// turns the frame, or of the one before: the frame is as long as the axes are apart, and the other bars in proportion.
#[derive(Clone, Debug)]
pub struct Bars {
    /// The motor's name.
    pub motor: String,
    linkage: Linkage,
    /// The frames of the driven joint and of the one that A lies on.
    driven: usize,
    pivot: usize,
    /// +1 where the rocker's angle grows as the driven frame turns about its z axis.
    sense: f64,
    /// Metres for one of the linkage's lengths.
    scale: f64,
    /// From the frames' origins to the plane, along the driven axis; and how far the drums reach towards it, at D and at A.
    plane: f64,
    drums: [f64; 2],
    radius: f64,
}

impl Bars {
    /// The linkages of an arm's drives. One whose joints' axes are not parallel, or in line, is not drawn.
    pub fn of(chain: &Chain, transmission: &Transmission) -> Vec<Self> {
        let motors = transmission.all().iter();
        motors
            .filter_map(|motor| {
                let linkage = motor.linkage()?;
                let turned = motor.terms().first().map(|term| term.variable);
                Self::new(chain, motor.name(), linkage, turned)
            })
            .collect()
    }

    fn new(chain: &Chain, name: &str, linkage: &Linkage, turned: Option<usize>) -> Option<Self> {
        let steps = &chain.canonical().steps;
        let step_of = |variable| {
            steps
                .iter()
                .position(|step| step.drive.variable == variable)
        };
        let driven = step_of(linkage.rocker.variable)?;
        let pivot = match turned {
            Some(variable) => step_of(variable)?,
            None => driven.checked_sub(1)?,
        };
        let mut frames = Vec::new();
        Frames::Axes.at(chain, &vec![0.0; chain.dof()], &mut frames);
        let (one, other) = (frames[pivot + 1], frames[driven + 1]);
        let axis = other * Vector3::z();
        let is_parallel = (one * Vector3::z()).cross(&axis).norm() < 1e-6;
        let apart = across(&one, &other).norm();
        if !is_parallel || apart < 1e-6 {
            return None;
        }
        let widths = [driven, pivot].map(|step| half_width(chain, step));
        let radius = 0.2 * radius_at(chain, driven);
        Some(Self {
            motor: name.to_owned(),
            linkage: *linkage,
            driven: driven + 1,
            pivot: pivot + 1,
            sense: (linkage.rocker.factor * steps[driven].drive.factor).signum(),
            scale: apart / linkage.four_bar.lengths().frame,
            plane: widths[0].max(widths[1]) + 1.2 * radius,
            drums: widths,
            radius,
        })
    }

    /// The frame of the link that the rocker is fixed to.
    pub fn driven(&self) -> usize {
        self.driven
    }

    /// Crank, coupler and rocker, each on a frame of its own: z along the bar, x across the linkage's plane, away from the arm.
    fn parts(&self) -> [Vec<Part>; 3] {
        let lengths = self.linkage.four_bar.lengths();
        let part = |what: &str, mesh: Mesh, color: Color, placed: Isometry3<f64>| Part {
            name: format!("{what} of {}", self.motor),
            mesh: Arc::new(mesh),
            color,
            placed,
            collision: false,
        };
        let bar = |what: &str, length: f64, color: Color| {
            let mesh = shapes::limb(self.radius, self.radius, length * self.scale);
            part(what, mesh, color, Isometry3::identity())
        };
        // From the drum to the bar.
        let pin = |what: &str, drum: f64| {
            let length = self.plane - drum;
            let mesh = shapes::cylinder(0.7 * self.radius, length, 0.0);
            let turn = shapes::pointing(&Vector3::x());
            let place = Translation3::new(-0.5 * length, 0.0, 0.0);
            part(what, mesh, DARK, Isometry3::from_parts(place, turn))
        };
        [
            vec![
                bar("crank", lengths.crank, DARK),
                pin("crank", self.drums[1]),
            ],
            vec![bar("coupler", lengths.coupler, ACCENT)],
            vec![
                bar("rocker", lengths.rocker, DARK),
                pin("rocker", self.drums[0]),
            ],
        ]
    }

    /// Where the three are, the arm's frames standing at `frames`. Past a dead point they stay at it.
    pub fn poses(&self, frames: &[Isometry3<f64>], q: &[f64]) -> [Isometry3<f64>; 3] {
        let [a, b, c, d] = self.points(frames, q);
        let away = frames[self.driven] * Vector3::z();
        [(a, b), (b, c), (d, c)].map(|(from, to)| stand(&from, &to, &away))
    }

    /// A, B, C and D in the world.
    fn points(&self, frames: &[Isometry3<f64>], q: &[f64]) -> [Point3<f64>; 4] {
        let (pivot, driven) = (&frames[self.pivot], &frames[self.driven]);
        let z = driven * Vector3::z();
        let x = across(pivot, driven).normalize();
        // The rocker's angle counts from y towards x.
        let y = z.cross(&x) * -self.sense;
        let section = &self.linkage.section;
        let phi = section.place(self.linkage.rocker.displacement(q));
        let phi = phi.unwrap_or_else(|(end, _)| end.phi);
        let frame = self.linkage.four_bar.lengths().frame;
        let flat = [[0.0, 0.0], [0.0, 0.0], [frame, 0.0], [frame, 0.0]];
        let points = self.linkage.four_bar.points(phi).unwrap_or(flat);
        let corner = Point3::from(driven.translation.vector) + z * self.plane;
        points.map(|[px, py]| corner + (x * (px - frame) + y * py) * self.scale)
    }
}

impl Body {
    /// The body with the bars of its drives, three links for each behind its own.
    #[must_use]
    pub fn with_bars(mut self, bars: &[Bars]) -> Self {
        self.links.extend(bars.iter().flat_map(Bars::parts));
        self
    }
}

/// From the axis of one frame to that of another that is parallel, across both.
fn across(one: &Isometry3<f64>, other: &Isometry3<f64>) -> Vector3<f64> {
    let axis = other * Vector3::z();
    let way = other.translation.vector - one.translation.vector;
    way - axis * axis.dot(&way)
}

/// The frame at `from` with z towards `to` and x away from the arm.
fn stand(from: &Point3<f64>, to: &Point3<f64>, away: &Vector3<f64>) -> Isometry3<f64> {
    let z = (to - from).try_normalize(1e-12);
    let turn = z.map_or_else(UnitQuaternion::identity, |z| {
        let columns = Matrix3::from_columns(&[*away, z.cross(away), z]);
        UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(columns))
    });
    Isometry3::from_parts((*from).into(), turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bars keep their lengths and meet, C stays where it is on the driven link, and A on the link that the crank's motor is on.
    #[test]
    fn bars_meet_and_keep_their_lengths() {
        let robot = pieper_robots::find("abb-paper").unwrap().robot();
        let (chain, transmission) = (robot.chain().unwrap(), robot.transmission().unwrap());
        let all = Bars::of(&chain, &transmission);
        let [bars] = &all[..] else {
            panic!("one linkage was expected")
        };
        // The upper arm is the frame, in its own length.
        assert!((bars.scale - 1.0).abs() < 1e-9, "{}", bars.scale);
        let lengths = bars.linkage.four_bar.lengths();
        let mut random = fastrand::Rng::with_seed(6);
        let mut frames = Vec::new();
        let (mut at_c, mut at_a): (Option<Point3<f64>>, Option<Point3<f64>>) = (None, None);
        for _ in 0..200 {
            let value = |v: &pieper::model::Variable| {
                let limits = v.limits.unwrap();
                limits.lower() + random.f64() * (limits.upper() - limits.lower())
            };
            let q: Vec<f64> = chain.variables().iter().map(value).collect();
            if !matches!(transmission.motors(&q, &mut [0.0; 6]), Ok(Ok(()))) {
                continue;
            }
            Frames::Axes.at(&chain, &q, &mut frames);
            let [a, b, c, d] = bars.points(&frames, &q);
            for (from, to, length) in [
                (a, b, lengths.crank),
                (b, c, lengths.coupler),
                (c, d, lengths.rocker),
                (a, d, lengths.frame),
            ] {
                assert!(((to - from).norm() - length).abs() < 1e-9);
            }
            let on_link = frames[bars.driven].inverse() * c;
            assert!((at_c.get_or_insert(on_link).coords - on_link.coords).norm() < 1e-9);
            let on_base = frames[bars.pivot - 1].inverse() * a;
            assert!((at_a.get_or_insert(on_base).coords - on_base.coords).norm() < 1e-9);
            let poses = bars.poses(&frames, &q);
            let end = poses[0] * Point3::new(0.0, 0.0, lengths.crank);
            assert!((end - b).norm() < 1e-9);
        }
        assert!(at_c.is_some());
    }
}
