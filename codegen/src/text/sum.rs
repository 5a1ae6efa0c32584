//! Sums with the masses collected: `(m₁ + m₂) g l sin φ`, `⅔ l² (m₁ + m₂ + 6 m₂ sin² φ)`.

use std::collections::BTreeMap;

use super::TextWriter;
use super::writer::MASS;
use crate::algebra::{Monomial, Rational, Series, Shorthand, Symbol, SymbolNames, Term, Wave, lead, rank};
use crate::math::Math;

/// Coefficients (functions of parameters) by what they multiply.
type Collected = BTreeMap<(Monomial, Wave), Series>;

impl TextWriter<'_> {
    /// A series; as it stands where no coefficient is a sum.
    pub(super) fn series(&self, series: &Series) -> Math {
        let mut shorthand = Shorthand::new(self);
        let shortened = shorthand.shortened(series);
        SumWriter { names: &shorthand }.series(&shortened)
    }
}

/// Writes sums with some names.
struct SumWriter<'a> {
    names: &'a dyn SymbolNames,
}

impl SumWriter<'_> {
    fn series(&self, series: &Series) -> Math {
        let (number, monomial) = series.written_content();
        let Some(inside) = series.over(number, &monomial) else { return series.math(self.names) };
        let collected = collect(&inside);
        if collected.len() < 2 && inside.len() < 2 || collected.values().all(|c| c.len() < 2) {
            return series.math(self.names);
        }
        match common_factor(&collected) {
            Some((factor, rest)) => self.factored(number, &monomial, &factor, &rest),
            None if collected.values().all(leads_negative) => {
                self.product(-number, &monomial, None, self.terms(&collect(&-inside)))
            }
            None => self.product(number, &monomial, None, self.terms(&collected)),
        }
    }

    /// number · monomial · factor · rest, all signs in front.
    fn factored(&self, number: Rational, monomial: &Monomial, factor: &Series, rest: &Series) -> Math {
        let (number, factor) =
            if leads_negative(factor) { (-number, -factor) } else { (number, factor.clone()) };
        let mut terms = rest.terms();
        match (terms.next(), terms.next()) {
            (Some((_, c)), None) => {
                let (units, others) = monomial.split_units();
                let rest = &rest.scale(c.recip()) * &Series::monomial(Rational::ONE, others);
                self.product(number * c, &units, Some(&factor), rest.math(self.names))
            }
            _ => self.product(number, monomial, Some(&factor), rest.math(self.names)),
        }
    }

    /// Parameters stand behind a sum of masses: `2 (m₁ + m₂) g l`.
    fn product(&self, number: Rational, monomial: &Monomial, factor: Option<&Series>, rest: Math) -> Math {
        let (monomial, below) = monomial.over_parameters();
        let (units, others) = monomial.split_units();
        let written = |monomial| Series::monomial(Rational::ONE, monomial).math(self.names);
        let (units, others, below) = (written(units), written(others), written(below));
        let number = Series::constant(number).math(self.names);
        let sum = factor.map_or(Math::ONE, |factor| factor.math(self.names));
        let parts = match factor.is_some_and(|factor| self.weighs(factor)) && !self.has_mass(&monomial) {
            true => [number, sum, units, others],
            false => [number, units, sum, others],
        };
        let mut parts: Vec<Math> = parts.into_iter().filter(|part| *part != Math::ONE).collect();
        match rest {
            Math::ONE if !parts.is_empty() => {}
            other => parts.push(other),
        }
        divided(parts, below)
    }

    fn terms(&self, collected: &Collected) -> Math {
        let mut terms: Vec<_> = collected.iter().collect();
        terms.sort_by_cached_key(|((monomial, wave), _)| {
            rank(&Term { monomial: monomial.clone(), wave: wave.clone() })
        });
        lead(&mut terms, |(_, c)| !leads_negative(c));
        Math::sum(terms.into_iter().map(|((monomial, wave), c)| {
            let rest = wave_times(monomial, wave);
            if c.len() == 1 { (c * &rest).math(self.names) } else { self.weighted(c, &rest) }
        }))
    }

    /// `−3 (m₁ + m₂) l φ̇ cos φ`.
    fn weighted(&self, sum: &Series, rest: &Series) -> Math {
        let (number, monomial) = sum.content();
        let number = if leads_negative(sum) { -number } else { number };
        let primitive = sum.over(number, &monomial).unwrap_or_else(|| sum.clone());
        self.product(number, &monomial, Some(&primitive), rest.math(self.names))
    }

    fn weighs(&self, series: &Series) -> bool {
        series.symbols().into_iter().any(|symbol| self.is_mass(symbol))
    }

    fn has_mass(&self, monomial: &Monomial) -> bool {
        monomial.factors().iter().any(|&(symbol, _)| self.is_mass(symbol))
    }

    fn is_mass(&self, symbol: Symbol) -> bool {
        matches!(symbol, Symbol::Parameter(index) if self.names.rank_parameter(index) == MASS)
    }
}

/// A product over another, the number in front: `½ (x² + y²)/r`.
fn divided(mut above: Vec<Math>, below: Math) -> Math {
    if below == Math::ONE {
        return Math::product(above);
    }
    let is_number = |math: &Math| match math {
        Math::Minus(inner) => matches!(**inner, Math::Number { .. }),
        other => matches!(other, Math::Number { .. }),
    };
    let number = above.first().is_some_and(is_number).then(|| above.remove(0));
    Math::product(number.into_iter().chain([Math::product(above).over(below)]))
}

fn leads_negative(series: &Series) -> bool {
    series.terms().next().is_some_and(|(_, c)| c.signum() < 0)
}

fn collect(series: &Series) -> Collected {
    let mut collected = Collected::new();
    for (term, coefficient) in series.terms() {
        let (parameters, rest) = term.monomial.split_units();
        let entry = collected.entry((rest, term.wave.clone())).or_insert_with(Series::zero);
        *entry += Series::monomial(coefficient, parameters);
    }
    collected
}

/// A sum of parameters of which all coefficients are multiples, and the rest.
fn common_factor(collected: &Collected) -> Option<(Series, Series)> {
    let first = collected.values().next()?;
    let (number, monomial) = first.content();
    let factor = first.over(number, &monomial)?;
    let rest = collected.iter().map(|((monomial, wave), coefficient)| {
        let multiple = coefficient.divide_exact(&factor).filter(|m| m.len() == 1)?;
        Some(&multiple * &wave_times(monomial, wave))
    });
    let rest = rest.collect::<Option<Vec<Series>>>()?.into_iter().sum();
    (factor.len() > 1).then_some((factor, rest))
}

fn wave_times(monomial: &Monomial, wave: &Wave) -> Series {
    let angle = wave.angle();
    let wave = if wave.sine { Series::sin(&angle) } else { Series::cos(&angle) };
    &Series::monomial(Rational::ONE, monomial.clone()) * &wave
}
