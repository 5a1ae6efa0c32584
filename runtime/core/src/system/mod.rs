//! A model with its type erased: what the engine integrates, watches and decides with, on slices.
//!
//! `M: BarSystem` and constant dimensions end here. [`Model::new`] lifts a compiled model; whatever
//! else can evaluate its own equations implements [`System`] and [`PhaseEquations`] itself. A call
//! through them happens once per right-hand side.

mod arrays;
mod derivative;
mod equations;
pub mod erased;
mod jacobian;
mod lanes;
mod lifted;
mod model;
mod phase;
mod projected;
mod series;

pub use equations::Equations;
pub use erased::{
    ByOrders, DenseOutput, InitialValueProblem, Methods, PhaseStepper, SeriesExpansion, SeriesOrders,
};
pub use lanes::{LaneConstructor, LaneEnd, LaneGroup, LaneStart, lanes};
pub use model::{Model, ModelOn, precise, varied};
pub use phase::PhaseInfo;
pub use projected::{KernelOrders, TakeOrder, projected_series};
pub use series::{LongTimeSeries, MOST_TIME_ORDERS, SeriesEquations, TIME_ORDERS, TimeSeries};

use std::sync::Arc;

use crate::model::{ContactSet, Energy, Form, Layout, Pivots, SlipState};
use crate::scalar::Scalar;

/// The full equations of a model at a state, on numbers `S`.
///
/// A state holds the coordinates, their rates and, where [`Layout::timed`], the time:
/// [`Layout::entries`] entries. Entries missing from a state that is too short count as not a
/// number.
pub trait System<S: Scalar = f64>: Send + Sync {
    /// Names of everything.
    fn layout(&self) -> &'static Layout;
    /// `M a = f + Jᵀ λ`, g and `J a + b = g̈` of all rows.
    fn equations(&self, state: &[S]) -> Equations<S>;
    /// g of the first rows, as many as `gaps` has entries: the contacts come first.
    fn gaps(&self, state: &[S], gaps: &mut [S]);
    /// a of `M a = f + Jᵀ λ`, `J a = −b` over the rows closed in `set`, and λ of every row, zero
    /// where open, the friction force for the slip of a sliding contact; whether λ is unique.
    fn solve(&self, state: &[S], set: ContactSet, accelerations: &mut [S], multipliers: &mut [S]) -> bool;
    /// The least change d in the mass metric with `J d = −r` over the closed rows, r one entry per
    /// row: `M d = Jᵀ μ`.
    fn correction(&self, state: &[S], set: ContactSet, residual: &[S], change: &mut [S]);
    /// Brings a state back on its closed contacts and joints; `length` is the natural one.
    fn project(&self, set: ContactSet, state: &mut [S], length: f64);
    /// T and V.
    fn energy(&self, state: &[S]) -> Energy<S>;
    /// Positions of the points, x then y of each.
    fn points(&self, state: &[S], points: &mut [S]);
    /// For each foot its distance from the bar's first and last point.
    fn feet(&self, state: &[S], feet: &mut [S]);
    /// Values of [`Layout::kinks`], one entry each: zero where the equations are not analytic in
    /// the state.
    fn kinks(&self, state: &[S], kinks: &mut [S]);
    /// The slip of each contact with friction, in the order of [`Layout::frictions`], one entry
    /// each.
    fn slips(&self, state: &[S], slips: &mut [SlipState<S>]);
    /// The quantity `entry` of [`Layout::quantities`].
    fn quantity(&self, entry: usize, state: &[S], accelerations: &[S], multipliers: &[S]) -> S;
    /// The phase of a contact set: in closed form where there is one and `form` asks for it,
    /// otherwise projected.
    fn phase(self: Arc<Self>, set: ContactSet, form: Form) -> Arc<dyn PhaseEquations<S>>;
}

/// The equations of one contact set in its reduced state: coordinates, then rates, then the time if
/// the equations depend on it; [`PhaseInfo::entries`] numbers.
pub trait PhaseEquations<S: Scalar = f64>: Send + Sync {
    /// The model.
    fn system(&self) -> &dyn System<S>;
    /// The contact set, the form and the dimensions.
    fn info(&self) -> &PhaseInfo;
    /// The entry of the full state that each entry of the reduced one is.
    fn kept(&self) -> &[usize];
    /// Time derivative of the reduced state.
    fn derivative(&self, y: &[S], derivative: &mut [S]);
    /// Reaction of every contact, zero where open, then the friction forces: [`Layout::reactions`]
    /// entries.
    fn reactions(&self, y: &[S], reactions: &mut [S]);
    /// The full state.
    fn embed(&self, y: &[S], state: &mut [S]);
    /// The pivots of the elimination, relative to their natural sizes.
    fn pivots(&self, y: &[S]) -> Pivots<S>;
    /// T and V; on `f64` with the eliminated coordinates substituted, so that no digits cancel.
    fn energy(&self, y: &[S]) -> Energy<S>;
    /// The source of its Taylor series, if it has any.
    fn series(&self) -> Option<Box<dyn SeriesExpansion + '_>> {
        None
    }
    /// How many products and quotients of series a closed form has; 0 where that is not known.
    fn products(&self) -> usize {
        0
    }
    /// The methods of integration that serve its size.
    fn methods(&self) -> Methods {
        Methods::default()
    }
    /// ∂f/∂y, if it is known exactly; what can be stiff should know it.
    fn jacobian(&self) -> Option<Jacobian<'_>> {
        None
    }
    /// The reduced state of a full one that satisfies the closed contacts.
    fn restrict(&self, state: &[S], y: &mut [S]) {
        for (y, &entry) in y.iter_mut().zip(self.kept()) {
            *y = state[entry];
        }
    }
}

/// Writes ∂f/∂y at y, row by row.
pub type Jacobian<'a> = Box<dyn Fn(&[f64], &mut [f64]) + 'a>;
