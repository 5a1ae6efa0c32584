//! Whether a phase at rest stays there: its accelerations vanish, or are no larger than what rounding of the
//! coordinates makes of zero (sin π is not 0 in floating point, yet a pendulum at π never falls).

use crate::model::{Array, BarSystem, Form, Phase, PhaseVisitor};
use crate::scales::Scales;

/// Roundings of a coordinate: it was typed in, converted and added to.
const ROUNDINGS: f64 = 4.0 * f64::EPSILON;
/// Rounding inside the masked solve, relative to natural accelerations.
const SOLVE: f64 = 1e-14;

/// Visits the phase of a state; true if it never moves.
pub(crate) struct Rest<'a, M: BarSystem> {
    pub(crate) constants: &'a M::Constants<f64>,
    pub(crate) scales: &'a Scales,
    pub(crate) state: &'a M::State<f64>,
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Rest<'_, M> {
    type Output = bool;

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> bool {
        // What depends on time may set it in motion later.
        if M::LAYOUT.timed {
            return false;
        }
        let rates = phase.coordinates..phase.coordinates + phase.rates;
        let reduced = (phase.restrict)(self.state);
        let derivative = |r: &[f64; N]| (phase.derivative)(self.constants, phase.set, r);
        let now = derivative(&reduced);
        if reduced[rates.clone()].iter().any(|rate| *rate != 0.0) {
            return false;
        }
        let mut rounding = [0.0; N];
        if phase.form == Form::Projected {
            let units = self.scales.state::<M>();
            let units = (phase.restrict)(&M::State::from_fn(|i| units[i]));
            rounding = units.map(|unit| SOLVE * unit / self.scales.time);
        }
        for j in 0..phase.coordinates {
            let mut moved = reduced;
            moved[j] += ROUNDINGS * reduced[j];
            let there = derivative(&moved);
            rates.clone().for_each(|k| rounding[k] += (there[k] - now[k]).abs());
        }
        rates.into_iter().all(|k| now[k].abs() <= rounding[k])
    }
}
