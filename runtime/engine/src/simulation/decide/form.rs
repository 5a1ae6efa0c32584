//! The form that a phase is integrated in, and the state put onto its contacts.

use std::sync::Arc;

use super::Entry;
use crate::contact::{joint_names, labels};
use crate::integration::chart::{self, Chart};
use crate::model::{ContactSet, Form};
use crate::numerics::zero::roundoff;
use crate::simulation::snapshot::Snapshot;
use crate::simulation::{RunCause, Simulation};
use crate::system::PhaseEquations;
use crate::trajectory::LoggedDecision;

impl Snapshot<'_> {
    /// Of closed contacts those that bear, given what a decision says. All do where their closed
    /// form holds: they depend on each other at this position at most, such as those of sin α = sin
    /// β at cos α = 0, and hold the motion that follows together.
    pub(super) fn choose_active_basis(&self, closed: ContactSet, decided: ContactSet) -> ContactSet {
        if decided == closed || self.setup.form == Form::Multipliers {
            return decided;
        }
        self.valid_chart(closed).map_or(decided, |_| closed)
    }

    /// The closed form of a set, if it has one that holds here.
    pub(super) fn valid_chart(&self, set: ContactSet) -> Option<Arc<dyn PhaseEquations>> {
        let Simulation { context, tolerance, .. } = self.setup;
        let (chart, phase) =
            chart::choose_chart(context, set, &self.state, (self.bound_with(set), *tolerance));
        (chart == Chart::Valid).then_some(phase)
    }

    /// The phase of contacts that bear, in the form that holds here. A state that does not satisfy
    /// the closed form was beside the form's own branch, or is on another.
    pub(in crate::simulation) fn enter(
        &self,
        bearing: ContactSet,
        is_given: bool,
    ) -> Result<Entry, RunCause> {
        let (chart, mut phase) = self.chart(bearing, &self.state);
        if chart == Chart::Valid {
            return Ok(Entry { phase, state: None, log: Vec::new() });
        }
        let mut log = Vec::new();
        if chart == Chart::SmallPivot {
            log.push(LoggedDecision::SmallPivot);
        }
        let (state, by) = self.project(bearing, self.rounding_of_the_way(), is_given)?;
        if is_given && by > self.bound_with(bearing) {
            log.push(LoggedDecision::StartMoves(by));
        }
        if chart == Chart::OtherBranch {
            let (chart, there) = self.chart(bearing, &state);
            phase = there;
            if chart != Chart::Valid {
                log.push(LoggedDecision::OtherBranch);
            }
        }
        Ok(Entry { phase, state: Some(state), log })
    }

    fn chart(&self, bearing: ContactSet, state: &[f64]) -> (Chart, Arc<dyn PhaseEquations>) {
        let Simulation { context, form, tolerance, .. } = self.setup;
        if *form == Form::Multipliers {
            return (Chart::Absent, context.phase(bearing, *form));
        }
        chart::choose_chart(context, bearing, state, (self.bound_with(bearing), *tolerance))
    }

    /// The state projected onto the contacts of a set, and how far that moves it, in natural units.
    /// A correction larger than the errors that positions cause in rates and than accumulated
    /// rounding would be a jump, which is an error.
    pub(in crate::simulation) fn project(
        &self,
        set: ContactSet,
        rounding: f64,
        is_given: bool,
    ) -> Result<(Vec<f64>, f64), RunCause> {
        let (context, layout) = (&self.setup.context, self.layout());
        let mut restored = self.state.clone();
        if !(0..layout.rows()).any(|row| layout.is_closed(row, &set)) {
            return Ok((restored, 0.0));
        }
        context.system().project(set, &mut restored, context.scales.length);
        let [positions, rates] = chart::apart(context, &self.state, &restored);
        let by = positions.max(rates);
        if by > self.bound_with(set).sqrt() + rounding {
            let contacts = if set.is_empty() { joint_names(layout) } else { labels(layout, set) };
            return Err(RunCause::Jump { t: self.t, contacts, by });
        }
        // Not a number where the equations are singular, which the phase tells.
        if (positions + rates).is_nan() {
            return Ok((self.state.clone(), 0.0));
        }
        if !is_given {
            self.lower_energy(&mut restored);
        }
        Ok((restored, by))
    }

    /// Takes from the rates what a shift of the position has added to the energy: many small shifts
    /// would keep a motion going that has lost its energy in impacts. Rates of contacts that stay
    /// closed are homogeneous unless they are driven.
    fn lower_energy(&self, shifted: &mut [f64]) {
        let (system, n) = (self.setup.context.system(), self.layout().coordinates.len());
        if self.layout().timed {
            return;
        }
        let [before, after] = [system.energy(&self.state), system.energy(shifted)];
        let gain = after.gained_since(&before);
        let size = after.kinetic + after.potential.abs().max(before.potential.abs());
        if gain > roundoff(16.0) * size && after.kinetic > 0.0 {
            let factor = (1.0 - gain / after.kinetic).max(0.0).sqrt();
            shifted[n..2 * n].iter_mut().for_each(|rate| *rate *= factor);
        }
    }
}
