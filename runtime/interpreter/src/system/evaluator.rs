//! An interpreted model as a `System`, on any number.

use std::sync::Arc;

use liftoff_core::hinge;
use liftoff_core::model::{ContactSet, Energy, Form, KernelView, Layout, SlipState};
use liftoff_core::project::project_by;
use liftoff_core::system::{Equations, LongTimeSeries, PhaseEquations, SeriesEquations, System, TimeSeries};

use super::full::FullCode;
use super::kernel::Kernel;
use super::phase::InterpretedPhase;
use crate::interpreted::Interpreted;
use crate::pool::{Lent, Number};

/// A model with the values of its constants on numbers `S`, in a contact set.
pub(crate) struct Evaluator<S> {
    pub(super) model: Arc<Interpreted>,
    pub(super) parameters: Arc<[S]>,
    pub(super) constants: Vec<S>,
}

impl<S: Number> Evaluator<S> {
    pub fn new(model: &Arc<Interpreted>, parameters: &[S], set: ContactSet) -> Self {
        let constants = model.constants.values(parameters, &set);
        Self { model: Arc::clone(model), parameters: parameters.into(), constants }
    }

    /// The same with the senses of the contacts that slide in a set; none where those here hold.
    pub(super) fn sliding(&self, set: &ContactSet) -> Option<Self> {
        let slides = self.model.layout.sliding(set).next().is_some();
        slides.then(|| Self::new(&self.model, &self.parameters, *set))
    }

    pub(super) fn full(&self) -> &FullCode {
        &self.model.full
    }

    pub(super) fn kernel(&self, state: &[S]) -> Kernel<S> {
        Kernel::evaluate(self.full(), &self.constants, &self.whole(state))
    }

    /// The state, not a number beyond its end.
    fn whole(&self, state: &[S]) -> Lent<S> {
        let mut whole = Lent::new(self.full().entries);
        let (known, rest) = whole.split_at_mut(state.len().min(self.full().entries));
        known.copy_from_slice(&state[..known.len()]);
        rest.fill(S::from_f64(f64::NAN));
        whole
    }

    pub(super) fn energy_at(&self, state: &[S]) -> Energy<S> {
        let mut energy = [S::ZERO; 2];
        self.full().energy.evaluate(&self.constants, &[&self.whole(state)], &mut energy);
        let [kinetic, potential] = energy;
        Energy { kinetic, potential }
    }

    pub(super) fn motion(
        &self,
        state: &[S],
        set: &ContactSet,
        accelerations: &mut [S],
        multipliers: &mut [S],
    ) -> bool {
        let layout = self.model.layout;
        if !layout.has_hinges() {
            return self.kernel(state).solve(layout, set, accelerations, multipliers);
        }
        let force = |entry: usize, a: &[S], lambda: &[S]| self.quantity_at(entry, state, a, lambda);
        hinge::solve(self.kernel(state), (layout, set), &force, accelerations, multipliers)
    }

    fn quantity_at(&self, entry: usize, state: &[S], accelerations: &[S], multipliers: &[S]) -> S {
        let missing = S::from_f64(f64::NAN);
        let Some(&[group, place]) = self.full().quantities.get(entry) else { return missing };
        let code = &self.full().quantity_codes[group];
        let mut values = Lent::new(code.outputs.len());
        let mut given = Lent::new(self.full().coordinates + self.full().rows);
        given.fill(missing);
        let (a, lambda) = given.split_at_mut(self.full().coordinates);
        a.iter_mut().zip(accelerations).for_each(|(to, from)| *to = *from);
        lambda.iter_mut().zip(multipliers).for_each(|(to, from)| *to = *from);
        code.evaluate(&self.constants, &[&self.whole(state), a, lambda], &mut values);
        values[place]
    }
}

impl<S: Number> System<S> for Evaluator<S>
where
    InterpretedPhase<S>: PhaseEquations<S>,
{
    fn layout(&self) -> &'static Layout {
        self.model.layout
    }

    fn equations(&self, state: &[S]) -> Equations<S> {
        Equations::from_kernel(&self.kernel(state))
    }

    fn gaps(&self, state: &[S], gaps: &mut [S]) {
        self.full().gaps.evaluate(&self.constants, &[&self.whole(state)], gaps);
    }

    fn solve(&self, state: &[S], set: ContactSet, accelerations: &mut [S], multipliers: &mut [S]) -> bool {
        match self.sliding(&set) {
            None => self.motion(state, &set, accelerations, multipliers),
            Some(sliding) => sliding.motion(state, &set, accelerations, multipliers),
        }
    }

    fn correction(&self, state: &[S], set: ContactSet, residual: &[S], change: &mut [S]) {
        self.kernel(state).correction(self.model.layout, &set, &|row| residual[row], change);
    }

    fn project(&self, set: ContactSet, state: &mut [S], length: f64) {
        let mut work = Lent::new(self.full().coordinates);
        project_by(|state: &[S]| self.kernel(state), (self.model.layout, &set), state, length, &mut work);
    }

    fn energy(&self, state: &[S]) -> Energy<S> {
        self.energy_at(state)
    }

    fn points(&self, state: &[S], points: &mut [S]) {
        self.full().points.evaluate(&self.constants, &[&self.whole(state)], points);
    }

    fn feet(&self, state: &[S], feet: &mut [S]) {
        self.full().feet.evaluate(&self.constants, &[&self.whole(state)], feet);
    }

    fn kinks(&self, state: &[S], kinks: &mut [S]) {
        self.full().kinks.evaluate(&self.constants, &[&self.whole(state)], kinks);
    }

    fn slips(&self, state: &[S], slips: &mut [SlipState<S>]) {
        let mut values = Lent::new(3 * slips.len());
        self.full().slips.evaluate(&self.constants, &[&self.whole(state)], &mut values);
        for (slip, &[velocity, kinetic, limit]) in slips.iter_mut().zip(values.as_chunks().0) {
            *slip = SlipState { velocity, kinetic, limit };
        }
    }

    fn quantity(&self, entry: usize, state: &[S], accelerations: &[S], multipliers: &[S]) -> S {
        self.quantity_at(entry, state, accelerations, multipliers)
    }

    fn phase(self: Arc<Self>, set: ContactSet, form: Form) -> Arc<dyn PhaseEquations<S>> {
        let system = match self.sliding(&set) {
            None => self,
            Some(sliding) => Arc::new(sliding),
        };
        Arc::new(InterpretedPhase::new(system, set, form))
    }
}

impl SeriesEquations for Evaluator<TimeSeries> {
    fn equations(&self, state: &[TimeSeries]) -> Option<Equations<TimeSeries>> {
        (!self.model.layout.contacts.is_empty()).then(|| Equations::from_kernel(&self.kernel(state)))
    }

    fn long_equations(&self, state: &[LongTimeSeries]) -> Option<Equations<LongTimeSeries>> {
        let parameters = self.parameters.iter().map(|x| LongTimeSeries::constant(x.coefficient(0)));
        let parameters: Vec<LongTimeSeries> = parameters.collect();
        let long = Evaluator::new(&self.model, &parameters, ContactSet::EMPTY);
        (!self.model.layout.contacts.is_empty()).then(|| Equations::from_kernel(&long.kernel(state)))
    }

    fn points(&self, state: &[TimeSeries], points: &mut [TimeSeries]) {
        self.full().points.evaluate(&self.constants, &[&self.whole(state)], points);
    }
}
