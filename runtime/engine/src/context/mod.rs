//! What does not change during a run: a model with its natural scales, and what each stage asks
//! of them.

mod check;
mod slip;

pub(crate) use check::scales_of;
pub(crate) use liftoff_core::scales::Scales;
pub(crate) use slip::{Slips, slips};

use std::sync::Arc;

use smallvec::{SmallVec, smallvec};

use crate::model::{ContactSet, DependentAngle, Form, Layout};
use crate::numerics::zero::roundoff;
use crate::system::{Equations, Model, PhaseEquations, System};

/// A gap below this, relative to the natural length, is closed; a rate likewise, relative to the
/// natural speed. Poses are typed in or printed with ten digits.
pub(crate) const CLOSED: f64 = 1e-10;

/// A value below this part of its natural unit is what the rounding of a state makes of zero.
const STILL: f64 = roundoff(16.0);

/// A rate or impulse, or zero where it is no more than rounding makes of zero in its unit: that
/// would open a contact at rest which has nothing to do with it.
pub(crate) fn without_rounding(value: f64, unit: f64) -> f64 {
    if value.abs() < STILL * unit { 0.0 } else { value }
}

/// Some numbers; those of small models need no allocation.
pub(crate) type Numbers = SmallVec<[f64; 16]>;

/// So many roundings of the coordinates are no gap, and of the way that they have come: each is
/// that of some steps.
pub(crate) const ROUNDINGS: f64 = roundoff(64.0);
/// What moves a gap by more than so many units of a coordinate, of each, is not expected.
const LEVER: f64 = 16.0;

/// What of a model does not change during a run.
#[derive(Clone)]
pub(crate) struct RunContext {
    pub(crate) model: Model,
    pub(crate) scales: Scales,
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

    /// Whether T + V is constant between impacts: no loads, dampers, friction, drives or anything
    /// else that depends on time.
    pub(crate) fn is_conservative(&self) -> bool {
        !self.is_worked_on() && self.layout().frictions.is_empty()
    }

    /// Whether anything but friction may change T + V between impacts.
    pub(crate) fn is_worked_on(&self) -> bool {
        self.layout().timed || self.layout().loaded || self.scales.damped
    }

    /// What the rounding of the coordinates makes of a gap that is zero, in its own unit: along a
    /// slope the height of a point is a difference of terms as large as it is far.
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

    /// Whether coordinates, given with their places, are so large that their rounding may count
    /// beside `bound`.
    pub(crate) fn is_far<'q>(&self, mut of: impl Iterator<Item = (usize, &'q f64)>, bound: f64) -> bool {
        let layout = self.layout();
        let near = bound / (LEVER * ROUNDINGS * layout.coordinates.len() as f64);
        of.any(|(i, q)| q.abs() > near * self.scales.coordinate(&layout.coordinates[i]))
    }

    /// How far the coordinates are from zero, in natural units and at least one, and the rounding
    /// accumulated over the way that they have come at their rates by the time `t`.
    pub(crate) fn travelled(&self, state: &[f64], t: f64) -> [f64; 2] {
        let (layout, n) = (self.layout(), self.layout().coordinates.len());
        let unit = |i: usize| self.scales.entry(layout, i);
        let far = (0..n).map(|i| state[i].abs() / unit(i)).fold(1.0, f64::max);
        let way = (0..n).map(|i| state[n + i].abs() * t / unit(i)).fold(0.0, f64::max);
        [far, ROUNDINGS * way]
    }

    /// The phase of a contact set, in closed form only if it has one.
    pub(crate) fn phase(&self, set: ContactSet, form: Form) -> Arc<dyn PhaseEquations> {
        Arc::clone(&self.model.system).phase(set, form)
    }

    /// The gaps of all contacts in a state.
    pub(crate) fn gaps(&self, state: &[f64]) -> Numbers {
        let mut gaps: Numbers = smallvec![0.0; self.layout().contacts.len()];
        self.system().gaps(state, &mut gaps);
        gaps
    }

    /// The contacts whose feet are on their bars by no more than a margin in a state, or beyond the
    /// ends of these.
    pub(crate) fn find_beyond_end(&self, state: &[f64], margin: f64) -> ContactSet {
        let mut feet: Numbers = smallvec![0.0; 2 * self.layout().feet()];
        self.system().feet(state, &mut feet);
        let is_beyond = |foot: usize| feet[2 * foot..2 * foot + 2].iter().any(|inside| *inside <= margin);
        let contacts = self.layout().contacts.iter().enumerate();
        contacts.filter(|(_, contact)| contact.foot.is_some_and(is_beyond)).map(|(i, _)| i).collect()
    }

    /// A state in which what is switched acts as in another.
    pub(crate) fn switched_as(&self, state: &[f64], other: &[f64]) -> Numbers {
        let mut switched: Numbers = state.into();
        let switches = self.layout().switch(0);
        switched[switches..].copy_from_slice(&other[switches..]);
        switched
    }
}

/// The reduced state of a phase.
pub(crate) fn reduce(phase: &dyn PhaseEquations, state: &[f64]) -> Numbers {
    let mut reduced: Numbers = smallvec![0.0; phase.info().entries];
    phase.restrict(state, &mut reduced);
    reduced
}

/// Reactions of all contacts, then the friction forces, of the multipliers of all rows.
pub(crate) fn reactions_of(layout: &Layout, multipliers: &[f64]) -> Numbers {
    (0..layout.reactions()).map(|entry| multipliers[layout.row_of_reaction(entry)]).collect()
}
