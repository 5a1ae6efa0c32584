//! One-sided supports. The normal of a line is a quarter turn counter-clockwise from its direction.

use syn::Expr;

use super::OneSided;
use super::bodies::Structure;
use super::circles::circle;
use super::contact_law::{Contacts, friction, moving, restitution};
use super::edges;
use super::figure::Figure;
use super::mass_properties::positive;
use super::scope::Scope;
use super::sides::{free_side, side};
use crate::algebra::{Angle, Rational, Series};
use crate::syntax::{Facing, Pair, ShapeDeclaration, SupportDeclaration};

/// Resolves all supports.
pub(super) fn resolve(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Option<Figure>,
    contacts: &mut Contacts,
) {
    let description = scope.description;
    for declared in &description.supports {
        let help = format!("give one another name: `other = …, under = {}`", declared.name);
        let names = declared.names();
        for name in &names {
            contacts.claim(scope, "support", &declared.name, name.clone(), &help);
        }
        let contact_law = (&declared.contact_law, restitution(scope, &declared.name, &declared.contact_law));
        let law = declared.contact_law.friction.as_ref();
        let surface = (friction(scope, structure, &declared.name, law), moving(scope, structure, declared));
        let constraints = one_sided(scope, structure, figure, declared);
        for (k, (name, contact)) in names.into_iter().zip(constraints).enumerate() {
            let (friction, moving) = surface.clone();
            let reversed = is_reversed(&declared.shape, k, &contact);
            let moving = moving.map(|velocity| if reversed { velocity.negated() } else { velocity });
            let disc = contact.point().and_then(|point| structure.disc(point)).cloned();
            contacts.push(&declared.name, name, (contact, disc), contact_law.clone(), (friction, moving));
        }
    }
}

/// Whether a line's direction is against that in which its surface is said to move: upwards on a
/// wall, along its angle in a slot.
fn is_reversed(shape: &ShapeDeclaration, k: usize, contact: &OneSided) -> bool {
    match (shape, contact) {
        (ShapeDeclaration::Wall(_), OneSided::Line { direction, .. }) => *direction == Angle::quarters(3),
        (ShapeDeclaration::Slot(..), _) => k == 1,
        _ => false,
    }
}

/// The constraints of a support, as many as it has names; none if it is not understood.
fn one_sided(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Option<Figure>,
    declared: &SupportDeclaration,
) -> Vec<OneSided> {
    if let ShapeDeclaration::Corner(at) = &declared.shape {
        return corner(scope, structure, figure, declared, at).into_iter().collect();
    }
    match &declared.shape {
        ShapeDeclaration::Bar(_) | ShapeDeclaration::Edge(_) => {
            return edges::support(scope, structure, figure, declared).into_iter().collect();
        }
        ShapeDeclaration::Circle(..) | ShapeDeclaration::Bowl(..) | ShapeDeclaration::Disc(_) => {
            return circle(scope, structure, figure, declared).into_iter().collect();
        }
        _ => {}
    }
    let point = structure.moving(scope, declared.under.as_ref().unwrap_or(&declared.name));
    let why = format!("support `{}` is under it", declared.name);
    let given = figure
        .as_mut()
        .zip(point)
        .is_some_and(|(figure, point)| figure.demand(scope, structure, point, &why));
    let known = figure.as_mut().zip(point).filter(|_| given);
    let contacts = match &declared.shape {
        ShapeDeclaration::Slot(angle, through, width) => {
            slot(scope, point, declared, (angle, through, width))
        }
        _ => line(scope, structure, known, declared)
            .zip(point)
            .map(|((through, direction), point)| vec![OneSided::Line { point, through, direction }]),
    };
    contacts.unwrap_or_default()
}

fn corner(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Option<Figure>,
    declared: &SupportDeclaration,
    at: &Pair,
) -> Option<OneSided> {
    let at = scope.position(at);
    let at = scope.report.keep(at);
    let name = declared.under.as_ref().or(declared.over.as_ref())?;
    let body = structure.body(scope, name)?;
    if !structure.is_bar(body) {
        let text = format!(
            "`{name}` is no bar; a corner under a side of a body is a fixed point at it: \
             `#[ground(P = (x, y))] #[support(P = edge(A, B))]`"
        );
        scope.report.add_message(name.span(), text);
        return None;
    }
    let side = side(scope, structure, figure.as_mut()?, declared, body)?;
    Some(OneSided::Corner { body, at: at?, side })
}

/// Two lines, each half the width from the middle: the lower free upwards, to the left of the
/// slot's direction.
fn slot(
    scope: &mut Scope,
    point: Option<usize>,
    declared: &SupportDeclaration,
    (angle, through, width): (&Expr, &Pair, &Expr),
) -> Option<Vec<OneSided>> {
    let (angle, through) = (scope.angle(angle), scope.position(through));
    let (angle, through) = (scope.report.keep(angle), scope.report.keep(through));
    let width = positive(scope, "the width", &declared.name, width);
    let (angle, [x, y], half) = (angle?, through?, width?.scale(Rational::HALF));
    let point = point?;
    let times = |x: &Series| scope.constants.multiply(&half, x);
    let [right, up] = [times(&Series::sin(&angle)), times(&Series::cos(&angle))];
    let opposite = &angle + &Angle::quarters(2);
    Some(vec![
        OneSided::Line { point, through: [&x + &right, &y - &up], direction: angle },
        OneSided::Line { point, through: [&x - &right, &y + &up], direction: opposite },
    ])
}

fn line(
    scope: &mut Scope,
    structure: &Structure,
    known: Option<(&mut Figure, usize)>,
    declared: &SupportDeclaration,
) -> Option<([Series; 2], Angle)> {
    match &declared.shape {
        ShapeDeclaration::Corner(_)
        | ShapeDeclaration::Circle(..)
        | ShapeDeclaration::Bowl(..)
        | ShapeDeclaration::Slot(..)
        | ShapeDeclaration::Bar(_)
        | ShapeDeclaration::Edge(_)
        | ShapeDeclaration::Disc(_) => None,
        ShapeDeclaration::Floor(height) => {
            let height = height.as_ref().map_or_else(|| Some(Series::zero()), |h| scope.number(h))?;
            Some(([Series::zero(), height], Angle::zero()))
        }
        ShapeDeclaration::Wall(x) => {
            let x = scope.number(x)?;
            let facing = match (declared.facing, known) {
                (Some(facing), _) => facing,
                (None, Some((figure, point))) => free_side(scope, structure, figure, declared, (point, &x))?,
                (None, None) => return None,
            };
            let quarters = if facing == Facing::Right { 3 } else { 1 };
            Some(([x, Series::zero()], Angle::quarters(quarters)))
        }
        ShapeDeclaration::Slope(angle, through) => {
            let angle = scope.angle(angle);
            let through =
                through.as_ref().map_or_else(|| Ok([Series::zero(), Series::zero()]), |p| scope.position(p));
            let (angle, through) = (scope.report.keep(angle), scope.report.keep(through));
            Some((through?, angle?))
        }
    }
}
