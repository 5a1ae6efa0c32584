//! Roots of polynomials that are made of them.

use num_rational::BigRational;
use num_traits::{One, Zero};
use proptest::prelude::*;

use super::{Univariate, within_unit};

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// Π (x − root) · (x² + 1)ᵏ.
fn with_roots(roots: &[BigRational], complex: usize) -> Univariate {
    let times = |p: Vec<BigRational>, factor: &[BigRational]| {
        let mut product = vec![BigRational::zero(); p.len() + factor.len() - 1];
        for (i, a) in p.iter().enumerate() {
            for (k, b) in factor.iter().enumerate() {
                product[i + k] += a * b;
            }
        }
        product
    };
    let one = BigRational::one;
    let real = roots.iter().fold(vec![one()], |p, root| times(p, &[-root, one()]));
    Univariate::from_coefficients(
        &(0..complex).fold(real, |p, _| times(p, &[one(), BigRational::zero(), one()])),
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// All within [−1, 1] are found, each within 2⁻⁸⁰, and no others; clusters 1/64 wide and
    /// multiples too.
    #[test]
    fn all_roots_are_found_with_their_multiplicities(
        chosen in prop::collection::vec((-80_i64..81, 1_usize..3), 1..6),
        complex in 0_usize..3,
    ) {
        let mut known = std::collections::BTreeMap::new();
        chosen.iter().for_each(|(n, k)| *known.entry(*n).or_insert(0) += k);
        let roots: Vec<BigRational> =
            known.iter().flat_map(|(n, k)| std::iter::repeat_n(ratio(*n, 64), *k)).collect();
        let found = within_unit(&with_roots(&roots, complex));
        let expected: Vec<(i64, usize)> = known.into_iter().filter(|(n, _)| n.abs() <= 64).collect();
        prop_assert_eq!(found.len(), expected.len());
        for (root, (n, k)) in found.iter().zip(expected) {
            let error = &root.at - ratio(n, 64);
            prop_assert!(error < ratio(1, 1 << 62) && -error < ratio(1, 1 << 62), "{} {}", root.at, n);
            prop_assert_eq!(root.multiplicity as usize, k);
        }
    }
}

/// Two roots 2⁻⁵⁰ apart are two, one twice is one.
#[test]
fn near_roots_are_kept_apart_and_double_ones_are_not() {
    let [near, nearer] = [ratio(1, 3), ratio(1, 3) + ratio(1, 1 << 50)];
    let found = within_unit(&with_roots(&[near.clone(), nearer], 1));
    assert_eq!(found.iter().map(|root| root.multiplicity).collect::<Vec<_>>(), [1, 1]);
    let found = within_unit(&with_roots(&[near.clone(), near], 1));
    assert_eq!(found.iter().map(|root| root.multiplicity).collect::<Vec<_>>(), [2]);
}

#[test]
fn without_real_roots_none_is_found() {
    assert_eq!(within_unit(&with_roots(&[], 3)), []);
    assert_eq!(within_unit(&with_roots(&[ratio(3, 2), ratio(-9, 8)], 1)), []);
}
