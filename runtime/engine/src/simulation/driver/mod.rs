//! The event loop: decide the closed contacts, integrate their phase to the first event, decide again.

mod begin;
mod collide;
mod dependent;
mod domain;
mod drives;
mod events;
mod friction;
mod gate;
mod jumps;
mod liftoff_order;
mod paradox;
mod phase;
mod plan;
mod switch;
mod tiny;
mod zeno;

use std::cell::RefCell;
use std::sync::Arc;

use tiny::Tiny;
use zeno::{BounceHistory, Rise, ZenoClosure};

use crate::contact::{ContactError, are_determined, labels, refuse_singular};
use crate::model::{ContactSet, Energy, Form, Layout};
use crate::simulation::{RunCause, RunError};

use crate::assembly::Start;
use crate::context::Numbers;
use crate::event::detection::{Broken, Guard, KnownAffineGuards};
use crate::integrate::Counts;
use crate::simulation::awaited::Awaited;
use crate::simulation::phase_run::{Outcome, Termination};
use crate::simulation::{Allowance, Exhausted, Simulation};
use crate::system::Phase;
use crate::trajectory::RecordedPhase;
use crate::trajectory::observe::Observer;
use crate::trajectory::{LoggedDecision, Trajectory};

/// A run in progress.
pub(crate) struct Driver<'a> {
    setup: &'a Simulation,
    observer: &'a mut dyn Observer,
    trajectory: Trajectory,
    t: f64,
    state: Vec<f64>,
    /// Closed contacts that the next decision is about.
    touching: ContactSet,
    /// Of these, the contacts with friction whose slips are those of the phase before.
    sensed: ContactSet,
    closed: ContactSet,
    /// Independent ones among them, which hold the others too: those that are integrated and watched.
    bearing: ContactSet,
    /// Contacts held closed whatever their reaction, drives that have taken hold among them.
    held: ContactSet,
    removed: ContactSet,
    /// Contacts that the last phase began with below their grounds, where they had been armed.
    sunk: ContactSet,
    /// Open contacts below their bars, which they have come to from beyond the ends.
    passed: ContactSet,
    /// Contacts that have just opened with their reaction at zero.
    lifted: ContactSet,
    /// Contacts whose reaction or slip velocity has been located at zero, or whose friction force at its limit, and that the
    /// decision has kept as they were.
    kept: ContactSet,
    form: Form,
    /// The phase decided on, until it is integrated.
    phase: Option<Arc<dyn Phase>>,
    /// Reactions at the last decision.
    reactions: Vec<f64>,
    affine: KnownAffineGuards,
    awaited: Awaited,
    /// Which entries of the plan have happened.
    done: Vec<bool>,
    bounces: BounceHistory,
    /// Contacts that rise at the start of the phase that follows, with those that bear it, until it is integrated.
    risen: Option<(ContactSet, Vec<Rise>)>,
    /// The last accelerations that were asked for, with the state and the set of which they are.
    accelerations: RefCell<Option<(Numbers, ContactSet, Numbers)>>,
    /// What counts as zero at the last state at which it was asked for.
    tiny: RefCell<Tiny>,
    settling: Vec<ZenoClosure>,
    allowance: Allowance,
    /// How many events of the trajectory the observer has been shown, and how many it has taken.
    shown: usize,
    taken: usize,
    /// Kinetic and potential energy at the start of the phase, and the state there.
    energy: Energy<f64>,
    begun: Vec<f64>,
    /// The state in which the phase before has ended, as it was recorded, and whether an impulse
    /// has acted since.
    ended: Vec<f64>,
    is_struck: bool,
    /// How many phases have begun since time last advanced.
    stalled: usize,
    /// How many impacts without collision since then.
    wedged: usize,
}

/// Whether the run goes on.
enum Next {
    Continue,
    Finished,
}

impl<'a> Driver<'a> {
    pub(crate) fn new(setup: &'a Simulation, start: Start, observer: &'a mut dyn Observer) -> Self {
        let last = setup.context.layout().public_state(&start.state).to_vec();
        let removed = setup.rules.switches.disarmed(&setup.context, &start.state, setup.begin);
        let mut driver = Self {
            awaited: Awaited::from_setup(setup),
            done: vec![false; setup.plan.len()],
            bounces: BounceHistory::new(setup.layout().contacts.len()),
            risen: None,
            accelerations: RefCell::default(),
            tiny: RefCell::default(),
            settling: Vec::new(),
            trajectory: Trajectory::empty(setup.context.clone(), setup.tolerance, (setup.begin, last)),
            form: setup.form,
            phase: None,
            held: setup.held.union(start.touching.intersection(setup.layout().drives())),
            setup,
            observer,
            t: setup.begin,
            state: start.state,
            touching: start.touching,
            sensed: ContactSet::EMPTY,
            closed: ContactSet::EMPTY,
            bearing: ContactSet::EMPTY,
            removed,
            sunk: ContactSet::EMPTY,
            passed: ContactSet::EMPTY,
            lifted: ContactSet::EMPTY,
            kept: ContactSet::EMPTY,
            reactions: Vec::new(),
            affine: KnownAffineGuards::default(),
            allowance: Allowance::of(setup.budget),
            shown: 0,
            taken: 0,
            energy: Energy { kinetic: 0.0, potential: 0.0 },
            begun: Vec::new(),
            ended: Vec::new(),
            is_struck: false,
            stalled: 0,
            wedged: 0,
        };
        driver.passed = driver.below();
        driver.tell_depth(start.depth);
        driver
    }

    fn layout(&self) -> &'static Layout {
        self.setup.layout()
    }

    /// Coordinates and rates as users see them.
    fn public_state(&self) -> &[f64] {
        self.setup.context.layout().public_state(&self.state)
    }

    fn keep_last(&mut self) {
        let last = &mut self.trajectory.last;
        last.clear();
        last.extend_from_slice(self.setup.context.layout().public_state(&self.state));
    }

    pub(crate) fn run(mut self) -> Result<Trajectory, RunError> {
        let played = self.play();
        self.show_events(true);
        self.trajectory.conditions = core::mem::take(&mut self.awaited.conditions);
        match played {
            Ok(()) => {
                self.keep_end();
                Ok(self.trajectory)
            }
            Err(cause) => Err(RunError::new(cause, self.trajectory)),
        }
    }

    /// What ends before it has moved is a phase of no duration.
    fn keep_end(&mut self) {
        if self.trajectory.phases.is_empty() && self.trajectory.last_phase.is_none() {
            let phase = self.setup.context.phase(self.bearing, Form::Projected);
            self.keep(RecordedPhase::still((phase, self.closed), self.t, &self.state), Vec::new());
        }
    }

    /// Keeps a phase, or its end in place of that of the one before.
    fn keep(&mut self, phase: RecordedPhase, guards: Vec<Guard>) {
        if self.observer.records() {
            self.trajectory.phases.push(phase);
            self.trajectory.ends.push(guards);
        } else {
            self.trajectory.last_phase = Some(phase);
        }
    }

    /// Takes what a phase needed from the budget.
    fn spend(&mut self, counts: Counts, memory: usize) -> Result<(), RunCause> {
        self.allowance.spend(counts.accepted + counts.rejected, memory);
        let most = self.setup.budget.events;
        if self.taken + self.trajectory.events.len() > most {
            return Err(self.exhausted(Exhausted::Events(most)));
        }
        self.allowance.exceeded_by(0, 0).map_or(Ok(()), |of| Err(self.exhausted(of)))
    }

    pub(super) fn exhausted(&self, of: Exhausted) -> RunCause {
        RunCause::Budget { t: self.t, of }
    }

    fn play(&mut self) -> Result<(), RunCause> {
        self.check()?;
        self.refuse_vanishing()?;
        if let Next::Finished = self.begin()? {
            return Ok(());
        }
        self.tell_met();
        self.do_due()?;
        loop {
            self.show_events(false);
            self.settle_unseen()?;
            self.energy = self.setup.context.system().energy(&self.state);
            self.begun.clone_from(&self.state);
            self.bear_what_sinks()?;
            self.refuse_seam()?;
            let outcome = self.advance();
            if let Next::Finished = self.apply_result(outcome)? {
                return Ok(());
            }
        }
    }

    fn apply_result(&mut self, outcome: Outcome) -> Result<Next, RunCause> {
        let Outcome {
            mut recorded,
            touches,
            log,
            end,
            t,
            state,
            ended,
            reactions,
            counts,
            passed,
            work,
            memory,
        } = outcome;
        if let (Some(recorded), Termination::Event(guards)) = (&mut recorded, &end) {
            self.record_parted(recorded, guards);
        }
        (self.stalled, self.wedged) = if t > self.t { (0, 0) } else { (self.stalled + 1, self.wedged) };
        (self.t, self.state, self.ended) = (t, state, ended);
        self.trajectory.end = t;
        self.keep_last();
        self.trajectory.statistics.add(counts);
        (self.reactions, self.passed) = (reactions, passed);
        let logged = self.trajectory.log.len();
        self.trajectory.log.extend(log);
        for touch in touches {
            self.record_touch(touch);
        }
        if let Some(mut recorded) = recorded {
            recorded.is_struck = core::mem::take(&mut self.is_struck);
            recorded.held = self.held;
            recorded.removed = self.removed.union(self.sunk).union(self.waiting());
            let guards = if let Termination::Event(guards) = &end { guards.clone() } else { Vec::new() };
            self.keep(recorded, guards);
        }
        if self.stalled > 4 + 2 * self.layout().contacts.len() {
            self.refuse_singular()?;
            return Err(self.stalled_by(&end));
        }
        self.spend(counts, memory)?;
        self.refuse_left(&end)?;
        let breaks = matches!(end, Termination::Failed(_) | Termination::Drive(_) | Termination::Seam(_));
        if !breaks && !matches!(end, Termination::Singular(_) | Termination::Loop(_)) {
            self.refuse_drift(counts, &work, &self.trajectory.log[logged..])?;
        }
        match end {
            Termination::Exhausted(of) => Err(self.exhausted(of)),
            Termination::Failed(error) => {
                self.refuse_vanishing()?;
                self.refuse_singular()?;
                self.refuse_hinges(&error)?;
                Err(error.into())
            }
            Termination::Seam(jump) => Err(RunCause::Invariant(jump)),
            Termination::Cancelled => Err(RunCause::Cancelled { t }),
            Termination::Loop(joints) => {
                self.refuse_vanishing()?;
                Err(RunCause::Loop { joints, t })
            }
            Termination::Singular(source) => Err(self.contact_error(source)),
            Termination::Drive(Broken { t, expression, what }) => {
                Err(RunCause::Drive { t, expression, what })
            }
            Termination::Pivot => {
                self.form = Form::Projected;
                self.log(LoggedDecision::SmallPivot);
                Ok(Next::Continue)
            }
            Termination::Paradox | Termination::Horizon | Termination::Event(_) => self.pass(&end),
        }
    }

    /// Why events follow one another without time: a hinge at its limit that has no motion beyond it, else that is not decided.
    fn stalled_by(&self, end: &Termination) -> RunCause {
        let guards = if let Termination::Event(guards) = end { &guards[..] } else { &[] };
        let at_zero: ContactSet = match guards.contains(&Guard::Grip) {
            true => self.closed,
            false => guards.iter().filter_map(Guard::contact).collect(),
        };
        let contacts = self.layout().contacts;
        let labels = |set: ContactSet| labels(self.layout(), set);
        let limited =
            guards.iter().filter_map(|g| if let Guard::Limit(rub) = g { Some(rub.contact) } else { None });
        let hinges: ContactSet = limited.filter(|&i| contacts[i].is_hinge()).collect();
        match hinges.is_empty() {
            true => RunCause::Stalled { t: self.t, contacts: labels(at_zero) },
            false => self.contact_error(ContactError::Hinges { hinges: labels(hinges) }),
        }
    }

    /// What happens at the end of a phase, and what that makes true at once.
    fn pass(&mut self, end: &Termination) -> Result<Next, RunCause> {
        let before = self.before_event();
        let (next, roots) = match end {
            Termination::Event(guards) => (self.handle(guards)?, &guards[..]),
            Termination::Paradox => (self.cross_border()?, &[][..]),
            _ => (self.reach_horizon()?, &[][..]),
        };
        match next {
            Next::Continue => self.follow_jumps(before, roots),
            Next::Finished => Ok(Next::Finished),
        }
    }

    /// The cause of a failed step may be accelerations that are nearly undetermined; then that is the error.
    fn refuse_singular(&self) -> Result<(), RunCause> {
        let refused = refuse_singular(&self.setup.context.model, &self.state, self.closed);
        refused.map_err(|source| self.contact_error(source))
    }

    /// Where a motion comes to a position at which it loses inertia, rates grow beyond all bounds and reactions lose their digits:
    /// a zero of one is no event there.
    fn refuse_lost_inertia(&self) -> Result<(), RunCause> {
        let model = &self.setup.context.model;
        let had_inertia = || refuse_singular(model, &self.begun, self.closed).is_ok();
        if are_determined(&*model.system, &self.state) || !had_inertia() {
            return Ok(());
        }
        self.refuse_singular()
    }
}
