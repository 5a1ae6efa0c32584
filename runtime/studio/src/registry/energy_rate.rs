//! How fast a phase gains or loses energy, from its equations: Ė along the motion.

use liftoff_core::system::PhaseEquations;

/// Part of the natural time over which Ė is a difference.
const STEP: f64 = 1e-5;

/// Ė at a full state of a phase, time being counted in `unit`.
pub fn energy_rate(phase: &dyn PhaseEquations, state: &[f64], unit: f64) -> f64 {
    let entries = phase.info().entries;
    let (mut here, mut rates) = (vec![0.0; entries], vec![0.0; entries]);
    phase.restrict(state, &mut here);
    phase.derivative(&here, &mut rates);
    let energy = |step: f64| {
        let moved: Vec<f64> = here.iter().zip(&rates).map(|(x, rate)| rate.mul_add(step, *x)).collect();
        let energy = phase.energy(&moved);
        energy.kinetic + energy.potential
    };
    let step = STEP * unit;
    (energy(step) - energy(-step)) / (2.0 * step)
}
