//! A motion computed once more, to more digits than doubles have, by a method that had no part in it.
//!
//! The finished run tells which contacts were closed when, and which guard ended each phase. Each phase is integrated in
//! double-double by Gragg's extrapolated method, to the root of that guard nearest to where the run found it; impacts are
//! solved from the contacts that acted. What is trusted of the run is thus only the order of its events. Twice over, at
//! two tolerances and step sizes: their difference bounds the error.

mod collision;
mod error;
mod extrapolation;
mod instant;
mod linear;
mod model;
mod replay;
mod root;

pub use error::ReferenceError;

use std::sync::Arc;

use liftoff::Scales;
use liftoff::Trajectory;
use liftoff::scalar::{DoubleDouble, Scalar};
use liftoff::system::System;
use model::PreciseModel;
use replay::Replay;

/// Error per step of the two passes.
const FINE: f64 = 1e-27;
const COARSE: f64 = 1e-24;
/// Above this a reference says little of runs in doubles.
const USELESS: f64 = 1e-15;

/// A motion's events and end to more digits than doubles have.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    times: Vec<Option<DoubleDouble>>,
    state: Vec<DoubleDouble>,
    units: Vec<f64>,
    time: f64,
    bound: f64,
}

impl Reference {
    /// Computes the motion of a run once more in double-double, with the contacts of the run but by another method.
    /// `system` makes the model's equations from the values of its parameters, for a compiled model
    /// [`precise`](liftoff::system::precise). Takes some thousand times as long as the run; the tighter the run's tolerance,
    /// the surer that its events are the true ones.
    ///
    /// # Errors
    /// The motion cannot be computed once more, or not to more digits than doubles have.
    pub fn of(
        run: &Trajectory,
        system: impl FnOnce(&[f64]) -> Arc<dyn System<DoubleDouble>>,
    ) -> Result<Self, ReferenceError> {
        let Scales { length, time, .. } = run.scales();
        let model = PreciseModel {
            system: system(run.parameters()),
            parameters: run.parameters().to_vec(),
            restitution: run.model().restitution.clone(),
            units: run.scales().state(run.layout()),
            length,
            time,
        };
        let (times, state) = Replay::new(&model, run, FINE)?.play()?;
        let coarse = Replay::new(&model, run, COARSE)?.play()?;
        let units = model.units[..state.len()].to_vec();
        let mut reference = Self { times, state, units, time, bound: 0.0 };
        let late = reference.times.iter().zip(&coarse.0);
        let late = late.filter_map(|(&fine, &coarse)| Some(reference.time_difference(fine?, coarse?)));
        let bound = late.fold(reference.difference(&coarse.1), f64::max);
        if bound.is_nan() || bound > USELESS {
            return Err(ReferenceError::Bound { bound });
        }
        reference.bound = bound;
        Ok(reference)
    }

    /// The time of each event of the run; none of touches, which are double roots.
    pub fn times(&self) -> &[Option<DoubleDouble>] {
        &self.times
    }

    /// The state at the end, coordinates then rates.
    pub fn state(&self) -> &[DoubleDouble] {
        &self.state
    }

    /// Largest difference of the two computations, measured as errors are.
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// The error of a time: relative, or in natural times √(length / gravity) where that is less.
    pub fn time_error(&self, event: usize, t: f64) -> Option<f64> {
        let time = (*self.times.get(event)?)?;
        Some(self.time_difference(time, DoubleDouble::new(t, 0.0)))
    }

    /// The error of a final state: its largest deviation in natural units, relative to its largest entry, or in natural
    /// units where that is less than one.
    pub fn state_error(&self, state: &[f64]) -> f64 {
        let state: Vec<_> = state.iter().map(|&x| DoubleDouble::new(x, 0.0)).collect();
        self.difference(&state)
    }

    fn time_difference(&self, time: DoubleDouble, other: DoubleDouble) -> f64 {
        (other - time).abs().to_f64() / time.abs().to_f64().max(self.time)
    }

    fn difference(&self, other: &[DoubleDouble]) -> f64 {
        let mut largest = 1.0;
        let mut difference = 0.0;
        for ((&x, &other), &unit) in self.state.iter().zip(other).zip(&self.units) {
            largest = f64::max(largest, x.abs().to_f64() / unit);
            let apart = (other - x).abs().to_f64() / unit;
            // `max` passes over what is not a number.
            difference = if apart.is_nan() { f64::NAN } else { difference.max(apart) };
            if difference.is_nan() {
                return difference;
            }
        }
        difference / largest
    }
}
