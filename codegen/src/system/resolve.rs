//! From a description to a system: names to indices, expressions to series, the figure completed, then the
//! decisions that depend on it.

use super::bodies::Scene;
use super::figure::Figure;
use super::mirror::Line;
use super::scope::Scope;
use super::{System, checks, coordinates, equal, mirror, names, supports};
use crate::syntax::Description;

impl System {
    /// Resolves and checks a description.
    ///
    /// # Errors
    /// Every mistake, each at its place.
    pub fn resolve(description: &Description) -> syn::Result<Self> {
        let mut scope = Scope::new(description);
        names::check(&mut scope);
        let scene = Scene::resolve(&mut scope);
        if description.beams.is_empty() && scope.joined {
            scope.report.at(
                description.ident.span(),
                "nothing is declared; add a bar: `#[bar(AD, mass = m, length = l)]`",
            );
        }
        let line = Line::resolve(&mut scope, &scene);
        let mut figure = Figure::complete(&mut scope, &scene, line.as_ref());
        let supports = supports::resolve(&mut scope, &scene, &mut figure);
        let coordinates = coordinates::resolve(&mut scope, &scene, &mut figure);
        let equal = equal::resolve(&mut scope, &scene, &coordinates);
        let mirror = line
            .zip(figure.as_ref())
            .and_then(|(line, figure)| mirror::resolve(&mut scope, &scene, line, figure, &supports));
        checks::untied(&mut scope, &scene);
        scope.check_used();
        scope.report.finish()?;
        Ok(Self {
            ident: description.ident.clone(),
            runtime: description.runtime.clone(),
            declaration: description.declaration.clone(),
            parameters: description.fields.clone(),
            constants: scope.constants.definitions().to_vec(),
            points: scene.points,
            bodies: scene.bodies,
            particles: scene.particles,
            pins: scene.pins,
            welds: Vec::new(),
            sliders: Vec::new(),
            drives: Vec::new(),
            springs: Vec::new(),
            torsions: Vec::new(),
            loads: Vec::new(),
            sections: Vec::new(),
            gravity: scene.gravity,
            supports,
            coordinates,
            equal,
            mirror,
            figure: figure.map(|figure| figure.positions).unwrap_or_default(),
            sets: crate::phases::LIMIT,
        })
    }
}
