//! A model on other numbers, and the motion of one of its phases.

use std::sync::Arc;

use crate::Number;
use crate::extrapolation::Field;
use liftoff::{Scales, Trajectory};
use liftoff_core::model::{ContactSet, Energy, Form, Layout};
use liftoff_core::system::{ModelOn, PhaseEquations};

/// A model's equations and values, with the natural units of the run.
pub(crate) struct ReplayModel<S: Number> {
    pub(crate) on: ModelOn<S>,
    /// Of each entry of a full state.
    pub(crate) units: Vec<f64>,
    pub(crate) length: f64,
    pub(crate) time: f64,
}

impl<S: Number> ReplayModel<S> {
    /// The model of a run on these numbers.
    pub(crate) fn new(run: &Trajectory, on: ModelOn<S>) -> Self {
        let Scales { length, time, .. } = run.scales();
        Self { on, units: run.scales().state(run.layout()), length, time }
    }

    pub(crate) fn layout(&self) -> &'static Layout {
        self.on.system.layout()
    }

    /// The phase of a contact set.
    pub(crate) fn phase(&self, set: ContactSet, form: Form) -> ReplayPhase<S> {
        ReplayPhase { phase: Arc::clone(&self.on.system).phase(set, form), length: self.length }
    }

    /// Accelerations and multipliers of all rows at a full state.
    pub(crate) fn solve(&self, set: ContactSet, state: &[S]) -> (Vec<S>, Vec<S>) {
        let mut accelerations = vec![S::ZERO; self.layout().coordinates.len()];
        let mut multipliers = vec![S::ZERO; self.layout().rows()];
        self.on.system.solve(state, set, &mut accelerations, &mut multipliers);
        (accelerations, multipliers)
    }

    /// Positions of the points at a full state, x then y of each.
    pub(crate) fn points(&self, state: &[S]) -> Vec<S> {
        let mut points = vec![S::ZERO; 2 * self.layout().points.len()];
        self.on.system.points(state, &mut points);
        points
    }
}

/// The equations of a phase, brought back on their constraints after each step.
pub(crate) struct ReplayPhase<S: Number> {
    phase: Arc<dyn PhaseEquations<S>>,
    length: f64,
}

impl<S: Number> ReplayPhase<S> {
    /// The closed contacts.
    pub(crate) fn set(&self) -> ContactSet {
        self.phase.info().set
    }

    /// Natural size of each entry of the reduced state, from those of a full one.
    pub(crate) fn units(&self, full: &[f64]) -> Vec<f64> {
        self.phase.kept().iter().map(|&entry| full[entry]).collect()
    }

    /// The reduced state of a full one, on the constraints.
    pub(crate) fn restrict(&self, mut state: Vec<S>) -> Vec<S> {
        self.project(&mut state);
        let mut y = vec![S::ZERO; self.phase.info().entries];
        self.phase.restrict(&state, &mut y);
        y
    }

    /// The full state of a reduced one.
    pub(crate) fn embed(&self, y: &[S]) -> Vec<S> {
        let mut state = vec![S::ZERO; self.phase.system().layout().entries()];
        self.phase.embed(y, &mut state);
        state
    }

    /// Reactions of all contacts.
    pub(crate) fn reactions(&self, y: &[S]) -> Vec<S> {
        let mut reactions = vec![S::ZERO; self.phase.system().layout().reactions()];
        self.phase.reactions(y, &mut reactions);
        reactions
    }

    /// T and V.
    pub(crate) fn energy(&self, y: &[S]) -> Energy<S> {
        self.phase.energy(y)
    }

    fn is_projected(&self) -> bool {
        self.phase.info().form == Form::Multipliers
    }

    fn project(&self, state: &mut [S]) {
        if self.is_projected() {
            self.phase.system().project(self.set(), state, self.length);
        }
    }
}

impl<S: Number> Field<S> for ReplayPhase<S> {
    fn rates(&self, y: &[S], rates: &mut [S]) {
        self.phase.derivative(y, rates);
    }

    fn restore(&self, y: &mut [S]) {
        if self.is_projected() {
            let mut state = self.embed(y);
            self.project(&mut state);
            self.phase.restrict(&state, y);
        }
    }
}
