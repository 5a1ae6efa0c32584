//! A phase as dense output.

use crate::event::supports;
use crate::integrate::Dense;
use crate::method::Choice;
use crate::model::{Array, BarSystem, Phase};
use crate::moment::{At, Moment, Scene, seen};
use crate::observe::Step;
use crate::trajectory::Segment;

/// A recorded phase.
pub(crate) trait Piece<M: BarSystem> {
    /// Set, form and times.
    fn segment(&self) -> Segment;
    /// Ends of the steps, the start included.
    fn times(&self) -> Vec<f64>;
    /// Shows the motion at a time, or at the nearer end.
    fn at(&self, scene: &Scene<M>, t: f64, read: &mut dyn FnMut(&dyn Moment<M>));
}

/// A phase while it is integrated.
pub(super) struct Record<M: BarSystem, const N: usize> {
    pub phase: Phase<M, f64, N>,
    pub choice: Choice,
    /// All steps, or the last one.
    pub steps: Vec<Dense<f64, N>>,
    pub keeps: bool,
    /// Where the phase has each entry of the full state, if it has it.
    pub places: Vec<Option<usize>>,
    /// Singular positions of closed loops that were passed.
    pub crossings: Vec<f64>,
    pub start: [f64; N],
    /// The state at `t1`, where no step is kept.
    pub tip: [f64; N],
    pub t0: f64,
    pub t1: f64,
}

impl<M: BarSystem, const N: usize> Record<M, N> {
    /// A phase that begins at a time in a state; it keeps all its steps or only the last.
    pub fn new(phase: Phase<M, f64, N>, (t0, start): (f64, [f64; N]), keeps: bool) -> Self {
        let kept = (phase.restrict)(&M::State::from_fn(|i| i as f64));
        let entries = M::State::from_fn(|_| 0.0).as_ref().len();
        let places = (0..entries).map(|i| kept.iter().position(|&entry| entry as usize == i)).collect();
        let choice = Choice { method: "none", why: "its integration did not begin" };
        Self {
            phase,
            choice,
            steps: Vec::new(),
            keeps,
            places,
            crossings: Vec::new(),
            start,
            tip: start,
            t0,
            t1: t0,
        }
    }

    /// Keeps the next step.
    pub fn push(&mut self, step: &Dense<f64, N>) {
        match self.steps.last_mut().filter(|_| !self.keeps) {
            Some(last) => last.clone_from(step),
            None => self.steps.push(step.clone()),
        }
    }

    /// Forgets the last step, of which its start is still needed if it is all that there is.
    pub fn pop(&mut self) {
        if self.keeps {
            self.steps.pop();
        }
    }

    /// The full state and the reactions at a time that is kept.
    pub fn state_and_reactions(&self, scene: &Scene<M>, t: f64) -> (Vec<f64>, Vec<f64>) {
        let at = At::new(&self.phase, &scene.constants, t, self.reduced(t));
        (seen::<M>(at.state()).to_vec(), at.reactions().as_ref().to_vec())
    }

    /// The reduced state at a time, or at the nearer end.
    pub fn reduced(&self, t: f64) -> [f64; N] {
        let after = self.steps.partition_point(|step| step.t0 <= t);
        let Some(step) = self.steps.get(after.saturating_sub(1)) else { return self.tip };
        let theta = (t.clamp(self.t0, self.t1) - step.t0) / step.h;
        step.at(theta.clamp(0.0, 1.0))
    }
}

impl<M: BarSystem, const N: usize> Piece<M> for Record<M, N> {
    fn segment(&self) -> Segment {
        let Phase { set, form, .. } = self.phase;
        Segment { set, closed: supports::<M>(set), form, choice: self.choice, t0: self.t0, t1: self.t1 }
    }

    fn times(&self) -> Vec<f64> {
        self.steps.iter().map(|step| step.t0).chain([self.t1]).collect()
    }

    fn at(&self, scene: &Scene<M>, t: f64, read: &mut dyn FnMut(&dyn Moment<M>)) {
        let t = t.clamp(self.t0, self.t1);
        read(&At::new(&self.phase, &scene.constants, t, self.reduced(t)));
    }
}

/// The last step of a record, up to its end.
pub(super) struct Seen<'a, M: BarSystem, const N: usize> {
    pub record: &'a Record<M, N>,
    pub scene: &'a Scene<M>,
}

impl<M: BarSystem, const N: usize> Step for Seen<'_, M, N> {
    fn times(&self) -> [f64; 2] {
        [self.record.steps.last().map_or(self.record.t0, |step| step.t0), self.record.t1]
    }

    fn state(&self, t: f64) -> Vec<f64> {
        let state = (self.record.phase.embed)(&self.scene.constants, &self.record.reduced(t));
        seen::<M>(&state).to_vec()
    }
}
