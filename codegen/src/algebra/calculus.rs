//! ∂/∂symbol and d/dt, term by term:
//! ∂(sᵉ·r·sin(k s + …)) = e sᵉ⁻¹·r·sin(k s + …) + k sᵉ·r·cos(k s + …).

use super::collect::Collector;
use super::product::push_wave;
use super::{Angle, Monomial, Powers, Rational, Series, Symbol, Term};

impl Series {
    /// ∂/∂symbol, of monomials and waves, all other symbols held.
    pub fn derivative(&self, symbol: Symbol) -> Self {
        self.collect(|sum| {
            for (term, c) in self.entries() {
                push_derivative(sum, term, *c, symbol, None);
            }
        })
    }

    /// d/dt: the sum over coordinates and their rates of ∂/∂q⁽ᵏ⁾ · q⁽ᵏ⁺¹⁾; all else is constant.
    pub fn rate(&self) -> Self {
        self.collect(|sum| {
            for (term, c) in self.entries() {
                for symbol in term.symbols() {
                    if let Some(rate) = symbol.derivative() {
                        push_derivative(sum, term, *c, symbol, Some(rate));
                    }
                }
            }
        })
    }
}

impl Angle {
    /// Its time derivative Σ kᵢ·q̇ᵢ; parameters are constant.
    pub fn rate(&self) -> Series {
        if self.multipliers().is_none() {
            return Series::overflow();
        }
        let rates = self
            .terms()
            .iter()
            .filter_map(|&(symbol, k)| Some(Series::symbol(symbol.derivative()?).scale(i64::from(k).into())));
        rates.sum()
    }
}

impl Term {
    /// Every symbol of the term once.
    fn symbols(&self) -> impl Iterator<Item = Symbol> {
        let waves = self.wave.argument.iter();
        let fresh = waves.filter(|(symbol, _)| self.monomial.exponent(*symbol) == 0);
        let all = self.monomial.factors().iter().chain(fresh);
        all.map(|&(symbol, _)| symbol)
    }
}

/// Adds c · ∂term/∂symbol · inner, inner being a symbol or 1.
fn push_derivative(sum: &mut Collector, term: &Term, c: Rational, symbol: Symbol, inner: Option<Symbol>) {
    let (exponent, multiplier) = (term.monomial.exponent(symbol), term.wave.argument.get(symbol));
    if exponent == 0 && multiplier == 0 {
        return;
    }
    let inner = inner.map_or(Powers::ZERO, |symbol| Powers::single(symbol, 1));
    let Some(powers) = term.monomial.0.plus(&inner) else {
        return sum.poison();
    };
    if exponent != 0 {
        let Some(lowered) = powers.minus(&Powers::single(symbol, 1)) else {
            return sum.poison();
        };
        let (monomial, wave) = (Monomial(lowered), term.wave.clone());
        sum.push(Term { monomial, wave }, c * i64::from(exponent).into());
    }
    if multiplier != 0 {
        let slope = if term.wave.sine { multiplier } else { -multiplier };
        let argument = Some(term.wave.argument.clone());
        let c = c * i64::from(slope).into();
        push_wave(sum, &Monomial(powers), !term.wave.sine, argument, c);
    }
}
