//! Mass, length, inertia and centre of mass. A uniform bar has its centre at l/2 and I = m l²/12
//! about it.

use syn::{Expr, Ident};

use super::scope::Scope;
use crate::algebra::{Rational, Series};
use crate::syntax::MassProperties;

/// The values of a bar's mass properties.
#[derive(Clone)]
pub(super) struct MassValues {
    pub mass: Series,
    pub length: Series,
    /// Distances of the first point from those after the second.
    pub extents: Vec<Series>,
    pub inertia: Series,
    pub centre: [Series; 2],
}

impl MassValues {
    /// Evaluates and checks the mass properties of `owner`.
    pub fn evaluate(scope: &mut Scope, mass_properties: &MassProperties, owner: &Ident) -> Self {
        let mass = scope.number(&mass_properties.mass);
        not_negative(scope, "the mass", owner, &mass_properties.mass, mass.as_ref());
        let mass = mass.unwrap_or_else(Series::one);
        let length = length(scope, mass_properties, owner);
        let inertia = mass_properties.inertia.as_ref().and_then(|expr| {
            let inertia = scope.number(expr);
            not_negative(scope, "the inertia", owner, expr, inertia.as_ref());
            inertia
        });
        let square = scope.constants.multiply(&length, &length);
        let uniform = || scope.constants.multiply(&mass, &square).scale(Rational::new(1, 12));
        let inertia = inertia.unwrap_or_else(uniform);
        let centre = mass_properties.centre.as_ref().and_then(|at| along_across(scope, at));
        let middle = || [length.scale(Rational::new(1, 2)), Series::zero()];
        Self { centre: centre.unwrap_or_else(middle), mass, inertia, length, extents: Vec::new() }
    }
}

fn length(scope: &mut Scope, mass_properties: &MassProperties, owner: &Ident) -> Series {
    let length = positive(scope, "the length", owner, &mass_properties.length);
    length.unwrap_or_else(|| {
        scope.placed = false;
        Series::one()
    })
}

/// The value of an expression; that a literal is not positive is reported.
pub(super) fn positive(scope: &mut Scope, what: &str, owner: &Ident, expr: &Expr) -> Option<Series> {
    let value = scope.number(expr)?;
    match value.as_constant().filter(|c| c.signum() <= 0) {
        Some(wrong) => {
            scope.report.over(expr, format!("{what} of `{owner}` is {wrong}; it must be positive"));
            None
        }
        None => Some(value),
    }
}

/// Reports a negative literal.
pub(super) fn not_negative(
    scope: &mut Scope,
    what: &str,
    owner: &Ident,
    expr: &Expr,
    value: Option<&Series>,
) {
    if let Some(value) = value.and_then(Series::as_constant).filter(|c| c.signum() < 0) {
        scope.report.over(expr, format!("{what} of `{owner}` is {value}; it cannot be negative"));
    }
}

/// One number along a bar, or two along and across it.
pub(super) fn along_across(scope: &mut Scope, at: &[Expr]) -> Option<[Series; 2]> {
    let mut values: Vec<Option<Series>> = at.iter().map(|expr| scope.number(expr)).collect();
    let across = if values.len() > 1 { values.pop()? } else { Some(Series::zero()) };
    Some([values.pop()??, across?])
}
