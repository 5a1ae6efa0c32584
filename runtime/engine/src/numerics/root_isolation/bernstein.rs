//! A polynomial in the Bernstein basis, p(x) = Σ bⱼ C(n, j) xʲ (1 − x)ⁿ⁻ʲ, whose coefficients bound
//! it on 0 ≤ x ≤ 1 (Farouki, *CAGD* 29 (2012) 379).

use super::polynomial::{FINE, Polynomial};

/// Bernstein coefficients on an interval, up to `degree`.
#[derive(Clone, Copy)]
pub(super) struct Bernstein {
    pub(super) degree: usize,
    coefficients: [f64; FINE + 1],
}

impl Bernstein {
    /// From powers: aₖ / C(n, k) are the differences Δᵏb₀, and Δᵏbⱼ₊₁ = Δᵏbⱼ + Δᵏ⁺¹bⱼ.
    pub(super) fn from_powers(a: &[f64]) -> Self {
        let mut p = Self::zero(a.len().saturating_sub(1));
        let n = p.degree;
        let mut differences = [0.0; FINE + 1];
        let mut choose = 1.0;
        for (k, (difference, a)) in differences.iter_mut().zip(a).enumerate() {
            *difference = a / choose;
            choose = choose * (n - k) as f64 / (k + 1) as f64;
        }
        for j in 0..=n {
            p.coefficients[j] = differences[0];
            for k in 0..n - j {
                differences[k] += differences[k + 1];
            }
        }
        p
    }

    /// Clenshaw's recurrence bₖ = cₖ + 2y bₖ₊₁ − bₖ₊₂, y = 2x − 1, on Bernstein coefficients.
    pub(super) fn from_chebyshev(p: &Polynomial) -> Self {
        let mut next = Self::constant(0.0);
        let mut b = Self::constant(p.coefficients[p.degree]);
        for k in (0..p.degree).rev() {
            let factor = if k == 0 { 1.0 } else { 2.0 };
            let mut sum = b.times_y();
            let raised = if b.degree == 0 { Self::zero(1) } else { next.raised().raised() };
            for (sum, below) in sum.coefficients.iter_mut().zip(raised.coefficients) {
                *sum = p.coefficients[k] + factor * *sum - below;
            }
            (b, next) = (sum, b);
        }
        b
    }

    fn zero(degree: usize) -> Self {
        Self { degree, coefficients: [0.0; FINE + 1] }
    }

    fn constant(value: f64) -> Self {
        let mut p = Self::zero(0);
        p.coefficients[0] = value;
        p
    }

    pub(super) fn terms(&self) -> &[f64] {
        &self.coefficients[..=self.degree]
    }

    /// Bounds of the polynomial.
    pub(super) fn range(&self) -> [f64; 2] {
        let widen = |[low, high]: [f64; 2], b: &f64| [low.min(*b), high.max(*b)];
        self.terms().iter().fold([f64::INFINITY, f64::NEG_INFINITY], widen)
    }

    /// The product with αx̄ + βx, one degree up: α (n−j)/n bⱼ + β j/n bⱼ₋₁.
    fn times(&self, alpha: f64, beta: f64) -> Self {
        let mut product = Self::zero(self.degree + 1);
        let n = product.degree as f64;
        for (j, &b) in self.terms().iter().enumerate() {
            product.coefficients[j] += alpha * (n - j as f64) / n * b;
            product.coefficients[j + 1] += beta * (j as f64 + 1.0) / n * b;
        }
        product
    }

    fn times_y(&self) -> Self {
        self.times(-1.0, 1.0)
    }

    fn raised(&self) -> Self {
        self.times(1.0, 1.0)
    }

    /// The coefficients on either half (de Casteljau).
    pub(super) fn halves(mut self) -> [Self; 2] {
        let n = self.degree;
        let mut left = self;
        for level in 1..=n {
            for i in 0..=n - level {
                self.coefficients[i] = 0.5 * (self.coefficients[i] + self.coefficients[i + 1]);
            }
            left.coefficients[level] = self.coefficients[0];
        }
        [left, self]
    }
}
