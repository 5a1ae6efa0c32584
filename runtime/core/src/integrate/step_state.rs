//! Where an integration is, and how long its next step may be.

use super::{Counts, StepError, Tolerance, is_finite};
use crate::scalar::Scalar;

/// Time, state and step size of an integration.
#[derive(Clone, Debug)]
pub struct StepState<S, const N: usize> {
    pub(super) tolerance: Tolerance<N>,
    pub(super) time: S,
    pub(super) state: [S; N],
    pub(super) next: Option<S>,
    first: S,
    pub(super) end: Option<S>,
    longest: Option<S>,
    pub(super) counts: Counts,
    /// How often the state was changed from outside.
    jumps: u64,
}

impl<S: Scalar, const N: usize> StepState<S, N> {
    /// Starts at time `t0` in the state `y0`.
    pub fn new(tolerance: Tolerance<N>, t0: S, y0: [S; N]) -> Self {
        Self {
            tolerance,
            time: t0,
            state: y0,
            next: None,
            first: S::ZERO,
            end: None,
            longest: None,
            counts: Counts::default(),
            jumps: 0,
        }
    }

    /// Proposes the first step, which is else chosen by the method.
    #[must_use]
    pub fn with_first_step(mut self, h: S) -> Self {
        (self.next, self.first) = (Some(h), h);
        self
    }

    /// No step is longer than `h` > 0.
    #[must_use]
    pub fn with_longest_step(mut self, h: S) -> Self {
        self.longest = Some(h);
        self
    }

    /// From now on steps may be as long as `h` too.
    #[cfg(feature = "std")]
    pub(crate) fn allow_step(&mut self, h: S) {
        self.longest = self.longest.map(|longest| if h > longest { h } else { longest });
    }

    /// Some step ends exactly at time `t`, and none goes past it.
    #[must_use]
    pub fn with_end(mut self, t: S) -> Self {
        self.end = Some(t);
        self
    }

    /// From now on some step ends exactly at time `t`, and none goes past it.
    pub fn set_end(&mut self, t: S) {
        self.end = Some(t);
    }

    /// Goes on from a later time and state, `h` the first step tried there; work is counted on.
    pub fn jump(&mut self, t: S, state: [S; N], h: S) {
        (self.time, self.state) = (t, state);
        (self.next, self.first) = (Some(h), h);
        self.jumps += 1;
    }

    /// Time of the last accepted state.
    pub fn time(&self) -> S {
        self.time
    }

    /// The last accepted state.
    pub fn state(&self) -> &[S; N] {
        &self.state
    }

    /// The step that will be tried next, once one has been made or proposed.
    pub fn next_step(&self) -> Option<S> {
        self.next
    }

    /// The work done so far.
    pub fn counts(&self) -> Counts {
        self.counts
    }

    /// The tolerance.
    pub fn tolerance(&self) -> &Tolerance<N> {
        &self.tolerance
    }

    /// Changes with every [`Self::jump`], so that a method can tell that what it kept of f is no
    /// longer of this state.
    pub(super) fn jumps(&self) -> u64 {
        self.jumps
    }

    /// Takes the first step from `h`, no longer than is allowed: powers of what a state that all
    /// but rests would do with have no number. Where any step will do it is the longest allowed.
    pub(super) fn begin(&mut self, h: Option<f64>) -> S {
        let at_rest = self.longest.or(self.end.map(|end| end - self.time));
        let first = h.map(S::from_f64).filter(|h| at_rest.is_none_or(|longest| *h < longest));
        self.first = first.or(at_rest).unwrap_or(S::ratio(1, 1));
        self.next = Some(self.first);
        self.first
    }

    /// The step to try and the time it leads to. Its length is the difference of two representable
    /// times, so that time does not drift against the state. `finite`: whether the last trial was.
    pub(super) fn fit(&self, wanted: S, finite: bool) -> Result<(S, S), StepError> {
        let t = self.time.to_f64();
        let h = match self.longest {
            Some(longest) if wanted > longest => longest,
            _ => wanted,
        };
        if let Some(end) = self.end {
            let left = end - self.time;
            if left <= S::ZERO {
                return Err(StepError::AtEnd { t });
            }
            // A step that nearly reaches the end is stretched to it (Hairer's 1.01).
            if S::from_f64(1.01) * h >= left {
                return Ok((left, end));
            }
        }
        if h > self.floor() {
            let t1 = self.time + h;
            return Ok((t1 - self.time, t1));
        }
        let h = h.to_f64();
        Err(if finite { StepError::Floor { t, h } } else { StepError::NotFinite { t } })
    }

    /// Whether the end has been reached.
    #[cfg(feature = "std")]
    pub(super) fn is_at_end(&self) -> bool {
        self.end.is_some_and(|end| self.time >= end)
    }

    /// Whether time can resolve a step of length `h`.
    pub(super) fn is_above_floor(&self, h: S) -> bool {
        h > self.floor()
    }

    fn floor(&self) -> S {
        let t = self.time.abs();
        let first = self.longest.filter(|longest| *longest < self.first).unwrap_or(self.first);
        S::from_f64(10.0) * S::EPSILON * if t > first { t } else { first }
    }

    /// An error if state or slope is infinite or not a number.
    pub(super) fn check(&self, slope: &[S; N]) -> Result<(), StepError> {
        if is_finite(&self.state) && is_finite(slope) {
            return Ok(());
        }
        Err(StepError::NotFinite { t: self.time.to_f64() })
    }

    /// Moves to the end of an accepted step; `next` is the step to try then.
    pub(super) fn accept(&mut self, t1: S, y1: [S; N], next: S) {
        (self.time, self.state, self.next) = (t1, y1, Some(next));
        self.counts.accepted += 1;
    }
}
