//! Sections of uniform bars.

use super::Section;
use super::bodies::Structure;
use super::scope::Scope;
use crate::algebra::{Rational, Series};
use crate::syntax::{SectionDeclaration, plain};

/// Resolves all sections.
pub(super) fn resolve(scope: &mut Scope, structure: &Structure) -> Vec<Section> {
    let description = scope.description;
    description.sections.iter().filter_map(|declared| section(scope, structure, declared)).collect()
}

fn section(scope: &mut Scope, structure: &Structure, declared: &SectionDeclaration) -> Option<Section> {
    let SectionDeclaration { name, bar, at: expr } = declared;
    let at = scope.number(expr);
    let body = structure.bar(scope, bar)?;
    if !structure.bodies[body].uniform {
        let text = format!(
            "a section needs a uniform bar; how the mass of `{bar}` is spread is not known from its \
             inertia and centre"
        );
        scope.report.add_message(bar.span(), text);
        return None;
    }
    let at = at?;
    if outside(scope, &at, &structure.bodies[body].length) {
        let text = format!("section `{name}` lies outside {} `{bar}`", structure.bodies[body].kind());
        scope.report.over(expr, text);
    }
    Some(Section { name: plain(name), body, at, span: name.span() })
}

/// Whether a section lies outside a bar for all parameters.
fn outside(scope: &Scope, at: &Series, length: &Series) -> bool {
    let exact = at.divide_exact(length).and_then(|ratio| ratio.as_constant()).map(Rational::to_f64);
    let numbers = || Some(scope.literal(at)? / scope.literal(length)?);
    let negative = || scope.literal(at).filter(|at| *at < 0.0);
    exact.or_else(numbers).or_else(negative).is_some_and(|ratio| !(0.0..=1.0).contains(&ratio))
}
