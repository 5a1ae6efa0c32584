//! How well a collision's conditions are met.

use nalgebra::DVector;

use super::equilibrated_kkt::EquilibratedKkt;
use super::impulse::{Collision, ImpulseMethod, Outcome, Row};
use crate::model::Law;

/// One stage of an impact.
struct StageImpulses<'a> {
    /// u at its end.
    rates: &'a DVector<f64>,
    /// What u gains in it.
    change: DVector<f64>,
    /// P of every row in it alone.
    impulses: DVector<f64>,
    /// I in it.
    applied: DVector<f64>,
}

impl Collision {
    /// The largest violation of the equations of motion and of the contact conditions in any stage:
    /// in units of √energy, that is divided by unit inertias and unit rows, relative to the largest
    /// rate there is. Of several groups that of the worst.
    pub fn residual(&self, outcome: &Outcome) -> f64 {
        if !outcome.groups.is_empty() {
            let groups = outcome.groups.iter();
            let residuals = groups.map(|it| self.with_contacts(&it.contacts).residual(&it.outcome));
            return residuals.fold(0.0, f64::max);
        }
        let zero = DVector::zeros(self.rates.len());
        let none = DVector::zeros(self.rows.len());
        let problem = EquilibratedKkt::new(&self.mass, &self.jacobian, (&zero, &none), (&zero, &none));
        let (n, scale) = (self.rates.len(), |i: usize| problem.scale[i]);
        let rates = self.rates.iter().chain(outcome.rates.iter()).enumerate();
        let fastest = rates.fold(0.0, |most: f64, (j, u)| most.max((u / scale(j % n)).abs()));
        let stages = self.stages(outcome);
        let units = |row: usize| (scale(n + row), 1.0 / scale(n + row));
        let rows = (0..self.rows.len()).map(|row| {
            let held = stages.iter().map(|stage| self.slip(stage, row, &units)).fold(0.0, f64::max);
            let rubs = stages.iter().map(|stage| self.friction(stage, outcome.method, row, units(row)));
            rubs.fold(held.max(self.violation(outcome, row, units(row))), f64::max)
        });
        let motion = stages.iter().map(|stage| {
            let load = self.jacobian.tr_mul(&stage.impulses) + &stage.applied;
            let change = &self.mass * &stage.change - load;
            (0..n).map(|j| (change[j] * scale(j)).abs()).fold(0.0, f64::max)
        });
        let worst = rows.chain(motion).fold(0.0, f64::max);
        if fastest > 0.0 { worst / fastest } else { worst }
    }

    fn stages<'a>(&self, outcome: &'a Outcome) -> Vec<StageImpulses<'a>> {
        let whole = StageImpulses {
            rates: &outcome.rates,
            change: &outcome.rates - &self.rates,
            impulses: outcome.impulses.clone(),
            applied: self.applied.clone(),
        };
        let Some((rates, impulses)) = &outcome.compression else { return vec![whole] };
        let first = StageImpulses { rates, change: rates - &self.rates, impulses: impulses.clone(), ..whole };
        let second = StageImpulses {
            rates: &outcome.rates,
            change: &outcome.rates - rates,
            impulses: &outcome.impulses - impulses,
            applied: DVector::zeros(self.rates.len()),
        };
        vec![first, second]
    }

    /// Of rows that hold both ways: always, or while their contact acts. A contact whose impulse
    /// vanishes may have a tangential one only if it stays closed without slip.
    fn slip(&self, stage: &StageImpulses, row: usize, units: &dyn Fn(usize) -> (f64, f64)) -> f64 {
        let speed = |row: usize| (self.speed(stage.rates)[row] * units(row).0).abs();
        match self.rows[row] {
            Row::TwoSided | Row::Guide => speed(row),
            Row::Tangent { of } if stage.impulses[of] > 0.0 || self.rows[of] == Row::TwoSided => speed(row),
            Row::Tangent { of } => (stage.impulses[row] * units(row).1).abs().min(speed(row).max(speed(of))),
            Row::Open | Row::Contact { .. } | Row::Friction { .. } => 0.0,
        }
    }

    /// Of Coulomb's law in a stage: within its cone, and against the slip at its end where that is
    /// all the law asks for. Along a path the slip may have turned.
    fn friction(
        &self,
        stage: &StageImpulses,
        method: ImpulseMethod,
        row: usize,
        (opening, impulse): (f64, f64),
    ) -> f64 {
        let Row::Friction { of, mu, restitution } = self.rows[row] else { return 0.0 };
        if !matches!(self.rows[of], Row::Contact { .. } | Row::Guide) {
            return (stage.impulses[row] * impulse).abs();
        }
        let normal = if self.rows[of] == Row::Guide { stage.impulses[of].abs() } else { stage.impulses[of] };
        let (friction, most) = (stage.impulses[row], mu * normal);
        let excess = (friction.abs() - most).max(0.0) * impulse;
        if method == ImpulseMethod::Path || restitution > 0.0 {
            return excess;
        }
        let slip = self.speed(stage.rates)[row];
        excess.max(((friction + most * slip.signum()).abs() * impulse).min(slip.abs() * opening))
    }

    fn violation(&self, outcome: &Outcome, row: usize, (opening, impulse): (f64, f64)) -> f64 {
        let speed = self.speed(&outcome.rates)[row];
        let both = |a: f64, b: f64| (a * opening).min(b * impulse).abs();
        match (self.rows[row], &outcome.compression) {
            (Row::Contact { .. }, Some((rates, compressed)))
                if outcome.law == Law::Stronge && outcome.method == ImpulseMethod::Path =>
            {
                let first = both(self.speed(rates)[row], compressed[row]);
                let gained = (outcome.impulses[row] - compressed[row]) * impulse;
                first.max(-gained).max(-speed * opening)
            }
            (Row::Contact { restitution, .. }, Some((rates, compressed))) => {
                let first = both(self.speed(rates)[row], compressed[row]);
                let least = (1.0 + outcome.factor * restitution) * compressed[row];
                first.max(both(speed, outcome.impulses[row] - least))
            }
            (Row::Contact { restitution, .. }, None) => {
                let target = speed + outcome.factor * restitution * self.approach()[row].min(0.0);
                both(target, outcome.impulses[row])
            }
            (Row::Open | Row::TwoSided | Row::Guide | Row::Tangent { .. } | Row::Friction { .. }, _) => 0.0,
        }
    }
}

#[cfg(test)]
mod tests;
