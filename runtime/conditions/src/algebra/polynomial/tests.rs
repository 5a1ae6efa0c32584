//! Against products that are known factor by factor.

use num_bigint::BigInt;
use proptest::prelude::*;

use super::Polynomial;

const VARIABLES: usize = 3;

fn variable(at: usize) -> Polynomial {
    Polynomial::variable(VARIABLES, at)
}

fn number(n: i64) -> Polynomial {
    Polynomial::constant(VARIABLES, BigInt::from(n))
}

/// Up to three terms of degree ≤ 1 in each of three variables.
fn polynomial() -> impl Strategy<Value = Polynomial> {
    let term = (prop::collection::vec(0_u32..2, VARIABLES), -9_i64..10);
    prop::collection::vec(term, 1..4).prop_map(|terms| {
        let terms = terms.into_iter().map(|(exponents, c)| Polynomial::term(exponents, c.into()));
        terms.fold(Polynomial::zero(VARIABLES), |sum, term| &sum + &term)
    })
}

fn product<'a>(factors: impl IntoIterator<Item = &'a Polynomial>) -> Polynomial {
    factors.into_iter().fold(number(1), |product, factor| &product * factor)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn a_common_divisor_divides_and_is_the_greatest(a in polynomial(), b in polynomial(), c in polynomial()) {
        prop_assume!(!a.is_zero() && !b.is_zero() && !c.is_zero());
        let gcd = (&a * &c).gcd(&(&b * &c));
        prop_assert_eq!(gcd.divide_exact(&c).map(|rest| &rest * &c), Some(gcd.clone()));
        let [a, b] = [&a * &c, &b * &c].map(|p| p.divide_exact(&gcd));
        prop_assert!(a.zip(b).is_some_and(|(a, b)| a.gcd(&b).is_one()));
    }

    #[test]
    fn factors_multiply_to_the_whole(a in polynomial(), b in polynomial()) {
        let whole = product([&a, &b, &b]);
        prop_assume!(!whole.is_zero());
        let factors = whole.factors();
        let powers: Vec<Polynomial> = factors.factors.iter().map(|(factor, k)| factor.pow(*k)).collect();
        prop_assert_eq!(product(&powers).scale(&factors.number), whole);
        for (factor, _) in &factors.factors {
            let x = factor.first_variable().expect("a variable");
            prop_assert!(!factor.gcd(&factor.derivative(x)).depends_on(x));
        }
    }

    /// `Res Π (x − aᵢ), Π (x − bⱼ) = Π (aᵢ − bⱼ)`, the roots being polynomials in other variables.
    #[test]
    fn a_resultant_is_the_product_of_differences(numbers in prop::collection::vec(-5_i64..6, 5)) {
        let (x, y, z) = (variable(0), variable(1), variable(2));
        let a = [&y + &number(numbers[0]), number(numbers[1]), &z * &number(numbers[2])];
        let b = [&z + &number(numbers[3]), &y * &number(numbers[4])];
        let of = |roots: &[Polynomial]| product(&roots.iter().map(|root| &x - root).collect::<Vec<_>>());
        let differences: Vec<Polynomial> = a.iter().flat_map(|a| b.iter().map(move |b| a - b)).collect();
        prop_assert_eq!(of(&a).resultant(&of(&b), 0), product(&differences));
        // Of two cubics' product of degree 3 · 2 the order decides the sign: (−1)⁶.
        prop_assert_eq!(of(&b).resultant(&of(&a), 0), product(&differences));
    }
}

/// The discriminant of `a x² + b x + c` is `b² − 4 a c`, up to its sign.
#[test]
fn a_discriminant_tells_double_roots() {
    let (x, a, b) = (variable(0), variable(1), variable(2));
    let quadratic = &(&(&a * &(&x * &x)) + &(&b * &x)) + &number(7);
    let expected = &(&b * &b) - &(&number(28) * &a);
    assert_eq!(quadratic.discriminant(0).positive(), expected.positive());
}

#[test]
fn factors_of_one_exponent_are_distinguished_by_their_variables() {
    let (x, y, z) = (variable(0), variable(1), variable(2));
    let whole = product([&(&x - &number(1)), &(&y + &number(2)), &z, &z, &number(-6)]);
    let factors = whole.factors();
    let mut found: Vec<(Polynomial, u32)> = factors.factors;
    found.sort_by_key(|(factor, _)| factor.first_variable());
    assert_eq!(found, [(&x - &number(1), 1), (&y + &number(2), 1), (z, 2)]);
    assert_eq!(factors.number, BigInt::from(-6));
}

#[test]
fn inexact_division_is_detected() {
    let (x, y) = (variable(0), variable(1));
    assert_eq!((&x * &x).divide_exact(&y), None);
    assert_eq!(x.divide_exact(&number(2)), None);
    assert_eq!((&x + &y).divide_exact(&(&x - &y)), None);
}
