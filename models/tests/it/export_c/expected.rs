//! Numbers that a library must give, as near as rounding allows.

use super::library::Answer;
use crate::cases::random;

/// Numbers with how far they change where the state changes by its rounding.
pub struct Expected {
    name: &'static str,
    pub values: Vec<f64>,
    changes: Vec<f64>,
}

/// The values of a function of the state at it, and what rounding of it changes at most in three
/// directions.
pub fn expected(name: &'static str, state: &[f64], of: &dyn Fn(&[f64]) -> Vec<f64>) -> Expected {
    let values = of(state);
    let mut changes = vec![0.0; values.len()];
    let mut seed = 5;
    for _ in 0..3 {
        let moved: Vec<f64> =
            state.iter().map(|x| x + x.abs() * f64::EPSILON * random(&mut seed).signum()).collect();
        for ((change, moved), value) in changes.iter_mut().zip(of(&moved)).zip(&values) {
            *change = f64::max(*change, (moved - value).abs());
        }
    }
    Expected { name, values, changes }
}

impl Expected {
    /// The largest error in units of what rounding gives: of the largest value, and of the state.
    pub fn off(&self, answer: &Answer) -> f64 {
        let found = &answer[self.name];
        assert_eq!(found.len(), self.values.len(), "{}", self.name);
        let scale = self.values.iter().fold(0.0, |scale: f64, x| scale.max(x.abs()));
        let unit = |change: f64| f64::EPSILON * scale + change + f64::MIN_POSITIVE;
        let each = found.iter().zip(&self.values).zip(&self.changes);
        each.fold(0.0, |worst, ((a, b), &change)| match a.to_bits() == b.to_bits() {
            true => worst,
            false => f64::max(worst, (a - b).abs() / unit(change)),
        })
    }
}
