//! Varied names in conditions.

use super::cell::written;
use super::range::{Spread, Varied};
use crate::run_spec::RunSpec;
use liftoff::Output;
use liftoff_core::model::Layout;

/// The varied names that conditions may use: those that are none of the model.
pub(super) struct Inserted {
    names: Vec<(usize, String)>,
}

impl Inserted {
    pub(super) fn new(names: &[&str], layout: &'static Layout) -> Self {
        let own = names.iter().enumerate().filter(|(_, name)| Output::parse(layout, name).is_err());
        Self { names: own.map(|(i, name)| (i, (*name).to_owned())).collect() }
    }

    /// Whether a condition of a run uses the varied name of this index.
    pub(super) fn uses(&self, spec: &RunSpec, varied: usize) -> bool {
        let Some((_, name)) = self.names.iter().find(|(i, _)| *i == varied) else { return false };
        let conditions = spec.until.iter().chain(spec.cut.iter().map(|(_, condition)| condition));
        conditions.flat_map(|condition| words(condition)).any(|(word, is_name)| is_name && word == name)
    }

    /// Puts the values at a point in the place of the names.
    pub(super) fn apply(&self, spec: &mut RunSpec, point: &[f64]) {
        let conditions = spec.until.iter_mut().chain(spec.cut.iter_mut().map(|(_, condition)| condition));
        conditions
            .filter(|_| !self.names.is_empty())
            .for_each(|condition| *condition = self.filled(condition, point));
    }

    fn filled(&self, condition: &str, point: &[f64]) -> String {
        let value = |word: &str| {
            let (i, _) = self.names.iter().find(|(_, name)| name == word)?;
            point.get(*i).map(|value| match written(*value) {
                negative if negative.starts_with('-') => format!("({negative})"),
                value => value,
            })
        };
        let filled =
            |(word, is_name): (&str, bool)| value(word).filter(|_| is_name).unwrap_or(word.to_owned());
        words(condition).into_iter().map(filled).collect()
    }
}

/// A point amid the ranges.
pub(super) fn amid(varied: &[Varied]) -> Vec<f64> {
    let value = |varied: &Varied| match &varied.spread {
        Spread::Grid(range, _) | Spread::Anywhere(range) => range.interpolate(0.5),
        Spread::Listed(values) => values.first().copied().unwrap_or(f64::NAN),
    };
    varied.iter().map(value).collect()
}

/// A text in its words and what stands between them, with which of both they are.
fn words(text: &str) -> Vec<(&str, bool)> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_' || c == '\'' || c == '.';
    let mut words = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c| is_word(c) != is_word(first)).unwrap_or(rest.len());
        let (word, behind) = rest.split_at(end);
        words
            .push((word, is_word(first) && !first.is_ascii_digit() && !behind.trim_start().starts_with('(')));
        rest = behind;
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_whole_words() {
        let inserted = Inserted { names: vec![(0, "s".into()), (1, "e".into())] };
        let filled = |text: &str| inserted.filled(text, &[0.25, -1e-9]);
        assert_eq!(filled("phi = s + 2*e"), "phi = 0.25 + 2*(-1e-9)");
        assert_eq!(filled("sin(s) < 1e-3*s"), "sin(0.25) < 1e-3*0.25");
        assert_eq!(filled("s' = es + s(A)"), "s' = es + s(A)");
    }
}
