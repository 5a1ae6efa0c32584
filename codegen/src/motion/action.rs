//! Forces and couples, and what they act on.

use crate::algebra::{Angle, Rational, Series, Symbol};
use crate::kinematics::Kinematics;
use crate::system::{CoordinateKind, System};

/// What moves as one: a body with the point masses on it, or a free point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holder {
    /// A body, by its index.
    Body(usize),
    /// A point that belongs to no body.
    Point(usize),
}

/// A force at a place of a holder, or a couple on it.
#[derive(Clone, Debug)]
pub struct Action {
    /// On what it acts; nothing where the ground bears it.
    pub on: Option<Holder>,
    /// Where it acts.
    pub at: [Series; 2],
    /// The same along the body, from the origin of its frame.
    pub along: Series,
    /// The force.
    pub force: [Series; 2],
    /// The couple, counter-clockwise.
    pub couple: Series,
}

impl Action {
    /// A force at a point.
    pub(super) fn at_point(scene: &Scene, point: usize, force: [Series; 2]) -> Self {
        let on = scene.holder(point);
        let along = match on {
            Some(Holder::Body(body)) => scene.system.local(body, point)[0].clone(),
            _ => Series::zero(),
        };
        Self { on, at: scene.kinematics.points[point].clone(), along, force, couple: Series::zero() }
    }

    /// A force at a place of a body, so far along it.
    pub(super) fn at_place(body: usize, at: [Series; 2], along: Series, force: [Series; 2]) -> Self {
        Self { on: Some(Holder::Body(body)), at, along, force, couple: Series::zero() }
    }

    /// A couple on a body: at the point that it shares with the body that bears the opposite, else
    /// at its first.
    pub(super) fn couple(scene: &Scene, body: usize, from: Option<usize>, couple: Series) -> Self {
        let holds =
            |point: &usize, body: usize| scene.system.points[*point].on.iter().any(|(b, _)| *b == body);
        let mut points = 0..scene.system.points.len();
        let shared = from.and_then(|from| points.find(|p| holds(p, body) && holds(p, from)));
        let point = shared.unwrap_or(scene.system.bodies[body].from);
        let along = scene.system.local(body, point)[0].clone();
        let at = scene.kinematics.points[point].clone();
        let force = [Series::zero(), Series::zero()];
        Self { on: Some(Holder::Body(body)), at, along, force, couple }
    }

    /// `F · ∂r/∂qᵢ + C ∂δ/∂qᵢ`, r the place's velocity with what it acts on.
    pub(super) fn work(&self, scene: &Scene, i: usize) -> Series {
        let body = match self.on {
            None => return Series::zero(),
            Some(Holder::Point(point)) => return scene.work(point, &self.force, i),
            Some(Holder::Body(body)) => body,
        };
        let from = scene.kinematics.tree.entry[body];
        let arm = [0, 1].map(|axis| &self.at[axis] - &scene.kinematics.points[from][axis]);
        let turn = scene.turn(body, i);
        let moment = &(&arm[0] * &self.force[1]) - &(&arm[1] * &self.force[0]);
        &scene.work(from, &self.force, i) + &(&turn * &(&moment + &self.couple))
    }

    /// The same, so many times as strong.
    pub fn scaled(&self, factor: &Series) -> Self {
        let force = self.force.each_ref().map(|part| part * factor);
        Self { force, couple: &self.couple * factor, ..self.clone() }
    }
}

/// A system with its kinematics.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// What is declared.
    pub system: &'a System,
    /// Where it is.
    pub kinematics: &'a Kinematics,
}

impl Scene<'_> {
    /// What a point moves with: the body it was reached by, else the first it belongs to.
    pub fn holder(&self, point: usize) -> Option<Holder> {
        let declared = &self.system.points[point];
        let first = || declared.on.first().map(|(body, _)| *body);
        match self.kinematics.tree.owner[point].or_else(first) {
            Some(body) => Some(Holder::Body(body)),
            None => declared.ground.is_none().then_some(Holder::Point(point)),
        }
    }

    /// That nothing gives a coordinate inertia, and nothing holds it.
    pub(super) fn massless(&self, i: usize) -> syn::Error {
        let coordinate = &self.kinematics.coordinates[i];
        let (what, span) = match coordinate.reading {
            CoordinateKind::Angle { body, .. } => {
                let body = &self.system.bodies[body];
                (format!("{} `{}`", body.kind(), body.name), body.span)
            }
            CoordinateKind::Position { point, .. } => {
                let point = &self.system.points[point];
                (format!("point `{}`", point.name), point.span)
            }
        };
        let text = format!(
            "{what} has neither mass nor constraint in the direction of `{}`, so that its motion is not determined; \
             give it mass, or tie or support it",
            coordinate.name
        );
        syn::Error::new(span, text)
    }

    pub(super) fn n(&self) -> usize {
        self.kinematics.coordinates.len()
    }

    /// `f · ∂r/∂qᵢ` of a force at a point.
    pub(super) fn work(&self, point: usize, force: &[Series; 2], i: usize) -> Series {
        let slope = |axis: usize| self.kinematics.points[point][axis].derivative(Symbol::coordinate(i));
        &(&force[0] * &slope(0)) + &(&force[1] * &slope(1))
    }

    /// `∂δ/∂qᵢ` of a body's direction.
    pub(super) fn turn(&self, body: usize, i: usize) -> Series {
        let k = self.kinematics.directions[body].coefficient(Symbol::coordinate(i));
        Series::constant(Rational::integer(k.into()))
    }
}

/// (cos δ, sin δ).
pub(super) fn unit(direction: &Angle) -> [Series; 2] {
    [Series::cos(direction), Series::sin(direction)]
}

/// (−sin δ, cos δ).
pub(super) fn normal(direction: &Angle) -> [Series; 2] {
    [-Series::sin(direction), Series::cos(direction)]
}
