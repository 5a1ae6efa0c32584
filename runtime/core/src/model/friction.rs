//! Coulomb friction at a contact: |R| ≤ μₛ N while it sticks, R = −σ μ N with σ = sign v while it
//! slides.

/// What friction depends on, at a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlipState<S> {
    /// v, the velocity along the tangent relative to the surface.
    pub velocity: S,
    /// μ, the coefficient of sliding friction at that velocity.
    pub kinetic: S,
    /// μₛ, the coefficient of static friction.
    pub limit: S,
}
