//! The exact Jacobian of a phase: its equations, run on dual numbers.

use super::Jacobian;
use super::arrays::array;
use super::lifted::Lifted;
use crate::hinge;
use crate::kernel::slopes;
use crate::model::{Array, BarSystem, ClosedForm, ContactSet, KernelView};
use crate::scalar::{Dual4, Scalar};

/// Derivatives taken in one evaluation.
const WIDTH: usize = 4;

/// Makes the Jacobian of the phase of a contact set.
pub(super) type JacobianOf<M, S> = for<'a> fn(&'a Lifted<M, S>, ContactSet) -> Jacobian<'a>;

/// That of a closed form, if the equations can be stiff; else nothing of it is compiled.
pub(super) fn of_closed<M: BarSystem, Q: ClosedForm<M, N>, const N: usize>() -> Option<JacobianOf<M, f64>> {
    if const { M::LAYOUT.compliant } { Some(closed::<M, Q, N>) } else { None }
}

/// That of the projected form, likewise.
pub(super) fn of_projected<M: BarSystem, const N: usize>() -> Option<JacobianOf<M, f64>> {
    if const { M::LAYOUT.compliant } { Some(projected::<M, N>) } else { None }
}

fn closed<M: BarSystem, Q: ClosedForm<M, N>, const N: usize>(
    system: &Lifted<M, f64>,
    set: ContactSet,
) -> Jacobian<'_> {
    let constants = constants::<M>(system, &set);
    let f = move |y: &[Dual4; N]| Q::derivative(&constants, y);
    Box::new(move |y, rows| differentiate(&f, y, rows))
}

fn projected<M: BarSystem, const N: usize>(system: &Lifted<M, f64>, set: ContactSet) -> Jacobian<'_> {
    let constants = constants::<M>(system, &set);
    let f = move |y: &[Dual4; N]| {
        let mut accelerations = M::Accelerations::from_fn(|_| Dual4::ZERO);
        let mut multipliers = M::Multipliers::from_fn(|_| Dual4::ZERO);
        let (a, lambda) = (accelerations.as_mut(), multipliers.as_mut());
        match const { M::LAYOUT.has_hinges() } {
            true => hinge::solution::<M, Dual4>(&constants, &set, &array(y), a, lambda),
            false => M::kernel(&constants, &array(y)).solve(M::LAYOUT, &set, a, lambda),
        };
        slopes(M::LAYOUT, y, accelerations.as_ref())
    };
    Box::new(move |y, rows| differentiate(&f, y, rows))
}

fn constants<M: BarSystem>(system: &Lifted<M, f64>, set: &ContactSet) -> M::Constants<Dual4> {
    let values = system.parameters.as_ref();
    M::constants_of(&Array::from_fn(|i| Dual4::constant(values[i])), set)
}

/// Writes ∂f/∂y row by row.
fn differentiate<const N: usize>(f: impl Fn(&[Dual4; N]) -> [Dual4; N], y: &[f64], rows: &mut [f64]) {
    for first in (0..N).step_by(WIDTH) {
        // Beyond the block an index is that of no variable.
        let seed = |j: usize| Dual4::variable(y[j], j.checked_sub(first).unwrap_or(WIDTH));
        for (row, f) in rows.chunks_exact_mut(N).zip(&f(&core::array::from_fn(seed))) {
            for (entry, derivative) in row[first..].iter_mut().zip(f.gradient()) {
                *entry = *derivative;
            }
        }
    }
}
