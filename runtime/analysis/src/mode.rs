//! Modes of vibration: ξ = v e^{λ t} of ξ̈ + C ξ̇ + K ξ = 0,
//!
//! ```text
//! (λ² + λ C + K) v = 0
//! ```
//!
//! Without C λ² are the eigenvalues of −K, which are real where K is symmetric. Away from an
//! equilibrium, and under forces that have no potential, it is not.

use nalgebra::{Complex, DMatrix, DVector};

/// Parts of K and C below this, in natural units, are rounding.
const ROUNDED: f64 = 1e-13;

/// A mode of vibration.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// λ, 1/s; of a pair of complex ones that with the positive imaginary part.
    pub rate: Complex<f64>,
    /// δq of each coordinate, relative to the largest in natural units.
    pub shape: Vec<Complex<f64>>,
}

impl Mode {
    pub(crate) fn new(
        rate: Complex<f64>,
        basis: &DMatrix<Complex<f64>>,
        shape: &DVector<Complex<f64>>,
        units: &[f64],
    ) -> Self {
        let moved = basis * shape;
        let natural = || moved.iter().zip(units).map(|(x, unit)| x / unit);
        let largest = natural().fold(Complex::new(0.0, 0.0), |most: Complex<f64>, x| {
            // Of equal ones the first.
            if x.norm() > (1.0 + 1e-9) * most.norm() { x } else { most }
        });
        let scale = if largest.norm() > 0.0 { largest } else { Complex::new(1.0, 0.0) };
        Self { rate, shape: moved.iter().map(|x| x / scale).collect() }
    }

    /// |λ|, the frequency that it had without damping, rad/s.
    pub fn frequency(&self) -> f64 {
        self.rate.norm()
    }

    /// −Re λ / |λ|; 1 or −1 where it does not vibrate.
    pub fn damping_ratio(&self) -> f64 {
        if self.rate.norm() > 0.0 { -self.rate.re / self.rate.norm() } else { 0.0 }
    }

    /// Re λ, 1/s, > 0 where it grows.
    pub fn growth(&self) -> f64 {
        self.rate.re
    }
}

pub(crate) fn real(x: f64) -> Complex<f64> {
    Complex::new(x, 0.0)
}

/// λ and v of all modes, one of each complex pair, and of a real pair ±λ without damping the
/// growing one.
pub(crate) fn compute_modes(
    [stiffness, damping]: [&DMatrix<f64>; 2],
    time: f64,
) -> Vec<(Complex<f64>, DVector<Complex<f64>>)> {
    if stiffness.is_empty() || !stiffness.iter().chain(damping.iter()).all(|x| x.is_finite()) {
        return Vec::new();
    }
    let size = stiffness.amax().max(1.0 / (time * time));
    let is_symmetric = (stiffness - stiffness.transpose()).amax() <= ROUNDED * size;
    let is_damped = damping.amax() > ROUNDED * size.sqrt();
    let mut found = match (is_symmetric, is_damped) {
        (true, false) => undamped(stiffness, ROUNDED * size),
        (false, false) => circulatory([stiffness, damping], ROUNDED * size),
        (_, true) => damped([stiffness, damping]),
    };
    let order = |rate: &Complex<f64>| (-rate.re.max(0.0), rate.norm());
    found.sort_by(|(a, _), (b, _)| {
        let (a, b) = (order(a), order(b));
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    found
}

fn undamped(stiffness: &DMatrix<f64>, rounding: f64) -> Vec<(Complex<f64>, DVector<Complex<f64>>)> {
    let symmetric = 0.5 * (stiffness + stiffness.transpose());
    let eigen = symmetric.symmetric_eigen();
    let pair = |(i, square): (usize, &f64)| {
        (rate_of_square(-square, rounding), eigen.eigenvectors.column(i).map(real))
    };
    eigen.eigenvalues.iter().enumerate().map(pair).collect()
}

/// λ of a real λ², that which grows or has the positive imaginary part.
fn rate_of_square(square: f64, rounding: f64) -> Complex<f64> {
    let root = if square.abs() > rounding { square.abs().sqrt() } else { 0.0 };
    if square > 0.0 { Complex::new(root, 0.0) } else { Complex::new(0.0, root) }
}

/// Without damping, of a K that is not symmetric: of a complex pair λ² both a vibration that grows
/// and one that decays.
fn circulatory(
    [stiffness, damping]: [&DMatrix<f64>; 2],
    rounding: f64,
) -> Vec<(Complex<f64>, DVector<Complex<f64>>)> {
    let squares = (-stiffness).complex_eigenvalues();
    let rates = squares.iter().flat_map(|square| match square.im {
        im if im.abs() <= rounding => vec![rate_of_square(square.re, rounding)],
        im if im > 0.0 => vec![square.sqrt(), -square.sqrt().conj()],
        _ => Vec::new(),
    });
    let mut found: Vec<(Complex<f64>, DVector<Complex<f64>>)> = Vec::new();
    for rate in rates {
        let before =
            found.iter().filter(|(other, _)| (other * other - rate * rate).norm() <= rounding).count();
        found.push((rate, shape([stiffness, damping], rate, before)));
    }
    found
}

fn damped([stiffness, damping]: [&DMatrix<f64>; 2]) -> Vec<(Complex<f64>, DVector<Complex<f64>>)> {
    let k = stiffness.nrows();
    let mut matrix = DMatrix::zeros(2 * k, 2 * k);
    matrix.view_mut((0, k), (k, k)).fill_with_identity();
    matrix.view_mut((k, 0), (k, k)).copy_from(&-stiffness);
    matrix.view_mut((k, k), (k, k)).copy_from(&-damping);
    let rates = matrix.complex_eigenvalues();
    let kept = rates.iter().filter(|rate| rate.im >= 0.0);
    kept.map(|&rate| (rate, shape([stiffness, damping], rate, 0))).collect()
}

/// v of (λ² + λ C + K) v = 0, the right singular vector of the least singular value; where so many
/// before have the same λ, of the next one that is as small, if there is one.
fn shape(
    [stiffness, damping]: [&DMatrix<f64>; 2],
    rate: Complex<f64>,
    before: usize,
) -> DVector<Complex<f64>> {
    let k = stiffness.nrows();
    let matrix = stiffness.map(real)
        + damping.map(|c| rate * c)
        + DMatrix::identity(k, k).map(|one: f64| rate * rate * one);
    let svd = matrix.svd(false, true);
    let values = &svd.singular_values;
    let next = k.saturating_sub(1 + before);
    let place = if values[next] <= ROUNDED.sqrt() * values.max() { next } else { k - 1 };
    svd.v_t.map_or_else(|| DVector::zeros(k), |right| right.row(place).adjoint())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// λ of all modes without damping, each with v that is independent of the others: (λ² + K) v = 0.
    fn rates(stiffness: &[f64]) -> Vec<Complex<f64>> {
        let k = stiffness.len().isqrt();
        let stiffness = DMatrix::from_row_slice(k, k, stiffness);
        let found = compute_modes([&stiffness, &DMatrix::zeros(k, k)], 1.0);
        let shapes: Vec<_> = found.iter().map(|(_, shape)| shape.clone()).collect();
        for (rate, shape) in &found {
            let rest = stiffness.map(real) * shape + shape * (rate * rate);
            assert!(rest.norm() < 1e-13 && (shape.norm() - 1.0).abs() < 1e-14, "{rate}: {shape} {rest}");
        }
        assert!(DMatrix::from_columns(&shapes).rank(1e-6) >= k.min(found.len()), "{shapes:?}");
        found.into_iter().map(|(rate, _)| rate).collect()
    }

    fn assert_near(found: &[Complex<f64>], expected: &[[f64; 2]]) {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (a, [re, im]) in found.iter().zip(expected) {
            assert!((a - Complex::new(*re, *im)).norm() < 1e-14, "{found:?}");
        }
    }

    /// Of ±λ the growing one, of ±iω one, and 0 once, whether K is symmetric or not.
    #[test]
    fn each_motion_without_damping_is_one_mode() {
        let expected = [[2.0, 0.0], [0.0, 0.0], [0.0, 3.0]];
        assert_near(&rates(&[9.0, 0.0, 0.0, 0.0, -4.0, 0.0, 0.0, 0.0, 0.0]), &expected);
        assert_near(&rates(&[9.0, 2.0, 1.0, 0.0, -4.0, 3.0, 0.0, 0.0, 0.0]), &expected);
        // Two shifts, each of its own.
        assert_near(
            &rates(&[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 4.0]),
            &[[0.0, 0.0], [0.0, 0.0], [0.0, 2.0]],
        );
    }

    /// Flutter: λ² = −1 ± i.
    #[test]
    fn of_a_complex_pair_one_grows_and_one_decays() {
        let (re, im) = ((0.5f64.sqrt() - 0.5).sqrt(), (0.5f64.sqrt() + 0.5).sqrt());
        assert_near(&rates(&[1.0, 1.0, -1.0, 1.0]), &[[re, im], [-re, im]]);
    }
}
