//! Runs with the values of an output and its slopes.

use std::cell::RefCell;

use argmin::core::{CostFunction, Error, Gradient};

use super::Optimum;
use crate::fit::{Datum, Fit, TrialError};

/// A run with given variables.
#[derive(Debug, Clone)]
pub(super) struct Point {
    pub(super) theta: Vec<f64>,
    pub(super) values: Vec<f64>,
    pub(super) output: f64,
    /// Of the output, with respect to the variables.
    pub(super) slopes: Vec<f64>,
    /// The same with respect to θ, of what is to become least.
    pub(super) gradient: Vec<f64>,
}

/// What is to become least, from a point on, scaled so that the first step has a given length.
pub(super) struct Cost<'a> {
    optimum: &'a Optimum<'a>,
    fit: &'a Fit<'a>,
    /// The scaled slope at that point: the length of the first step, in θ.
    step: f64,
    unit: f64,
    first: f64,
    pub(super) seen: RefCell<Seen>,
}

/// What has been computed.
pub(super) struct Seen {
    pub(super) best: Point,
    /// The last θ, with what came of it.
    last: (Vec<f64>, Option<Point>),
    /// Why the last run that failed did.
    pub(super) failed: Option<TrialError>,
    pub(super) runs: usize,
    /// How often it was asked for a value or a slope.
    asked: usize,
}

/// Values and slopes that are asked for at most: a search of steps that are no numbers would have no end.
const MOST: usize = 2000;

impl<'a> Optimum<'a> {
    /// What was measured of an output, 0, with a deviation of 1: its residual is the output.
    pub(super) fn reading(&self) -> Fit<'a> {
        let datum = Datum { place: self.place, output: self.output.clone(), value: 0.0, deviation: 1.0 };
        let variables = self.variables.iter().map(|free| free.variable.clone()).collect();
        Fit { simulate: self.simulate, model: self.model, variables, data: vec![datum] }
    }

    pub(super) fn point(&self, fit: &Fit<'_>, theta: &[f64]) -> Result<Point, TrialError> {
        let placed: Vec<[f64; 2]> =
            self.variables.iter().zip(theta).map(|(free, theta)| free.value(*theta)).collect();
        let values: Vec<f64> = placed.iter().map(|[value, _]| *value).collect();
        let trial = fit.trial(&values)?;
        let jacobian = fit.jacobian(&trial)?;
        let slopes: Vec<f64> = jacobian.row(0).iter().copied().collect();
        let gradient =
            slopes.iter().zip(&placed).map(|(slope, [_, by_theta])| self.sign() * slope * by_theta).collect();
        Ok(Point { theta: theta.to_vec(), values, output: trial.residuals[0], slopes, gradient })
    }

    pub(super) fn sign(&self) -> f64 {
        if self.greatest { -1.0 } else { 1.0 }
    }
}

impl<'a> Cost<'a> {
    pub(super) fn new((optimum, fit): (&'a Optimum<'a>, &'a Fit<'a>), start: Point, step: f64) -> Self {
        let (unit, first) = (start.steepest(), start.output);
        let last = (start.theta.clone(), Some(start.clone()));
        let seen = RefCell::new(Seen { best: start, last, failed: None, runs: 0, asked: 0 });
        Self { optimum, fit, step, unit, first, seen }
    }

    fn cost_of(&self, output: f64) -> f64 {
        self.step * self.optimum.sign() * (output - self.first) / self.unit
    }

    /// The run with these θ; none where there is no such run.
    fn at(&self, theta: &[f64]) -> Result<Option<Point>, Error> {
        let mut seen = self.seen.borrow_mut();
        seen.asked += 1;
        if seen.asked > MOST || theta.iter().any(|theta| !theta.is_finite()) {
            return Err(Error::msg("no step is better"));
        }
        if seen.last.0 == theta {
            return Ok(seen.last.1.clone());
        }
        seen.runs += 1;
        let point = self.optimum.point(self.fit, theta).map_err(|why| seen.failed = Some(why)).ok();
        if let Some(point) = &point
            && self.cost_of(point.output) < self.cost_of(seen.best.output)
        {
            seen.best = point.clone();
        }
        seen.last = (theta.to_vec(), point.clone());
        Ok(point)
    }
}

impl Point {
    /// The largest slope by θ.
    pub(super) fn steepest(&self) -> f64 {
        self.gradient.iter().fold(0.0, |most: f64, slope| most.max(slope.abs()))
    }
}

/// As the search asks for it.
pub(super) struct Asked<'a>(pub(super) &'a Cost<'a>);

impl CostFunction for Asked<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    /// A run that fails is worse than the best one by a first step.
    fn cost(&self, theta: &Vec<f64>) -> Result<f64, Error> {
        let point = self.0.at(theta)?;
        let worse = || self.0.cost_of(self.0.seen.borrow().best.output) + self.0.step;
        Ok(point.map_or_else(worse, |point| self.0.cost_of(point.output)))
    }
}

impl Gradient for Asked<'_> {
    type Param = Vec<f64>;
    type Gradient = Vec<f64>;

    fn gradient(&self, theta: &Vec<f64>) -> Result<Vec<f64>, Error> {
        let scaled =
            |point: Point| point.gradient.iter().map(|slope| self.0.step * slope / self.0.unit).collect();
        Ok(self.0.at(theta)?.map_or_else(|| vec![0.0; theta.len()], scaled))
    }
}
