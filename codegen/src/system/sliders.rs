//! Points kept on guides, two-sided.

use syn::Ident;

use super::bodies::Structure;
use super::contact_law::{Contacts, friction, restitution};
use super::mass_properties::positive;
use super::scope::Scope;
use super::{Centre, Edge, Guide, OneSided, Slider};
use crate::algebra::{Angle, Series};
use crate::syntax::{SliderDeclaration, Track, plain};

/// Resolves all sliders; those with friction are contacts too.
pub(super) fn resolve(scope: &mut Scope, structure: &Structure, contacts: &mut Contacts) -> Vec<Slider> {
    let description = scope.description;
    let sliders = description.sliders.iter().filter_map(|declared| {
        let slider = slider(scope, structure, declared);
        rub(scope, structure, contacts, declared, slider.as_ref());
        slider
    });
    sliders.collect()
}

/// The contact that a guide with friction is.
fn rub(
    scope: &mut Scope,
    structure: &Structure,
    contacts: &mut Contacts,
    declared: &SliderDeclaration,
    slider: Option<&Slider>,
) {
    let name = &declared.name;
    let friction = friction(scope, structure, name, declared.friction.as_ref());
    if let (Some(law), true) = (&declared.friction, scope.description.mirror.is_some()) {
        let text = format!(
            "in a mirrored model guides are smooth: how the friction of `{name}` and that of its image share a load is not known; \
             leave `mirror` out"
        );
        scope.report.over(&law.kinetic, text);
    }
    let (Some(friction), Some(slider)) = (friction, slider) else { return };
    contacts.claim(scope, "support", name, plain(name), "rename the slider or the support");
    contacts.guide(name, slider.guide.contact(structure, slider.point), friction);
}

impl Guide {
    /// The guide as a contact, its gap the distance from it.
    fn contact(&self, structure: &Structure, point: usize) -> OneSided {
        match self {
            Self::Line { through, direction } => {
                OneSided::Line { point, through: through.clone(), direction: direction.clone() }
            }
            Self::Circle { centre, radius, .. } => OneSided::Circle {
                point,
                centre: Centre::Ground(centre.clone()),
                radius: radius.clone(),
                reach: radius.clone(),
                inside: true,
            },
            Self::Axis(body) => {
                let bar = &structure.bodies[*body];
                let (ends, length) = ([bar.from, bar.to], bar.length.clone());
                let along = [Series::one(), Series::zero()];
                OneSided::Edge { point, edge: Edge { body: *body, ends, along, length }, side: 1 }
            }
        }
    }
}

/// The ends of bars that stop what slides along them, as one-sided constraints named after slider
/// and end.
pub(super) fn stops(scope: &mut Scope, structure: &Structure, contacts: &mut Contacts) {
    let description = scope.description;
    for declared in &description.sliders {
        let (Some(law), Track::Bar(bar)) = (&declared.stops, &declared.guide) else { continue };
        let restitution = restitution(scope, &declared.name, law);
        let name = declared.of.as_ref().unwrap_or(&declared.name);
        // What is not known is told of the slider.
        let point = structure.points.iter().position(|point| name == &point.name);
        let body = structure.bodies.iter().position(|body| bar == &body.name);
        let (Some(point), Some(body)) = (point, body) else { continue };
        let ends = [structure.bodies[body].from, structure.bodies[body].to];
        for (end, is_last) in ends.into_iter().zip([false, true]) {
            let name = format!("{}_{}", plain(&declared.name), structure.points[end].name);
            contacts.claim(
                scope,
                "support",
                &declared.name,
                name.clone(),
                "rename the slider or the support",
            );
            let contact = (OneSided::Stop { point, body, is_last }, None);
            contacts.push(&declared.name, name, contact, (law, restitution.clone()), (None, None));
        }
    }
}

fn slider(scope: &mut Scope, structure: &Structure, declared: &SliderDeclaration) -> Option<Slider> {
    let name = declared.of.as_ref().unwrap_or(&declared.name);
    let (point, guide) = match &declared.guide {
        Track::Bar(bar) => {
            let (point, body) = (structure.point(scope, name), structure.bar(scope, bar));
            (point, body.map(Guide::Axis))
        }
        track => {
            let point = structure.moving(scope, name);
            (point, fixed(scope, &declared.name, track))
        }
    };
    let (point, guide) = (point?, guide?);
    if let Guide::Axis(body) = guide
        && structure.members(body).iter().any(|(member, _)| *member == point)
    {
        let text =
            format!("`{name}` is a point of `{}`; it cannot slide along it", structure.bodies[body].name);
        scope.report.add_message(name.span(), text);
        return None;
    }
    let (name, rubs) = (plain(&declared.name), declared.friction.is_some());
    Some(Slider { name, point, guide, rubs, span: declared.name.span() })
}

fn fixed(scope: &mut Scope, owner: &Ident, track: &Track) -> Option<Guide> {
    let zero = Series::zero;
    match track {
        Track::Horizontal(height) => {
            let through = [zero(), scope.number(height)?];
            Some(Guide::Line { through, direction: Angle::zero() })
        }
        Track::Vertical(x) => {
            let through = [scope.number(x)?, zero()];
            Some(Guide::Line { through, direction: Angle::quarters(1) })
        }
        Track::Line(angle, through) => {
            let angle = scope.angle(angle);
            let through = through.as_ref().map_or_else(|| Ok([zero(), zero()]), |p| scope.position(p));
            let (angle, through) = (scope.report.keep(angle), scope.report.keep(through));
            Some(Guide::Line { through: through?, direction: angle? })
        }
        Track::Circle(centre, radius) => {
            let centre = scope.position(centre);
            let centre = scope.report.keep(centre);
            let radius = positive(scope, "the radius", owner, radius)?;
            let inverse = scope.constants.divide(&Series::one(), &radius)?;
            Some(Guide::Circle { centre: centre?, radius, inverse })
        }
        Track::Bar(_) => None,
    }
}
