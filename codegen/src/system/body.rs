//! Rigid bodies of any shape. A uniform triangle with the sides a, b, c has its centre of mass at
//! the mean of its corners and the moment of inertia I = m (a² + b² + c²)/36 about it.

use super::bodies::Structure;
use super::figure::SAMPLES;
use super::mass_properties::{MassValues, not_negative};
use super::outline::describe_crossing;
use super::scope::Scope;
use crate::algebra::{Rational, Series};
use crate::syntax::{RigidBody, plain};

type Place = [Series; 2];

impl Structure {
    /// Adds a body with the points of its own frame.
    pub(super) fn rigid_body(&mut self, scope: &mut Scope, declared: &RigidBody) {
        let name = &declared.name;
        if self.bodies.iter().any(|other| plain(name) == other.name) {
            return scope
                .report
                .add_message(name.span(), format!("body `{name}` is declared twice; rename one"));
        }
        let mut places: Vec<Place> = Vec::new();
        for (i, (point, at)) in declared.points.iter().enumerate() {
            if declared.points[..i].iter().any(|(other, _)| other == point) {
                scope.joined = false;
                let text = format!("body `{name}` has point `{point}` twice; remove one");
                return scope.report.add_message(point.span(), text);
            }
            let place = scope.position(at);
            let place = scope.report.keep(place);
            scope.placed &= place.is_some();
            // Where a place is not understood, any that differs from the others serves to go on.
            places.push(place.unwrap_or_else(|| [Series::integer(1_000_003 + i as i64), Series::zero()]));
        }
        if let Some((i, j)) = coincident(&places) {
            let [(a, _), (b, _)] = [&declared.points[i], &declared.points[j]];
            scope.placed = false;
            scope
                .report
                .add_message(b.span(), format!("points `{a}` and `{b}` of body `{name}` are at one place"));
        }
        if let Some(crossing) = find_crossing(scope, declared, &places).filter(|_| scope.placed) {
            let text = format!(
                "body `{name}`: {crossing}; a point within it is declared by `#[point(P = {name}, at = (x, y))]`"
            );
            scope.report.add_message(name.span(), text);
        }
        let values = values(scope, declared, &places);
        let points: Vec<_> = declared.points.iter().map(|(name, _)| name).zip(places).collect();
        self.body_through(name, &points, &values, false);
    }
}

/// Which sides cross, where the same do with all sample values of the parameters.
fn find_crossing(scope: &Scope, declared: &RigidBody, places: &[Place]) -> Option<String> {
    let names: Vec<String> = declared.points.iter().map(|(name, _)| plain(name)).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut samples = scope.candidates().take(SAMPLES).map(|values| {
        let corners: Vec<_> = places.iter().map(|place| values.pair(place)).collect();
        describe_crossing(&names, &corners)
    });
    let first = samples.next()??;
    samples.all(|sides| sides.is_some()).then_some(first)
}

fn coincident(places: &[Place]) -> Option<(usize, usize)> {
    let equal = |j: usize| (0..j).find(|&i| places[i] == places[j]).map(|i| (i, j));
    (0..places.len()).find_map(equal)
}

fn values(scope: &mut Scope, declared: &RigidBody, places: &[Place]) -> MassValues {
    let name = &declared.name;
    let mass = scope.number(&declared.mass);
    not_negative(scope, "the mass", name, &declared.mass, mass.as_ref());
    let mass = mass.unwrap_or_else(Series::one);
    let inertia = declared.inertia.as_ref().and_then(|expr| {
        let inertia = scope.number(expr);
        not_negative(scope, "the inertia", name, expr, inertia.as_ref());
        inertia
    });
    let centre = declared.centre.as_ref().and_then(|at| {
        let centre = scope.position(at);
        scope.report.keep(centre)
    });
    let triangle = is_triangle(scope, places);
    if !triangle && (declared.inertia.is_none() || declared.centre.is_none()) {
        let text = format!(
            "`{name}` is no triangle, so its centre of mass and inertia are not known; add `inertia = …` and \
             `centre = (x, y)`"
        );
        scope.report.add_message(name.span(), text);
    }
    let inertia = inertia.unwrap_or_else(|| inertia_of_triangle(scope, &mass, places));
    let centre = centre.unwrap_or_else(|| mean(places));
    let mut distance = |place: &Place| scope.norm(&minus(place, &places[0]));
    let (length, extents) = (distance(&places[1]), places[2..].iter().map(&mut distance).collect());
    MassValues { length, extents, mass, inertia, centre }
}

fn is_triangle(scope: &Scope, places: &[Place]) -> bool {
    let [a, b, c] = places else {
        return false;
    };
    let ([x, y], [u, v]) = (minus(b, a), minus(c, a));
    let times = |a: &Series, b: &Series| scope.constants.multiply(a, b);
    times(&x, &v) != times(&y, &u)
}

fn mean(places: &[Place]) -> Place {
    let share = Rational::new(1, places.len() as i128);
    [0, 1].map(|axis| places.iter().map(|place| &place[axis]).sum::<Series>().scale(share))
}

/// m (a² + b² + c²)/36.
fn inertia_of_triangle(scope: &Scope, mass: &Series, corners: &[Place]) -> Series {
    let side = |i: usize| minus(&corners[(i + 1) % corners.len()], &corners[i]);
    let squares: Series = (0..corners.len()).map(|i| scope.square(&side(i))).sum();
    scope.constants.multiply(mass, &squares).scale(Rational::new(1, 36))
}

fn minus(a: &Place, b: &Place) -> Place {
    [&a[0] - &b[0], &a[1] - &b[1]]
}
