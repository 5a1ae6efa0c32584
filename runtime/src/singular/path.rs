//! A motion continued by the polynomial through a part of it.

use crate::model::{Array, BarSystem};
use crate::moment::Scene;

/// The polynomial's degree.
const DEGREE: usize = 10;
/// An energy that changes by less over the data, relative to the kinetic one, is constant.
const CONSTANT: f64 = 1e-9;

/// A motion as the polynomial through its states at Chebyshev's points.
pub(super) struct Path<M: BarSystem> {
    times: [f64; DEGREE + 1],
    states: Vec<M::State<f64>>,
}

impl<M: BarSystem> Path<M> {
    pub(super) fn over([start, end]: [f64; 2], at: &dyn Fn(f64) -> M::State<f64>) -> Self {
        let turn = core::f64::consts::PI / DEGREE as f64;
        let times = core::array::from_fn(|j| {
            let fraction = 0.5 * (1.0 - (turn * j as f64).cos());
            if j == DEGREE { end } else { start + fraction * (end - start) }
        });
        Self { times, states: times.map(at).to_vec() }
    }

    /// Barycentric weights at a time that is none of the points (Berrut and Trefethen, *SIAM Rev.* 46 (2004) 501).
    fn weights(&self, t: f64) -> [f64; DEGREE + 1] {
        let weight = |j: usize| {
            let ends = if j == 0 || j == DEGREE { 0.5 } else { 1.0 };
            let sign = if j.is_multiple_of(2) { 1.0 } else { -1.0 };
            sign * ends / (t - self.times[j])
        };
        let weights: [f64; DEGREE + 1] = core::array::from_fn(weight);
        let sum: f64 = weights.iter().sum();
        weights.map(|weight| weight / sum)
    }

    pub(super) fn state(&self, t: f64) -> M::State<f64> {
        let weights = self.weights(t);
        let last = 2 * M::LAYOUT.coordinates.len();
        M::State::from_fn(|i| {
            let along = weights.iter().zip(&self.states).map(|(weight, state)| weight * state.as_ref()[i]);
            if i < last { along.sum() } else { t }
        })
    }

    /// The energy at a time: constant unless it was seen to change.
    pub(super) fn energy(&self, scene: &Scene<M>, t: f64) -> f64 {
        let energies: Vec<[f64; 2]> = self
            .states
            .iter()
            .map(|state| M::energy(&scene.constants, state))
            .map(|energy| [energy.kinetic + energy.potential, energy.kinetic])
            .collect();
        let total = energies.iter().map(|[total, _]| *total);
        let [low, high] = [total.clone().fold(f64::MAX, f64::min), total.clone().fold(f64::MIN, f64::max)];
        let kinetic = energies.iter().fold(0.0, |most: f64, [_, kinetic]| most.max(*kinetic));
        if high - low <= CONSTANT * kinetic {
            return total.sum::<f64>() / energies.len() as f64;
        }
        self.weights(t).iter().zip(total).map(|(weight, energy)| weight * energy).sum()
    }
}
