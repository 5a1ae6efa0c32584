use super::super::{Angle, Rational, Series, Symbol};
use super::random::*;
use proptest::prelude::*;

#[test]
fn pythagoras() {
    let a = angle(2, -3, 1);
    assert_eq!(Series::sin(&a).pow(2) + Series::cos(&a).pow(2), Series::one());
}

proptest! {
    #[test]
    fn addition_theorems(k in -4..4, n in -4..4, q in 0..4_i64, r in -3..4, s in -9..9_i64) {
        let (a, b) = (angle(k, n, q), angle(r, 1, s));
        let (sine, cosine) = (Series::sin, Series::cos);
        let sum = &a + &b;
        prop_assert_eq!(sine(&sum), sine(&a) * cosine(&b) + cosine(&a) * sine(&b));
        prop_assert_eq!(cosine(&sum), cosine(&a) * cosine(&b) - sine(&a) * sine(&b));
        prop_assert_eq!(sine(&-&a), -sine(&a));
        prop_assert_eq!(cosine(&(&a - &b)), cosine(&(&b - &a)));
    }

    #[test]
    fn quarter_turns_are_exact(k in -3..3, n in -3..3, q in -9..9_i64, seed in 0..99_u32) {
        let (a, value) = (angle(k, n, q), point(seed));
        let x = f64::from(k) * value(PHI) + f64::from(n) * value(PSI)
            + q as f64 * std::f64::consts::FRAC_PI_2;
        prop_assert!((Series::cos(&a).evaluate(&value) - x.cos()).abs() < ROUNDING);
        prop_assert!((Series::sin(&a).evaluate(&value) - x.sin()).abs() < ROUNDING);
    }
}

proptest! {
    #[test]
    fn angles_take_the_values_of_their_symbols(k in -4..4, n in -4..4, r in -4..4, q in 0..4_i64, seed in 0..99_u32) {
        let (a, b, value) = (angle(k, n, q), angle(r, 1, 1), point(seed));
        let phi = b.evaluate(&value);
        let at = |s| if s == PHI { phi } else { value(s) };
        let turns = |x: f64| (x / std::f64::consts::TAU).rem_euclid(1.0);
        let apart = (turns(a.substitute(PHI, &b).evaluate(&value)) - turns(a.evaluate(&at))).abs();
        prop_assert!(apart.min(1.0 - apart) < ROUNDING);
        prop_assert_eq!(a.turned(q - 3), &a + &Angle::quarters(q - 3));
        prop_assert_eq!(&(&a - &b) + &b, a);
    }
}

#[test]
fn powers_of_a_cosine_come_in_multiples() {
    // cos⁴ φ = (3 + 4 cos 2φ + cos 4φ)/8.
    let multiple = |k, c| Series::cos(&angle(k, 0, 0)).scale(Rational::new(c, 8));
    let expected = multiple(0, 3) + multiple(2, 4) + multiple(4, 1);
    assert_eq!(Series::cos(&angle(1, 0, 0)).pow(4), expected);
}

#[test]
fn overflow_is_sticky_and_not_zero() {
    let huge = Series::constant(Rational::new(i128::MAX, 1));
    let mixed = &huge * symbol(PHI) + symbol(L);
    let lost = &mixed * &mixed;
    for result in [
        lost.derivative(Y),
        lost.rate(),
        &lost * Series::zero(),
        Series::zero() * &lost,
        &lost - &lost,
        lost.scale(Rational::ZERO),
        lost.coefficient(Y, 3),
        lost.substitute(PHI, &Series::zero()),
        lost.substitute_angle(PHI, &Angle::zero()),
        &huge + &huge,
        lost.pow(0),
    ] {
        assert!(result.is_overflow() && !result.is_zero());
        assert!(result.evaluate(&point(0)).is_nan());
    }
}

#[test]
fn exponents_overflow_too() {
    let high = symbol(L).pow(32767);
    assert_eq!(high.degree(L), 32767);
    assert!((&high * symbol(L)).is_overflow());
    assert!((high.recip_monomial().unwrap() * symbol(L).recip_monomial().unwrap()).is_overflow());
    let fast = Angle::from_symbol(PHI).scale(32767);
    assert!(Series::cos(&(&fast + &Angle::from_symbol(PHI))).is_overflow());
    assert!((Series::cos(&fast) * Series::cos(&Angle::from_symbol(PHI))).is_overflow());
}

#[test]
fn queries() {
    let f = symbol(M) * symbol(L).pow(2) * Series::cos(&angle(1, -1, 0)) * symbol(PHI_RATE);
    let g = symbol(M) * symbol(L) * symbol(Y);
    let sum = f.scale(Rational::new(4, 3)) - g.scale(Rational::new(2, 9));
    assert_eq!(sum.content().0, Rational::new(2, 9));
    assert_eq!(sum.content().1.factors(), &[(M, 1), (L, 1)]);
    assert!(sum.in_wave(PSI) && !sum.in_wave(Y) && sum.depends_on(Y) && !sum.depends_on(Symbol::Reaction(0)));
    assert_eq!(sum.degree(L), 2);
    assert_eq!(sum.coefficient(Y, 1), (symbol(M) * symbol(L)).scale(Rational::new(-2, 9)));
    assert_eq!(sum.symbols().len(), 6);
    assert_eq!(Series::integer(5).as_constant(), Some(5.into()));
    assert_eq!(sum.as_constant(), None);
    assert!(
        f.as_monomial().is_none() && f.recip_monomial().is_none() && symbol(Y).recip_monomial().is_none()
    );
}

/// A number in front is not written where it, or what it leaves, has five digits.
#[test]
fn long_numbers_are_not_divided() {
    let of = |number: Rational, left: i64| {
        let series = symbol(Y).scale(left.into()) + symbol(PHI);
        series.scale(number).written_content().0
    };
    let [third, two_thirds, two] = [Rational::new(1, 3), Rational::new(2, 3), Rational::integer(2)];
    assert_eq!(
        [4999, 9999, 10_000].map(|left| of(two_thirds, left)),
        [two_thirds, two_thirds, Rational::ONE]
    );
    assert_eq!([9999, 10_000].map(|left| of(third, left)), [third, Rational::ONE]);
    assert_eq!(of(two, 10_000), two);
    assert_eq!(of(Rational::new(20_000, 3), 5), Rational::ONE);
}
