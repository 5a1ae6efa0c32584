//! The root of the guard that ended a phase, by the secant method on the motion itself.

use crate::extrapolation::Extrapolation;
use crate::instant::{Instant, Unsupported};
use crate::model::{ReplayModel, ReplayPhase};
use crate::replay::failed;
use crate::{Number, ReplayError};
use liftoff::__private::event::Guard;
use liftoff::Condition;

/// The first step of the secant method, in natural times: far above rounding, far below the time of
/// any change.
const PROBE: f64 = 1e-7;
/// Changes of the root below so many roundings, in natural times, are none.
const ROUNDING: f64 = 400.0;
/// Below so many, changes that shrink no more are rounding: that of guards which depend on many
/// numbers.
const NOISE: f64 = 1e5;
/// A root further away, in natural times, is another event.
const FARTHEST: f64 = 0.1;
const ITERATIONS: usize = 40;
/// The time over which the change of a guard is looked at, in natural times.
const SPAN: f64 = 1.2e-2;
/// Times whose derivatives agree to this stay together.
pub(crate) const TOGETHER: f64 = 1e-7;
/// A guard whose ġ is this part of its change only touches zero.
const GRAZING: f64 = 1e-6;

/// A phase near its end.
pub(crate) struct EventRefinement<'a, S: Number> {
    pub(crate) model: &'a ReplayModel<S>,
    pub(crate) phase: &'a ReplayPhase<S>,
    /// Where the run ended it.
    pub(crate) t: S,
    pub(crate) state: &'a [S],
    pub(crate) conditions: &'a [Condition],
}

impl<S: Number> EventRefinement<'_, S> {
    /// How long after `t` the nearest root of one of the guards is, and the reduced state there.
    pub(crate) fn find(
        &self,
        guards: &[Guard],
        integrator: &mut Extrapolation<'_, S>,
    ) -> Result<(S, Vec<S>), ReplayError> {
        let probe = S::from_f64(PROBE * self.model.time);
        let mut nearest: Option<(f64, Guard)> = None;
        for &guard in guards {
            let here = self.value(guard, S::ZERO, integrator)?.0;
            let there = self.value(guard, probe, integrator)?.0;
            let away = (here * probe / (there - here)).abs().to_f64();
            if here == S::ZERO || nearest.is_none_or(|(least, _)| away < least) {
                nearest = Some((if away.is_nan() { 0.0 } else { away }, guard));
            }
        }
        let (_, guard) = nearest.ok_or(ReplayError::Event { t: self.t.to_f64() })?;
        let found = self.root(guard, probe, integrator)?;
        for &other in guards.iter().filter(|other| S::PARTS > 1 && **other != guard) {
            let apart = self.root(other, probe, integrator)?.0 - found.0;
            let is_apart =
                |k: usize| apart.part(k).abs() > TOGETHER * found.0.part(k).abs().max(self.model.time);
            if (1..S::PARTS).any(is_apart) {
                return Err(ReplayError::Simultaneous { t: (self.t + found.0).to_f64() });
            }
        }
        Ok(found)
    }

    fn root(
        &self,
        guard: Guard,
        probe: S,
        integrator: &mut Extrapolation<'_, S>,
    ) -> Result<(S, Vec<S>), ReplayError> {
        let (mut before, mut now) = (probe, S::ZERO);
        let mut old = self.value(guard, before, integrator)?.0;
        let rounding = S::EPSILON.to_f64() * self.model.time;
        let mut last = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let (value, state) = self.value(guard, now, integrator)?;
            let change = value * (now - before) / (value - old);
            let size = change.abs().to_f64();
            let settled = size <= ROUNDING * rounding || size >= last && last <= NOISE * rounding;
            last = size;
            if value == S::ZERO || settled {
                return self.with_derivatives(guard, (now, value, state), integrator);
            }
            (before, old) = (now, value);
            now = now - change;
            let near = now.abs().to_f64() <= FARTHEST * self.model.time;
            if !near {
                break;
            }
        }
        Err(ReplayError::Event { t: self.t.to_f64() })
    }

    /// The root, of a guard with this value there, with its derivatives: δτ = −δg / ġ.
    fn with_derivatives(
        &self,
        guard: Guard,
        (root, value, mut state): (S, S, Vec<S>),
        integrator: &mut Extrapolation<'_, S>,
    ) -> Result<(S, Vec<S>), ReplayError> {
        let Some(moment) = S::infinitesimal() else { return Ok((root, state)) };
        let mut next = state.clone();
        integrator.shift(&mut next, moment);
        let slope = (self.evaluate_guard(guard, root + moment, &next)? - value).part(1);
        let h = SPAN * self.model.time;
        let [late, early] = [1.0, -1.0].map(|sign| root + S::from_f64(sign * h));
        let change = self.value(guard, late, integrator)?.0 - self.value(guard, early, integrator)?.0;
        let size = change.to_f64().abs();
        if (slope * h).abs() <= GRAZING * size || size == 0.0 {
            return Err(ReplayError::Grazing { t: (self.t + root).to_f64() });
        }
        let by = -(value / S::from_f64(slope));
        integrator.shift(&mut state, by);
        Ok((root + by, state))
    }

    /// The guard and the reduced state after a time.
    fn value(
        &self,
        guard: Guard,
        after: S,
        integrator: &mut Extrapolation<'_, S>,
    ) -> Result<(S, Vec<S>), ReplayError> {
        let t = self.t.to_f64();
        let mut state = self.state.to_vec();
        integrator.refine(&mut state, after).map_err(|failure| failed(failure, t))?;
        Ok((self.evaluate_guard(guard, after, &state)?, state))
    }

    /// The guard at a reduced state after a time.
    fn evaluate_guard(&self, guard: Guard, after: S, state: &[S]) -> Result<S, ReplayError> {
        let instant = Instant::new(self.model, self.phase, self.t + after, state);
        let unsupported = |what: Unsupported| ReplayError::Condition { t: self.t.to_f64(), feature: what.0 };
        instant.guard(guard, self.conditions).map_err(unsupported)
    }
}
