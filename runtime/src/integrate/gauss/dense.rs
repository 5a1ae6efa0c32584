//! The collocation polynomial p, of order s, and its defects at the ends, which make it one of order s + 1:
//! y′ − p′ is P_s(x)(κ₀ + κ₁ x) up to O(hˢ⁺²), x = 2θ − 1, with κ₀ + κ₁ and (−1)ˢ(κ₀ − κ₁) the defects at 1 and 0.
//! Both integrals vanish at both ends.

use super::legendre::{STAGES, nodes, round, values};
use super::tableau::Tableau;
use crate::scalar::{DoubleDouble, Real, Scalar};

/// Degree s + 2.
pub(super) const TERMS: usize = STAGES + 3;

/// A polynomial in θ, by powers.
type Powers = [DoubleDouble; TERMS];

/// Coefficients for θ and 1 − θ in turn, of each polynomial that Lⱼ is multiplied with, then κ₀ and κ₁.
pub(super) struct Basis {
    columns: [[f64; TERMS]; STAGES + 2],
}

impl Basis {
    pub(super) fn new() -> Self {
        let zero = DoubleDouble::ZERO;
        let mut legendre = [[zero; TERMS]; STAGES + 1];
        legendre[0][0] = DoubleDouble::ratio(1, 1);
        for k in 0..STAGES {
            let n = k as i64;
            let turned = times_x(&legendre[k]);
            let before = if k == 0 { [zero; TERMS] } else { legendre[k - 1] };
            legendre[k + 1] = core::array::from_fn(|i| {
                DoubleDouble::ratio(2 * n + 1, n + 1) * turned[i] - DoubleDouble::ratio(n, n + 1) * before[i]
            });
        }
        let at = nodes().map(|(x, _)| values(x));
        let column = |j: usize| match j {
            // Σ (2k+1) Pₖ(xⱼ) Pₖ.
            _ if j < STAGES => core::array::from_fn(|i| {
                let term = |k: usize| DoubleDouble::ratio(2 * k as i64 + 1, 1) * at[j][k] * legendre[k][i];
                (0..STAGES).fold(zero, |sum, k| sum + term(k))
            }),
            STAGES => legendre[STAGES],
            _ => times_x(&legendre[STAGES]),
        };
        Self { columns: core::array::from_fn(|j| alternating(integral(&column(j)))) }
    }

    /// Coefficients of the step from `y0` with these Lⱼ, and the defects h(f − p′) at both ends.
    pub(super) fn coefficients<const N: usize>(
        &self,
        y0: &[f64; N],
        l: &[[f64; N]; STAGES],
        defects: &[[f64; N]; 2],
    ) -> [[f64; N]; TERMS] {
        let sign = if STAGES.is_multiple_of(2) { 1.0 } else { -1.0 };
        let mut terms = [[0.0; N]; TERMS];
        for (k, term) in terms.iter_mut().enumerate() {
            *term = core::array::from_fn(|i| {
                let (first, last) = (0.5 * sign * defects[0][i], 0.5 * defects[1][i]);
                let stages: f64 = l.iter().zip(&self.columns).map(|(l, column)| column[k] * l[i]).sum();
                let [even, odd] = [&self.columns[STAGES], &self.columns[STAGES + 1]];
                stages + even[k] * (last + first) + odd[k] * (last - first)
            });
        }
        terms[0] = *y0;
        terms
    }
}

/// h p′ at the ends, 0 and 1: Σ (2k+1) Pₖ(±1) Σ Pₖ(xⱼ) Lⱼ.
pub(super) fn end_rates<const N: usize>(tableau: &Tableau, l: &[[f64; N]; STAGES]) -> [[f64; N]; 2] {
    [-1.0, 1.0].map(|x: f64| {
        core::array::from_fn(|i| {
            let mode = |k: usize| (0..STAGES).map(|j| tableau.modes[k][j] * l[j][i]).sum::<f64>();
            (0..STAGES).map(|k| (2 * k + 1) as f64 * x.powi(k as i32) * mode(k)).sum()
        })
    })
}

/// x p, x = 2θ − 1.
fn times_x(p: &Powers) -> Powers {
    let two = DoubleDouble::ratio(2, 1);
    core::array::from_fn(|i| if i == 0 { -p[0] } else { two * p[i - 1] - p[i] })
}

/// ∫₀^θ p.
fn integral(p: &Powers) -> Powers {
    core::array::from_fn(|i| {
        if i == 0 { DoubleDouble::ZERO } else { p[i - 1] / DoubleDouble::ratio(i as i64, 1) }
    })
}

/// p = p(0) + θ q, q = q(1) − (1 − θ) r, and r so again.
fn alternating(mut p: Powers) -> [f64; TERMS] {
    let zero = DoubleDouble::ZERO;
    core::array::from_fn(|k| {
        if k % 2 == 1 {
            // Horner's scheme at 1: the remainder, then −r.
            let mut sum = zero;
            for entry in p.iter_mut().rev() {
                sum = sum + *entry;
                *entry = sum;
            }
            p = p.map(|entry| -entry);
            p[0] = -p[0];
        }
        let term = round(p[0]);
        p[0] = zero;
        p.rotate_left(1);
        term
    })
}
