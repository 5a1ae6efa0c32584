//! The linear systems of the simplified iteration: with J for every stage, T takes them apart into
//! one real and one complex system of size N (Hairer & Wanner II, IV.8, eqs. 8.13–8.15).

use num_complex::Complex;

use super::coefficients::{ALPHA, BACK, BETA, FORWARD, GAMMA, transform};
use super::lu::Lu;
use super::newton::Stages;

/// The factors of γ/h − J and (α + iβ)/h − J.
pub(super) struct NewtonFactors<const N: usize> {
    pub(super) h: f64,
    real: Lu<f64, N>,
    complex: Lu<Complex<f64>, N>,
}

impl<const N: usize> NewtonFactors<N> {
    /// `unit`: that of each entry of the state. None if one of the matrices is singular.
    pub(super) fn new(h: f64, jacobian: &[[f64; N]; N], unit: &[f64; N]) -> Option<Self> {
        let real = core::array::from_fn(|i| {
            core::array::from_fn(|j| if i == j { GAMMA / h } else { 0.0 } - jacobian[i][j])
        });
        let shift = Complex::new(ALPHA, BETA) / h;
        let complex = core::array::from_fn(|i| {
            core::array::from_fn(|j| if i == j { shift - jacobian[i][j] } else { (-jacobian[i][j]).into() })
        });
        Some(Self { h, real: Lu::new(real, unit)?, complex: Lu::new(complex, unit)? })
    }

    /// (γ/h − J)⁻¹ x.
    pub(super) fn filter(&self, x: &[f64; N]) -> [f64; N] {
        self.real.solve(x)
    }

    /// The change of the stages z with the slopes `f`.
    pub(super) fn change(&self, h: f64, f: &Stages<N>, z: &Stages<N>) -> Stages<N> {
        let (g, w) = (transform(&BACK, f), transform(&BACK, z));
        let real = self.real.solve(&core::array::from_fn(|i| g[0][i] - GAMMA / h * w[0][i]));
        let shift = Complex::new(ALPHA, BETA) / h;
        let residual = |i: usize| Complex::new(g[1][i], g[2][i]) - shift * Complex::new(w[1][i], w[2][i]);
        let complex = self.complex.solve(&core::array::from_fn(residual));
        transform(&FORWARD, &[real, complex.map(|x| x.re), complex.map(|x| x.im)])
    }

    /// How far roundings of `y` move the stages: (γ/h − J)⁻¹ J δ, δ = ε y with like and with
    /// alternating signs.
    pub(super) fn rounding(&self, y: &[f64; N]) -> [f64; N] {
        let of = |sign: f64| {
            let change = y.map(|y| f64::EPSILON * y);
            let change: [f64; N] =
                core::array::from_fn(|i| if i % 2 == 1 { sign * change[i] } else { change[i] });
            let filtered = self.filter(&change);
            core::array::from_fn::<f64, N, _>(|i| (GAMMA / self.h * filtered[i] - change[i]).abs())
        };
        let (like, alternating) = (of(1.0), of(-1.0));
        core::array::from_fn(|i| like[i].max(alternating[i]) + f64::EPSILON * y[i].abs())
    }
}
