//! Points of no body: particles, and points fixed to the ground.

use syn::Ident;

use super::bodies::Structure;
use super::scope::Scope;
use crate::algebra::Series;
use crate::syntax::plain;

impl Structure {
    /// Adds particles and fixed points.
    pub(super) fn free_points(&mut self, scope: &mut Scope) {
        let description = scope.description;
        for declared in &description.particles {
            let name = &declared.point;
            let instead = format!("give it a mass by `#[mass({name}, …)]`");
            let point = self.free_point(scope, name, &instead);
            self.mass_at(scope, point, declared);
        }
        for (name, at) in &description.ground {
            let place = scope.position(at);
            let place = scope.report.keep(place);
            scope.placed &= place.is_some();
            if let Some(point) = self.free_point(scope, name, &format!("hold it by `#[pin({name} = …)]`")) {
                self.points[point].ground = Some(place.unwrap_or_else(|| [Series::zero(), Series::zero()]));
            }
        }
    }

    fn free_point(&mut self, scope: &mut Scope, name: &Ident, instead: &str) -> Option<usize> {
        let text =
            match self.points.iter().find(|point| plain(name) == point.name).map(|point| point.on.first()) {
                None => return Some(self.add(name)),
                Some(Some((body, _))) => {
                    format!("`{name}` is a point of `{}` already; {instead}", self.bodies[*body].name)
                }
                Some(None) => format!("point `{name}` is declared twice; remove one"),
            };
        scope.report.add_message(name.span(), text);
        None
    }
}
