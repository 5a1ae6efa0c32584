use super::super::Rational;
use proptest::prelude::*;

fn rational() -> impl Strategy<Value = Rational> {
    (-999_i128..999, 1..99_i128).prop_map(|(n, d)| Rational::new(n, d))
}

proptest! {
    #[test]
    fn field_laws(a in rational(), b in rational(), c in rational()) {
        prop_assert_eq!((a + b) * c, a * c + b * c);
        prop_assert_eq!(a - b + b, a);
        prop_assert!(b.is_zero() || a / b * b == a);
        prop_assert_eq!(a.cmp(&b), (a - b).signum().cmp(&0));
        prop_assert_eq!((a * a).sqrt_exact(), Some(a.abs()));
        prop_assert!(a.is_zero() || a.pow(-3) * a.pow(3) == Rational::ONE);
        let common = a.gcd(b);
        if !common.is_zero() {
            let [n, d] = [a / common, b / common];
            prop_assert!(common > Rational::ZERO && [n, d].iter().all(|whole| whole.denominator() == 1));
            let divides = |k: i128| n.numerator() % k == 0 && d.numerator() % k == 0;
            prop_assert!((2..100).all(|k| !divides(k)));
        }
    }
}

#[test]
fn lowest_terms_and_print() {
    assert_eq!(Rational::new(6, -8), Rational::new(-3, 4));
    assert_eq!(Rational::new(-6, 8).to_string(), "-3/4");
    assert_eq!(Rational::new(0, -5), Rational::ZERO);
    assert_eq!(Rational::new(2, 1).sqrt_exact(), None);
    assert_eq!([-4, 0].map(|n| Rational::new(n, 1).sqrt_exact()), [None, Some(Rational::ZERO)]);
    assert_eq!(Rational::new(2, 3).to_f64(), 2.0 / 3.0);
    let wide = Rational::new(i128::MAX, i128::MAX - 1);
    assert!(wide > Rational::ONE && -wide < -Rational::ONE && wide.recip() < Rational::ONE);
}

#[test]
fn overflow_absorbs() {
    let huge = Rational::integer(i128::MAX);
    let tiny = huge.recip();
    for lost in [
        huge + Rational::ONE,
        huge * huge,
        tiny * tiny,
        tiny + Rational::new(1, i128::MAX - 1),
        -huge - Rational::integer(2),
        Rational::new(1, 0),
        Rational::ZERO.recip(),
        Rational::ZERO.pow(-1),
        huge.pow(2),
        Rational::new(i128::MIN, 1),
    ] {
        assert!(lost.is_overflow() && !lost.is_zero(), "{lost}");
        assert!((lost * Rational::ZERO + Rational::ONE).is_overflow());
        assert!((-lost).recip().abs().pow(0).is_overflow());
        assert!(lost.to_f64().is_nan() && lost.sqrt_exact().is_none());
    }
    assert!((huge - huge).is_zero());
}

#[test]
fn one_overflow_of_two_is_enough() {
    let lost = Rational::OVERFLOW;
    for other in [Rational::ZERO, Rational::ONE, Rational::HALF, -Rational::new(7, 3), lost] {
        let pairs = [(lost, other), (other, lost)];
        let all = pairs.map(|(a, b)| [a + b, a - b, a * b, a / b, a.gcd(b)]);
        assert_eq!(all, [[lost; 5]; 2], "{other}");
        assert!(!lost.is_negative() && other <= lost);
    }
}
