//! Series and angles as numbers.

use super::{Angle, Series, Symbol, Term, work};

impl Angle {
    /// The value where every symbol has the value given, whole quarter turns from 0 to 3.
    pub fn evaluate(&self, value: &impl Fn(Symbol) -> f64) -> f64 {
        let turns = f64::from(self.quarter_turns()) * core::f64::consts::FRAC_PI_2;
        self.terms().iter().fold(turns, |sum, &(symbol, k)| sum + f64::from(k) * value(symbol))
    }
}

impl Series {
    /// The value where every symbol has the value given; NaN for overflow, and once the budget of
    /// [`work`] is spent.
    pub fn evaluate(&self, value: &impl Fn(Symbol) -> f64) -> f64 {
        if self.is_overflow() || !work::spend(self.len()) {
            return f64::NAN;
        }
        self.terms().map(|(term, c)| c.to_f64() * term.evaluate(value)).sum()
    }
}

impl Term {
    /// The value without coefficient.
    pub fn evaluate(&self, value: &impl Fn(Symbol) -> f64) -> f64 {
        let factors = self.monomial.factors().iter();
        let power: f64 = factors.map(|&(s, k)| value(s).powi(k.into())).product();
        let arguments = self.wave.argument.iter();
        let argument: f64 = arguments.map(|&(s, k)| value(s) * f64::from(k)).sum();
        power * if self.wave.sine { argument.sin() } else { argument.cos() }
    }
}
