//! Parameters and starts by least squares.

use super::variables::{variables, with_values};
use super::{Failure, Measured, equations};
use crate::registry::{Entry, RunOptions};
use crate::run_spec::RunSpec;
use liftoff_analysis::{Fit, Fitted};
use liftoff_core::scalar::Dual4;

/// Finds the values of these names with the least sum of squares, from those of a run on.
///
/// # Errors
/// Unknown names; too few values; the run cannot be compared with them; they do not determine a
/// name.
pub fn fit(
    model: &Entry,
    run: (RunOptions, RunSpec),
    names: &[String],
    measured: &Measured,
) -> Result<Fitted, Failure> {
    let (options, spec) = run;
    let found = variables(&model.simulation(&spec)?, &spec, names)?;
    let simulate = |values: &[f64]| {
        let spec = with_values(&spec, &found, values);
        model.simulation_by(options.clone(), &spec).map_err(|error| error.to_string())
    };
    let problem = Fit {
        simulate: &simulate,
        model: &|parameters: &[Dual4]| equations(model, parameters),
        variables: found.clone(),
        data: measured.data.clone(),
    };
    Ok(problem.solve()?)
}
