//! Radau IIA as a method, with the exact Jacobian of the phase.

use super::{Begun, Method, Problem};
use crate::integrate;
use crate::model::{BarSystem, jacobian};

/// Radau IIA of order 5, for stiff springs and dampers: [`integrate::Radau`].
#[derive(Debug, Clone, Copy, Default)]
pub struct Radau;

impl Method for Radau {
    fn name(&self) -> &'static str {
        "radau"
    }

    fn begin<'a, M: BarSystem, const N: usize>(&self, problem: Problem<'a, M, N>) -> Begun<'a, N> {
        let (set, form) = (problem.phase.set, problem.phase.form);
        let constants = M::from_parameters(problem.parameters).constants();
        let exact = move |y: &[f64; N]| jacobian::<M, N>(&constants, set, form, y);
        Begun::asked(self, integrate::Radau::new(problem.rates, exact, problem.progress))
    }
}
