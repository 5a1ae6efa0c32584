//! The way to the least value: searches one after the other, each on the scale of the slopes where
//! the last one ended, and behind it Newton's method on the slopes.

use nalgebra::{DMatrix, DVector};

use super::cost::{Cost, CostPoint};
use super::{Best, Optimum, OptimumError};
use crate::fit::{Ending, Fit, TrialError};
use crate::numeric::quasi_newton::{self, minimize};

/// Slopes by θ below this part of the steepest one at the start of a search are none.
const FLAT: f64 = 1e-7;
/// A search ends at such a part of the flattest slope that counts, the first where Newton's method
/// can go on.
const BELOW: f64 = 0.3;
const NEAR: f64 = 1e-4;
/// Slopes below this part of the output are rounding of runs.
const ROUNDING: f64 = 1e-11;
/// A search that gains no more than this part of the output is the last one.
const SETTLED: f64 = 1e-9;
/// The first step of the first search, in θ; each further one has a first step so much shorter.
const FIRST: f64 = 0.1;
const SHORTER: f64 = 1e-3;
/// Searches at most.
const SEARCHES: i32 = 8;
/// Newton steps on the slopes at most, and the difference in θ that tells how they change.
const POLISHED: usize = 4;
const PROBE: f64 = 1e-4;
/// How far it is looked around, in θ, where there is no slope.
const AROUND: f64 = 1e-2;

/// Where the searches have come to.
struct Progress<'a> {
    optimum: &'a Optimum<'a>,
    /// How the output is read.
    fit: Fit<'a>,
    best: CostPoint,
    runs: usize,
    /// The steepest slope at the start of any search.
    steepest: f64,
    failed: Option<TrialError>,
}

impl Optimum<'_> {
    /// The best values near those that the search begins with. A run that fails, that does not have
    /// the output, or that has no derivatives counts as too long a step.
    ///
    /// # Errors
    /// Nothing is varied; a variable does not begin between its bounds; the first run has no such
    /// output or no derivatives.
    pub fn solve(&self) -> Result<Best, OptimumError> {
        if self.variables.is_empty() {
            return Err(OptimumError::NoVariable);
        }
        let theta: Vec<f64> = self.variables.iter().map(|free| free.theta()).collect::<Result<_, _>>()?;
        let fit = self.reading();
        let start = self.point(&fit, &theta).map_err(OptimumError::Start)?;
        let first = start.output;
        let mut progress = Progress { optimum: self, fit, best: start, runs: 1, steepest: 0.0, failed: None };
        if progress.best.is_flat() {
            self.look_around(&mut progress);
        }
        let ending = self.search(&mut progress);
        let Progress { best: CostPoint { values, output, slopes, .. }, runs, .. } = progress;
        let at_bounds = self.variables.iter().zip(&values).map(|(free, value)| free.is_at_bound(*value));
        Ok(Best { at_bounds: at_bounds.collect(), values, value: output, first, slopes, runs, ending })
    }

    /// The largest slope by θ of what no bound holds.
    fn steepest(&self, point: &CostPoint) -> f64 {
        let each = self.variables.iter().enumerate();
        let free = each.filter(|(k, free)| !free.is_held(point.values[*k], self.sign() * point.slopes[*k]));
        free.fold(0.0, |most: f64, (k, _)| most.max(point.gradient[k].abs()))
    }

    /// A point without slopes is left for a better one beside it: it may be the worst of all.
    fn look_around(&self, progress: &mut Progress) {
        let start = progress.best.clone();
        for k in 0..self.variables.len() {
            for by in [AROUND, -AROUND] {
                let mut theta = start.theta.clone();
                theta[k] += by;
                progress.runs += 1;
                let Ok(point) = self.point(&progress.fit, &theta) else { continue };
                let gain = self.sign() * (progress.best.output - point.output);
                if gain > ROUNDING * start.output.abs() {
                    progress.best = point;
                }
            }
        }
    }

    fn search(&self, progress: &mut Progress) -> Ending {
        for k in 0..SEARCHES {
            if progress.best.is_flat() {
                return Ending::Converged;
            }
            let flat = if k == 0 { NEAR } else { BELOW * FLAT };
            let settled = progress.once(FIRST * SHORTER.powi(k), flat) && k > 0;
            progress.polish();
            let variables = self.variables.iter().zip(&progress.best.values);
            if let Some((free, _)) = variables.into_iter().find(|(free, value)| free.runs_away(**value)) {
                return Ending::Stopped(format!(
                    "the output improves without bound as {} grows or falls: --vary {0}=LOW:HIGH keeps it between bounds",
                    free.variable.name
                ));
            }
            let steepest = self.steepest(&progress.best);
            if steepest <= FLAT * progress.steepest.min(progress.best.output.abs()) {
                return Ending::Converged;
            }
            if settled {
                break;
            }
        }
        match &progress.failed {
            _ if self.steepest(&progress.best) <= FLAT * progress.steepest => Ending::Converged,
            Some(why) => Ending::Stopped(format!("no step leads on: {why}")),
            None => Ending::Stopped(
                "no step improves the output, although the slope is not zero: the output jumps where the sequence of events changes"
                    .to_owned(),
            ),
        }
    }
}

impl Progress<'_> {
    /// Searches once from the best point on, until slopes are this part of those at first; whether
    /// that has gained next to nothing.
    fn once(&mut self, step: f64, flat: f64) -> bool {
        let steepest = self.best.steepest();
        self.steepest = self.steepest.max(steepest);
        let start = quasi_newton::Iterate {
            x: DVector::from_row_slice(&self.best.theta),
            value: self.optimum.cost(&self.best),
            gradient: DVector::from_row_slice(&self.best.gradient),
        };
        let mut cost = Cost::new((self.optimum, &self.fit), self.best.clone(), steepest);
        // However it ends, what was best has been seen.
        minimize(start, step, flat * steepest, |theta| cost.evaluate(theta));
        let Cost { best, failed, runs, .. } = cost;
        let settled = (self.best.output - best.output).abs() <= SETTLED * best.output.abs();
        // Short steps do not come to what has held up long ones.
        if failed.is_some() || !settled {
            self.failed = failed;
        }
        self.runs += runs;
        self.best = best;
        settled
    }

    /// Newton's method on the slopes, H from their differences: where the output is flat, its
    /// values, which err as runs do, tell less than its slopes.
    fn polish(&mut self) {
        for _ in 0..POLISHED {
            let Some(point) = self.newton() else { return };
            let loss = self.optimum.sign() * (point.output - self.best.output);
            let is_flatter = self.optimum.steepest(&point) < self.optimum.steepest(&self.best);
            if !is_flatter || loss > SETTLED * self.best.output.abs() {
                return;
            }
            self.best = point;
        }
    }

    fn newton(&mut self) -> Option<CostPoint> {
        let CostPoint { theta, gradient, .. } = self.best.clone();
        let n = theta.len();
        let mut at = |theta: &[f64]| {
            self.runs += 1;
            self.optimum.point(&self.fit, theta).ok()
        };
        let mut differences = DMatrix::zeros(n, n);
        for k in 0..n {
            let mut beside = theta.clone();
            beside[k] += PROBE;
            let slopes = at(&beside)?.gradient;
            differences
                .set_column(k, &((DVector::from_vec(slopes) - DVector::from_row_slice(&gradient)) / PROBE));
        }
        let hessian = 0.5 * (&differences + differences.transpose());
        let step = hessian.cholesky()?.solve(&DVector::from_vec(gradient));
        at((DVector::from_vec(theta) - step).as_slice())
    }
}

impl CostPoint {
    fn is_flat(&self) -> bool {
        self.steepest() <= ROUNDING * self.output.abs()
    }
}
