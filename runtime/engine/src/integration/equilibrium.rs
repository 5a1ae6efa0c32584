//! Whether a phase at rest stays there: its accelerations vanish, or are no larger than what rounding of the
//! coordinates makes of zero (sin π is not 0 in floating point, yet a pendulum at π never falls).

use crate::integration::phase_point::{Numbers, RunContext};
use crate::model::Form;
use crate::system::Phase;
use smallvec::smallvec;

/// Roundings of a coordinate: it was typed in, converted and added to.
const ROUNDINGS: f64 = 4.0 * f64::EPSILON;
/// Rounding inside the masked solve, relative to natural accelerations.
const SOLVE: f64 = 1e-14;

/// Whether a state of a phase never moves.
pub(crate) fn is_equilibrium(context: &RunContext, phase: &dyn Phase, state: &[f64]) -> bool {
    let layout = context.layout();
    // What depends on time may set it in motion later.
    if layout.timed {
        return false;
    }
    let info = phase.info();
    let mut reduced: Numbers = smallvec![0.0; info.entries];
    phase.restrict(state, &mut reduced);
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
    let unit = |&entry: &usize| match info.form {
        Form::Projected => SOLVE * context.scales.entry(layout, entry) / context.scales.time,
        Form::Closed => 0.0,
    };
    let mut rounding: Numbers = phase.kept().iter().map(unit).collect();
    for j in 0..info.coordinates {
        let mut moved = reduced.clone();
        moved[j] += ROUNDINGS * reduced[j];
        let there = derivative(&moved);
        rates.clone().for_each(|k| rounding[k] += (there[k] - now[k]).abs());
    }
    rates.into_iter().all(|k| now[k].abs() <= rounding[k])
}
