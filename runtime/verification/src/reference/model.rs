//! A model in double-double, and the motion of one of its phases.

use std::sync::Arc;

use super::extrapolation::Field;
use liftoff::model::{ContactSet, Energy, Form, Layout};
use liftoff::scalar::{DoubleDouble, Scalar};
use liftoff::system::{Phase, System};

/// The equations in double-double, with the natural units of the run.
pub(super) struct PreciseModel {
    pub(super) system: Arc<dyn System<DoubleDouble>>,
    pub(super) parameters: Vec<f64>,
    pub(super) restitution: Vec<f64>,
    /// Of each entry of a full state.
    pub(super) units: Vec<f64>,
    pub(super) length: f64,
    pub(super) time: f64,
}

impl PreciseModel {
    pub(super) fn layout(&self) -> &'static Layout {
        self.system.layout()
    }

    /// The phase of a contact set.
    pub(super) fn phase(&self, set: ContactSet, form: Form) -> PrecisePhase {
        PrecisePhase { phase: Arc::clone(&self.system).phase(set, form), length: self.length }
    }

    /// Accelerations and multipliers of all rows at a full state.
    pub(super) fn solve(
        &self,
        set: ContactSet,
        state: &[DoubleDouble],
    ) -> (Vec<DoubleDouble>, Vec<DoubleDouble>) {
        let mut accelerations = vec![DoubleDouble::ZERO; self.layout().coordinates.len()];
        let mut multipliers = vec![DoubleDouble::ZERO; self.layout().rows()];
        self.system.solve(state, set, &mut accelerations, &mut multipliers);
        (accelerations, multipliers)
    }

    /// Positions of the points at a full state, x then y of each.
    pub(super) fn points(&self, state: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut points = vec![DoubleDouble::ZERO; 2 * self.layout().points.len()];
        self.system.points(state, &mut points);
        points
    }
}

/// The equations of a phase, brought back on their constraints after each step.
pub(super) struct PrecisePhase {
    phase: Arc<dyn Phase<DoubleDouble>>,
    length: f64,
}

impl PrecisePhase {
    /// The closed contacts.
    pub(super) fn set(&self) -> ContactSet {
        self.phase.info().set
    }

    /// Natural size of each entry of the reduced state, from those of a full one.
    pub(super) fn units(&self, full: &[f64]) -> Vec<f64> {
        self.phase.kept().iter().map(|&entry| full[entry]).collect()
    }

    /// The reduced state of a full one, on the constraints.
    pub(super) fn restrict(&self, mut state: Vec<DoubleDouble>) -> Vec<DoubleDouble> {
        self.project(&mut state);
        let mut y = vec![DoubleDouble::ZERO; self.phase.info().entries];
        self.phase.restrict(&state, &mut y);
        y
    }

    /// The full state of a reduced one.
    pub(super) fn embed(&self, y: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut state = vec![DoubleDouble::ZERO; self.phase.system().layout().entries()];
        self.phase.embed(y, &mut state);
        state
    }

    /// Reactions of all contacts.
    pub(super) fn reactions(&self, y: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let mut reactions = vec![DoubleDouble::ZERO; self.phase.system().layout().reactions()];
        self.phase.reactions(y, &mut reactions);
        reactions
    }

    /// T and V.
    pub(super) fn energy(&self, y: &[DoubleDouble]) -> Energy<DoubleDouble> {
        self.phase.energy(y)
    }

    fn is_projected(&self) -> bool {
        self.phase.info().form == Form::Projected
    }

    fn project(&self, state: &mut [DoubleDouble]) {
        if self.is_projected() {
            self.phase.system().project(self.set(), state, self.length);
        }
    }
}

impl Field for PrecisePhase {
    fn rates(&self, y: &[DoubleDouble], rates: &mut [DoubleDouble]) {
        self.phase.derivative(y, rates);
    }

    fn restore(&self, y: &mut [DoubleDouble]) {
        if self.is_projected() {
            let mut state = self.embed(y);
            self.project(&mut state);
            self.phase.restrict(&state, y);
        }
    }
}
