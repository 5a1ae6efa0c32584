//! Generalised coordinates read off a maximal state, so that other descriptions can be compared
//! with it.

use nalgebra::Vector2;

use super::rows::Row;
use super::{Assembly, Motion, Place, State};

/// A coordinate as a function of the state.
#[derive(Clone, Debug)]
pub enum Coordinate {
    /// Σ cᵢ θᵢ − offset.
    Angle {
        /// (body, cᵢ).
        terms: Vec<(usize, f64)>,
        /// Where the coordinate is zero.
        offset: f64,
    },
    /// ± a component of a point's position.
    Position {
        /// The point.
        at: Place,
        /// 0 for x, 1 for y.
        axis: usize,
        /// +1 or −1.
        sign: f64,
    },
}

impl Coordinate {
    /// ± the unit vector along an axis.
    fn direction(axis: usize, sign: f64) -> Vector2<f64> {
        let mut direction = Vector2::zeros();
        direction[axis] = sign;
        direction
    }
}

impl Assembly {
    /// A coordinate as a row: its value, its gradient and its second derivative without
    /// accelerations.
    pub(super) fn reading(&self, state: &State, coordinate: &Coordinate) -> Row {
        match coordinate {
            Coordinate::Angle { terms, offset } => {
                let sum: f64 = terms.iter().map(|&(body, c)| c * state.angle(body)).sum();
                Row::of_angles(terms, sum - offset)
            }
            &Coordinate::Position { at, axis, sign } => {
                self.projection(state, at, Coordinate::direction(axis, sign))
            }
        }
    }

    /// Value and rate of a coordinate.
    pub fn measure(&self, state: &State, coordinate: &Coordinate) -> [f64; 2] {
        match coordinate {
            Coordinate::Angle { terms, offset } => [
                terms.iter().map(|&(body, c)| c * state.angle(body)).sum::<f64>() - offset,
                terms.iter().map(|&(body, c)| c * state.spin(body)).sum(),
            ],
            &Coordinate::Position { at, axis, sign } => {
                [self.position(state, at)[axis], self.velocity(state, at)[axis]].map(|v| sign * v)
            }
        }
    }

    /// Second derivative of a coordinate.
    pub fn second_rate(&self, state: &State, motion: &Motion, coordinate: &Coordinate) -> f64 {
        match coordinate {
            Coordinate::Angle { terms, .. } => terms.iter().map(|&(body, c)| c * motion.angular(body)).sum(),
            &Coordinate::Position { at, axis, sign } => sign * self.acceleration(state, motion, at)[axis],
        }
    }
}
