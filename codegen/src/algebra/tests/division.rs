use super::super::Series;
use super::super::divide::divide;
use super::random::*;
use proptest::prelude::*;

proptest! {
    #[test]
    fn products_divide(a in series(), b in nonzero()) {
        prop_assert_eq!((&a * &b).divide_exact(&b), Some(a));
    }

    #[test]
    fn a_quotient_times_the_divisor_is_the_dividend(a in series(), b in nonzero()) {
        if let Some(q) = a.divide_exact(&b) {
            prop_assert_eq!(q * b, a);
        }
    }

    /// b | ab + 1 would make b a unit.
    #[test]
    fn one_more_than_a_product_does_not_divide(a in series(), b in nonzero()) {
        let unit = b.recip_monomial().is_some();
        let divides = (&a * &b + Series::one()).divide_exact(&b).is_some();
        prop_assert_eq!(divides, unit);
    }

    /// The degrees alone must end a division that fails.
    #[test]
    fn leading_terms_agree_with_the_image_modulo_a_prime(a in series(), b in nonzero()) {
        let (n, d) = (&a * &b + Series::one(), b.primitive().2);
        let found = divide(n.to_exponential().unwrap(), &d.to_exponential().unwrap());
        prop_assert_eq!(found.is_some(), n.divide_exact(&d).is_some());
    }
}

#[test]
fn special_divisors() {
    let (sine, cosine) = (Series::sin(&angle(1, 0, 0)), Series::cos(&angle(1, 0, 0)));
    assert_eq!(sine.divide_exact(&cosine), None);
    assert_eq!((Series::one() - sine.pow(2)).divide_exact(&cosine), Some(cosine.clone()));
    assert_eq!(Series::one().divide_exact(&Series::zero()), None);
    assert_eq!(Series::zero().divide_exact(&cosine), Some(Series::zero()));
    assert_eq!(symbol(Y).divide_exact(&symbol(L)), Some(symbol(Y) * symbol(L).recip_monomial().unwrap()));
    assert_eq!(symbol(L).divide_exact(&symbol(Y)), None);
    // (1 − cos φ)(1 + cos φ) = sin² φ, in two factorisations without a common factor.
    let (down, up) = (Series::one() - &cosine, Series::one() + &cosine);
    assert_eq!(sine.pow(2).divide_exact(&up), Some(down.clone()));
    assert_eq!(down.divide_exact(&sine), None);
}
