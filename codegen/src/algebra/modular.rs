//! Proofs that one series does not divide another, by their images in F_p[x].
//!
//! All variables but one get values in F_p, where p ≡ 1 (mod 4) so that i = √−1 exists. If d
//! divides n, then the image of d divides that of n up to a power of x; a remainder refutes it. The
//! converse fails with a probability of about 1/p, and then costs time only.

use super::{Rational, Series, Symbol, Term, work};
use std::collections::BTreeMap;

pub(super) const P: u64 = 998_244_353;
const I: u64 = 86_583_718;
const HALF: u64 = P.div_ceil(2);

/// A symbol, or the z = e^{i symbol} in which its sines and cosines are polynomials.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Variable {
    Symbol(Symbol),
    Z(Symbol),
}

/// Whether the divisor provably does not divide the numerator.
pub(super) fn refutes(numerator: &Series, divisor: &Series) -> bool {
    let Some(main) = widest(divisor) else {
        return false;
    };
    let mut image = Image::new(main);
    match (image.compute_coefficients(numerator), image.compute_coefficients(divisor)) {
        (Some(n), Some(d)) => !d.is_empty() && !divides(n, &d),
        _ => false,
    }
}

/// The variable of which the degrees differ most.
fn widest(series: &Series) -> Option<Variable> {
    let mut ranges = BTreeMap::<Variable, (i16, i16)>::new();
    for (term, _) in series.terms() {
        let symbols = term.monomial.factors().iter();
        let waves = term.wave.argument.iter();
        let symbols = symbols.map(|&(s, k)| (Variable::Symbol(s), k, k));
        for (variable, low, high) in symbols.chain(waves.map(|&(s, k)| (Variable::Z(s), -k.abs(), k.abs()))) {
            let (least, greatest) = ranges.entry(variable).or_insert((0, 0));
            *least = low.min(*least);
            *greatest = high.max(*greatest);
        }
    }
    let width = |(least, greatest): (i16, i16)| i32::from(greatest) - i32::from(least);
    let widest = ranges.into_iter().max_by_key(|(_, range)| width(*range));
    widest.map(|(variable, _)| variable)
}

/// The map to F_p[x], x the main variable.
struct Image {
    main: Variable,
    /// Values of the other variables, with their inverses.
    points: BTreeMap<Variable, (u64, u64)>,
}

impl Image {
    fn new(main: Variable) -> Self {
        let points = BTreeMap::new();
        Self { main, points }
    }

    /// Coefficients by falling powers, without zeros at either end; `None` where a denominator is
    /// 0 in F_p.
    fn compute_coefficients(&mut self, series: &Series) -> Option<Vec<u64>> {
        let mut coefficients = BTreeMap::new();
        if !work::spend(series.len()) {
            return None;
        }
        for (term, c) in series.terms() {
            let (value, degree) = self.monomial(term, residue(c)?);
            self.add_wave(&mut coefficients, term, value, degree);
        }
        coefficients.retain(|_, c| *c != 0);
        let (Some((&least, _)), Some((&greatest, _))) =
            (coefficients.first_key_value(), coefficients.last_key_value())
        else {
            return Some(Vec::new());
        };
        let falling = (least..=greatest).rev();
        Some(falling.map(|k| coefficients.get(&k).copied().unwrap_or(0)).collect())
    }

    fn monomial(&mut self, term: &Term, c: u64) -> (u64, i32) {
        let (mut value, mut degree) = (c, 0);
        for &(symbol, k) in term.monomial.factors() {
            let variable = Variable::Symbol(symbol);
            if variable == self.main {
                degree = i32::from(k);
            } else {
                value = value * self.power(variable, k) % P;
            }
        }
        (value, degree)
    }

    /// 2 cos = w + w⁻¹, 2 sin = −i (w − w⁻¹) with w = Π zᵏ.
    fn add_wave(&mut self, coefficients: &mut BTreeMap<i32, u64>, term: &Term, value: u64, degree: i32) {
        let mut add = |degree, value| {
            let sum = coefficients.entry(degree).or_insert(0);
            *sum = (*sum + value) % P;
        };
        if term.wave.is_one() {
            return add(degree, value);
        }
        let (mut up, mut down, mut shift) = (value * HALF % P, value * HALF % P, 0);
        for &(symbol, k) in &term.wave.argument {
            let variable = Variable::Z(symbol);
            if variable == self.main {
                shift = i32::from(k);
            } else {
                up = up * self.power(variable, k) % P;
                down = down * self.power(variable, -k) % P;
            }
        }
        if term.wave.sine {
            (up, down) = (up * (P - I) % P, down * I % P);
        }
        add(degree + shift, up);
        add(degree - shift, down);
    }

    fn power(&mut self, variable: Variable, k: i16) -> u64 {
        let (value, inverse) = *self.points.entry(variable).or_insert_with(|| {
            let value = point(variable);
            (value, inverse(value))
        });
        power(if k.is_negative() { inverse } else { value }, k.unsigned_abs().into())
    }
}

/// An arbitrary non-zero value, the same at every call.
fn point(variable: Variable) -> u64 {
    let seed = match variable {
        Variable::Symbol(s) => 2 * u64::from(s.code()),
        Variable::Z(s) => 2 * u64::from(s.code()) + 1,
    };
    power(seed + 1_000_003, 12_345)
}

fn residue(c: Rational) -> Option<u64> {
    let modulo = |n: i128| n.rem_euclid(i128::from(P)) as u64;
    match modulo(c.denominator()) {
        0 => None,
        1 => Some(modulo(c.numerator())),
        d => Some(modulo(c.numerator()) * inverse(d) % P),
    }
}

/// By Fermat's little theorem.
fn inverse(a: u64) -> u64 {
    power(a, P - 2)
}

/// baseᵏ of a base below p.
fn power(mut base: u64, mut k: u64) -> u64 {
    let mut product = 1;
    while k > 0 {
        if k & 1 == 1 {
            product = product * base % P;
        }
        base = base * base % P;
        k >>= 1;
    }
    product
}

/// Whether the remainder of a division in F_p[x] is zero.
fn divides(mut remainder: Vec<u64>, divisor: &[u64]) -> bool {
    let lead = inverse(divisor[0]);
    let steps = (remainder.len() + 1).saturating_sub(divisor.len());
    if !work::spend(steps * divisor.len() / 16) {
        return false;
    }
    for i in 0..steps {
        let factor = remainder[i] * lead % P;
        for (r, d) in remainder[i..].iter_mut().zip(divisor) {
            *r = (*r + (P - factor) * d) % P;
        }
    }
    remainder.iter().all(|&r| r == 0)
}
