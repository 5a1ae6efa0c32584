//! The event loop: decide the closed contacts, integrate their phase to the first event, decide again.

mod accumulate;
mod collide;
mod events;
mod plan;

pub(crate) use plan::{Action, Planned, When};

use accumulate::{Flights, Settling};

use crate::contact::{ContactError, Decision, Question, decide, refuse_singular};
use crate::error::{RunCause, RunError, StartError};
use crate::event::EventKind;
use crate::model::{BarSystem, ContactSet, Form, KernelView};
use crate::moment::seen;
use crate::output::Condition;
use crate::pivot::form_at;
use crate::rest::Rest;
use crate::segment::{Drive, End, Outcome};
use crate::simulation::Simulation;
use crate::start::{CLOSED, Start};
use crate::trajectory::{LogEntry, Trajectory};
use crate::watch::{Bounds, Roles, Watches};

const SMALL_PIVOT: &str = "a pivot of the closed form is small: the phase is integrated with multipliers";
const CROSSED: &str = "a loop passes a singular position: the motion is continued along its branch";

/// A run in progress.
pub(crate) struct Driver<M: BarSystem> {
    setup: Simulation<M>,
    trajectory: Trajectory<M>,
    t: f64,
    state: M::State<f64>,
    /// Closed contacts that the next decision is about.
    touching: ContactSet,
    closed: ContactSet,
    removed: ContactSet,
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

impl<M: BarSystem> Driver<M> {
    pub(crate) fn new(setup: Simulation<M>, start: Start<M>) -> Self {
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
            setup,
            t: 0.0,
            state: start.state,
            touching: start.touching,
            closed: ContactSet::EMPTY,
            removed: ContactSet::EMPTY,
            reactions: Vec::new(),
            stalled: 0,
        }
    }

    pub(crate) fn run(mut self) -> Result<Trajectory<M>, RunError<M>> {
        match self.play() {
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

    /// The phase of the start, after the impact of what its rates drive into a support.
    fn begin(&mut self) -> Result<Next, RunCause> {
        let striking = self.striking();
        if striking.is_empty() {
            self.decide(ContactSet::EMPTY)?;
            self.refuse_equilibrium()?;
            self.record(EventKind::Start, ContactSet::EMPTY, None);
            return Ok(Next::Continue);
        }
        self.closed = self.touching;
        self.reactions = vec![0.0; M::LAYOUT.contacts.len()];
        let note = "before the impact".to_owned();
        self.record(EventKind::Start, ContactSet::EMPTY, Some(note));
        if !self.barred(striking).is_empty() {
            self.record(EventKind::Close, striking, None);
            return Ok(Next::Finished);
        }
        self.strike(striking)?;
        Ok(Next::Continue)
    }

    /// Contacts with g = 0 > ġ at the start.
    fn striking(&self) -> ContactSet {
        let scene = &self.setup.scene;
        let kernel = M::kernel(&scene.constants, &self.state);
        let n = M::LAYOUT.coordinates.len();
        let rates = &self.state.as_ref()[n..2 * n];
        let speed = |i: usize| {
            let along = kernel.jacobian(i).iter().zip(rates).map(|(slope, u)| slope * u);
            along.sum::<f64>() + kernel.drift()[i]
        };
        let closes = |i: &usize| {
            !self.touching.contains(*i)
                && kernel.gap()[*i].abs() <= CLOSED * scene.scales.length
                && speed(*i) < 0.0
        };
        (0..M::LAYOUT.contacts.len()).filter(closes).fold(ContactSet::EMPTY, ContactSet::with)
    }

    fn check(&self) -> Result<(), RunCause> {
        let Simulation { tolerance, limit, .. } = self.setup;
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(RunCause::Tolerance(tolerance));
        }
        if !(limit > 0.0 && limit.is_finite()) {
            return Err(RunCause::Limit(limit));
        }
        let kernel = M::kernel(&self.setup.scene.constants, &self.state);
        match self.setup.held.iter().find(|&i| !self.touching.contains(i)) {
            Some(i) => {
                let support = M::LAYOUT.contacts[i].label.to_owned();
                Err(StartError::HeldOpen { support, gap: kernel.gap()[i] }.into())
            }
            None => Ok(()),
        }
    }

    /// Nothing that is at rest now is ever set in motion, unless something is planned.
    fn refuse_equilibrium(&self) -> Result<(), RunCause> {
        let scene = &self.setup.scene;
        let rest = Rest { constants: &scene.constants, scales: &scene.scales, state: &self.state };
        if self.setup.plan.is_empty() && M::phase(self.closed, self.form, rest) {
            return Err(StartError::Equilibrium.into());
        }
        Ok(())
    }

    /// The closed contacts from now on, given those whose reaction is zero.
    fn decide(&mut self, unloaded: ContactSet) -> Result<(), RunCause> {
        let held = ContactSet(self.setup.held.0 & !self.removed.0);
        let question = Question { touching: self.touching, held, unloaded };
        let decided = decide::<M>(&self.setup.scene.series, &self.state, &question);
        let Decision { closed, reactions, unique } = decided.map_err(|source| self.contact_error(source))?;
        if !unique {
            self.log("the reactions are not unique; the least-norm ones are given".to_owned());
        }
        (self.closed, self.touching, self.reactions) = (closed, closed, reactions);
        self.choose_form();
        Ok(())
    }

    fn contact_error(&self, source: ContactError) -> RunCause {
        match self.t {
            0.0 => RunCause::Start(StartError::Contact(source)),
            t => RunCause::Contact { t, source },
        }
    }

    fn choose_form(&mut self) {
        let Simulation { scene, form, tolerance, .. } = &self.setup;
        let has = M::LAYOUT.closed_forms.contains(&self.closed);
        self.form = form_at::<M>(&scene.constants, self.closed, *form, &self.state, *tolerance);
        if has && *form == Form::Closed && self.form == Form::Projected {
            self.log(SMALL_PIVOT.to_owned());
        }
    }

    fn advance(&self) -> Outcome<M> {
        let Simulation { scene, tolerance, held, .. } = &self.setup;
        let largest = self.reactions.iter().fold(scene.scales.force(), |most: f64, r| most.max(r.abs()));
        let bounds = Bounds { relative: self.relative_bound(), force: largest, length: scene.scales.length };
        let (off, heights) = (self.beyond_end(), &self.flights.heights);
        let roles = Roles { held: *held, removed: self.removed, off, heights };
        let located = |k: &usize| self.conditions[*k].time(&scene.parameters).is_none() && self.awaited(*k);
        let located: Vec<usize> = (0..self.conditions.len()).filter(located).collect();
        let drive = Drive {
            scene,
            watches: Watches::new::<M>(self.closed, roles, (&self.conditions, &located), bounds),
            tolerance: *tolerance,
            t: self.t,
            horizon: self.horizon(),
            state: self.state,
        };
        M::phase(self.closed, self.form, drive)
    }

    /// Local errors of ten steps, or some roundings.
    fn relative_bound(&self) -> f64 {
        (10.0 * self.setup.tolerance).max(64.0 * f64::EPSILON)
    }

    /// The next time at which something is to happen.
    fn horizon(&self) -> f64 {
        let settling = self.settling.map(|settling| settling.end);
        let times = self.stops().chain(self.planned_times()).chain(settling);
        times.filter(|t| *t > self.t).fold(self.setup.limit, f64::min)
    }

    fn is_held(&self, contact: usize) -> bool {
        self.setup.held.contains(contact) && !self.removed.contains(contact)
    }

    /// Open contacts whose foot is at the end of its bar or beyond.
    fn beyond_end(&self) -> ContactSet {
        let scene = &self.setup.scene;
        let feet = M::feet(&scene.constants, &self.state);
        let bound = self.relative_bound() * scene.scales.length;
        let off = |i: &usize| {
            let foot = M::LAYOUT.contacts[*i].foot.filter(|_| !self.closed.contains(*i));
            foot.is_some_and(|k| feet.as_ref()[2 * k..2 * k + 2].iter().any(|margin| *margin <= bound))
        };
        (0..M::LAYOUT.contacts.len()).filter(off).fold(ContactSet::EMPTY, ContactSet::with)
    }

    fn stops(&self) -> impl Iterator<Item = f64> {
        let Simulation { conditions, scene, .. } = &self.setup;
        conditions.iter().filter_map(|condition| condition.time(&scene.parameters))
    }

    fn absorb(&mut self, outcome: Outcome<M>) -> Result<Next, RunCause> {
        let Outcome { piece, touches, crossings, end, t, state, counts } = outcome;
        self.stalled = if t > self.t { 0 } else { self.stalled + 1 };
        (self.t, self.state) = (t, state);
        self.trajectory.last = seen::<M>(&self.state).to_vec();
        self.trajectory.statistics.add(counts);
        self.reactions = piece.state_and_reactions(&self.setup.scene, t).1;
        for t in crossings {
            self.trajectory.log.push(LogEntry { t, text: CROSSED.to_owned() });
        }
        for (t, guard) in touches {
            let touched = piece.state_and_reactions(&self.setup.scene, t);
            self.record_touch(t, guard, touched);
        }
        if piece.segment().t1 > piece.segment().t0 {
            self.trajectory.pieces.push(piece);
        }
        if self.stalled > 4 + 2 * M::LAYOUT.contacts.len() {
            return Err(RunCause::Stalled { t });
        }
        match end {
            End::Failed(error) => {
                refuse_singular::<M>(&self.setup.scene.series, &self.state, self.closed)
                    .map_err(|source| self.contact_error(source))?;
                Err(error.into())
            }
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
}
