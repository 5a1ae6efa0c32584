//! What a guard g ≥ 0 does over a step, with δ the bound of its error: below −δ it has crossed, at
//! the last change from + to − before; an interior minimum within ±δ is a touch; above δ, nothing.

use super::partition::{Accuracy, Division};
use super::series::PowerSeries;
use super::sign_history::{Crossing, History};
use super::{GuardError, RootStart};

/// Follows the guard `g` from θ = 0 to the first event. It counts as clear only where a fit that
/// has been compared with it between its nodes stays above the error bound by more than it may
/// differ.
///
/// # Errors
/// If `g` is infinite or not a number somewhere, or turns too often to be followed.
pub fn watch(
    mut g: impl FnMut(f64) -> f64,
    start: RootStart,
    accuracy: impl Into<Accuracy>,
) -> Result<Crossing, GuardError> {
    let accuracy = accuracy.into();
    let mut guard = History::new(start, accuracy.delta);
    let division = Division { accuracy, dull: |[low, _], delta| low >= delta };
    division.visit(&mut g, &mut |node| guard.follow(node))?;
    Ok(guard.verdict(&mut g))
}

/// [`watch`] of the guard Σ cₖ θᵏ, exact for these coefficients; `delta` bounds the error of the
/// series. Those after the first [`TERMS`](super::TERMS) do not count.
///
/// # Errors
/// If a coefficient is infinite or not a number.
pub fn watch_series(c: &[f64], start: RootStart, delta: f64) -> Result<Crossing, GuardError> {
    let series = PowerSeries::new(c, start);
    let level = series.level(delta);
    if series.is_within(|[low, _]| low > level) {
        return Ok(Crossing::Clear);
    }
    let mut guard = History::of_series(start, delta);
    series.visit(&mut |node| guard.follow(node))?;
    Ok(guard.verdict(&mut |theta| series.evaluate(theta)))
}
