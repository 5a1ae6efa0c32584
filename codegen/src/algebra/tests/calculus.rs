//! Derivatives against dual numbers: x + x′ε with ε² = 0, exact up to rounding.

use super::super::{Series, Symbol, Term};
use super::random::*;
use proptest::prelude::*;

type Dual = (f64, f64);

fn times((x, dx): Dual, (y, dy): Dual) -> Dual {
    (x * y, dx * y + x * dy)
}

fn term_dual(term: &Term, value: &impl Fn(Symbol) -> Dual) -> Dual {
    let mut product = (1.0, 0.0);
    for &(s, k) in term.monomial.factors() {
        let (x, dx) = value(s);
        let power = (x.powi(k.into()), f64::from(k) * x.powi(i32::from(k) - 1) * dx);
        product = times(product, power);
    }
    let (mut x, mut dx) = (0.0, 0.0);
    for &(s, k) in &term.wave.argument {
        x += f64::from(k) * value(s).0;
        dx += f64::from(k) * value(s).1;
    }
    let wave = if term.wave.sine { (x.sin(), x.cos() * dx) } else { (x.cos(), -x.sin() * dx) };
    times(product, wave)
}

fn dual(series: &Series, value: &impl Fn(Symbol) -> Dual) -> f64 {
    series.terms().map(|(term, c)| c.to_f64() * term_dual(term, value).1).sum()
}

/// Exponents and multipliers up to about ten multiply the rounding of a derivative.
const SLACK: f64 = 10.0 * ROUNDING;

proptest! {
    #[test]
    fn partial_derivatives_agree(a in series(), seed in 0..1000_u32) {
        let value = point(seed);
        for s in [L, PHI, PSI, PHI_RATE, Y] {
            let expected = dual(&a, &|t| (value(t), f64::from(u8::from(s == t))));
            let found = a.derivative(s).evaluate(&value);
            prop_assert!((found - expected).abs() <= SLACK * (1.0 + magnitude(&a, &value)));
        }
    }

    #[test]
    fn rate_follows_the_chain_rule(a in series(), seed in 0..1000_u32) {
        let value = point(seed);
        let expected = dual(&a, &|t| (value(t), t.derivative().map_or(0.0, &value)));
        let found = a.rate().evaluate(&value);
        prop_assert!((found - expected).abs() <= SLACK * (1.0 + magnitude(&a, &value)));
    }

    #[test]
    fn product_rule_and_symmetry_hold_by_form(a in series(), b in series()) {
        let product = &a * &b;
        prop_assert_eq!(product.rate(), a.rate() * &b + &a * b.rate());
        prop_assert_eq!(product.derivative(PHI), a.derivative(PHI) * &b + &a * b.derivative(PHI));
        prop_assert_eq!(a.derivative(PHI).derivative(L), a.derivative(L).derivative(PHI));
        // ∂ḟ/∂q̇ = ∂f/∂q + d/dt ∂f/∂q̇
        let cancelled = a.rate().derivative(PHI_RATE) - a.derivative(PHI_RATE).rate();
        prop_assert_eq!(cancelled, a.derivative(PHI));
    }
}
