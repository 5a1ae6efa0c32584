//! Which contacts are closed from now on, how they slip, and the phase that follows. Nothing is
//! changed by it.

mod dependent;
mod form;
mod slips;

#[cfg(test)]
mod tests;

pub(crate) use slips::LocatedSlips;

use std::sync::Arc;

use crate::contact::{
    Alternatives, ContactError, ContactProblem, ContactSolution, StationaryGaps, labels, nondegenerate,
};
use crate::context::CLOSED;
use crate::model::ContactSet;
use crate::simulation::RunCause;
use crate::simulation::snapshot::Snapshot;
use crate::system::PhaseEquations;
use crate::trajectory::LoggedDecision;
use slips::reason_name;

/// What is known before a decision.
#[derive(Debug, Clone)]
pub(crate) struct DecisionInput {
    /// Contacts that may be closed.
    pub(super) touching: ContactSet,
    /// Of these, those with friction whose slips are those of the phase before.
    pub(super) slip_known: ContactSet,
    /// Contacts whose reaction is zero.
    pub(super) unloaded: ContactSet,
    pub(super) located: LocatedSlips,
    /// Whether the state is the one that was given: its rates are kept, whatever the shift onto its
    /// contacts.
    pub(super) is_given: bool,
}

impl DecisionInput {
    /// About contacts of whose slips only the velocities are known.
    pub(super) fn about(touching: ContactSet) -> Self {
        Self {
            touching,
            slip_known: ContactSet::EMPTY,
            unloaded: ContactSet::EMPTY,
            located: LocatedSlips::default(),
            is_given: false,
        }
    }
}

/// What follows.
pub(crate) struct Decision {
    closed: ContactSet,
    reactions: Vec<f64>,
    entry: Entry,
    log: Vec<LoggedDecision>,
}

/// How a phase is entered.
pub(crate) struct Entry {
    phase: Arc<dyn PhaseEquations>,
    /// The state where it had to be put onto the contacts of the phase.
    state: Option<Vec<f64>>,
    log: Vec<LoggedDecision>,
}

/// Why there is no decision.
pub(crate) enum Refusal {
    /// Of these contacts no motion is known that obeys all laws.
    Contacts(Box<Unsolved>),
    /// The run cannot go on.
    Run(RunCause),
}

/// Contacts that may be closed, and why nothing is known of them.
pub(crate) struct Unsolved {
    pub(super) touching: ContactSet,
    pub(super) source: ContactError,
}

impl From<RunCause> for Refusal {
    fn from(cause: RunCause) -> Self {
        Self::Run(cause)
    }
}

impl Snapshot<'_> {
    /// What to ask where nothing has changed but what is said.
    pub(super) fn question(&self) -> DecisionInput {
        DecisionInput { slip_known: self.closed(), ..DecisionInput::about(self.closed()) }
    }

    /// The closed contacts from now on and how those with friction slip.
    pub(super) fn decide(&self, question: &DecisionInput) -> Result<Decision, Refusal> {
        let touching = question.touching.difference(self.find_parted()).union(self.contacts.guides());
        let stationary = self.find_stationary_gaps(touching);
        let question = &DecisionInput { touching: touching.difference(stationary.least), ..question.clone() };
        let (touching, greatest) = (question.touching, stationary.greatest());
        let mut decided = self.solve(question, touching.difference(greatest));
        if let (Ok(free), false) = (&decided, greatest.is_empty()) {
            self.refuse_jam(&stationary, free.active_basis)?;
            decided = self.solve(question, touching.difference(stationary.flat));
        }
        match decided {
            Ok(decided) => self.enter_decided(decided, stationary.flat, question.is_given),
            Err(source) => match self.located_otherwise(question, &source) {
                Some(located) => self.decide(&DecisionInput { located, ..question.clone() }),
                None => Err(Refusal::Contacts(Box::new(Unsolved { touching, source }))),
            },
        }
    }

    /// The contact problem with some of the contacts in question.
    fn solve(&self, question: &DecisionInput, touching: ContactSet) -> Result<ContactSolution, ContactError> {
        let (context, held) = (&self.setup.context, self.contacts.held());
        let problem = ContactProblem {
            touching,
            held,
            unloaded: question.unloaded,
            most_trials: Some(self.setup.budget.trials),
            slips: &self.known_slips(question),
            time: Some(context.scales.time),
        };
        let reduced = problem.slips.is_empty().then(|| self.valid_chart(touching.union(held))).flatten();
        (self.setup.parts.laws.decide)(context, &self.state, &problem, reduced.as_deref())
    }

    /// What else may be taken for located where the contacts jam: what was at its limit need not be
    /// what slips, and at a start nothing has been located.
    fn located_otherwise(&self, question: &DecisionInput, source: &ContactError) -> Option<LocatedSlips> {
        let jams = matches!(source, ContactError::Jammed { .. });
        let located = &question.located;
        if located.is_leaving() && (jams || matches!(source, ContactError::Hinges { .. })) {
            return Some(located.at_rest());
        }
        let at_limits = (jams && located.is_empty()).then(|| self.at_static_limits(question.touching));
        at_limits.filter(LocatedSlips::is_leaving)
    }

    /// The phase of the contacts that have been decided to be closed, those of flat gaps too.
    fn enter_decided(
        &self,
        decided: ContactSolution,
        flat: ContactSet,
        is_given: bool,
    ) -> Result<Decision, Refusal> {
        let ContactSolution { closed, active_basis: bearing, reactions, unique, alternatives } = decided;
        let closed = closed.union(flat);
        let mut log = alternatives.map_or_else(Vec::new, log_alternatives);
        log.extend((!unique).then_some(LoggedDecision::ReactionsNotUnique));
        let entry = self.enter(self.choose_active_basis(closed, bearing), is_given)?;
        Ok(Decision { closed, reactions, entry, log })
    }

    /// Contacts that did depend on those that bear and have come off: their gaps were zero only
    /// where the phase began.
    fn find_parted(&self) -> ContactSet {
        let dependent = self.closed().difference(self.active_basis());
        if dependent.is_empty() {
            return ContactSet::EMPTY;
        }
        let equations = self.setup.context.system().equations(&self.state);
        let (layout, length) = (self.layout(), self.setup.context.scales.length);
        let bound = |i: usize| self.relative_bound() * layout.unit(i, length);
        let dependent = dependent.difference(self.layout().drives());
        dependent.iter().filter(|&i| equations.gap()[i] > bound(i)).collect()
    }

    /// Those of touching contacts that may open whose gaps are stationary here.
    pub(in crate::simulation) fn find_stationary_gaps(&self, touching: ContactSet) -> StationaryGaps {
        let drives = touching.intersection(self.layout().drives());
        let held = self.contacts.held().union(self.contacts.guides()).union(drives);
        let touching = touching.difference(held);
        let problem = ContactProblem { touching, held, ..ContactProblem::default() };
        StationaryGaps::find(&self.setup.context, &self.state, &problem, CLOSED)
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

    /// Goes on as decided.
    pub(super) fn adopt(&mut self, decision: Decision) {
        let Decision { closed, reactions, entry, log } = decision;
        self.contacts.decide(closed);
        self.reactions = reactions;
        log.into_iter().for_each(|decision| self.log(decision));
        self.adopt_entry(entry);
    }

    /// Enters the phase that follows.
    pub(super) fn adopt_entry(&mut self, entry: Entry) {
        let Entry { phase, state, log } = entry;
        self.phase = phase;
        if let Some(state) = state {
            self.state = state;
        }
        log.into_iter().for_each(|decision| self.log(decision));
    }
}

/// What of the motions that the law of friction allows was taken.
fn log_alternatives(found: Alternatives) -> Vec<LoggedDecision> {
    let Alternatives { motions, taken, reason, complete, determined } = found;
    let several = motions.len() > 1;
    let why = reason_name(reason);
    [
        (!complete).then_some(LoggedDecision::MotionsNotCounted),
        (!determined).then_some(LoggedDecision::MotionNotDetermined),
        several.then_some(LoggedDecision::SeveralMotions { motions, taken, why }),
    ]
    .into_iter()
    .flatten()
    .collect()
}
