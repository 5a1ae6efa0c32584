//! A model with its values.

use std::sync::Arc;

use super::arrays::array;
use super::lifted::{Liftable, Lifted};
use super::series::TimeSeries;
use super::{SeriesEquations, System};
use crate::model::{BarSystem, Layout, Measure};
use crate::scalar::{DoubleDouble, Dual4, Real, Scalar};

/// A model with its type erased: its equations with the values of its parameters, and what is known
/// of them.
#[derive(Clone)]
pub struct Model {
    /// The full equations and the phases.
    pub system: Arc<dyn System>,
    /// The same on Taylor series in time.
    pub series: Arc<dyn SeriesEquations>,
    /// One value per parameter of the layout.
    pub parameters: Vec<f64>,
    /// The coordinates of the nominal figure.
    pub nominal: Vec<f64>,
    /// Restitution of each contact, then the tangential one of each with friction, between 0 and 1.
    pub restitution: Vec<f64>,
    /// Masses, lengths, inertias, stiffnesses, gravity.
    pub measures: Vec<Measure>,
    /// What the layout's geometry needs of the parameters.
    pub numbers: Vec<f64>,
}

impl Model {
    /// Lifts a compiled model.
    pub fn new<M: BarSystem>(model: &M) -> Self {
        Self {
            system: Arc::new(Lifted::<M, f64>::new(model)),
            series: Arc::new(Lifted::<M, TimeSeries>::new(model)),
            parameters: model.parameters().as_ref().to_vec(),
            nominal: model.nominal().as_ref().to_vec(),
            restitution: M::restitution(&model.parameters()).as_ref().to_vec(),
            measures: model.measures().as_ref().to_vec(),
            numbers: model.numbers().as_ref().to_vec(),
        }
    }

    /// Names of everything.
    #[inline]
    pub fn layout(&self) -> &'static Layout {
        self.system.layout()
    }
}

impl<M: BarSystem> From<&M> for Model {
    fn from(model: &M) -> Self {
        Self::new(model)
    }
}

/// The equations of a compiled model in double-double, with these values of its parameters.
pub fn precise<M: BarSystem>(parameters: &[f64]) -> Arc<dyn System<DoubleDouble>> {
    let parameters: Vec<_> = parameters.iter().map(|&value| DoubleDouble::from_f64(value)).collect();
    on::<M, DoubleDouble>(&parameters).system
}

/// A compiled model on values with their derivatives, given those of its parameters.
pub fn varied<M: BarSystem>(parameters: &[Dual4]) -> ModelOn<Dual4> {
    on::<M, Dual4>(parameters)
}

/// What is missing of the parameters is not a number.
fn on<M: BarSystem, S: Liftable>(parameters: &[S]) -> ModelOn<S> {
    let parameters: M::Parameters<S> = array(parameters);
    let restitution = M::restitution(&parameters).as_ref().to_vec();
    let values = parameters.as_ref().to_vec();
    ModelOn { system: Arc::new(Lifted::<M, S>::with(parameters)), parameters: values, restitution }
}

/// A model's equations on numbers `S`, with its values.
#[derive(Clone)]
pub struct ModelOn<S: Scalar> {
    /// The full equations and the phases.
    pub system: Arc<dyn System<S>>,
    /// One value per parameter of the layout.
    pub parameters: Vec<S>,
    /// Restitution of each contact, then the tangential one of each with friction, between 0 and 1.
    pub restitution: Vec<S>,
}
