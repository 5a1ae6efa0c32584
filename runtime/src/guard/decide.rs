//! What a guard g ≥ 0 does over a step, with δ the bound of its error: below −δ it has crossed, at the
//! last change from + to − before; an interior minimum within ±δ is a touch; above δ, nothing.

use super::history::History;
use super::partition::{Division, ROUGH, Samples};
use super::series::Series;
use super::{GuardError, Start};

/// The first thing that happens to a guard in (0, 1].
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Verdict {
    /// Nothing.
    Clear,
    /// It changes from + to − and goes below −δ.
    Crossing {
        /// The root.
        theta: f64,
    },
    /// It has a minimum within ±δ and rises again.
    Touch {
        /// Where the rate is zero.
        theta: f64,
        /// The value there.
        value: f64,
    },
    /// It goes below −δ without having been positive: from its known root, or from a start at or
    /// below zero. The event is at θ = 0.
    LeavesAtStart,
}

/// Follows the guard `g`, known to within `delta` ≥ 0, from θ = 0 to the first event.
///
/// # Errors
/// If `g` is infinite or not a number somewhere, or turns too often to be followed.
pub fn watch(mut g: impl FnMut(f64) -> f64, start: Start, delta: f64) -> Result<Verdict, GuardError> {
    decide(&mut g, None, start, delta)
}

/// [`watch`] with the values of `g` at [`NODES`](super::NODES) already known, so that they can be computed for all
/// guards at once. A guard that is sure to stay above `delta` is not evaluated again.
///
/// # Errors
/// If `g` is infinite or not a number somewhere, or turns too often to be followed.
pub fn watch_sampled(
    samples: &Samples,
    mut g: impl FnMut(f64) -> f64,
    start: Start,
    delta: f64,
) -> Result<Verdict, GuardError> {
    decide(&mut g, Some(samples), start, delta)
}

fn decide(
    g: &mut dyn FnMut(f64) -> f64,
    samples: Option<&Samples>,
    start: Start,
    delta: f64,
) -> Result<Verdict, GuardError> {
    let mut guard = History::new(start, delta);
    let division = Division { samples, delta, dull: |[low, _], delta| low >= delta, rough: ROUGH };
    division.visit(g, &mut |node| guard.follow(node))?;
    Ok(guard.verdict(g))
}

/// [`watch`] of the guard Σ cₖ θᵏ, exact for these coefficients; `delta` bounds the error of the series. Those after the first
/// [`TERMS`](super::TERMS) do not count.
///
/// # Errors
/// If a coefficient is infinite or not a number.
pub fn watch_series(c: &[f64], start: Start, delta: f64) -> Result<Verdict, GuardError> {
    let series = Series::new(c, start);
    let level = series.level(delta);
    if series.reach()[0] > level || series.partial_sums()[0] > level || series.range()[0] > level {
        return Ok(Verdict::Clear);
    }
    let mut guard = History::of_series(start, delta);
    series.visit(&mut |node| guard.follow(node))?;
    Ok(guard.verdict(&mut |theta| series.at(theta)))
}
