use super::super::{Angle, Quotient, Rational, Series, Symbol};
use super::random::*;
use proptest::prelude::*;

fn cosine() -> Series {
    Series::cos(&Angle::from_symbol(PHI))
}

fn sine() -> Series {
    Series::sin(&Angle::from_symbol(PHI))
}

fn small() -> impl Strategy<Value = Series> {
    let term = (1..4_i64, 0..3, prop::sample::select(vec![L, Y, PHI_RATE]));
    let term = term.prop_map(|(c, k, s)| (Series::cos(&angle(k, 0, 0)) + symbol(s)).scale(c.into()));
    prop_oneof![term, Just(cosine()), Just(sine()), Just(cosine().pow(2)), Just(symbol(L))]
}

fn quotient() -> impl Strategy<Value = Quotient> {
    (small(), small()).prop_map(|(n, d)| Quotient::new(n, d))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn field_laws(a in quotient(), b in quotient(), c in quotient()) {
        prop_assert!(((&a + &b) * &c).equals(&(&a * &c + &b * &c)));
        prop_assert!((&a * &b / &b).equals(&a));
        prop_assert!((&a - &a).is_zero() && (&a + &-&a).is_zero());
        let mut sum = a.clone();
        sum += b.clone();
        prop_assert!(sum.equals(&(&a + &b)));
        let value = point(5);
        let (x, y) = (a.evaluate(&value), b.evaluate(&value));
        // Values are of order 10 and below, denominators at the point of order 0.1 and above.
        prop_assert!(((&a + &b).evaluate(&value) - (x + y)).abs() < 1e-9 * (1.0 + x.abs() + y.abs()));
        prop_assert!(((&a / &b).evaluate(&value) - x / y).abs() < 1e-9 * (1.0 + (x / y).abs()));
    }

    #[test]
    fn derivatives(a in quotient(), b in quotient()) {
        prop_assert!((&a * &b).rate().equals(&(a.rate() * &b + &a * b.rate())));
        prop_assert!((a.recip().derivative(PHI)).equals(&(-a.derivative(PHI) / (&a * &a))));
        let replaced = b.substitute_angle(PHI, &angle(1, -1, 1));
        prop_assert!(replaced.rate().equals(&b.rate().substitute_angle(PHI, &angle(1, -1, 1))));
    }
}

#[test]
fn common_factors_cancel() {
    let n = Series::one() - cosine().pow(3);
    let q = Quotient::new(n.clone(), cosine().pow(2));
    assert_eq!(q.numerator(), &n);
    assert_eq!(q.factors(), &[(cosine(), 2)]);
    assert!((q - Quotient::new(Series::one(), cosine().pow(2))).equals(&(-cosine()).into()));
    let both = Quotient::new(sine().pow(2), Series::one() + cosine());
    assert_eq!(both.as_series(), Some(&(Series::one() - cosine())));
}

#[test]
fn denominators_are_split_and_units_moved() {
    let double = Series::one() + Series::cos(&angle(2, 0, 0));
    let q = Quotient::new(Series::one(), symbol(Y) * symbol(L) * double.scale(6.into()));
    let unit = symbol(L).recip_monomial().unwrap().scale(Rational::new(1, 12));
    assert_eq!(q.numerator(), &unit);
    assert_eq!(q.factors(), &[(cosine(), 2), (symbol(Y), 1)]);
    let factor = symbol(Y) + symbol(L);
    let other = symbol(Y) - symbol(L);
    let product = Quotient::new(Series::one(), &factor * &other);
    let split = product * Quotient::new(Series::one(), factor.clone());
    assert_eq!(split.factors().len(), 2);
    assert!(split.equals(&Quotient::new(Series::one(), factor.pow(2) * other)));
}

#[test]
fn division_by_zero_is_overflow() {
    let lost = Quotient::new(Series::one(), Series::zero());
    assert!(lost.is_overflow() && !lost.is_zero() && !lost.equals(&lost));
    assert!((lost * Quotient::from(Series::zero())).is_overflow());
    assert!(Quotient::from(Series::zero()).recip().is_overflow());
}

#[test]
fn a_factor_without_a_primitive_part_is_overflow() {
    let high = symbol(L).pow(32767);
    let wide = &high * symbol(Y) + high.recip_monomial().unwrap();
    let huge = Series::constant(Rational::integer(i128::MAX).recip());
    let fine = huge + symbol(Y).scale(Rational::integer(i128::MAX - 1).recip());
    for denominator in [wide, fine] {
        assert!(Quotient::new(Series::one(), denominator).is_overflow());
    }
}

#[test]
fn powers_of_composite_factors_are_split() {
    let (f, g) = (symbol(Y) + symbol(L), symbol(Y) + cosine());
    let expected = [(f.clone(), 3), (g.clone(), 2)];
    for factors in [[(f.clone(), 1), (&f * &g, 2)], [(&f * &g, 2), (f.clone(), 1)]] {
        let split = Quotient::over(Series::one(), &factors);
        let mut found = split.factors().to_vec();
        found.sort_by_key(|(_, k)| std::cmp::Reverse(*k));
        assert_eq!(found, expected);
    }
}

/// cos 2φ + 1 = 2 cos² φ, y² l = y · y · l.
#[test]
fn powers_of_powers_multiply() {
    let double = Series::one() + Series::cos(&angle(2, 0, 0));
    let cubed = Quotient::over(Series::one(), &[(double, 3), (symbol(Y).pow(2) * symbol(L), 3)]);
    assert_eq!(cubed.factors(), &[(cosine(), 6), (symbol(Y), 6)]);
    let unit = symbol(L).recip_monomial().unwrap().pow(3).scale(Rational::new(1, 8));
    assert_eq!(cubed.numerator(), &unit);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    /// y at its value a/b, in a numerator, in a denominator and in its square.
    #[test]
    fn what_replaces_a_symbol_is_its_value(q in quotient(), d in small(), a in quotient()) {
        let value = point(7);
        let y = a.evaluate(&value);
        let at = |s| if s == Y { y } else { value(s) };
        let shifted = d + symbol(Y).pow(2) + symbol(M);
        for q in [q.clone(), Quotient::over(Series::one(), &[(shifted, 2)]) * q] {
            let (found, expected) = (q.substitute_quotient(Y, &a).evaluate(&value), q.evaluate(&at));
            // Values of up to some 10⁴ with denominators that may be as small as 10⁻³.
            prop_assert!(!expected.is_finite() || (found - expected).abs() <= 1e-8 * (1.0 + expected.abs()), "{found} {expected}");
        }
    }
}

/// The paper's (3.1): y = (l/2) tan φ in T = m(ẏ² − ẏ l φ̇ cos φ + l²φ̇²/3) gives
/// (m l²/4)(4/3 + 1/cos⁴φ − 2/cos φ) φ̇².
#[test]
fn paper_3_1_by_substitution() {
    let (m, l, rate) = (symbol(M), symbol(L), symbol(PHI_RATE));
    let y = Quotient::new((&l * sine()).scale(Rational::HALF), cosine());
    let y_rate = Symbol::rate(2);
    let free = &m
        * (symbol(y_rate).pow(2) - symbol(y_rate) * &l * &rate * cosine()
            + (&l * &rate).pow(2).scale(Rational::new(1, 3)));
    let found = free.substitute_quotient(y_rate, &y.rate());
    let over = |n: i64, k| Quotient::new(Series::integer(n), cosine().pow(k));
    let shape = Quotient::from(Series::constant(Rational::new(4, 3))) + over(1, 4) - over(2, 1);
    let factor = (&m * &l.pow(2) * rate.pow(2)).scale(Rational::new(1, 4));
    assert!(found.equals(&(shape * Quotient::from(factor))));
    assert_eq!(found.factors(), &[(cosine(), 4)]);
}
