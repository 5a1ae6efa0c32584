//! Parameters and starts with which an output is least or greatest.

use super::variables::{variables, with_values};
use super::{Failure, equations};
use crate::registry::{Entry, RunOptions};
use crate::run_spec::RunSpec;
use crate::sweep::Observation;
use liftoff::Output;
use liftoff_analysis::{Best, Free, Optimum, Place};
use liftoff_core::model::Layout;
use liftoff_core::scalar::Dual4;

/// A name that is varied, and its bounds.
pub type Bounded = (String, Option<[f64; 2]>);

/// What is to be least or greatest.
pub struct Goal {
    place: Place,
    output: Option<Output>,
    greatest: bool,
}

impl Goal {
    /// The time of an event, `first open`, an output after one, `2nd impact x`, or at the end,
    /// `end phi`.
    ///
    /// # Errors
    /// It is none of these.
    pub fn parse(text: &str, layout: &'static Layout, greatest: bool) -> Result<Self, String> {
        let observation = Observation::parse(text, layout).map_err(|error| error.to_string())?;
        if let Some(output) = observation.at_end() {
            return Ok(Self { place: Place::End, output: Some(output.clone()), greatest });
        }
        let (which, filter, output) = observation.event().ok_or(
            "expected an event, `first open`, an output after it, `2nd impact x`, or at the end, `end phi`",
        )?;
        Ok(Self { place: Place::Event(which, filter), output: output.cloned(), greatest })
    }
}

/// Finds the values with which the goal is reached, from those of a run on.
///
/// # Errors
/// Unknown names; a value out of its bounds; the run has no such value, or no derivatives.
pub fn optimise(
    model: &Entry,
    run: (RunOptions, RunSpec),
    varied: &[Bounded],
    goal: Goal,
) -> Result<Best, Failure> {
    let (options, spec) = run;
    let names: Vec<String> = varied.iter().map(|(name, _)| name.clone()).collect();
    let found = variables(&model.simulation(&spec)?, &spec, &names)?;
    let simulate = |values: &[f64]| {
        let spec = with_values(&spec, &found, values);
        model.simulation_by(options.clone(), &spec).map_err(|error| error.to_string())
    };
    let free = |(variable, (_, bounds)): (_, &Bounded)| Free { variable, bounds: *bounds };
    let problem = Optimum {
        simulate: &simulate,
        model: &|parameters: &[Dual4]| equations(model, parameters),
        variables: found.iter().cloned().zip(varied).map(free).collect(),
        place: goal.place,
        output: goal.output,
        greatest: goal.greatest,
    };
    Ok(problem.solve()?)
}
