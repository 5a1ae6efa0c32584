//! How fast a phase gains or loses energy, from its equations: Ė along the motion.

use crate::model::{BarSystem, ContactSet, Form, Phase, PhaseVisitor};

/// Part of the natural time over which Ė is a difference.
const STEP: f64 = 1e-5;

/// Ė at a state of the phase with these contacts closed, time being counted in `unit`.
pub fn power<M: BarSystem>(parameters: &[f64], set: ContactSet, state: &M::State<f64>, unit: f64) -> f64 {
    let constants = M::from_parameters(parameters).constants();
    M::phase(set, Form::Projected, Along::<M> { constants: &constants, set, state, step: STEP * unit })
}

struct Along<'a, M: BarSystem> {
    constants: &'a M::Constants<f64>,
    set: ContactSet,
    state: &'a M::State<f64>,
    step: f64,
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Along<'_, M> {
    type Output = f64;

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> f64 {
        let here = (phase.restrict)(self.state);
        let rates = (phase.derivative)(self.constants, self.set, &here);
        let energy = |step: f64| {
            let moved: [f64; N] = core::array::from_fn(|i| rates[i].mul_add(step, here[i]));
            let energy = (phase.energy)(self.constants, &moved);
            energy.kinetic + energy.potential
        };
        (energy(self.step) - energy(-self.step)) / (2.0 * self.step)
    }
}
