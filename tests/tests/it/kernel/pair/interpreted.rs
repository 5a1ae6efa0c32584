//! The same model interpreted, on the numbers that the engine uses.

use liftoff_codegen::functions::PhaseFunctions;
use liftoff_core::model::{ContactSet, Form};
use liftoff_core::system::PhaseEquations;
use liftoff_interpreter::Interpreted;
use std::sync::Arc;

use super::{Full, Pair};

impl Pair {
    /// Coordinates, rates and the time where the equations depend on it.
    fn state(&self, full: &Full) -> Vec<f64> {
        let n = self.analysis.motion.n;
        let time = full.0.last().filter(|_| self.analysis.motion.is_timed());
        full.0[..2 * n].iter().chain(time).copied().collect()
    }

    /// The motion that the engine is given, against that of these equations, which is the oracle's.
    pub(super) fn interpreted(&self, full: &Full, set: u64, a: &[f64], lambda: &[f64], force: f64) {
        let (mut accelerations, mut multipliers) = (vec![0.0; a.len()], vec![0.0; lambda.len()]);
        let model = Interpreted::from_analysis(&self.analysis).model(&self.parameters);
        let closed = ContactSet::from_bits(set);
        model.system.solve(&self.state(full), closed, &mut accelerations, &mut multipliers);
        self.close("interpreted accelerations", &accelerations, a);
        self.close_to("interpreted multipliers", &multipliers, lambda, force);
    }

    /// A closed form as the engine is given it, against the values of its functions.
    pub(super) fn interpreted_form(&self, functions: &PhaseFunctions, full: &Full, [a, r]: [&[f64]; 2]) {
        let model = Interpreted::from_analysis(&self.analysis).model(&self.parameters);
        let set = ContactSet::from_bits_and_stick(functions.set.closed, functions.set.stick);
        let phase: Arc<dyn PhaseEquations> = model.system.phase(set, Form::Reduced);
        let (mut y, mut reactions) = (vec![0.0; phase.info().entries], vec![0.0; r.len()]);
        phase.restrict(&self.state(full), &mut y);
        let mut f = y.clone();
        phase.derivative(&y, &mut f);
        phase.reactions(&y, &mut reactions);
        let rates = phase.info().places_of_rates();
        self.close("interpreted form", &f[rates], a);
        self.close("interpreted reactions", &reactions, r);
        let mut series = phase.series().expect("small forms have one");
        series.expand(&y, 1.0, 2);
        self.close("interpreted series", &series.series()[y.len()..2 * y.len()], &f);
    }
}
