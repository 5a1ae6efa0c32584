//! One phase integrated from a state to the first event, recorded as dense output.

use crate::contact::{ContactError, refuse_singular};
use crate::event::supports;
use crate::guard::NotFinite;
use crate::integrate::{Counts, Dop853, Interpolant, StepError, Tolerance};
use crate::model::{Array, BarSystem, Form, Phase, PhaseVisitor};
use crate::moment::{At, Moment, Scene, seen};
use crate::pivot::least_pivot;
use crate::project::project;
use crate::singular::{Ahead, LOOSEST, Loops};
use crate::trajectory::Segment;
use crate::watch::{Findings, Guard, StepView, Watches};

/// Absolute tolerance against the relative one, in natural units and not below rounding: a departure from φ = 1e-4 keeps
/// its digits, a coordinate that is zero by symmetry asks for no smaller steps.
const FINENESS: f64 = 1e-4;

/// So often a phase with steps below [`CREEPING`] natural times is asked whether it creeps towards a singularity.
const STEPS: usize = 1024;
const CREEPING: f64 = 1e-9;
/// After so many of them in a row the step size is at its floor for all that a run can achieve.
const MOST_STEPS: usize = 4 * STEPS;

/// A recorded phase.
pub(crate) trait Piece<M: BarSystem> {
    /// Set, form and times.
    fn segment(&self) -> Segment;
    /// Ends of the steps, the start included.
    fn times(&self) -> Vec<f64>;
    /// Shows the motion at a time, or at the nearer end.
    fn at(&self, scene: &Scene<M>, t: f64, read: &mut dyn FnMut(&dyn Moment<M>));
    /// The full state and the reactions at a time.
    fn state_and_reactions(&self, scene: &Scene<M>, t: f64) -> (Vec<f64>, Vec<f64>);
}

struct Record<M: BarSystem, const N: usize> {
    phase: Phase<M, f64, N>,
    steps: Vec<Interpolant<f64, N>>,
    /// Singular positions of closed loops that were passed.
    crossings: Vec<f64>,
    start: [f64; N],
    t0: f64,
    t1: f64,
}

/// How a phase ended.
pub(crate) enum End {
    /// At the time it was given.
    Horizon,
    /// With these guards at zero.
    Event(Vec<Guard>),
    /// With a pivot too small to go on in this form.
    Pivot,
    /// Without reaching an event.
    Failed(StepError),
    /// Before a singular position of the loop through these joints.
    Loop(Vec<String>),
    /// Before accelerations that are all but undetermined.
    Singular(ContactError),
}

/// A phase as it went.
pub(crate) struct Outcome<M: BarSystem> {
    pub(crate) piece: Box<dyn Piece<M>>,
    /// Guards that touched zero on the way.
    pub(crate) touches: Vec<(f64, Guard)>,
    /// Times of singular positions that were passed.
    pub(crate) crossings: Vec<f64>,
    pub(crate) end: End,
    pub(crate) t: f64,
    pub(crate) state: M::State<f64>,
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
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Drive<'_, M> {
    type Output = Outcome<M>;

    fn visit<const N: usize>(mut self, phase: Phase<M, f64, N>) -> Outcome<M> {
        let start = (phase.restrict)(&self.state);
        self.watches.begin(&phase, self.scene, self.t, &start);
        let mut loops = (phase.form == Form::Projected)
            .then(|| Loops::of::<M>(phase.set, self.scene, self.tolerance))
            .flatten();
        if loops.is_some() {
            self.tolerance = self.tolerance.min(LOOSEST);
        }
        let mut record =
            Record { phase, steps: Vec::new(), crossings: Vec::new(), start, t0: self.t, t1: self.t };
        let mut touches = Vec::new();
        let (end, counts) = match self.tolerances(&record.phase) {
            Ok(tolerance) => {
                let mut integrator = Dop853::new(tolerance, self.t, start).with_end(self.horizon);
                let end = self.advance(&mut record, &mut integrator, &mut loops, &mut touches);
                (end.unwrap_or_else(End::Failed), integrator.counts())
            }
            Err(error) => (End::Failed(error), Counts::default()),
        };
        let mut state = (record.phase.embed)(&self.scene.constants, &record.reduced(record.t1));
        self.project(&record.phase, &mut state);
        let end = match (end, &mut loops) {
            (end @ (End::Failed(_) | End::Singular(_)), Some(loops)) => {
                loops.lost::<M>(self.scene, &state).map_or(end, End::Loop)
            }
            (end, _) => end,
        };
        let crossings = core::mem::take(&mut record.crossings);
        Outcome { touches, crossings, end, t: record.t1, state, counts, piece: Box::new(record) }
    }
}

impl<M: BarSystem> Drive<'_, M> {
    /// The tolerance in natural units of what the phase integrates.
    fn tolerances<const N: usize>(&self, phase: &Phase<M, f64, N>) -> Result<Tolerance<N>, StepError> {
        let units = self.scene.scales.state::<M>();
        let rounding = self.tolerance.min(2.0 * f64::EPSILON);
        let absolute = rounding.max(FINENESS * self.tolerance);
        let absolute = (phase.restrict)(&M::State::from_fn(|i| units[i] * absolute));
        Tolerance::new(self.tolerance, absolute).map_err(|_| StepError::Floor { t: self.t, h: 0.0 })
    }

    fn advance<const N: usize>(
        &mut self,
        record: &mut Record<M, N>,
        integrator: &mut Dop853<f64, N>,
        loops: &mut Option<Loops>,
        touches: &mut Vec<(f64, Guard)>,
    ) -> Result<End, StepError> {
        let mut work = vec![0.0; M::LAYOUT.coordinates.len()];
        let least = least_pivot(self.tolerance);
        let mut crept = 0;
        match loops.as_mut().map_or(Ok(None), |loops| loops.begin::<M>(self.scene, self.t, &self.state)) {
            Ok(None) => {}
            Ok(Some(first)) => integrator.jump(self.t, record.start, first),
            Err(joints) => return Ok(End::Loop(joints)),
        }
        loop {
            if record.t1 >= self.horizon {
                return Ok(End::Horizon);
            }
            let phase = &record.phase;
            let f = |y: &[f64; N]| (phase.derivative)(&self.scene.constants, phase.set, y);
            let mut step = integrator.step(f)?;
            if phase.form == Form::Projected {
                let mut state = (phase.embed)(&self.scene.constants, &step.y1);
                project::<M>(
                    &self.scene.constants,
                    phase.set,
                    &mut state,
                    self.scene.scales.length,
                    &mut work,
                );
                integrator.restart_from(&mut step, (phase.restrict)(&state), f)?;
            }
            let dense = integrator.interpolant(&step, f);
            let view = StepView { phase, scene: self.scene, dense: &dense };
            let not_finite = |NotFinite { theta }| StepError::NotFinite { t: dense.t0 + theta * dense.h };
            let Findings { touches: touched, first } = self.watches.examine(&view).map_err(not_finite)?;
            touches.extend(touched.into_iter().map(|(theta, guard)| (dense.t0 + theta * dense.h, guard)));
            record.steps.push(dense);
            match first {
                Some((theta, guards)) => {
                    record.t1 = if theta == 1.0 { step.t1 } else { step.t0 + theta * step.h };
                    return Ok(End::Event(guards));
                }
                None => record.t1 = step.t1,
            }
            crept = if step.h < CREEPING * self.scene.scales.time { crept + 1 } else { 0 };
            if crept > MOST_STEPS {
                return Err(StepError::Floor { t: step.t1, h: step.h });
            }
            if crept > 0 && record.steps.len().is_multiple_of(STEPS) {
                let state = (phase.embed)(&self.scene.constants, &step.y1);
                if let Err(singular) = refuse_singular::<M>(&self.scene.series, &state, phase.set) {
                    return Ok(End::Singular(singular));
                }
            }
            if record.t1 < self.horizon
                && phase.form == Form::Closed
                && (phase.pivot)(&self.scene.constants, &step.y1) < least
            {
                return Ok(End::Pivot);
            }
            if let Some(loops) = loops
                && let Some(end) = self.pass_singular(record, integrator, loops, touches)?
            {
                return Ok(end);
            }
        }
    }

    /// Looks out for singular positions of closed loops, and passes one that is near.
    fn pass_singular<const N: usize>(
        &mut self,
        record: &mut Record<M, N>,
        integrator: &mut Dop853<f64, N>,
        loops: &mut Loops,
        touches: &mut Vec<(f64, Guard)>,
    ) -> Result<Option<End>, StepError> {
        let (scene, t) = (self.scene, record.t1);
        let embed = |y: &[f64; N]| (record.phase.embed)(&scene.constants, y);
        let h = record.steps.last().map_or(0.0, |step| step.h);
        let next = integrator.next_step().unwrap_or(h);
        let ts = match loops.note::<M>(scene, (t, h, next), &embed(integrator.state())) {
            Ahead::Here(ts) => ts,
            Ahead::Near(end) => {
                integrator.set_end(end.min(self.horizon));
                return Ok(None);
            }
            Ahead::Regular => {
                integrator.set_end(self.horizon);
                return Ok(None);
            }
        };
        integrator.set_end(self.horizon);
        let since = record.crossings.last().copied().unwrap_or(record.t0);
        let Some(beyond) = loops.cross::<M>(scene, (since, t, ts), &|t| embed(&record.reduced(t))) else {
            return Ok(None);
        };
        let phase = &record.phase;
        let f = |y: &[f64; N]| (phase.derivative)(&scene.constants, phase.set, y);
        let ends = [*integrator.state(), (phase.restrict)(&beyond.state)];
        let dense = Interpolant::cubic((t, beyond.t - t), ends, ends.each_ref().map(f));
        // Reactions are undetermined on the way.
        let found = self.watches.examine(&StepView { phase, scene, dense: &dense }).unwrap_or_default();
        let first = found.first.filter(|(_, guards)| !guards.iter().any(|g| matches!(g, Guard::Reaction(_))));
        record.steps.push(dense);
        record.crossings.push(ts);
        if let Some((theta, guards)) = first {
            record.t1 = t + theta * (beyond.t - t);
            touches.retain(|(at, _)| *at < record.t1);
            return Ok(Some(End::Event(guards)));
        }
        record.t1 = beyond.t.min(self.horizon);
        if record.t1 >= self.horizon {
            return Ok(Some(End::Horizon));
        }
        integrator.jump(beyond.t, ends[1], 0.25 * loops.window());
        Ok(None)
    }

    fn project<const N: usize>(&self, phase: &Phase<M, f64, N>, state: &mut M::State<f64>) {
        if phase.form == Form::Projected {
            let mut work = vec![0.0; M::LAYOUT.coordinates.len()];
            project::<M>(&self.scene.constants, phase.set, state, self.scene.scales.length, &mut work);
        }
    }
}

impl<M: BarSystem, const N: usize> Record<M, N> {
    fn reduced(&self, t: f64) -> [f64; N] {
        let after = self.steps.partition_point(|step| step.t0 <= t);
        let Some(step) = self.steps.get(after.saturating_sub(1)) else { return self.start };
        let theta = (t.clamp(self.t0, self.t1) - step.t0) / step.h;
        step.at(theta.clamp(0.0, 1.0))
    }
}

impl<M: BarSystem, const N: usize> Piece<M> for Record<M, N> {
    fn segment(&self) -> Segment {
        let Phase { set, form, .. } = self.phase;
        Segment { set, closed: supports::<M>(set), form, t0: self.t0, t1: self.t1 }
    }

    fn times(&self) -> Vec<f64> {
        self.steps.iter().map(|step| step.t0).chain([self.t1]).collect()
    }

    fn at(&self, scene: &Scene<M>, t: f64, read: &mut dyn FnMut(&dyn Moment<M>)) {
        let t = t.clamp(self.t0, self.t1);
        read(&At::new(&self.phase, &scene.constants, t, self.reduced(t)));
    }

    fn state_and_reactions(&self, scene: &Scene<M>, t: f64) -> (Vec<f64>, Vec<f64>) {
        let at = At::new(&self.phase, &scene.constants, t, self.reduced(t));
        (seen::<M>(at.state()).to_vec(), at.reactions().as_ref().to_vec())
    }
}
