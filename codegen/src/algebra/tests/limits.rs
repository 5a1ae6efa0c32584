//! Limits of numbers, exponents, multipliers and budgets.

use super::super::collect::{BATCH, Collector};
use super::super::divide::divide;
use super::super::{Angle, Monomial, Powers, Quotient, Rational, Series, Symbol, Term, Wave, work};
use super::random::*;

fn huge() -> Rational {
    Rational::integer(i128::MAX)
}

/// A series with the value overflow.
fn lost() -> Series {
    Series::constant(huge()) + Series::constant(huge())
}

#[test]
fn one_overflow_is_enough() {
    let one = Series::one();
    let sum = symbol(Y) + Series::cos(&Angle::from_symbol(PHI));
    for other in [one, sum, Series::zero()] {
        let sums = [[lost(), other.clone()], [other.clone(), lost()]];
        let mut all: Vec<Series> = sums.iter().map(|pair| pair.iter().sum()).collect();
        all.extend(sums.iter().flat_map(|[a, b]| [a + b, a - b, a * b]));
        all.extend([lost().divide_exact(&other), other.divide_exact(&lost())].into_iter().flatten());
        assert!(all.len() == 10 && all.iter().all(Series::is_overflow), "{all:?}");
        let quotients = [Quotient::new(lost(), other.clone()), Quotient::new(other.clone(), lost())];
        assert!(quotients.iter().all(Quotient::is_overflow));
    }
    let factors = [symbol(Y), symbol(L)].map(|s| s.scale(huge()));
    assert!((&factors[0] * &factors[1]).is_overflow());
}

/// cos φ / (2¹²⁷ − 1) times 1, though half of the number does not fit.
#[test]
fn a_constant_halves_nothing() {
    let tiny = Series::cos(&Angle::from_symbol(PHI)).scale(huge().recip());
    let (y, l) = (symbol(Y), symbol(L));
    let expected = &tiny + &tiny * &l + &y + &y * &l;
    assert_eq!((&tiny + &y) * (Series::one() + &l), expected);
    assert_eq!((Series::one() + &l) * (&tiny + &y), expected);
}

#[test]
fn zero_over_a_symbol_is_zero() {
    assert_eq!(Series::zero().divide_exact(&symbol(Y)), Some(Series::zero()));
}

/// y² / (2¹²⁷ − 1) over 2 y + 1: the first number of the quotient does not fit.
#[test]
fn a_division_whose_numbers_do_not_fit_fails() {
    let n = symbol(Y).pow(2).scale(huge().recip());
    let d = symbol(Y).scale(2.into()) + Series::one();
    assert_eq!(divide(n.to_exponential().unwrap(), &d.to_exponential().unwrap()), None);
}

/// 20 terms of the quotient by 20 of the divisor are 400 subtractions.
#[test]
fn a_division_spends_what_it_subtracts() {
    let [a, b] = [0..20, 20..40].map(|range| range.map(|i| symbol(Symbol::parameter(i))).sum::<Series>());
    let (n, d) = ((&a * &b).to_exponential().unwrap(), b.to_exponential().unwrap());
    let found = |budget| work::limited(budget, || divide(n.clone(), &d));
    assert_eq!(found(400), None);
    assert_eq!(found(400 * 10), Some(a.to_exponential().unwrap()));
}

#[test]
fn values_spend_too() {
    let sum = symbol(Y) + symbol(L) + Series::one();
    let value = |budget| work::limited(budget, || sum.evaluate(&point(1)));
    assert!(value(3).is_nan() && value(4) == sum.evaluate(&point(1)));
}

#[test]
fn an_angle_beyond_its_multipliers_is_no_series() {
    let lost = Angle::from_symbol(PHI).scale(32767) + Angle::from_symbol(PHI);
    for series in [symbol(PHI), symbol(PHI_RATE), Series::sin(&Angle::from_symbol(PHI))] {
        assert!(series.substitute_angle(PHI, &lost).is_overflow());
    }
    assert!(
        lost.rate().is_overflow() && Series::cos(&lost).is_overflow() && Series::sin(&lost).is_overflow()
    );
}

#[test]
fn numbers_end_at_minus_the_greatest() {
    let power = |k| Rational::integer(1_i128 << k);
    let least = Rational::integer(-i128::MAX);
    assert_eq!(-power(126) - power(126) + Rational::ZERO, Rational::OVERFLOW);
    assert_eq!(-power(126) - (power(126) - Rational::ONE), least);
    assert_eq!(-power(64) * power(63), Rational::OVERFLOW);
    assert_eq!(-power(64) * power(62), -power(126));
    let wrong = [(1, 0), (3, i128::MIN), (i128::MIN, 3), (i128::MIN, i128::MIN), (i128::MIN, -1)];
    assert!(wrong.into_iter().all(|(n, d)| Rational::new(n, d).is_overflow()));
    assert_eq!(Rational::new(i128::MAX, -i128::MAX), -Rational::ONE);
    // Greatest common divisors above and below the greatest 64-bit number.
    for (n, d) in
        [(3 << 65, 1 << 66), (3 * i128::from(u64::MAX), 2 * i128::from(u64::MAX)), (3 << 64, 1 << 65)]
    {
        assert_eq!(Rational::new(n, d), Rational::new(3, 2));
    }
    assert_eq!([0, 7].map(|n| Rational::integer(n).pow(0)), [Rational::ONE; 2]);
}

/// The terms pending a merge are fewer than a batch, or than twice the terms so far.
#[test]
fn sums_keep_few_terms_waiting() {
    let wave = Wave::ONE;
    let term = |k| Term { monomial: Monomial(Powers::single(Y, k)), wave: wave.clone() };
    let mut sum = Collector::default();
    for k in 0..20_000_i16 {
        sum.push(term(k), Rational::ONE);
        let waiting = sum.pending.len();
        assert!(waiting < BATCH.max(2 * usize::try_from(k).unwrap()), "{k}: {waiting}");
    }
    assert_eq!(sum.finish().len(), 20_000);
    let mut same = Collector::default();
    for _ in 0..3 * BATCH {
        same.push(term(1), Rational::ONE);
        assert!(same.pending.len() < BATCH);
    }
    assert_eq!(same.finish(), symbol(Y).scale(3072.into()));
}
