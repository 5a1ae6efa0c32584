//! Every turning point of a polynomial: sign changes of p′ isolated by Descartes' rule in the
//! Bernstein basis (Lane and Riesenfeld, *BIT* 21 (1981) 112; Farouki, *CAGD* 29 (2012) 379).
//! An interval without variation of sign holds no root, one with a single variation exactly one;
//! any other is halved by de Casteljau's algorithm.

use super::bernstein::Bernstein;
use super::bracket::{Point, root};
use crate::numerics::zero::roundoff;

/// Two turning points nearer than this differ in value by p‴/12 of its cube: nothing.
const NARROWEST: f64 = 1.0 / (1 << 20) as f64;

/// Visits the turning points within (0, 1) of a polynomial in ascending order, its derivative given
/// by coefficients and by values, both up to `rounding`. Where turning points cannot be told apart
/// it visits a point among them; the polynomial is monotone between neighbours, up to rounding.
pub(super) fn turning_points(
    slope: Bernstein,
    rounding: f64,
    at: &dyn Fn(f64) -> f64,
    visit: &mut dyn FnMut(f64),
) {
    let size = slope.terms().iter().fold(0.0, |m: f64, b| m.max(b.abs()));
    let negligible = rounding.max(roundoff(slope.degree as f64) * size);
    let isolation = Isolation { at, negligible };
    isolation.search(slope, [0.0, 1.0], visit);
}

struct Isolation<'a> {
    at: &'a dyn Fn(f64) -> f64,
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
        let signed = first.abs().min(last.abs()) > self.negligible;
        if variations == 1 && signed {
            let [a, b] = [(start, first), (end, last)].map(|(theta, value)| Point { theta, value });
            let [best, _] = root(&mut |x| (self.at)(x), a, b);
            return visit(best.theta);
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
        let mut signs = terms.iter().filter(|b| b.abs() > self.negligible).map(|b| b.is_sign_positive());
        let first = signs.next();
        let count =
            |(sign, n): (Option<bool>, usize), next| (Some(next), n + usize::from(sign != Some(next)));
        signs.fold((first, 0), count).1
    }
}
