//! One guard over a step: its own series where the method has it to well within the error bound,
//! else its values.

use super::advance::Advance;
use crate::numerics::root_isolation::{self, Accuracy, Crossing, GuardError, Root, RootStart};
use crate::numerics::zero::roundoff;

/// A series whose tail is at most this part of the error bound counts as exact.
pub(super) const EXACT: f64 = 0.1;

/// Whether a series counts as the guard itself.
pub(super) fn is_exact(series: &[f64], bound: f64) -> bool {
    root_isolation::tail(series) <= EXACT * bound
}

/// Whether a series proves that the guard stays above its bound: by much more than its own error.
/// One that counts as the guard is looked at again where the cheapest bound does not prove it.
pub(super) fn is_clear(series: &[f64], bound: f64) -> bool {
    let level = bound.max(root_isolation::tail(series) / EXACT);
    root_isolation::stays_above(series, level) || level > bound && root_isolation::is_above(series, level)
}

/// What has been decided of a guard that begins a phase at zero: that it does not cross it there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Suppression {
    /// Nothing: it counts as soon as it falls.
    None,
    /// It counts where it has fallen by its bound.
    ToBound,
    /// The same, but one that begins above zero is known better: it counts where it is zero.
    ToZero,
}

/// A guard as a function of θ.
pub(crate) enum GuardSource<'a> {
    /// Σ cₖ θᵏ.
    Series(&'a [f64]),
    /// Values, the largest of which are so large; whether they are taken for noise where no fit
    /// resolves them.
    Values { value: &'a dyn Fn(f64) -> f64, size: f64, is_noisy: bool },
}

impl GuardSource<'_> {
    /// The rounding of its values, that of a difference of terms as large as they are.
    pub(super) fn rounding(&self) -> f64 {
        let size = match self {
            Self::Series(terms) => terms.iter().fold(0.0_f64, |most, value| most.max(value.abs())),
            Self::Values { size, .. } => *size,
        };
        roundoff(16.0) * size
    }

    /// The value at the start of the step.
    pub(super) fn first(&self) -> f64 {
        match self {
            Self::Series(c) => c.first().copied().unwrap_or(f64::NAN),
            Self::Values { value, .. } => value(0.0),
        }
    }

    /// What happens behind `from`, as θ of the step.
    pub(super) fn watch(&self, from: f64, start: RootStart, bound: f64) -> Result<Crossing, GuardError> {
        let at = |s: f64| from + (1.0 - from) * s;
        let verdict = match self {
            Self::Series(c) if from == 0.0 => root_isolation::watch_series(c, start, bound)?,
            Self::Series(c) => root_isolation::watch_series(&root_isolation::rest(c, from), start, bound)?,
            Self::Values { value, is_noisy, .. } => {
                let accuracy = Accuracy { delta: bound, is_noisy: *is_noisy };
                root_isolation::watch(|s| value(at(s)), start, accuracy)
                    .map_err(|error| error.map_theta(at))?
            }
        };
        Ok(match verdict {
            Crossing::At { theta } => Crossing::At { theta: at(theta) },
            Crossing::Touch { theta, value } => Crossing::Touch { theta: at(theta), value },
            other => other,
        })
    }

    /// The first fall through zero behind `from`; `touch` is told where it goes on behind zeros
    /// that are only touched.
    pub(super) fn find_fall(
        &self,
        bound: f64,
        (mut from, mut start): (f64, RootStart),
        suppression: Suppression,
        touch: &mut dyn FnMut(f64),
    ) -> Result<Option<f64>, GuardError> {
        let is_suppressed = suppression != Suppression::None && from == 0.0;
        if is_suppressed && self.first() < -0.5 * bound {
            // It was kept for a reaction that might as well be zero, which this is not.
            return Ok(Some(0.0));
        }
        let mut advance = Advance::BEGUN;
        loop {
            match self.watch(from, start, bound)? {
                Crossing::Clear => return Ok(None),
                Crossing::At { theta } => return Ok(Some(theta)),
                Crossing::LeavesAtStart if is_suppressed && from == 0.0 => {
                    let is_above = suppression == Suppression::ToZero && self.first() > 0.0;
                    let sunk = if is_above { (0.0, self.rounding()) } else { (bound, 0.5 * bound) };
                    return self.first_root(0.0, RootStart::Free, sunk);
                }
                Crossing::LeavesAtStart => return Ok(Some(from)),
                Crossing::Touch { theta, .. } => {
                    from = advance.behind(theta, from);
                    touch(from);
                    start = RootStart::Order(2);
                    if from >= 1.0 {
                        return Ok(None);
                    }
                }
            }
        }
    }

    /// The first zero of the guard + `shift` behind `from`, as θ of the step.
    pub(super) fn first_root(
        &self,
        from: f64,
        start: RootStart,
        shifted: (f64, f64),
    ) -> Result<Option<f64>, GuardError> {
        Ok(self.find_root(from, start, shifted)?.map(|root| root.theta))
    }

    /// The same with the value of an extremum that counts as a zero.
    pub(super) fn find_root(
        &self,
        from: f64,
        start: RootStart,
        (shift, bound): (f64, f64),
    ) -> Result<Option<Root>, GuardError> {
        let at = |s: f64| from + (1.0 - from) * s;
        let root = match self {
            Self::Series(c) => {
                let mut c = root_isolation::rest(c, from);
                c[0] += shift;
                root_isolation::find_root_series(&c, start, bound)?
            }
            Self::Values { value, is_noisy, .. } => {
                let accuracy = Accuracy { delta: bound, is_noisy: *is_noisy };
                root_isolation::find_root(&mut |s| value(at(s)) + shift, start, accuracy)
                    .map_err(|error| error.map_theta(at))?
            }
        };
        Ok(root.map(|root| root.map_theta(at)))
    }
}

#[cfg(test)]
mod tests;
