//! The way to the least sum of squares.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use levenberg_nalgebra::storage::Owned;
use levenberg_nalgebra::{DMatrix as LmMatrix, DVector as LmVector, Dyn};
use nalgebra::DMatrix;

use super::estimate::{estimates, is_held_up};
use super::trial::{FAR, Trial, TrialError};
use super::{Ending, Fit, FitError, Fitted};

/// Relative changes of the sum of squares and of the variables below this are none: some ten times the error of a run.
const NOTHING: f64 = 1e-10;
/// Runs at most, for each variable and one more.
const PATIENCE: usize = 60;

/// The best trial so far, and where the search is.
struct Search<'a> {
    fit: &'a Fit<'a>,
    at: LmVector<f64>,
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
    /// The values of the variables with the least sum of squares near those that the search begins with.
    ///
    /// A run that fails, that lacks what was measured, or that has no derivatives counts as too long a step.
    ///
    /// # Errors
    /// There are fewer values than variables; the first run cannot be compared with the data; the data do not determine a variable.
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
        let at = LmVector::from_vec(values);
        let search =
            Search { fit: self, at, best, jacobian, other: None, failed: None, iterations: 0, runs: 1 };
        let method = LevenbergMarquardt::new().with_ftol(NOTHING).with_xtol(NOTHING).with_gtol(NOTHING);
        let (search, report) = method.with_patience(PATIENCE).minimize(search);
        let ending = search.ending(&report.termination);
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
    fn ending(&self, reason: &TerminationReason) -> Ending {
        use TerminationReason::{Converged, LostPatience, NoImprovementPossible};
        // Short steps that gain a little lead to a bound as they do to a minimum.
        if reason.was_successful()
            && let Some(why) = &self.failed
            && is_held_up(self.fit, &self.best, &self.jacobian)
        {
            return Ending::Stopped(format!("no step leads on: {why}"));
        }
        match (reason, &self.other) {
            // Steps have become short because longer ones failed.
            (Converged { ftol: false, .. } | NoImprovementPossible(_), Some(Err(why))) => {
                Ending::Stopped(format!("no step leads on: {why}"))
            }
            (NoImprovementPossible(_), _) => Ending::Converged,
            (reason, _) if reason.was_successful() => Ending::Converged,
            (LostPatience, _) => Ending::Stopped(format!("{} runs are the most", self.runs)),
            (reason, _) => Ending::Stopped(format!("the equations of a step have no solution: {reason:?}")),
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

    fn is_at_best(&self) -> bool {
        self.best.values == self.at.as_slice()
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Search<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, x: &LmVector<f64>) {
        self.at.copy_from(x);
        // At its end the search goes back to the best; what became of the last step is still asked for.
        if !self.is_at_best() {
            self.runs += 1;
            self.other = self.attempt(x.as_slice()).transpose();
            if let Some(Err(why)) = &self.other {
                self.failed = Some(why.clone());
            }
        }
    }

    fn params(&self) -> LmVector<f64> {
        self.at.clone()
    }

    fn residuals(&self) -> Option<LmVector<f64>> {
        let of = |trial: &Trial| LmVector::from_column_slice(trial.residuals.as_slice());
        Some(match &self.other {
            _ if self.is_at_best() => of(&self.best),
            Some(Ok(trial)) => of(trial),
            _ => LmVector::from_element(self.best.residuals.len(), FAR),
        })
    }

    fn jacobian(&self) -> Option<LmMatrix<f64>> {
        let of = |matrix: &DMatrix<f64>| {
            let (rows, columns) = matrix.shape();
            LmMatrix::from_column_slice(rows, columns, matrix.as_slice())
        };
        match &self.other {
            _ if self.is_at_best() => Some(of(&self.jacobian)),
            // Nearer than the last step that was taken, but not than one that gained too little to be.
            Some(Ok(trial)) => self.fit.jacobian(trial).ok().as_ref().map(of),
            _ => None,
        }
    }
}
