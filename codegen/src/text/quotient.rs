//! Quotients over a power of one cosine, written as books do: `y = ½ l tan φ`,
//! `T = … (4 − 6/cos φ + 3/cos⁴ φ)`.

use super::TextWriter;
use crate::algebra::{Angle, Monomial, Quotient, Rational, Series, Symbol, Wave, lead};
use crate::math::Math;
use crate::program::Polynomial;

/// `coefficient · monomial · sin^{0|1} α · cos^power α`.
struct Piece {
    coefficient: Rational,
    monomial: Monomial,
    sine: bool,
    power: i32,
}

impl TextWriter<'_> {
    /// A quotient; term by term where its denominator is a power of one cosine.
    pub fn quotient(&self, quotient: &Quotient) -> Math {
        if let Some(series) = quotient.as_series() {
            return self.series(series);
        }
        let [(factor, exponent)] = quotient.factors() else { return quotient.math(self) };
        let angle = single_cosine(factor);
        match angle.and_then(|wave| Some((wave, pieces(quotient.numerator(), wave, *exponent)?))) {
            Some((wave, pieces)) => self.pieces(&pieces, wave),
            None => quotient.math(self),
        }
    }

    fn pieces(&self, pieces: &[Piece], wave: &Wave) -> Math {
        let (content, common) = content(pieces);
        let Some(angle) = self.argument(wave) else { return Math::ZERO };
        let terms = pieces.iter().map(|piece| {
            let rest =
                Series::monomial(piece.coefficient * content.recip(), quotient_of(&piece.monomial, &common));
            attach(rest.math(self), piece, &angle)
        });
        let sum = Math::sum(terms);
        let outside = Series::monomial(content, common);
        match (outside == Series::one(), pieces.len()) {
            (true, _) => sum,
            (false, 1) => attach(outside.math(self), &pieces[0], &angle),
            (false, _) => Math::product([outside.math(self), sum.group()]),
        }
    }

    fn argument(&self, wave: &Wave) -> Option<Math> {
        match Series::cos(&wave.angle()).math(self) {
            Math::Apply { argument, .. } => Some(*argument),
            _ => None,
        }
    }
}

fn single_cosine(factor: &Series) -> Option<&Wave> {
    let mut terms = factor.terms();
    let (term, coefficient) = terms.next()?;
    let plain = term.monomial.is_one() && coefficient == Rational::ONE && !term.wave.sine;
    (plain && terms.next().is_none()).then_some(&term.wave)
}

/// The numerator's terms over `cosᵏ α`, lowest powers last; `None` where another angle occurs.
fn pieces(numerator: &Series, wave: &Wave, exponent: u32) -> Option<Vec<Piece>> {
    let mut groups: Vec<(Monomial, Polynomial, Polynomial)> = Vec::new();
    for (term, coefficient) in numerator.terms() {
        let k = multiple(&term.wave, wave)?;
        let at = groups.iter().position(|(m, _, _)| *m == term.monomial).unwrap_or_else(|| {
            groups.push((term.monomial.clone(), Polynomial::default(), Polynomial::default()));
            groups.len() - 1
        });
        let coefficient = Series::constant(coefficient);
        match term.wave.sine {
            true => groups[at].2.add_second_kind(k - 1, &coefficient),
            false => groups[at].1.add_first_kind(k, &coefficient),
        }
    }
    let mut pieces = Vec::new();
    for (monomial, cosine, sine) in groups {
        for (sine, polynomial) in [(false, cosine), (true, sine)] {
            for (power, coefficient) in polynomial.coefficients().iter().enumerate().rev() {
                let coefficient = coefficient.as_constant()?;
                if !coefficient.is_zero() {
                    let power = power as i32 - exponent as i32;
                    pieces.push(Piece { coefficient, monomial: monomial.clone(), sine, power });
                }
            }
        }
    }
    lead(&mut pieces, |piece| piece.coefficient.signum() > 0);
    Some(pieces)
}

fn multiple(wave: &Wave, base: &Wave) -> Option<usize> {
    if wave.is_one() {
        return Some(0);
    }
    let k = wave.argument.first()?.1 / base.argument.first()?.1;
    let scaled = base.angle().scale(k.into());
    (k > 0 && scaled.terms() == &wave.argument[..]).then_some(k.unsigned_abs().into())
}

/// The common factor of all pieces, by way of waves that keep them apart.
fn content(pieces: &[Piece]) -> (Rational, Monomial) {
    let apart = pieces.iter().enumerate().map(|(i, piece)| {
        let wave = Series::cos(&Angle::from_symbol(Symbol::Reaction(0)).scale(i as i32 + 1));
        &Series::monomial(piece.coefficient, piece.monomial.clone()) * &wave
    });
    let (content, monomial) = apart.sum::<Series>().content();
    let negative = pieces.iter().all(|piece| piece.coefficient.signum() < 0);
    (if negative { -content } else { content }, monomial)
}

fn quotient_of(monomial: &Monomial, by: &Monomial) -> Monomial {
    let series =
        by.factors().iter().fold(Series::monomial(Rational::ONE, monomial.clone()), |rest, &(symbol, k)| {
            rest.coefficient(symbol, rest.degree(symbol))
                * Series::symbol(symbol).pow((rest.degree(symbol) - k).max(0) as u32)
        });
    series.as_monomial().map_or_else(|| monomial.clone(), |(_, m)| m.clone())
}

/// `factor tan φ`, `factor cos² φ`, `factor tan φ/cos⁴ φ`.
fn attach(factor: Math, piece: &Piece, angle: &Math) -> Math {
    let apply = |function, power: i32| Math::Apply {
        function,
        power: power.unsigned_abs(),
        argument: Box::new(angle.clone()),
    };
    let (head, power) = match (piece.sine, piece.power) {
        (true, p) if p < 0 => (Some(apply("tan", 1)), p + 1),
        (true, p) => (Some(apply("sin", 1)), p),
        (false, p) => (None, p),
    };
    let above =
        Math::product([factor].into_iter().chain(head).chain((power > 0).then(|| apply("cos", power))));
    if power < 0 { above.over(apply("cos", power)) } else { above }
}
