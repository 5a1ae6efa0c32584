//! Supports and threads with their names and manners.

use syn::{Expr, Ident};

use super::bodies::Structure;
use super::formula::Readable;
use super::scope::Scope;
use super::{Disc, Drive, Formula, Friction, Law, OneSided, Support};
use crate::algebra::{Rational, Series};
use crate::syntax::{
    ContactLaw, DriveDeclaration, FrictionLaw, SupportDeclaration, SwitchDeclaration, plain,
};

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
            scope.report.add_message(written.span(), format!("{kind} `{name}` is declared twice; {help}"));
        }
        self.names.push(name);
    }

    /// Adds a guide with friction, which holds both ways.
    pub fn guide(&mut self, written: &Ident, contact: OneSided, friction: Friction) {
        self.resolved.push(Support {
            name: plain(written),
            span: written.span(),
            contact,
            disc: None,
            two_sided: true,
            rough: false,
            friction: Some(friction),
            moving: None,
            restitution: None,
            law: Law::Newton,
            stop: false,
            armed: None,
            breaks: None,
        });
    }

    /// Adds a drive on a condition, which holds both ways; its index.
    pub fn drive(&mut self, drive: &Drive, index: usize, declared: &DriveDeclaration) {
        self.resolved.push(Support {
            name: format!("drive {}", drive.name),
            span: drive.span,
            contact: OneSided::Drive(index),
            disc: None,
            two_sided: false,
            rough: false,
            friction: None,
            moving: None,
            restitution: None,
            law: Law::Newton,
            stop: false,
            armed: condition(declared.armed.as_ref()),
            breaks: condition(declared.breaks.as_ref()),
        });
    }

    /// All of them. Guides are closed in every set, and sets are counted by their first contacts.
    pub fn guides_first(mut self) -> Vec<Support> {
        self.resolved.sort_by_key(|support| !support.two_sided);
        self.resolved
    }

    /// Adds a constraint.
    pub fn push(
        &mut self,
        written: &Ident,
        name: String,
        (contact, disc): (OneSided, Option<Disc>),
        (contact_law, restitution): (&ContactLaw, Option<Series>),
        (friction, moving): (Option<Friction>, Option<Formula>),
    ) {
        self.resolved.push(Support {
            name,
            span: written.span(),
            contact,
            disc,
            two_sided: false,
            rough: contact_law.rough,
            friction,
            moving,
            restitution,
            law: contact_law.law,
            stop: contact_law.stop,
            armed: condition(contact_law.armed.as_ref()),
            breaks: condition(contact_law.breaks.as_ref()),
        });
    }
}

fn condition(declared: Option<&SwitchDeclaration>) -> Option<String> {
    declared.map(|switch| switch.condition.clone())
}

/// The restitution of `owner`; that a literal lies outside [0, 1] is reported. What the condition
/// that it is there on names counts as used.
pub(super) fn restitution(scope: &mut Scope, owner: &Ident, contact_law: &ContactLaw) -> Option<Series> {
    let conditions = contact_law.armed.iter().chain(&contact_law.breaks);
    conditions.for_each(|switch| scope.use_words(&switch.condition));
    coefficient(scope, "restitution", owner, contact_law.restitution.as_ref()?)
}

fn coefficient(scope: &mut Scope, what: &str, owner: &Ident, expr: &Expr) -> Option<Series> {
    let value = scope.number(expr)?;
    let outside = |e: &Rational| e.signum() < 0 || (*e - Rational::ONE).signum() > 0;
    if let Some(e) = value.as_constant().filter(outside) {
        let text = format!("the {what} of `{owner}` is {e}; it must lie between 0 and 1");
        scope.report.over(expr, text);
    }
    Some(value)
}

/// The friction of a support or a slider; literals that no friction has are reported.
pub(super) fn friction(
    scope: &mut Scope,
    structure: &Structure,
    owner: &Ident,
    law: Option<&FrictionLaw>,
) -> Option<Friction> {
    let law = law?;
    let readable = Readable { structure, coordinates: &[] };
    let kinetic = readable.of_slip(scope, &law.kinetic);
    let limit = law.limit.as_ref().map(|limit| scope.number(limit));
    let kinetic = kinetic?;
    let limit = match limit {
        Some(limit) => limit?,
        None => at_rest(scope, &kinetic)?,
    };
    let known = |series: &Series| series.as_constant();
    let sliding = if let Formula::Constant(series) = &kinetic { known(series) } else { None };
    let negative = |mu: &Rational| mu.signum() < 0;
    if let Some(mu) = sliding.filter(negative) {
        let text = format!("the friction of `{owner}` is {mu}; a coefficient of friction is not negative");
        scope.report.over(&law.kinetic, text);
    }
    if let Some((expr, (mu, limit))) = law.limit.as_ref().zip(sliding.zip(known(&limit)))
        && (limit - mu).signum() < 0
    {
        let text = format!(
            "static friction {limit} of `{owner}` is below sliding friction {mu}; it must be at least as large"
        );
        scope.report.over(expr, text);
    }
    let tangential = law.tangential.as_ref();
    let tangential = tangential.and_then(|e| coefficient(scope, "tangential restitution", owner, e));
    Some(Friction { kinetic, limit, tangential, jams: law.jams })
}

/// A friction at v = 0.
fn at_rest(scope: &mut Scope, formula: &Formula) -> Option<Series> {
    fn folded(scope: &mut Scope, formula: &Formula) -> Result<Formula, &'static str> {
        match formula {
            Formula::Slip => Ok(Formula::Constant(Series::zero())),
            Formula::Apply(function, inner) => {
                let inner = folded(scope, inner)?;
                scope.applied(*function, inner)
            }
            Formula::Join(operator, a, b) => {
                let (a, b) = (folded(scope, a)?, folded(scope, b)?);
                scope.joined_by(*operator, a, b)
            }
            other => Ok(other.clone()),
        }
    }
    match folded(scope, formula) {
        Ok(Formula::Constant(series)) => Some(series),
        _ => None,
    }
}

/// The velocity of a support's surface.
pub(super) fn moving(
    scope: &mut Scope,
    structure: &Structure,
    declared: &SupportDeclaration,
) -> Option<Formula> {
    let why = "the velocity of a surface is a function of time: it may contain `t` and parameters, no motion";
    let readable = Readable { structure, coordinates: &[] };
    readable.prescribed(scope, declared.moving.as_ref()?, why)
}
