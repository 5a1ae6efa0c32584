//! How a start depends on a variable, by differences (Fornberg, Mathematics of Computation 51, 1988), of the fourth order where there
//! are starts on both sides:
//!
//! ```text
//! 12 h x′ = 8 (x₁ − x₋₁) − (x₂ − x₋₂)
//! 60 h x′ = −147 x₀ + 360 x₁ − 450 x₂ + 400 x₃ − 225 x₄ + 72 x₅ − 10 x₆     where there is nothing on one side
//! ```

use liftoff::Trajectory;

use super::Direction;
use crate::SensitivityError;

/// Steps, in units of the variable: the error of the order is rounding.
const STEP: f64 = 3e-4;
const ONE_SIDED_STEP: f64 = 1e-3;
const ONE_SIDED: [f64; 7] = [-147.0, 360.0, -450.0, 400.0, -225.0, 72.0, -10.0];
/// Roundings by which entries of starts differ that do not depend on a variable.
const ROUNDED: f64 = 8.0 * f64::EPSILON;

/// What a run is differentiated with respect to.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// As users write it: `m`, `phi`, `phi'`.
    pub name: String,
    /// Its place among the parameters, if it is one.
    pub parameter: Option<usize>,
    /// Its value in the run.
    pub value: f64,
    /// What it varies on: of a parameter its value, of a coordinate its natural unit.
    pub unit: f64,
}

impl Variable {
    /// That of the starts of runs.
    pub(crate) fn direction(
        &self,
        run: &Trajectory,
        start: &impl Fn(&Self, f64) -> Result<Vec<f64>, String>,
    ) -> Result<Direction, SensitivityError> {
        let state = run.events().first().map_or(&[][..], |event| &event.state);
        let start = |steps: f64, h: f64| start(self, self.value + steps * h);
        let either = central(state, |steps| start(steps, STEP * self.unit), STEP * self.unit);
        let sided = |h: f64| one_sided(state.len(), |steps| start(steps, h), h);
        let found = either.or_else(|_| sided(ONE_SIDED_STEP * self.unit));
        let found = found.or_else(|_| sided(-ONE_SIDED_STEP * self.unit));
        let slopes = found.map_err(|why| SensitivityError::Start { variable: self.name.clone(), why })?;
        Ok(Direction { start: slopes, parameter: self.parameter, unit: self.unit })
    }
}

/// Slopes at a state; zero without looking farther where both neighbours are the same.
fn central(
    state: &[f64],
    start: impl Fn(f64) -> Result<Vec<f64>, String>,
    h: f64,
) -> Result<Vec<f64>, String> {
    let [before, after] = [start(-1.0)?, start(1.0)?];
    let is_kept = |x: f64, of: f64| (x - of).abs() <= ROUNDED * of.abs();
    if state.iter().zip(before.iter().zip(&after)).all(|(&x, (&a, &b))| is_kept(a, x) && is_kept(b, x)) {
        return Ok(vec![0.0; state.len()]);
    }
    let [first, last] = [start(-2.0)?, start(2.0)?];
    let slope = |i: usize| (8.0 * (after[i] - before[i]) - (last[i] - first[i])) / (12.0 * h);
    Ok((0..state.len()).map(slope).collect())
}

/// Slopes of so many entries.
fn one_sided(
    entries: usize,
    start: impl Fn(f64) -> Result<Vec<f64>, String>,
    h: f64,
) -> Result<Vec<f64>, String> {
    let mut slopes = vec![0.0; entries];
    for (k, weight) in ONE_SIDED.iter().enumerate() {
        slopes.iter_mut().zip(start(k as f64)?).for_each(|(slope, x)| *slope += weight * x / (60.0 * h));
    }
    Ok(slopes)
}
