//! What counts as zero: max(10 tol, 64 ε, 2 ε t · fastest rate) of a natural unit, and of a gap at
//! least 64 ε Σ |Jᵢ qᵢ|, the roundoff of its terms.

use std::cell::Ref;

use super::Snapshot;
use crate::context::Numbers;
use crate::model::ContactSet;
use crate::numerics::zero::{compute_place_error, roundoff};
use crate::simulation::Simulation;

/// What counts as zero at a time and a state.
#[derive(Default)]
pub(super) struct ZeroBounds {
    t: f64,
    state: Numbers,
    /// Local errors of ten steps, or some roundings, or what the motion goes in the rounding of a
    /// time that is long.
    usual: f64,
    /// Roundoff of each gap, where that may be more.
    roundings: Numbers,
}

impl ZeroBounds {
    fn compute(setup: &Simulation, t: f64, state: &[f64]) -> Self {
        let context = &setup.context;
        let fastest = context.scales.fastest(context.layout(), &state[context.rates()]);
        let usual = compute_place_error(setup.tolerance).max(roundoff(2.0) * t.abs() * fastest);
        Self { t, state: Numbers::from_slice(state), usual, roundings: context.roundings(state, usual) }
    }
}

impl Snapshot<'_> {
    /// What counts as zero at the state, that of closed contacts too: a projection back onto them
    /// turns the motion by as much as the rounding of coordinates lets it leave them.
    pub(in crate::simulation) fn relative_bound(&self) -> f64 {
        self.bound_with(ContactSet::EMPTY)
    }

    /// The same with more contacts closed.
    pub(in crate::simulation) fn bound_with(&self, more: ContactSet) -> f64 {
        let ZeroBounds { usual, roundings, .. } = &*self.tiny();
        if roundings.is_empty() {
            return *usual;
        }
        let closed = self.closed().union(more);
        let held = (0..roundings.len()).filter(|row| self.layout().is_closed(*row, &closed));
        held.fold(*usual, |most, row| most.max(roundings[row]))
    }

    /// What of the gap of each contact counts as zero, m or rad.
    pub(in crate::simulation) fn gap_bounds(&self) -> impl Fn(usize) -> f64 {
        let (usual, length) = (self.relative_bound(), self.setup.context.scales.length);
        let (roundings, layout) = (self.tiny().roundings.clone(), self.layout());
        move |contact| {
            usual.max(roundings.get(contact).copied().unwrap_or(0.0)) * layout.unit(contact, length)
        }
    }

    fn tiny(&self) -> Ref<'_, ZeroBounds> {
        let is_known = |known: &ZeroBounds| known.t == self.t && known.state[..] == self.state[..];
        if !is_known(&self.memory.borrow().tiny) {
            self.memory.borrow_mut().tiny = ZeroBounds::compute(self.setup, self.t, &self.state);
        }
        Ref::map(self.memory.borrow(), |memory| &memory.tiny)
    }
}
