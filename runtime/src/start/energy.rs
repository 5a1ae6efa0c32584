//! The rate of a one-degree phase on an energy level: u = d + s τ with T(d + s τ) + V = E, where J τ = 0 and d is what
//! prescribed motions ask for, J d = −∂g/∂t; away from the pose whose energy it is. Without them s = ±√((E − V) / T(τ)).

use nalgebra::DMatrix;

use super::{CLOSED, Start};
use crate::chart;
use crate::error::StartError;
use crate::model::{BarSystem, Energy, Form, KernelView, Phase, PhaseVisitor};
use crate::moment::retained;
use crate::scales::Scales;

/// `start` with the rates that its phase has on the energy level of `level`.
pub(crate) fn on_energy_of<M: BarSystem>(
    constants: &M::Constants<f64>,
    scales: &Scales,
    start: &Start<M>,
    level: &Start<M>,
) -> Result<Start<M>, StartError> {
    let form = |state| chart::at::<M>((constants, scales), start.touching, state, (CLOSED, CLOSED)).form();
    let energy = M::phase(start.touching, form(&level.state), EnergyAt { constants, state: &level.state });
    let ascent = Ascent { constants, scales, start, level, energy };
    let state = M::phase(start.touching, form(&start.state), ascent)?;
    Ok(Start { state, touching: start.touching })
}

struct Ascent<'a, M: BarSystem> {
    constants: &'a M::Constants<f64>,
    scales: &'a Scales,
    start: &'a Start<M>,
    level: &'a Start<M>,
    /// That of the level.
    energy: Energy<f64>,
}

struct EnergyAt<'a, M: BarSystem> {
    constants: &'a M::Constants<f64>,
    state: &'a M::State<f64>,
}

impl<M: BarSystem> PhaseVisitor<M, f64> for EnergyAt<'_, M> {
    type Output = Energy<f64>;

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> Energy<f64> {
        (phase.energy)(self.constants, &(phase.restrict)(self.state))
    }
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Ascent<'_, M> {
    type Output = Result<M::State<f64>, StartError>;

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> Self::Output {
        let reduced = (phase.restrict)(&self.start.state);
        let rates = phase.coordinates..phase.coordinates + phase.rates;
        let (imposed, motion) = match (phase.form, phase.rates) {
            (Form::Closed, 1) => (vec![0.0], vec![1.0]),
            (Form::Closed, degrees) => return Err(StartError::Degrees { degrees }),
            (Form::Projected, n) => (self.imposed(n), self.unit_motion(n)?),
        };
        let with_rates = |scale: f64| -> [f64; N] {
            core::array::from_fn(|i| {
                let k = i.wrapping_sub(rates.start);
                if rates.contains(&i) { scale.mul_add(motion[k], imposed[k]) } else { reduced[i] }
            })
        };
        let (from, to) = (self.level.state.as_ref(), self.start.state.as_ref());
        let along: f64 = retained(&phase).into_iter().zip(&motion).map(|(i, u)| (to[i] - from[i]) * u).sum();
        let energy = [-1.0, 0.0, 1.0].map(|scale| (phase.energy)(self.constants, &with_rates(scale)));
        let rate = self.rate(energy, along < 0.0)?;
        Ok((phase.embed)(self.constants, &with_rates(rate)))
    }
}

impl<M: BarSystem> Ascent<'_, M> {
    /// s of T₀ + b s + a s² + V = E, from the energies at s = −1, 0 and 1.
    fn rate(&self, [back, rest, ahead]: [Energy<f64>; 3], backwards: bool) -> Result<f64, StartError> {
        let excess = self.energy.potential - rest.potential + (self.energy.kinetic - rest.kinetic);
        let slope = 0.5 * (ahead.kinetic - back.kinetic);
        let curvature = 0.5 * (ahead.kinetic + back.kinetic) - rest.kinetic;
        let half = 0.5 * slope / curvature;
        let square = excess + curvature * half * half;
        let rounding = 64.0 * f64::EPSILON * self.scales.force() * self.scales.length;
        if square < -rounding {
            return Err(StartError::EnergyTooLow { missing: -square });
        }
        let root = (square.max(0.0) / curvature).sqrt();
        Ok(if backwards { -half - root } else { root - half })
    }

    /// The least rates that prescribed motions ask for.
    fn imposed(&self, n: usize) -> Vec<f64> {
        let kernel = M::kernel(self.constants, &self.start.state);
        let mut rates = vec![0.0; n];
        kernel.correction(M::LAYOUT, self.start.touching, |row| kernel.drift()[row], &mut rates);
        rates
    }

    /// The one direction with J τ = 0, of coordinates in natural units.
    fn unit_motion(&self, n: usize) -> Result<Vec<f64>, StartError> {
        let kernel = M::kernel(self.constants, &self.start.state);
        let rows = (0..M::LAYOUT.rows()).filter(|&row| M::LAYOUT.is_closed(row, self.start.touching));
        let unit: Vec<f64> = M::LAYOUT.coordinates.iter().map(|c| self.scales.coordinate(c)).collect();
        let mut slopes = DMatrix::zeros(0, n);
        for row in rows {
            let k = slopes.nrows();
            slopes = slopes.insert_row(k, 0.0);
            (0..n).for_each(|j| slopes[(k, j)] = kernel.jacobian(row)[j] * unit[j]);
        }
        let normal = slopes.tr_mul(&slopes).symmetric_eigen();
        let largest = normal.eigenvalues.amax().max(f64::MIN_POSITIVE);
        // Eigenvalues of JᵀJ are squares: the cutoff is that of singular values at 1e-7.
        let null: Vec<usize> = (0..n).filter(|&k| normal.eigenvalues[k] <= 1e-14 * largest).collect();
        match null[..] {
            [k] => Ok((0..n).map(|i| normal.eigenvectors[(i, k)] * unit[i]).collect()),
            _ => Err(StartError::Degrees { degrees: null.len() }),
        }
    }
}
