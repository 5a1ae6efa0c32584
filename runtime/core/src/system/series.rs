//! The full equations along a motion, as Taylor series in time.

use super::Equations;
use super::arrays::array;
use super::lifted::Lifted;
use crate::model::{Array, BarSystem};
use crate::scalar::{Jet, Real};

/// Coefficients kept: orders 0 to 3, so that reactions are known to their third derivative.
pub const TIME_ORDERS: usize = 4;

/// A Taylor series in time.
pub type TimeSeries = Jet<f64, TIME_ORDERS>;

/// Coefficients kept if fewer do not decide; the cost per coefficient grows with their number.
pub const MOST_TIME_ORDERS: usize = 10;

/// A Taylor series in time to the higher order.
pub type LongTimeSeries = Jet<f64, MOST_TIME_ORDERS>;

/// A model's equations on Taylor series in time.
pub trait SeriesEquations: Send + Sync {
    /// The full equations along a motion, for decisions on contacts; without contacts `None`, and
    /// nothing is compiled.
    fn equations(&self, state: &[TimeSeries]) -> Option<Equations<TimeSeries>>;
    /// The full equations to more orders; only for models that depend on time, because compiling
    /// them takes long.
    fn long_equations(&self, state: &[LongTimeSeries]) -> Option<Equations<LongTimeSeries>>;
    /// Positions of the points along a motion, x then y of each.
    fn points(&self, state: &[TimeSeries], points: &mut [TimeSeries]);
}

impl<M: BarSystem> SeriesEquations for Lifted<M, TimeSeries> {
    fn equations(&self, state: &[TimeSeries]) -> Option<Equations<TimeSeries>> {
        if const { M::LAYOUT.contacts.is_empty() } {
            return None;
        }
        Some(self.along(state))
    }

    fn long_equations(&self, state: &[LongTimeSeries]) -> Option<Equations<LongTimeSeries>> {
        if const { M::LAYOUT.contacts.is_empty() || !M::LAYOUT.timed } {
            return None;
        }
        let parameter = |i: usize| Jet::constant(self.parameters.as_ref()[i].coefficient(0));
        let long = Lifted::<M, LongTimeSeries>::with(Array::from_fn(parameter));
        Some(long.along(state))
    }

    fn points(&self, state: &[TimeSeries], points: &mut [TimeSeries]) {
        points.copy_from_slice(M::points(&self.constants, &array(state)).as_ref());
    }
}

impl<M: BarSystem, S: Real> Lifted<M, S> {
    fn along(&self, state: &[S]) -> Equations<S> {
        Equations::from_kernel(&M::kernel(&self.constants, &array(state)))
    }
}
