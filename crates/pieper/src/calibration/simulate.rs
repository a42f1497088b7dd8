//! Measurements of an arm whose numbers are a little wrong: for teaching, for tests, and for trying a plan before it is carried out.

use nalgebra::{Translation3, Vector3};

use super::model::Model;
use super::parameter::{Group, Unit};
use crate::describe::{Measurement, Readings, Seen};
use crate::error::{Error, Result};
use crate::spatial::{Pose, shift};

/// What is measured in a simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Whole poses of the tool.
    Poses,
    /// Where three points of the tool are, one after the other: as a tracker with one reflector that is moved.
    Positions,
    /// The distance to two anchors, as with a wire or a ball bar.
    Distances,
    /// Where the tool's point is.
    Position,
}

/// A seeded source of numbers.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The same numbers for the same seed.
    pub fn new(seed: u64) -> Self {
        // Small seeds are made large.
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    /// Evenly between 0 and 1.
    pub fn even(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Normally distributed, with standard deviation 1.
    pub fn normal(&mut self) -> f64 {
        let (u, v) = (self.even().max(1e-300), self.even());
        (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
    }
}

/// How a simulation is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Simulation {
    /// How many postures.
    pub count: usize,
    /// What is measured.
    pub kind: Kind,
    /// Standard deviation of the true lengths from the description's, metres.
    pub wrong_lengths: f64,
    /// And of angles, radians.
    pub wrong_angles: f64,
    /// Standard deviation of measured lengths, metres.
    pub sigma: f64,
    /// And of measured angles, radians.
    pub sigma_angle: f64,
    /// Whether what the arm tells are its motors' values, rather than its joints'.
    pub of_motors: bool,
    /// The share of measurements that are grossly wrong, by 10 mm and more.
    pub outliers: f64,
    /// The seed.
    pub seed: u64,
}

impl Default for Simulation {
    fn default() -> Self {
        Self {
            count: 60,
            kind: Kind::Poses,
            wrong_lengths: 1e-3,
            wrong_angles: 5e-3,
            sigma: 5e-5,
            sigma_angle: 0.01_f64.to_radians(),
            of_motors: false,
            outliers: 0.0,
            seed: 1,
        }
    }
}

/// The true values of the parameters, and the measurements.
///
/// # Errors
/// As [`measure`].
pub fn simulate(model: &Model, of: &Simulation) -> Result<(Vec<f64>, Vec<Measurement>)> {
    let mut random = Random::new(of.seed);
    let truth: Vec<f64> = model
        .parameters()
        .iter()
        .map(|parameter| {
            let wrong = match (parameter.group, parameter.unit) {
                (_, Unit::Angle) => of.wrong_angles,
                // A short length is made as exactly as a long one, in shares of it.
                (Group::Drive, Unit::Length) => of.wrong_angles * parameter.nominal,
                (_, Unit::Length | Unit::Ratio) => of.wrong_lengths,
            };
            parameter.nominal + wrong * random.normal()
        })
        .collect();
    let measurements = measure(model, &truth, of, &mut random)?;
    Ok((truth, measurements))
}

/// Measurements of the arm with these values of the parameters, at random postures.
///
/// # Errors
/// A model error where motor values are asked for, and the drives reach none of many postures.
pub fn measure(
    model: &Model,
    truth: &[f64],
    of: &Simulation,
    random: &mut Random,
) -> Result<Vec<Measurement>> {
    (0..of.count)
        .map(|number| {
            let readings = readings(model, truth, of.of_motors, random)?;
            Ok(measured(model, truth, (number, readings), of, random))
        })
        .collect()
}

/// What the arm tells at a random posture: of the postures that the true drives reach, where it tells its motors' values.
fn readings(
    model: &Model,
    truth: &[f64],
    of_motors: bool,
    random: &mut Random,
) -> Result<Readings> {
    for _ in 0..TRIES {
        let joints = posture(model, random);
        if !of_motors {
            return Ok(Readings::Joints(joints));
        }
        if let Some(motors) = model.motors(truth, &joints)? {
            return Ok(Readings::Motors(motors));
        }
    }
    let text = format!("the drives reach none of {TRIES} postures within the joints' limits");
    Err(Error::model("calibration", text))
}

/// The most postures to try for one that the drives reach.
const TRIES: usize = 1000;

/// Joint values within the limits; within half a turn either way where there are none, and half a metre.
pub fn posture(model: &Model, random: &mut Random) -> Vec<f64> {
    let value = |variable: &crate::model::Variable| {
        let usual = if variable.kind.is_angular() {
            std::f64::consts::PI
        } else {
            0.5
        };
        let [lower, upper] = variable
            .limits
            .map_or([-usual, usual], |limits| [limits.lower(), limits.upper()]);
        lower + (upper - lower) * random.even()
    };
    model.chain().variables().iter().map(value).collect()
}

/// The points of the tool that a tracker's reflector is put to.
const POINTS: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [0.08, 0.0, 0.0], [0.0, 0.08, 0.03]];

/// The anchors of wires.
const ANCHORS: [(&str, [f64; 3]); 2] = [("A", [0.9, 0.2, 0.1]), ("B", [0.1, -0.9, 0.4])];

fn measured(
    model: &Model,
    truth: &[f64],
    (number, readings): (usize, Readings),
    of: &Simulation,
    random: &mut Random,
) -> Measurement {
    let sensed = model.with(truth).sense(&readings);
    let tool = sensed.map_or_else(Pose::identity, |sensed| sensed.tool);
    let is_gross = random.even() < of.outliers;
    let gross = if is_gross {
        0.01 + 0.04 * random.even()
    } else {
        0.0
    };
    let mut noise = |sigma: f64| Vector3::from_fn(|_, _| sigma * random.normal());
    let shifted = noise(of.sigma) + noise(1.0).normalize() * gross;
    let turned = noise(of.sigma_angle);
    let seen = match of.kind {
        Kind::Poses => {
            let place = Translation3::from(tool.translation.vector + shifted);
            let turn = nalgebra::Rotation3::new(turned) * tool.rotation;
            Seen::Pose(Pose::from_parts(place, turn))
        }
        Kind::Position | Kind::Positions => {
            let at = match of.kind {
                Kind::Position => POINTS[0],
                _ => POINTS[number % POINTS.len()],
            };
            let point = (tool * shift(Vector3::from(at))).translation.vector + shifted;
            Seen::Position {
                point: point.into(),
                at,
            }
        }
        Kind::Distances => {
            let (anchor, place) = ANCHORS[number % ANCHORS.len()];
            let way = (tool.translation.vector - Vector3::from(place)).norm();
            Seen::Distance {
                anchor: anchor.to_owned(),
                distance: way + shifted.x,
                at: [0.0; 3],
            }
        }
    };
    Measurement {
        readings,
        seen,
        sigma: of.sigma,
        sigma_angle: of.sigma_angle,
    }
}
