//! The way to the least value.

use argmin::core::{Executor, IterState};
use argmin::solver::linesearch::MoreThuenteLineSearch;
use argmin::solver::quasinewton::LBFGS;

use super::cost::{Asked, Cost, FIRST, Point, Seen};
use super::{Best, Optimum, OptimumError};
use crate::fit::Ending;

/// Slopes below this part of the steepest one at the start, or of the output itself, are none: runs have some ten digits.
const FLAT: f64 = 1e-7;
/// Steps that H is made of.
const REMEMBERED: usize = 8;
/// Directions that are searched at most.
const DIRECTIONS: u64 = 200;
/// The search ends at such a part of the flattest slope that counts.
const BELOW: f64 = 0.3;

impl Optimum<'_> {
    /// The best values near those that the search begins with. A run that fails, that does not have the output, or that has no
    /// derivatives counts as too long a step.
    ///
    /// # Errors
    /// Nothing is varied; a variable does not begin between its bounds; the first run has no such output or no derivatives.
    pub fn solve(&self) -> Result<Best, OptimumError> {
        if self.variables.is_empty() {
            return Err(OptimumError::NoVariable);
        }
        let theta: Vec<f64> = self.variables.iter().map(|free| free.theta()).collect::<Result<_, _>>()?;
        let start = self.point(&self.reading(), &theta).map_err(OptimumError::Start)?;
        let (first, steepest) = (start.output, start.steepest());
        let cost = Cost::new(self, start);
        let stopped = if steepest > 0.0 { search(&cost, theta) } else { None };
        let Seen { best, failed, runs, .. } = cost.seen.into_inner();
        let ending = match best.steepest() <= FLAT * steepest.max(best.output.abs()) {
            true => Ending::Converged,
            false => Ending::Stopped(match (failed, stopped) {
                (Some(why), _) => format!("no step leads on: {why}"),
                (None, Some(why)) => why,
                (None, None) => format!("{DIRECTIONS} directions are the most"),
            }),
        };
        let Point { values, output, slopes, .. } = best;
        let at_bounds = self.variables.iter().zip(&values).map(|(free, value)| free.is_at_bound(*value));
        Ok(Best { at_bounds: at_bounds.collect(), values, value: output, first, slopes, runs, ending })
    }
}

/// Searches from here on; why it could not go on, if it could not.
fn search(cost: &Cost<'_>, theta: Vec<f64>) -> Option<String> {
    let method = LBFGS::new(MoreThuenteLineSearch::new(), REMEMBERED);
    let method =
        method.with_tolerance_grad(BELOW * FLAT * FIRST).and_then(|method| method.with_tolerance_cost(0.0));
    let begun = |state: IterState<_, _, _, _, _, _>| state.param(theta).max_iters(DIRECTIONS);
    let ran = method.and_then(|method| Executor::new(Asked(cost), method).configure(begun).run());
    ran.err().map(|error| error.to_string())
}
