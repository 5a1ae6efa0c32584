//! Points and bodies: ends of equal name are one point, a hinge.

use syn::Ident;

use super::matter::{Values, along_across, not_negative};
use super::scope::Scope;
use super::{Body, Particle, Pin, Point};
use crate::algebra::Series;
use crate::syntax::{self, Bar, Beam, PointOnBar};

/// Everything that has a place.
#[derive(Clone, Debug, Default)]
pub(super) struct Scene {
    /// Named points.
    pub points: Vec<Point>,
    /// Bars.
    pub bodies: Vec<Body>,
    /// Point masses.
    pub particles: Vec<Particle>,
    /// Points held by the ground.
    pub pins: Vec<Pin>,
    /// The acceleration of free fall.
    pub gravity: Option<[Series; 2]>,
    members: Vec<Vec<(usize, [Series; 2])>>,
}

impl Scene {
    /// Resolves all bodies, points, masses, pins and gravity.
    pub fn resolve(scope: &mut Scope) -> Self {
        let description = scope.description;
        let mut scene = Self::default();
        for beam in &description.beams {
            scene.beam(scope, beam);
        }
        let mut named: Vec<&Ident> = Vec::new();
        for point in &description.points {
            if named.contains(&&point.name) {
                scope
                    .report
                    .at(point.name.span(), format!("point `{0}` is declared twice; remove one", point.name));
            } else {
                scene.point_on_bar(scope, point);
                named.push(&point.name);
            }
        }
        scene.loads(scope);
        scene
    }

    /// The index of a point.
    pub fn point(&self, scope: &mut Scope, name: &Ident) -> Option<usize> {
        scope.find("point", name, self.points.iter().map(|p| p.name.as_str()))
    }

    /// The index of a bar.
    pub fn body(&self, scope: &mut Scope, name: &Ident) -> Option<usize> {
        scope.find("bar", name, self.bodies.iter().map(|b| b.name.as_str()))
    }

    /// The points of a body and where on it they are.
    pub fn members(&self, body: usize) -> &[(usize, [Series; 2])] {
        &self.members[body]
    }

    fn beam(&mut self, scope: &mut Scope, beam: &Beam) {
        match beam {
            Beam::Bar(bar) => {
                let values = Values::of(scope, &bar.matter, &bar.name);
                self.bar(scope, bar, &values);
            }
            Beam::Chain(chain) => {
                let values = Values::of(scope, &chain.matter, &chain.name);
                chain.bars().for_each(|bar| self.bar(scope, &bar, &values));
            }
        }
    }

    fn bar(&mut self, scope: &mut Scope, bar: &Bar, values: &Values) {
        let Bar { name, from, to, .. } = bar;
        let known = self.bodies.iter().any(|other| *name == other.name);
        if known || from == to {
            scope.joined &= known;
            let text = match known {
                true => format!(
                    "bar `{name}` is declared twice; remove one, or name it: `other = {from} -> {to}`"
                ),
                false => format!("bar `{name}` begins and ends at the same point `{from}`"),
            };
            return scope.report.at(name.span(), text);
        }
        let body = self.bodies.len();
        self.members.push(Vec::new());
        let ends = [(from, Series::zero()), (to, values.length.clone())];
        let [from, to] = ends.map(|(end, along)| {
            let point = self.add(end);
            self.attach(point, body, [along, Series::zero()]);
            point
        });
        self.bodies.push(Body {
            name: name.to_string(),
            span: name.span(),
            from,
            to,
            mass: values.mass.clone(),
            length: values.length.clone(),
            inertia: values.inertia.clone(),
            centre: values.centre.clone(),
            uniform: bar.matter.inertia.is_none() && bar.matter.centre.is_none(),
            outline: vec![from, to],
        });
    }

    fn add(&mut self, name: &Ident) -> usize {
        let known = self.points.iter().position(|point| name == &point.name);
        known.unwrap_or_else(|| {
            self.points.push(Point {
                name: name.to_string(),
                span: name.span(),
                on: Vec::new(),
                ground: None,
            });
            self.points.len() - 1
        })
    }

    fn attach(&mut self, point: usize, body: usize, local: [Series; 2]) {
        self.points[point].on.push((body, local.clone()));
        self.members[body].push((point, local));
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
                "`{}` is an end of bar `{}` already; give this point another name",
                declared.name, declared.bar
            );
            return scope.report.at(declared.name.span(), text);
        }
        self.attach(point, body, local);
    }

    fn loads(&mut self, scope: &mut Scope) {
        let description = scope.description;
        for declared in &description.masses {
            let point = self.point(scope, &declared.point);
            let mass = scope.number(&declared.mass);
            not_negative(scope, "the mass", &declared.point, &declared.mass, mass.as_ref());
            if let (Some(point), Some(mass)) = (point, mass) {
                self.particles.push(Particle { point, mass, span: declared.point.span() });
            }
        }
        for (name, at) in &description.pins {
            self.pin(scope, name, at);
        }
        self.gravity = description.gravity.as_ref().and_then(|gravity| match &gravity.components[..] {
            [strength] => scope.number(strength).map(|g| [Series::zero(), -g]),
            [x, y] => {
                let (x, y) = (scope.number(x), scope.number(y));
                Some([x?, y?])
            }
            _ => None,
        });
    }

    fn pin(&mut self, scope: &mut Scope, name: &Ident, at: &syntax::Pair) {
        let point = self.point(scope, name);
        let position = scope.position(at);
        let position = scope.report.keep(position);
        scope.joined &= point.is_some();
        scope.placed &= position.is_some();
        let Some((point, at)) = point.zip(position) else {
            return;
        };
        let span = name.span();
        match self.pins.iter().any(|pin| pin.point == point) {
            true => scope.report.at(span, format!("point `{name}` is pinned twice; remove one pin")),
            false => self.pins.push(Pin { point, at, span }),
        }
    }
}
