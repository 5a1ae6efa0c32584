//! Discs about points: those of supports touch with their rim.

use super::Disc;
use super::bodies::Structure;
use super::mass_properties::positive;
use super::scope::Scope;
use crate::syntax::DiscDeclaration;

impl Structure {
    /// Adds discs about points.
    pub(super) fn discs(&mut self, scope: &mut Scope) {
        let description = scope.description;
        for declared in &description.discs {
            let disc = self.declared_disc(scope, declared);
            self.discs.extend(disc);
        }
    }

    fn declared_disc(&self, scope: &mut Scope, declared: &DiscDeclaration) -> Option<Disc> {
        let name = &declared.centre;
        let centre = self.point(scope, name);
        let radius = positive(scope, "the radius", name, &declared.radius);
        let (centre, radius) = (centre?, radius?);
        if self.disc(centre).is_some() {
            scope.report.add_message(
                name.span(),
                format!("`{name}` has two discs; remove one, or name a second point there"),
            );
            return None;
        }
        let on = &self.points[centre].on;
        let body = match &declared.on {
            Some(body) => {
                let body_index = self.body(scope, body)?;
                if on.iter().all(|(other, _)| *other != body_index) {
                    scope.report.add_message(body.span(), format!("`{name}` is no point of `{body}`"));
                    return None;
                }
                Some(body_index)
            }
            None if on.len() > 1 => {
                let bodies: Vec<String> =
                    on.iter().map(|(body, _)| self.bodies[*body].name.clone()).collect();
                let text = format!(
                    "`{name}` is a point of {}; name the body with which the disc turns: `on = {}`",
                    super::listed(bodies.iter()),
                    bodies[0]
                );
                scope.report.add_message(name.span(), text);
                return None;
            }
            None => on.first().map(|(body, _)| *body),
        };
        Some(Disc { centre, body, radius, span: name.span() })
    }

    /// The disc about a point.
    pub fn disc(&self, centre: usize) -> Option<&Disc> {
        self.discs.iter().find(|disc| disc.centre == centre)
    }
}
