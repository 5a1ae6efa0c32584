//! The exact Jacobian of a phase: its emitted derivative, run on dual numbers.

use super::{BarSystem, ContactSet, Form, Phase, PhaseVisitor};
use crate::scalar::Dual;

/// Derivatives taken in one evaluation. One width for all phases: emitted code is compiled for it once.
const WIDTH: usize = 4;

/// The number that the Jacobian is computed with.
pub type Slope = Dual<f64, WIDTH>;

/// ∂f/∂y of the derivative f of the phase of `set` and `form` at its reduced state `y`, row `i` that of fᵢ;
/// not a number if the phase has not `N` entries.
pub fn jacobian<M: BarSystem, const N: usize>(
    constants: &M::Constants<Slope>,
    set: ContactSet,
    form: Form,
    y: &[f64; N],
) -> [[f64; N]; N] {
    let mut rows = [[f64::NAN; N]; N];
    M::phase(set, form, Differentiate::<M, N> { constants, y, rows: &mut rows });
    rows
}

struct Differentiate<'a, M: BarSystem, const N: usize> {
    constants: &'a M::Constants<Slope>,
    y: &'a [f64; N],
    rows: &'a mut [[f64; N]; N],
}

impl<M: BarSystem, const N: usize> PhaseVisitor<M, Slope> for Differentiate<'_, M, N> {
    type Output = ();

    fn visit<const K: usize>(self, phase: Phase<M, Slope, K>) {
        if K != N {
            return;
        }
        for first in (0..N).step_by(WIDTH) {
            // Beyond the block an index is that of no variable.
            let seed = |j: usize| Slope::variable(self.y[j], j.checked_sub(first).unwrap_or(WIDTH));
            let f = (phase.derivative)(self.constants, phase.set, &core::array::from_fn(seed));
            for (row, f) in self.rows.iter_mut().zip(&f) {
                for (entry, slope) in row[first..].iter_mut().zip(f.gradient()) {
                    *entry = *slope;
                }
            }
        }
    }
}
