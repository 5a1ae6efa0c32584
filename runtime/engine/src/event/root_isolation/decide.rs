//! What a guard g ≥ 0 does over a step, with δ the bound of its error: below −δ it has crossed, at the
//! last change from + to − before; an interior minimum within ±δ is a touch; above δ, nothing.

use super::partition::{Division, ROUGH, Samples};
use super::series::Series;
use super::sign_history::History;
use super::{GuardError, Start};

/// The first thing that happens to a guard in (0, 1].
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Crossing {
    /// Nothing.
    Clear,
    /// It changes from + to − and goes below −δ.
    At {
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
pub fn watch(mut g: impl FnMut(f64) -> f64, start: Start, delta: f64) -> Result<Crossing, GuardError> {
    decide(&mut g, (None, ROUGH), start, delta)
}

/// [`watch`] of a guard whose rounding may exceed `delta`, as that of a reaction near a singular position: pieces that no fit
/// resolves are followed as they are, however many. Its values at [`NODES`](super::NODES) may be known already, so that they can
/// be computed for all guards at once; one that is sure to stay above `delta` is not evaluated again.
///
/// # Errors
/// If `g` is infinite or not a number somewhere.
pub fn watch_noisy(
    samples: Option<&Samples>,
    mut g: impl FnMut(f64) -> f64,
    start: Start,
    delta: f64,
) -> Result<Crossing, GuardError> {
    decide(&mut g, (samples, usize::MAX), start, delta)
}

fn decide(
    g: &mut dyn FnMut(f64) -> f64,
    (samples, rough): (Option<&Samples>, usize),
    start: Start,
    delta: f64,
) -> Result<Crossing, GuardError> {
    let mut guard = History::new(start, delta);
    let division = Division { samples, delta, dull: |[low, _], delta| low >= delta, rough };
    division.visit(g, &mut |node| guard.follow(node))?;
    Ok(guard.verdict(g))
}

/// [`watch`] of the guard Σ cₖ θᵏ, exact for these coefficients; `delta` bounds the error of the series. Those after the first
/// [`TERMS`](super::TERMS) do not count.
///
/// # Errors
/// If a coefficient is infinite or not a number.
pub fn watch_series(c: &[f64], start: Start, delta: f64) -> Result<Crossing, GuardError> {
    let series = Series::new(c, start);
    let level = series.level(delta);
    if series.reach()[0] > level || series.partial_sums()[0] > level || series.range()[0] > level {
        return Ok(Crossing::Clear);
    }
    let mut guard = History::of_series(start, delta);
    series.visit(&mut |node| guard.follow(node))?;
    Ok(guard.verdict(&mut |theta| series.at(theta)))
}
