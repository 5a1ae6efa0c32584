//! What the derive macro implements: a model's names, its constants, its full equations and its
//! phases.

mod array;
mod closed_form;
mod contact_set;
mod defaults;
mod energy;
mod equations;
mod friction;
pub mod geometry;
mod layout;
mod measure;
pub mod names;
mod phase;
mod quantity;
mod series;
#[doc(hidden)]
pub mod variables;

pub use crate::series::{Columns, SeriesOps, Tape};
pub use array::Array;
pub use closed_form::{ClosedForm, Pivots};
pub use contact_set::{ContactSet, Side, Slip};
pub use defaults::Defaults;
pub use energy::Energy;
pub use equations::{Kernel, KernelView};
pub use friction::SlipState;
pub use geometry::Geometry;
pub use layout::{
    Bar, Contact, ContactKind, Coordinate, DependentAngle, Dimension, Friction, Joint, Kink, Law, Layout,
    Signal, Switch, Term,
};
pub use measure::{Measure, MeasureKind};
pub use phase::{Form, InSet, OfState, Phase, PhaseVisitor};
pub use quantity::{Quantity, QuantityKind};
pub use series::{KernelSeries, PhaseSeries, Terms, TermsOf, Varying};

use crate::scalar::{Real, Scalar};

/// A planar bar system; implemented by `#[derive(BarSystem)]`.
pub trait BarSystem: Sized + 'static {
    /// Names of everything.
    const LAYOUT: &'static Layout;
    /// Parameters and their products, computed once.
    type Constants<S: Real>: Clone + Send + Sync;
    /// Coordinates, then rates, then the time if the equations depend on it, then the switches.
    type State<S: Real>: Array<S>;
    /// One entry per contact, then one per contact with friction.
    type Reactions<S: Real>: Array<S>;
    /// One entry per coordinate.
    type Accelerations<S: Real>: Array<S>;
    /// One entry per row of the kernel.
    type Multipliers<S: Real>: Array<S>;
    /// The full equations; a [`Kernel`].
    type Kernel<S: Real>: KernelView<S>;
    /// Positions of the points, x then y of each.
    type Points<S: Real>: Array<S>;
    /// For each foot its distance from the bar's first and last point, both ≥ 0 while it lies under
    /// the bar.
    type Feet<S: Real>: Array<S>;

    /// One entry per parameter.
    type Parameters<S: Real>: Array<S> + Send + Sync;
    /// One entry per mass, length, inertia, stiffness, … and component of gravity.
    type Measures: AsRef<[Measure]>;
    /// What [`Layout::geometry`] needs of the parameters.
    type Numbers: Array<f64>;

    /// Values of the parameters in the order of the layout.
    fn parameters(&self) -> Self::Parameters<f64>;
    /// The model with these values of the parameters.
    fn from_parameters(values: &[f64]) -> Self;
    /// Masses, lengths, inertias and gravity.
    fn measures(&self) -> Self::Measures;
    /// Restitution of each contact, then the tangential one of each with friction, between 0 and 1.
    fn restitution<S: Real>(_: &Self::Parameters<S>) -> Self::Reactions<S> {
        Array::from_fn(|_| S::ratio(0, 1))
    }
    /// Lengths, angles and places that [`Layout::geometry`] refers to.
    fn numbers(&self) -> Self::Numbers;
    /// The coordinates of the nominal figure.
    fn nominal(&self) -> Self::Accelerations<f64>;
    /// Parameters and their products from the values of the parameters, with the senses σ of the
    /// contacts that slide in a set.
    fn constants_of<S: Real>(parameters: &Self::Parameters<S>, set: &ContactSet) -> Self::Constants<S>;
    /// The same of this model, where no contact slides.
    fn constants<S: Real>(&self) -> Self::Constants<S> {
        Self::constants_from(self.parameters().as_ref(), &ContactSet::EMPTY)
    }
    /// [`Self::constants_of`] values that are doubles.
    fn constants_from<S: Real>(parameters: &[f64], set: &ContactSet) -> Self::Constants<S> {
        Self::constants_of(&Array::from_fn(|i| S::from_f64(parameters[i])), set)
    }
    /// The full equations at a state.
    fn kernel<S: Real>(constants: &Self::Constants<S>, state: &Self::State<S>) -> Self::Kernel<S>;
    /// Energies at a full state.
    fn energy<S: Real>(constants: &Self::Constants<S>, state: &Self::State<S>) -> Energy<S>;
    /// Positions of the points.
    fn points<S: Real>(constants: &Self::Constants<S>, state: &Self::State<S>) -> Self::Points<S>;
    /// Positions of the feet along their bars.
    fn feet<S: Real>(constants: &Self::Constants<S>, state: &Self::State<S>) -> Self::Feet<S>;
    /// Writes what [`Layout::kinks`] lists.
    fn kinks<S: Real>(_: &Self::Constants<S>, _: &Self::State<S>, _: &mut [S]) {}
    /// Writes the slip of each contact with friction, in the order of [`Layout::frictions`].
    fn slips<S: Real>(_: &Self::Constants<S>, _: &Self::State<S>, _: &mut [SlipState<S>]) {}
    /// The quantity `entry` of [`Layout::quantities`] at a state with these accelerations and
    /// multipliers; NaN for an entry that is none.
    fn quantity<S: Real>(
        constants: &Self::Constants<S>,
        entry: usize,
        state: &Self::State<S>,
        accelerations: &Self::Accelerations<S>,
        multipliers: &Self::Multipliers<S>,
    ) -> S;
    /// Hands the phase of `set` to `visitor`: closed form where there is one and `form` asks for
    /// it, otherwise projected.
    fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(set: ContactSet, form: Form, visitor: V) -> V::Output;
}
