//! Sums with the masses collected: `(m₁ + m₂) l g sin φ`, `⅔ l² (m₁ + 4 m₂ − 3 m₂ cos 2φ)`.

use std::collections::BTreeMap;

use super::Writer;
use crate::algebra::{Angle, Monomial, Rational, Series, Wave};
use crate::math::Math;

/// Coefficients (functions of parameters) by what they multiply.
type Collected = BTreeMap<(Monomial, Wave), Series>;

impl Writer<'_> {
    /// A series; as it stands where no coefficient is a sum.
    pub(super) fn series(&self, series: &Series) -> Math {
        let (number, monomial) = series.content();
        let outside = Series::monomial(number, monomial);
        let Some(inside) = outside.recip_monomial().map(|inverse| series * &inverse) else {
            return series.math(self);
        };
        let collected = collect(&inside);
        if collected.len() < 2 && inside.len() < 2 || collected.values().all(|c| c.len() < 2) {
            return series.math(self);
        }
        match common_factor(&collected) {
            Some((factor, rest)) if leads_negative(&factor) => {
                self.product(&[-outside, -factor], rest.math(self))
            }
            Some((factor, rest)) => self.product(&[outside, factor], rest.math(self)),
            None => self.product(&[outside], self.terms(&collected)),
        }
    }

    fn product(&self, factors: &[Series], rest: Math) -> Math {
        let factors = factors.iter().filter(|factor| **factor != Series::one()).map(|f| factor(f.math(self)));
        let mut parts: Vec<Math> = factors.collect();
        match rest {
            Math::Number { numerator: 1, denominator: 1 } if !parts.is_empty() => {}
            sum @ Math::Sum(_) if !parts.is_empty() => parts.push(sum.group()),
            other => parts.push(other),
        }
        match parts.as_slice() {
            [Math::Group(sum)] => (**sum).clone(),
            _ => Math::product(parts),
        }
    }

    fn terms(&self, collected: &Collected) -> Math {
        let (last, first): (Vec<_>, Vec<_>) = collected.iter().partition(|(_, c)| leads_negative(c));
        Math::sum(first.into_iter().chain(last).map(|((monomial, wave), c)| {
            let rest = wave_times(monomial, wave);
            match (c.len(), rest == Series::one()) {
                (1, _) => (c * &rest).math(self),
                (_, true) => c.math(self),
                (_, false) => self.weighted(c, &rest),
            }
        }))
    }

    /// `−3 l (m₁ + m₂) φ̇ cos φ`.
    fn weighted(&self, sum: &Series, rest: &Series) -> Math {
        let (number, monomial) = sum.content();
        let number = if leads_negative(sum) { -number } else { number };
        let content = Series::monomial(number, monomial);
        let primitive = content.recip_monomial().map_or_else(|| sum.clone(), |inverse| sum * &inverse);
        Math::product([content.math(self), primitive.math(self).group(), rest.math(self)])
    }
}

/// A sum in brackets.
fn factor(math: Math) -> Math {
    if matches!(math, Math::Sum(_)) { math.group() } else { math }
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
    let factor = first * &Series::monomial(number, monomial).recip_monomial()?;
    let rest = collected.iter().map(|((monomial, wave), coefficient)| {
        let multiple = coefficient.divide_exact(&factor).filter(|m| m.len() == 1)?;
        Some(&multiple * &wave_times(monomial, wave))
    });
    let rest = rest.collect::<Option<Vec<Series>>>()?.into_iter().sum();
    (factor.len() > 1).then_some((factor, rest))
}

fn wave_times(monomial: &Monomial, wave: &Wave) -> Series {
    let angle = wave
        .argument
        .iter()
        .fold(Angle::zero(), |sum, &(symbol, k)| &sum + &Angle::of(symbol).scale(i32::from(k)));
    let wave = if wave.sine { Series::sin(&angle) } else { Series::cos(&angle) };
    &Series::monomial(Rational::ONE, monomial.clone()) * &wave
}
