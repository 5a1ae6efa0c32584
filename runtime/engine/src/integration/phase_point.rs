//! A model in a run, and its motion at one time.

#[cfg(test)]
mod tests;

use std::cell::{OnceCell, RefCell};
use std::sync::Arc;

use nalgebra::DVector;
use smallvec::{SmallVec, smallvec};

use crate::contact::friction::Grip;
use crate::contact::shortest_reactions;
use crate::event::detection::Signal;
use crate::model::{ContactSet, DependentAngle, Energy, Form, Layout, Slip};
use crate::scales::Scales;
use crate::simulation::Switch;
use crate::system::{Equations, Model, Phase, System};

/// Some numbers; those of small models need no allocation.
pub(crate) type Numbers = SmallVec<[f64; 16]>;

/// So many roundings of the coordinates are no gap, and of the way that they have come: each is that of some steps.
pub(crate) const ROUNDINGS: f64 = 64.0 * f64::EPSILON;
/// What moves a gap by more than so many units of a coordinate, of each, is not expected.
const LEVER: f64 = 16.0;

/// What of a model does not change during a run.
#[derive(Clone)]
pub(crate) struct RunContext {
    pub(crate) model: Model,
    pub(crate) scales: Scales,
    pub(crate) switches: Vec<Switch>,
    pub(crate) signals: Vec<Signal>,
}

impl RunContext {
    pub(crate) fn layout(&self) -> &'static Layout {
        self.model.layout()
    }

    pub(crate) fn system(&self) -> &dyn System {
        &*self.model.system
    }

    /// Value and rate of each dependent angle in a state.
    pub(crate) fn dependent(&self, state: &[f64]) -> Vec<(&'static str, [f64; 2])> {
        let n = self.layout().coordinates.len();
        let parameters = &self.model.parameters;
        let motion = |angle: &DependentAngle| {
            (angle.name, [angle.value(parameters, &state[..n]), angle.rate(&state[n..2 * n])])
        };
        self.layout().dependent.iter().map(motion).collect()
    }

    /// Where a state has its rates.
    pub(crate) fn rates(&self) -> core::ops::Range<usize> {
        let n = self.layout().coordinates.len();
        n..2 * n
    }

    /// Whether T + V is constant between impacts: no loads, dampers, friction, drives or anything else that depends on time.
    pub(crate) fn is_conservative(&self) -> bool {
        !self.is_worked_on() && self.layout().frictions.is_empty()
    }

    /// Whether anything but friction may change T + V between impacts.
    pub(crate) fn is_worked_on(&self) -> bool {
        self.layout().timed || self.layout().loaded || self.scales.damped
    }

    /// What the rounding of the coordinates makes of a gap that is zero, in its own unit: along a slope the height of a point is a
    /// difference of terms as large as it is far.
    pub(crate) fn rounding(&self, equations: &Equations<f64>, row: usize, positions: &[f64]) -> f64 {
        ROUNDINGS * equations.terms(row, positions) / self.layout().unit(row, self.scales.length)
    }

    /// That of each gap; nothing where it is less than `bound`.
    pub(crate) fn roundings(&self, state: &[f64], bound: f64) -> Numbers {
        let (layout, n) = (self.layout(), self.layout().coordinates.len());
        if !self.is_far(state[..n].iter().enumerate(), bound) {
            return Numbers::new();
        }
        let equations = self.system().equations(state);
        let rows = 0..layout.contacts.len() + layout.joints.len();
        rows.map(|row| self.rounding(&equations, row, &state[..n])).collect()
    }

    /// Whether coordinates, given with their places, are so large that their rounding may count beside `bound`.
    pub(crate) fn is_far<'q>(&self, mut of: impl Iterator<Item = (usize, &'q f64)>, bound: f64) -> bool {
        let layout = self.layout();
        let near = bound / (LEVER * ROUNDINGS * layout.coordinates.len() as f64);
        of.any(|(i, q)| q.abs() > near * self.scales.coordinate(&layout.coordinates[i]))
    }

    /// How far the coordinates are from zero, in natural units and at least one, and the rounding accumulated over the way that
    /// they have come at their rates by the time `t`.
    pub(crate) fn travelled(&self, state: &[f64], t: f64) -> [f64; 2] {
        let (layout, n) = (self.layout(), self.layout().coordinates.len());
        let unit = |i: usize| self.scales.entry(layout, i);
        let far = (0..n).map(|i| state[i].abs() / unit(i)).fold(1.0, f64::max);
        let way = (0..n).map(|i| state[n + i].abs() * t / unit(i)).fold(0.0, f64::max);
        [far, ROUNDINGS * way]
    }

    /// The phase of a contact set, in closed form only if it has one.
    pub(crate) fn phase(&self, set: ContactSet, form: Form) -> Arc<dyn Phase> {
        Arc::clone(&self.model.system).phase(set, form)
    }
}

/// A state of a phase at a time, with what follows from it computed when asked for.
pub(crate) struct PhasePoint {
    phase: Arc<dyn Phase>,
    /// The closed contacts: those of the phase, and those that depend on them.
    closed: ContactSet,
    t: f64,
    reduced: Numbers,
    state: Numbers,
    solution: OnceCell<Solution>,
    redundant: OnceCell<bool>,
    /// The dual of the last shares of a load, from which the next ones are near.
    dual: RefCell<Option<DVector<f64>>>,
    /// The energy lost since the start of the motion, where that is known.
    dissipated: f64,
}

struct Solution {
    accelerations: Numbers,
    multipliers: Numbers,
}

impl PhasePoint {
    /// At the time `t`, also where the reduced state has an entry for the time.
    pub(crate) fn new(phase: Arc<dyn Phase>, closed: ContactSet, t: f64, reduced: Numbers) -> Self {
        let state = smallvec![0.0; phase.system().layout().entries()];
        let mut point = Self {
            phase,
            closed,
            t,
            reduced,
            state,
            solution: OnceCell::new(),
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

    /// Accelerations of all coordinates.
    pub(crate) fn accelerations(&self) -> &[f64] {
        &self.solution().accelerations
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

    /// Whether more contacts are closed than the phase needs to hold them, or friction holds more than it needs.
    fn is_redundant(&self) -> bool {
        let shares = || !Grip::of(self.phase.system(), &self.state, &self.closed).is_empty();
        *self.redundant.get_or_init(|| self.closed != self.phase.info().set || shares())
    }

    /// T and V.
    pub(crate) fn energy(&self) -> Energy<f64> {
        self.phase.energy(&self.reduced)
    }

    /// Kept accelerations come from the phase's own equations, which lose no digits by cancellation; the others follow.
    fn solution(&self) -> &Solution {
        self.solution.get_or_init(|| {
            let (system, info) = (self.phase.system(), self.phase.info());
            let layout = system.layout();
            let mut accelerations: Numbers = smallvec![0.0; layout.coordinates.len()];
            let mut multipliers: Numbers = smallvec![0.0; layout.rows()];
            system.solve(&self.state, info.set, &mut accelerations, &mut multipliers);
            if info.form == Form::Closed {
                let mut own: Numbers = smallvec![0.0; info.entries];
                self.phase.derivative(&self.reduced, &mut own);
                for place in info.places_of_rates() {
                    accelerations[coordinate_of(&*self.phase, place)] = own[place];
                }
            }
            if self.is_redundant() {
                multipliers = shortest_reactions(
                    system,
                    &self.state,
                    &self.closed,
                    &multipliers,
                    &mut self.dual.borrow_mut(),
                );
            }
            Solution { accelerations, multipliers }
        })
    }
}

/// Reactions of all contacts, then the friction forces, of the multipliers of all rows.
pub(crate) fn reactions_of(layout: &Layout, multipliers: &[f64]) -> Numbers {
    (0..layout.reactions()).map(|entry| multipliers[layout.row_of_reaction(entry)]).collect()
}

/// The coordinate whose rate is at this place of the reduced state.
pub(crate) fn coordinate_of(phase: &dyn Phase, place: usize) -> usize {
    phase.kept()[place] - phase.system().layout().coordinates.len()
}
