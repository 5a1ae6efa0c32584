//! Products of two waves where they are shorter than the sums that series have:
//! `1 − cos 2φ = 2 sin² φ`, `cos(φ − ψ) − cos(φ + ψ) = 2 sin φ sin ψ`.
//!
//! With `a = ½ (α + β)` and `b = ½ (α − β)`
//!
//! ```text
//! p cos α + q cos β = (p + q) cos a cos b + (q − p) sin a sin b
//! p sin α + q sin β = (p + q) sin a cos b + (p − q) cos a sin b
//! p cos 2a + q      = (p + q) − 2 p sin² a = (q − p) + 2 p cos² a
//! ```
//!
//! A product is a symbol of its own in what is printed; nothing computes with it.

use std::collections::BTreeMap;

use super::super::{Monomial, Powers, Rational, Series, Symbol, Term, Wave};
use super::names::{PRODUCT, SymbolNames};
use super::products::wave;
use crate::math::Math;

/// Sums of more waves are left as they are: every pair is tried.
const MOST: usize = 48;

/// Names that know the products of waves too.
pub struct Shorthand<'a> {
    names: &'a dyn SymbolNames,
    pub(in crate::algebra) products: Vec<[Wave; 2]>,
}

/// Coefficients, made of parameters, of the waves that one monomial of coordinates and rates is
/// multiplied by.
type Waves = BTreeMap<Wave, Series>;

impl<'a> Shorthand<'a> {
    /// The names, without products.
    pub fn new(names: &'a dyn SymbolNames) -> Self {
        Self { names, products: Vec::new() }
    }

    /// The series with products of waves in place of sums, where fewer terms are left.
    pub fn shortened(&mut self, series: &Series) -> Series {
        if series.is_overflow() {
            return series.clone();
        }
        let mut groups: BTreeMap<Monomial, Waves> = BTreeMap::new();
        for (term, coefficient) in series.terms() {
            let (parameters, rest) = term.monomial.split_units();
            let waves = groups.entry(rest).or_default();
            *waves.entry(term.wave.clone()).or_insert_with(Series::zero) +=
                Series::monomial(coefficient, parameters);
        }
        let written = groups
            .into_iter()
            .map(|(monomial, waves)| &self.group(waves) * &Series::monomial(Rational::ONE, monomial));
        written.sum()
    }

    /// The waves of one monomial; the pair that saves most first.
    fn group(&mut self, mut waves: Waves) -> Series {
        let mut written = Series::zero();
        while waves.len() <= MOST
            && let Some(best) = pairs(&waves).into_iter().max_by_key(|pair| pair.saves)
        {
            best.pair.iter().for_each(|wave| drop(waves.remove(wave)));
            for (factors, coefficient) in best.products {
                if let Some(constant) = factors.is_none().then(|| coefficient.clone()) {
                    *waves.entry(Wave::ONE).or_insert_with(Series::zero) += constant;
                    continue;
                }
                let symbol = factors.map_or(Series::one(), |factors| Series::symbol(self.symbol(factors)));
                written += &coefficient * &symbol;
            }
        }
        let rest = waves.into_iter().map(|(wave, coefficient)| {
            &coefficient * &Series::term(Rational::ONE, Term { monomial: Monomial::ONE, wave })
        });
        written + rest.sum::<Series>()
    }

    fn symbol(&mut self, factors: [Wave; 2]) -> Symbol {
        let known = self.products.iter().position(|product| *product == factors);
        let index = known.unwrap_or_else(|| {
            self.products.push(factors);
            self.products.len() - 1
        });
        Symbol::Opaque { index: index as u16, order: PRODUCT }
    }
}

impl SymbolNames for Shorthand<'_> {
    fn parameter(&self, index: u16) -> Math {
        self.names.parameter(index)
    }

    fn rank_parameter(&self, index: u16) -> u8 {
        self.names.rank_parameter(index)
    }

    fn coordinate(&self, index: u16) -> String {
        self.names.coordinate(index)
    }

    fn reaction(&self, index: u16) -> Math {
        self.names.reaction(index)
    }

    fn opaque_term(&self, index: u16) -> String {
        self.names.opaque_term(index)
    }

    fn product(&self, index: u16) -> Math {
        match self.products.get(usize::from(index)) {
            Some([one, other]) if one == other => wave(one, 2, self),
            Some(both) => Math::product(both.iter().map(|factor| wave(factor, 1, self))),
            None => Math::ONE,
        }
    }
}

/// Two waves, and what their sum is written as.
struct WavePair {
    pair: [Wave; 2],
    /// Products of waves, none for the constant 1, by their coefficients.
    products: Vec<(Option<[Wave; 2]>, Series)>,
    /// Terms saved; then fewer signs; then smaller numbers.
    saves: (usize, i128, i128),
}

fn pairs(waves: &Waves) -> Vec<WavePair> {
    let mut pairs = Vec::new();
    for (i, first) in waves.iter().enumerate() {
        for second in waves.iter().skip(i + 1) {
            // 1 comes before all waves.
            if first.0.is_one() {
                pairs.extend(squares(second, first.1));
            } else {
                pairs.extend(product(first, second));
            }
        }
    }
    pairs
}

/// `p cos 2a + q` by a square.
fn squares((double, p): (&Wave, &Series), q: &Series) -> Vec<WavePair> {
    let Some(half) = halved(&double.argument).filter(|_| !double.sine) else { return Vec::new() };
    let twice = p.scale(Rational::integer(2));
    let square = |sine| Some([Wave { argument: half.clone(), sine }, Wave { argument: half.clone(), sine }]);
    let forms = [(q + p, -&twice, true), (q - p, twice, false)];
    let before = measure([p, q]);
    let pair = forms.into_iter().filter_map(|(constant, coefficient, sine)| {
        let after = measure([&constant, &coefficient]);
        (after < before).then(|| WavePair {
            pair: [double.clone(), Wave::ONE],
            products: vec![(square(sine), coefficient), (None, constant)],
            saves: (before.0.saturating_sub(after.0), before.1 - after.1, before.2 - after.2),
        })
    });
    pair.collect()
}

/// `p cos α + q cos β`, or the same of sines, by one product of waves or two.
fn product((alpha, p): (&Wave, &Series), (beta, q): (&Wave, &Series)) -> Option<WavePair> {
    if alpha.sine != beta.sine {
        return None;
    }
    let a = halved(&alpha.argument.plus(&beta.argument)?)?;
    let b = halved(&alpha.argument.minus(&beta.argument)?)?;
    let sine = alpha.sine;
    let forms = match sine {
        false => [(false, false, p + q), (true, true, q - p)],
        true => [(true, false, p + q), (false, true, p - q)],
    };
    let mut products = Vec::new();
    for (first, second, coefficient) in forms {
        let (negative_a, wave_a) = Wave::canonical(first, a.clone())?;
        let (negative_b, wave_b) = Wave::canonical(second, b.clone())?;
        let coefficient = if negative_a == negative_b { coefficient } else { -coefficient };
        if !coefficient.is_zero() {
            let mut factors = [wave_a, wave_b];
            factors.sort_by(|x, y| (&x.argument[0].0, &x.argument).cmp(&(&y.argument[0].0, &y.argument)));
            products.push((Some(factors), coefficient));
        }
    }
    let after = products.iter().map(|(_, coefficient)| coefficient.len()).sum::<usize>();
    let saves = (p.len() + q.len()).checked_sub(after).filter(|&saved| saved > 0)?;
    Some(WavePair { pair: [alpha.clone(), beta.clone()], products, saves: (saves, 0, 0) })
}

/// Terms, signs among them, and the sum of their numbers over the greatest that they have in
/// common.
fn measure(parts: [&Series; 2]) -> (usize, i128, i128) {
    let numbers: Vec<Rational> = parts.iter().flat_map(|part| part.terms().map(|(_, c)| c)).collect();
    let negative = numbers.iter().filter(|c| c.is_negative()).count();
    let common = numbers.iter().fold(Rational::ZERO, |common, c| common.gcd(*c));
    let sum = numbers.iter().map(|c| (*c * common.recip()).numerator().abs());
    let signs = if negative == numbers.len() { 0 } else { negative as i128 };
    (numbers.len(), signs, sum.fold(0, i128::saturating_add))
}

/// Half of an angle, where that is a whole multiple of symbols.
fn halved(argument: &Powers) -> Option<Powers> {
    let whole = argument.iter().all(|(_, k)| k % 2 == 0);
    whole.then(|| {
        argument.iter().fold(Powers::ZERO, |mut half, &(symbol, k)| {
            half.push(symbol, k / 2);
            half
        })
    })
}
