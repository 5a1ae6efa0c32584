//! Functions over a step as series of Legendre's polynomials, f(x) = Σ cₘ Pₘ(x) with −1 ≤ x ≤ 1.
//!
//! Through the values at Gauss's points cₘ = (m + ½) Σ wₖ Pₘ(xₖ) f(xₖ), and ∫ Pₘ = (Pₘ₊₁ −
//! Pₘ₋₁)/(2m + 1).

/// How many points.
pub(crate) const POINTS: usize = 8;
/// Gauss's points and weights (Abramowitz and Stegun 25.4.30).
pub(crate) const X: [f64; POINTS] = [
    -0.960_289_856_497_536_2,
    -0.796_666_477_413_626_7,
    -0.525_532_409_916_329,
    -0.183_434_642_495_649_8,
    0.183_434_642_495_649_8,
    0.525_532_409_916_329,
    0.796_666_477_413_626_7,
    0.960_289_856_497_536_2,
];
pub(crate) const W: [f64; POINTS] = [
    0.101_228_536_290_376_26,
    0.222_381_034_453_374_47,
    0.313_706_645_877_887_3,
    0.362_683_783_378_362,
    0.362_683_783_378_362,
    0.313_706_645_877_887_3,
    0.222_381_034_453_374_47,
    0.101_228_536_290_376_26,
];
/// Terms of a function that was integrated twice.
pub(crate) const TERMS: usize = POINTS + 2;

/// c₀, c₁, …
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LegendreSeries([f64; TERMS]);

impl LegendreSeries {
    /// The polynomial through values at Gauss's points.
    pub(crate) fn through(values: impl Fn(usize) -> f64) -> Self {
        let mut terms = [0.0; TERMS];
        for (k, (x, w)) in X.iter().zip(W).enumerate() {
            let (value, p) = (values(k), polynomials(*x));
            for m in 0..POINTS {
                terms[m] += (m as f64 + 0.5) * w * p[m] * value;
            }
        }
        Self(terms)
    }

    /// The last two coefficients of a function through values, as a part of the largest.
    pub(crate) fn tail(&self) -> f64 {
        let largest = |terms: &[f64]| terms.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
        let all = largest(&self.0);
        if all > 0.0 { largest(&self.0[POINTS - 2..]) / all } else { 0.0 }
    }

    /// f₀ + ½h ∫ f from x = −1, the last term of a full series left out.
    pub(crate) fn integral(&self, f0: f64, h: f64) -> Self {
        let mut terms = [0.0; TERMS];
        for (m, c) in self.0[..TERMS - 1].iter().enumerate() {
            let part = 0.5 * h * c / (2.0 * m as f64 + 1.0);
            terms[m + 1] += part;
            terms[m.saturating_sub(1)] += if m == 0 { part } else { -part };
        }
        terms[0] += f0;
        Self(terms)
    }

    pub(crate) fn evaluate(&self, x: f64) -> f64 {
        self.0.iter().zip(polynomials(x)).map(|(c, p)| c * p).sum()
    }

    /// Coefficients of the powers of θ = (x + 1)/2: Pₘ = Σ (−1)ᵐ⁺ᵏ C(m, k) C(m + k, k) θᵏ.
    pub(crate) fn powers(&self) -> [f64; TERMS] {
        let mut powers = [0.0; TERMS];
        for (m, c) in self.0.iter().enumerate() {
            let mut product = if m % 2 == 0 { 1.0 } else { -1.0 };
            for (k, power) in powers.iter_mut().enumerate().take(m + 1) {
                *power += c * product;
                product *= -((m - k) as f64) * ((m + k + 1) as f64) / ((k + 1) as f64).powi(2);
            }
        }
        powers
    }
}

/// P₀ … at x by their recurrence.
fn polynomials(x: f64) -> [f64; TERMS] {
    let mut p = [1.0; TERMS];
    p[1] = x;
    for m in 1..TERMS - 1 {
        let k = m as f64;
        p[m + 1] = ((2.0 * k + 1.0) * x * p[m] - k * p[m - 1]) / (k + 1.0);
    }
    p
}

#[cfg(test)]
mod tests {
    use super::*;

    /// f = 6x² integrates to 2x³ + 2, and again to x⁴/2 + 2x + 3/2, over a step of length 2.
    #[test]
    fn polynomials_are_integrated_exactly() {
        let twice = LegendreSeries::through(|k| 6.0 * X[k] * X[k]).integral(0.0, 2.0).integral(0.0, 2.0);
        let powers = twice.powers();
        for x in [-1.0, -0.3, 0.0, 0.7, 1.0_f64] {
            let exact = 0.5 * x.powi(4) + 2.0 * x + 1.5;
            let theta = 0.5 * (x + 1.0);
            let horner = powers.iter().rev().fold(0.0, |sum, c| sum * theta + c);
            assert!((twice.evaluate(x) - exact).abs() < 1e-14, "{x}");
            assert!((horner - exact).abs() < 1e-13, "{x}");
        }
    }
}
