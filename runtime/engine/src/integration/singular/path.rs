//! A motion continued by the polynomial through a part of it.

use crate::integration::phase_point::RunContext;

/// The polynomial's degree.
const DEGREE: usize = 10;
/// An energy that changes by less over the data, relative to the kinetic one, is constant.
const CONSTANT: f64 = 1e-9;

/// A motion as the polynomial through its states at Chebyshev's points.
pub(super) struct Path {
    times: [f64; DEGREE + 1],
    states: Vec<Vec<f64>>,
    /// How many entries of a state are coordinates and rates.
    public: usize,
}

impl Path {
    pub(super) fn over([start, end]: [f64; 2], public: usize, at: &dyn Fn(f64) -> Vec<f64>) -> Self {
        let turn = core::f64::consts::PI / DEGREE as f64;
        let times = core::array::from_fn(|j| {
            let fraction = 0.5 * (1.0 - (turn * j as f64).cos());
            if j == DEGREE { end } else { start + fraction * (end - start) }
        });
        Self { times, states: times.map(at).to_vec(), public }
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

    pub(super) fn state(&self, t: f64) -> Vec<f64> {
        let weights = self.weights(t);
        let weighted = |i: usize| {
            let along = weights.iter().zip(&self.states).map(|(weight, state)| weight * state[i]);
            if i < self.public { along.sum() } else { t }
        };
        (0..self.states[0].len()).map(weighted).collect()
    }

    /// The energy at a time: constant unless it was seen to change.
    pub(super) fn energy(&self, context: &RunContext, t: f64) -> f64 {
        let energies: Vec<[f64; 2]> = self
            .states
            .iter()
            .map(|state| context.system().energy(state))
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
