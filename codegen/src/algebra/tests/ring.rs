use super::super::{Rational, Series};
use super::random::*;
use proptest::prelude::*;

proptest! {
    #[test]
    fn operations_agree_with_numbers(a in series(), b in series(), seed in 0..1000_u32) {
        let value = point(seed);
        let (x, y) = (a.evaluate(&value), b.evaluate(&value));
        let (p, q) = (magnitude(&a, &value), magnitude(&b, &value));
        prop_assert!(((&a + &b).evaluate(&value) - (x + y)).abs() <= ROUNDING * (p + q));
        prop_assert!(((&a - &b).evaluate(&value) - (x - y)).abs() <= ROUNDING * (p + q));
        prop_assert!(((&a * &b).evaluate(&value) - x * y).abs() <= ROUNDING * p * q);
        prop_assert!((a.pow(3).evaluate(&value) - x * x * x).abs() <= ROUNDING * p * p * p);
    }

    #[test]
    fn ring_laws_hold_by_form(a in series(), b in series(), c in series()) {
        prop_assert_eq!(&a + &b, &b + &a);
        prop_assert_eq!(&a * &b, &b * &a);
        prop_assert_eq!((&a + &b) + &c, &a + (&b + &c));
        prop_assert_eq!((&a * &b) * &c, &a * (&b * &c));
        prop_assert_eq!((&a + &b) * &c, &a * &c + &b * &c);
        prop_assert!((&a - &a).is_zero());
        prop_assert_eq!([&a, &b, &c].into_iter().sum::<Series>(), &a + &b + &c);
        let mut sum = a.clone();
        sum += &b;
        sum -= &a;
        prop_assert_eq!(sum, b);
    }

    #[test]
    fn terms_are_sorted_distinct_and_not_zero(a in series(), b in series()) {
        for result in [&a * &b, &a + &b, a.rate(), a.derivative(PHI), a.times_monomial_of(&b)] {
            let terms: Vec<_> = result.terms().collect();
            prop_assert!(terms.windows(2).all(|pair| pair[0].0 < pair[1].0));
            prop_assert!(terms.iter().all(|(_, c)| !c.is_zero()));
        }
    }
}

impl Series {
    /// Multiplies term by term, relying on monomial products to keep the order.
    fn times_monomial_of(&self, other: &Self) -> Self {
        self.times_monomial(Rational::new(-2, 3), &other.content().1)
    }
}

#[test]
fn sums_larger_than_one_batch_are_merged() {
    // (Σ xᵢ)² over 60 symbols: 60 squares and 60·59/2 double products, from 3,600 pushed terms.
    let sum: Series = (0..60).map(|i| Series::cos(&angle(i, 1, 0)) * symbol(L)).sum();
    let xs: Series = (0..60).map(|i| symbol(super::super::Symbol::parameter(i))).sum();
    assert_eq!(xs.pow(2).len(), 60 + 60 * 59 / 2);
    assert_eq!((&sum * &xs) * &xs, &sum * xs.pow(2));
}

/// One term against many is inserted, not merged.
#[test]
fn terms_leave_a_long_sum_one_by_one() {
    let term = |i| Series::cos(&angle(i, 1, 0)).scale(i64::from(i + 1).into());
    let mut sum: Series = (0..40).map(term).sum();
    sum -= term(17);
    assert_eq!(sum, (0..17).chain(18..40).map(term).sum());
    sum += term(17);
    sum += term(17);
    assert_eq!(sum, (0..40).map(term).sum::<Series>() + term(17));
}
