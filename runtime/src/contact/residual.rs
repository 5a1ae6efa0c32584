//! How well a collision's conditions are met.

use nalgebra::DVector;

use super::balanced::Balanced;
use super::impulse::{Collision, Outcome, Row};
use crate::model::Law;

impl Collision {
    /// The largest violation of the equations of motion and of the contact conditions: in units of √energy, that is
    /// divided by unit inertias and unit rows, relative to the largest rate there is.
    pub fn residual(&self, outcome: &Outcome) -> f64 {
        let zero = DVector::zeros(self.rates.len());
        let none = DVector::zeros(self.rows.len());
        let problem = Balanced::new(&self.mass, &self.jacobian, (&zero, &none), (&zero, &none));
        let scale = |i: usize| problem.scale[i];
        let n = self.rates.len();
        let rates = self.rates.iter().chain(outcome.rates.iter()).enumerate();
        let fastest = rates.fold(0.0, |most: f64, (j, u)| most.max((u / scale(j % n)).abs()));
        let rows = (0..self.rows.len()).map(|row| {
            let (opening, impulse) = (scale(n + row), 1.0 / scale(n + row));
            self.violation(outcome, row, opening, impulse)
        });
        let load = self.jacobian.tr_mul(&outcome.impulses) + &self.applied;
        let change = &self.mass * (&outcome.rates - &self.rates) - load;
        let motion = (0..n).map(|j| (change[j] * scale(j)).abs());
        let worst = rows.chain(motion).fold(0.0, f64::max);
        if fastest > 0.0 { worst / fastest } else { worst }
    }

    fn violation(&self, outcome: &Outcome, row: usize, opening: f64, impulse: f64) -> f64 {
        let speed = self.speed(&outcome.rates)[row];
        let both = |a: f64, b: f64| (a * opening).min(b * impulse).abs();
        match (self.rows[row], &outcome.compression) {
            (Row::Open, _) => 0.0,
            (Row::TwoSided, _) => (speed * opening).abs(),
            (Row::Tangent { of }, _) if outcome.impulses[of] > 0.0 || outcome.impulses[row] != 0.0 => {
                (speed * opening).abs()
            }
            (Row::Tangent { .. }, _) => 0.0,
            (Row::Contact { restitution, .. }, Some((rates, compressed))) if outcome.law == Law::Poisson => {
                let first = both(self.speed(rates)[row], compressed[row]);
                let least = (1.0 + outcome.factor * restitution) * compressed[row];
                first.max(both(speed, outcome.impulses[row] - least))
            }
            (Row::Contact { restitution, .. }, _) => {
                let target = speed + outcome.factor * restitution * self.approach()[row];
                both(target, outcome.impulses[row])
            }
        }
    }
}
