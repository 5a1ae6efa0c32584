//! Sums with the masses collected: `(m₁ + m₂) l g sin φ`, `⅔ l² (m₁ + 4 m₂ − 3 m₂ cos 2φ)`.

use std::collections::BTreeMap;

use super::Notation;
use super::quotient::joined;
use crate::algebra::{Angle, Monomial, Rational, Series, Wave};

/// Coefficients (functions of parameters) by what they multiply.
type Collected = BTreeMap<(Monomial, Wave), Series>;

impl Notation<'_> {
    /// A series; its plain text where no coefficient is a sum.
    pub(super) fn series(&self, series: &Series) -> String {
        let (number, monomial) = series.content();
        let outside = Series::monomial(number, monomial);
        let Some(inside) = outside.recip_monomial().map(|inverse| series * &inverse) else {
            return series.text(self);
        };
        let collected = collect(&inside);
        if collected.len() < 2 && inside.len() < 2 || collected.values().all(|c| c.len() < 2) {
            return series.text(self);
        }
        match common_factor(&collected) {
            Some((factor, rest)) if leads_negative(&factor) => self.product(&[-outside, -factor], &rest),
            Some((factor, rest)) => self.product(&[outside, factor], &rest),
            None => self.product(&[outside], &self.terms(&collected)),
        }
    }

    fn product(&self, factors: &[Series], rest: &impl Inside) -> String {
        let factors = factors.iter().filter(|f| **f != Series::one()).map(|f| match f.len() {
            1 => f.text(self),
            _ => format!("({})", f.text(self)),
        });
        let mut parts: Vec<String> = factors.collect();
        match rest.inside(self) {
            (text, _) if text == "1" && !parts.is_empty() => {}
            (text, true) if !parts.is_empty() => parts.push(format!("({text})")),
            (text, _) => parts.push(text),
        }
        parts.join(" ")
    }

    fn terms(&self, collected: &Collected) -> Vec<String> {
        let (last, first): (Vec<_>, Vec<_>) = collected.iter().partition(|(_, c)| leads_negative(c));
        let text = |((monomial, wave), c): (&(Monomial, Wave), &Series)| {
            let rest = wave_times(monomial, wave);
            match (c.len(), rest == Series::one()) {
                (1, _) => (c * &rest).text(self),
                (_, true) => c.text(self),
                (_, false) => {
                    let (number, monomial) = c.content();
                    let number = if leads_negative(c) { -number } else { number };
                    let content = Series::monomial(number, monomial);
                    let primitive =
                        content.recip_monomial().map_or_else(|| c.clone(), |inverse| c * &inverse);
                    self.weighted(&content, &primitive, &rest)
                }
            }
        };
        first.into_iter().chain(last).map(text).collect()
    }
}

impl Notation<'_> {
    /// `−3 l (m₁ + m₂) φ̇ cos φ`.
    fn weighted(&self, content: &Series, sum: &Series, rest: &Series) -> String {
        let (sum, rest) = (sum.text(self), rest.text(self));
        match content.text(self).as_str() {
            "1" => format!("({sum}) {rest}"),
            "−1" => format!("−({sum}) {rest}"),
            content => format!("{content} ({sum}) {rest}"),
        }
    }
}

fn leads_negative(series: &Series) -> bool {
    series.terms().next().is_some_and(|(_, c)| c.signum() < 0)
}

/// What stands behind the common factors, and whether it is a sum.
trait Inside {
    fn inside(&self, notation: &Notation) -> (String, bool);
}

impl Inside for Series {
    fn inside(&self, notation: &Notation) -> (String, bool) {
        (self.text(notation), self.len() > 1)
    }
}

impl Inside for Vec<String> {
    fn inside(&self, _: &Notation) -> (String, bool) {
        (joined(self.iter().cloned()), true)
    }
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
    let mut rest = Series::zero();
    for ((monomial, wave), coefficient) in collected {
        let multiple = coefficient.divide_exact(&factor).filter(|m| m.len() == 1)?;
        rest += &multiple * &wave_times(monomial, wave);
    }
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
