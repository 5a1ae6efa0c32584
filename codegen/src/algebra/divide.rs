//! Exact division of Laurent–trigonometric polynomials by their lexicographic leading terms.
//!
//! Degrees add under multiplication, the greatest and the least in every variable. So the degrees
//! of a quotient lie in a box known beforehand; a leading term outside it proves that there is
//! none, and since leading terms decrease, the division ends. Nearly every failure is found
//! beforehand, and cheaply, by an image modulo a prime.

use super::exponential::{Exponential, Exponents, subtract};
use super::{Monomial, Powers, Series, Symbol, modular, work};
use std::collections::BTreeMap;

impl Series {
    /// self / divisor if that is a series, else `None`; `None` too for a zero divisor and where
    /// intermediate numbers overflow. An overflow divided by anything is overflow.
    pub fn divide_exact(&self, divisor: &Self) -> Option<Self> {
        if self.is_overflow() || divisor.is_overflow() {
            return Some(Self::overflow());
        }
        if divisor.is_zero() || self.is_zero() {
            return (!divisor.is_zero()).then(Self::zero);
        }
        let (number, monomial, primitive) = divisor.primitive();
        let numerator = self.divide_monomial(&monomial)?.scale(number.recip());
        if primitive.as_constant().is_some() {
            return Some(numerator);
        }
        if modular::refutes(&numerator, &primitive) {
            return None;
        }
        let quotient = divide(numerator.to_exponential()?, &primitive.to_exponential()?)?;
        Some(Self::from_exponential(&quotient))
    }

    /// `None` if a symbol other than a parameter would get a negative exponent.
    fn divide_monomial(&self, monomial: &Monomial) -> Option<Self> {
        let (_, common) = self.content();
        let (_, rest) = Monomial(common.0.minus(&monomial.0)?).split_units();
        let allowed = rest.factors().iter().all(|(_, k)| k.is_positive());
        let inverse = monomial.0.times(-1).filter(|_| allowed)?;
        Some(self.times_monomial(super::Rational::ONE, &Monomial(inverse)))
    }
}

/// Leading terms only, without the refutation beforehand.
pub(super) fn divide(mut remainder: Exponential, divisor: &Exponential) -> Option<Exponential> {
    let bounds = Bounds::compute(&remainder, divisor)?;
    let ((monomial, z), leading) = divisor.last_key_value()?;
    let inverse = leading.recip();
    let mut quotient = Exponential::new();
    while let Some(((m, k), c)) = remainder.last_key_value() {
        let term = (Monomial(m.0.minus(&monomial.0)?), k.minus(z)?);
        let c = *c * inverse;
        if c.is_overflow() || !bounds.contain(&term) || !work::spend(4 * divisor.len()) {
            return None;
        }
        for ((m, k), d) in divisor {
            let exponents = (Monomial(m.0.plus(&term.0.0)?), k.plus(&term.1)?);
            subtract(&mut remainder, exponents, *d * c);
        }
        quotient.insert(term, c);
    }
    Some(quotient)
}

/// Least and greatest degree of a quotient in every symbol and every z.
struct Bounds {
    monomial: BTreeMap<Symbol, (i16, i16)>,
    z: BTreeMap<Symbol, (i16, i16)>,
}

impl Bounds {
    /// `None` where a greatest degree would be below the least, or a least one not allowed.
    fn compute(numerator: &Exponential, divisor: &Exponential) -> Option<Self> {
        let monomial = quotient_ranges(
            &ranges(numerator.keys().map(|(m, _)| &m.0)),
            &ranges(divisor.keys().map(|(m, _)| &m.0)),
        )?;
        let z = quotient_ranges(
            &ranges(numerator.keys().map(|(_, k)| k)),
            &ranges(divisor.keys().map(|(_, k)| k)),
        )?;
        let integral = monomial.iter().all(|(s, (least, _))| s.is_parameter() || *least >= 0);
        integral.then_some(Self { monomial, z })
    }

    fn contain(&self, (monomial, z): &Exponents) -> bool {
        within(&self.monomial, &monomial.0) && within(&self.z, z)
    }
}

type Ranges = BTreeMap<Symbol, (i16, i16)>;

/// Least and greatest entry at every symbol that occurs, zeros counted.
fn ranges<'a>(vectors: impl Iterator<Item = &'a Powers> + Clone) -> Ranges {
    let mut ranges = Ranges::new();
    for powers in vectors.clone() {
        for &(symbol, k) in powers {
            ranges.entry(symbol).or_insert((k, k));
        }
    }
    for powers in vectors {
        for (symbol, (least, greatest)) in &mut ranges {
            let k = powers.get(*symbol);
            *least = k.min(*least);
            *greatest = k.max(*greatest);
        }
    }
    ranges
}

fn quotient_ranges(numerator: &Ranges, divisor: &Ranges) -> Option<Ranges> {
    let mut ranges = numerator.clone();
    for (symbol, (least, greatest)) in divisor {
        let range = ranges.entry(*symbol).or_insert((0, 0));
        *range = (range.0.checked_sub(*least)?, range.1.checked_sub(*greatest)?);
    }
    let proper = ranges.values().all(|(least, greatest)| least <= greatest);
    proper.then_some(ranges)
}

/// Whether every entry lies in its range; remainders have no symbols but those of numerator and
/// divisor, which all have one.
fn within(ranges: &Ranges, powers: &Powers) -> bool {
    ranges.iter().all(|(symbol, (least, greatest))| (*least..=*greatest).contains(&powers.get(*symbol)))
}
