//! Checks across declarations.

use syn::Ident;

use super::bodies::Structure;
use super::scope::Scope;
use crate::syntax::{Description, Member, Origin, ReadingDeclaration, Track, plain};

/// Reports bars that nothing ties to anything, where there is something to be tied to.
pub(super) fn untied(scope: &mut Scope, structure: &Structure) {
    if structure.bodies.len() < 2 || !scope.joined {
        return;
    }
    let named = named(scope.description);
    let malformed = &scope.description.malformed;
    let is_named =
        |name: &String| malformed.contains(name) || named.iter().any(|other| plain(other) == *name);
    for (i, body) in structure.bodies.iter().enumerate() {
        let points = structure.members(i).iter().map(|(point, _)| *point);
        let held = |p: usize| {
            structure.points[p].on.len() > 1
                || structure.pins.iter().any(|pin| pin.point == p)
                || is_named(&structure.points[p].name)
        };
        if !points.into_iter().any(held) && !is_named(&body.name) {
            let text = format!(
                "nothing ties {} `{}` to anything; let it share a point with another bar, or pin or support it",
                body.kind(),
                body.name
            );
            scope.report.add_message(body.span, text);
        }
    }
}

/// The points and bars that supports, constraints, loads and coordinates name.
fn named(description: &Description) -> Vec<&Ident> {
    let supports = description.supports.iter().flat_map(|s| {
        s.shape.movers().into_iter().map(Some).chain([Some(&s.name), s.under.as_ref(), s.over.as_ref()])
    });
    let equal = description.equal.iter().flat_map(|equal| &equal.members);
    let constrained = equal.map(|multiple| match &multiple.member {
        Member::Bar(name) | Member::Coordinate(name) => Some(name),
    });
    let measured = description.coordinates.iter().flat_map(|c| match &c.reading {
        ReadingDeclaration::Angle { bar, from: Origin::Bar(other) } => [Some(bar), Some(other)],
        ReadingDeclaration::Angle { bar, .. } => [Some(bar), None],
        ReadingDeclaration::Position { point, .. } => [Some(point), None],
    });
    supports.chain(constrained).chain(measured).flatten().chain(held(description)).collect()
}

/// The points and bars that are guided, driven, held or loaded.
fn held(d: &Description) -> impl Iterator<Item = &Ident> {
    let welds = d.welds.iter().flat_map(|weld| [Some(&weld.first), weld.second.as_ref()]);
    let sliders = d.sliders.iter().flat_map(|slider| {
        let bar = if let Track::Bar(bar) = &slider.guide { Some(bar) } else { None };
        [Some(&slider.name), slider.of.as_ref(), bar]
    });
    let drives = d.drives.iter().flat_map(|drive| drive.target.idents()).map(Some);
    let torsions = d.torsions.iter().flat_map(|torsion| [Some(&torsion.first), torsion.second.as_ref()]);
    let forces = d.forces.iter().flat_map(|force| [Some(&force.name), force.at.as_ref()]);
    let couples = d.couples.iter().flat_map(|c| [Some(&c.name), c.on.as_ref(), c.from.as_ref()]);
    let others = welds.chain(sliders).chain(drives).chain(torsions).chain(forces).chain(couples);
    let threads = d.threads.iter().flat_map(|thread| &thread.path);
    let springs = d.springs.iter().flat_map(|spring| &spring.ends);
    others.flatten().chain(threads).chain(springs)
}
