//! One phase integrated from a state to the first event, recorded as dense output.

mod advance;
mod paradox;
mod record;
mod singular;

pub(crate) use record::LastStep;

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use crate::audit::Finding;
use crate::contact::ContactError;
use crate::context::{Numbers, RunContext, Scales, reduce};
use crate::event::detection::{Broken, EventDetector, Guard, KnownAffineGuards, Signals, StepView};
use crate::integrate::{Counts, StepError};
use crate::integration::form_selection::eliminates;
use crate::integration::method::{Method, MethodChanges, Problem, StartedStepper};
use crate::integration::phase_point::PhasePoint;
use crate::integration::singular::{ROUNDED, SingularityMonitor};
use crate::model::{ContactSet, Energy, Form};
use crate::numerics::zero::roundoff;
use crate::simulation::parts::Parts;
use crate::simulation::{Allowance, Exhausted};
use crate::system::{DenseOutput, InitialValueProblem, PhaseEquations};
use crate::trajectory::observe::Observer;
use crate::trajectory::{LogEntry, LoggedDecision, RecordedPhase, Work};
use record::Recording;
use smallvec::smallvec;

/// Ratio of the absolute tolerance, in natural units and not below rounding, to the relative one: a
/// motion that starts from φ = 1e-4 keeps its relative accuracy, and a coordinate that is zero by
/// symmetry does not shrink the steps.
const FINENESS: f64 = 1e-4;

/// The longest step while guards are watched, in natural times: over a longer one a short flight at
/// its start would be lost in the rounding of the values at its end. A phase that has lasted longer
/// may make steps as long as it has lasted; one that begins with a flight, as long as that will be
/// by its height and the natural acceleration, and a little more, so that it lands.
const LONGEST: f64 = 1.0;
const LANDED: f64 = 1.0625;

/// How a phase ended.
pub(crate) enum Termination {
    /// At the time it was given.
    Horizon,
    /// With these guards at zero.
    Event(Vec<Guard>),
    /// With a pivot too small to go on in this form.
    Pivot,
    /// At the border of Painlevé's region, where no reaction holds a contact that slides.
    Paradox,
    /// Because it was asked to.
    Cancelled,
    /// With nothing left of its budget.
    Exhausted(Exhausted),
    /// Without reaching an event.
    Failed(StepError),
    /// Where a drive is not smooth.
    Drive(Broken),
    /// With a projection that would make the motion jump.
    Seam(Finding),
    /// Before a singular position of the loop through these joints.
    Loop(Vec<String>),
    /// Before accelerations that are all but undetermined.
    Singular(ContactError),
}

/// A guard that touched zero on the way.
pub(crate) struct Touch {
    pub(crate) t: f64,
    pub(crate) guard: Guard,
    /// Whether it may as well have crossed, for all that the tolerance tells.
    pub(crate) undecided: bool,
    /// Coordinates, then rates.
    pub(crate) state: Vec<f64>,
    pub(crate) energy: Energy<f64>,
    pub(crate) reactions: Vec<f64>,
}

/// A phase as it went.
pub(crate) struct PhaseOutcome {
    /// What was recorded of it, if it took time: all of it, or its last step.
    pub(crate) recorded: Option<RecordedPhase>,
    pub(crate) touches: Vec<Touch>,
    /// Singular positions that were passed, guards that were found to be noise.
    pub(crate) log: Vec<LogEntry>,
    pub(crate) end: Termination,
    pub(crate) t: f64,
    pub(crate) state: Vec<f64>,
    /// The state as it was recorded, before its projection.
    pub(crate) ended: Vec<f64>,
    pub(crate) reactions: Vec<f64>,
    pub(crate) counts: Counts,
    /// Open contacts that close only after they have come back.
    pub(crate) below: ContactSet,
    /// What loads, dampers and drives have done.
    pub(crate) work: Work,
    /// Bytes of what was recorded.
    pub(crate) memory: usize,
}

/// A phase to integrate.
pub(crate) struct PhaseRun<'a> {
    pub(crate) context: &'a RunContext,
    pub(crate) phase: Arc<dyn PhaseEquations>,
    /// The closed contacts: those of the phase, and those that depend on them.
    pub(crate) closed: ContactSet,
    pub(crate) detector: EventDetector<'a>,
    /// What loads and drives follow.
    pub(crate) signals: Signals<'a>,
    pub(crate) tolerance: f64,
    pub(crate) t: f64,
    pub(crate) horizon: f64,
    pub(crate) state: Vec<f64>,
    /// How far it has come.
    pub(crate) progress: Progress,
    pub(crate) observer: &'a mut dyn Observer,
    /// The affine guards of the run, until this phase has taken its own.
    pub(crate) affine: Option<&'a mut KnownAffineGuards>,
    pub(crate) parts: Parts,
    pub(crate) limits: Limits<'a>,
}

/// What may end a phase from outside.
pub(crate) struct Limits<'a> {
    /// Once true, no more steps are made.
    pub(crate) cancel: Option<&'a AtomicBool>,
    pub(crate) allowance: Allowance,
}

/// What a phase has brought so far.
#[derive(Default)]
pub(crate) struct Progress {
    /// Steps taken back in a row because a guard turns too often.
    unresolved: u32,
    log: Vec<LogEntry>,
    /// What loads, dampers and drives have done.
    work: Work,
    /// Whether nobody looks into the steps, so that only their ends are needed.
    is_unseen: bool,
    /// Whether the phase ends within the step across a singular position, where nothing can be
    /// projected.
    bridged: bool,
    /// Room for a reduced state.
    reduced: Numbers,
}

impl PhaseRun<'_> {
    /// Integrates up to the first event.
    pub(crate) fn run(mut self, method: &dyn Method) -> PhaseOutcome {
        let phase = Arc::clone(&self.phase);
        let mut start = reduce(&*phase, &self.state);
        self.detector.begin(&StepView::new(&phase, self.context, &DenseOutput::still(self.t, &start)));
        let mut loops = (phase.info().form == Form::Multipliers)
            .then(|| SingularityMonitor::new(phase.info().set, self.context, self.tolerance))
            .flatten();
        let keeps = self.observer.records();
        let is_blind = self.observer.is_blind() && self.context.is_conservative();
        let is_blind = is_blind && loops.is_none() && !eliminates(&*phase);
        self.progress.is_unseen = self.detector.is_empty() && !keeps && is_blind;
        let mut recording = Recording::new((Arc::clone(&phase), self.closed), (self.t, start.clone()), keeps);
        let mut touches = Vec::new();
        let mut counts = Counts::default();
        let end = loop {
            let tolerance = self.tolerance;
            let (end, more) = self.integrate(method, &start, &mut recording, &mut loops, &mut touches);
            counts = counts + more;
            if self.tolerance >= tolerance {
                break end;
            }
            recording.phase.reduced(recording.phase.t1, &mut start);
        };
        self.finish((end, counts), recording, loops, touches)
    }

    /// Integrates from where the recording ends, until the end or until a singular position asks
    /// for a finer tolerance.
    fn integrate(
        &mut self,
        method: &dyn Method,
        start: &[f64],
        recording: &mut Recording,
        loops: &mut Option<SingularityMonitor>,
        touches: &mut Vec<Touch>,
    ) -> (Termination, Counts) {
        let phase = Arc::clone(&self.phase);
        let least = if loops.is_some() { ROUNDED } else { 0.0 };
        let absolute = absolute_tolerance(&*phase, &self.context.scales, (self.tolerance, least));
        let Some(begun) = self.begin(&*phase, method, (recording.phase.t1, start, &absolute)) else {
            return (Termination::Failed(StepError::Floor { t: self.t, h: 0.0 }), Counts::default());
        };
        let StartedStepper { choice, mut stepper, switches } = begun;
        recording.phase.choice = choice;
        let end = self.advance(recording, &mut *stepper, loops, touches);
        self.log_switches(&switches, recording.phase.t1);
        let failed = |error: StepError| {
            let mut last: Numbers = smallvec![0.0; phase.info().entries];
            recording.phase.reduced(recording.phase.t1, &mut last);
            let otherwise = || self.break_near(error).unwrap_or(Termination::Failed(error));
            if self.is_at_border(&last) { Termination::Paradox } else { otherwise() }
        };
        (end.unwrap_or_else(failed), stepper.counts())
    }

    fn begin<'p>(
        &self,
        phase: &'p dyn PhaseEquations,
        method: &dyn Method,
        (t, start, absolute): (f64, &'p [f64], &'p [f64]),
    ) -> Option<StartedStepper<'p>> {
        let Scales { time, damped, .. } = self.context.scales;
        let longest = (!self.detector.is_empty()).then(|| time * LONGEST.max(LANDED * self.flight()));
        let (end, relative) = (self.horizon, self.tolerance);
        let tightness = 1.0;
        let problem = InitialValueProblem { phase, t, start, end, relative, absolute, tightness, longest };
        let problem = Problem { problem, time, damped };
        let begun = method.begin(&problem)?;
        Some(match self.parts.cut {
            Some(cut) => cut(begun, &problem),
            None => begun,
        })
    }

    /// The time of the shortest flight that begins with the phase, in natural times: T² = 8 H/g.
    fn flight(&self) -> f64 {
        (8.0 * self.detector.lowest_flight() / self.context.scales.length).sqrt()
    }

    /// Logs the changes of the method up to the end of the phase.
    fn log_switches(&mut self, switches: &MethodChanges, end: f64) {
        let made = switches.take().into_iter().filter(|(t, _)| *t <= end);
        self.progress
            .log
            .extend(made.map(|(t, choice)| LogEntry { t, decision: LoggedDecision::Method(choice) }));
        self.progress.log.sort_by(|a, b| a.t.total_cmp(&b.t));
    }

    fn finish(
        &mut self,
        (end, counts): (Termination, Counts),
        recording: Recording,
        mut loops: Option<SingularityMonitor>,
        touches: Vec<Touch>,
    ) -> PhaseOutcome {
        let (phase, t) = (Arc::clone(&self.phase), recording.phase.t1);
        let mut reduced: Numbers = smallvec![0.0; phase.info().entries];
        recording.phase.reduced(t, &mut reduced);
        let mut state = core::mem::take(&mut self.state);
        phase.embed(&reduced, &mut state);
        let ended = state.clone();
        if !self.progress.bridged {
            self.project(&*phase, &mut state);
        }
        let reactions = self.reactions(t, reduced);
        let end = match (end, &mut loops) {
            (end @ Termination::Failed(StepError::Constant { .. }), _) => end,
            (
                end @ (Termination::Failed(_) | Termination::Singular(_) | Termination::Seam(_)),
                Some(loops),
            ) => loops.diagnose(self.context, &state).map_or(end, Termination::Loop),
            (end, _) => end,
        };
        // What an event at the very end of the run leaves is kept as a phase of no duration.
        let kept = t > recording.phase.t0 || matches!(end, Termination::Horizon);
        let memory = if kept { recording.whole_memory() } else { 0 };
        let recorded = kept.then_some(recording.phase);
        PhaseOutcome {
            recorded,
            touches,
            log: core::mem::take(&mut self.progress.log),
            end,
            t,
            state,
            ended,
            reactions,
            counts,
            below: self.detector.below(),
            work: self.progress.work,
            memory,
        }
    }

    /// Those at the end; none where nothing is closed.
    fn reactions(&self, t: f64, reduced: Numbers) -> Vec<f64> {
        let layout = self.context.layout();
        if self.closed.is_empty() && !layout.has_hinges() {
            return vec![0.0; layout.reactions()];
        }
        PhasePoint::new(Arc::clone(&self.phase), self.closed, t, reduced).reactions().to_vec()
    }

    /// Brings the state of a projected phase back on its constraints.
    fn project(&self, phase: &dyn PhaseEquations, state: &mut [f64]) {
        if phase.info().form == Form::Multipliers {
            self.context.system().project(phase.info().set, state, self.context.scales.length);
        }
    }
}

/// The absolute tolerance of each entry that a phase integrates.
pub(crate) fn absolute_tolerance(
    phase: &dyn PhaseEquations,
    scales: &Scales,
    (tolerance, least): (f64, f64),
) -> Numbers {
    let absolute = tolerance.min(roundoff(2.0)).max(FINENESS * tolerance).max(least);
    let layout = phase.system().layout();
    phase.kept().iter().map(|&entry| scales.entry(layout, entry) * absolute).collect()
}
