//! One guard over a step: its own series where the method has it to well within the error bound, else its values.

use crate::event::root_isolation::{self, Crossing, GuardError, Samples, Start};

/// A series whose tail is at most this part of the error bound counts as exact.
pub(super) const EXACT: f64 = 0.1;

/// Whether a series counts as the guard itself.
pub(super) fn is_exact(series: &[f64], bound: f64) -> bool {
    root_isolation::tail(series) <= EXACT * bound
}

/// A guard as a function of θ.
pub(super) enum GuardSource<'a> {
    /// Σ cₖ θᵏ.
    Series(&'a [f64]),
    /// Values, those at the nodes of the fit already known.
    Values { samples: &'a Samples, value: &'a dyn Fn(f64) -> f64 },
}

impl GuardSource<'_> {
    /// The rounding of its values, that of a difference of terms as large as they are.
    pub(super) fn rounding(&self) -> f64 {
        let terms = match self {
            Self::Series(terms) => terms,
            Self::Values { samples, .. } => &samples[..],
        };
        16.0 * f64::EPSILON * terms.iter().fold(0.0_f64, |most, value| most.max(value.abs()))
    }

    /// The value at the start of the step.
    pub(super) fn first(&self) -> f64 {
        match self {
            Self::Series(c) => c.first().copied().unwrap_or(f64::NAN),
            Self::Values { samples, .. } => samples[0],
        }
    }

    /// What happens behind `from`, as θ of the step.
    pub(super) fn watch(&self, from: f64, start: Start, bound: f64) -> Result<Crossing, GuardError> {
        let at = |s: f64| from + (1.0 - from) * s;
        let verdict = match self {
            Self::Series(c) if from == 0.0 => root_isolation::watch_series(c, start, bound)?,
            Self::Series(c) => root_isolation::watch_series(&root_isolation::rest(c, from), start, bound)?,
            Self::Values { samples, value } if from == 0.0 => {
                root_isolation::watch_noisy(Some(samples), value, start, bound)?
            }
            Self::Values { value, .. } => root_isolation::watch_noisy(None, |s| value(at(s)), start, bound)?,
        };
        Ok(match verdict {
            Crossing::At { theta } => Crossing::At { theta: at(theta) },
            Crossing::Touch { theta, value } => Crossing::Touch { theta: at(theta), value },
            other => other,
        })
    }

    /// The first zero of the guard + `shift` behind `from`, as θ of the step.
    pub(super) fn first_root(
        &self,
        from: f64,
        start: Start,
        (shift, bound): (f64, f64),
    ) -> Result<Option<f64>, GuardError> {
        let at = |s: f64| from + (1.0 - from) * s;
        let root = match self {
            Self::Series(c) => {
                let mut c = root_isolation::rest(c, from);
                c[0] += shift;
                root_isolation::first_root_series(&c, start, bound)?
            }
            Self::Values { value, .. } => {
                root_isolation::first_root_noisy(|s| value(at(s)) + shift, start, bound)?
            }
        };
        Ok(root.map(at))
    }
}
