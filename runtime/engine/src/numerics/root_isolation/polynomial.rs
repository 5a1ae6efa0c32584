//! Chebyshev interpolation at the nested points θⱼ = (1 − cos πj/n)/2, n = 8, 16, 32 (Trefethen,
//! *Approximation Theory and Approximation Practice*, ch. 3 and 8): the degree rises until the
//! coefficients end below the tolerance, or level off in the noise of g. What has been fitted is
//! compared with g between the nodes.

use super::GuardError;
use super::bracket::sample;
use crate::numerics::zero::roundoff;

/// The lowest degree tried.
pub(super) const COARSE: usize = 8;
pub(super) const FINE: usize = 32;

/// cos πm/32 for m = 0 … 16.
const QUARTER: [f64; FINE / 2 + 1] = [
    1.0,
    0.9951847266721969,
    0.9807852804032304,
    0.9569403357322088,
    0.9238795325112867,
    0.881921264348355,
    0.8314696123025452,
    0.773010453362737,
    core::f64::consts::FRAC_1_SQRT_2,
    0.6343932841636455,
    0.5555702330196022,
    0.47139673682599764,
    0.3826834323650898,
    0.2902846772544624,
    0.19509032201612828,
    0.0980171403295606,
    2.0670321098263988e-43,
];

/// Noise is told from slow convergence by its size: a plateau this far below the largest value, or
/// within the guard's own error.
const NOISE: f64 = 1e-9;

/// What the coefficients left out of an unfinished fit may sum to, in units of the last.
const UNRESOLVED: f64 = 10.0;

/// The largest part that the coefficients of a quarter may be of those before: 0.32 per degree in
/// the lowest fit, 0.75 in the highest, behind which the rest sums to 3 times the last.
const SHRINKS: f64 = 0.1;

/// Places between the nodes where a fit is compared with g; those of the lower degrees are nodes of
/// the next.
const CHECKS: [(usize, [f64; 2]); 3] = [
    (COARSE, [node(11, 2 * COARSE); 2]),
    (2 * COARSE, [node(5, FINE), node(21, FINE)]),
    (FINE, [0.202_1, 0.713_8]),
];
/// The first of them, which is [`COARSE`]'s.
pub(super) const CHECK: f64 = CHECKS[0].1[0];

/// A fit may differ from g there by so many times its error.
const CHECKED: f64 = 4.0;

/// Noise leaves coefficients of its own size behind: all of the last half of them are less than its
/// height by this factor with a probability of 1e-7 in the fit of degree 16, of 1e-11 in that of
/// degree 32.
const HIDDEN: f64 = 16.0;

/// Σ cₖ Tₖ(2x − 1) on 0 ≤ x ≤ 1.
pub(super) struct Polynomial {
    pub(super) degree: usize,
    pub(super) coefficients: [f64; FINE + 1],
    /// Estimate of the largest distance from g.
    pub(super) error: f64,
    /// Values of g at the start and the end.
    pub(super) ends: [f64; 2],
    /// Whether the error is down to what was asked or to the noise of g.
    pub(super) resolved: bool,
    /// What g may differ by from the polynomial where that is to prove that g has no root: infinite
    /// where the coefficients do not shrink.
    pub(super) margin: f64,
    /// The same if what does not shrink is the noise of g.
    pub(super) scatter: f64,
}

/// cos πm/32 for the full turn.
const COSINES: [f64; 2 * FINE] = {
    let mut cosines = [0.0; 2 * FINE];
    let mut m = 0;
    while m < 2 * FINE {
        let half = if m > FINE { 2 * FINE - m } else { m };
        cosines[m] = if half > FINE / 2 { -QUARTER[FINE - half] } else { QUARTER[half] };
        m += 1;
    }
    cosines
};

/// cos πm/32.
const fn cosine(m: usize) -> f64 {
    COSINES[m % (2 * FINE)]
}

/// θⱼ for the degree `n`.
pub(super) const fn node(j: usize, n: usize) -> f64 {
    0.5 * (1.0 - cosine(j * (FINE / n)))
}

impl Polynomial {
    /// Fits g, known to within `delta`, on `[start, end]` to a hundredth of that, or until it is
    /// good enough.
    pub(super) fn fit(
        g: &mut dyn FnMut(f64) -> f64,
        [start, end]: [f64; 2],
        delta: f64,
        enough: &dyn Fn(&Self) -> bool,
    ) -> Result<Self, GuardError> {
        let mut sample = |x: f64| sample(g, start + (end - start) * x).map(|point| point.value);
        let mut values = [0.0; FINE + 1];
        for j in 0..=COARSE {
            values[j * (FINE / COARSE)] = sample(node(j, COARSE))?;
        }
        for (degree, checks) in CHECKS {
            for j in (1..degree).step_by(2).filter(|_| degree > COARSE) {
                values[j * (FINE / degree)] = sample(node(j, degree))?;
            }
            let mut fit = Self::interpolate(&values, degree, delta);
            let passes = fit.resolved || enough(&fit);
            if passes || degree == FINE {
                fit.check(&mut sample, checks)?;
                if degree == FINE || fit.resolved || passes && enough(&fit) {
                    return Ok(fit);
                }
            }
        }
        unreachable!("the last degree returns")
    }

    /// The polynomial of at most this degree that g is, to within `error` beside rounding.
    pub(super) fn exact(
        g: &mut dyn FnMut(f64) -> f64,
        degree: usize,
        error: f64,
    ) -> Result<Self, GuardError> {
        let degree = [COARSE, 2 * COARSE].into_iter().find(|n| degree <= *n).unwrap_or(FINE);
        let mut values = [0.0; FINE + 1];
        for j in 0..=degree {
            values[j * (FINE / degree)] = sample(g, node(j, degree))?.value;
        }
        let coefficients = coefficients(&values, degree);
        let error = error + roundoff(8.0) * largest(&values);
        let ends = [values[0], values[FINE]];
        Ok(Self { degree, coefficients, error, ends, resolved: true, margin: error, scatter: error })
    }

    fn interpolate(values: &[f64; FINE + 1], degree: usize, delta: f64) -> Self {
        let coefficients = coefficients(values, degree);
        let known = &coefficients[..=degree];
        let largest = values.iter().step_by(FINE / degree).fold(0.0, |most: f64, g| most.max(g.abs()));
        let goal = (0.01 * delta).max(roundoff(8.0) * largest);
        let tail = tail(known);
        let limit = delta.max(NOISE * largest);
        let noise = noise(known, limit);
        let level = noise.unwrap_or(goal);
        let resolved = noise.is_some() || tail <= goal;
        let error = if resolved { level } else { UNRESOLVED * tail };
        let converges = resolved || tail <= limit || shrink(known);
        let [margin, scatter] = match converges {
            true => [2.0 * error; 2],
            false => [f64::INFINITY, HIDDEN * self::largest(&known[degree / 2 + 1..])],
        };
        let ends = [values[0], values[FINE]];
        let mut fit = Self { degree, coefficients, error, ends, resolved, margin, scatter };
        fit.chop(level);
        fit
    }

    /// Compares it with g between the nodes.
    fn check(
        &mut self,
        sample: &mut dyn FnMut(f64) -> Result<f64, GuardError>,
        [first, second]: [f64; 2],
    ) -> Result<(), GuardError> {
        let mut apart = |x: f64| sample(x).map(|value| (value - self.evaluate(x)).abs());
        let mut most = apart(first)?;
        if second != first {
            most = most.max(apart(second)?);
        }
        if most > CHECKED * self.error {
            (self.resolved, self.error) = (false, CHECKED * most);
            (self.margin, self.scatter) = (f64::INFINITY, self.scatter.max(HIDDEN * most));
        }
        Ok(())
    }

    /// Drops the last coefficients as long as they sum to `level` at most.
    fn chop(&mut self, level: f64) {
        let mut dropped = 0.0;
        while self.degree > 0 {
            dropped += self.coefficients[self.degree].abs();
            if dropped > level {
                return;
            }
            self.coefficients[self.degree] = 0.0;
            self.degree -= 1;
        }
    }

    /// Bounds of the polynomial, c₀ ± Σ |cₖ|.
    pub(super) fn range(&self) -> [f64; 2] {
        let [centre, rest @ ..] = &self.coefficients;
        let reach = rest[..self.degree].iter().map(|c| c.abs()).sum::<f64>();
        [centre - reach, centre + reach]
    }

    /// Coefficients of half the derivative with respect to x: c′ₖ₋₁ = c′ₖ₊₁ + 2k cₖ.
    pub(super) fn derivative(&self) -> Self {
        let mut slope = [0.0; FINE + 1];
        for k in (1..=self.degree).rev() {
            let above = slope.get(k + 1).copied().unwrap_or(0.0);
            slope[k - 1] = above + 2.0 * k as f64 * self.coefficients[k];
        }
        slope[0] *= 0.5;
        Self {
            degree: self.degree.saturating_sub(1),
            coefficients: slope,
            error: self.error,
            ends: self.ends,
            resolved: self.resolved,
            margin: self.margin,
            scatter: self.scatter,
        }
    }

    /// The value at x (Clenshaw).
    pub(super) fn evaluate(&self, x: f64) -> f64 {
        let y = 2.0 * x - 1.0;
        let (mut b, mut next) = (0.0, 0.0);
        for k in (1..=self.degree).rev() {
            (b, next) = (self.coefficients[k] + 2.0 * y * b - next, b);
        }
        self.coefficients[0] + y * b - next
    }
}

/// The matrix of cₖ = (2/n) Σ″ⱼ gⱼ Tₖ(−cos πj/n), the double prime and c₀, cₙ halving the ends: a
/// row for each j. `R` = n + 1 rows, rounded up in `C` so that they are whole vectors.
const fn matrix<const R: usize, const C: usize>() -> [[f64; C]; R] {
    let n = R - 1;
    let mut rows = [[0.0; C]; R];
    let mut j = 0;
    while j <= n {
        let mut k = 0;
        while k <= n {
            let ends =
                (if j == 0 || j == n { 0.5 } else { 1.0 }) * (if k == 0 || k == n { 1.0 } else { 2.0 });
            rows[j][k] = ends * cosine(k * (n - j) * (FINE / n)) / n as f64;
            k += 1;
        }
        j += 1;
    }
    rows
}

static LOW: [[f64; 12]; COARSE + 1] = matrix();
static MIDDLE: [[f64; 20]; 2 * COARSE + 1] = matrix();
static HIGH: [[f64; 36]; FINE + 1] = matrix();

fn coefficients(values: &[f64; FINE + 1], n: usize) -> [f64; FINE + 1] {
    match n {
        COARSE => product(&LOW, values),
        FINE => product(&HIGH, values),
        _ => product(&MIDDLE, values),
    }
}

/// The last four of Chebyshev's coefficients of a function with these values at
/// [`NODES`](super::NODES).
pub fn last_coefficients(values: &[f64]) -> [f64; 4] {
    core::array::from_fn(|k| values.iter().zip(&LOW).map(|(value, row)| value * row[COARSE - 3 + k]).sum())
}

fn product<const R: usize, const C: usize>(
    rows: &[[f64; C]; R],
    values: &[f64; FINE + 1],
) -> [f64; FINE + 1] {
    let mut sums = [0.0; C];
    for (row, value) in rows.iter().zip(values.iter().step_by(FINE / (R - 1))) {
        for (sum, entry) in sums.iter_mut().zip(row) {
            *sum += value * entry;
        }
    }
    let mut c = [0.0; FINE + 1];
    c[..R].copy_from_slice(&sums[..R]);
    c
}

fn largest(c: &[f64]) -> f64 {
    c.iter().fold(0.0, |m: f64, c| m.max(c.abs()))
}

/// What the coefficients left out may amount to: the last, or the one before shrunk at the rate of
/// the last four, as every other one vanishes where g is even or odd.
fn tail(c: &[f64]) -> f64 {
    let n = c.len() - 1;
    let (last, before) = (largest(&c[n - 1..]), largest(&c[n - 3..n - 1]));
    let rate = if last < before { last / before } else { 1.0 };
    c[n].abs().max(c[n - 1].abs() * rate)
}

/// Whether the coefficients shrink from quarter to quarter as those of a smooth function do, at a
/// rate at which the ones left out are less than [`UNRESOLVED`] times the last.
fn shrink(c: &[f64]) -> bool {
    let quarter = |k: usize| largest(&c[k * (c.len() - 1) / 4 + 1..=(k + 1) * (c.len() - 1) / 4]);
    let [first, second, third, fourth] = [0, 1, 2, 3].map(quarter);
    third <= SHRINKS * first.max(second) && fourth <= SHRINKS * third
}

/// The level at which the last half of the coefficients has stopped to shrink, if it is noise.
fn noise(c: &[f64], limit: f64) -> Option<f64> {
    let n = c.len() - 1;
    let (third, last) = (largest(&c[n / 2 + 1..=3 * n / 4]), largest(&c[3 * n / 4 + 1..]));
    let level = third.max(last);
    (n > COARSE && last > 0.1 * third && level < limit).then_some(2.0 * level)
}

#[cfg(test)]
mod tests;
