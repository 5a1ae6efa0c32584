//! Points and bodies: ends of equal name are one point, a hinge.

use syn::Ident;

use super::mass_properties::MassValues;
use super::scope::Scope;
use super::{Body, Disc, Particle, Pin, Point};
use crate::algebra::Series;
use crate::syntax::plain;

/// Everything that has a place.
#[derive(Clone, Debug, Default)]
pub(super) struct Structure {
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
    /// Discs about points.
    pub discs: Vec<Disc>,
    members: Vec<Vec<(usize, [Series; 2])>>,
}

impl Structure {
    /// Resolves all bodies, points, masses, pins and gravity.
    pub fn resolve(scope: &mut Scope) -> Self {
        let description = scope.description;
        let mut structure = Self::default();
        for beam in &description.beams {
            structure.beam(scope, beam);
        }
        structure.points_on_bars(scope);
        structure.free_points(scope);
        structure.masses(scope);
        structure.discs(scope);
        structure.pins(scope);
        structure.gravity(scope);
        structure
    }

    /// The index of a point.
    pub fn point(&self, scope: &mut Scope, name: &Ident) -> Option<usize> {
        let known = self.points.iter().map(|p| p.name.as_str());
        match known.clone().any(|point| name == point) || !is_centre(name) || self.bodies.is_empty() {
            true => scope.find("point", name, known),
            false => {
                let body = &self.bodies[0].name;
                let text = format!(
                    "there is no point `{name}`; a centre of mass gets its name by `#[point({name} = {body}, at = …)]`, the \
                     distance from the first point of `{body}`"
                );
                scope.unknown_at(name, text);
                None
            }
        }
    }

    /// The index of a bar.
    pub fn body(&self, scope: &mut Scope, name: &Ident) -> Option<usize> {
        scope.find("bar", name, self.bodies.iter().map(|b| b.name.as_str()))
    }

    /// Whether something is called so that is a body and no point.
    pub fn is_body(&self, name: &Ident) -> bool {
        let name = plain(name);
        self.bodies.iter().any(|body| body.name == name) && self.points.iter().all(|point| point.name != name)
    }

    /// The index of a body that is a bar.
    pub fn bar(&self, scope: &mut Scope, name: &Ident) -> Option<usize> {
        let body = self.body(scope, name)?;
        if self.is_bar(body) {
            return Some(body);
        }
        scope
            .report
            .add_message(name.span(), format!("`{name}` is not a bar; this needs a bar, which has an axis"));
        None
    }

    /// The index of a point that is no fixed point.
    pub fn moving(&self, scope: &mut Scope, name: &Ident) -> Option<usize> {
        let point = self.point(scope, name)?;
        if self.points[point].ground.is_none() {
            return Some(point);
        }
        scope.report.add_message(name.span(), format!("`{name}` is a fixed point; name one that moves"));
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

    /// Adds a body with its points; there are two at least.
    pub(super) fn body_through(
        &mut self,
        name: &Ident,
        points: &[(&Ident, [Series; 2])],
        values: &MassValues,
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
        let MassValues { mass, length, extents, inertia, centre } = values.clone();
        let (name, span) = (plain(name), name.span());
        let [from, to] = [outline[0], outline[1]];
        self.bodies.push(Body {
            name,
            span,
            from,
            to,
            mass,
            length,
            extents,
            inertia,
            centre,
            uniform,
            outline,
        });
    }

    /// The point of a name, which is new or known.
    pub(super) fn add(&mut self, name: &Ident) -> usize {
        let text = plain(name);
        let known = self.points.iter().position(|point| text == point.name);
        known.unwrap_or_else(|| {
            self.points.push(Point { name: text, span: name.span(), on: Vec::new(), ground: None });
            self.points.len() - 1
        })
    }

    /// Fixes a point to a body.
    pub(super) fn attach(&mut self, point: usize, body: usize, local: [Series; 2]) {
        self.points[point].on.push((body, local.clone()));
        self.members[body].push((point, local));
    }
}

/// Whether books call centres of mass so: G, S, CM, `G_1`.
fn is_centre(name: &Ident) -> bool {
    let name = plain(name);
    let stem = name.split(|c: char| c == '_' || c.is_ascii_digit()).next().unwrap_or_default();
    ["G", "S", "CG", "CM", "COM"].contains(&stem)
}
