//! The step once more, with twice as many stages: its collocation polynomial has the order that the
//! step has at its end. y = y₀ + Σ (2k+1) mₖ ∫₀^θ Pₖ with the modes mₖ of h y′.

use super::legendre::{FINE, next, round};
use super::stages::{CollocationEquations, Sum};
use super::tableau::Tableau;
use crate::integrate::Rates;
use crate::scalar::{DoubleDouble, Real, Scalar};

/// Of a polynomial of degree [`FINE`].
pub(super) const TERMS: usize = FINE + 1;

/// A polynomial in θ, by powers.
type Powers = [DoubleDouble; TERMS];

/// The method with twice as many stages, and the polynomials (2k+1) ∫ Pₖ by coefficients for θ and
/// 1 − θ in turn.
pub(super) struct Fine {
    tableau: Tableau<FINE>,
    integrals: [[f64; TERMS]; FINE],
}

impl Fine {
    pub(super) fn new() -> Self {
        let zero = DoubleDouble::ZERO;
        let mut legendre = [[zero; TERMS]; FINE];
        legendre[0][0] = DoubleDouble::ratio(1, 1);
        legendre[1] = times_x(&legendre[0]);
        for k in 1..FINE - 1 {
            let turned = times_x(&legendre[k]);
            legendre[k + 1] = core::array::from_fn(|i| next(k, turned[i], legendre[k - 1][i]));
        }
        let weighted = |k: usize| legendre[k].map(|p| DoubleDouble::ratio(2 * k as i64 + 1, 1) * p);
        let integrals = core::array::from_fn(|k| alternating(integral(&weighted(k))));
        Self { tableau: Tableau::new(), integrals }
    }

    /// Coefficients of the step of length `h` from `y0` whose slopes have these modes, for a start;
    /// stages are found to `enough`, and left as they were where they cannot be. Counts evaluations
    /// of f.
    pub(super) fn coefficients<const N: usize>(
        &self,
        (f, pairs): (Rates<f64, N>, usize),
        (y0, h): (&[f64; N], f64),
        (modes, enough): (&[[f64; N]], &[f64; N]),
        evaluations: &mut u64,
    ) -> [[f64; N]; TERMS] {
        let guess = self.tableau.of_modes(modes);
        let mut l = guess;
        let equations = CollocationEquations { f, tableau: &self.tableau, pairs };
        if equations.solve((&Sum::new(*y0), h), &mut l, [enough, &[0.0; N]], evaluations).is_err() {
            l = guess;
        }
        let modes = self.tableau.modes(&l);
        let mut terms: [[f64; N]; TERMS] = core::array::from_fn(|term| {
            core::array::from_fn(|i| (0..FINE).rev().map(|k| self.integrals[k][term] * modes[k][i]).sum())
        });
        terms[0] = *y0;
        terms
    }
}

/// x p, x = 2θ − 1.
fn times_x(p: &Powers) -> Powers {
    let two = DoubleDouble::ratio(2, 1);
    core::array::from_fn(|i| if i == 0 { -p[0] } else { two * p[i - 1] - p[i] })
}

/// ∫₀^θ p.
fn integral(p: &Powers) -> Powers {
    core::array::from_fn(|i| match i {
        0 => DoubleDouble::ZERO,
        _ => p[i - 1] / DoubleDouble::ratio(i as i64, 1),
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
