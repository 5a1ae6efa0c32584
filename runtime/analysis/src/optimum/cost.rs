//! Runs with the values of an output and its slopes.

use nalgebra::DVector;

use super::Optimum;
use crate::fit::{Datum, Fit, TrialError};

/// A run with given variables.
#[derive(Debug, Clone)]
pub(super) struct CostPoint {
    pub(super) theta: Vec<f64>,
    pub(super) values: Vec<f64>,
    pub(super) output: f64,
    /// Of the output, with respect to the variables.
    pub(super) slopes: Vec<f64>,
    /// The same with respect to θ, of what is to become least.
    pub(super) gradient: Vec<f64>,
}

/// What is to become least, with what has been computed of it.
pub(super) struct Cost<'a> {
    optimum: &'a Optimum<'a>,
    fit: &'a Fit<'a>,
    /// A run that fails is worse than the best one by so much.
    loss: f64,
    pub(super) best: CostPoint,
    /// Why the last run that failed did.
    pub(super) failed: Option<TrialError>,
    pub(super) runs: usize,
}

/// Runs of a search at most.
const MOST: usize = 1000;

impl<'a> Optimum<'a> {
    /// What was measured of an output, 0, with a deviation of 1: its residual is the output.
    pub(super) fn reading(&self) -> Fit<'a> {
        let datum = Datum { place: self.place, output: self.output.clone(), value: 0.0, deviation: 1.0 };
        let variables = self.variables.iter().map(|free| free.variable.clone()).collect();
        Fit { simulate: self.simulate, model: self.model, variables, data: vec![datum] }
    }

    pub(super) fn point(&self, fit: &Fit<'_>, theta: &[f64]) -> Result<CostPoint, TrialError> {
        let placed: Vec<[f64; 2]> =
            self.variables.iter().zip(theta).map(|(free, theta)| free.value(*theta)).collect();
        let values: Vec<f64> = placed.iter().map(|[value, _]| *value).collect();
        let trial = fit.trial(&values)?;
        let jacobian = fit.jacobian(&trial)?;
        let slopes: Vec<f64> = jacobian.row(0).iter().copied().collect();
        let gradient =
            slopes.iter().zip(&placed).map(|(slope, [_, by_theta])| self.sign() * slope * by_theta).collect();
        Ok(CostPoint { theta: theta.to_vec(), values, output: trial.residuals[0], slopes, gradient })
    }

    /// What is to become least.
    pub(super) fn cost(&self, point: &CostPoint) -> f64 {
        self.sign() * point.output
    }

    pub(super) fn sign(&self) -> f64 {
        if self.greatest { -1.0 } else { 1.0 }
    }
}

impl<'a> Cost<'a> {
    pub(super) fn new((optimum, fit): (&'a Optimum<'a>, &'a Fit<'a>), best: CostPoint, loss: f64) -> Self {
        Self { optimum, fit, loss, best, failed: None, runs: 0 }
    }

    /// The value with these θ and its slopes; none where the search is to end.
    pub(super) fn evaluate(&mut self, theta: &DVector<f64>) -> Option<(f64, DVector<f64>)> {
        if self.runs == MOST || theta.iter().any(|theta| !theta.is_finite()) {
            return None;
        }
        self.runs += 1;
        match self.optimum.point(self.fit, theta.as_slice()) {
            Ok(point) => {
                let value = self.optimum.cost(&point);
                let gradient = DVector::from_row_slice(&point.gradient);
                if value < self.optimum.cost(&self.best) {
                    self.best = point;
                }
                Some((value, gradient))
            }
            Err(why) => {
                self.failed = Some(why);
                Some((self.optimum.cost(&self.best) + self.loss, DVector::zeros(theta.len())))
            }
        }
    }
}

impl CostPoint {
    /// The largest slope by θ.
    pub(super) fn steepest(&self) -> f64 {
        self.gradient.iter().fold(0.0, |most: f64, slope| most.max(slope.abs()))
    }
}
