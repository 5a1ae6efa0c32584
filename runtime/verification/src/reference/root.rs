//! The root of the guard that ended a phase, by the secant method on the motion itself.

use super::ReferenceError;
use super::extrapolation::Extrapolation;
use super::instant::Instant;
use super::model::{PreciseModel, PrecisePhase};
use super::replay::failed;
use liftoff::event::Guard;
use liftoff::expression::Condition;
use liftoff::scalar::{DoubleDouble, Real, Scalar};

/// The first step of the secant method, in natural times: far above rounding, far below the time of any change.
const PROBE: f64 = 1e-7;
/// Changes of the root below this, in natural times, are rounding.
const ROUNDING: f64 = 1e-29;
/// A root further away, in natural times, is another event.
const FARTHEST: f64 = 0.1;
const ITERATIONS: usize = 40;

/// A phase near its end.
pub(super) struct EventRefinement<'a> {
    pub(super) model: &'a PreciseModel,
    pub(super) phase: &'a PrecisePhase,
    /// Where the run ended it.
    pub(super) t: DoubleDouble,
    pub(super) state: &'a [DoubleDouble],
    pub(super) conditions: &'a [Condition],
}

impl EventRefinement<'_> {
    /// How long after `t` the nearest root of one of the guards is, and the reduced state there.
    pub(super) fn find(
        &self,
        guards: &[Guard],
        integrator: &mut Extrapolation<'_>,
    ) -> Result<(DoubleDouble, Vec<DoubleDouble>), ReferenceError> {
        let probe = DoubleDouble::from_f64(PROBE * self.model.time);
        let mut nearest: Option<(f64, Guard)> = None;
        for &guard in guards {
            let here = self.value(guard, DoubleDouble::ZERO, integrator)?.0;
            let there = self.value(guard, probe, integrator)?.0;
            let away = (here * probe / (there - here)).abs().to_f64();
            if here == DoubleDouble::ZERO || nearest.is_none_or(|(least, _)| away < least) {
                nearest = Some((if away.is_nan() { 0.0 } else { away }, guard));
            }
        }
        let (_, guard) = nearest.ok_or(ReferenceError::Event { t: self.t.to_f64() })?;
        self.root(guard, probe, integrator)
    }

    fn root(
        &self,
        guard: Guard,
        probe: DoubleDouble,
        integrator: &mut Extrapolation<'_>,
    ) -> Result<(DoubleDouble, Vec<DoubleDouble>), ReferenceError> {
        let (mut before, mut now) = (probe, DoubleDouble::ZERO);
        let mut old = self.value(guard, before, integrator)?.0;
        for _ in 0..ITERATIONS {
            let (value, state) = self.value(guard, now, integrator)?;
            let change = value * (now - before) / (value - old);
            let settled = change.abs().to_f64() <= ROUNDING * self.model.time;
            if value == DoubleDouble::ZERO || settled {
                return Ok((now, state));
            }
            (before, old) = (now, value);
            now = now - change;
            let near = now.abs().to_f64() <= FARTHEST * self.model.time;
            if !near {
                break;
            }
        }
        Err(ReferenceError::Event { t: self.t.to_f64() })
    }

    /// The guard and the reduced state after a time.
    fn value(
        &self,
        guard: Guard,
        after: DoubleDouble,
        integrator: &mut Extrapolation<'_>,
    ) -> Result<(DoubleDouble, Vec<DoubleDouble>), ReferenceError> {
        let t = self.t.to_f64();
        let mut state = self.state.to_vec();
        integrator.advance(&mut state, after).map_err(|failure| failed(failure, t))?;
        let instant = Instant::new(self.model, self.phase, self.t + after, &state);
        let value = instant.guard(guard, self.conditions);
        let value = value.map_err(|unsupported| ReferenceError::Condition { t, feature: unsupported.0 })?;
        Ok((value, state))
    }
}
