//! The exact Jacobian of a phase: its equations on dual numbers.

use std::sync::Arc;

use liftoff_core::scalar::Dual4;
use liftoff_core::system::{Jacobian, PhaseEquations};

use super::evaluator::Evaluator;
use super::phase::InterpretedPhase;
use crate::pool::Lent;

/// Derivatives taken in one evaluation.
const WIDTH: usize = 4;

/// ∂f/∂y of a phase.
pub(super) fn build_jacobian(phase: &InterpretedPhase<f64>) -> Jacobian<'_> {
    let (system, info) = (&phase.system, PhaseEquations::info(phase));
    let parameters: Vec<_> = system.parameters.iter().map(|&value| Dual4::constant(value)).collect();
    let dual = Evaluator::new(&system.model, &parameters, info.set);
    let dual = InterpretedPhase::new(Arc::new(dual), info.set, info.form);
    Box::new(move |y, rows| differentiate(&dual, y, rows))
}

/// Writes ∂f/∂y row by row.
fn differentiate(phase: &InterpretedPhase<Dual4>, y: &[f64], rows: &mut [f64]) {
    let n = y.len();
    let (mut at, mut f) = (Lent::new(n), Lent::new(n));
    for first in (0..n).step_by(WIDTH) {
        for (j, entry) in at.iter_mut().enumerate() {
            // Beyond the block an index is that of no variable.
            *entry = Dual4::variable(y[j], j.checked_sub(first).unwrap_or(WIDTH));
        }
        phase.derivative(&at, &mut f);
        for (row, f) in rows.chunks_exact_mut(n).zip(f.iter()) {
            for (entry, derivative) in row[first..].iter_mut().zip(f.gradient()) {
                *entry = *derivative;
            }
        }
    }
}
