//! Quantiles of Student's distribution of ν degrees of freedom, for whole ν (Abramowitz and Stegun,
//! *Handbook of Mathematical Functions*, 1964, 26.7.3 and 26.7.4): with tan θ = t/√ν
//!
//! ```text
//! P(|T| ≤ t) = (2/π) (θ + sin θ (cos θ + 2/3 cos³θ + … + c cos^(ν−2) θ)),    ν odd
//! c = 2·4…(ν − 3)/(3·5…(ν − 2))
//! P(|T| ≤ t) = sin θ (1 + 1/2 cos²θ + … + c cos^(ν−2) θ),    ν even
//! c = 1·3…(ν − 3)/(2·4…(ν − 2))
//! ```
//!
//! All terms are positive: nothing cancels.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// The t with P(|T| ≤ t) = p, for ν ≥ 1 and 0 ≤ p < 1, by bisection of θ up to rounding.
pub(crate) fn two_sided_quantile(p: f64, freedom: usize) -> f64 {
    let (mut low, mut high) = (0.0, FRAC_PI_2);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return (freedom as f64).sqrt() * middle.tan();
        }
        if two_sided_probability(middle, freedom) < p { low = middle } else { high = middle }
    }
}

/// P(|T| ≤ √ν tan θ).
fn two_sided_probability(theta: f64, freedom: usize) -> f64 {
    let (sine, cosine) = theta.sin_cos();
    let is_odd = !freedom.is_multiple_of(2);
    let (mut term, mut sum) = (if is_odd { cosine } else { 1.0 }, 0.0);
    // The exponents of the cosine.
    for k in (usize::from(is_odd)..freedom.saturating_sub(1)).step_by(2) {
        sum += term;
        term *= (k + 1) as f64 / (k + 2) as f64 * cosine * cosine;
    }
    if is_odd { FRAC_2_PI * (theta + sine * sum) } else { sine * sum }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abramowitz and Stegun, table 26.10, and NIST/SEMATECH, *e-Handbook of Statistical Methods*,
    /// 1.3.6.7.2: to three digits.
    #[test]
    fn quantiles_are_those_of_tables() {
        let table = [
            (0.95, 1, 12.706),
            (0.95, 2, 4.303),
            (0.95, 3, 3.182),
            (0.95, 4, 2.776),
            (0.95, 5, 2.571),
            (0.95, 10, 2.228),
            (0.95, 29, 2.045),
            (0.95, 30, 2.042),
            (0.95, 100, 1.984),
            (0.8, 1, 3.078),
            (0.8, 7, 1.415),
            (0.99, 1, 63.657),
            (0.99, 6, 3.707),
            (0.99, 60, 2.660),
        ];
        for (p, freedom, t) in table {
            let found = two_sided_quantile(p, freedom);
            assert!((found - t).abs() <= 5.1e-4, "{p} {freedom} {found}");
        }
    }

    /// t = tan(πp/2), p √(2/(1 − p²)), and of four degrees of freedom 2 √(cos(⅓ arccos √a)/√a − 1)
    /// with a = 1 − p² (Shaw, *Sampling Student's T distribution*, Journal of Computational Finance
    /// 9, 2006).
    #[test]
    fn quantiles_of_one_two_and_four_degrees_have_closed_forms() {
        for p in [0.0, 1e-9, 0.1, 0.5, 0.9, 0.95, 0.99, 1.0 - 1e-6] {
            let root = f64::sqrt(1.0 - p * p);
            let four = ((root.acos() / 3.0).cos() / root - 1.0).max(0.0);
            let expected = [(1, (FRAC_PI_2 * p).tan()), (2, p * 2f64.sqrt() / root), (4, 2.0 * four.sqrt())];
            for (freedom, t) in expected {
                // Rounding of p is so much of 1 − p; that of the last form a root.
                let error = if freedom == 4 && p < 0.1 { 1e-7 } else { 1e-15 / (1.0 - p) };
                let found = two_sided_quantile(p, freedom);
                assert!((found - t).abs() <= 4.0 * error * t.max(1.0), "{p} {freedom} {found} {t}");
            }
        }
    }

    /// Of many degrees of freedom t = z + (z³ + z)/4ν + (5z⁵ + 16z³ + 3z)/96ν² + O(ν⁻³), 26.7.5.
    #[test]
    fn quantiles_come_to_those_of_the_normal_distribution() {
        let z = 1.959_963_984_540_054_f64;
        let second = (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / 96.0;
        for freedom in [1000, 1001, 100_000] {
            let n = freedom as f64;
            let expected = z + (z.powi(3) + z) / (4.0 * n) + second / (n * n);
            let found = two_sided_quantile(0.95, freedom);
            assert!((found - expected).abs() < 1e-12 + 5.0 / n.powi(3), "{freedom} {found} {expected}");
        }
    }
}
