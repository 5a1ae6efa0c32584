//! The rate of a phase with one degree of freedom on an energy level: u = d + s τ with T(d + s τ) +
//! V = E. Here J τ = 0, and d satisfies the prescribed motions, J d = −∂g/∂t. The motion goes away
//! from the pose that defines the level. Without prescribed motions d = 0 and s = ±√((E − V) /
//! T(τ)).

use nalgebra::DMatrix;

use super::ConsistentStart;
use crate::assembly::StartError;
use crate::context::{CLOSED, RunContext, reduce};
use crate::integration::chart;
use crate::integration::phase_point::coordinate_of;
use crate::model::{Energy, Form};
use crate::numerics::decomposition::symmetric_eigen;
use crate::system::PhaseEquations;

/// `start` with the rates that its phase has on the energy level of `level`.
pub(crate) fn on_energy_of(
    context: &RunContext,
    start: &ConsistentStart,
    level: &ConsistentStart,
) -> Result<ConsistentStart, StartError> {
    let phase = |state: &[f64]| chart::choose_chart(context, start.touching, state, (CLOSED, CLOSED)).1;
    let at_level = phase(&level.state);
    let energy = at_level.energy(&reduce(&*at_level, &level.state));
    let search = EnergyLevel { context, start, level, energy };
    Ok(ConsistentStart { state: search.state(&*phase(&start.state))?, ..*start })
}

struct EnergyLevel<'a> {
    context: &'a RunContext,
    start: &'a ConsistentStart,
    level: &'a ConsistentStart,
    /// Energies of the level.
    energy: Energy<f64>,
}

impl EnergyLevel<'_> {
    /// The start's state with its rates on the level.
    fn state(&self, phase: &dyn PhaseEquations) -> Result<Vec<f64>, StartError> {
        let (info, reduced) = (phase.info(), reduce(phase, &self.start.state));
        let (imposed, motion) = match (info.form, info.rates) {
            (Form::Reduced, 1) => (vec![0.0], vec![1.0]),
            (Form::Reduced, degrees) => return Err(StartError::Degrees { degrees }),
            (Form::Multipliers, n) => (self.imposed(n), self.unit_motion(n)?),
        };
        let with_rates = |scale: f64| {
            let mut y = reduced.clone();
            for (k, place) in info.places_of_rates().enumerate() {
                y[place] = scale.mul_add(motion[k], imposed[k]);
            }
            y
        };
        let (from, to) = (&self.level.state, &self.start.state);
        let kept = info.places_of_rates().map(|place| coordinate_of(phase, place));
        let along: f64 = kept.zip(&motion).map(|(i, u)| (to[i] - from[i]) * u).sum();
        let energy = [-1.0, 0.0, 1.0].map(|scale| phase.energy(&with_rates(scale)));
        let rate = self.rate(energy, along < 0.0)?;
        let mut state = vec![0.0; self.start.state.len()];
        phase.embed(&with_rates(rate), &mut state);
        Ok(state)
    }

    /// s of T₀ + b s + a s² + V = E, from the energies at s = −1, 0 and 1.
    fn rate(&self, [back, rest, ahead]: [Energy<f64>; 3], backwards: bool) -> Result<f64, StartError> {
        let excess = self.energy.potential - rest.potential + (self.energy.kinetic - rest.kinetic);
        let slope = 0.5 * (ahead.kinetic - back.kinetic);
        let curvature = 0.5 * (ahead.kinetic + back.kinetic) - rest.kinetic;
        let half = 0.5 * slope / curvature;
        let square = excess + curvature * half * half;
        let rounding = 64.0 * f64::EPSILON * self.context.scales.force() * self.context.scales.length;
        if square < -rounding {
            return Err(StartError::EnergyTooLow { missing: -square });
        }
        let root = (square.max(0.0) / curvature).sqrt();
        Ok(if backwards { -half - root } else { root - half })
    }

    /// The least rates that prescribed motions ask for.
    fn imposed(&self, n: usize) -> Vec<f64> {
        let system = self.context.system();
        let equations = system.equations(&self.start.state);
        let mut rates = vec![0.0; n];
        system.correction(
            &self.start.state,
            self.start.touching,
            equations.prescribed_gap_rate(),
            &mut rates,
        );
        rates
    }

    /// The one direction with J τ = 0, of coordinates in natural units.
    fn unit_motion(&self, n: usize) -> Result<Vec<f64>, StartError> {
        let layout = self.context.layout();
        let equations = self.context.system().equations(&self.start.state);
        let rows = (0..layout.rows()).filter(|&row| layout.is_closed(row, &self.start.touching));
        let unit: Vec<f64> = layout.coordinates.iter().map(|c| self.context.scales.coordinate(c)).collect();
        let mut jacobian = DMatrix::zeros(0, n);
        for row in rows {
            let k = jacobian.nrows();
            jacobian = jacobian.insert_row(k, 0.0);
            (0..n).for_each(|j| jacobian[(k, j)] = equations.jacobian(row)[j] * unit[j]);
        }
        let normal = symmetric_eigen(jacobian.tr_mul(&jacobian));
        let largest = normal.eigenvalues.amax().max(f64::MIN_POSITIVE);
        // Eigenvalues of JᵀJ are squares: the cutoff is that of singular values at 1e-7.
        let null: Vec<usize> = (0..n).filter(|&k| normal.eigenvalues[k] <= 1e-14 * largest).collect();
        match null[..] {
            [k] => Ok((0..n).map(|i| normal.eigenvectors[(i, k)] * unit[i]).collect()),
            _ => Err(StartError::Degrees { degrees: null.len() }),
        }
    }
}
