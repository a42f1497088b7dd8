//! The model of the arm that is really there: which numbers of a table are wrong, from measurements, and how well they are known.
//!
//! [`Model`] is an arm's table as a list of elementary motions, each of which may be a parameter; [`Measurement`] is what was seen of the
//! tool; [`Calibration`] estimates by Levenberg-Marquardt. What the measurements cannot tell apart is named and held at its nominal
//! value, never silently spread over several parameters.
//!
//! ```
//! use pieper::calibration::{Calibration, Groups, Measurement, Model, Readings, Seen};
//! use pieper::describe::Robot;
//! let robot = |l2: &str| Robot::from_toml("two.toml", &format!(r#"
//! name = "two links"
//! convention = "standard"
//! [[joint]]
//! theta = "q1"
//! a = 0.3
//! [[joint]]
//! theta = "q2"
//! a = {l2}
//! "#));
//! // The second link is 2 mm longer than the table says.
//! let (nominal, real) = (robot("0.2")?, robot("0.202")?.chain()?);
//! let model = Model::of(&nominal, Groups { a: true, theta: true, ..Groups::NONE })?;
//! let seen = |k: u32| {
//!     let q = vec![0.3 * f64::from(k), 1.0 - 0.4 * f64::from(k)];
//!     let tool = pieper::kinematics::tool_pose(&real, &q)?;
//!     let point = tool.translation.vector.into();
//!     let seen = Seen::Position { point, at: [0.0; 3] };
//!     Ok(Measurement { readings: Readings::Joints(q), seen, sigma: 1e-4, sigma_angle: 1e-3 })
//! };
//! let measurements: Vec<_> = (0..10).map(seen).collect::<Result<_, pieper::Error>>()?;
//! let result = Calibration::new(model, measurements)?.run()?;
//! let a2 = result.estimates.iter().find(|p| p.name == "a2").unwrap();
//! assert!((a2.value - 0.202).abs() < 1e-9);
//! # Ok::<(), pieper::Error>(())
//! ```

mod columns;
mod design;
mod drives;
mod identify;
mod measurement;
mod model;
mod parameter;
mod place;
mod problem;
mod rebuild;
mod robust;
mod sense;
mod simulate;
mod solve;
mod validate;

pub use crate::describe::{Measurement, Readings, Seen};
pub use design::design;
pub use identify::{Held, Together};
pub use model::Model;
pub use parameter::{Group, Groups, Parameter, Unit};
pub use simulate::{Kind, Random, Simulation, measure, posture, simulate};
pub use solve::{Calibration, Estimate, Outcome, Residual};
pub use validate::HeldOut;
