//! What the method asks of the equations.

use crate::series::ORDERS;

/// The equations y′ = f(y) as a source of Taylor coefficients.
pub trait Expansion<const N: usize> {
    /// Fills `series[1..=order]`, y(t₀ + `unit` θ) = Σ `series[k]` θᵏ; `series[0]` is given, `order` < [`ORDERS`].
    fn expand(&mut self, unit: f64, order: usize, series: &mut [[f64; N]; ORDERS]);
    /// The guards of the last expansion over 0 ≤ θ ≤ `ratio`, if it has any.
    fn guards(&mut self, ratio: f64) -> Option<Guards<'_>>;
}

/// Series of what tells when a contact opens or closes: Σ cₖ θᵏ, 0 ≤ θ ≤ 1 over the step.
#[derive(Clone, Copy, Debug)]
pub struct Guards<'a> {
    /// Coefficients of each.
    pub(super) terms: usize,
    pub(super) reactions: &'a [[f64; ORDERS]],
    pub(super) gaps: &'a [[f64; ORDERS]],
    pub(super) feet: &'a [[f64; ORDERS]],
}

impl<'a> Guards<'a> {
    /// The reaction of a contact, zero where open.
    pub fn reaction(&self, contact: usize) -> &'a [f64] {
        &self.reactions[contact][..self.terms]
    }

    /// The gap of a contact, zero where closed.
    pub fn gap(&self, contact: usize) -> &'a [f64] {
        &self.gaps[contact][..self.terms]
    }

    /// Distance of a foot from its bar's first (`end` 0) or last point (1).
    pub fn foot(&self, foot: usize, end: usize) -> &'a [f64] {
        &self.feet[2 * foot + end][..self.terms]
    }
}
