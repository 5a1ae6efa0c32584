//! The rate of a one-degree phase on an energy level: u = ±√((E − V) / T₁) τ with T₁ the kinetic energy of the unit
//! motion τ, J τ = 0; away from the pose whose energy it is.

use nalgebra::DMatrix;

use super::{CLOSED, Start};
use crate::error::StartError;
use crate::model::{BarSystem, Energy, Form, KernelView, Phase, PhaseVisitor};
use crate::pivot::form_at;
use crate::scales::Scales;

/// `start` with the rates that its phase has on the energy level of `level`.
pub(crate) fn on_energy_of<M: BarSystem>(
    constants: &M::Constants<f64>,
    scales: &Scales,
    start: &Start<M>,
    level: &Start<M>,
) -> Result<Start<M>, StartError> {
    let form = |state| form_at::<M>(constants, start.touching, Form::Closed, state, CLOSED);
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
        let (from, to) = ((phase.restrict)(&self.level.state), (phase.restrict)(&self.start.state));
        let motion = match (phase.form, N) {
            (Form::Closed, 2) => vec![1.0],
            (Form::Closed, _) => return Err(StartError::Degrees { degrees: N / 2 }),
            (Form::Projected, _) => self.unit_motion(N / 2)?,
        };
        let with_rates =
            |scale: f64| core::array::from_fn(|i| if i < N / 2 { to[i] } else { scale * motion[i - N / 2] });
        let along: f64 = (0..N / 2).map(|i| (to[i] - from[i]) * motion[i]).sum();
        let rate = self.rate((phase.energy)(self.constants, &with_rates(1.0)))?;
        let rate = if along < 0.0 { -rate } else { rate };
        Ok((phase.embed)(self.constants, &with_rates(rate)))
    }
}

impl<M: BarSystem> Ascent<'_, M> {
    fn rate(&self, unit: Energy<f64>) -> Result<f64, StartError> {
        let excess = self.energy.potential - unit.potential + self.energy.kinetic;
        let rounding = 64.0 * f64::EPSILON * self.scales.force() * self.scales.length;
        if excess < -rounding {
            return Err(StartError::EnergyTooLow { missing: -excess });
        }
        Ok((excess.max(0.0) / unit.kinetic).sqrt())
    }

    /// The one direction with J τ = 0, of coordinates in natural units.
    fn unit_motion(&self, n: usize) -> Result<Vec<f64>, StartError> {
        let kernel = M::kernel(self.constants, &self.start.state);
        let contacts = M::LAYOUT.contacts.len();
        let rows = (0..contacts + M::LAYOUT.joints.len())
            .filter(|&row| row >= contacts || self.start.touching.contains(row));
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
