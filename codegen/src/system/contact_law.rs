//! Supports and threads with their names and manners.

use syn::Ident;

use super::scope::Scope;
use super::{Law, OneSided, Support};
use crate::algebra::{Rational, Series};
use crate::syntax::ContactLaw;

/// One-sided constraints while they are resolved; no two have one name.
#[derive(Default)]
pub(super) struct Contacts {
    /// Those understood.
    pub resolved: Vec<Support>,
    names: Vec<String>,
}

impl Contacts {
    /// Claims a name; that it is taken is reported, with what helps.
    pub fn claim(&mut self, scope: &mut Scope, kind: &str, written: &Ident, name: String, help: &str) {
        if self.names.contains(&name) {
            scope.report.at(written.span(), format!("{kind} `{name}` is declared twice; {help}"));
        }
        self.names.push(name);
    }

    /// Adds a constraint.
    pub fn push(
        &mut self,
        written: &Ident,
        name: String,
        contact: OneSided,
        (contact_law, restitution): (&ContactLaw, Option<Series>),
    ) {
        self.resolved.push(Support {
            name,
            span: written.span(),
            contact,
            rough: contact_law.rough,
            restitution,
            law: if contact_law.poisson { Law::Poisson } else { Law::Newton },
            stop: contact_law.stop,
        });
    }
}

/// The restitution of `owner`; that a literal lies outside [0, 1] is reported.
pub(super) fn restitution(scope: &mut Scope, owner: &Ident, contact_law: &ContactLaw) -> Option<Series> {
    let expr = contact_law.restitution.as_ref()?;
    let value = scope.number(expr)?;
    let outside = |e: &Rational| e.signum() < 0 || (*e - Rational::ONE).signum() > 0;
    if let Some(e) = value.as_constant().filter(outside) {
        let text = format!("the restitution of `{owner}` is {e}; it must lie between 0 and 1");
        scope.report.over(expr, text);
    }
    Some(value)
}
