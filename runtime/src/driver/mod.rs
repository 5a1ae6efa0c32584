//! The event loop: decide the closed contacts, integrate their phase to the first event, decide again.

mod accumulate;
mod begin;
mod collide;
mod events;
mod lift;
mod phase;
mod plan;

pub(crate) use plan::{Action, Planned, When};

use accumulate::{Flights, Settling};

use crate::contact::refuse_singular;
use crate::error::{RunCause, RunError};
use crate::model::{BarSystem, ContactSet, Form};
use crate::moment::seen;
use crate::observe::Observer;
use crate::output::Condition;
use crate::segment::{End, Outcome};
use crate::simulation::Simulation;
use crate::start::Start;
use crate::trajectory::{LogEntry, Trajectory};

const SMALL_PIVOT: &str = "a pivot of the closed form is small: the phase is integrated with multipliers";
const OTHER_BRANCH: &str = "the contacts are closed on another branch than that of the closed form: the phase is integrated with multipliers";
const CROSSED: &str = "a loop passes a singular position: the motion is continued along its branch";

/// A run in progress.
pub(crate) struct Driver<'a, M: BarSystem> {
    setup: &'a Simulation<M>,
    observer: &'a mut dyn Observer,
    trajectory: Trajectory<M>,
    t: f64,
    state: M::State<f64>,
    /// Closed contacts that the next decision is about.
    touching: ContactSet,
    closed: ContactSet,
    /// Contacts held closed whatever their reaction.
    held: ContactSet,
    removed: ContactSet,
    /// Contacts that have just opened with their reaction at zero.
    lifted: ContactSet,
    form: Form,
    /// Reactions at the last decision.
    reactions: Vec<f64>,
    /// Conditions that end the run, then those of the plan.
    conditions: Vec<Condition>,
    /// Which entries of the plan have happened.
    done: Vec<bool>,
    flights: Flights,
    settling: Option<Settling>,
    /// Phases since time last advanced.
    stalled: usize,
}

/// Whether the run goes on.
enum Next {
    Continue,
    Finished,
}

impl<'a, M: BarSystem> Driver<'a, M> {
    pub(crate) fn new(setup: &'a Simulation<M>, start: Start<M>, observer: &'a mut dyn Observer) -> Self {
        let last = seen::<M>(&start.state).to_vec();
        let planned = setup.plan.iter().filter_map(|planned| match &planned.when {
            When::If(condition) => Some(condition),
            When::At(_) => None,
        });
        Self {
            conditions: setup.conditions.iter().chain(planned).cloned().collect(),
            done: vec![false; setup.plan.len()],
            flights: Flights::new(M::LAYOUT.contacts.len()),
            settling: None,
            trajectory: Trajectory::empty(setup.scene.clone(), setup.tolerance, last),
            form: setup.form,
            held: setup.held,
            setup,
            observer,
            t: 0.0,
            state: start.state,
            touching: start.touching,
            closed: ContactSet::EMPTY,
            removed: ContactSet::EMPTY,
            lifted: ContactSet::EMPTY,
            reactions: Vec::new(),
            stalled: 0,
        }
    }

    pub(crate) fn run(mut self) -> Result<Trajectory<M>, RunError<M>> {
        let played = self.play();
        self.trajectory.conditions = self.conditions;
        match played {
            Ok(()) => Ok(self.trajectory),
            Err(cause) => Err(RunError::new(cause, self.trajectory)),
        }
    }

    fn play(&mut self) -> Result<(), RunCause> {
        self.check()?;
        if let Next::Finished = self.begin()? {
            return Ok(());
        }
        self.do_due()?;
        loop {
            let outcome = self.advance();
            if let Next::Finished = self.absorb(outcome)? {
                return Ok(());
            }
        }
    }

    fn absorb(&mut self, outcome: Outcome<M>) -> Result<Next, RunCause> {
        let Outcome { piece, touches, crossings, end, t, state, reactions, counts } = outcome;
        self.stalled = if t > self.t { 0 } else { self.stalled + 1 };
        (self.t, self.state) = (t, state);
        self.trajectory.end = t;
        self.trajectory.last = seen::<M>(&self.state).to_vec();
        self.trajectory.statistics.add(counts);
        self.reactions = reactions.as_ref().to_vec();
        for t in crossings {
            self.trajectory.log.push(LogEntry { t, text: CROSSED.to_owned() });
        }
        for touch in touches {
            self.record_touch(touch);
        }
        if let Some(piece) = piece {
            self.trajectory.pieces.push(piece);
            let guards = if let End::Event(guards) = &end { guards.clone() } else { Vec::new() };
            self.trajectory.ends.push(guards);
        }
        if self.stalled > 4 + 2 * M::LAYOUT.contacts.len() {
            self.refuse_singular()?;
            return Err(RunCause::Stalled { t });
        }
        match end {
            End::Failed(error) => {
                self.refuse_singular()?;
                Err(error.into())
            }
            End::Cancelled => Err(RunCause::Cancelled { t }),
            End::Loop(joints) => Err(RunCause::Loop { joints, t }),
            End::Singular(source) => Err(self.contact_error(source)),
            End::Horizon => self.reach_horizon(),
            End::Pivot => {
                self.form = Form::Projected;
                self.log(SMALL_PIVOT.to_owned());
                Ok(Next::Continue)
            }
            End::Event(guards) => self.handle(&guards),
        }
    }

    /// What looks like an error of stepping may be accelerations that are all but undetermined.
    fn refuse_singular(&self) -> Result<(), RunCause> {
        let refused = refuse_singular::<M>(&self.setup.scene.series, &self.state, self.closed);
        refused.map_err(|source| self.contact_error(source))
    }
}
