//! What a drawing needs of a model at one instant.

use crate::model::{Array, BarSystem, Layout, Measure, Scenery};
use crate::simulation::Simulation;

/// A model at one instant: what a drawing needs.
#[derive(Clone, Debug)]
pub struct Still {
    /// The names of points and bars.
    pub layout: &'static Layout,
    /// Values of the parameters, in the layout's order.
    pub parameters: Vec<f64>,
    /// Coordinates, then rates.
    pub state: Vec<f64>,
    /// Positions of the points, in the layout's order.
    pub points: Vec<[f64; 2]>,
    /// What stands still.
    pub scenery: Vec<Scenery>,
    /// Masses, lengths, gravity.
    pub measures: Vec<Measure>,
}

impl Still {
    /// At a state of the model with these parameters.
    pub(crate) fn at<M: BarSystem>(
        parameters: &[f64],
        constants: &M::Constants<f64>,
        state: &M::State<f64>,
    ) -> Self {
        let model = M::from_parameters(parameters);
        let points = M::points(constants, state);
        Self {
            layout: M::LAYOUT,
            parameters: parameters.to_vec(),
            state: crate::moment::seen::<M>(state).to_vec(),
            points: points.as_ref().chunks_exact(2).map(|p| [p[0], p[1]]).collect(),
            scenery: model.scenery().as_ref().to_vec(),
            measures: model.measures().as_ref().to_vec(),
        }
    }

    /// Where a run starts.
    pub(super) fn started<M: BarSystem>(simulation: &Simulation<M>) -> Self {
        let scene = &*simulation.scene;
        let nominal = || M::State::from_fn(|i| scene.nominal.get(i).copied().unwrap_or(0.0));
        let state = simulation.start.as_ref().map_or_else(nominal, |start| start.state);
        Self::at::<M>(&scene.parameters, &scene.constants, &state)
    }
}
