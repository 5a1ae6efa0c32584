//! Contacts with Coulomb friction: which of them open, stick or slide, at acceleration level.
//!
//! ```text
//! M a = f + J_Nᵀ λ_N + J_tᵀ R + J_fixedᵀ λ,    0 ≤ J_N a + b_N ⟂ λ_N ≥ 0
//! v ≠ 0:            R = −σ μ λ_N,      σ = sign v
//! v = 0, v̇ = 0:    |R| ≤ μ_s λ_N
//! v = 0, v̇ ≠ 0:    R = −σ μ λ_N,      σ = sign v̇,    v̇ = J_t a + b_t
//! ```
//!
//! A contact that slides has the column J_N − σ μ J_t against the row J_N: the problem is not
//! symmetric, and may have several solutions or none (Painlevé, *Sur les lois du frottement de
//! glissement*, C. R. Acad. Sci. 121, 1895). Few contacts are decided by trying all combinations of
//! modes, which counts the solutions ([`enumeration`]), many by Lemke's method on the linear
//! complementarity problem of planar friction ([`many`]), which finds one.
//!
//! Of several solutions the limit of stiff compliant contacts decides ([`stability`]): one whose
//! closed contacts cannot be held by springs, however stiff, is not taken; of the others the one
//! with the fewest closed contacts is, and of these the one with the most that stick. What order 0
//! leaves at zero, however redundant contacts share their load ([`inside`]), is given as
//! [`Frictional`] for the next order ([`modes`]).

mod basis;
mod cone;
mod decision;
mod enumeration;
mod grip;
pub(in crate::contact) mod impact;
mod inside;
mod lemke;
mod limit;
mod many;
mod modes;
mod planar_lcp;
mod problem;
mod shares;
mod stability;
#[cfg(test)]
pub(in crate::contact) mod tests;

pub(crate) use decision::{FrictionError, FrictionSolution, Reason};
pub(crate) use grip::{LastMargin, SharedFriction, SharedFrictionMargin, margin};
pub(crate) use modes::{ContactMode, Frictional, SlipDirection, SlipVelocity};
pub(crate) use problem::FrictionProblem;
pub(crate) use stability::{holds, least_hold};
