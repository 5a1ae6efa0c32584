//! The motion over one step as a polynomial in θ = (t − t₀)/h, nested: y(t₀ + θh) = c₀ + w₁(c₁ +
//! w₂(c₂ + w₃(c₃ + …))), with all wₖ = θ (a Taylor series), or with θ and θ̄ = 1 − θ in turn:
//! Newton's form on the nodes 0, 1, 0, 1, …, in which c₀, c₁, c₂, c₃ make Hermite's cubic and the
//! rest vanishes doubly at both ends.

use super::store::{Terms, terms};
use crate::scalar::Scalar;

/// y(t) over one step; exactly the step's own states at both ends.
#[derive(Debug)]
pub struct Dense<S, const N: usize> {
    /// Time at the start.
    pub t0: S,
    /// Length of the step.
    pub h: S,
    /// Time at the end.
    pub t1: S,
    y1: [S; N],
    alternating: bool,
    coefficients: Terms<[S; N]>,
}

impl<S: Copy, const N: usize> Clone for Dense<S, N> {
    fn clone(&self) -> Self {
        Self { coefficients: self.coefficients.clone(), ..*self }
    }

    /// Within the room there is.
    fn clone_from(&mut self, other: &Self) {
        (self.t0, self.h, self.t1, self.y1) = (other.t0, other.h, other.t1, other.y1);
        self.alternating = other.alternating;
        self.coefficients.clone_from(&other.coefficients);
    }
}

impl<S: Scalar, const N: usize> Dense<S, N> {
    /// Nothing yet, with room for so many coefficients.
    pub fn with_room(room: usize) -> Self {
        let zero = S::ZERO;
        let coefficients = terms(room, [zero; N]);
        Self { t0: zero, h: zero, t1: zero, y1: [zero; N], alternating: false, coefficients }
    }

    /// The state y₀ at time t₀.
    pub fn still(t0: S, y0: [S; N]) -> Self {
        let mut dense = Self::with_room(1);
        dense.set_powers([t0, t0], y0, [y0]);
        dense
    }

    /// Takes a series y(t₀ + θh) = Σ cₖ θᵏ that ends in y₁.
    pub fn set_powers(&mut self, times: [S; 2], y1: [S; N], terms: impl IntoIterator<Item = [S; N]>) {
        self.set(false, times, y1, terms);
    }

    /// Takes coefficients for θ and 1 − θ in turn, and the end y₁.
    pub fn set_alternating(&mut self, times: [S; 2], y1: [S; N], terms: impl IntoIterator<Item = [S; N]>) {
        self.set(true, times, y1, terms);
    }

    fn set(
        &mut self,
        alternating: bool,
        [t0, t1]: [S; 2],
        y1: [S; N],
        terms: impl IntoIterator<Item = [S; N]>,
    ) {
        (self.t0, self.h, self.t1) = (t0, t1 - t0, t1);
        (self.y1, self.alternating) = (y1, alternating);
        self.coefficients.clear();
        self.coefficients.extend(terms);
    }

    /// Hermite's cubic between two times, with the values and slopes there.
    pub fn cubic(times: [S; 2], ends: [[S; N]; 2], slopes: [[S; N]; 2]) -> Self {
        let mut cubic = Self::with_room(4);
        cubic.set_alternating(times, ends[1], hermite(times[1] - times[0], ends, slopes));
        cubic
    }

    /// The state at t₀ + θh, 0 ≤ θ ≤ 1.
    pub fn interpolate(&self, theta: S) -> [S; N] {
        let one = S::ratio(1, 1);
        if theta == one {
            return self.y1;
        }
        let weights = [theta, if self.alternating { one - theta } else { theta }];
        let Some((last, rest)) = self.coefficients.split_last() else { return self.y1 };
        rest.iter()
            .enumerate()
            .rev()
            .fold(*last, |sum, (k, c)| core::array::from_fn(|i| weights[k % 2].mul_add(sum[i], c[i])))
    }

    /// dy/dt at t₀ + θh.
    pub fn rate(&self, theta: S) -> [S; N] {
        let one = S::ratio(1, 1);
        let other = if self.alternating { (one - theta, -one) } else { (theta, one) };
        let weights = [(theta, one), other];
        let zero = [S::ZERO; N];
        let Some((last, rest)) = self.coefficients.split_last() else { return zero };
        let (_, slope) = rest.iter().enumerate().rev().fold((*last, zero), |(value, slope), (k, c)| {
            let (weight, change) = weights[k % 2];
            let next = core::array::from_fn(|i| weight.mul_add(value[i], c[i]));
            (next, core::array::from_fn(|i| weight.mul_add(slope[i], change * value[i])))
        });
        slope.map(|x| x / self.h)
    }

    /// The series y(t₀ + θh) = Σ cₖ θᵏ, if it is one.
    pub fn powers(&self) -> Option<&[[S; N]]> {
        (!self.alternating).then_some(&self.coefficients)
    }

    /// All coefficients c₀, c₁, ….
    #[cfg(feature = "std")]
    pub(crate) fn coefficients(&self) -> &[[S; N]] {
        &self.coefficients
    }

    /// The state at the end.
    pub fn end(&self) -> &[S; N] {
        &self.y1
    }
}

/// c₀ … c₃ of Hermite's cubic.
pub(super) fn hermite<S: Scalar, const N: usize>(
    h: S,
    [y0, y1]: [[S; N]; 2],
    [f0, f1]: [[S; N]; 2],
) -> [[S; N]; 4] {
    let rise: [S; N] = core::array::from_fn(|i| y1[i] - y0[i]);
    let start: [S; N] = core::array::from_fn(|i| h * f0[i] - rise[i]);
    let end = core::array::from_fn(|i| rise[i] - h * f1[i] - start[i]);
    [y0, rise, start, end]
}
