//! From a description to a system: names to indices, expressions to series, the figure completed,
//! then the decisions that depend on it.

use super::bodies::Structure;
use super::contact_law::Contacts;
use super::figure::Figure;
use super::formula::Readable;
use super::mirror_line::Line;
use super::parts::Parts;
use super::scope::Scope;
use super::{
    System, checks, coordinates, drives, edges, equal, forces, hinges, joint_limits, mirror, names, sections,
    sliders, springs, supports, threads, welds,
};
use crate::syntax::Description;

impl Parts {
    fn resolve(scope: &mut Scope, structure: &Structure, figure: &mut Option<Figure>) -> Self {
        let mut contacts = Contacts::default();
        supports::resolve(scope, structure, figure, &mut contacts);
        edges::both_sides(scope, structure, &contacts.resolved);
        threads::resolve(scope, structure, figure.as_ref(), &mut contacts);
        sliders::stops(scope, structure, &mut contacts);
        let coordinates = coordinates::resolve(scope, structure, figure);
        let readable = Readable { structure, coordinates: &coordinates };
        let equal = equal::resolve(scope, structure, &coordinates);
        let welds = welds::resolve(scope, structure, figure);
        let sliders = sliders::resolve(scope, structure, &mut contacts);
        let drives = drives::resolve(scope, &readable, figure.as_ref(), &mut contacts);
        joint_limits::resolve(scope, &readable, figure.as_ref(), &mut contacts);
        hinges::resolve(scope, structure, &mut contacts);
        Self {
            supports: contacts.guides_first(),
            equal,
            welds,
            sliders,
            drives,
            springs: springs::springs(scope, &readable),
            torsions: springs::torsions(scope, &readable),
            loads: forces::resolve(scope, &readable),
            sections: sections::resolve(scope, structure),
            coordinates,
        }
    }
}

impl System {
    /// Resolves and checks a description.
    ///
    /// # Errors
    /// Every mistake, each at its place.
    pub fn resolve(description: &Description) -> syn::Result<Self> {
        let mut scope = Scope::new(description);
        names::check(&mut scope);
        let structure = Structure::resolve(&mut scope);
        if description.beams.is_empty() && description.particles.is_empty() && scope.joined {
            scope.report.add_message(
                description.ident.span(),
                "nothing is declared; add a bar: `#[bar(AD, mass = m, length = l)]`",
            );
        }
        let line = Line::resolve(&mut scope, &structure);
        let mut figure = Figure::complete(&mut scope, &structure, line.as_ref());
        let parts = Parts::resolve(&mut scope, &structure, &mut figure);
        let mirror = line
            .zip(figure.as_ref())
            .and_then(|(line, figure)| mirror::resolve(&mut scope, &structure, line, figure, &parts));
        checks::untied(&mut scope, &structure);
        scope.check_used();
        core::mem::take(&mut scope.report).finish()?;
        let figure = figure.unwrap_or_default();
        let samples = figure.numbers(&scope, &structure);
        Ok(Self {
            ident: description.ident.clone(),
            runtime: description.runtime.clone(),
            name_constants: description.names.clone(),
            declaration: description.declaration.clone(),
            summary: description.summary.clone(),
            parameters: description.fields.clone(),
            meanings: description.meanings.clone(),
            values: description.values.clone(),
            run: description.run.clone().unwrap_or_default(),
            constants: scope.constants.definitions().to_vec(),
            points: structure.points,
            bodies: structure.bodies,
            particles: structure.particles,
            discs: structure.discs,
            pins: structure.pins,
            gravity: structure.gravity,
            welds: parts.welds,
            sliders: parts.sliders,
            drives: parts.drives,
            springs: parts.springs,
            torsions: parts.torsions,
            loads: parts.loads,
            switches: scope.switches.clone(),
            signals: scope.signals.clone(),
            sections: parts.sections,
            supports: parts.supports,
            coordinates: parts.coordinates,
            equal: parts.equal,
            mirror,
            figure: figure.positions,
            settled: figure.settled,
            samples,
            sets: description.sets.unwrap_or(crate::limits::CLOSED_FORMS),
        })
    }
}
