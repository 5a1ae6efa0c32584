//! [`Dense`] with its dimension forgotten.

use crate::integrate::Dense;
use crate::scalar::Real;

/// Rounding of the sum of a step's terms.
const ROUNDED: f64 = 4.0 * f64::EPSILON;

/// y(t) over one step as a polynomial in θ = (t − t₀)/h, see [`Dense`]; exactly the step's own
/// states at both ends.
#[derive(Clone, Debug, Default)]
pub struct DenseOutput {
    /// Time at the start.
    pub t0: f64,
    /// Length of the step.
    pub h: f64,
    /// Time at the end.
    pub t1: f64,
    entries: usize,
    alternating: bool,
    /// y₁, then the coefficients, `entries` numbers each.
    values: Vec<f64>,
}

impl DenseOutput {
    /// The state y₀ at time t₀.
    pub fn still(t0: f64, y0: &[f64]) -> Self {
        let values = [y0, y0].concat();
        Self { t0, h: 0.0, t1: t0, entries: y0.len(), alternating: false, values }
    }

    /// y(t₀ + θh) = Σ cₖ θᵏ between two times: its end, and c₀, c₁, … one behind the other.
    pub fn series([t0, t1]: [f64; 2], y1: &[f64], coefficients: impl Iterator<Item = f64>) -> Self {
        let values = y1.iter().copied().chain(coefficients).collect();
        Self { t0, h: t1 - t0, t1, entries: y1.len(), alternating: false, values }
    }

    /// Takes the first entries of a step, within the room there is.
    pub(super) fn set<const N: usize>(&mut self, dense: &Dense<f64, N>, entries: usize) {
        (self.t0, self.h, self.t1, self.entries) = (dense.t0, dense.h, dense.t1, entries);
        self.alternating = dense.powers().is_none();
        self.values.clear();
        self.values.reserve(entries * (1 + dense.coefficients().len()));
        self.values.extend_from_slice(&dense.end()[..entries]);
        if entries == N {
            return self.values.extend_from_slice(dense.coefficients().as_flattened());
        }
        for c in dense.coefficients() {
            self.values.extend_from_slice(&c[..entries]);
        }
    }

    /// The memory that it takes, bytes.
    pub fn memory(&self) -> usize {
        size_of::<Self>() + size_of::<f64>() * self.values.capacity()
    }

    /// The number of entries of a state.
    pub fn entries(&self) -> usize {
        self.entries
    }

    /// The state at t₀ + θh, 0 ≤ θ ≤ 1.
    pub fn interpolate(&self, theta: f64, y: &mut [f64]) {
        let (end, coefficients) = self.values.split_at(self.entries);
        if theta == 1.0 || coefficients.is_empty() {
            return y.copy_from_slice(end);
        }
        if theta == 0.0 {
            return y.copy_from_slice(&coefficients[..self.entries]);
        }
        let weights = [theta, if self.alternating { 1.0 - theta } else { theta }];
        match self.entries {
            2 => horner::<2>(weights, coefficients, y),
            3 => horner::<3>(weights, coefficients, y),
            4 => horner::<4>(weights, coefficients, y),
            5 => horner::<5>(weights, coefficients, y),
            6 => horner::<6>(weights, coefficients, y),
            8 => horner::<8>(weights, coefficients, y),
            entries => {
                let (rest, last) = coefficients.split_at(coefficients.len() - entries);
                y.copy_from_slice(last);
                for (k, c) in rest.chunks_exact(entries).enumerate().rev() {
                    y.iter_mut().zip(c).for_each(|(y, c)| *y = Real::mul_add(weights[k % 2], *y, *c));
                }
            }
        }
    }

    /// The polynomial and its rate dy/dθ at t₀ + θh: at its end too, where [`Self::interpolate`] is
    /// the step's own state.
    pub fn with_slope(&self, theta: f64, y: &mut [f64], slope: &mut [f64]) {
        let weights = [(theta, 1.0), if self.alternating { (1.0 - theta, -1.0) } else { (theta, 1.0) }];
        let coefficients = self.values[self.entries..].chunks_exact(self.entries.max(1));
        y.fill(0.0);
        slope.fill(0.0);
        // (p, p′) of p ← cₖ + w p.
        for (k, c) in coefficients.enumerate().rev() {
            let (weight, of_weight) = weights[k % 2];
            for ((y, slope), c) in y.iter_mut().zip(slope.iter_mut()).zip(c) {
                *slope = Real::mul_add(weight, *slope, of_weight * *y);
                *y = Real::mul_add(weight, *y, *c);
            }
        }
    }

    /// The state at the start.
    pub fn start(&self) -> Vec<f64> {
        let mut y = vec![0.0; self.entries];
        self.interpolate(0.0, &mut y);
        y
    }

    /// The state at the end.
    pub fn end(&self) -> &[f64] {
        &self.values[..self.entries]
    }

    /// The degree of the polynomial.
    pub fn degree(&self) -> usize {
        (self.values.len() / self.entries.max(1)).saturating_sub(2)
    }

    /// Writes the coefficients of one entry as a polynomial Σ cₖ θᵏ that ends in that of y₁; none
    /// where there is no room for all.
    pub fn polynomial(&self, entry: usize, terms: &mut [f64]) -> Option<()> {
        if entry < self.entries { self.powers(|y| y[entry], terms) } else { None }
    }

    /// The same of Σ wᵢ yᵢ.
    pub fn combination(&self, weights: &[f64], terms: &mut [f64]) -> Option<()> {
        self.powers(|y| y.iter().zip(weights).map(|(y, weight)| weight * y).sum(), terms)
    }

    /// The same of a linear function of the state.
    fn powers(&self, of: impl Fn(&[f64]) -> f64, terms: &mut [f64]) -> Option<()> {
        let (end, coefficients) = self.values.split_at_checked(self.entries)?;
        let degree = self.degree();
        terms.get_mut(degree + 1..)?.fill(0.0);
        let terms = &mut terms[..=degree];
        let nested = coefficients.chunks_exact(self.entries.max(1)).map(&of);
        if self.alternating {
            from_pairs(nested, terms);
        } else {
            terms.iter_mut().zip(nested).for_each(|(term, c)| *term = c);
        }
        let (sum, size) = terms.iter().fold((0.0, 0.0), |(sum, size), c| (sum + c, size + c.abs()));
        let missing = of(end) - sum;
        if missing.abs() > ROUNDED * size {
            terms[degree] += missing;
        }
        Some(())
    }
}

/// The powers of c₀ + θ(c₁ + θ̄(c₂ + θ(c₃ + …))), θ̄ = 1 − θ, pair by pair: p ← c₂ₖ + c₂ₖ₊₁ θ + θθ̄
/// p.
fn from_pairs(nested: impl DoubleEndedIterator<Item = f64> + ExactSizeIterator, terms: &mut [f64]) {
    terms.fill(0.0);
    let (mut length, mut linear) = (0, 0.0);
    for (k, c) in nested.enumerate().rev() {
        if k % 2 == 1 {
            linear = c;
            continue;
        }
        length = (length + 2).min(terms.len());
        for i in (2..length).rev() {
            terms[i] = terms[i - 1] - terms[i - 2];
        }
        if let [constant, first, ..] = terms {
            *first = *constant + linear;
        }
        terms[0] = c;
    }
}

/// c₀ + w₀(c₁ + w₁(c₂ + w₀(c₃ + …))) of `N` entries each, kept out of memory on the way.
fn horner<const N: usize>(weights: [f64; 2], coefficients: &[f64], y: &mut [f64]) {
    let Some((last, rest)) = coefficients.as_chunks::<N>().0.split_last() else { return };
    let mut sum = *last;
    for (k, c) in rest.iter().enumerate().rev() {
        sum = core::array::from_fn(|i| Real::mul_add(weights[k % 2], sum[i], c[i]));
    }
    y.copy_from_slice(&sum);
}

#[cfg(test)]
mod tests {
    use super::DenseOutput;
    use crate::integrate::Dense;

    /// Both nested forms as powers, and the end that the step has.
    #[test]
    fn powers_of_either_form() {
        let nested = [[0.7, -2.0], [1.5, 0.25], [-0.3, 1.0], [2.0, -0.5], [0.1, 0.6]];
        let at = |theta: f64, weights: [f64; 2]| {
            let [a, b, c, d, e] = nested.map(|c| c[1]);
            let [w, v] = weights;
            a + theta * (b + v * (c + w * (d + v * e)))
        };
        for alternating in [false, true] {
            let weights = |theta: f64| [theta, if alternating { 1.0 - theta } else { theta }];
            let end = [9.0, at(1.0, weights(1.0)) + 1e-3];
            let mut dense = Dense::<f64, 2>::with_room(5);
            if alternating {
                dense.set_alternating([0.0, 2.0], end, nested);
            } else {
                dense.set_powers([0.0, 2.0], end, nested);
            }
            let mut output = DenseOutput::default();
            output.set(&dense, 2);
            let mut terms = [f64::NAN; 8];
            output.polynomial(1, &mut terms).expect("room for five");
            assert_eq!((output.degree(), &terms[5..]), (4, &[0.0; 3][..]));
            for theta in [0.0, 0.3, 0.5, 0.9, 1.0] {
                let slope: f64 = (1..5).map(|k| k as f64 * terms[k] * f64::powi(theta, k as i32 - 1)).sum();
                let (mut values, mut slopes) = ([0.0; 2], [0.0; 2]);
                output.with_slope(theta, &mut values, &mut slopes);
                assert!(
                    (values[1] - at(theta, weights(theta))).abs() < 1e-14,
                    "{alternating} {theta}: {values:?}"
                );
                let expected = slope - 4e-3 * theta.powi(3);
                assert!(
                    (slopes[1] - expected).abs() < 1e-13,
                    "{alternating} {theta}: {slopes:?} for {expected}"
                );
                let sum: f64 = (0..5).map(|k| terms[k] * f64::powi(theta, k as i32)).sum();
                // The end is met by the last power.
                let expected = at(theta, weights(theta)) + 1e-3 * theta.powi(4);
                assert!((sum - expected).abs() < 1e-14, "{alternating} {theta}: {sum} for {expected}");
            }
            assert_eq!(output.polynomial(1, &mut [0.0; 4]), None);
            let (mut first, mut both) = ([0.0; 5], [0.0; 5]);
            output.polynomial(0, &mut first).expect("room for five");
            output.combination(&[-0.5, 3.0], &mut both).expect("room for five");
            for k in 0..5 {
                assert!((both[k] - (3.0 * terms[k] - 0.5 * first[k])).abs() < 1e-14, "{alternating} {k}");
            }
        }
    }
}
