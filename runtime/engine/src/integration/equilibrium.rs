//! Whether a phase at rest stays there: its accelerations vanish, or are what rounding of the
//! coordinates makes of zero (sin π is not 0 in floating point, yet a pendulum at π never falls).
//! With K = ∂a/∂q and R the roundings of the coordinates,
//!
//! ```text
//! a + K R z = 0,   |zᵢ| ≤ 1
//! ```
//!
//! Bars that lean one way by more than their roundings do fall, also where roundings against each
//! other would accelerate them as much.

use nalgebra::{DMatrix, DVector};

use crate::context::{Numbers, RunContext, reduce};
use crate::model::Form;
use crate::numerics::zero::roundoff;
use crate::system::PhaseEquations;
use smallvec::smallvec;

/// Roundoff of a coordinate: it was typed in, converted and added to.
const ROUNDED: f64 = roundoff(2.0);
/// The difference that K is taken of, in natural units: the cube root of ε balances its errors.
const STEP: f64 = 1e-5;
/// Singular values below this part of the largest are error of K, which goes as the square of that.
const RANK: f64 = 10.0 * STEP * STEP;

/// Whether a state of a phase never moves.
pub(crate) fn is_equilibrium(context: &RunContext, phase: &dyn PhaseEquations, state: &[f64]) -> bool {
    let layout = context.layout();
    // What depends on time may set it in motion later.
    if layout.timed {
        return false;
    }
    let info = phase.info();
    let reduced = reduce(phase, state);
    let derivative = |y: &[f64]| {
        let mut derivative: Numbers = smallvec![0.0; y.len()];
        phase.derivative(y, &mut derivative);
        derivative
    };
    let rates = info.places_of_rates();
    let mut full: Numbers = smallvec![0.0; layout.entries()];
    phase.embed(&reduced, &mut full);
    // All of them: a contact that sticks to a surface which moves has no rate of its own.
    if full[layout.coordinates.len()..].iter().any(|rate| *rate != 0.0) {
        return false;
    }
    let now = derivative(&reduced);
    let solve_error: Numbers = phase
        .kept()
        .iter()
        .map(|&entry| match info.form {
            Form::Multipliers => roundoff(64.0) * context.scales.entry(layout, entry) / context.scales.time,
            Form::Reduced => 0.0,
        })
        .collect();
    // By how much coordinate j is moved in the arithmetic of doubles, and the change of the
    // accelerations.
    let change = |j: usize, by: f64| {
        let mut moved = reduced.clone();
        moved[j] += by;
        let there = derivative(&moved);
        let change = DVector::from_iterator(info.rates, rates.clone().map(|k| there[k] - now[k]));
        (moved[j] - reduced[j], change)
    };
    let slopes: Vec<DVector<f64>> = (0..info.coordinates)
        .map(|j| {
            let (step, change) = change(j, STEP * context.scales.entry(layout, phase.kept()[j]));
            change / step
        })
        .collect();
    let mut noise = DVector::zeros(info.rates);
    let mut most = DVector::zeros(info.rates);
    for (j, slope) in slopes.iter().enumerate() {
        let (step, change) = change(j, ROUNDED * reduced[j]);
        noise += (&change - slope * step).abs();
        most += change.abs();
    }
    let beyond_error = |k: usize| {
        let error = solve_error[info.coordinates + k] + noise[k];
        let a = now[info.coordinates + k];
        a.signum() * (a.abs() - error).max(0.0)
    };
    let left = DVector::from_fn(info.rates, |k, _| beyond_error(k));
    if left.iter().all(|a| *a == 0.0) {
        return true;
    }
    if (0..info.rates).any(|k| left[k].abs() > most[k]) {
        return false;
    }
    if slopes.iter().flatten().any(|x| !x.is_finite()) {
        return false;
    }
    let columns = slopes.into_iter().zip(&reduced).map(|(slope, q)| slope * (ROUNDED * q.abs()));
    let columns = DMatrix::from_columns(&columns.collect::<Vec<_>>());
    let rank = RANK * columns.amax();
    columns.pseudo_inverse(rank).is_ok_and(|inverse| (inverse * left).amax() <= 1.0)
}
