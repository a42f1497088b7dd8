//! Residuals and their rates as the solver wants them.

// The solver's own version of the matrix types: it has not followed ours yet, and its vectors are copied.
use levenberg_marquardt::LeastSquaresProblem;
use nalgebra::Vector3;
use solver_nalgebra::storage::Owned;
use solver_nalgebra::{DMatrix, DVector, Dyn};

use super::model::Model;
use super::parameter::{Group, Parameter, Unit};
use crate::describe::Measurement;

/// An anchor, a plane or a contact that is estimated with the arm.
#[derive(Clone, Debug)]
pub(super) struct Set {
    pub(super) kind: &'static str,
    pub(super) name: String,
    /// A plane's normal at the start.
    pub(super) normal: Vector3<f64>,
}

/// The residual of what the drives cannot reach with some values of their numbers, in standard deviations: a step there is taken back.
const BEYOND: f64 = 1e6;

/// What is fitted.
#[derive(Clone, Debug)]
pub(super) struct Problem {
    pub(super) model: Model,
    pub(super) measurements: Vec<Measurement>,
    pub(super) sets: Vec<Set>,
    /// Which set a measurement is of.
    pub(super) set_of: Vec<Option<usize>>,
    /// All parameters: the model's, then three for each set.
    pub(super) parameters: Vec<Parameter>,
    pub(super) values: Vec<f64>,
    /// The parameters that are fitted.
    pub(super) free: Vec<usize>,
    /// How much each measurement counts, 0 to 1.
    pub(super) weights: Vec<f64>,
}

impl Problem {
    /// The first residual of each measurement, and their number at the end.
    pub(super) fn starts(&self) -> Vec<usize> {
        let mut starts = vec![0];
        for measurement in &self.measurements {
            starts.push(starts[starts.len() - 1] + measurement.seen.count());
        }
        starts
    }

    /// Residuals in standard deviations without weights, and their rates by all parameters, one column each.
    pub(super) fn rows(&self, with_rates: bool) -> (Vec<f64>, Option<nalgebra::DMatrix<f64>>) {
        let own = self.model.parameters().len();
        let starts = self.starts();
        let count = starts[self.measurements.len()];
        let mut residuals = Vec::with_capacity(count);
        let mut rates = with_rates.then(|| nalgebra::DMatrix::zeros(count, self.parameters.len()));
        let arm = self.model.with(&self.values);
        for (index, measurement) in self.measurements.iter().enumerate() {
            let Some(sensed) = arm.sense(&measurement.readings) else {
                residuals.extend(std::iter::repeat_n(BEYOND, measurement.seen.count()));
                continue;
            };
            let set = self.set_of[index];
            let (numbers, normal) = match set {
                Some(set) => {
                    let at = own + 3 * set;
                    let numbers = [self.values[at], self.values[at + 1], self.values[at + 2]];
                    (numbers, self.sets[set].normal)
                }
                None => ([0.0; 3], Vector3::z()),
            };
            for row in measurement.rows(&sensed, &numbers, &normal) {
                if let Some(rates) = &mut rates {
                    let at = residuals.len();
                    for (parameter, rate) in row.by_model.iter().enumerate() {
                        rates[(at, parameter)] = *rate;
                    }
                    if let Some(set) = set {
                        for (k, rate) in row.by_set.iter().enumerate() {
                            rates[(at, own + 3 * set + k)] = *rate;
                        }
                    }
                }
                residuals.push(row.value);
            }
        }
        (residuals, rates)
    }

    /// The weight of each residual: its measurement's.
    fn roots(&self) -> Vec<f64> {
        let counts = self.measurements.iter().map(|m| m.seen.count());
        let weights = counts.zip(&self.weights);
        weights
            .flat_map(|(count, weight)| std::iter::repeat_n(weight.sqrt(), count))
            .collect()
    }

    /// The parameters of the sets.
    pub(super) fn set_parameters(kind: &str, name: &str) -> [Parameter; 3] {
        let (words, is_angle) = match kind {
            "plane" => (["offset", "slope1", "slope2"], [false, true, true]),
            _ => (["x", "y", "z"], [false; 3]),
        };
        std::array::from_fn(|k| Parameter {
            name: format!("{kind} {name}.{}", words[k]),
            group: Group::Set,
            unit: if is_angle[k] {
                Unit::Angle
            } else {
                Unit::Length
            },
            nominal: 0.0,
            spread: if is_angle[k] { 0.17 } else { 0.1 },
        })
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Problem {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    // In units of their spreads, so that lengths and angles weigh alike.
    fn set_params(&mut self, x: &DVector<f64>) {
        for (value, &index) in x.iter().zip(&self.free) {
            let of = &self.parameters[index];
            self.values[index] = of.nominal + value * of.spread;
        }
    }

    fn params(&self) -> DVector<f64> {
        let scaled = self.free.iter().map(|&index| {
            let of = &self.parameters[index];
            (self.values[index] - of.nominal) / of.spread
        });
        DVector::from_iterator(self.free.len(), scaled)
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let (residuals, _) = self.rows(false);
        let weighted = residuals.iter().zip(self.roots()).map(|(r, w)| r * w);
        Some(DVector::from_iterator(residuals.len(), weighted))
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let (_, rates) = self.rows(true);
        let rates = rates?;
        let roots = self.roots();
        Some(DMatrix::from_fn(
            rates.nrows(),
            self.free.len(),
            |row, column| {
                let index = self.free[column];
                rates[(row, index)] * self.parameters[index].spread * roots[row]
            },
        ))
    }
}
