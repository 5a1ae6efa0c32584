//! What a drawing needs of a model at one instant.

use liftoff::Trajectory;
use liftoff::model::{Layout, Measure, Scenery};
use liftoff::system::Model;

/// A model at one instant: what a drawing needs.
#[derive(Clone, Debug)]
pub struct Configuration {
    /// Layout of the model, with the names of points and bars.
    pub layout: &'static Layout,
    /// Values of the parameters, in the layout's order.
    pub parameters: Vec<f64>,
    /// Coordinates, then rates.
    pub state: Vec<f64>,
    /// Positions of the points, in the layout's order.
    pub points: Vec<[f64; 2]>,
    /// Supports, pins and fixed points.
    pub scenery: Vec<Scenery>,
    /// Masses, lengths, gravity.
    pub measures: Vec<Measure>,
}

impl Configuration {
    /// Of a motion, at a time.
    pub fn of(run: &Trajectory, t: f64) -> Self {
        Self::at(run.model(), &run.layout().state_at(&run.state(t), t))
    }

    /// Of a model at a full state.
    pub(super) fn at(model: &Model, state: &[f64]) -> Self {
        let layout = model.layout();
        let mut points = vec![0.0; 2 * layout.points.len()];
        model.system.points(state, &mut points);
        Self {
            layout,
            parameters: model.parameters.clone(),
            state: layout.public_state(state).to_vec(),
            points: points.chunks_exact(2).map(|p| [p[0], p[1]]).collect(),
            scenery: model.scenery.clone(),
            measures: model.measures.clone(),
        }
    }
}
