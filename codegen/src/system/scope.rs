//! What names stand for while a description is resolved, and the mistakes met on the way.

use proc_macro2::Span;
use std::collections::BTreeMap;
use syn::{Expr, Ident};

use super::constants::Constants;
use super::value::Numbers;
use crate::algebra::{Series, Symbol};
use crate::syntax::{Description, Report, nearest, unknown};

/// Names of parameters and constants, and which of them were used.
pub(super) struct Scope<'a> {
    /// What is resolved.
    pub description: &'a Description,
    /// Derived constants.
    pub constants: Constants,
    /// Mistakes.
    pub report: Report,
    /// Whether bars, points, pins and figure are all understood, so that what follows from them can be judged.
    pub sound: bool,
    used: Vec<bool>,
    named: BTreeMap<String, (Series, bool)>,
}

/// Attributes that place points.
const PLACING: [&str; 5] = ["bar", "chain", "point", "pin", "figure"];

impl<'a> Scope<'a> {
    /// The parameters, then the named constants in the order declared.
    pub fn new(description: &'a Description) -> Self {
        let parameters = description.fields.len();
        let mut scope = Self {
            description,
            constants: Constants::after(parameters),
            report: description.report.clone(),
            sound: !description.broken.iter().any(|kind| PLACING.contains(kind)),
            used: vec![false; parameters],
            named: BTreeMap::new(),
        };
        for (name, value) in &description.constants {
            let value = scope.number(value).unwrap_or_else(Series::one);
            scope.named.insert(name.to_string(), (value, false));
        }
        scope
    }

    /// The value of a name.
    pub fn named(&mut self, name: &Ident) -> syn::Result<Series> {
        if let Some(i) = self
            .description
            .fields
            .iter()
            .position(|field| field == name)
        {
            self.used[i] = true;
            return Ok(Series::symbol(Symbol::parameter(i)));
        }
        if let Some((value, used)) = self.named.get_mut(&name.to_string()) {
            *used = true;
            return Ok(value.clone());
        }
        if name == "pi" {
            return Ok(Series::symbol(self.constants.pi()));
        }
        let fields: Vec<String> = self
            .description
            .fields
            .iter()
            .map(Ident::to_string)
            .collect();
        let known: Vec<&str> = fields
            .iter()
            .chain(self.named.keys())
            .map(String::as_str)
            .collect();
        let text = unknown("parameter", name, known.iter().copied());
        if let Some(i) = nearest(&name.to_string(), &known)
            .and_then(|meant| fields.iter().position(|f| f == meant))
        {
            self.used[i] = true;
        }
        Err(syn::Error::new(
            name.span(),
            format!("{text} (a parameter is an `f64` field of the struct)"),
        ))
    }

    /// The value of an expression, or its mistakes are kept.
    pub fn number(&mut self, expr: &Expr) -> Option<Series> {
        let value = self.value(expr);
        self.report.keep(value)
    }

    /// The index of a name among those known, or the mistake is kept.
    pub fn find<'n>(
        &mut self,
        kind: &str,
        name: &Ident,
        known: impl Iterator<Item = &'n str> + Clone,
    ) -> Option<usize> {
        let found = known.clone().position(|other| name == other);
        if found.is_none() && !self.description.malformed.contains(&name.to_string()) {
            self.report.at(name.span(), unknown(kind, name, known));
        }
        found
    }

    /// Reports parameters and constants that nothing uses; not while an attribute is not understood.
    pub fn check_used(&mut self) {
        if !self.description.broken.is_empty() {
            return;
        }
        let fields = self
            .description
            .fields
            .iter()
            .zip(&self.used)
            .map(|(name, used)| ("parameter", name, *used));
        let constants = self.description.constants.iter().map(|(name, _)| {
            (
                "constant",
                name,
                self.named
                    .get(&name.to_string())
                    .is_none_or(|(_, used)| *used),
            )
        });
        let unused: Vec<(Span, String)> = fields
            .chain(constants)
            .filter(|(_, _, used)| !used)
            .map(|(kind, name, _)| {
                (
                    name.span(),
                    format!("{kind} `{name}` is used nowhere; use it or remove it"),
                )
            })
            .collect();
        unused
            .into_iter()
            .for_each(|(span, text)| self.report.at(span, text));
    }

    /// Values with every parameter 1.
    pub fn nominal(&self) -> Numbers {
        Numbers::new(&vec![1.0; self.used.len()], self.constants.definitions())
    }

    /// Values at a few generic parameters near 1: what agrees there is taken to agree identically.
    pub fn samples(&self) -> Vec<Numbers> {
        let sample = |k: usize| {
            let generic = |i: usize| 1.0 + 0.37 * (1.7 * ((i + 1) * (2 * k + 1)) as f64).sin();
            let parameters: Vec<f64> = (0..self.used.len()).map(generic).collect();
            Numbers::new(&parameters, self.constants.definitions())
        };
        (0..3).map(sample).collect()
    }
}
