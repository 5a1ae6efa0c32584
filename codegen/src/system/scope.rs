//! What names stand for while a description is resolved, and the mistakes met on the way.

use std::collections::{BTreeMap, BTreeSet};

use quote::ToTokens;
use syn::{Expr, Ident};

use super::Switch;
use super::constants::Constants;
use super::signals::Signal;
use super::value::ParameterValues;
use crate::algebra::{Series, Symbol};
use crate::syntax::{self, Description, Report, identifiers, nearest, plain, unknown};

/// Names of parameters and constants, and which of them were used.
pub(super) struct Scope<'a> {
    /// What is resolved.
    pub description: &'a Description,
    /// Derived constants.
    pub constants: Constants,
    /// Mistakes.
    pub report: Report,
    /// Whether it is understood what belongs to what, so that it can be told what does not.
    pub joined: bool,
    /// Whether it is understood where things are, too, so that the figure can be judged.
    pub placed: bool,
    /// What springs and loads act by that do not always.
    pub switches: Vec<Switch>,
    /// Expressions that loads and drives follow.
    pub signals: Vec<Signal>,
    used: BTreeSet<String>,
    named: BTreeMap<String, Series>,
}

/// So many generic samples are tried: enough for a figure that one in a hundred of them can draw.
const TRIED: usize = 512;

/// Attributes that join points.
const JOINING: [&str; 7] = ["bar", "chain", "body", "particle", "point", "pin", "ground"];

impl<'a> Scope<'a> {
    /// The parameters, then the named constants in the order declared.
    pub fn new(description: &'a Description) -> Self {
        let mut scope = Self {
            description,
            constants: Constants::after(description.fields.len()),
            report: description.report.clone(),
            joined: !description.broken.iter().any(|kind| JOINING.contains(kind)),
            placed: !description.broken.contains(&"figure"),
            switches: Vec::new(),
            signals: Vec::new(),
            used: BTreeSet::new(),
            named: BTreeMap::new(),
        };
        for (name, value) in &description.constants {
            let value = scope.number(value).unwrap_or_else(Series::one);
            scope.named.insert(plain(name), value);
        }
        scope
    }

    /// The value of a name.
    pub fn named(&mut self, name: &Ident) -> syn::Result<Series> {
        let text = plain(name);
        self.used.insert(text.clone());
        let fields = &self.description.fields;
        if let Some(i) = fields.iter().position(|field| field == name) {
            return Ok(Series::symbol(Symbol::parameter(i)));
        }
        match self.named.get(&text) {
            Some(value) => Ok(value.clone()),
            None if name == "pi" => Ok(Series::symbol(self.constants.pi())),
            None => Err(self.unknown(name)),
        }
    }

    /// Whether a name stands for a number.
    pub fn knows(&self, name: &Ident) -> bool {
        let named = |fields: &[Ident]| fields.iter().any(|field| field == name);
        name == "pi" || named(&self.description.fields) || self.named.contains_key(&plain(name))
    }

    /// Notes a signal, once.
    pub fn note(&mut self, signal: Option<Signal>) {
        let known = |signal: &Signal| self.signals.contains(signal);
        self.signals.extend(signal.filter(|signal| !known(signal)));
    }

    /// The names of parameters and constants.
    pub fn names(&self) -> Vec<String> {
        let fields = self.description.fields.iter().map(plain);
        fields.chain(self.named.keys().cloned()).collect()
    }

    /// What was meant counts as used, so that one misspelt name gives one message.
    pub fn mistaken(&mut self, name: &Ident, known: &[String]) {
        let known: Vec<&str> = known.iter().map(String::as_str).collect();
        self.used.extend(nearest(&plain(name), &known).map(String::from));
    }

    fn unknown(&mut self, name: &Ident) -> syn::Error {
        let known = self.names();
        self.mistaken(name, &known);
        let text = unknown("parameter", name, known.iter().map(String::as_str));
        syn::Error::new(name.span(), format!("{text} (a parameter is an `f64` field of the struct)"))
    }

    /// What a condition of the runtime names counts as used.
    pub fn use_words(&mut self, condition: &str) {
        let words = condition.split(|c: char| !c.is_alphanumeric() && c != '_');
        self.used.extend(words.map(str::to_owned));
    }

    /// What an expression names counts as used, although the expression is not understood.
    pub fn mention(&mut self, tokens: &impl ToTokens) {
        self.used.extend(identifiers(tokens));
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
        let text = plain(name);
        let found = known.clone().position(|other| text == other);
        if found.is_none() {
            self.unknown_at(name, unknown(kind, name, known));
        }
        found
    }

    /// Reports an unknown name, unless a malformed attribute may have declared it.
    pub fn unknown_at(&mut self, name: &Ident, text: String) {
        if !self.description.malformed.contains(&plain(name)) {
            self.report.add_message(name.span(), text);
        }
    }

    /// The switch of what acts on a condition; one for all that act on the same.
    pub fn switch(&mut self, label: &str, armed: Option<&syntax::SwitchDeclaration>) -> Option<usize> {
        let condition = &armed?.condition;
        self.use_words(condition);
        Some(self.switch_on(label, condition))
    }

    /// The switch of a condition that something with this label has.
    pub fn switch_on(&mut self, label: &str, condition: &str) -> usize {
        let known = self.switches.iter().position(|switch| switch.condition == condition);
        match known.map(|i| (i, &mut self.switches[i].label)) {
            Some((i, labels)) => {
                if labels.split(", ").all(|known| known != label) {
                    *labels += &format!(", {label}");
                }
                i
            }
            None => {
                self.switches.push(Switch { label: label.to_owned(), condition: condition.to_owned() });
                self.switches.len() - 1
            }
        }
    }

    /// Reports parameters and constants that nothing uses; not while an attribute is not
    /// understood.
    pub fn check_used(&mut self) {
        if !self.description.broken.is_empty() {
            return;
        }
        let fields = &self.description.fields;
        let constants = self.description.constants.iter().map(|(name, _)| name);
        let constants = constants.filter(|name| !fields.contains(name));
        let parameters = fields.iter().map(|name| ("parameter", name));
        for (kind, name) in parameters.chain(constants.map(|name| ("constant", name))) {
            if !self.used.contains(&plain(name)) {
                let text = format!("{kind} `{name}` is used nowhere; use it or remove it");
                self.report.add_message(name.span(), text);
            }
        }
    }

    /// The first values of the figure.
    pub fn nominal(&self) -> ParameterValues {
        self.of_figure().next().unwrap_or_else(|| self.ones())
    }

    /// Values at a few generic parameters: what agrees there is taken to agree identically.
    pub fn samples(&self) -> Vec<ParameterValues> {
        self.generic().take(3).collect()
    }

    /// Values with every parameter 1, then at generic parameters, where every constant is a number.
    pub fn candidates(&self) -> impl Iterator<Item = ParameterValues> + '_ {
        core::iter::once(self.ones()).filter(ParameterValues::are_finite).chain(self.generic())
    }

    /// Values with every parameter 1.
    pub fn ones(&self) -> ParameterValues {
        self.numbers(&self.all_one())
    }

    /// Values with which the figure may be drawn: those that parameters have by default, others as
    /// in [`Self::candidates`].
    pub fn of_figure(&self) -> impl Iterator<Item = ParameterValues> + '_ {
        let defaults: Vec<Option<f64>> = self.description.values.iter().map(|known| known.value).collect();
        // Without a free parameter all samples are one.
        let count = if defaults.iter().all(Option::is_some) { 1 } else { TRIED + 1 };
        let with_defaults = move |free: Vec<f64>| -> Vec<f64> {
            free.iter().zip(&defaults).map(|(free, default)| default.unwrap_or(*free)).collect()
        };
        let values = (0..count).map(|k| k.checked_sub(1).map_or(self.all_one(), |k| self.generic_values(k)));
        values.map(with_defaults).map(|values| self.numbers(&values)).filter(ParameterValues::are_finite)
    }

    fn generic(&self) -> impl Iterator<Item = ParameterValues> + '_ {
        (0..TRIED).map(|k| self.numbers(&self.generic_values(k))).filter(ParameterValues::are_finite)
    }

    fn numbers(&self, parameters: &[f64]) -> ParameterValues {
        ParameterValues::new(parameters, self.constants.definitions())
    }

    fn all_one(&self) -> Vec<f64> {
        vec![1.0; self.description.fields.len()]
    }

    /// First near 1, then up to 4 and 20 times as large and as small.
    fn generic_values(&self, k: usize) -> Vec<f64> {
        let parameter = |i: usize| {
            let x = (1.7 * ((i + 1) * (2 * k + 1)) as f64).sin();
            match k % 3 {
                _ if k < 3 => 1.0 + 0.37 * x,
                0 => (0.4 * x).exp(),
                1 => (1.4 * x).exp(),
                _ => (3.0 * x).exp(),
            }
        };
        (0..self.description.fields.len()).map(parameter).collect()
    }
}
