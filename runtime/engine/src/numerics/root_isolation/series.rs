//! A guard's own series g(θ) = Σ cₖ θᵏ. Of known order m at the start, θᵐ is divided out: the sign
//! of g is that of Σ cₘ₊ₖ θᵏ then. Values by compensated Horner (Graillat, Langlois, Louvet,
//! *Compensated Horner scheme*, 2005, alg. 8): as if in twice the precision, rounded.

use super::bernstein::Bernstein;
use super::bracket::Point;
use super::isolate::turning_points;
use super::partition::{Node, beyond};
use super::polynomial::FINE;
use super::{GuardError, RootStart};
use crate::numerics::zero::roundoff;

/// The most coefficients of a series that count; those after them belong to its error.
pub const TERMS: usize = FINE + 1;

/// Rounding of a sum of so many terms, relative to their sizes.
const SUMMED: f64 = roundoff(TERMS as f64);

/// Rounding of the coefficients themselves, as they come from some operations each.
const ROUNDED: f64 = roundoff(8.0);

/// θᵐ Σ aₖ θᵏ.
#[derive(Clone, Copy)]
pub(super) struct PowerSeries<'a> {
    order: usize,
    terms: &'a [f64],
}

impl<'a> PowerSeries<'a> {
    pub(super) fn new(c: &'a [f64], start: RootStart) -> Self {
        let c = &c[..c.len().min(TERMS)];
        let order = if let RootStart::Order(m) = start { m.min(c.len()) } else { 0 };
        let terms = &c[order..];
        let length = without_zeros(terms).len().max(1);
        Self { order, terms: &terms[..length.min(terms.len())] }
    }

    /// What the divided series must stay above: `delta`, or zero behind a known root.
    pub(super) fn level(&self, delta: f64) -> f64 {
        if self.order > 0 { 0.0 } else { delta }
    }

    /// Whether bounds of the divided series are as wanted, the cheap ones first; none are where its
    /// ends are not.
    pub(super) fn is_within(&self, wanted: impl Fn([f64; 2]) -> bool) -> bool {
        let is_possible = |value: f64| wanted([value; 2]);
        self.terms.first().is_none_or(|first| is_possible(*first))
            && (wanted(self.reach())
                || is_possible(self.terms.iter().sum())
                    && (wanted(self.partial_sums()) || wanted(self.range())))
    }

    /// Bounds of the divided series, the one farther from zero left out: for a₀ > 0, it is at least
    /// a₀ + Σ min(aₖ, 0).
    pub(super) fn reach(&self) -> [f64; 2] {
        let [first, rest @ ..] = self.terms else { return [0.0; 2] };
        let side = first.signum();
        let fall = 0.5 * summed(rest, |a| a.abs() - side * a);
        // Where the bound is of use the falls are less than a₀, and their rounding than SUMMED ·
        // a₀; an infinite a₀ has none.
        let least = first.abs() - (fall + SUMMED * first.abs());
        if side.is_sign_positive() { [least, f64::INFINITY] } else { [f64::NEG_INFINITY, -least] }
    }

    /// Bounds of the divided series by its partial sums, of which it is a mean: Σ aₖ θᵏ = Σ Sₖ (θᵏ
    /// − θᵏ⁺¹) + Sₙ θⁿ (Abel's summation).
    pub(super) fn partial_sums(&self) -> [f64; 2] {
        let (mut sum, mut size) = (0.0, 0.0);
        let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
        for a in self.terms {
            sum += a;
            size += a.abs();
            [low, high] = [low.min(sum), high.max(sum)];
        }
        [low - SUMMED * size, high + SUMMED * size]
    }

    /// Bounds of the divided series by its Bernstein coefficients.
    pub(super) fn range(&self) -> [f64; 2] {
        let rounding = SUMMED * self.size();
        let [low, high] = Bernstein::from_powers(without_zeros(self.terms)).range();
        [low - rounding, high + rounding]
    }

    fn size(&self) -> f64 {
        sizes(self.terms)
    }

    pub(super) fn evaluate(&self, theta: f64) -> f64 {
        let [rest @ .., last] = self.terms else { return 0.0 };
        let (mut sum, mut error) = (*last, 0.0);
        for a in rest.iter().rev() {
            let product = sum * theta;
            let rounded = sum.mul_add(theta, -product);
            sum = product + a;
            let taken = sum - product;
            error = f64::mul_add(error, theta, rounded + ((product - (sum - taken)) + (a - taken)));
        }
        (sum + error) * theta.powi(self.order as i32)
    }

    fn point(&self, theta: f64) -> Point {
        Point { theta, value: self.evaluate(theta) }
    }

    /// Visits both ends and the turning points between in ascending order.
    pub(super) fn visit(&self, visit: &mut dyn FnMut(Node)) -> Result<(), GuardError> {
        let slope = Slope::from_series(self);
        slope.check(self)?;
        let noise = ROUNDED * self.size();
        let mut node = |theta, beyond| visit(Node { point: self.point(theta), noise, beyond, smooth: true });
        node(0.0, f64::INFINITY);
        let bernstein = Bernstein::from_powers(slope.terms());
        turning_points(bernstein, slope.rounding(), &|x| slope.evaluate(x), &mut |x| node(x, f64::INFINITY));
        node(1.0, slope.beyond());
        Ok(())
    }
}

/// g′(θ) = θᵐ⁻¹ Σ (m + k) aₖ θᵏ without its power of θ.
struct Slope {
    /// Power of θ left in g′.
    order: usize,
    length: usize,
    coefficients: [f64; TERMS],
}

impl Slope {
    fn from_series(series: &PowerSeries) -> Self {
        let skip = usize::from(series.order == 0);
        let terms = without_zeros(&series.terms[skip.min(series.terms.len())..]);
        let mut coefficients = [0.0; TERMS];
        for (k, (slope, a)) in coefficients.iter_mut().zip(terms).enumerate() {
            *slope = (series.order + skip + k) as f64 * a;
        }
        Self { order: (series.order + skip).saturating_sub(1), length: terms.len(), coefficients }
    }

    fn terms(&self) -> &[f64] {
        &self.coefficients[..self.length]
    }

    fn evaluate(&self, theta: f64) -> f64 {
        self.terms().iter().rev().fold(0.0, |sum, c| sum * theta + c)
    }

    fn beyond(&self) -> f64 {
        let rate = self.terms().iter().sum();
        let bend = self.terms().iter().enumerate().map(|(k, c)| (self.order + k) as f64 * c).sum();
        beyond(rate, bend)
    }

    fn size(&self) -> f64 {
        sizes(self.terms())
    }

    fn rounding(&self) -> f64 {
        roundoff(self.length as f64) * self.size()
    }

    fn check(&self, series: &PowerSeries) -> Result<(), GuardError> {
        match series.terms.first() {
            Some(first) if !first.is_finite() => Err(GuardError::NotFinite { theta: 0.0 }),
            _ if !self.size().is_finite() => Err(GuardError::NotFinite { theta: 1.0 }),
            _ => Ok(()),
        }
    }
}

/// Whether Σ cₖ θᵏ stays above `delta` on 0 ≤ θ ≤ 1, and above its rounding, by the sum of what
/// lets it fall, Σ max(−cₖ, 0) = ½ Σ (|cₖ| − cₖ): the cheapest proof, which nearly all steps have.
pub fn stays_above(c: &[f64], delta: f64) -> bool {
    let [first, rest @ ..] = &c[..c.len().min(TERMS)] else { return false };
    let least = first - (0.5 * summed(rest, |c| c.abs() - c) + SUMMED * first);
    least > delta && least > SUMMED * (first + sizes(rest))
}

/// Whether it stays above `delta` by any bound of the series, the expensive ones only where the
/// cheap ones do not prove it.
pub fn is_above(c: &[f64], delta: f64) -> bool {
    PowerSeries::new(c, RootStart::Free).is_within(|[low, _]| low > delta)
}

/// Σ |cₖ|.
fn sizes(c: &[f64]) -> f64 {
    summed(c, f64::abs)
}

/// The sum of a function of each, four at once.
#[inline(always)]
fn summed(c: &[f64], of: impl Fn(f64) -> f64) -> f64 {
    let (fours, last) = c.as_chunks::<4>();
    let sums = fours.iter().fold([0.0; 4], |sums, four| core::array::from_fn(|k| sums[k] + of(four[k])));
    sums.iter().sum::<f64>() + last.iter().map(|c| of(*c)).sum::<f64>()
}

/// Up to the last coefficient that is not zero.
pub fn without_zeros(c: &[f64]) -> &[f64] {
    &c[..c.iter().rposition(|c| *c != 0.0).map_or(0, |last| last + 1)]
}

/// What the terms after the last of Σ cₖ θᵏ may sum to on 0 ≤ θ ≤ 1: a geometric series from the
/// last two, at the rate at which they are less than the two before (every other one vanishes where
/// g is even or odd). Infinite where they do not shrink: the step is too long for the series.
pub fn tail(c: &[f64]) -> f64 {
    let largest = |c: &[f64]| c.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
    let [rest @ .., a, b, y, z] = c else { return f64::INFINITY };
    let (before, last) = (a.abs().max(b.abs()), y.abs().max(z.abs()));
    if last == 0.0 {
        return 0.0;
    }
    let ratio = last / before;
    if ratio > 0.5 && last <= f64::EPSILON * largest(rest) {
        return 2.0 * last;
    }
    if ratio < 1.0 { 2.0 * last * ratio / (1.0 - ratio) } else { f64::INFINITY }
}

/// The coefficients of what is left of Σ cₖ θᵏ behind `from`, stretched to 0 ≤ s ≤ 1, θ = `from` +
/// (1 − `from`) s (Taylor shift by repeated synthetic division).
pub fn rest(c: &[f64], from: f64) -> [f64; TERMS] {
    let c = without_zeros(&c[..c.len().min(TERMS)]);
    let n = c.len();
    let mut shifted = [0.0; TERMS];
    shifted[..n].copy_from_slice(c);
    let (mut power, width) = (1.0, 1.0 - from);
    for k in 0..n {
        for j in (k..n - 1).rev() {
            shifted[j] += from * shifted[j + 1];
        }
        shifted[k] *= power;
        power *= width;
    }
    shifted
}
