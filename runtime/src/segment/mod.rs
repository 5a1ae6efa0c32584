//! One phase integrated from a state to the first event, recorded as dense output.

mod advance;
mod record;
mod singular;

pub(crate) use record::Piece;

use core::sync::atomic::AtomicBool;

use crate::contact::ContactError;
use crate::integrate::{Counts, Dense, Progress, StepError, Tolerance, ToleranceError};
use crate::method::{Begun, Problem};
use crate::model::{Array, BarSystem, Form, Phase};
use crate::moment::Scene;
use crate::observe::Observer;
use crate::project::project;
use crate::scales::Scales;
use crate::singular::{LOOSEST, Loops};
use crate::watch::{Guard, StepView, Watches};
use record::Record;

/// Absolute tolerance against the relative one, in natural units and not below rounding: a departure from φ = 1e-4 keeps
/// its digits, a coordinate that is zero by symmetry asks for no smaller steps.
const FINENESS: f64 = 1e-4;

/// A step over which guards are watched, in natural times: longer ones would drown a short flight at their start in the
/// rounding of the values at their end. Once a phase has lasted longer, so may its steps.
const LONGEST: f64 = 1.0;

/// How a phase ended.
pub(crate) enum End {
    /// At the time it was given.
    Horizon,
    /// With these guards at zero.
    Event(Vec<Guard>),
    /// With a pivot too small to go on in this form.
    Pivot,
    /// Because it was asked to.
    Cancelled,
    /// Without reaching an event.
    Failed(StepError),
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
    pub(crate) reactions: Vec<f64>,
}

/// A phase as it went.
pub(crate) struct Outcome<M: BarSystem> {
    /// What was recorded of it, if it took time.
    pub(crate) piece: Option<Box<dyn Piece<M>>>,
    pub(crate) touches: Vec<Touch>,
    /// Times of singular positions that were passed.
    pub(crate) crossings: Vec<f64>,
    pub(crate) end: End,
    pub(crate) t: f64,
    pub(crate) state: M::State<f64>,
    pub(crate) reactions: M::Reactions<f64>,
    pub(crate) counts: Counts,
}

/// What to integrate.
pub(crate) struct Drive<'a, M: BarSystem> {
    pub(crate) scene: &'a Scene<M>,
    pub(crate) watches: Watches<'a>,
    pub(crate) tolerance: f64,
    pub(crate) t: f64,
    pub(crate) horizon: f64,
    pub(crate) state: M::State<f64>,
    pub(crate) observer: &'a mut dyn Observer,
    /// Once true, no more steps are made.
    pub(crate) cancel: Option<&'static AtomicBool>,
}

/// Makes the integration of a phase.
type Begin<'b, M, const N: usize> = &'b dyn for<'a> Fn(Problem<'a, M, N>) -> Begun<'a, N>;

impl<M: BarSystem> Drive<'_, M> {
    pub(crate) fn run<const N: usize>(mut self, phase: Phase<M, f64, N>, begin: Begin<M, N>) -> Outcome<M> {
        let start = (phase.restrict)(&self.state);
        let dense = Dense::still(self.t, start);
        self.watches.begin(&StepView::new(&phase, self.scene, &dense));
        let mut loops = (phase.form == Form::Projected)
            .then(|| Loops::of::<M>(phase.set, self.scene, self.tolerance))
            .flatten();
        if loops.is_some() {
            self.tolerance = self.tolerance.min(LOOSEST);
        }
        let keeps = loops.is_some() || self.observer.records();
        let mut record = Record::new(phase, (self.t, start), keeps);
        let mut touches = Vec::new();
        let Scene { constants, parameters, .. } = self.scene;
        let (end, counts) = match tolerances(&phase, &self.scene.scales, self.tolerance) {
            Ok(tolerance) => {
                let progress = Progress::new(tolerance, self.t, start).with_end(self.horizon);
                let progress = match self.watches.is_empty() {
                    true => progress,
                    false => progress.with_longest_step(LONGEST * self.scene.scales.time),
                };
                let rates = |y: &[f64; N]| (phase.derivative)(constants, phase.set, y);
                let Scales { time, damped, .. } = self.scene.scales;
                let problem =
                    Problem { phase: &phase, constants, parameters, time, damped, rates: &rates, progress };
                let Begun { choice, mut stepper } = begin(problem);
                record.choice = choice;
                let end = self.advance(&mut record, &mut *stepper, &mut loops, &mut touches);
                (end.unwrap_or_else(End::Failed), stepper.progress().counts())
            }
            Err(_) => (End::Failed(StepError::Floor { t: self.t, h: 0.0 }), Counts::default()),
        };
        let reduced = record.reduced(record.t1);
        let mut state = (phase.embed)(constants, &reduced);
        self.project(&phase, &mut state);
        let reactions = (phase.reactions)(constants, phase.set, &reduced);
        let end = match (end, &mut loops) {
            (end @ (End::Failed(_) | End::Singular(_)), Some(loops)) => {
                loops.lost::<M>(self.scene, &state).map_or(end, End::Loop)
            }
            (end, _) => end,
        };
        let crossings = core::mem::take(&mut record.crossings);
        let t = record.t1;
        // What an event at the very end of the run leaves is kept as a phase of no duration.
        let kept = self.observer.records() && (t > record.t0 || matches!(end, End::Horizon));
        let piece = kept.then(|| Box::new(record) as Box<dyn Piece<M>>);
        Outcome { piece, touches, crossings, end, t, state, reactions, counts }
    }

    /// Brings the state of a projected phase back on its constraints.
    fn project<const N: usize>(&self, phase: &Phase<M, f64, N>, state: &mut M::State<f64>) {
        if phase.form == Form::Projected {
            let mut work = vec![0.0; M::LAYOUT.coordinates.len()];
            project::<M, _>(&self.scene.constants, phase.set, state, self.scene.scales.length, &mut work);
        }
    }
}

/// The tolerance in natural units of what a phase integrates.
pub(crate) fn tolerances<M: BarSystem, const N: usize>(
    phase: &Phase<M, f64, N>,
    scales: &Scales,
    tolerance: f64,
) -> Result<Tolerance<N>, ToleranceError> {
    let units = scales.state::<M>();
    let absolute = tolerance.min(2.0 * f64::EPSILON).max(FINENESS * tolerance);
    Tolerance::new(tolerance, (phase.restrict)(&M::State::from_fn(|i| units[i] * absolute)))
}
