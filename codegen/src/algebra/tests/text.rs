use super::super::{Angle, Quotient, Rational, Series, Shorthand, Symbol, SymbolNames};
use super::random::*;
use crate::math::Math;

pub(super) struct Pair;

impl SymbolNames for Pair {
    fn parameter(&self, index: u16) -> Math {
        Math::symbol(["m", "l", "g", "m1", "slope"][usize::from(index)])
    }
    fn coordinate(&self, index: u16) -> String {
        ["phi", "psi", "y", "phi_inner", "x2"][usize::from(index)].to_owned()
    }
    fn reaction(&self, index: u16) -> Math {
        Math::symbol(["N_P", "lambda"][usize::from(index)])
    }
}

fn cosine() -> Series {
    Series::cos(&Angle::from_symbol(PHI))
}

fn r(n: i128, d: i128) -> Rational {
    Rational::new(n, d)
}

#[test]
fn symbols() {
    let text = |s| Series::symbol(s).pow(2).text(&Pair);
    let printed = [
        Symbol::parameter(3),
        Symbol::rate(0),
        Symbol::acceleration(3),
        Symbol::acceleration(4),
        Symbol::Coordinate { index: 2, order: 3 },
        Symbol::Reaction(0),
        Symbol::Reaction(1),
    ];
    let expected = ["m₁²", "φ̇²", "φ_inner''²", "ẍ₂²", "y⃛²", "N_P²", "λ²"];
    assert_eq!(printed.map(text), expected.map(String::from));
}

#[test]
fn waves() {
    let text = |a: &Angle| Series::sin(a).text(&Pair);
    assert_eq!(text(&Angle::from_symbol(PHI)), "sin φ");
    assert_eq!(text(&angle(2, 0, 0)), "sin 2φ");
    assert_eq!(text(&angle(1, -1, 0)), "sin(φ − ψ)");
    assert_eq!(text(&angle(-1, 3, 0)), "−sin(φ − 3ψ)");
    assert_eq!(text(&Angle::from_symbol(Symbol::coordinate(3)).scale(2)), "sin 2φ_inner");
    assert_eq!(text(&Angle::from_symbol(Symbol::parameter(4)).scale(2)), "sin(2 slope)");
}

#[test]
fn angles() {
    let text = |turns| angle(-1, 2, turns).math(&Pair).to_string();
    assert_eq!([0, 1, 2, 3].map(text), ["2ψ − φ", "2ψ − φ + ½π", "2ψ − φ + π", "2ψ − φ − ½π"]);
}

#[test]
fn sums() {
    let (m, l, rate, y_rate) = (symbol(M), symbol(L), symbol(PHI_RATE), symbol(Symbol::rate(2)));
    let t = &m * (y_rate.pow(2) - &y_rate * &l * &rate * cosine() + (&l * &rate).pow(2).scale(r(1, 3)));
    assert_eq!(t.text(&Pair), "⅓ m (l² φ̇² − 3 l φ̇ ẏ cos φ + 3 ẏ²)");
    let inertia = (&m * l.pow(2)).scale(r(1, 12));
    assert_eq!(inertia.text(&Pair), "¹⁄₁₂ m l²");
    let weight = &m * symbol(Symbol::parameter(2));
    let force = -(&weight * (&l * cosine() + symbol(Y)));
    assert_eq!(force.text(&Pair), "−m g (y + l cos φ)");
    let over = &weight * l.pow(2).recip_monomial().unwrap() * cosine();
    assert_eq!(over.text(&Pair), "(m g/l²) cos φ");
    let pull = (&weight * l.pow(2).recip_monomial().unwrap() * symbol(Y)).scale(r(-1, 2));
    assert_eq!(pull.text(&Pair), "−½ m g y/l²");
    assert_eq!((Series::one() - cosine()).text(&Pair), "1 − cos φ");
    assert_eq!((symbol(PSI) - symbol(Symbol::acceleration(0))).text(&Pair), "ψ − φ̈");
    assert_eq!(Series::integer(-2).text(&Pair), "−2");
    assert_eq!(Series::zero().text(&Pair), "0");
}

/// Parameters, reactions, coordinates by order; a function has nothing below it.
#[test]
fn factors_stand_in_order() {
    let reaction = symbol(Symbol::Reaction(0));
    let factors = [symbol(Symbol::acceleration(0)), symbol(PHI_RATE), symbol(Y), reaction, symbol(L)];
    let third = symbol(Symbol::Coordinate { index: 0, order: 3 });
    let product: Series = factors.iter().fold(third, |product, factor| product * factor);
    assert_eq!(product.text(&Pair), "l N_P y φ̇ φ̈ φ⃛");
    let ratio = symbol(M) * symbol(L).recip_monomial().unwrap();
    let mut names = Shorthand::new(&Pair);
    let short = names.shortened(&((Series::cos(&angle(1, -1, 0)) - Series::cos(&angle(1, 1, 0))) * &ratio));
    assert_eq!(short.text(&names), "2 (m/l) sin φ sin ψ");
    assert_eq!(ratio.text(&Pair), "m/l");
    let below = (symbol(M) * symbol(L)).recip_monomial().unwrap();
    assert_eq!((symbol(Y) * below).text(&Pair), "y/(m l)");
    assert_eq!((symbol(M) * (symbol(Y) + symbol(L))).text(&Pair), "m (y + l)");
    let over = (symbol(PHI) + symbol(PSI)) * symbol(L).recip_monomial().unwrap();
    assert_eq!(over.text(&Pair), "(φ + ψ)/l");
}

#[test]
fn quotients() {
    let n = Series::one() - cosine().pow(3);
    let q = Quotient::new(n, cosine().pow(2));
    assert_eq!(q.text(&Pair), "¼ (4 − 3 cos φ − cos 3φ) / cos² φ");
    let y = Quotient::new((symbol(L) * Series::sin(&Angle::from_symbol(PHI))).scale(r(1, 2)), cosine());
    assert_eq!(y.text(&Pair), "½ l sin φ / cos φ");
    assert_eq!(y.rate().text(&Pair), "½ l φ̇ / cos² φ");
    let root = cosine().pow(4).scale(r(4, 3)) + Series::one() - cosine().pow(3).scale(2.into());
    let sum = symbol(L) + cosine();
    let q = Quotient::new(sum.clone(), &root * cosine());
    assert!(q.text(&Pair).starts_with("6 (l + cos φ) / (cos φ (9 − 9 cos φ + 4 cos 2φ"), "{}", q.text(&Pair));
    assert_eq!(Quotient::new(sum, symbol(Y).pow(2)).text(&Pair), "(l + cos φ) / y²");
}

/// By the addition theorems; what is not shorter stays as it is.
#[test]
fn products_of_waves_stand_where_they_are_shorter() {
    let text = |series: Series| {
        let mut names = Shorthand::new(&Pair);
        let short = names.shortened(&series);
        short.text(&names)
    };
    let [phi, psi] = [0, 1].map(|i| Angle::from_symbol(Symbol::coordinate(i)));
    let (sum, difference, twice) = (&phi + &psi, &phi - &psi, phi.scale(2));
    let [sin, cos] = [Series::sin, Series::cos];
    let m = || Series::symbol(Symbol::parameter(0));
    assert_eq!(text(&cos(&difference) - &cos(&sum)), "2 sin φ sin ψ");
    assert_eq!(text(&cos(&difference) + &cos(&sum)), "2 cos φ cos ψ");
    assert_eq!(text(&sin(&sum) + &sin(&difference)), "2 sin φ cos ψ");
    assert_eq!(text(&sin(&sum) - &sin(&difference)), "2 cos φ sin ψ");
    assert_eq!(text(&m() - &(&m() * &cos(&twice))), "2 m sin² φ");
    assert_eq!(text(&Series::integer(5) + &cos(&twice).scale(r(3, 1))), "2 (1 + 3 cos² φ)");
    assert_eq!(text(&Series::integer(5) - &cos(&twice).scale(r(3, 1))), "2 (1 + 3 sin² φ)");
    assert_eq!(text(&cos(&phi) + &cos(&psi)), "cos φ + cos ψ");
    assert_eq!(text(sin(&twice)), "sin 2φ");
}
