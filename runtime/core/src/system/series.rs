//! The full equations along a motion, as Taylor series in time.

use super::Equations;
use super::lifted::{Lifted, array};
use crate::model::BarSystem;
use crate::scalar::Jet;

/// Coefficients kept: orders 0 to 3, so that reactions are known to their third derivative.
pub const TIME_ORDERS: usize = 4;

/// A Taylor series in time.
pub type TimeSeries = Jet<f64, TIME_ORDERS>;

/// A model's equations on Taylor series in time.
pub trait SeriesEquations: Send + Sync {
    /// The full equations along a motion, where there are contacts, whose decisions ask for them; else nothing of them is
    /// compiled.
    fn equations(&self, state: &[TimeSeries]) -> Option<Equations<TimeSeries>>;
    /// Positions of the points along a motion, x then y of each.
    fn points(&self, state: &[TimeSeries], points: &mut [TimeSeries]);
}

impl<M: BarSystem> SeriesEquations for Lifted<M, TimeSeries> {
    fn equations(&self, state: &[TimeSeries]) -> Option<Equations<TimeSeries>> {
        if const { M::LAYOUT.contacts.is_empty() } {
            return None;
        }
        Some(Equations::of(&M::kernel(&self.constants, &array(state))))
    }

    fn points(&self, state: &[TimeSeries], points: &mut [TimeSeries]) {
        points.copy_from_slice(M::points(&self.constants, &array(state)).as_ref());
    }
}
