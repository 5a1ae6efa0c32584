//! What a drawing needs of a model at one instant.

use core::f64::consts::FRAC_PI_2;
use liftoff::Trajectory;
use liftoff_core::model::geometry::{Direction, Geometry, Number, Push, Round, Spot};
use liftoff_core::model::{Layout, Measure};
use liftoff_core::system::Model;

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
    /// What the layout's geometry refers to.
    pub numbers: Vec<f64>,
    /// Masses, lengths, gravity.
    pub measures: Vec<Measure>,
}

impl Configuration {
    /// Of a motion, at a time.
    pub fn from_run(run: &Trajectory, t: f64) -> Self {
        Self::new(run.model(), &run.layout().state_at(&run.state(t), t))
    }

    /// Of a model at a full state.
    pub(crate) fn new(model: &Model, state: &[f64]) -> Self {
        let layout = model.layout();
        let mut points = vec![0.0; 2 * layout.points.len()];
        model.system.points(state, &mut points);
        Self {
            layout,
            parameters: model.parameters.clone(),
            state: layout.public_state(state).to_vec(),
            points: points.chunks_exact(2).map(|p| [p[0], p[1]]).collect(),
            numbers: model.numbers.clone(),
            measures: model.measures.clone(),
        }
    }

    /// Points, and the outermost places of the circles about them.
    pub fn places(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let rim = |round: &Round| {
            let ([x, y], r) = (self.points[round.centre], self.number(round.radius));
            [[x - r, y - r], [x + r, y + r]]
        };
        self.points.iter().copied().chain(self.geometry().rounds.iter().flat_map(rim))
    }

    /// How the model is drawn.
    pub fn geometry(&self) -> &'static Geometry {
        self.layout.geometry
    }

    /// A number of the geometry.
    pub fn number(&self, number: Number) -> f64 {
        self.numbers[number]
    }

    /// A fixed place of the geometry.
    pub fn position(&self, at: [Number; 2]) -> [f64; 2] {
        at.map(|number| self.number(number))
    }

    /// Any place of the geometry.
    pub fn spot(&self, spot: Spot) -> [f64; 2] {
        match spot {
            Spot::Point(point) => self.points[point],
            Spot::Fixed(at) => self.position(at),
        }
    }

    /// The direction in which something pushes, rad counter-clockwise from the right.
    pub fn normal(&self, push: &Push) -> f64 {
        self.direction(push.along) + FRAC_PI_2 * f64::from(push.turns)
    }

    /// Where something pushes: a point, or the place at which a rim is touched.
    pub fn touched(&self, push: &Push) -> [f64; 2] {
        let [x, y] = self.spot(push.at);
        let (rim, (sin, cos)) = (push.rim.map_or(0.0, |rim| self.number(rim)), self.normal(push).sin_cos());
        [x - rim * cos, y - rim * sin]
    }

    /// A direction of the geometry, rad counter-clockwise from the right.
    pub fn direction(&self, direction: Direction) -> f64 {
        let between = |[from, to]: [Spot; 2]| {
            let [a, b] = [from, to].map(|spot| self.spot(spot));
            (b[1] - a[1]).atan2(b[0] - a[0])
        };
        match direction {
            Direction::Fixed(angle) => self.number(angle),
            Direction::Towards(from, to) => between([from, to]),
            Direction::Axis { ends, step } => {
                let [along, across] = self.position(step);
                between(ends.map(Spot::Point)) - across.atan2(along)
            }
        }
    }
}
