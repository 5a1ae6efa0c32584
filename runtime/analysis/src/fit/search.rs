//! The way to the least sum of squares.

use nalgebra::{DMatrix, DVector};

use super::estimate::{estimates, is_held_up};
use super::trial::{Trial, TrialError};
use super::{Ending, Fit, FitError, Fitted};
use crate::numeric::least_squares::{self, Limits, Residuals, minimize};

/// Relative changes of the sum of squares and of the variables below this are none: some ten times
/// the error of a run.
const NOTHING: f64 = 1e-10;
/// Runs at most, for each variable and one more.
const PATIENCE: usize = 60;

/// The best trial so far.
struct Search<'a> {
    fit: &'a Fit<'a>,
    best: Trial,
    jacobian: DMatrix<f64>,
    /// The last trial, or why there is none, unless it is the best.
    other: Option<Result<Trial, TrialError>>,
    /// Why the last run that failed did.
    failed: Option<TrialError>,
    iterations: usize,
    runs: usize,
}

impl Fit<'_> {
    /// The values of the variables with the least sum of squares near those that the search begins
    /// with.
    ///
    /// A run that fails, that lacks what was measured, or that has no derivatives counts as too
    /// long a step.
    ///
    /// # Errors
    /// There are fewer values than variables; the first run cannot be compared with the data; the
    /// data do not determine a variable.
    pub fn solve(&self) -> Result<Fitted, FitError> {
        let [data, variables] = [self.data.len(), self.variables.len()];
        if variables == 0 {
            return Err(FitError::NoVariable);
        }
        if data < variables {
            return Err(FitError::TooFew { data, variables });
        }
        let values: Vec<f64> = self.variables.iter().map(|variable| variable.value).collect();
        let (best, jacobian) = self.differentiated(&values).map_err(FitError::Start)?;
        let (x, residuals) = (DVector::from_vec(values), best.residuals.clone());
        let begun = jacobian.clone();
        let mut search =
            Search { fit: self, best, jacobian, other: None, failed: None, iterations: 0, runs: 1 };
        let limits = Limits { tolerance: NOTHING, evaluations: PATIENCE * (variables + 1) };
        let (_, ending) = minimize(x, residuals, begun, limits, &mut search);
        let ending = search.ending(ending);
        let Search { best, jacobian, iterations, runs, .. } = search;
        let norm = best.residuals.norm();
        let freedom = data - variables;
        let scatter = (freedom > 0).then(|| norm / (freedom as f64).sqrt());
        let (estimates, correlations) = estimates(self, &best, &jacobian, scatter)?;
        let differences = self.data.iter().zip(&best.computed).map(|(datum, y)| y - datum.value);
        Ok(Fitted {
            estimates,
            correlations,
            residuals: differences.collect(),
            norm,
            freedom,
            scatter,
            iterations,
            runs,
            ending,
        })
    }

    fn differentiated(&self, values: &[f64]) -> Result<(Trial, DMatrix<f64>), TrialError> {
        let trial = self.trial(values)?;
        let jacobian = self.jacobian(&trial)?;
        Ok((trial, jacobian))
    }
}

impl Search<'_> {
    fn ending(&self, reached: least_squares::Termination) -> Ending {
        use least_squares::Termination::{Exhausted, Least, NoDerivatives, Short};
        // Short steps that gain a little lead to a bound as they do to a minimum.
        if let (Least | Short, Some(why)) = (reached, &self.failed)
            && is_held_up(self.fit, &self.best, &self.jacobian)
        {
            return Ending::Stopped(format!("no step leads on: {why}"));
        }
        match (reached, &self.other) {
            // Steps have become short because longer ones failed.
            (Short, Some(Err(why))) => Ending::Stopped(format!("no step leads on: {why}")),
            (Least | Short, _) => Ending::Converged,
            (Exhausted, _) => Ending::Stopped(format!("{} runs are the most", self.runs)),
            (NoDerivatives, _) => Ending::Stopped("the derivatives at a step are not finite".to_owned()),
        }
    }

    /// The run with these values, which is the best from now on if it comes nearer.
    fn attempt(&mut self, values: &[f64]) -> Result<Option<Trial>, TrialError> {
        let trial = self.fit.trial(values)?;
        if trial.residuals.norm() >= self.best.residuals.norm() {
            return Ok(Some(trial));
        }
        self.jacobian = self.fit.jacobian(&trial)?;
        self.best = trial;
        self.iterations += 1;
        Ok(None)
    }
}

impl Residuals for Search<'_> {
    fn residuals(&mut self, x: &DVector<f64>) -> Option<DVector<f64>> {
        self.runs += 1;
        self.other = self.attempt(x.as_slice()).transpose();
        match &self.other {
            None => Some(self.best.residuals.clone()),
            Some(Ok(trial)) => Some(trial.residuals.clone()),
            Some(Err(why)) => {
                self.failed = Some(why.clone());
                None
            }
        }
    }

    fn jacobian(&mut self) -> Option<DMatrix<f64>> {
        match &self.other {
            None => Some(self.jacobian.clone()),
            // Nearer than the last step that was taken, but not than one that gained too little to
            // be.
            Some(Ok(trial)) => self.fit.jacobian(trial).ok(),
            Some(Err(_)) => None,
        }
    }
}
