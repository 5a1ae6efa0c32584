//! Guards that are affine functions of the reduced state, g = g₀ + a·y. Over a step whose dense
//! output is y = Σ cₖ θᵏ they are
//!
//! ```text
//! g(θ) = g₀ + a·c₀ + Σ (a·cₖ) θᵏ
//! ```
//!
//! without being evaluated, and no fit has to be proved.

#[cfg(test)]
mod tests;

use crate::context::{RunContext, slips};
use crate::integrate::Guards;
use crate::model::{ContactSet, Slip};
use crate::series::ORDERS;
use crate::system::{DenseOutput, PhaseEquations};

/// Where slopes are taken, in natural units: so far away that what a guard is at zero is lost in
/// the rounding of the difference. An affine function has the same slope everywhere.
const FAR: f64 = (1_u64 << 40) as f64;

/// Zero coefficients behind those of a polynomial, as a series has them that ends there: by these
/// its rest is judged.
const ENDS: usize = 2;

/// The guards of a run's phases that have only such.
#[derive(Default)]
pub(crate) struct KnownAffineGuards(Vec<AffineGuards>);

impl KnownAffineGuards {
    /// Of a phase in closed form; those of a set that returns are not found again.
    pub(crate) fn find_or_compute(
        &mut self,
        phase: &dyn PhaseEquations,
        context: &RunContext,
    ) -> &mut AffineGuards {
        let set = phase.info().set;
        let place = self.0.iter().position(|known| known.set == set).unwrap_or_else(|| {
            self.0.push(AffineGuards::compute(phase, context));
            self.0.len() - 1
        });
        &mut self.0[place]
    }
}

/// The guards of a phase: reactions and friction forces, gaps and slip velocities, feet.
pub(crate) struct AffineGuards {
    set: ContactSet,
    /// g₀, then a, of each.
    coefficients: Vec<f64>,
    is_finite: bool,
    /// Entries of the reduced state.
    entries: usize,
    reactions: usize,
    /// Over the last step.
    series: Vec<[f64; ORDERS]>,
}

impl AffineGuards {
    /// Of a phase that has only such guards.
    fn compute(phase: &dyn PhaseEquations, context: &RunContext) -> Self {
        let (layout, entries) = (context.layout(), phase.info().entries);
        let (reactions, feet) = (layout.reactions(), 2 * layout.feet());
        let rows = 2 * reactions + feet;
        let mut y = vec![0.0; entries];
        let at_zero = values(phase, &y);
        let mut coefficients = vec![0.0; rows * (1 + entries)];
        for (row, value) in coefficients.chunks_exact_mut(1 + entries).zip(&at_zero) {
            row[0] = *value;
        }
        for i in 0..entries {
            let far = FAR * context.scales.entry(layout, phase.kept()[i]);
            y[i] = far;
            let beyond = values(phase, &y);
            y[i] = 0.0;
            for (row, (value, first)) in
                coefficients.chunks_exact_mut(1 + entries).zip(beyond.iter().zip(&at_zero))
            {
                row[1 + i] = (value - first) / far;
            }
        }
        let (set, series) = (phase.info().set, vec![[0.0; ORDERS]; rows]);
        let is_finite = coefficients.iter().all(|c| c.is_finite());
        Self { set, coefficients, is_finite, entries, reactions, series }
    }

    /// Their polynomials over a step; none where its dense output is of too high a degree, or where
    /// they overflow far away.
    pub(crate) fn over(&mut self, step: &DenseOutput) -> Option<Guards<'_>> {
        let terms = step.degree() + 1;
        if terms + ENDS > ORDERS || !self.is_finite {
            return None;
        }
        for (series, row) in self.series.iter_mut().zip(self.coefficients.chunks_exact(1 + self.entries)) {
            let series = &mut series[..terms + ENDS];
            series.fill(0.0);
            if row[1..].iter().any(|slope| *slope != 0.0) {
                step.combination(&row[1..], &mut series[..terms])?;
            }
            series[0] += row[0];
        }
        let (reactions, rest) = self.series.split_at(self.reactions);
        let (gaps, feet) = rest.split_at(self.reactions);
        Some(Guards::new(terms + ENDS, reactions, gaps, feet))
    }
}

/// All guards at a reduced state: zero are gaps of closed contacts, and slip velocities but of
/// those that slide.
fn values(phase: &dyn PhaseEquations, reduced: &[f64]) -> Vec<f64> {
    let (system, set) = (phase.system(), phase.info().set);
    let layout = system.layout();
    let (contacts, all) = (layout.contacts.len(), layout.reactions());
    let mut values = vec![0.0; 2 * all + 2 * layout.feet()];
    let (reactions, rest) = values.split_at_mut(all);
    let (gaps, rest) = rest.split_at_mut(contacts);
    let (velocities, feet) = rest.split_at_mut(all - contacts);
    let mut state = vec![0.0; layout.entries()];
    phase.reactions(reduced, reactions);
    phase.embed(reduced, &mut state);
    system.gaps(&state, gaps);
    set.iter().for_each(|contact| gaps[contact] = 0.0);
    for ((velocity, slip), friction) in velocities.iter_mut().zip(slips(system, &state)).zip(layout.frictions)
    {
        *velocity = if slides(&set, friction.contact) { slip.velocity } else { 0.0 };
    }
    system.feet(&state, feet);
    values
}

fn slides(set: &ContactSet, contact: usize) -> bool {
    set.contains(contact) && set.slip(contact) != Slip::Stick
}
