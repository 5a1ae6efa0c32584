//! From a description to a system: names to indices, expressions to series, the figure completed, then the
//! decisions that depend on it.

use super::bodies::Scene;
use super::figure::Figure;
use super::formula::Readable;
use super::manner::Contacts;
use super::mirror::Line;
use super::scope::Scope;
use super::{
    Declared, Drive, Equal, Load, Section, Slider, Spring, Support, System, Torsion, Weld, checks,
    coordinates, drives, equal, forces, mirror, names, sections, sliders, springs, supports, threads, welds,
};
use crate::syntax::Description;

/// What constrains, drives and loads the scene.
pub(super) struct Parts {
    pub coordinates: Vec<Declared>,
    pub supports: Vec<Support>,
    pub equal: Vec<Equal>,
    pub welds: Vec<Weld>,
    pub sliders: Vec<Slider>,
    pub drives: Vec<Drive>,
    pub springs: Vec<Spring>,
    pub torsions: Vec<Torsion>,
    pub loads: Vec<Load>,
    pub sections: Vec<Section>,
}

impl Parts {
    fn resolve(scope: &mut Scope, scene: &Scene, figure: &mut Option<Figure>) -> Self {
        let mut contacts = Contacts::default();
        supports::resolve(scope, scene, figure, &mut contacts);
        threads::resolve(scope, scene, figure.as_ref(), &mut contacts);
        let coordinates = coordinates::resolve(scope, scene, figure);
        let readable = Readable { scene, coordinates: &coordinates };
        Self {
            supports: contacts.resolved,
            equal: equal::resolve(scope, scene, &coordinates),
            welds: welds::resolve(scope, scene, figure),
            sliders: sliders::resolve(scope, scene),
            drives: drives::resolve(scope, &readable),
            springs: springs::springs(scope, scene),
            torsions: springs::torsions(scope, scene),
            loads: forces::resolve(scope, &readable),
            sections: sections::resolve(scope, scene),
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
        let scene = Scene::resolve(&mut scope);
        if description.beams.is_empty() && description.particles.is_empty() && scope.joined {
            scope.report.at(
                description.ident.span(),
                "nothing is declared; add a bar: `#[bar(AD, mass = m, length = l)]`",
            );
        }
        let line = Line::resolve(&mut scope, &scene);
        let mut figure = Figure::complete(&mut scope, &scene, line.as_ref());
        let parts = Parts::resolve(&mut scope, &scene, &mut figure);
        let mirror = line
            .zip(figure.as_ref())
            .and_then(|(line, figure)| mirror::resolve(&mut scope, &scene, line, figure, &parts));
        checks::untied(&mut scope, &scene);
        scope.check_used();
        core::mem::take(&mut scope.report).finish()?;
        let figure = figure.unwrap_or_default();
        let samples = figure.numbers(&scope, &scene);
        Ok(Self {
            ident: description.ident.clone(),
            runtime: description.runtime.clone(),
            declaration: description.declaration.clone(),
            summary: description.summary.clone(),
            parameters: description.fields.clone(),
            meanings: description.meanings.clone(),
            constants: scope.constants.definitions().to_vec(),
            points: scene.points,
            bodies: scene.bodies,
            particles: scene.particles,
            pins: scene.pins,
            gravity: scene.gravity,
            welds: parts.welds,
            sliders: parts.sliders,
            drives: parts.drives,
            springs: parts.springs,
            torsions: parts.torsions,
            loads: parts.loads,
            sections: parts.sections,
            supports: parts.supports,
            coordinates: parts.coordinates,
            equal: parts.equal,
            mirror,
            figure: figure.positions,
            settled: figure.settled,
            samples,
            sets: description.sets.unwrap_or(crate::phases::LIMIT),
        })
    }
}
