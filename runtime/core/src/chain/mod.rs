//! A chain of equal bars, hinged end to end, its first end pinned: equations of any length by
//! loops.
//!
//! Every angle is measured from one fixed direction, the first axis; e = (cos θ, sin θ) runs along
//! a bar, n = (−sin θ, cos θ) across it. The centre of mass is at the middle. With λₖ the force on
//! bar k at its first end over the mass of a bar, λ_N = 0, Newton's and Euler's equations of bar k
//! give the accelerations of its two ends,
//!
//! ```text
//! aₖ   = g + ½ l ω² e + (1 + κ n nᵀ) λₖ − Y λₖ₊₁,    Y = 1 − κ n nᵀ,    κ = m l²/4J
//! aₖ₊₁ = g − ½ l ω² e − (1 + κ n nᵀ) λₖ₊₁ + Y λₖ,    ω̇ = −(m l/2J) n·(λₖ + λₖ₊₁)
//! ```
//!
//! (R. Featherstone, *Rigid Body Dynamics Algorithms*, 2008, § 7.1: the inverse inertias of a body
//! with two handles). Neighbours share an end, and the pin rests: a symmetric block-tridiagonal
//! system for the forces, which `elimination` solves from both ends at once in O(N); of many states
//! side by side `articulated` computes the accelerations from the free end and back. Both are
//! regular in every position, stretched or folded, as long as J > 0; from both ends as many digits
//! are lost as J is smaller than m l².

mod articulated;
mod dense;
mod elimination;
mod geometry;
mod joint;
mod plane;
mod two_ended;

use crate::scalar::Real;
use geometry::Bars;
use plane::PlaneVector;

/// Equal bars, the first pinned.
#[derive(Clone, Copy, Debug)]
pub struct Chain<S> {
    mass: S,
    length: S,
    inertia: S,
    gravity: PlaneVector<S>,
    /// κ.
    slenderness: S,
    /// m l/2J.
    lever: S,
}

impl<S: Real> Chain<S> {
    /// `mass`, `length` and `inertia` of one bar, the last about its centre and positive; `gravity`
    /// along the two axes.
    #[inline(always)]
    pub fn new(mass: S, length: S, inertia: S, gravity: [S; 2]) -> Self {
        let lever = mass * length * S::ratio(1, 2) / inertia;
        let slenderness = lever * length * S::ratio(1, 2);
        Self { mass, length, inertia, gravity: PlaneVector::from(gravity), slenderness, lever }
    }

    /// The same from κ = m l²/4J, `slenderness`, and m l/2J, `lever`, computed before.
    #[inline(always)]
    pub fn prepared(mass: S, length: S, inertia: S, gravity: [S; 2], slenderness: S, lever: S) -> Self {
        Self { mass, length, inertia, gravity: PlaneVector::from(gravity), slenderness, lever }
    }

    /// The angular acceleration of each bar, J not much smaller than m l².
    #[inline]
    pub fn accelerations<const N: usize>(&self, angles: &[S; N], rates: &[S; N]) -> [S; N] {
        if S::MANY {
            return self.articulated(angles, rates);
        }
        let mut accelerations = *rates;
        Bars::compute(self, angles, rates).solve(self.gravity, |bar, turn, _| accelerations[bar] = turn);
        accelerations
    }

    /// The force on each bar at its first end, along the two axes: of the pin, then of the bar
    /// before.
    #[inline]
    pub fn joint_forces<const N: usize>(&self, angles: &[S; N], rates: &[S; N]) -> [[S; 2]; N] {
        let mut forces = [[S::ratio(0, 1); 2]; N];
        let at_first =
            |bar: usize, _, first: PlaneVector<S>| forces[bar] = [self.mass * first.x, self.mass * first.y];
        Bars::compute(self, angles, rates).solve(self.gravity, at_first);
        forces
    }
}

#[cfg(test)]
mod tests;
