//! A chain of n hinged bars: T = Σ aᵢⱼ q̇ᵢq̇ⱼ cos(qᵢ − qⱼ), by velocities of the centres.

use super::super::{Angle, Rational, Series, Symbol};
use super::random::{L, M, symbol};

fn kinetic_energy(n: usize) -> Series {
    let (mut x, mut y) = (Series::zero(), Series::zero());
    let mut t = Series::zero();
    for i in 0..n {
        let angle = Angle::from_symbol(Symbol::coordinate(i));
        let half = symbol(L).scale(Rational::HALF);
        let (dx, dy) = (&half * Series::cos(&angle), &half * Series::sin(&angle));
        let (u, v) = ((&x + &dx).rate(), (&y + &dy).rate());
        t += (u.pow(2) + v.pow(2)).scale(Rational::HALF);
        t += (symbol(L) * symbol(Symbol::rate(i))).pow(2).scale(Rational::new(1, 24));
        x += dx.scale(2.into());
        y += dy.scale(2.into());
    }
    t * symbol(M)
}

/// The same by its closed form: aᵢⱼ = m l² (n − max − ½), aᵢᵢ = m l² (n − i − 1 + ⅓)/2.
fn closed_form(n: usize) -> Series {
    let mut t = Series::zero();
    for i in 0..n {
        for j in 0..=i {
            let below = Rational::integer((n - i - 1) as i128);
            let c =
                if i == j { (below + Rational::new(1, 3)) * Rational::HALF } else { below + Rational::HALF };
            let angle = Angle::from_symbol(Symbol::coordinate(i)) - Angle::from_symbol(Symbol::coordinate(j));
            let rates = symbol(Symbol::rate(i)) * symbol(Symbol::rate(j));
            t += (Series::cos(&angle) * rates).scale(c);
        }
    }
    t * symbol(M) * symbol(L).pow(2)
}

#[test]
fn energy_of_a_chain() {
    assert_eq!(kinetic_energy(6), closed_form(6));
}

/// 2,080 terms in T, 64·127 = 8,128 in the equations.
#[test]
fn equations_of_a_long_chain() {
    let t = closed_form(64);
    assert_eq!(t.len(), 2080);
    let equations =
        (0..64).map(|i| t.derivative(Symbol::rate(i)).rate() - t.derivative(Symbol::coordinate(i)));
    assert_eq!(equations.map(|e| e.len()).sum::<usize>(), 8128);
}
