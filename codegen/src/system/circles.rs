//! Circles, bowls and discs as supports; their centres are places of the ground, or points.

use syn::Ident;

use super::bodies::Structure;
use super::figure::Figure;
use super::mass_properties::positive;
use super::scope::Scope;
use super::sides::on_its_side;
use super::threads::nothing_moves;
use super::{Centre, OneSided};
use crate::algebra::Series;
use crate::syntax::{self, ShapeDeclaration, SupportDeclaration, plain};

/// A circle, and whether what it carries is inside.
struct DeclaredCircle {
    centre: Centre,
    radius: Series,
    inside: bool,
}

/// The support by a circle; none if it is not understood.
pub(super) fn circle(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Option<Figure>,
    declared: &SupportDeclaration,
) -> Option<OneSided> {
    let name = declared.under.as_ref().unwrap_or(&declared.name);
    if structure.is_body(name) {
        scope.report.add_message(name.span(), under_a_bar(&declared.shape, name));
        return None;
    }
    let ring = ring(scope, structure, declared);
    let point = match ring.as_ref().map(|ring| &ring.centre) {
        Some(Centre::Point { .. }) => structure.point(scope, name),
        _ => structure.moving(scope, name),
    };
    let (DeclaredCircle { centre, radius, inside }, point) = (ring?, point?);
    if let Centre::Point { point: centre, .. } = centre
        && (centre == point || structure.rigid(centre, point))
    {
        let other: Ident = syn::parse_str(&structure.points[centre].name).ok()?;
        scope.report.add_message(declared.span, nothing_moves("support", &declared.name, [name, &other]));
        return None;
    }
    let reach = reach(scope, structure, declared, (point, &radius), inside)?;
    let at = find_positions(scope, structure, figure.as_mut()?, declared, (point, &centre));
    if let Some([place, at]) = at {
        on_its_side(scope, &place, (&at, &reach), inside, declared.span);
    }
    Some(OneSided::Circle { point, centre, radius, reach, inside })
}

/// What is said of a circle that carries a bar along its length.
fn under_a_bar(shape: &ShapeDeclaration, bar: &Ident) -> String {
    let centre = match shape {
        ShapeDeclaration::Circle(syntax::CentreDeclaration::Point(centre), _)
        | ShapeDeclaration::Disc(centre) => centre.to_string(),
        ShapeDeclaration::Bowl(..) => {
            return format!("`{bar}` is not a point; name the points of it that the bowl keeps inside");
        }
        _ => "O".to_owned(),
    };
    let place = if centre == "O" { "`#[ground(O = (x, y))] " } else { "`" };
    format!(
        "`{bar}` is no point; a bar lies on a cylinder as the cylinder's disc on a side of the bar: \
         {place}#[disc({centre}, radius = r)] #[support({centre} = bar({bar}))]`"
    )
}

fn ring(scope: &mut Scope, structure: &Structure, declared: &SupportDeclaration) -> Option<DeclaredCircle> {
    let (centre, radius, inside) = match &declared.shape {
        ShapeDeclaration::Circle(centre, radius) => (centre, radius, false),
        ShapeDeclaration::Bowl(centre, radius) => (centre, radius, true),
        ShapeDeclaration::Disc(centre) => return disc(scope, structure, centre),
        _ => return None,
    };
    let centre = match centre {
        syntax::CentreDeclaration::Ground(at) => {
            let at = scope.position(at);
            scope.report.keep(at).map(Centre::Ground)
        }
        syntax::CentreDeclaration::Point(name) => about(scope, structure, declared, name),
    };
    let radius = positive(scope, "the radius", &declared.name, radius);
    Some(DeclaredCircle { centre: centre?, radius: radius?, inside })
}

fn disc(scope: &mut Scope, structure: &Structure, name: &Ident) -> Option<DeclaredCircle> {
    let point = structure.point(scope, name)?;
    if let Some(disc) = structure.disc(point) {
        let centre = Centre::Point { point, body: disc.body };
        return Some(DeclaredCircle { centre, radius: disc.radius.clone(), inside: false });
    }
    if !scope.description.malformed.contains(&plain(name)) {
        let text = format!(
            "there is no disc about `{name}`; add `#[disc({name}, radius = r)]`, or write `circle({name}, r)`"
        );
        scope.report.add_message(name.span(), text);
    }
    None
}

/// A circle about a point turns with the body of the point.
fn about(
    scope: &mut Scope,
    structure: &Structure,
    declared: &SupportDeclaration,
    name: &Ident,
) -> Option<Centre> {
    let point = structure.point(scope, name)?;
    let on = &structure.points[point].on;
    let law = &declared.contact_law;
    if on.len() > 1 && (law.rough || law.friction.is_some()) {
        let text = format!(
            "`{name}` is a point of several bodies, and where there is friction it matters with which the circle turns; name \
             a point of that body alone: `#[point(C = {}, at = …)]`",
            structure.bodies[on[0].0].name
        );
        scope.report.add_message(name.span(), text);
        return None;
    }
    let body = if let [(body, _)] = &on[..] { Some(*body) } else { None };
    Some(Centre::Point { point, body })
}

/// The distance of the centres where they touch.
fn reach(
    scope: &mut Scope,
    structure: &Structure,
    declared: &SupportDeclaration,
    (point, radius): (usize, &Series),
    inside: bool,
) -> Option<Series> {
    let Some(disc) = structure.disc(point) else { return Some(radius.clone()) };
    let reach = if inside { radius - &disc.radius } else { radius + &disc.radius };
    if reach.as_constant().is_some_and(|reach| reach.signum() <= 0) {
        let text = format!("the disc about `{}` has no room in this bowl", structure.points[point].name);
        scope.report.add_message(declared.span, text);
        return None;
    }
    Some(reach)
}

/// Where the figure has the point and the centre, if both are given.
fn find_positions(
    scope: &mut Scope,
    structure: &Structure,
    figure: &mut Figure,
    declared: &SupportDeclaration,
    (point, centre): (usize, &Centre),
) -> Option<[[Series; 2]; 2]> {
    let why = format!("support `{}` is under it", declared.name);
    let given = figure.demand(scope, structure, point, &why);
    let at = match centre {
        Centre::Ground(at) => at.clone(),
        Centre::Point { point, .. } => {
            let known =
                figure.demand(scope, structure, *point, &format!("support `{}` is there", declared.name));
            known.then(|| figure.positions[*point].clone())?
        }
    };
    given.then(|| [figure.positions[point].clone(), at])
}
