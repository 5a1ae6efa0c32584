//! Roots of either direction, for stop conditions, and extrema, for reports.

use super::bracket::{Point, root};
use super::extrema::{LocatedExtremum, Zigzag};
use super::partition::{Accuracy, Division, Node};
use super::search::{RootSearch, SearchResult};
use super::series::PowerSeries;
use super::{GuardError, RootStart};
use crate::numerics::zero::roundoff;

/// After a pole the search continues at least this far behind it, twice as far each time.
const BEHIND: f64 = 1e-13;

/// The values across a change of sign are compared with values this many times farther away.
const WIDER: f64 = 1e6;

/// A root, or an extremum so near zero that it may be one.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Root {
    /// Where.
    pub theta: f64,
    /// The value of an extremum; zero where the sign changes.
    pub value: f64,
}

impl Root {
    fn crossing(theta: f64) -> Self {
        Self { theta, value: 0.0 }
    }

    /// The same in the step that it is found in a piece of.
    pub fn map_theta(self, at: impl Fn(f64) -> f64) -> Self {
        Self { theta: at(self.theta), ..self }
    }
}

/// The first root of `g` in (0, 1]: a change of sign either way, or an extremum within its error
/// bound of zero. A change of sign through a pole or a jump is no root. At θ = 0 there is a root
/// only where the step [continues](RootStart::Continues) one that ended with the other sign.
///
/// # Errors
/// If `g` is infinite or not a number somewhere, or turns too often to be followed.
pub fn find_root(
    g: &mut dyn FnMut(f64) -> f64,
    start: RootStart,
    accuracy: Accuracy,
) -> Result<Option<Root>, GuardError> {
    let delta = accuracy.delta;
    let (mut from, mut start, mut least) = (0.0, start, BEHIND);
    while from < 1.0 {
        let at = |s: f64| from + (1.0 - from) * s;
        let mut rest = |s: f64| g(at(s));
        let mut search = RootSearch::new(start, delta);
        let dull = |[low, high]: [f64; 2], delta| low > delta || high < -delta;
        Division { accuracy, dull }.visit(&mut rest, &mut |node| search.follow(node))?;
        match search.found() {
            None => return Ok(None),
            Some(SearchResult::At(s)) => return Ok(Some(Root::crossing(at(s)))),
            Some(SearchResult::Tangent { theta, value }) => {
                return Ok(Some(Root { theta: at(theta), value }));
            }
            Some(SearchResult::Between { ends: [a, b], smooth }) => {
                let across = root(&mut rest, a, b);
                let s = across[0].theta;
                let rounding = roundoff(64.0) * a.value.abs().max(b.value.abs());
                if smooth || is_continuous(&mut rest, across, delta.max(rounding)) {
                    return Ok(Some(Root::crossing(at(s))));
                }
                (from, start) = (at(s) + least, RootStart::Free);
                least *= 2.0;
            }
        }
    }
    Ok(None)
}

/// Whether the values across a change of sign, `ends`, are within `rounding` or nearer to each
/// other than those farther away, as they are where the function passes through zero, and not where
/// it jumps over it or has a pole.
fn is_continuous(g: &mut dyn FnMut(f64) -> f64, ends: [Point; 2], rounding: f64) -> bool {
    let jump = (ends[0].value - ends[1].value).abs();
    if ends[0].value == 0.0 || jump <= rounding {
        return true;
    }
    let width = WIDER * (ends[0].theta - ends[1].theta).abs();
    let [a, b] = [-width, width].map(|apart| g((ends[0].theta + apart).clamp(0.0, 1.0)));
    jump <= 0.5 * (a - b).abs()
}

/// [`find_root`] of Σ cₖ θᵏ, exact for these coefficients; `delta` bounds the error of the series.
/// Those after the first [`TERMS`](super::TERMS) do not count.
///
/// # Errors
/// If a coefficient is infinite or not a number.
pub fn find_root_series(c: &[f64], start: RootStart, delta: f64) -> Result<Option<Root>, GuardError> {
    let series = PowerSeries::new(c, start);
    let level = series.level(delta);
    let stays = |[low, high]: [f64; 2]| match start {
        RootStart::Continues { positive } => (if positive { low } else { -high }) > level,
        _ => low > level || high < -level,
    };
    if series.is_within(stays) {
        return Ok(None);
    }
    let mut search = RootSearch::of_series(start, delta);
    series.visit(&mut |node| search.follow(node))?;
    Ok(search.found().map(|found| match found {
        SearchResult::At(theta) => Root::crossing(theta),
        SearchResult::Tangent { theta, value } => Root { theta, value },
        SearchResult::Between { ends: [a, b], .. } => {
            Root::crossing(root(&mut |theta| series.evaluate(theta), a, b)[0].theta)
        }
    }))
}

/// Visits every maximum and minimum of `g` in (0, 1] that stands out by more than `delta` ≥ 0 and
/// by more than rounding, in ascending order. One so near the seam of two steps that it does not
/// stand out from it is seen at the end of the step before, and may be seen again by the step
/// after.
///
/// # Errors
/// If `g` is infinite or not a number somewhere.
pub fn extrema(
    mut g: impl FnMut(f64) -> f64,
    delta: f64,
    mut visit: impl FnMut(LocatedExtremum),
) -> Result<(), GuardError> {
    let mut zigzag = Zigzag::default();
    let accuracy = Accuracy { delta, is_noisy: true };
    let division = Division { accuracy, dull: |_, _| false };
    division.visit(&mut g, &mut |node| turn(&mut zigzag, node, delta, &mut visit))
}

fn turn(zigzag: &mut Zigzag, node: Node, delta: f64, visit: &mut dyn FnMut(LocatedExtremum)) {
    let noise = node.noise.max(delta);
    let passed = zigzag.push(node.point, noise);
    let last = zigzag.finish().filter(|_| node.beyond <= noise);
    passed.into_iter().chain(last).for_each(visit);
}

#[cfg(test)]
mod tests;
