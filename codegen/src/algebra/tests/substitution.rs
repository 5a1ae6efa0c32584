use super::super::{Angle, Quotient, Rational, Series};
use super::random::*;
use proptest::prelude::*;

proptest! {
    #[test]
    fn a_symbol_takes_its_value(a in series(), b in series(), seed in 0..1000_u32) {
        let value = point(seed);
        let y = b.evaluate(&value);
        let found = a.substitute(Y, &b).evaluate(&value);
        let at = |s| if s == Y { y } else { value(s) };
        let scale = magnitude(&a, &|s| if s == Y { magnitude(&b, &value) } else { value(s) });
        prop_assert!((found - a.evaluate(&at)).abs() <= ROUNDING * scale);
    }

    #[test]
    fn an_angle_takes_its_value_and_its_rates(a in series(), k in -3..3, n in -3..3, seed in 0..99_u32) {
        let (b, value) = (angle(k, n, 1), point(seed));
        let replaced = a.substitute_angle(PHI, &b);
        let at = |s| {
            let derivative = |order: u8| {
                let q = |index| value(super::super::Symbol::Coordinate { index, order });
                f64::from(k) * q(0) + f64::from(n) * q(1)
            };
            match s {
                super::super::Symbol::Coordinate { index: 0, order: 0 } => {
                    derivative(0) + std::f64::consts::FRAC_PI_2
                }
                super::super::Symbol::Coordinate { index: 0, order } => derivative(order),
                _ => value(s),
            }
        };
        let bound = |s| value(s).abs() + at(s).abs() + 9.0;
        let scale = magnitude(&a, &bound).max(1.0);
        let (found, expected) = (replaced.evaluate(&value), a.evaluate(&at));
        // 1/l is bounded from below by 1/(l + 9) only, hence the tenfold slack.
        prop_assert!((found - expected).abs() <= 100.0 * ROUNDING * scale);
    }

    #[test]
    fn replacing_an_angle_commutes_with_the_rate(a in series(), k in -3..3, n in -3..3, q in 0..4_i64) {
        let b = angle(k, n, q);
        prop_assert_eq!(a.substitute_angle(PHI, &b).rate(), a.rate().substitute_angle(PHI, &b));
        prop_assert_eq!(&b.rate(), &Series::symbol(PHI_RATE).substitute_angle(PHI, &b));
    }

    #[test]
    fn quotients_replace_symbols(a in series(), n in nonzero(), d in nonzero()) {
        let q = Quotient::new(n, d.clone());
        let found = a.substitute_quotient(Y, &q);
        let parts = (0..=a.degree(Y)).map(|k| {
            let power = (0..k).fold(Quotient::from(Series::one()), |p, _| p * &q);
            power * Quotient::from(a.coefficient(Y, k))
        });
        prop_assert!(found.is_overflow() || found.equals(&parts.sum()));
    }
}

#[test]
fn negative_powers_need_a_unit() {
    let inverse = symbol(L).recip_monomial().unwrap();
    let half = symbol(M).scale(Rational::HALF);
    let expected = symbol(M).recip_monomial().unwrap().scale(2.into());
    assert_eq!(inverse.substitute(L, &half), expected);
    assert!(inverse.substitute(L, &symbol(Y)).is_overflow());
    let over_y = inverse.substitute_quotient(L, &symbol(Y).into());
    assert!((over_y * Quotient::from(symbol(Y))).equals(&Series::one().into()));
    assert!(inverse.substitute_quotient(L, &Series::zero().into()).is_overflow());
}

#[test]
fn equal_angles_merge() {
    let difference = Series::cos(&angle(1, -1, 0)) * symbol(PHI_RATE);
    let merged = difference.substitute_angle(PSI, &Angle::from_symbol(PHI));
    assert_eq!(merged, symbol(PHI_RATE));
    assert!(symbol(PHI).substitute_angle(PHI, &Angle::quarters(1)).is_overflow());
}

/// φ = 2φ + ψ in φ⃛ and in φ, with no derivative between them; ψ⃛ stays.
#[test]
fn derivatives_of_any_order_are_replaced() {
    let third = |index| symbol(super::super::Symbol::Coordinate { index, order: 3 });
    let found = (third(0) * symbol(PHI) + third(1)).substitute_angle(PHI, &angle(2, 1, 0));
    let turned = third(0).scale(2.into()) + third(1);
    assert_eq!(found, turned * (symbol(PHI).scale(2.into()) + symbol(PSI)) + third(1));
    let slope = Angle::from_symbol(L).scale(3);
    assert_eq!(
        (Series::sin(&Angle::from_symbol(M)) + symbol(M)).substitute_angle(M, &slope),
        Series::sin(&slope) + symbol(L).scale(3.into())
    );
}
