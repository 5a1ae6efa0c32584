//! A step of a phase: what is evaluated within it.

use std::sync::Arc;

use super::sample::{Quantities, Sample, Scratch};
use crate::context::{Numbers, RunContext};
use crate::expression::{Condition, Enclosure, Interval, SeriesQuantity, Sides, Variable};
use crate::integrate::Guards;
use crate::integration::phase_point::PhasePoint;
use crate::model::{ContactSet, Form};
use crate::numerics::root_isolation::{GuardError, Smooth, TERMS};
use crate::numerics::zero::roundoff;
use crate::system::{DenseOutput, PhaseEquations};
use smallvec::smallvec;

/// What a condition reads, over a step.
pub(super) type Leaves = Vec<(Variable, Smooth)>;

/// A step of a phase, as the guards see it.
pub(crate) struct StepView<'a> {
    pub(super) phase: &'a Arc<dyn PhaseEquations>,
    /// The closed contacts: those of the phase, and those that depend on them.
    pub(super) closed: ContactSet,
    pub(super) context: &'a RunContext,
    pub(super) dense: &'a DenseOutput,
    /// The series of the guards: the method's own, or what the dense output makes of them.
    pub(super) guards: Option<Guards<'a>>,
    /// Whether they are the dense output's: what is known to vanish at the start does so only to
    /// within its error.
    is_fitted: bool,
    /// The entries of the full state that the dense output is a polynomial of; none where it is no
    /// step.
    kept: &'a [usize],
    /// Whether it is a step across a singular position.
    is_bridge: bool,
}

impl<'a> StepView<'a> {
    /// A step known by its dense output only.
    pub(crate) fn new(
        phase: &'a Arc<dyn PhaseEquations>,
        context: &'a RunContext,
        dense: &'a DenseOutput,
    ) -> Self {
        let closed = phase.info().set;
        Self { phase, closed, context, dense, guards: None, is_fitted: false, kept: &[], is_bridge: false }
    }

    /// The same with the contacts closed that depend on those of the phase.
    pub(crate) fn with_closed(self, closed: ContactSet) -> Self {
        Self { closed, ..self }
    }

    /// The same with series of the guards, if there are any.
    pub(crate) fn with_series(self, guards: Option<Guards<'a>>) -> Self {
        Self { guards, kept: self.phase.kept(), ..self }
    }

    /// The same where these are polynomials of the dense output, not the method's own series.
    pub(crate) fn with_fitted(self, is_fitted: bool) -> Self {
        Self { is_fitted, ..self }
    }

    pub(super) fn form(&self) -> Form {
        self.phase.info().form
    }

    pub(super) fn is_fitted(&self) -> bool {
        self.is_fitted
    }

    /// The same across a singular position: it cannot be made shorter, and reactions are not
    /// determined within.
    pub(crate) fn across(self) -> Self {
        Self { is_bridge: true, ..self }
    }

    pub(super) fn is_bridge(&self) -> bool {
        self.is_bridge
    }

    /// The reduced state at θ.
    pub(super) fn reduced(&self, theta: f64, reduced: &mut Numbers) {
        reduced.resize(self.dense.entries(), 0.0);
        self.dense.interpolate(theta, reduced);
    }

    /// Evaluates what is asked for at θ.
    pub(super) fn sample(&self, theta: f64, asked: Quantities, sample: &mut Sample, scratch: &mut Scratch) {
        let Scratch { reduced, state, last_grip, .. } = scratch;
        self.reduced(theta, reduced);
        if asked.contains(Quantities::REACTIONS) {
            self.phase.reactions(reduced, &mut sample.reactions);
        }
        if asked != Quantities::REACTIONS {
            self.phase.embed(reduced, state);
        }
        if asked.contains(Quantities::GAPS) {
            self.phase.system().gaps(state, &mut sample.gaps);
        }
        if asked.contains(Quantities::FEET) {
            self.phase.system().feet(state, &mut sample.feet);
        }
        if asked.contains(Quantities::SLIPS) {
            self.phase.system().slips(state, &mut sample.slips);
        }
        if asked.contains(Quantities::GRIP) {
            sample.grip = last_grip.value(self.context.system(), state, &self.closed, &sample.reactions);
        }
    }

    /// Roundoff of each gap at the end, if a coordinate of the phase has become so large
    /// that it may be more than `bound`.
    pub(super) fn roundings(&self, bound: f64, scratch: &mut Scratch) -> Option<Numbers> {
        let coordinates =
            self.phase.kept().iter().copied().zip(self.dense.end()).take(self.phase.info().coordinates);
        if !self.context.is_far(coordinates, bound) {
            return None;
        }
        self.phase.embed(self.dense.end(), &mut scratch.state);
        Some(self.context.roundings(&scratch.state, bound))
    }

    /// The size of the terms at the end that a gap is the sum of.
    pub(super) fn terms(&self, contact: usize, scratch: &mut Scratch) -> f64 {
        self.phase.embed(self.dense.end(), &mut scratch.state);
        let positions = &scratch.state[..self.context.layout().coordinates.len()];
        self.context.system().equations(&scratch.state).terms(contact, positions)
    }

    /// The difference of a condition's sides at θ, and the larger of them.
    pub(super) fn difference(&self, theta: f64, condition: &Condition, scratch: &mut Scratch) -> (f64, f64) {
        condition.difference(self.context, self.point(theta, scratch))
    }

    /// What rounding may make of the difference of a condition's sides at θ where they are equal;
    /// zero where that is no number.
    pub(super) fn rounding(&self, theta: f64, condition: &Condition, scratch: &mut Scratch) -> f64 {
        let rounding = condition.rounding(self.context, self.point(theta, scratch));
        if rounding.is_finite() { rounding } else { 0.0 }
    }

    fn point<'v>(&self, theta: f64, scratch: &'v mut Scratch) -> &'v PhasePoint {
        let t = self.dense.t0 + theta * self.dense.h;
        let reduced = || smallvec![0.0; self.dense.entries()];
        let begun = || PhasePoint::new(Arc::clone(self.phase), self.closed, t, reduced());
        let point = scratch.point.get_or_insert_with(begun);
        point.move_to(t, |reduced| self.dense.interpolate(theta, reduced));
        point
    }

    /// g̈ of a contact at θ.
    pub(super) fn gap_acceleration(&self, theta: f64, contact: usize, scratch: &mut Scratch) -> f64 {
        let point = self.point(theta, scratch);
        let equations = self.phase.system().equations(point.state());
        equations.gap_acceleration(contact, point.accelerations())
    }

    /// The length of the step in time, and the natural acceleration.
    pub(super) fn scales(&self) -> (f64, f64) {
        (self.dense.h, self.context.scales.acceleration())
    }

    /// What a condition reads, at θ.
    pub(super) fn evaluate_variable(&self, theta: f64, variable: Variable, scratch: &mut Scratch) -> f64 {
        variable.value(self.context, self.point(theta, scratch))
    }

    /// Bounds of the difference of a condition's sides over a piece, from those of what it reads.
    pub(super) fn enclosure(
        &self,
        condition: &Condition,
        leaves: &Leaves,
        piece: [f64; 2],
    ) -> Option<Enclosure> {
        let leaf = |variable: Variable| {
            let (_, smooth) = leaves.iter().find(|(known, _)| *known == variable)?;
            let [value, slope] = [smooth.value(piece), smooth.slope(piece)];
            let around = |(middle, reach)| Interval::around(middle, reach);
            Some(Enclosure { value: around(value), slope: around(slope) })
        };
        condition.enclosure(&self.context.model.parameters, &leaf)
    }

    /// The series of the guards, for a contact that is one of the phase: what is closed because
    /// others are has none.
    pub(super) fn own_guards(&self, contact: usize) -> Option<Guards<'_>> {
        self.guards.filter(|_| self.phase.info().set.contains(contact))
    }

    /// Where the reduced state has a coordinate or its rate, if it has it.
    fn find_index(&self, index: usize, order: usize) -> Option<usize> {
        let entry = index + order * self.context.layout().coordinates.len();
        self.kept.iter().position(|kept| *kept == entry)
    }

    /// What is a polynomial of the step itself; none for what has to be fitted.
    pub(super) fn polynomial(&self, variable: Variable) -> Option<Result<Smooth, GuardError>> {
        let mut terms = [0.0; TERMS];
        match variable {
            Variable::Time => (terms[0], terms[1]) = (self.dense.t0, self.dense.h),
            Variable::Coordinate { index, order } => {
                self.dense.polynomial(self.find_index(index, order)?, &mut terms)?;
            }
            _ => return None,
        }
        let degree = self.dense.degree().max(1);
        let at = |theta: f64| terms[..=degree].iter().rev().fold(0.0, |sum, c| sum * theta + c);
        // Of the sum, whose terms may be larger than it is.
        let rounding = roundoff(4.0) * terms.iter().map(|c| c.abs()).sum::<f64>();
        Some(Smooth::polynomial(&mut |theta| at(theta), degree, rounding))
    }

    /// The series of a condition's sides, if they follow from those of what the method has: the
    /// motion itself is a polynomial.
    pub(super) fn sides(&self, condition: &Condition) -> Option<Sides> {
        condition.sides(&self.context.model.parameters, &|known, terms| match known {
            SeriesQuantity::Coordinate { index, order } => {
                self.dense.polynomial(self.find_index(index, order)?, terms)
            }
            // Where more contacts are closed than the phase needs, they share its reactions.
            SeriesQuantity::Reaction(_) if self.closed != self.phase.info().set => None,
            SeriesQuantity::Reaction(contact) => copy(self.guards?.reaction(contact), terms),
            SeriesQuantity::Gap(contact) => copy(self.guards?.gap(contact), terms),
            SeriesQuantity::Time => {
                (terms[0], terms[1]) = (self.dense.t0, self.dense.h);
                Some(())
            }
        })
    }
}

fn copy(series: &[f64], terms: &mut [f64]) -> Option<()> {
    series.iter().zip(terms).for_each(|(c, term)| *term = *c);
    Some(())
}
