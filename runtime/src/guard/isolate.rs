//! Every turning point of a polynomial: sign changes of p′ isolated by Descartes' rule in the
//! Bernstein basis (Lane and Riesenfeld, *BIT* 21 (1981) 112; Farouki, *CAGD* 29 (2012) 379).
//! An interval without variation of sign holds no root, one with a single variation exactly one;
//! any other is halved by de Casteljau's algorithm.

use super::bracket::{Point, root};
use super::polynomial::{FINE, Polynomial};

/// Two turning points nearer than this differ in value by p‴/12 of its cube: nothing.
const NARROWEST: f64 = 1.0 / (1 << 20) as f64;

/// Bernstein coefficients on an interval, up to `degree`.
#[derive(Clone, Copy)]
struct Bernstein {
    degree: usize,
    coefficients: [f64; FINE + 1],
}

/// Visits the turning points within (0, 1) of p with the derivative `slope`, in ascending order. Where turning points cannot be
/// told apart it visits a point among them; p is monotone between neighbours, up to rounding.
pub(super) fn turning_points(slope: &Polynomial, visit: &mut dyn FnMut(f64)) {
    let [low, high] = slope.range();
    if low > 0.0 || high < 0.0 {
        return;
    }
    let bernstein = Bernstein::new(slope);
    let size = bernstein.terms().iter().fold(0.0, |m: f64, b| m.max(b.abs()));
    let isolation = Isolation { slope, negligible: f64::EPSILON * size * slope.degree as f64 };
    isolation.search(bernstein, [0.0, 1.0], visit);
}

struct Isolation<'a> {
    slope: &'a Polynomial,
    negligible: f64,
}

impl Isolation<'_> {
    fn search(&self, piece: Bernstein, [start, end]: [f64; 2], visit: &mut dyn FnMut(f64)) {
        let variations = self.variations(piece.terms());
        if variations == 0 {
            return;
        }
        let middle = 0.5 * (start + end);
        let (first, last) = (piece.terms()[0], piece.terms()[piece.degree]);
        if variations == 1 && first.min(last) < 0.0 && first.max(last) > 0.0 {
            let [a, b] = [(start, first), (end, last)].map(|(theta, value)| Point { theta, value });
            return visit(root(&mut |x| self.slope.at(x), a, b));
        }
        if end - start < NARROWEST {
            return visit(middle);
        }
        let [left, right] = piece.halves();
        let between = right.terms()[0];
        self.search(left, [start, middle], visit);
        if between.abs() <= self.negligible {
            visit(middle);
        }
        self.search(right, [middle, end], visit);
    }

    fn variations(&self, terms: &[f64]) -> usize {
        let mut signs = terms.iter().filter(|b| b.abs() > self.negligible).map(|b| *b > 0.0);
        let first = signs.next();
        let count =
            |(sign, n): (Option<bool>, usize), next| (Some(next), n + usize::from(sign != Some(next)));
        signs.fold((first, 0), count).1
    }
}

impl Bernstein {
    /// Clenshaw's recurrence bₖ = cₖ + 2y bₖ₊₁ − bₖ₊₂, y = 2x − 1, on Bernstein coefficients.
    fn new(p: &Polynomial) -> Self {
        let mut next = Self::constant(0.0);
        let mut b = Self::constant(p.coefficients[p.degree]);
        for k in (0..p.degree).rev() {
            let factor = if k == 0 { 1.0 } else { 2.0 };
            let mut sum = b.times_y();
            let raised = if b.degree == 0 { Self::zero(1) } else { next.raised().raised() };
            for (sum, below) in sum.coefficients.iter_mut().zip(raised.coefficients) {
                *sum = p.coefficients[k] + factor * *sum - below;
            }
            (b, next) = (sum, b);
        }
        b
    }

    fn zero(degree: usize) -> Self {
        Self { degree, coefficients: [0.0; FINE + 1] }
    }

    fn constant(value: f64) -> Self {
        let mut p = Self::zero(0);
        p.coefficients[0] = value;
        p
    }

    fn terms(&self) -> &[f64] {
        &self.coefficients[..=self.degree]
    }

    /// The product with αx̄ + βx, one degree up: α (n−j)/n bⱼ + β j/n bⱼ₋₁.
    fn times(&self, alpha: f64, beta: f64) -> Self {
        let mut product = Self::zero(self.degree + 1);
        let n = product.degree as f64;
        for (j, &b) in self.terms().iter().enumerate() {
            product.coefficients[j] += alpha * (n - j as f64) / n * b;
            product.coefficients[j + 1] += beta * (j as f64 + 1.0) / n * b;
        }
        product
    }

    fn times_y(&self) -> Self {
        self.times(-1.0, 1.0)
    }

    fn raised(&self) -> Self {
        self.times(1.0, 1.0)
    }

    /// The coefficients on either half (de Casteljau).
    fn halves(mut self) -> [Self; 2] {
        let n = self.degree;
        let mut left = self;
        for level in 1..=n {
            for i in 0..=n - level {
                self.coefficients[i] = 0.5 * (self.coefficients[i] + self.coefficients[i + 1]);
            }
            left.coefficients[level] = self.coefficients[0];
        }
        [left, self]
    }
}
