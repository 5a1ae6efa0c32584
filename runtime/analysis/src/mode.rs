//! Modes of vibration: ξ = v e^{λ t} of ξ̈ + C ξ̇ + K ξ = 0,
//!
//! ```text
//! (λ² + λ C + K) v = 0
//! ```
//!
//! Without C, and with a symmetric K, λ² are the eigenvalues of −K.

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

/// λ and v of all modes, one of each complex pair, and of a real pair ±λ without damping the growing one.
pub(crate) fn of(
    [stiffness, damping]: [&DMatrix<f64>; 2],
    time: f64,
) -> Vec<(Complex<f64>, DVector<Complex<f64>>)> {
    if stiffness.is_empty() || !stiffness.iter().chain(damping.iter()).all(|x| x.is_finite()) {
        return Vec::new();
    }
    let size = stiffness.amax().max(1.0 / (time * time));
    let is_symmetric = (stiffness - stiffness.transpose()).amax() <= ROUNDED * size;
    let is_damped = damping.amax() > ROUNDED * size.sqrt();
    let mut found = match is_symmetric && !is_damped {
        true => undamped(stiffness, ROUNDED * size),
        false => damped([stiffness, damping]),
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
        let root = if square.abs() > rounding { square.abs().sqrt() } else { 0.0 };
        let rate = if *square < 0.0 { Complex::new(root, 0.0) } else { Complex::new(0.0, root) };
        (rate, eigen.eigenvectors.column(i).map(real))
    };
    eigen.eigenvalues.iter().enumerate().map(pair).collect()
}

fn damped([stiffness, damping]: [&DMatrix<f64>; 2]) -> Vec<(Complex<f64>, DVector<Complex<f64>>)> {
    let k = stiffness.nrows();
    let mut matrix = DMatrix::zeros(2 * k, 2 * k);
    matrix.view_mut((0, k), (k, k)).fill_with_identity();
    matrix.view_mut((k, 0), (k, k)).copy_from(&-stiffness);
    matrix.view_mut((k, k), (k, k)).copy_from(&-damping);
    let rates = matrix.complex_eigenvalues();
    let kept = rates.iter().filter(|rate| rate.im >= 0.0);
    kept.map(|&rate| (rate, shape([stiffness, damping], rate))).collect()
}

/// v of (λ² + λ C + K) v = 0, the right singular vector of the least singular value.
fn shape([stiffness, damping]: [&DMatrix<f64>; 2], rate: Complex<f64>) -> DVector<Complex<f64>> {
    let k = stiffness.nrows();
    let matrix = stiffness.map(real)
        + damping.map(|c| rate * c)
        + DMatrix::identity(k, k).map(|one: f64| rate * rate * one);
    let svd = matrix.svd(false, true);
    let least = svd.singular_values.argmin().0;
    svd.v_t.map_or_else(|| DVector::zeros(k), |right| right.row(least).adjoint())
}
