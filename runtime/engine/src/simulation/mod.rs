//! A simulation in preparation, as a builder.

mod awaited;
mod budget;
mod decide;
mod domain;
mod driver;
mod error;
mod parts;
pub(crate) mod phase_handle;
pub(crate) mod phase_run;
mod respond;
mod rules;
mod scene;
mod schedule;
mod snapshot;

#[cfg(test)]
mod tests;

pub(crate) use budget::Allowance;
pub use budget::{Budget, Exhausted};
pub(crate) use domain::Domain;
pub use error::{RunCause, RunError};
pub(crate) use rules::Rules;
pub use scene::Scene;

use core::sync::atomic::AtomicBool;
use std::sync::Arc;

use crate::EventKind;
use crate::assembly::{ConsistentStart, Pose, StartError, on_energy_of, start};
use crate::context::{RunContext, Scales, reduce, scales_of};
use crate::error::{ModelError, NameError, OutputError, ScheduleError, SupportError};
use crate::event::EventFilter;
use crate::expression::resolve::{contact_of, unknown_support};
use crate::expression::{Condition, IntoConditions, Output};
use crate::integration::method::{Auto, Method};
use crate::integration::phase_point::PhasePoint;
use crate::model::names::{ContactFilter, ContactName, PointName, ThreadName};
use crate::model::{ContactKind, ContactSet, Form, Layout};
use crate::simulation::awaited::Awaited;
use crate::simulation::driver::Driver;
use crate::simulation::parts::Parts;
use crate::simulation::schedule::{Action, Scheduled, Trigger};
use crate::system::Model;
use crate::trajectory::observe::{Observer, Recorder};
use crate::trajectory::{Segment, Trajectory};

/// Relative tolerance where none is given.
const TOLERANCE: f64 = 1e-12;
/// Time limit where none is given, in natural times.
const LIMIT: f64 = 1000.0;

/// A simulation in preparation.
///
/// The model's parameters are read once, by [`Simulation::new`].
#[derive(Clone)]
pub struct Simulation {
    pub(crate) context: Arc<RunContext>,
    pub(crate) tolerance: f64,
    /// The start that was asked for.
    start: Option<GivenStart>,
    /// When it begins.
    pub(crate) begin: f64,
    pub(crate) held: ContactSet,
    pub(crate) restitution: Vec<f64>,
    /// What breaks, then what the user plans.
    pub(crate) plan: Vec<Scheduled>,
    pub(crate) rules: Arc<Rules>,
    pub(crate) parts: Parts,
    pub(crate) ends: Ends,
    pub(crate) form: Form,
    pub(crate) method: Arc<dyn Method>,
    pub(crate) cancel: Option<Arc<AtomicBool>>,
    pub(crate) budget: Budget,
}

/// What ends a run.
#[derive(Clone, Default)]
pub(crate) struct Ends {
    pub(crate) conditions: Vec<Condition>,
    /// Events that end it once all of them have happened.
    pub(crate) events: Vec<EventFilter>,
    /// Whether any impact does.
    pub(crate) at_impacts: bool,
    /// The latest end, if one is given.
    limit: Option<f64>,
}

/// A start that was asked for, and what it is at the tolerance set then.
#[derive(Clone)]
struct GivenStart {
    pose: Pose,
    /// A pose on whose energy level it has its rate.
    level: Option<Pose>,
    tolerance: f64,
    start: ConsistentStart,
}

impl Simulation {
    /// Checks the model's parameters, masses, lengths, gravity and restitution.
    pub fn new(model: impl Into<Scene>) -> Result<Self, ModelError> {
        Self::from_scene(model.into())
    }

    fn from_scene(Scene { model, parts }: Scene) -> Result<Self, ModelError> {
        let scales = scales_of(&model)?;
        let restitution = model.restitution.clone();
        let context = RunContext { model, scales };
        let rules = (parts.rules)(&context)?;
        Ok(Self {
            context: Arc::new(context),
            tolerance: TOLERANCE,
            start: None,
            begin: 0.0,
            held: ContactSet::EMPTY,
            restitution,
            plan: rules.breaks.clone(),
            rules: Arc::new(rules),
            parts,
            ends: Ends::default(),
            form: Form::Reduced,
            method: Arc::new(Auto),
            cancel: None,
            budget: Budget::default(),
        })
    }

    /// Names of the model.
    pub fn layout(&self) -> &'static Layout {
        self.context.layout()
    }

    /// The model that is to move.
    pub fn model(&self) -> &Model {
        &self.context.model
    }

    /// Its natural units, in which absolute tolerances are measured; a model without bars has those
    /// of its start.
    pub fn scales(&self) -> Scales {
        self.context.scales
    }

    /// The full state that the run starts in: coordinates, rates, and the time if the model depends
    /// on it.
    ///
    /// # Errors
    /// No start was given and the nominal figure allows none.
    pub fn start_state(&self) -> Result<Vec<f64>, StartError> {
        Ok(self.started()?.state)
    }

    /// Local error per step, relative to each coordinate and, in natural units, absolute: lengths
    /// of the largest bar, times of √(length / gravity). A model without bars is as large as the
    /// largest coordinate it starts from; where a start is faster than that, or gravity and springs
    /// are absent, its time is that of the fastest rate, or of what drives accelerate. The default
    /// is 1e-12.
    #[must_use]
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Starts from this pose; coordinates and rates that it leaves open follow from the closed
    /// contacts. Contacts may be penetrated by ten times the tolerance, in natural lengths; one
    /// that is set later counts when the run begins. The default is the nominal figure at rest.
    pub fn start(mut self, pose: Pose) -> Result<Self, StartError> {
        self.measure(&pose)?;
        let mut start = self.complete(&pose)?;
        let (layout, n) = (self.layout(), self.layout().coordinates.len());
        let driven = self.driven_acceleration(&start.state[..n], &self.context.scales);
        let scales = self.context.scales.driven_at(layout, &start.state[n..2 * n], driven);
        if scales.time != self.context.scales.time {
            self.set_scales(scales);
            start = self.complete(&pose)?;
        }
        self.start = Some(GivenStart { pose, level: None, tolerance: self.tolerance, start });
        Ok(self)
    }

    /// The same at this time instead of t = 0. What is planned for times before is done then.
    ///
    /// # Errors
    /// As for [`Self::start`].
    pub fn start_at(self, t: f64, pose: Pose) -> Result<Self, StartError> {
        Self { begin: t, ..self }.start(pose)
    }

    /// The same from a pose at a time: in the natural units of this simulation, however small what
    /// is left of the motion; with [`Pose::of_state`] from where a run was left. What is planned
    /// for times before is done at that time.
    ///
    /// ```
    /// # use liftoff::prelude::*;
    /// # /// A bar that swings.
    /// # #[derive(BarSystem)]
    /// # #[gravity(g)]
    /// # #[bar(OA, mass = m, length = l)]
    /// # #[pin(O = (0, 0))]
    /// # #[figure(A = (0, -l))]
    /// # #[coordinate(phi = angle(OA), from = down)]
    /// # struct Pendulum { m: f64, l: f64, g: f64 }
    /// let swings = Simulation::new(&Pendulum { m: 1.0, l: 1.0, g: 9.81 })?.start(Pose::new("phi", 1.0))?;
    /// let whole = swings.clone().until("t = 2")?.run()?;
    /// let left = Pose::of_state(Pendulum::LAYOUT, &whole.state(1.0));
    /// let rest = swings.continued(1.0, &left)?.until("t = 2")?.run()?;
    /// assert_eq!(rest.interval(), [1.0, 2.0]);
    /// assert!((rest.final_state()[0] - whole.final_state()[0]).abs() < 1e-10);
    /// // What a trajectory tells, of a state.
    /// let energy = Output::parse(Pendulum::LAYOUT, "E")?;
    /// let [value] = swings.values(&whole.segments()[0], (1.0, &whole.state(1.0)), &[energy.clone()])[..] else { panic!() };
    /// assert_eq!(value, whole.value(&energy, 1.0));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// The pose satisfies the joints and contacts of no phase.
    pub fn continued(&self, t: f64, pose: &Pose) -> Result<Self, StartError> {
        let mut continued = Self { begin: t, ..self.clone() };
        let (pose, start) = (pose.clone(), continued.complete(pose)?);
        continued.start = Some(GivenStart { pose, level: None, tolerance: self.tolerance, start });
        Ok(continued)
    }

    /// Outputs in a phase at a time and a full state, coordinates then rates, of which the entries
    /// are read that the phase keeps.
    pub fn values(&self, phase: &Segment, (t, state): (f64, &[f64]), outputs: &[Output]) -> Vec<f64> {
        let mut full = self.layout().state_at(state, t);
        for i in 0..self.layout().switches.len() {
            full[self.layout().switch(i)] = f64::from(u8::from(phase.acting.contains(&i)));
        }
        let equations = self.context.phase(phase.active_basis, phase.form);
        let reduced = reduce(&*equations, &full);
        let point = PhasePoint::new(equations, phase.set, t, reduced);
        outputs.iter().map(|output| output.evaluate(&self.context, &point)).collect()
    }

    /// Gives the start the rate that it has on the energy level of `pose`, moving away from that
    /// pose. The closed contacts must leave one degree of freedom.
    pub fn on_energy_of(mut self, pose: Pose) -> Result<Self, StartError> {
        let from = self.start.map_or_else(Pose::nominal, |given| given.pose);
        self.start = None;
        let start = self.resolve(&from, Some(&pose))?;
        self.start = Some(GivenStart { pose: from, level: Some(pose), tolerance: self.tolerance, start });
        Ok(self)
    }

    /// Makes a support two-sided: it does not open, unless it slides off its bar; its reaction is
    /// reported whatever its sign.
    ///
    /// # Errors
    /// There is no such support, or it has friction: the law of a support knows no reaction that
    /// pulls.
    pub fn hold(mut self, support: impl ContactName) -> Result<Self, SupportError> {
        let held = contact(support.as_ref(), self.layout())?;
        if self.layout().contacts[held].friction.is_some() {
            return Err(SupportError::HeldWithFriction { support: support.as_ref().to_owned() });
        }
        self.held = self.held.with(held);
        Ok(self)
    }

    /// The supports that are held.
    pub fn held(&self) -> Vec<&'static str> {
        let contacts = self.layout().contacts;
        self.held.iter().flat_map(|i| contacts[i].supports.iter().copied()).collect()
    }

    /// Takes a support away at a time, and with it the contact that it belongs to.
    pub fn release(mut self, support: impl ContactName, at: f64) -> Result<Self, SupportError> {
        let support = support.as_ref();
        let contact = contact(support, self.layout())?;
        if !(at >= 0.0 && at.is_finite()) {
            return Err(SupportError::Time { support: support.to_owned(), at });
        }
        self.plan.push(Scheduled {
            action: Action::Remove(ContactSet::EMPTY.with(contact)),
            when: Trigger::At(at),
        });
        Ok(self)
    }

    /// Takes a support away, and with it the contact that it belongs to, when a condition becomes
    /// true: `t = 0.2`, `phi = 1`, `N(A) < 0.1`.
    pub fn release_when(self, support: impl ContactName, condition: &str) -> Result<Self, ScheduleError> {
        let support = support.as_ref();
        let (contact, _) =
            contact_of(self.layout(), support).ok_or_else(|| unknown_support(self.layout(), support))?;
        self.plan(Action::Remove(ContactSet::EMPTY.with(contact)), condition)
    }

    /// Cuts a thread when a condition becomes true: `t = 0` starts a motion from a taut
    /// equilibrium.
    pub fn cut(self, thread: impl ThreadName, condition: &str) -> Result<Self, ScheduleError> {
        let thread = thread.as_ref();
        let threads = self.layout().contacts.iter().filter(|c| c.kind == ContactKind::Thread);
        let names = threads.flat_map(|c| c.supports.iter().copied());
        match contact_of(self.layout(), thread) {
            Some((i, contact)) if contact.kind == ContactKind::Thread => {
                self.plan(Action::Remove(ContactSet::EMPTY.with(i)), condition)
            }
            Some(_) => Err(ScheduleError::NoThread { support: thread.to_owned() }),
            None => Err(NameError::new("thread", thread, names).into()),
        }
    }

    /// Applies the impulse (pₓ, p_y), a force times a time, at a point and a time. All closed
    /// contacts answer at once. Refused beside hinges with friction.
    pub fn impulse(
        mut self,
        point: impl PointName,
        impulse: [f64; 2],
        at: f64,
    ) -> Result<Self, ScheduleError> {
        let point = point.as_ref();
        let points = self.layout().points;
        let found = points.iter().position(|p| *p == point);
        let index = found.ok_or_else(|| NameError::new("point", point, points.iter().copied()))?;
        if !impulse.iter().all(|p| p.is_finite()) {
            return Err(ScheduleError::Impulse { point: point.to_owned(), impulse });
        }
        if self.layout().has_hinges() {
            return Err(ScheduleError::HingeFriction);
        }
        let when = Trigger::from_time(at)?;
        self.plan.push(Scheduled { action: Action::Impulse { point: index, impulse }, when });
        self.set_scales(self.context.scales);
        Ok(self)
    }

    fn plan(mut self, action: Action, condition: &str) -> Result<Self, ScheduleError> {
        let condition = Condition::parse(self.layout(), condition)?;
        let when = match condition.time(&self.context.model.parameters) {
            Some(at) => Trigger::from_time(at)?,
            None => Trigger::If(condition),
        };
        self.plan.push(Scheduled { action, when });
        Ok(self)
    }

    /// Ends the run where a contact closes, before the impact; the event is
    /// [`EventKind::Close`](crate::EventKind).
    #[must_use]
    pub fn stop_at_impacts(mut self) -> Self {
        self.ends.at_impacts = true;
        self
    }

    /// Ends the run where a condition becomes true, in an impact too: `phi = pi/2`, `y(D) < -l`,
    /// `t = 5`, or an expression becoming zero. An equation that an impact passes is not met. `and`
    /// joins `<` and `>`, `or` any conditions. Text or a [`Condition`] is taken.
    pub fn until(mut self, condition: impl IntoConditions) -> Result<Self, OutputError> {
        for condition in condition.into_conditions(self.layout())? {
            if condition
                .time(&self.context.model.parameters)
                .is_some_and(|at| at.is_nan() || at <= self.begin)
            {
                return Err(OutputError::Constant { condition: condition.to_string() });
            }
            self.ends.conditions.push(condition);
        }
        Ok(self)
    }

    /// Ends the run once an event of this kind has happened to this support, `Ladder::B` or `"B"`,
    /// or to any with `None`; where several are asked for, once each of them has. That event is the
    /// last of the run.
    pub fn until_event(mut self, kind: EventKind, support: impl ContactFilter) -> Result<Self, SupportError> {
        self.ends.events.push(EventFilter::new(self.layout(), kind, support)?);
        Ok(self)
    }

    /// Ends the run at this time at the latest. The default is 1000 natural times, √(length /
    /// gravity) or shorter where speeds or impulses are high, after the start; so much after the
    /// last planned impulse or removal if that is later; and no sooner than a time that ends the
    /// run. Where a time is given a start in equilibrium stays there until then.
    #[must_use]
    pub fn limit(mut self, time: f64) -> Self {
        self.ends.limit = Some(time);
        self
    }

    /// When the run ends at the latest.
    pub fn time_limit(&self) -> f64 {
        self.ends.limit.unwrap_or_else(|| {
            let natural = LIMIT * self.context.scales.time;
            let planned = self.plan.iter().filter_map(|planned| match planned.when {
                Trigger::At(at) => Some(at),
                Trigger::If(_) => None,
            });
            let last = planned.fold(self.begin, f64::max);
            let begin = if last - self.begin < natural { self.begin } else { last };
            self.stops().filter(|at| at.is_finite()).fold(begin + natural, f64::max)
        })
    }

    /// Whether a time is given that ends the run.
    pub(crate) fn ends_at_a_time(&self) -> bool {
        self.ends.limit.is_some() || self.stops().any(f64::is_finite)
    }

    /// The given times that end the run.
    pub(crate) fn stops(&self) -> impl Iterator<Item = f64> {
        self.ends.conditions.iter().filter_map(|condition| condition.time(&self.context.model.parameters))
    }

    /// Integrates every phase in this form where it has it; [`Form::Multipliers`] exists for all.
    #[must_use]
    pub fn form(mut self, form: Form) -> Self {
        self.form = form;
        self
    }

    /// Integrates with this method; the default is [`Auto`].
    #[must_use]
    pub fn method(mut self, method: impl Method) -> Self {
        self.method = Arc::new(method);
        self
    }

    /// Stops between steps once this is true: with [`RunCause::Cancelled`] and the motion so far.
    #[must_use]
    pub fn cancel(mut self, flag: Arc<AtomicBool>) -> Self {
        self.cancel = Some(flag);
        self
    }

    /// What the run may take, instead of [`Budget::default`].
    #[must_use]
    pub fn budget(mut self, budget: Budget) -> Self {
        self.budget = budget;
        self
    }

    /// Computes the motion up to the event that ends it.
    pub fn run(&self) -> Result<Trajectory, RunError> {
        self.drive(&mut Recorder)
    }

    /// The same with nothing recorded but events and the last state: the observer sees each step as
    /// it is made. `&mut ()` looks at none, and long runs take no memory.
    pub fn observe(&self, observer: &mut impl Observer) -> Result<Trajectory, RunError> {
        self.drive(observer)
    }

    fn drive(&self, observer: &mut dyn Observer) -> Result<Trajectory, RunError> {
        match self.started() {
            Ok(start) => Driver::new(self, &Awaited::from_setup(self), start, observer).run(),
            Err(error) => {
                let nominal = &self.context.model.nominal;
                let last = nominal.iter().copied().chain(nominal.iter().map(|_| 0.0)).collect();
                let trajectory =
                    Trajectory::empty(Arc::clone(&self.context), self.tolerance, (self.begin, last));
                Err(RunError::new(RunCause::Start(error), trajectory))
            }
        }
    }

    /// Takes the natural length of a model without bars from its start, and the natural time of one
    /// that starts fast.
    fn measure(&mut self, pose: &Pose) -> Result<(), StartError> {
        let [positions, rates] = pose.values(self.model())?;
        let natural = scales_of(self.model()).unwrap_or(self.context.scales);
        let sized = natural.sized_at(self.layout(), &positions, &rates);
        let driven = self.driven_acceleration(&positions, &sized);
        self.set_scales(sized.starting_at(self.layout(), &rates, driven));
        Ok(())
    }

    /// The largest ∂²g/∂t² at the start, in natural lengths or radians: what drives accelerate, and
    /// grounds that move.
    fn driven_acceleration(&self, positions: &[f64], scales: &Scales) -> f64 {
        let layout = self.layout();
        if !layout.timed {
            return 0.0;
        }
        let at_rest = layout.state_at(&[positions, &vec![0.0; positions.len()]].concat(), self.begin);
        let equations = self.context.system().equations(&at_rest);
        let natural = |row: usize| (equations.bias()[row] / layout.unit(row, scales.length)).abs();
        (0..layout.rows()).map(natural).filter(|it| it.is_finite()).fold(0.0, f64::max)
    }

    fn set_scales(&mut self, scales: Scales) {
        let size = |planned: &Scheduled| match planned.action {
            Action::Impulse { impulse: [x, y], .. } => x.hypot(y),
            Action::Remove(_) => 0.0,
        };
        let scales = self.plan.iter().map(size).fold(scales, Scales::struck);
        Arc::make_mut(&mut self.context).scales = scales;
    }

    pub(crate) fn started(&self) -> Result<ConsistentStart, StartError> {
        match &self.start {
            None => self.complete(&Pose::nominal()),
            Some(given) if given.tolerance == self.tolerance => Ok(given.start.clone()),
            Some(given) => self.resolve(&given.pose, given.level.as_ref()),
        }
    }

    /// The start of a pose, with the rate of an energy level where one is given.
    fn resolve(&self, pose: &Pose, level: Option<&Pose>) -> Result<ConsistentStart, StartError> {
        let from = self.complete(pose)?;
        match level {
            None => Ok(from),
            Some(level) => on_energy_of(&self.context, &from, &self.complete(level)?),
        }
    }

    fn complete(&self, pose: &Pose) -> Result<ConsistentStart, StartError> {
        start((&self.context, &self.rules.switches), pose, self.tolerance, self.begin)
    }
}

fn contact(support: &str, layout: &'static crate::model::Layout) -> Result<usize, SupportError> {
    contact_of(layout, support).map(|(i, _)| i).ok_or_else(|| unknown_support(layout, support).into())
}
