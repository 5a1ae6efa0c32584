//! Point masses, pins and gravity.

use syn::Ident;

use super::bodies::Structure;
use super::mass_properties::not_negative;
use super::scope::Scope;
use super::{Particle, Pin};
use crate::algebra::Series;
use crate::syntax::{self, PointMass};

impl Structure {
    /// Adds point masses at points of bodies.
    pub(super) fn masses(&mut self, scope: &mut Scope) {
        let description = scope.description;
        for declared in &description.masses {
            let point = self.moving(scope, &declared.point);
            self.mass_at(scope, point, declared);
        }
    }

    /// Adds a mass at a point.
    pub(super) fn mass_at(&mut self, scope: &mut Scope, point: Option<usize>, declared: &PointMass) {
        let mass = scope.number(&declared.mass);
        not_negative(scope, "the mass", &declared.point, &declared.mass, mass.as_ref());
        if let (Some(point), Some(mass)) = (point, mass) {
            self.particles.push(Particle { point, mass, span: declared.point.span() });
        }
    }

    /// Sets the acceleration of free fall.
    pub(super) fn gravity(&mut self, scope: &mut Scope) {
        let gravity = scope.description.gravity.as_ref();
        self.gravity = gravity.and_then(|gravity| match &gravity.components[..] {
            [strength] => scope.number(strength).map(|g| [Series::zero(), -g]),
            [x, y] => {
                let (x, y) = (scope.number(x), scope.number(y));
                Some([x?, y?])
            }
            _ => None,
        });
    }

    /// Adds what the ground holds.
    pub(super) fn pins(&mut self, scope: &mut Scope) {
        let description = scope.description;
        for (name, at) in &description.pins {
            self.pin(scope, name, at);
        }
    }

    fn pin(&mut self, scope: &mut Scope, name: &Ident, at: &syntax::Pair) {
        let point = self.moving(scope, name);
        let position = scope.position(at);
        let position = scope.report.keep(position);
        scope.joined &= point.is_some();
        scope.placed &= position.is_some();
        let Some((point, at)) = point.zip(position) else {
            return;
        };
        let span = name.span();
        let is_loose = scope.description.loose_pins.iter().any(|(other, _)| other == name);
        match is_loose || self.pins.iter().any(|pin| pin.point == point) {
            true => scope.report.add_message(span, format!("point `{name}` is pinned twice; remove one pin")),
            false => self.pins.push(Pin { point, at, span }),
        }
    }
}
