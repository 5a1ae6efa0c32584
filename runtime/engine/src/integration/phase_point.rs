//! The motion of a phase at one time.

#[cfg(test)]
mod tests;

use std::cell::{OnceCell, RefCell};
use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use smallvec::smallvec;

use crate::contact::friction::SharedFriction;
use crate::contact::shortest_reactions;
use crate::context::{Numbers, reactions_of};
use crate::model::{ContactSet, Energy, Form, Slip};
use crate::system::PhaseEquations;
/// A state of a phase at a time, with what follows from it computed when asked for.
pub(crate) struct PhasePoint {
    phase: Arc<dyn PhaseEquations>,
    /// The closed contacts: those of the phase, and those that depend on them.
    closed: ContactSet,
    t: f64,
    reduced: Numbers,
    state: Numbers,
    solution: OnceCell<PhaseSolution>,
    accelerations: OnceCell<Numbers>,
    redundant: OnceCell<bool>,
    /// The dual of the last shares of a load, from which the next ones are near.
    dual: RefCell<Option<DVector<f64>>>,
    /// The energy lost since the start of the motion, where that is known.
    dissipated: f64,
}

struct PhaseSolution {
    accelerations: Numbers,
    multipliers: Numbers,
}

impl PhasePoint {
    /// At the time `t`, also where the reduced state has an entry for the time.
    pub(crate) fn new(phase: Arc<dyn PhaseEquations>, closed: ContactSet, t: f64, reduced: Numbers) -> Self {
        let state = smallvec![0.0; phase.system().layout().entries()];
        let mut point = Self {
            phase,
            closed,
            t,
            reduced,
            state,
            solution: OnceCell::new(),
            accelerations: OnceCell::new(),
            redundant: OnceCell::new(),
            dual: RefCell::default(),
            dissipated: f64::NAN,
        };
        point.follow();
        point
    }

    /// Moves to another time, where `write` writes the reduced state.
    pub(crate) fn move_to(&mut self, t: f64, write: impl FnOnce(&mut [f64])) {
        write(&mut self.reduced);
        self.t = t;
        self.solution.take();
        self.accelerations.take();
        self.redundant.take();
        self.follow();
    }

    fn follow(&mut self) {
        let info = self.phase.info();
        if self.phase.system().layout().timed {
            self.reduced[info.coordinates + info.rates] = self.t;
        }
        self.phase.embed(&self.reduced, &mut self.state);
    }

    pub(crate) fn t(&self) -> f64 {
        self.t
    }

    /// The same with the energy that has been lost since the start of its motion.
    pub(crate) fn having_lost(self, dissipated: f64) -> Self {
        Self { dissipated, ..self }
    }

    /// The energy lost since the start of the motion; not a number where that is not known.
    pub(crate) fn dissipated(&self) -> f64 {
        self.dissipated
    }

    /// The full state.
    pub(crate) fn state(&self) -> &[f64] {
        &self.state
    }

    /// Accelerations of all coordinates. Kept ones come from the phase's own equations, which lose
    /// no digits by cancellation; the others follow by the rows that they were eliminated with.
    pub(crate) fn accelerations(&self) -> &[f64] {
        self.accelerations.get_or_init(|| {
            let info = self.phase.info();
            let mut accelerations = self.solution().accelerations.clone();
            if info.form == Form::Reduced {
                let mut own: Numbers = smallvec![0.0; info.entries];
                self.phase.derivative(&self.reduced, &mut own);
                for place in info.places_of_rates() {
                    accelerations[coordinate_of(&*self.phase, place)] = own[place];
                }
                if let Some(others) = self.compute_eliminated(&accelerations) {
                    others.into_iter().for_each(|(coordinate, a)| accelerations[coordinate] = a);
                }
            }
            accelerations
        })
    }

    /// Multipliers of all rows, zero where open.
    pub(crate) fn multipliers(&self) -> &[f64] {
        &self.solution().multipliers
    }

    /// Reactions of all contacts, the shortest where they are not unique, then the friction forces.
    pub(crate) fn reactions(&self) -> Numbers {
        let layout = self.phase.system().layout();
        if self.is_redundant() {
            return reactions_of(layout, self.multipliers());
        }
        let mut reactions: Numbers = smallvec![0.0; layout.reactions()];
        self.phase.reactions(&self.reduced, &mut reactions);
        reactions
    }

    /// Whether a contact with friction is closed and does not slip.
    pub(crate) fn sticks(&self, contact: usize) -> bool {
        self.closed.contains(contact) && self.closed.slip(contact) == Slip::Stick
    }

    /// Whether more contacts are closed than the phase needs to hold them, or friction holds more
    /// than it needs.
    fn is_redundant(&self) -> bool {
        let shares = || !SharedFriction::compute(self.phase.system(), &self.state, &self.closed).is_empty();
        *self.redundant.get_or_init(|| self.closed != self.phase.info().set || shares())
    }

    /// T and V.
    pub(crate) fn energy(&self) -> Energy<f64> {
        self.phase.energy(&self.reduced)
    }

    /// What the full equations with the bearing contacts closed have, multipliers shared.
    fn solution(&self) -> &PhaseSolution {
        self.solution.get_or_init(|| {
            let (system, info) = (self.phase.system(), self.phase.info());
            let layout = system.layout();
            let mut accelerations: Numbers = smallvec![0.0; layout.coordinates.len()];
            let mut multipliers: Numbers = smallvec![0.0; layout.rows()];
            system.solve(&self.state, info.set, &mut accelerations, &mut multipliers);
            if self.is_redundant() {
                multipliers = shortest_reactions(
                    system,
                    &self.state,
                    &self.closed,
                    &multipliers,
                    &mut self.dual.borrow_mut(),
                );
            }
            PhaseSolution { accelerations, multipliers }
        })
    }

    /// Accelerations of the coordinates that are not kept, from J q̈ + J̇ q̇ + ∂²g/∂t² = 0 of the
    /// rows that hold: rows may differ by little, as of a bar that is all but upright, and entries
    /// of J have all digits. None where these rows are not as many.
    fn compute_eliminated(&self, accelerations: &[f64]) -> Option<Vec<(usize, f64)>> {
        let (system, info) = (self.phase.system(), self.phase.info());
        let layout = system.layout();
        let mut known = Numbers::from_slice(accelerations);
        let kept: Vec<usize> = info.places_of_rates().map(|k| coordinate_of(&*self.phase, k)).collect();
        let eliminated: Vec<usize> = (0..known.len()).filter(|i| !kept.contains(i)).collect();
        let rows: Vec<usize> = (0..layout.rows()).filter(|row| layout.is_closed(*row, &info.set)).collect();
        if eliminated.is_empty() || rows.len() != eliminated.len() {
            return None;
        }
        eliminated.iter().for_each(|&i| known[i] = 0.0);
        let equations = system.equations(&self.state);
        let mut jacobian =
            DMatrix::from_fn(rows.len(), rows.len(), |k, i| equations.jacobian(rows[k])[eliminated[i]]);
        let mut rest = DVector::from_fn(rows.len(), |k, _| -equations.gap_acceleration(rows[k], &known));
        for (k, mut row) in jacobian.row_iter_mut().enumerate() {
            let unit = row.amax();
            row /= unit;
            rest[k] /= unit;
        }
        let is_solved = jacobian.full_piv_lu().solve_mut(&mut rest);
        let is_known = is_solved && rest.iter().all(|a| a.is_finite());
        is_known.then(|| eliminated.into_iter().zip(rest.iter().copied()).collect())
    }
}

/// The coordinate whose rate is at this place of the reduced state.
pub(crate) fn coordinate_of(phase: &dyn PhaseEquations, place: usize) -> usize {
    phase.kept()[place] - phase.system().layout().coordinates.len()
}
