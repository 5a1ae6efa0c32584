//! The phase that follows, and its integration.

use std::sync::Arc;

use super::Driver;
use super::friction::LocatedSlips;
use crate::assembly::StartError;
use crate::contact::friction::Grip;
use crate::contact::nondegenerate::slider;
use crate::contact::{
    ContactError, ContactProblem, ContactSolution, StationaryGaps, decide, hinges, joint_names, labels,
    nondegenerate,
};
use crate::context::{CLOSED, Numbers};
use crate::event::detection::{Bounds, ContactStatus, EventDetector, Signals};
use crate::integration::chart::{self, Chart};
use crate::model::{ContactSet, Form};
use crate::simulation::RunCause;
use crate::simulation::awaited::Role;
use crate::simulation::phase_run::{Outcome, PhaseRun};
use crate::simulation::{Exhausted, Simulation};
use crate::system::{Equations, Phase};
use crate::trajectory::{LoggedDecision, Work};
use smallvec::smallvec;

/// A change of the energy by this part of its terms is rounding.
const ROUNDED: f64 = 16.0 * f64::EPSILON;

impl Driver<'_> {
    /// The closed contacts from now on, given those whose reaction is zero.
    pub(super) fn decide(&mut self, unloaded: ContactSet) -> Result<(), RunCause> {
        self.decide_slips(unloaded, &LocatedSlips::default())
    }

    /// The same, and how those with friction slip, given what has been located of them.
    pub(super) fn decide_slips(
        &mut self,
        unloaded: ContactSet,
        located: &LocatedSlips,
    ) -> Result<(), RunCause> {
        self.touching = self.touching.difference(self.parted()).union(self.guides());
        let held = self.held.difference(self.removed);
        let stationary = self.stationary_gaps(held);
        self.touching = self.touching.difference(stationary.least);
        let most_trials = Some(self.setup.budget.trials);
        let slips = &self.known_slips(located)[..];
        let context = &self.setup.context;
        let time = Some(context.scales.time);
        let ask = |touching: ContactSet| {
            let question = ContactProblem { touching, held, unloaded, most_trials, slips, time };
            let searched = || decide(&context.model, &self.state, &question);
            match (self.layout().has_hinges(), slips.is_empty()) {
                (true, _) => hinges::decide(context, &self.state, &question),
                (false, true) => {
                    let reduced = self.valid_chart(touching.union(held));
                    nondegenerate::decide(context, &self.state, &question, reduced.as_deref())
                        .map_or_else(searched, Ok)
                }
                (false, false) => slider::decide(context, &self.state, &question).map_or_else(searched, Ok),
            }
        };
        let greatest = stationary.greatest();
        let mut decided = ask(self.touching.difference(greatest));
        if let (Ok(free), false) = (&decided, greatest.is_empty()) {
            self.refuse_jam(&stationary, free.bearing)?;
            decided = ask(self.touching.difference(stationary.flat));
        }
        let decided = match decided {
            Ok(decided) => decided,
            // What was located at its limit need not be what slips.
            Err(ContactError::Jammed { .. } | ContactError::Hinges { .. }) if located.is_leaving() => {
                return self.decide_slips(unloaded, &located.at_rest());
            }
            Err(source @ ContactError::Jammed { .. }) if located.is_empty() => {
                let at_limits = self.at_static_limits();
                let leaves = at_limits.is_leaving();
                return if leaves { self.decide_slips(unloaded, &at_limits) } else { self.unjam(source) };
            }
            Err(source) => return self.unjam(source),
        };
        let ContactSolution { closed, bearing, reactions, unique, alternatives } = decided;
        let closed = closed.union(stationary.flat);
        self.log_alternatives(alternatives);
        if !unique {
            self.log(LoggedDecision::ReactionsNotUnique);
        }
        (self.closed, self.bearing, self.touching, self.reactions) = (closed, bearing, closed, reactions);
        self.sensed = closed;
        self.bearing = self.bearing_from_here();
        self.choose_form()
    }

    /// The contacts that are closed always, unless they have been taken away.
    pub(super) fn guides(&self) -> ContactSet {
        self.layout().guides().difference(self.removed)
    }

    /// All closed contacts where their closed form holds: they depend on each other at this position at most, such as those of
    /// sin α = sin β at cos α = 0, and hold the motion that follows together.
    fn bearing_from_here(&self) -> ContactSet {
        if self.bearing == self.closed || self.setup.form == Form::Projected {
            return self.bearing;
        }
        self.valid_chart(self.closed).map_or(self.bearing, |_| self.closed)
    }

    /// The closed form of a set, if it has one that holds here.
    fn valid_chart(&self, set: ContactSet) -> Option<Arc<dyn Phase>> {
        let Simulation { context, tolerance, .. } = self.setup;
        let (chart, phase) = chart::at(context, set, &self.state, (self.relative_bound(), *tolerance));
        (chart == Chart::Valid).then_some(phase)
    }

    /// Contacts that did depend on those that bear and have come off: their gaps were zero only where the phase began.
    fn parted(&self) -> ContactSet {
        let dependent = self.closed.difference(self.bearing);
        if dependent.is_empty() {
            return ContactSet::EMPTY;
        }
        let equations = self.setup.context.system().equations(&self.state);
        let bound = self.relative_bound() * self.setup.context.scales.length;
        let dependent = dependent.difference(self.layout().drives());
        dependent.iter().filter(|&i| equations.gap()[i] > bound).collect()
    }

    /// Contacts that may open whose gaps are stationary here.
    fn stationary_gaps(&self, held: ContactSet) -> StationaryGaps {
        let drives = self.touching.intersection(self.layout().drives());
        let held = held.union(self.guides()).union(drives);
        let touching = self.touching.difference(held);
        let question = ContactProblem { touching, held, ..ContactProblem::default() };
        StationaryGaps::find(&self.setup.context, &self.state, &question, CLOSED)
    }

    /// Refuses a motion against contacts that only infinite reactions would hold.
    fn refuse_jam(&self, stationary: &StationaryGaps, bearing: ContactSet) -> Result<(), RunCause> {
        let context = &self.setup.context;
        let Some((accelerations, _)) = nondegenerate::solve(context, &self.state, bearing) else {
            return Ok(());
        };
        match stationary.find_jammed(context, &self.state, &accelerations) {
            jammed if jammed.is_empty() => Ok(()),
            jammed => {
                let contacts = labels(self.layout(), jammed);
                Err(self.contact_error(ContactError::Jammed { contacts }))
            }
        }
    }

    pub(super) fn contact_error(&self, source: ContactError) -> RunCause {
        match self.t {
            _ if matches!(source, ContactError::Undecided { .. }) => {
                self.exhausted(Exhausted::Trials(self.setup.budget.trials))
            }
            t if t == self.setup.begin => RunCause::Start(StartError::Contact(source)),
            t => RunCause::Contact { t, source },
        }
    }

    pub(super) fn choose_form(&mut self) -> Result<(), RunCause> {
        let (chart, phase) = self.chart();
        (self.form, self.phase) = (chart.form(), Some(phase));
        match chart {
            Chart::Valid => return Ok(()),
            Chart::SmallPivot => self.log(LoggedDecision::SmallPivot),
            Chart::OtherBranch => return self.leave_branch(),
            Chart::Absent => {}
        }
        self.restore(self.bearing, self.rounding_of_the_way())
    }

    /// Puts a state onto its contacts that does not satisfy their closed form. It was beside the form's own branch, or is on another.
    fn leave_branch(&mut self) -> Result<(), RunCause> {
        self.restore(self.bearing, self.rounding_of_the_way())?;
        let (chart, phase) = self.chart();
        (self.form, self.phase) = (chart.form(), Some(phase));
        if chart != Chart::Valid {
            self.log(LoggedDecision::OtherBranch);
        }
        Ok(())
    }

    fn chart(&self) -> (Chart, Arc<dyn Phase>) {
        let Simulation { context, form, tolerance, .. } = self.setup;
        if *form == Form::Projected {
            return (Chart::Absent, context.phase(self.bearing, *form));
        }
        chart::at(context, self.bearing, &self.state, (self.relative_bound(), *tolerance))
    }

    /// Projects the state onto the contacts of a set. A correction larger than the errors that positions cause in rates and
    /// than accumulated rounding would be a jump, which is an error.
    pub(super) fn restore(&mut self, set: ContactSet, rounding: f64) -> Result<(), RunCause> {
        let (context, layout) = (&self.setup.context, self.layout());
        if !(0..layout.rows()).any(|row| layout.is_closed(row, &set)) {
            return Ok(());
        }
        let mut restored = self.state.clone();
        context.system().project(set, &mut restored, context.scales.length);
        let [positions, rates] = chart::apart(context, &self.state, &restored);
        let by = positions.max(rates);
        if by > self.relative_bound().sqrt() + rounding {
            let contacts = if set.is_empty() { joint_names(layout) } else { labels(layout, set) };
            return Err(RunCause::Jump { t: self.t, contacts, by });
        }
        // Not a number where the equations are singular, which the phase tells.
        if !(positions + rates).is_nan() {
            if !self.is_start() {
                self.lower_energy(&mut restored);
            } else if by > self.relative_bound() {
                self.log(LoggedDecision::StartMoves(by));
            }
            self.state = restored;
        }
        Ok(())
    }

    /// Whether the state is the one that was given: its rates are kept, whatever the shift onto its contacts.
    fn is_start(&self) -> bool {
        self.trajectory.events.is_empty()
    }

    /// Takes from the rates what a shift of the position has added to the energy: many small shifts would keep a motion going
    /// that has lost its energy in impacts. Rates of contacts that stay closed are homogeneous unless they are driven.
    fn lower_energy(&self, shifted: &mut [f64]) {
        let (system, n) = (self.setup.context.system(), self.layout().coordinates.len());
        if self.layout().timed {
            return;
        }
        let [before, after] = [system.energy(&self.state), system.energy(shifted)];
        let gain = after.gained_since(&before);
        let size = after.kinetic + after.potential.abs().max(before.potential.abs());
        if gain > ROUNDED * size && after.kinetic > 0.0 {
            let factor = (1.0 - gain / after.kinetic).max(0.0).sqrt();
            shifted[n..2 * n].iter_mut().for_each(|rate| *rate *= factor);
        }
    }

    /// Rounding accumulated over the distance that the coordinates have travelled at their rates.
    pub(super) fn rounding_of_the_way(&self) -> f64 {
        self.setup.context.travelled(&self.state, self.t)[1]
    }

    pub(super) fn advance(&mut self) -> Outcome {
        self.integrate(false)
    }

    /// The phase that follows, without a trace of it.
    pub(super) fn try_phase(&mut self) -> Outcome {
        let (kept, lifted, phase) = (self.kept, self.lifted, self.phase.clone());
        let outcome = self.integrate(true);
        (self.kept, self.lifted, self.phase) = (kept, lifted, phase);
        outcome
    }

    /// Integrates the phase that has been decided on; before no observer, if that is a trial.
    fn integrate(&mut self, is_trial: bool) -> Outcome {
        let Simulation { context, tolerance, method, .. } = self.setup;
        let mut nobody = ();
        let bounds = Bounds { relative: self.relative_bound(), length: context.scales.length };
        let slips = &self.natural_slips()[..];
        let forces = &self.forces();
        let orders = &self.liftoff_orders();
        let (off, heights) = (self.beyond_end(), &self.low_flights());
        self.sunk = off.intersection(self.setup.rules.switches.contacts());
        let (closed, held, removed, passed) = (self.closed, self.held, self.removed, self.passed);
        let kept = core::mem::replace(&mut self.kept, ContactSet::EMPTY);
        let grip = Grip::of(context.system(), &self.state, &closed);
        let contacts =
            ContactStatus { closed, held, removed, off, passed, kept, grip, heights, orders, forces, slips };
        let located = |k: &usize| {
            self.awaited.conditions[*k].time(&context.model.parameters).is_none() && self.is_awaited(*k)
        };
        let located = self.awaited.places().filter(located);
        let located: Vec<(usize, bool)> =
            located.map(|k| (k, matches!(self.awaited.role(k), Role::Switch { .. }))).collect();
        let conditions = (&self.awaited.conditions[..], &located[..]);
        let mut detector = EventDetector::new(self.layout(), self.bearing, contacts, conditions, bounds);
        let run = PhaseRun {
            context,
            phase: self.phase.take().unwrap_or_else(|| context.phase(self.bearing, self.form)),
            closed: self.closed,
            detector: &mut detector,
            signals: Signals::new(self.layout(), &self.setup.rules.signals, &context.model.parameters),
            tolerance: *tolerance,
            t: self.t,
            horizon: self.horizon(),
            state: self.state.clone(),
            unresolved: 0,
            work: Work::default(),
            log: Vec::new(),
            is_unseen: false,
            bridged: false,
            reduced: Numbers::new(),
            observer: if is_trial { &mut nobody } else { &mut *self.observer },
            affine: Some(&mut self.affine),
            cancel: self.setup.cancel.as_deref(),
            allowance: self.allowance,
        };
        run.run(&**method)
    }

    /// The size of the reaction of each closed contact: what it is now, or what gives its contact's own mass 1/Wᵢᵢ the natural
    /// acceleration, or that of the motion where it is faster by now; of one that slides no more than what has a natural force of
    /// friction, however large μ is. That of an open one is zero.
    fn forces(&self) -> Numbers {
        let mut forces: Numbers = smallvec![0.0; self.layout().contacts.len()];
        if self.closed.is_empty() {
            return forces;
        }
        let context = &self.setup.context;
        let equations = context.system().equations(&self.state);
        let scales = context.scales.moving_at(self.layout(), &self.state[context.rates()]);
        for contact in self.closed.iter() {
            let mu = self.sliding_friction(contact);
            let own = scales.acceleration() * self.effective_mass(&equations, contact, mu);
            let usual = scales.force() / (1.0 + mu);
            let is_own = own.is_finite() && !self.layout().contacts[contact].is_hinge();
            forces[contact] = self.reactions[contact].abs().max(if is_own { own.min(usual) } else { usual });
        }
        forces
    }

    /// The mass that the reaction of a contact moves by itself: `1/W_NN = dᵀ M d` of the least d with `J_N d = −1`, and where it slides
    /// `1/(W_NN − σ μ W_Nt)` with `W_Nt = −W_NN J_t d`.
    fn effective_mass(&self, equations: &Equations<f64>, contact: usize, mu: f64) -> f64 {
        let mut residual: Numbers = smallvec![0.0; self.layout().rows()];
        residual[contact] = 1.0;
        let mut d: Numbers = smallvec![0.0; self.layout().coordinates.len()];
        let set = ContactSet::EMPTY.with(contact);
        self.setup.context.system().correction(&self.state, set, &residual, &mut d);
        let along = |i: usize| equations.mass(i).iter().zip(&d).map(|(m, d)| m * d).sum::<f64>();
        let alone: f64 = (0..d.len()).map(|i| d[i] * along(i)).sum();
        let slides = self.layout().contacts[contact].friction.filter(|_| mu != 0.0);
        let bent = slides.map_or(1.0, |entry| {
            let tangent = equations.jacobian(self.layout().frictions[entry].row);
            let along_slip: f64 = tangent.iter().zip(&d).map(|(j, d)| j * d).sum();
            1.0 + self.closed.sense(contact) as f64 * mu * along_slip
        });
        alone / bent.abs()
    }

    /// μ of a contact that slides, else zero.
    fn sliding_friction(&self, contact: usize) -> f64 {
        let friction = self.layout().contacts[contact].friction.filter(|_| self.closed.sense(contact) != 0);
        friction.map_or(0.0, |entry| self.slip_states()[entry].kinetic)
    }

    /// Whether all events have happened that the run was to wait for.
    pub(super) fn has_seen_enough(&self) -> bool {
        let (awaited, events) = (&self.setup.event_filters, &self.trajectory.events);
        !awaited.is_empty() && awaited.iter().all(|awaited| events.iter().any(|event| awaited.is(event)))
    }

    /// The time up to which the next phase is integrated at most: now, if all awaited events have happened; else the next
    /// planned time, or the limit.
    pub(super) fn horizon(&self) -> f64 {
        if self.has_seen_enough() {
            return self.t;
        }
        let settling = self.settling.iter().map(|settling| settling.end);
        let times = self.setup.stops().chain(self.planned_times()).chain(settling);
        times.filter(|t| *t >= self.t).fold(self.setup.time_limit(), f64::min)
    }

    pub(super) fn is_held(&self, contact: usize) -> bool {
        self.held.contains(contact) && !self.removed.contains(contact)
    }

    /// Open contacts whose foot is at the end of its bar or beyond.
    pub(super) fn beyond_end(&self) -> ContactSet {
        let context = &self.setup.context;
        let contacts = self.layout().contacts.iter().enumerate();
        let mut open = contacts
            .filter_map(|(i, contact)| Some((i, contact.foot?)))
            .filter(|(i, _)| !self.closed.contains(*i))
            .peekable();
        if open.peek().is_none() && self.setup.rules.switches.is_empty() {
            return ContactSet::EMPTY;
        }
        let mut feet: Numbers = smallvec![0.0; 2 * self.layout().feet()];
        context.system().feet(&self.state, &mut feet);
        let bound = self.relative_bound() * context.scales.length;
        let is_off = |(_, k): &(usize, usize)| feet[2 * k..2 * k + 2].iter().any(|margin| *margin <= bound);
        let off: ContactSet = open.filter(is_off).map(|(i, _)| i).collect();
        if self.setup.rules.switches.is_empty() {
            return off;
        }
        off.union(self.sunk(&self.gaps(), self.gap_bounds()))
    }
}
