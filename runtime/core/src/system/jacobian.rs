//! The exact Jacobian of a phase: its emitted derivative, run on dual numbers.

use super::Jacobian;
use super::lifted::Lifted;
use crate::model::{BarSystem, ContactSet, Form, Phase, PhaseVisitor};
use crate::scalar::Dual;

/// Derivatives taken in one evaluation. One width for all phases: emitted code is compiled for it once.
const WIDTH: usize = 4;

/// The number that the Jacobian is computed with.
type Dual4 = Dual<f64, WIDTH>;

/// ∂f/∂y of the derivative f of the phase of `set` and `form`, whose reduced state has `N` entries.
pub(super) fn jacobian_of<M: BarSystem, const N: usize>(
    system: &Lifted<M, f64>,
    set: ContactSet,
    form: Form,
) -> Jacobian<'_> {
    let constants = M::from_parameters(&system.parameters).constants::<Dual4>();
    Box::new(move |y, rows| M::phase(set, form, Differentiate::<M> { constants: &constants, y, rows }))
}

struct Differentiate<'a, M: BarSystem> {
    constants: &'a M::Constants<Dual4>,
    y: &'a [f64],
    rows: &'a mut [f64],
}

impl<M: BarSystem> PhaseVisitor<M, Dual4> for Differentiate<'_, M> {
    type Output = ();

    fn visit<const N: usize>(self, phase: Phase<M, Dual4, N>) {
        for first in (0..N).step_by(WIDTH) {
            // Beyond the block an index is that of no variable.
            let seed = |j: usize| Dual4::variable(self.y[j], j.checked_sub(first).unwrap_or(WIDTH));
            let f = (phase.derivative)(self.constants, phase.set, &core::array::from_fn(seed));
            for (row, f) in self.rows.chunks_exact_mut(N).zip(&f) {
                for (entry, slope) in row[first..].iter_mut().zip(f.gradient()) {
                    *entry = *slope;
                }
            }
        }
    }
}
