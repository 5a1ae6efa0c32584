//! Products of terms; two waves become a sum of two by the addition theorems
//!
//! 2 cos a cos b = cos(a−b) + cos(a+b),  2 sin a sin b = cos(a−b) − cos(a+b),
//! 2 sin a cos b = sin(a+b) + sin(a−b),  2 cos a sin b = sin(a+b) − sin(a−b).

use super::collect::Collector;
use super::{Monomial, Powers, Rational, Series, Term, Wave, work};

/// Adds a·b·(c = product of their coefficients) to a sum.
fn push_product(sum: &mut Collector, a: &Term, b: &Term, c: Rational) {
    let Some(powers) = a.monomial.0.plus(&b.monomial.0) else {
        return sum.poison();
    };
    let monomial = Monomial(powers);
    if a.wave.is_one() || b.wave.is_one() {
        let wave = if a.wave.is_one() { &b.wave } else { &a.wave };
        let wave = wave.clone();
        return sum.push(Term { monomial, wave }, c);
    }
    let sine = a.wave.sine != b.wave.sine;
    let half = c * Rational::HALF;
    let on_sum = if a.wave.sine && b.wave.sine { -half } else { half };
    let on_difference = if !a.wave.sine && b.wave.sine { -half } else { half };
    let (argument, other) = (&a.wave.argument, &b.wave.argument);
    push_wave(sum, &monomial, sine, argument.plus(other), on_sum);
    push_wave(sum, &monomial, sine, argument.minus(other), on_difference);
}

/// Adds c · monomial · sin|cos(argument), whatever the sign of the argument.
pub(super) fn push_wave(
    sum: &mut Collector,
    monomial: &Monomial,
    sine: bool,
    argument: Option<Powers>,
    c: Rational,
) {
    let Some(argument) = argument else {
        return sum.poison();
    };
    if let Some((negative, wave)) = Wave::canonical(sine, argument) {
        let monomial = monomial.clone();
        sum.push(Term { monomial, wave }, if negative { -c } else { c });
    }
}

impl Series {
    pub(super) fn product(&self, other: &Self) -> Self {
        if self.is_overflow() || other.is_overflow() {
            return Self::overflow();
        }
        if let Some((c, monomial)) = other.as_monomial() {
            return self.times_monomial(c, monomial);
        }
        if let Some((c, monomial)) = self.as_monomial() {
            return other.times_monomial(c, monomial);
        }
        let mut sum = Collector::with_capacity(self.len().saturating_mul(other.len()));
        for (a, c) in self.entries() {
            if work::is_spent() {
                return Self::overflow();
            }
            for (b, d) in other.entries() {
                push_product(&mut sum, a, b, *c * *d);
            }
        }
        sum.finish()
    }

    /// Multiplication by a monomial keeps the order of terms (see `powers`).
    pub(super) fn times_monomial(&self, c: Rational, monomial: &Monomial) -> Self {
        if !work::spend(self.len()) {
            return Self::overflow();
        }
        if c.is_zero() && !self.is_overflow() {
            return Self::zero();
        }
        let scaled = self.clone().map_coefficients(|d| d * c);
        if monomial.is_one() || scaled.is_overflow() {
            return scaled;
        }
        let mut terms = scaled.into_entries();
        for (term, _) in &mut terms {
            match term.monomial.0.plus(&monomial.0) {
                Some(powers) => term.monomial = Monomial(powers),
                None => return Self::overflow(),
            }
        }
        Self::from_sorted(terms)
    }

    /// c · self.
    pub fn scale(&self, c: Rational) -> Self {
        if c.is_overflow() {
            return Self::overflow();
        }
        self.times_monomial(c, &Monomial::ONE)
    }

    /// selfⁿ, with 0⁰ = 1.
    pub fn pow(&self, n: u32) -> Self {
        let mut power = if self.is_overflow() { Self::overflow() } else { Self::one() };
        for bit in (0..n.checked_ilog2().map_or(0, |top| top + 1)).rev() {
            power = power.product(&power);
            if n >> bit & 1 == 1 {
                power = power.product(self);
            }
        }
        power
    }

    /// 1/self for a single term made of parameters only.
    pub fn recip_monomial(&self) -> Option<Self> {
        let (c, monomial) = self.as_monomial()?;
        let unit = monomial.factors().iter().all(|(s, _)| s.is_parameter());
        let inverse = monomial.0.times(-1).filter(|_| unit)?;
        Some(Self::monomial(c.recip(), Monomial(inverse)))
    }
}
