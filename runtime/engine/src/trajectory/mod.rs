//! A motion as computed: phases with dense output, and events.

mod dissipation;
mod extrema;
mod log;
pub(crate) mod observe;
mod recorded_phase;
mod work;

use core::fmt;

use std::sync::{Arc, OnceLock};

use crate::assembly::find_below;
use crate::contact::compute_joint_impulse;
use crate::context::{RunContext, Scales};
use crate::error::OutputError;
use crate::event::{Event, Guard};
use crate::expression::{Condition, Output, Switches, unrounded};
use crate::integrate::Counts;
use crate::integration::method::Choice;
use crate::integration::phase_point::PhasePoint;
use crate::model::{ContactSet, Form, Layout, Quantity};
use crate::numerics::root_isolation;
use crate::system::Model;

pub use crate::numerics::root_isolation::ExtremumKind;
use dissipation::Dissipation;
use extrema::Way;
pub use log::{LogEntry, LoggedDecision};
pub(crate) use recorded_phase::RecordedPhase;
pub(crate) use work::{Work, blur};

/// A motion from its start to the event that ended it. Of a run that was only observed it has the
/// events and what it ends with, and no motion in between.
pub struct Trajectory {
    pub(crate) context: Arc<RunContext>,
    pub(crate) phases: Vec<RecordedPhase>,
    /// The motion before an impact or an impulse at the start.
    pub(crate) before_start: Option<RecordedPhase>,
    /// The end of the last phase of a run that was only observed.
    pub(crate) last_phase: Option<RecordedPhase>,
    /// The guards that ended each phase; none where a planned time did.
    pub(crate) ends: Vec<Vec<Guard>>,
    pub(crate) conditions: Vec<Condition>,
    pub(crate) impulses: Vec<AppliedImpulse>,
    pub(crate) events: Vec<Event>,
    pub(crate) log: Vec<LogEntry>,
    pub(crate) statistics: Statistics,
    pub(crate) tolerance: f64,
    pub(crate) end: f64,
    pub(crate) last: Vec<f64>,
    /// What it has lost, once that is asked for.
    dissipation: OnceLock<Dissipation>,
}

/// An impulse that was applied.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AppliedImpulse {
    /// When, s.
    pub t: f64,
    /// The point that it acted at, by its place in the layout.
    pub point: usize,
    /// Its components, N s.
    pub impulse: [f64; 2],
}

/// The work that a run took.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Statistics {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of the equations of motion by the integrator.
    pub evaluations: u64,
    /// Evaluations of their Jacobian.
    pub jacobians: u64,
}

impl Statistics {
    pub(crate) fn add(&mut self, counts: Counts) {
        self.steps += counts.accepted;
        self.rejected += counts.rejected;
        self.evaluations += counts.evaluations;
        self.jacobians += counts.jacobians;
    }
}

/// A part of a motion with one set of closed contacts.
#[derive(Debug, Clone, PartialEq)]
pub struct Segment {
    /// The closed contacts.
    pub set: ContactSet,
    /// Independent ones among them, which hold the others too: those that were integrated.
    pub active_basis: ContactSet,
    /// Their supports.
    pub closed: Vec<&'static str>,
    /// The entries of [`Layout::switches`] whose springs and loads act.
    pub acting: Vec<usize>,
    /// In which form it was integrated.
    pub form: Form,
    /// By which method, and why by that.
    pub choice: Choice,
    /// Its start.
    pub t0: f64,
    /// Its end.
    pub t1: f64,
}

/// A time at which a motion is looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Instant {
    /// When.
    pub t: f64,
    /// Whether it is the side before an impact or an impulse, at which velocities jump.
    pub is_before: bool,
}

/// A turning point of an output.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extremum {
    /// When.
    pub t: f64,
    /// The value there.
    pub value: f64,
    /// Whether it is a minimum.
    pub minimum: bool,
}

impl Trajectory {
    pub(crate) fn empty(context: Arc<RunContext>, tolerance: f64, (end, last): (f64, Vec<f64>)) -> Self {
        Self {
            context,
            phases: Vec::new(),
            before_start: None,
            last_phase: None,
            ends: Vec::new(),
            conditions: Vec::new(),
            impulses: Vec::new(),
            events: Vec::new(),
            log: Vec::new(),
            statistics: Statistics::default(),
            tolerance,
            end,
            last,
            dissipation: OnceLock::new(),
        }
    }

    /// What happened, in order of time; the last event ended the run.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// Names of the model.
    pub fn layout(&self) -> &'static Layout {
        self.context.layout()
    }

    /// The phases in order of time.
    pub fn segments(&self) -> Vec<Segment> {
        self.phases.iter().map(RecordedPhase::segment).collect()
    }

    /// Time of the start.
    pub fn start_time(&self) -> f64 {
        self.phases.first().map_or(0.0, |phase| phase.t0)
    }

    /// Time of the end.
    pub fn end_time(&self) -> f64 {
        self.end
    }

    /// Times of the start and of the end.
    pub fn interval(&self) -> [f64; 2] {
        [self.start_time(), self.end_time()]
    }

    /// The full state at a time, coordinates then rates; at the nearer end for times outside the
    /// run.
    pub fn state(&self, t: f64) -> Vec<f64> {
        let at = self.point(t).filter(|_| !self.phases.is_empty());
        let state = at.map(|point| self.context.layout().public_state(point.state()).to_vec());
        state.unwrap_or_else(|| self.last.clone())
    }

    /// An expression of the model's names as an output to be evaluated.
    ///
    /// # Errors
    /// It is no expression, or names something that the model does not have.
    pub fn output(&self, text: &str) -> Result<Output, OutputError> {
        Output::parse(self.layout(), text)
    }

    /// An expression of the model's names as a function of time; at an event it has the value after
    /// it.
    ///
    /// # Errors
    /// It is no expression, or names something that the model does not have.
    pub fn function(&self, text: &str) -> Result<impl Fn(f64) -> f64 + use<'_>, OutputError> {
        let output = self.output(text)?;
        Ok(move |t| self.value(&output, t))
    }

    /// An output at a time; NaN if nothing was computed, or kept, as of a run that was only
    /// observed before its end. At an event it has the value after it.
    pub fn value(&self, output: &Output, t: f64) -> f64 {
        let Some(point) = self.point(t) else { return f64::NAN };
        let point = match self.phase_at(t) {
            Some(k) => self.with_history(output, k, point),
            None => point,
        };
        output.evaluate(&self.context, &point)
    }

    /// The full state at the end.
    pub fn final_state(&self) -> Vec<f64> {
        self.last.clone()
    }

    /// The supports that have gone round an end of their edges and are below these in a state of
    /// the motion: its coordinates do not tell, and a start there says `below(P)` = 1 of each.
    pub fn find_below(&self, state: &[f64], t: f64) -> Vec<&'static str> {
        let layout = self.layout();
        if layout.feet() == 0 {
            return Vec::new();
        }
        let Ok(switches) = Switches::from_layout(layout) else { return Vec::new() };
        let below = find_below((&self.context, &switches), self.tolerance, state, t);
        below.iter().map(|contact| layout.contacts[contact].supports[0]).collect()
    }

    /// Ends of the integrator's steps in order of time; between two neighbours the motion is one
    /// polynomial.
    pub fn times(&self) -> Vec<f64> {
        let mut times: Vec<f64> = self.phases.iter().flat_map(RecordedPhase::times).collect();
        times.dedup();
        times
    }

    /// The times of [`times`](Self::times); those at which velocities jump twice, before the jump
    /// and after it.
    pub fn instants(&self) -> Vec<Instant> {
        let mut jumps =
            self.events.iter().filter(|event| event.before.is_some()).map(|event| event.t).peekable();
        let start = self.start_time();
        let mut instants = Vec::new();
        for t in self.times() {
            while jumps.next_if(|jump| *jump < t).is_some() {}
            let is_begun = t > start || self.before_start.is_some();
            let is_jump = is_begun && jumps.peek() == Some(&t);
            instants.extend(is_jump.then_some(Instant { t, is_before: true }));
            instants.push(Instant { t, is_before: false });
        }
        instants
    }

    /// The full state, coordinates then rates, at each of the [`instants`](Self::instants) in
    /// order.
    pub fn states(&self) -> impl Iterator<Item = (Instant, Vec<f64>)> {
        self.instants().into_iter().map(|instant| (instant, self.state_at(instant)))
    }

    /// The values of some outputs, a row for each of the times; at an event they are those after
    /// it.
    ///
    /// ```
    /// # use liftoff::prelude::*;
    /// # #[derive(BarSystem)]
    /// # #[gravity(g)]
    /// # #[bar(OA, mass = m, length = l)]
    /// # #[pin(O = (0, 0))]
    /// # #[figure(A = (0, -l))]
    /// # #[coordinate(phi = angle(OA), from = down)]
    /// # struct Pendulum { m: f64, l: f64, g: f64 }
    /// # let pendulum = Pendulum { m: 1.0, l: 1.0, g: 9.81 };
    /// let run = Simulation::new(&pendulum)?.start(Pose::new("phi", 1.0))?.limit(2.0).run()?;
    /// let rows = run.sample((0..=20).map(|i| 0.1 * f64::from(i)), &[run.output("phi")?, run.output("x(A)")?]);
    /// assert!(rows.len() == 21 && rows[0] == [1.0, 1.0_f64.sin()]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn sample(&self, times: impl IntoIterator<Item = f64>, outputs: &[Output]) -> Vec<Vec<f64>> {
        let row = |t| outputs.iter().map(|output| self.value(output, t)).collect();
        times.into_iter().map(row).collect()
    }

    /// The full state at an instant.
    pub fn state_at(&self, instant: Instant) -> Vec<f64> {
        match self.point_before(instant) {
            Some(point) => self.context.layout().public_state(point.state()).to_vec(),
            None => self.state(instant.t),
        }
    }

    /// An output at an instant.
    pub fn value_at(&self, output: &Output, instant: Instant) -> f64 {
        let point = match (self.phase_before(instant), self.point_before(instant)) {
            (Some(k), Some(point)) => self.with_history(output, k, point),
            (None, Some(point)) => point,
            (_, None) => return self.value(output, instant.t),
        };
        output.evaluate(&self.context, &point)
    }

    /// The motion at an instant before a jump; none of other instants.
    fn point_before(&self, instant: Instant) -> Option<PhasePoint> {
        match self.phase_before(instant) {
            Some(k) => Some(self.phases[k].interpolate_on_constraints(&self.context, instant.t)),
            None => self.point_before_start().filter(|_| instant.is_before),
        }
    }

    fn point_before_start(&self) -> Option<PhasePoint> {
        let phase = self.before_start.as_ref()?;
        Some(phase.interpolate_on_constraints(&self.context, phase.t0).having_lost(0.0))
    }

    /// The phase that ends at an instant before a jump; none of other instants.
    fn phase_before(&self, Instant { t, is_before }: Instant) -> Option<usize> {
        let before = self.phases.partition_point(|phase| phase.t0 < t).checked_sub(1);
        before.filter(|_| is_before)
    }

    /// The turning points of an output, in order of time, those at events among them: where a
    /// velocity jumps, its values before and after. Those that stand out by less than the error
    /// bound do not count.
    pub fn extrema(&self, output: &Output) -> Vec<Extremum> {
        let largest = self.times().iter().fold(0.0, |most: f64, &t| most.max(self.value(output, t).abs()));
        let delta = (10.0 * self.tolerance).max(64.0 * f64::EPSILON) * largest;
        let before = self.point_before_start();
        let start = before.map(|point| (point.t(), output.evaluate(&self.context, &point)));
        let mut ways: Vec<Way> =
            start.map(|end| Way { ends: [end; 2], turns: Vec::new() }).into_iter().collect();
        for (k, phase) in self.phases.iter().enumerate() {
            let ends = [phase.t0, phase.t1].map(|t| (t, self.value_in(output, k, t)));
            let mut turns = Vec::new();
            let times: Vec<f64> = phase.times().collect();
            for span in times.windows(2) {
                let [t0, t1] = [span[0], span[1]];
                let at = |theta: f64| t0 + theta * (t1 - t0);
                let value = |theta: f64| self.value_in(output, k, at(theta));
                // An output that is not finite somewhere in a step, tan φ say, has its turning
                // points elsewhere.
                let _ = root_isolation::extrema(value, delta, |extremum| {
                    let minimum = extremum.kind == ExtremumKind::Minimum;
                    turns.push(Extremum { t: at(extremum.theta), value: extremum.value, minimum });
                });
            }
            ways.push(Way { ends, turns });
        }
        extrema::along(ways, delta)
    }

    /// The least and the greatest value of an output over the run, at turning points and at the
    /// ends of steps, before and after events; none where nothing was computed or no value is
    /// finite.
    pub fn range(&self, output: &Output) -> Option<[f64; 2]> {
        let ends =
            self.phases.iter().enumerate().flat_map(|(k, phase)| {
                phase.times().map(|t| self.value_in(output, k, t)).collect::<Vec<_>>()
            });
        let turning = self.extrema(output).into_iter().map(|extremum| extremum.value);
        let start = self.point_before_start().map(|point| output.evaluate(&self.context, &point));
        let values = ends.chain(turning).chain(start).filter(|value| value.is_finite());
        values.fold(None, |range: Option<[f64; 2]>, x| {
            Some(range.map_or([x, x], |[a, b]| [a.min(x), b.max(x)]))
        })
    }

    /// The guards that ended a segment, by its place; none where a planned time did.
    pub fn ended_by(&self, segment: usize) -> &[Guard] {
        self.ends.get(segment).map_or(&[], Vec::as_slice)
    }

    /// The conditions that were watched: [`Guard::Condition`] counts them.
    pub fn conditions(&self) -> &[Condition] {
        &self.conditions
    }

    /// The impulses that were applied.
    pub fn impulses(&self) -> &[AppliedImpulse] {
        &self.impulses
    }

    /// The impulses of joints and drives at an impact of this motion, N s, of couples N m s, by the
    /// names of their forces: `fx(O, OA)`, `couple(AB, BC)`. None of other events, nor where an
    /// impulse was applied, nor of models without such forces.
    pub fn joint_impulses(&self, event: &Event) -> Vec<(&'static str, f64)> {
        let layout = self.layout();
        let Some(before) = event.before.as_ref().filter(|before| !before.impulses.is_empty()) else {
            return Vec::new();
        };
        let n = layout.coordinates.len();
        let change: Vec<f64> = (n..2 * n).map(|i| event.state[i] - before.state[i]).collect();
        let state = layout.state_at(&before.state, event.t);
        let of_joint = |(_, quantity): &(usize, &Quantity)| quantity.kind.is_of_joint();
        let joints = layout.quantities.iter().enumerate().filter(of_joint);
        let impulse = |(entry, quantity): (usize, &Quantity)| {
            let system = self.context.system();
            (quantity.name, compute_joint_impulse(system, entry, &state, &change, &before.impulses))
        };
        joints.map(impulse).collect()
    }

    /// Coordinates and rates of a state, then dependent angles and their rates, as
    /// [`Layout::names_of_motion`] names them.
    pub fn with_dependent(&self, state: &[f64]) -> Vec<f64> {
        self.layout().motion(self.parameters(), state)
    }

    /// The same for print: zero in place of what is nothing but rounding in natural units.
    pub fn unrounded(&self, motion: &[f64]) -> Vec<f64> {
        let (n, dependent) = (self.layout().coordinates.len(), self.layout().dependent.len());
        let unit = |i: usize| match i {
            _ if i < 2 * n => self.scales().entry(self.layout(), i),
            _ if i < 2 * n + dependent => 1.0,
            _ => 1.0 / self.scales().time,
        };
        motion.iter().enumerate().map(|(i, x)| unrounded(*x, unit(i))).collect()
    }

    /// The tolerance of the run.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The natural units of the run.
    pub fn scales(&self) -> Scales {
        self.context.scales
    }

    /// The work that the run took.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// Whether friction, dampers or impacts may have taken energy.
    pub fn dissipates(&self) -> bool {
        let struck = || self.events.iter().any(|event| !event.impulses.is_empty());
        !self.layout().frictions.is_empty() || self.scales().damped || struck()
    }

    /// Decisions of the simulation that are no events: a change of form, say.
    pub fn log(&self) -> &[LogEntry] {
        &self.log
    }

    /// Parameters of the model, in declaration order.
    pub fn parameters(&self) -> &[f64] {
        &self.context.model.parameters
    }

    /// The model that moved.
    pub fn model(&self) -> &Model {
        &self.context.model
    }

    /// An output at a time of a phase, or at the nearer end.
    fn value_in(&self, output: &Output, k: usize, t: f64) -> f64 {
        let point = self.with_history(output, k, self.phases[k].interpolate(t));
        output.evaluate(&self.context, &point)
    }

    /// A point of a phase with what an output reads of the motion before.
    fn with_history(&self, output: &Output, k: usize, point: PhasePoint) -> PhasePoint {
        if !output.reads_history() {
            return point;
        }
        let dissipation = self.dissipation.get_or_init(|| Dissipation::compute(self));
        let lost = dissipation.evaluate(self, k, point.t());
        point.having_lost(lost)
    }

    /// The recorded phase of a time; at an event the one after it.
    fn phase_at(&self, t: f64) -> Option<usize> {
        let last = self.phases.len().checked_sub(1)?;
        Some(self.phases.partition_point(|phase| phase.t0 <= t).saturating_sub(1).min(last))
    }

    fn point(&self, t: f64) -> Option<PhasePoint> {
        let phase = self
            .phase_at(t)
            .map(|k| &self.phases[k])
            .or_else(|| self.last_phase.as_ref().filter(|last| t >= last.t1));
        phase.map(|phase| phase.interpolate_on_constraints(&self.context, t))
    }
}

impl fmt::Debug for Trajectory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Trajectory").field("events", &self.events).finish_non_exhaustive()
    }
}
