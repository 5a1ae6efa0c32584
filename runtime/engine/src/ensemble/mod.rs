//! Many motions: initial states or parameter sets, on all threads and, where asked for, eight side
//! by side on each.
//!
//! Members are run one by one, as [`Simulation::observe`] does. [`Ensemble::side_by_side`]
//! integrates those of a model without contacts, closed loops and dampers that run to a time,
//! without conditions, a budget or anything planned, by Taylor's method in the lanes of vectors:
//! each with its own time, step and end, its place taken by the next when it is done. Where nothing
//! works on them, one whose energy has changed is run by itself, which tells why. Neither the bits
//! of a member nor its place among the results depend on the others or on the number of threads;
//! with the lanes' own order of the series, they are not those of [`Simulation::run`].
//!
//! ```
//! use liftoff::ensemble::Ensemble;
//! use liftoff::prelude::*;
//! use liftoff::lanes;
//!
//! /// A bar that swings.
//! #[derive(BarSystem)]
//! #[gravity(g)]
//! #[bar(OA, mass = m, length = l)]
//! #[pin(O = (0, 0))]
//! #[figure(A = (0, -l))]
//! #[coordinate(phi = angle(OA), from = down)]
//! struct Pendulum {
//!     m: f64,
//!     l: f64,
//!     g: f64,
//! }
//!
//! let lengths = [0.5, 1.0, 2.0];
//! let ends = Ensemble::new(lengths.len(), |i| {
//!     let pendulum = Pendulum { m: 1.0, l: lengths[i], g: 9.81 };
//!     Ok(Simulation::new(&pendulum)?.start(Pose::new("phi", 0.1))?.limit(10.0))
//! })
//! .side_by_side(lanes::<Pendulum>)
//! .run();
//! assert!(ends.iter().all(|end| end.as_ref().is_ok_and(|member| member.t == 10.0)));
//! ```

mod lanes;
mod member;
#[cfg(test)]
mod tests;
mod worker;

pub use member::{Member, MemberError};

use std::sync::atomic::AtomicBool;
use std::sync::{Mutex, PoisonError};

use crate::expression::Output;
use crate::simulation::Simulation;
use crate::system::LaneConstructor;
use crate::trajectory::Trajectory;
use worker::{EndsWorker, Shared, Worker};

/// A member's whole motion, or why there is none.
pub type Motion = Result<Trajectory, MemberError>;

/// Many runs in preparation.
pub struct Ensemble<'a, F> {
    count: usize,
    member: F,
    lanes: Option<LaneConstructor>,
    outputs: Vec<Output>,
    progress: Option<&'a (dyn Fn(usize) + Sync)>,
    cancel: Option<&'a AtomicBool>,
    most_errors: usize,
}

impl<'a, F: Fn(usize) -> Result<Simulation, MemberError> + Sync> Ensemble<'a, F> {
    /// `count` members; `member` prepares each by its number, on any thread.
    pub fn new(count: usize, member: F) -> Self {
        let (outputs, most_errors) = (Vec::new(), usize::MAX);
        Self { count, member, lanes: None, outputs, progress: None, cancel: None, most_errors }
    }

    /// Integrates members of this model eight at a time on each thread, where they can have no
    /// events; with [`lanes::<M>`](crate::system::lanes). Members of other models are run one by
    /// one.
    #[must_use]
    pub fn side_by_side(mut self, lanes: LaneConstructor) -> Self {
        self.lanes = Some(lanes);
        self
    }

    /// Evaluates these at each member's end.
    #[must_use]
    pub fn outputs(mut self, outputs: Vec<Output>) -> Self {
        self.outputs = outputs;
        self
    }

    /// Called with the number of finished members each time that one finishes, from any thread.
    #[must_use]
    pub fn progress(mut self, told: &'a (dyn Fn(usize) + Sync)) -> Self {
        self.progress = Some(told);
        self
    }

    /// Begins no more members once this is true; those that have not begun are
    /// [`MemberError::NotRun`].
    #[must_use]
    pub fn cancel(mut self, flag: &'a AtomicBool) -> Self {
        self.cancel = Some(flag);
        self
    }

    /// Begins no more members once this many have failed: which those are depends on the threads.
    #[must_use]
    pub fn stop_after(mut self, errors: usize) -> Self {
        self.most_errors = errors;
        self
    }

    /// Runs all members on the threads of the current rayon pool: the ends of all, or why there is
    /// none, in their order.
    pub fn run(&self) -> Vec<Result<Member, MemberError>> {
        let ends: Mutex<Vec<_>> = Mutex::new((0..self.count).map(|_| Err(MemberError::NotRun)).collect());
        self.each_end(&|i, end| ends.lock().unwrap_or_else(PoisonError::into_inner)[i] = end);
        ends.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    /// The same; calls `told` with the number and the result of each member as soon as it has one,
    /// from any thread, and not for members that have not begun.
    pub fn each_end(&self, told: &(dyn Fn(usize, Result<Member, MemberError>) + Sync)) {
        let shared = Shared::default();
        rayon::broadcast(|_| {
            let worker = Worker { ensemble: self, shared: &shared };
            EndsWorker { worker, told }.run();
        });
    }

    /// Runs each member by itself and calls `told` with its whole motion on the thread that ran it;
    /// the motion is dropped afterwards. Not called for members that have not begun.
    pub fn each_motion(&self, told: &(dyn Fn(usize, Motion) + Sync)) {
        let shared = Shared::default();
        rayon::broadcast(|_| Worker { ensemble: self, shared: &shared }.run_motions(told));
    }
}
