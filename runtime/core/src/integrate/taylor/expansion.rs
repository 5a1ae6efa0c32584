//! What the method asks of the equations.

use crate::series::ORDERS;

/// The equations y′ = f(y) as a source of Taylor coefficients; it keeps those of the last
/// expansion.
pub trait Expansion<const N: usize> {
    /// Expands y(t₀ + `unit` θ) = Σ cₖ θᵏ from c₀ = `state` up to k = `order` < [`ORDERS`].
    fn expand(&mut self, state: &[f64; N], unit: f64, order: usize);
    /// c₀, c₁, …, those beyond the order of the last expansion without meaning.
    fn series(&self) -> &[[f64; N]; ORDERS];
    /// f; the series and the guards are left as they are. An expansion at the same state that
    /// follows has its values already.
    fn rates(&mut self, state: &[f64; N]) -> [f64; N];
    /// The guards of the last expansion over 0 ≤ θ ≤ `ratio`, if it has any.
    fn guards(&mut self, ratio: f64) -> Option<Guards<'_>>;
}

/// Series of what tells when a contact opens or closes: Σ cₖ θᵏ, 0 ≤ θ ≤ 1 over the step.
#[derive(Clone, Copy, Debug)]
pub struct Guards<'a> {
    /// Coefficients of each.
    terms: usize,
    reactions: &'a [[f64; ORDERS]],
    gaps: &'a [[f64; ORDERS]],
    feet: &'a [[f64; ORDERS]],
}

impl<'a> Guards<'a> {
    /// The first `terms` coefficients of each: of reactions, of gaps, and of both distances of each
    /// foot.
    pub fn new(
        terms: usize,
        reactions: &'a [[f64; ORDERS]],
        gaps: &'a [[f64; ORDERS]],
        feet: &'a [[f64; ORDERS]],
    ) -> Self {
        Self { terms, reactions, gaps, feet }
    }

    /// The reaction of a contact, zero where open; behind those of the contacts the friction
    /// forces.
    pub fn reaction(&self, contact: usize) -> &'a [f64] {
        &self.reactions[contact][..self.terms]
    }

    /// The gap of a contact, zero where closed; behind those of the contacts the slip velocities,
    /// zero but where one slides.
    pub fn gap(&self, contact: usize) -> &'a [f64] {
        &self.gaps[contact][..self.terms]
    }

    /// Distance of a foot from its bar's first (`end` 0) or last point (1).
    pub fn foot(&self, foot: usize, end: usize) -> &'a [f64] {
        &self.feet[2 * foot + end][..self.terms]
    }
}
