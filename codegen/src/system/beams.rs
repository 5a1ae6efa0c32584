//! Bars, chains of them, and points on them.

use syn::Ident;

use super::bodies::Structure;
use super::mass_properties::{MassValues, along_across};
use super::scope::Scope;
use crate::algebra::Series;
use crate::syntax::{Bar, Beam, PointOnBar, plain};

impl Structure {
    /// Adds what is rigid.
    pub(super) fn beam(&mut self, scope: &mut Scope, beam: &Beam) {
        match beam {
            Beam::Bar(bar) => {
                let values = MassValues::evaluate(scope, &bar.mass_properties, &bar.name);
                self.beam_between(scope, bar, &values);
            }
            Beam::Body(body) => self.rigid_body(scope, body),
            Beam::Chain(chain) => {
                let values = MassValues::evaluate(scope, &chain.mass_properties, &chain.name);
                chain.bars().for_each(|bar| self.beam_between(scope, &bar, &values));
            }
        }
    }

    fn beam_between(&mut self, scope: &mut Scope, bar: &Bar, values: &MassValues) {
        let Bar { name, from, to, .. } = bar;
        let text = plain(name);
        let known = self.bodies.iter().any(|other| text == other.name);
        if known || from == to {
            scope.joined &= known;
            let text = match known {
                true => format!(
                    "bar `{name}` is declared twice; remove one, or name it: `other = {from} -> {to}`"
                ),
                false => format!("bar `{name}` begins and ends at the same point `{from}`"),
            };
            return scope.report.add_message(name.span(), text);
        }
        let zero = Series::zero;
        let points = [(from, [zero(), zero()]), (to, [values.length.clone(), zero()])];
        let uniform = bar.mass_properties.inertia.is_none() && bar.mass_properties.centre.is_none();
        self.body_through(name, &points, values, uniform);
    }

    /// Adds points on bars and bodies.
    pub(super) fn points_on_bars(&mut self, scope: &mut Scope) {
        let description = scope.description;
        let mut named: Vec<&Ident> = Vec::new();
        for point in &description.points {
            if named.contains(&&point.name) {
                scope.report.add_message(
                    point.name.span(),
                    format!("point `{0}` is declared twice; remove one", point.name),
                );
            } else {
                self.point_on_bar(scope, point);
                named.push(&point.name);
            }
        }
    }

    fn point_on_bar(&mut self, scope: &mut Scope, declared: &PointOnBar) {
        let body = self.body(scope, &declared.bar);
        let local = along_across(scope, &declared.at);
        let (Some(body), Some(local)) = (body, local) else {
            scope.joined = false;
            return;
        };
        let point = self.add(&declared.name);
        if self.points[point].on.iter().any(|(b, _)| *b == body) {
            let text = format!(
                "`{}` is a point of `{}` already; give this one another name",
                declared.name, declared.bar
            );
            return scope.report.add_message(declared.name.span(), text);
        }
        self.attach(point, body, local);
    }
}
