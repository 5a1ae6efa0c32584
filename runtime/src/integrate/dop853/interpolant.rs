//! Dense output of order 7 (Hairer, Nørsett, Wanner I, II.6, eq. 6.30 ff.):
//! y(t₀ + θh) = y₀ + θ(F₀ + θ̄(F₁ + θ(F₂ + θ̄(F₃ + θ(F₄ + θ̄(F₅ + θF₆)))))), θ̄ = 1 − θ.
//! F₀, F₁, F₂ make it Hermite's cubic; the rest vanishes doubly at both ends.

use super::Step;
use super::coefficients::{A14, A15, A16, D4, D5, D6, D7};
use super::stages::{LAST, advance, combine};
use crate::scalar::Scalar;

/// y(t) over one step, a polynomial of degree 7; continuous with its derivative from step to step.
#[derive(Clone, Copy, Debug)]
pub struct Interpolant<S, const N: usize> {
    /// Time at the start.
    pub t0: S,
    /// Length of the step.
    pub h: S,
    y0: [S; N],
    y1: [S; N],
    coefficients: [[S; N]; 7],
}

impl<S: Scalar, const N: usize> Interpolant<S, N> {
    /// Evaluations of f that it takes.
    pub(super) const EVALUATIONS: u64 = 3;

    pub(super) fn new(step: &Step<S, N>, f: impl Fn(&[S; N]) -> [S; N]) -> Self {
        let &Step { t0, h, y0, y1, ref slopes, .. } = step;
        let mut k = [slopes[0]; LAST + 4];
        k[..=LAST].copy_from_slice(slopes);
        k[LAST + 1] = f(&advance(&y0, h, &combine(&k, &A14)));
        k[LAST + 2] = f(&advance(&y0, h, &combine(&k, &A15)));
        k[LAST + 3] = f(&advance(&y0, h, &combine(&k, &A16)));
        let rise: [S; N] = core::array::from_fn(|i| y1[i] - y0[i]);
        let start: [S; N] = core::array::from_fn(|i| h * k[0][i] - rise[i]);
        let end = core::array::from_fn(|i| rise[i] - h * k[LAST][i] - start[i]);
        let high = [combine(&k, &D4), combine(&k, &D5), combine(&k, &D6), combine(&k, &D7)];
        let [f3, f4, f5, f6] = high.map(|sum| sum.map(|x| h * x));
        let coefficients = [rise, start, end, f3, f4, f5, f6];
        Self { t0, h, y0, y1, coefficients }
    }

    /// Hermite's cubic over a step from t₀ of length h, with the values and slopes at its ends.
    pub fn cubic((t0, h): (S, S), [y0, y1]: [[S; N]; 2], [f0, f1]: [[S; N]; 2]) -> Self {
        let rise: [S; N] = core::array::from_fn(|i| y1[i] - y0[i]);
        let start: [S; N] = core::array::from_fn(|i| h * f0[i] - rise[i]);
        let end = core::array::from_fn(|i| rise[i] - h * f1[i] - start[i]);
        let none = [S::ZERO; N];
        Self { t0, h, y0, y1, coefficients: [rise, start, end, none, none, none, none] }
    }

    /// The state at t₀ + θh, 0 ≤ θ ≤ 1; exactly the step's own at both ends.
    pub fn at(&self, theta: S) -> [S; N] {
        let one = S::ratio(1, 1);
        if theta == one {
            return self.y1;
        }
        let weights = [one - theta, theta];
        core::array::from_fn(|i| {
            let inner = (0..6)
                .rev()
                .fold(self.coefficients[6][i], |sum, j| weights[j % 2].mul_add(sum, self.coefficients[j][i]));
            theta.mul_add(inner, self.y0[i])
        })
    }

    /// dy/dt at t₀ + θh.
    pub fn rate(&self, theta: S) -> [S; N] {
        let one = S::ratio(1, 1);
        let weights = [(one - theta, -one), (theta, one)];
        core::array::from_fn(|i| {
            let last = (self.coefficients[6][i], S::ZERO);
            let (value, slope) = (0..6).rev().fold(last, |(value, slope), j| {
                let (weight, change) = weights[j % 2];
                let slope = weight.mul_add(slope, change * value);
                (weight.mul_add(value, self.coefficients[j][i]), slope)
            });
            theta.mul_add(slope, value) / self.h
        })
    }
}
