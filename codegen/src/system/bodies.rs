//! Points, bars and what is fixed to them: ends of equal name are one point, a hinge.

use syn::Ident;

use super::matter::{Values, along_across, not_negative};
use super::scope::Scope;
use super::{Body, Particle, Pin, Point};
use crate::algebra::Series;
use crate::syntax::{self, Bar, Beam, PointMass, PointOnBar};

/// Everything that has a place.
#[derive(Clone, Debug, Default)]
pub(super) struct Scene {
    /// Named points.
    pub points: Vec<Point>,
    /// Bars and other bodies.
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
        scene.free_points(scope);
        scene.masses(scope);
        for (name, at) in &description.pins {
            scene.pin(scope, name, at);
        }
        scene.gravity(scope);
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

    /// The index of a body that is a bar.
    pub fn bar(&self, scope: &mut Scope, name: &Ident) -> Option<usize> {
        let body = self.body(scope, name)?;
        if self.is_bar(body) {
            return Some(body);
        }
        scope.report.at(name.span(), format!("`{name}` is no bar; this needs a bar, which has an axis"));
        None
    }

    /// The index of a point that is no fixed point.
    pub fn moving(&self, scope: &mut Scope, name: &Ident) -> Option<usize> {
        let point = self.point(scope, name)?;
        if self.points[point].ground.is_none() {
            return Some(point);
        }
        scope.report.at(name.span(), format!("`{name}` is a fixed point; name one that moves"));
        None
    }

    /// Whether the body's frame runs from its first point along its last.
    pub fn is_bar(&self, body: usize) -> bool {
        let along = [[Series::zero(), Series::zero()], [self.bodies[body].length.clone(), Series::zero()]];
        self.bodies[body].outline.len() == 2 && self.members[body].iter().map(|(_, z)| z).take(2).eq(&along)
    }

    /// Where the ground holds a point, if it does.
    pub fn fixed(&self, point: usize) -> Option<&[Series; 2]> {
        let pin = || self.pins.iter().find(|pin| pin.point == point).map(|pin| &pin.at);
        self.points[point].ground.as_ref().or_else(pin)
    }

    /// Whether the distance of two points never changes, because both are fixed or on one body.
    pub fn rigid(&self, a: usize, b: usize) -> bool {
        let on = |point: usize| self.points[point].on.iter().map(|(body, _)| *body);
        on(a).any(|body| on(b).any(|other| other == body)) || self.fixed(a).and(self.fixed(b)).is_some()
    }

    /// The points of a body and where on it they are.
    pub fn members(&self, body: usize) -> &[(usize, [Series; 2])] {
        &self.members[body]
    }

    fn beam(&mut self, scope: &mut Scope, beam: &Beam) {
        match beam {
            Beam::Bar(bar) => {
                let values = Values::of(scope, &bar.matter, &bar.name);
                self.beam_between(scope, bar, &values);
            }
            Beam::Body(body) => self.rigid_body(scope, body),
            Beam::Chain(chain) => {
                let values = Values::of(scope, &chain.matter, &chain.name);
                chain.bars().for_each(|bar| self.beam_between(scope, &bar, &values));
            }
        }
    }

    fn beam_between(&mut self, scope: &mut Scope, bar: &Bar, values: &Values) {
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
        let zero = Series::zero;
        let points = [(from, [zero(), zero()]), (to, [values.length.clone(), zero()])];
        let uniform = bar.matter.inertia.is_none() && bar.matter.centre.is_none();
        self.body_through(name, &points, values, uniform);
    }

    /// Adds a body with its points; there are two at least.
    pub(super) fn body_through(
        &mut self,
        name: &Ident,
        points: &[(&Ident, [Series; 2])],
        values: &Values,
        uniform: bool,
    ) {
        let body = self.bodies.len();
        self.members.push(Vec::new());
        let mut outline = Vec::new();
        for (name, local) in points {
            let point = self.add(name);
            self.attach(point, body, local.clone());
            outline.push(point);
        }
        let Values { mass, length, inertia, centre } = values.clone();
        let (name, span) = (name.to_string(), name.span());
        let [from, to] = [outline[0], outline[1]];
        self.bodies.push(Body { name, span, from, to, mass, length, inertia, centre, uniform, outline });
    }

    /// The point of a name, which is new or known.
    pub(super) fn add(&mut self, name: &Ident) -> usize {
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
                "`{}` is a point of `{}` already; give this one another name",
                declared.name, declared.bar
            );
            return scope.report.at(declared.name.span(), text);
        }
        self.attach(point, body, local);
    }

    fn masses(&mut self, scope: &mut Scope) {
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

    fn gravity(&mut self, scope: &mut Scope) {
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
        match self.pins.iter().any(|pin| pin.point == point) {
            true => scope.report.at(span, format!("point `{name}` is pinned twice; remove one pin")),
            false => self.pins.push(Pin { point, at, span }),
        }
    }
}
