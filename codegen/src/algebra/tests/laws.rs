//! What rings, derivatives and canonical forms promise, where the other tests do not state it.

use super::super::{Series, Symbol};
use super::random::*;
use proptest::prelude::*;

/// The motion whose coordinates and their derivatives have the values of a point at t = 0, to the
/// order of a step.
fn moved(value: &impl Fn(Symbol) -> f64, t: f64) -> impl Fn(Symbol) -> f64 {
    move |s| match s.derivative() {
        Some(rate) => {
            let second = rate.derivative().map_or(0.0, value);
            value(s) + t * value(rate) + 0.5 * t * t * second
        }
        None => value(s),
    }
}

proptest! {
    #[test]
    fn zero_and_one_are_neutral(a in series()) {
        prop_assert_eq!(&a + &Series::zero(), a.clone());
        prop_assert_eq!(&a * &Series::one(), a.clone());
        prop_assert!((&a * &Series::zero()).is_zero());
        prop_assert_eq!(-(-&a), a.clone());
        prop_assert!((&a + &-&a).is_zero());
        prop_assert_eq!(a.pow(0), Series::one());
    }

    /// The truncation t² f⃛/6 and the rounding ε f/t, of exponents up to three and frequencies up
    /// to twenty.
    #[test]
    fn the_rate_is_that_of_a_motion(a in series(), seed in 0..1000_u32) {
        let (value, t) = (point(seed), 1e-5);
        let difference = (a.evaluate(&moved(&value, t)) - a.evaluate(&moved(&value, -t))) / (2.0 * t);
        let scale = 1.0 + magnitude(&a, &|s| value(s).abs() + 1.0);
        prop_assert!((a.rate().evaluate(&value) - difference).abs() <= 1e-5 * scale);
    }

    #[test]
    fn a_function_of_a_function_has_the_derivative_of_both(a in series(), b in series()) {
        // d/dψ a(y = b) = ∂a/∂ψ (y = b) + ∂a/∂y (y = b) ∂b/∂ψ.
        let left = a.substitute(Y, &b).derivative(PSI);
        let right = a.derivative(PSI).substitute(Y, &b) + a.derivative(Y).substitute(Y, &b) * b.derivative(PSI);
        prop_assert_eq!(left, right);
    }

    #[test]
    fn substitution_is_a_homomorphism(a in series(), b in series(), c in series()) {
        let at = |f: &Series| f.substitute(Y, &c);
        prop_assert_eq!(at(&(&a + &b)), at(&a) + at(&b));
        prop_assert_eq!(at(&(&a * &b)), at(&a) * at(&b));
        prop_assert_eq!(a.substitute(Y, &symbol(Y)), a);
    }

    /// Series of one value have one form, whatever way they were made; those of different forms
    /// differ somewhere.
    #[test]
    fn the_form_is_that_of_the_value(a in series(), b in series(), seed in 0..1000_u32) {
        let square = |f: &Series| f * f;
        prop_assert_eq!(square(&(&a + &b)) - square(&(&a - &b)), (&a * &b).scale(4.into()));
        let values = (0..8).map(|k| {
            let value = point(seed + 1000 * k);
            let scale = magnitude(&a, &value) + magnitude(&b, &value);
            (a.evaluate(&value) - b.evaluate(&value)).abs() / scale.max(f64::MIN_POSITIVE)
        });
        prop_assert_eq!(a == b, values.fold(0.0, f64::max) <= 1e-9);
    }
}
