//! Names that must differ, and names of parameters in texts.

use std::collections::BTreeMap;
use std::fmt::Display;

use super::constants::PI;
use super::scope::Scope;
use super::{Definition, System};
use crate::algebra::{Rational, Series, SymbolNames};
use crate::math::Math;
use crate::syntax::{Bound, plain};

/// Time, energies and momenta, which every run has under these names.
const EVERYWHERE: [&str; 7] = ["t", "T", "V", "E", "px", "py", "Lz"];

/// Reports names that stand for two things of which the same is asked or set.
pub(super) fn check(scope: &mut Scope) {
    let d = scope.description;
    let mut numbers = Namespace::default();
    numbers.known.extend(EVERYWHERE.iter().map(|name| ((*name).to_owned(), "quantity of every run")));
    numbers.claim(scope, "parameter", &d.fields);
    numbers.claim(scope, "constant", d.constants.iter().map(|(name, _)| name));
    numbers.claim(scope, "coordinate", d.coordinates.iter().map(|c| &c.name));
    let supports = d.supports.iter().map(|support| ("support", &support.name));
    let threads = d.threads.iter().map(|thread| ("thread", &thread.name));
    for (kind, name) in supports.chain(threads) {
        if d.coordinates.iter().any(|c| c.name == *name) {
            scope.report.add_message(name.span(), collision(kind, "coordinate", name));
        }
    }
    for limit in &d.limits {
        for Bound { name, .. } in
            limit.bounds().filter(|bound| d.coordinates.iter().any(|c| c.name == bound.name))
        {
            scope.report.add_message(limit.name.span(), collision("limit", "coordinate", &name));
        }
    }
    Namespace::default().claim(scope, "slider", d.sliders.iter().map(|slider| &slider.name));
    Namespace::default().claim(scope, "spring", d.springs.iter().map(|spring| &spring.name));
    Namespace::default().claim(scope, "section", d.sections.iter().map(|section| &section.name));
    let mut loads = Namespace::default();
    loads.claim(scope, "force", d.forces.iter().map(|force| &force.name));
    loads.claim(scope, "couple", d.couples.iter().map(|couple| &couple.name));
}

/// Names of which no two may be the same, and of what they are.
#[derive(Default)]
struct Namespace {
    known: BTreeMap<String, &'static str>,
}

impl Namespace {
    fn claim<'a>(
        &mut self,
        scope: &mut Scope,
        kind: &'static str,
        names: impl IntoIterator<Item = &'a syn::Ident>,
    ) {
        for name in names {
            let other = *self.known.get(&plain(name)).unwrap_or(&kind);
            if self.known.insert(plain(name), kind).is_some() {
                scope.report.add_message(name.span(), collision(kind, other, name));
            }
        }
    }
}

fn collision(kind: &str, other: &str, name: &dyn Display) -> String {
    match kind == other {
        true => format!("{kind} `{name}` is declared twice; rename or remove one"),
        false => format!("{kind} `{name}` has the name of a {other}; rename one"),
    }
}

/// How each parameter symbol is written: parameters by name, derived constants by definition.
#[derive(Clone, Debug)]
pub struct ParameterNames(Vec<Math>);

impl SymbolNames for ParameterNames {
    fn parameter(&self, index: u16) -> Math {
        self.0.get(usize::from(index)).cloned().unwrap_or(Math::ONE)
    }

    fn coordinate(&self, index: u16) -> String {
        format!("q{index}")
    }

    fn reaction(&self, index: u16) -> Math {
        Math::symbol(&format!("lambda{index}"))
    }
}

impl System {
    /// Names of the parameters and derived constants.
    pub fn names(&self) -> ParameterNames {
        ParameterNames::new(&self.parameters, &self.constants)
    }
}

impl ParameterNames {
    /// Names of parameters, then of derived constants.
    pub(super) fn new(parameters: &[syn::Ident], constants: &[Definition]) -> Self {
        let mut names = Self(parameters.iter().map(|name| Math::symbol(&plain(name))).collect());
        for constant in constants {
            let written = names.definition(constant);
            names.0.push(written);
        }
        names
    }

    fn definition(&self, constant: &Definition) -> Math {
        let written = |series: &Series| series.math(self);
        match constant {
            definition if definition.is_pi() => Math::symbol("pi"),
            Definition::Sqrt(a) => Math::Root(Box::new(written(a))),
            Definition::Ratio(a, b) if b.as_constant() == Some(Rational::ONE) => written(a).group(),
            Definition::Ratio(a, b) => written(a).over(written(b)),
        }
    }
}

impl Definition {
    /// Whether it stands for π.
    pub fn is_pi(&self) -> bool {
        let Self::Ratio(numerator, denominator) = self else { return false };
        [numerator, denominator].map(Series::as_constant)
            == [PI.0, PI.1].map(|part| Some(Rational::integer(part)))
    }
}
