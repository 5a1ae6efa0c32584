//! What a condition is a polynomial in: sin q, cos q, `t = tan ½q` where it has both, with
//! `sin q = 2t/(1 + t²)`, `cos q = (1 − t²)/(1 + t²)`; or q itself where that is a length.

use liftoff_codegen::algebra::Symbol;

use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::{Ring, Variable};

/// Polynomials in one unknown, which stands at a place of its own.
pub(crate) struct Unknown {
    pub at: usize,
    /// Whether it is a sine or a cosine: its values 1 and −1 are each taken once, all others twice
    /// in a turn.
    pub folds: bool,
    pub polynomials: Vec<Polynomial>,
}

impl Ring {
    /// The same zeros as polynomials in one unknown; `None` where the coordinate stands in them
    /// beside its sine or cosine.
    pub fn in_one_unknown(&self, coordinate: Symbol, polynomials: &[Polynomial]) -> Option<Unknown> {
        let plain = self.position(Variable::Plain(coordinate));
        let has_plain = plain.filter(|&at| polynomials.iter().any(|p| p.depends_on(at)));
        let circle = self.circle(coordinate);
        let turns = circle.filter(|pair| pair.iter().any(|&at| polynomials.iter().any(|p| p.depends_on(at))));
        match (has_plain, turns) {
            (Some(at), None) => Some(Unknown { at, folds: false, polynomials: polynomials.to_vec() }),
            (None, Some([sine, cosine])) => {
                let by = |gone, kept| -> Option<Unknown> {
                    let written = polynomials.iter().map(|p| self.without_square(p, gone, kept));
                    let polynomials: Vec<Polynomial> = written.collect();
                    let free = polynomials.iter().all(|p| !p.depends_on(gone));
                    free.then_some(Unknown { at: kept, folds: true, polynomials })
                };
                by(cosine, sine).or_else(|| by(sine, cosine)).or_else(|| {
                    let polynomials = polynomials.iter().map(|p| self.by_tangent(p, sine, cosine)).collect();
                    Some(Unknown { at: sine, folds: false, polynomials })
                })
            }
            _ => None,
        }
    }

    /// (1 + t²)ᵈ times the polynomial, t at the place of the sine.
    fn by_tangent(&self, polynomial: &Polynomial, sine: usize, cosine: usize) -> Polynomial {
        let (one, t) = (self.one(), Polynomial::variable(self.len(), sine));
        let square = &t * &t;
        let (above, below) = (&one - &square, &one + &square);
        let degree = polynomial.terms().map(|(k, _)| k[sine] + k[cosine]).max().unwrap_or(0);
        let parts = polynomial.collected(|x| x == sine || x == cosine);
        parts.iter().fold(Polynomial::zero(self.len()), |sum, (k, coefficient)| {
            let [i, j] = [k[sine], k[cosine]];
            let wave = &(&t.scale(&2.into()).pow(i) * &above.pow(j)) * &below.pow(degree - i - j);
            &sum + &(coefficient * &wave)
        })
    }
}
