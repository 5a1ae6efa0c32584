//! Names that must differ, and names of parameters in texts.

use std::collections::BTreeMap;

use proc_macro2::Span;

use super::constants::PI;
use super::scope::Scope;
use super::{Definition, System};
use crate::algebra::{Names, Rational, Series};

/// Time and energies, which every run has under these names.
const EVERYWHERE: [&str; 4] = ["t", "T", "V", "E"];

/// Reports parameters, constants and coordinates (and supports) of one name.
pub(super) fn check(scope: &mut Scope) {
    let description = scope.description;
    let everywhere = EVERYWHERE.iter().map(|name| ((*name).to_owned(), "quantity of every run"));
    let mut known: BTreeMap<String, &str> = everywhere.collect();
    let mut taken = |kind: &'static str, name: &syn::Ident| -> Option<(Span, String)> {
        let other = *known.get(&name.to_string()).unwrap_or(&kind);
        let free = known.insert(name.to_string(), kind).is_none();
        (!free).then(|| (name.span(), collision(kind, other, name)))
    };
    let fields = description.fields.iter().map(|name| ("parameter", name));
    let constants = description.constants.iter().map(|(name, _)| ("constant", name));
    let coordinates = description.coordinates.iter().map(|c| ("coordinate", &c.name));
    let clashes: Vec<_> =
        fields.chain(constants).chain(coordinates).filter_map(|(kind, name)| taken(kind, name)).collect();
    clashes.into_iter().for_each(|(span, text)| scope.report.at(span, text));
    for support in &description.supports {
        if description.coordinates.iter().any(|c| c.name == support.name) {
            scope.report.at(support.name.span(), collision("support", "coordinate", &support.name));
        }
    }
}

fn collision(kind: &str, other: &str, name: &syn::Ident) -> String {
    match kind == other {
        true => format!("{kind} `{name}` is declared twice; rename or remove one"),
        false => format!("{kind} `{name}` has the name of a {other}; rename one"),
    }
}

/// What each parameter symbol is called in texts: parameters by name, derived constants by definition.
#[derive(Clone, Debug)]
pub struct ParameterNames(pub Vec<String>);

impl Names for ParameterNames {
    fn parameter(&self, index: u16) -> String {
        self.0.get(usize::from(index)).cloned().unwrap_or_default()
    }

    fn coordinate(&self, index: u16) -> String {
        format!("q{index}")
    }

    fn reaction(&self, index: u16) -> String {
        format!("λ{index}")
    }
}

impl System {
    /// Names of the parameters and derived constants.
    pub fn names(&self) -> ParameterNames {
        ParameterNames::of(&self.parameters, &self.constants)
    }
}

impl ParameterNames {
    /// Names of parameters, then of derived constants.
    pub(super) fn of(parameters: &[syn::Ident], constants: &[Definition]) -> Self {
        let mut names = Self(parameters.iter().map(ToString::to_string).collect());
        for constant in constants {
            let text = names.definition(constant);
            names.0.push(text);
        }
        names
    }

    fn definition(&self, constant: &Definition) -> String {
        let text = |series: &Series| series.text(self);
        match constant {
            Definition::Sqrt(a) => format!("√({})", text(a)),
            Definition::Ratio(a, b) if is_pi(a, b) => "π".into(),
            Definition::Ratio(a, b) if b.as_constant() == Some(Rational::ONE) => {
                format!("({})", text(a))
            }
            Definition::Ratio(a, b) => format!("({})/({})", text(a), text(b)),
        }
    }
}

fn is_pi(numerator: &Series, denominator: &Series) -> bool {
    [numerator, denominator].map(Series::as_constant)
        == [PI.0, PI.1].map(|part| Some(Rational::integer(part)))
}
