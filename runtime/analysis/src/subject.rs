//! What is analysed.

use std::sync::Arc;

use liftoff::{Scales, Simulation, StartError};
use liftoff_core::model::{ContactSet, Layout, Slip};
use liftoff_core::scalar::{DoubleDouble, Real};
use liftoff_core::system::System;

use crate::AnalysisError;

/// A contact is closed within this part of the natural length.
const CLOSED: f64 = 1e-9;

/// A model with its parameters in double-double, its natural units, and a position at rest to begin
/// with.
#[derive(Clone)]
pub struct Subject {
    pub(crate) system: Arc<dyn System<DoubleDouble>>,
    pub(crate) scales: Scales,
    pub(crate) state: Vec<DoubleDouble>,
}

impl Subject {
    /// The model of a simulation, at the position that it starts from; `system`: its equations in
    /// double-double, from [`precise`](liftoff_core::system::precise).
    ///
    /// # Errors
    /// The start is refused.
    pub fn new(simulation: &Simulation, system: Arc<dyn System<DoubleDouble>>) -> Result<Self, StartError> {
        let layout = simulation.layout();
        let n = layout.coordinates.len();
        let state = simulation.start_state()?;
        let at_rest = |(i, value): (usize, &f64)| if (n..2 * n).contains(&i) { 0.0 } else { *value };
        let state = state.iter().enumerate().map(at_rest).map(DoubleDouble::from_f64).collect();
        Ok(Self { system, scales: simulation.scales(), state })
    }

    /// Names of everything.
    pub fn layout(&self) -> &'static Layout {
        self.system.layout()
    }

    /// Its position, coordinate by coordinate.
    pub fn positions(&self) -> Vec<f64> {
        self.state[..self.layout().coordinates.len()].iter().map(|q| q.hi()).collect()
    }

    /// The contacts that are closed at its position; those with friction stick.
    pub fn touching(&self) -> ContactSet {
        self.touching_at(&self.state)
    }

    /// The contacts of these supports.
    ///
    /// # Errors
    /// There is no such support, or it is open at the position.
    pub fn contacts(&self, supports: &[&str]) -> Result<ContactSet, AnalysisError> {
        let set = liftoff::contact_set(self.layout(), supports)?;
        let touching = self.touching();
        if let Some(open) = set.iter().find(|&i| !touching.contains(i)) {
            let gap = self.gaps(&self.state)[open];
            return Err(AnalysisError::Open { contact: self.layout().contacts[open].label.to_owned(), gap });
        }
        Ok(self.sticking(set.union(self.layout().guides())))
    }

    pub(crate) fn touching_at(&self, state: &[DoubleDouble]) -> ContactSet {
        let gaps = self.gaps(state);
        let feet = self.feet(state);
        let (layout, length) = (self.layout(), self.scales.length);
        let on_bar = |i: usize| {
            let foot = layout.contacts[i].foot;
            foot.is_none_or(|k| feet[2 * k..2 * k + 2].iter().all(|margin| *margin >= -CLOSED * length))
        };
        let is_closed = |&i: &usize| gaps[i].abs() <= CLOSED * layout.unit(i, length) && on_bar(i);
        let closed = self.candidates().into_iter().filter(is_closed);
        self.sticking(closed.collect::<ContactSet>().union(self.layout().guides()))
    }

    /// Contacts that are closed or open by their gaps alone.
    pub(crate) fn candidates(&self) -> Vec<usize> {
        let contacts = self.layout().contacts.iter().enumerate();
        let there = contacts.filter(|(_, c)| c.kind.is_one_sided() && c.armed.is_none());
        there.map(|(i, _)| i).collect()
    }

    pub(crate) fn sticking(&self, set: ContactSet) -> ContactSet {
        let frictions = self.layout().frictions.iter().map(|friction| friction.contact);
        frictions.filter(|&i| set.contains(i)).fold(set, |set, i| set.slipping(i, Slip::Stick))
    }

    pub(crate) fn gaps(&self, state: &[DoubleDouble]) -> Vec<f64> {
        let mut gaps = vec![DoubleDouble::from_f64(0.0); self.layout().contacts.len()];
        self.system.gaps(state, &mut gaps);
        gaps.into_iter().map(DoubleDouble::hi).collect()
    }

    pub(crate) fn feet(&self, state: &[DoubleDouble]) -> Vec<f64> {
        let mut feet = vec![DoubleDouble::from_f64(0.0); 2 * self.layout().feet()];
        self.system.feet(state, &mut feet);
        feet.into_iter().map(DoubleDouble::hi).collect()
    }

    /// Refuses what never stays at rest, or does so anywhere.
    pub(crate) fn refuse_unsuited(&self) -> Result<(), AnalysisError> {
        match self.layout() {
            layout if layout.timed => Err(AnalysisError::Timed),
            layout if layout.has_hinges() => Err(AnalysisError::HingeFriction),
            _ => Ok(()),
        }
    }

    /// The unit of δξ, M-orthonormal coordinates: √mass · length.
    pub(crate) fn unit(&self) -> f64 {
        self.scales.mass.sqrt() * self.scales.length
    }
}
