//! Quotients as rational functions in sines, cosines, coordinates and parameters, in factors.

use liftoff_codegen::algebra::{Quotient, Symbol};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::{Ring, Variable};

/// number · Π above / Π below, reduced.
#[derive(Clone, Debug)]
pub(crate) struct Form {
    pub number: BigRational,
    /// Factors of the numerator with their exponents; one factor is 0 if the numerator is 0.
    pub above: Vec<(Polynomial, u32)>,
    /// Factors of the denominator with their exponents.
    pub below: Vec<(Polynomial, u32)>,
}

impl Form {
    pub fn from_quotient(ring: &Ring, quotient: &Quotient) -> Self {
        let [mut numerator, monomial] = ring.fraction(quotient.numerator());
        let mut below = vec![(monomial, 1)];
        for (factor, k) in quotient.factors() {
            let [own, monomial] = ring.fraction(factor);
            numerator = &numerator * &monomial.pow(*k);
            below.push((own, *k));
        }
        let below = reduce(&mut numerator, below);
        let mut form = Self { number: BigRational::one(), above: Vec::new(), below: Vec::new() };
        form.put(&numerator, 1, true);
        below.iter().for_each(|(factor, k)| form.put(factor, *k, false));
        form.signed(ring)
    }

    /// Moves a negative sign of the number into a factor that is a sum of odd power, if there is
    /// one: `3 (sin q₀ − sin q)`.
    fn signed(mut self, ring: &Ring) -> Self {
        let sums = self.above.iter_mut().filter(|(factor, k)| k % 2 == 1 && factor.len() > 1);
        let varying =
            sums.filter(|(factor, _)| !ring.is_constant(factor)).max_by_key(|(factor, _)| factor.len());
        if let Some((factor, _)) = varying.filter(|_| self.number.is_negative()) {
            *factor = -&*factor;
            self.number = -self.number;
        }
        self
    }

    /// Multiplies by the factors of a polynomial, or divides by them.
    fn put(&mut self, polynomial: &Polynomial, k: u32, above: bool) {
        let parts = polynomial.factors();
        let number = num_traits::pow(BigRational::from(parts.number), k as usize);
        if above {
            self.number *= number
        } else {
            self.number /= number
        }
        let side = if above { &mut self.above } else { &mut self.below };
        for (factor, exponent) in parts.factors {
            match side.iter_mut().find(|(known, _)| *known == factor) {
                Some((_, known)) => *known += exponent * k,
                None => side.push((factor, exponent * k)),
            }
        }
    }

    pub fn is_zero(&self) -> bool {
        self.number.is_zero()
    }

    /// The factors of the numerator that can vanish during the motion: they depend on the
    /// coordinate and are not of one sign for all positive parameters.
    pub fn vanishing(&self, ring: &Ring, coordinate: Symbol) -> Vec<(Polynomial, u32)> {
        let vanishing = self
            .above
            .iter()
            .filter(|(factor, _)| ring.depends_on(factor, coordinate) && !ring.is_definite(factor));
        vanishing.cloned().collect()
    }

    /// The product of the vanishing factors, each once.
    pub fn condition(&self, ring: &Ring, coordinate: Symbol) -> Polynomial {
        let vanishing = self.vanishing(ring, coordinate);
        vanishing.iter().fold(ring.one(), |product, (factor, _)| &product * factor)
    }

    /// Numerator and denominator multiplied out.
    pub fn expanded(&self, ring: &Ring) -> [Polynomial; 2] {
        let product = |number: &BigInt, factors: &[(Polynomial, u32)]| {
            let number = Polynomial::constant(ring.len(), number.clone());
            factors.iter().fold(number, |product, (factor, k)| &product * &factor.pow(*k))
        };
        [product(self.number.numer(), &self.above), product(self.number.denom(), &self.below)]
    }
}

/// Divides a numerator by the common factors with a denominator; returns the remaining factors of
/// the denominator.
fn reduce(numerator: &mut Polynomial, below: Vec<(Polynomial, u32)>) -> Vec<(Polynomial, u32)> {
    let mut kept = Vec::new();
    let mut waiting = below;
    while let Some((factor, k)) = waiting.pop() {
        let common = numerator.gcd(&factor);
        match numerator.divide_exact(&common).zip(factor.divide_exact(&common)) {
            Some((reduced, rest)) if !numerator.is_zero() && !common.is_one() && k > 0 => {
                *numerator = reduced;
                waiting.extend([(rest, 1), (factor, k - 1)].into_iter().filter(|(_, k)| *k > 0));
            }
            _ => kept.push((factor, k)),
        }
    }
    kept
}

impl Ring {
    pub fn depends_on(&self, polynomial: &Polynomial, symbol: Symbol) -> bool {
        let variables = self.variables.iter().enumerate();
        variables.filter(|(_, v)| v.symbol() == symbol).any(|(at, _)| polynomial.depends_on(at))
    }

    /// Whether a polynomial provably has one sign, and no zero, as long as the parameters are
    /// positive: for every monomial of parameters the constant exceeds the other terms, as sines
    /// and cosines lie in [−1, 1].
    pub fn is_definite(&self, polynomial: &Polynomial) -> bool {
        let classes = polynomial.collected(|x| self.variables[x].is_parameter());
        [1, -1].into_iter().any(|sign| {
            let least: Option<Vec<BigInt>> = classes.values().map(|class| self.least(class, sign)).collect();
            least.is_some_and(|all| {
                all.iter().all(|least| !least.is_negative()) && all.iter().any(BigInt::is_positive)
            })
        })
    }

    /// A lower bound of a polynomial without parameters, or of its opposite; `None` where there is
    /// none.
    fn least(&self, polynomial: &Polynomial, sign: i32) -> Option<BigInt> {
        polynomial.terms().try_fold(BigInt::zero(), |least, (exponents, c)| {
            let c = c * sign;
            let occurring = || exponents.iter().enumerate().filter(|(_, k)| **k > 0);
            if occurring().next().is_none() {
                return Some(least + c);
            }
            if occurring().all(|(_, k)| k % 2 == 0) && c.is_positive() {
                return Some(least);
            }
            let bounded = occurring().all(|(x, _)| !matches!(self.variables[x], Variable::Plain(_)));
            bounded.then(|| least - c.abs())
        })
    }

    /// Whether no sine, cosine or coordinate occurs.
    pub fn is_constant(&self, polynomial: &Polynomial) -> bool {
        let variables = self.variables.iter().enumerate();
        !variables.filter(|(_, v)| !v.is_parameter()).any(|(at, _)| polynomial.depends_on(at))
    }
}
