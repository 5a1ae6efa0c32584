//! A run at one moment: what decisions are made on, and what responses to events change.

mod contacts;
mod domain;
mod flights;
mod forces;
mod gate;
mod slips;
mod tiny;
mod transition;

#[cfg(test)]
mod tests;

pub(crate) use contacts::Contacts;
pub(crate) use flights::{Bounces, PendingFlight, Sequence, ZenoClosure};
pub(crate) use transition::{TransitionRecord, split};

use std::cell::RefCell;
use std::sync::Arc;

use smallvec::smallvec;

use crate::assembly::{ConsistentStart, StartError};
use crate::contact::ContactError;
use crate::context::{Numbers, reactions_of};
use crate::expression::Switched;
use crate::integration::phase_point::PhasePoint;
use crate::model::{ContactSet, Energy, Form, Layout};
use crate::simulation::awaited::{Awaited, Role};
use crate::simulation::schedule::Trigger;
use crate::simulation::{Exhausted, RunCause, Simulation};
use crate::system::PhaseEquations;
use crate::trajectory::RecordedPhase;
use tiny::ZeroBounds;

/// A run at one moment.
pub(crate) struct Snapshot<'a> {
    pub(super) setup: &'a Simulation,
    pub(super) awaited: &'a Awaited,
    pub(super) t: f64,
    pub(super) state: Vec<f64>,
    pub(super) contacts: Contacts,
    /// The phase that follows. The contacts of its set bear: independent ones, which hold the other
    /// closed ones too.
    pub(super) phase: Arc<dyn PhaseEquations>,
    /// Reactions at the last decision, or at the end of the phase since.
    pub(super) reactions: Vec<f64>,
    pub(super) onset: Onset,
    /// Which entries of the plan have happened.
    pub(super) done: Vec<bool>,
    pub(super) bounces: Bounces,
    /// What has happened since the driver last took note.
    pub(super) transition: TransitionRecord,
    memory: RefCell<Memory>,
}

/// What is known of the phase that follows, until it begins.
#[derive(Default)]
pub(crate) struct Onset {
    /// Contacts that have just opened with their reaction at zero.
    pub(super) opened_at_zero_reaction: ContactSet,
    /// Contacts whose reaction or slip velocity has been located at zero, or whose friction force
    /// at its limit, and that the decision has kept as they were.
    pub(super) suppressed: ContactSet,
    /// Contacts that rise where these bear.
    pub(super) risen: Option<(ContactSet, Vec<PendingFlight>)>,
    /// Whether an impulse has acted since the phase before.
    pub(super) is_struck: bool,
}

/// What a phase begins with.
pub(crate) struct PhaseStart {
    pub(super) state: Vec<f64>,
    pub(super) energy: Energy<f64>,
}

/// What has been computed for a state, which is often asked for again.
#[derive(Default)]
struct Memory {
    tiny: ZeroBounds,
    accelerations: Option<(Numbers, ContactSet, Numbers)>,
}

impl<'a> Snapshot<'a> {
    /// The start of a run, before anything is decided.
    pub(crate) fn new(setup: &'a Simulation, awaited: &'a Awaited, start: ConsistentStart) -> Self {
        let layout = setup.layout();
        let absent = setup.rules.switches.disarmed(&setup.context, &start.state, setup.begin);
        let mut snapshot = Self {
            setup,
            awaited,
            t: setup.begin,
            state: start.state,
            contacts: Contacts::new(layout, start.touching, setup.held, absent),
            phase: setup.context.phase(ContactSet::EMPTY, Form::Multipliers),
            reactions: vec![0.0; layout.reactions()],
            onset: Onset::default(),
            done: vec![false; setup.plan.len()],
            bounces: Bounces::new(layout.contacts.len()),
            transition: TransitionRecord::default(),
            memory: RefCell::default(),
        };
        let below = snapshot.find_below(layout.edges());
        snapshot.contacts.set_below(below);
        snapshot.log_depth(start.depth);
        snapshot
    }

    pub(super) fn layout(&self) -> &'static Layout {
        self.setup.layout()
    }

    /// Closed contacts, and how they slip.
    pub(super) fn closed(&self) -> ContactSet {
        self.contacts.closed()
    }

    /// The independent ones among them, which are integrated and watched.
    pub(super) fn active_basis(&self) -> ContactSet {
        self.phase.info().set
    }

    pub(super) fn rates(&self) -> &[f64] {
        &self.state[self.setup.context.rates()]
    }

    /// Coordinates and rates as users see them.
    pub(super) fn public_state(&self) -> &[f64] {
        self.layout().public_state(&self.state)
    }

    /// The motion as it is, for conditions to be evaluated at.
    pub(super) fn point(&self) -> PhasePoint {
        let phase = self.setup.context.phase(self.active_basis(), Form::Multipliers);
        RecordedPhase::still((phase, self.closed()), self.t, &self.state).interpolate(self.t)
    }

    pub(super) fn gaps(&self) -> Numbers {
        self.setup.context.gaps(&self.state)
    }

    /// Reactions of contacts with all of a set closed, and what counts as zero.
    pub(super) fn reactions_at(&self, state: &[f64], touching: ContactSet) -> (Vec<f64>, f64) {
        let (context, layout) = (&self.setup.context, self.layout());
        let (mut a, mut multipliers) = (vec![0.0; layout.coordinates.len()], vec![0.0; layout.rows()]);
        context.system().solve(state, touching, &mut a, &mut multipliers);
        let reactions = reactions_of(layout, &multipliers).to_vec();
        let largest = reactions.iter().map(|reaction| reaction.abs()).fold(context.scales.force(), f64::max);
        (reactions, self.relative_bound() * largest)
    }

    /// Accelerations with a set of contacts closed.
    pub(super) fn accelerations(&self, state: &[f64], set: ContactSet) -> Numbers {
        let known = &mut self.memory.borrow_mut().accelerations;
        if let Some((at, with, a)) = &*known
            && (&at[..], *with) == (state, set)
        {
            return Numbers::from_slice(a);
        }
        let mut a: Numbers = smallvec![0.0; self.layout().coordinates.len()];
        let mut multipliers: Numbers = smallvec![0.0; self.layout().rows()];
        self.setup.context.system().solve(state, set, &mut a, &mut multipliers);
        *known = Some((Numbers::from_slice(state), set, Numbers::from_slice(&a)));
        a
    }

    /// Open contacts whose foot is at the end of its bar or beyond.
    pub(super) fn find_beyond_end(&self) -> ContactSet {
        if self.layout().edges().difference(self.closed()).is_empty() {
            return ContactSet::EMPTY;
        }
        let context = &self.setup.context;
        let bound = self.relative_bound() * context.scales.length;
        context.find_beyond_end(&self.state, bound).difference(self.closed())
    }

    /// Contacts of a set that lie below their grounds.
    pub(super) fn find_below(&self, set: ContactSet) -> ContactSet {
        let (gaps, bound) = (self.gaps(), self.gap_bounds());
        set.iter().filter(|&i| gaps[i] < -bound(i)).collect()
    }

    pub(super) fn restitution(&self, contact: usize) -> f64 {
        self.setup.restitution.get(contact).copied().unwrap_or(0.0)
    }

    /// What the phase that follows begins with.
    pub(super) fn phase_start(&self) -> PhaseStart {
        PhaseStart { state: self.state.clone(), energy: self.energy() }
    }

    /// Rounding accumulated over the distance that the coordinates have travelled at their rates.
    pub(super) fn rounding_of_the_way(&self) -> f64 {
        self.setup.context.travelled(&self.state, self.t)[1]
    }

    /// Times at which something is still to happen, that of the end among them.
    pub(super) fn next_time(&self) -> f64 {
        let plan = self.setup.plan.iter().zip(&self.done);
        let planned = plan.filter_map(|(planned, done)| match planned.when {
            Trigger::At(at) if !done => Some(at),
            _ => None,
        });
        let settling = self.bounces.settling.iter().map(|settling| settling.end);
        let times = self.setup.stops().chain(planned).chain(settling);
        times.filter(|t| *t >= self.t).fold(self.setup.time_limit(), f64::min)
    }

    /// Whether a condition is still to be met.
    pub(super) fn is_awaited(&self, condition: usize) -> bool {
        match self.awaited.role(condition) {
            Role::Stop => true,
            Role::Planned(entry) => !self.done[entry],
            Role::Switch { switch, arms } => self.is_there(switch) != arms,
            Role::Domain(domain) => self.is_bound(domain),
        }
    }

    /// Whether what a switch has is there.
    fn is_there(&self, switch: usize) -> bool {
        match self.setup.rules.switches[switch].switched {
            Switched::Contact(i) => !self.contacts.absent().contains(i),
            Switched::Loads(i) => self.state[self.layout().switch(i)] != 0.0,
        }
    }

    pub(super) fn exhausted(&self, of: Exhausted) -> RunCause {
        RunCause::Budget { t: self.t, of }
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
}
