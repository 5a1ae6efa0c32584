//! The spec as the oracle's data.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector2;

use super::assemble_parts::{parts, weld};
use super::spec::{Bar, Declared, Gravity, Heading, Origin, Pair, Shape, Spec, Tie};
use crate::oracle::{
    AngleTie, Assembly, Body, Contact, Coordinate, Hinge, Mark, Particle, Pin, Place, Support,
};

/// Where each named point is.
pub type Places = BTreeMap<String, Place>;

/// The bodies and what ties them, and a place for each named point.
pub fn assembly(spec: &Spec) -> (Assembly, Places) {
    let names = || spec.figure.keys();
    let marks: BTreeMap<_, Vec<Mark>> = names().map(|name| (name.clone(), marks(spec, name))).collect();
    let places: Places = names().map(|name| (name.clone(), locate(spec, name, &marks[name]))).collect();
    let first = |name: &str| marks[name][0];
    let pin = |name: &String| Pin { at: first(name), ground: vector(&spec.figure[name]) };
    let joined = |all: &Vec<Mark>| {
        let hinge = |&second: &Mark| Hinge { first: all[0], second };
        all.iter().skip(1).map(hinge).collect::<Vec<_>>()
    };
    let carried = spec.masses.iter().map(|(at, m)| (Some(first(at)), m));
    let free = spec.parts.particles.iter().map(|(_, m)| (None, m));
    let particles = carried.chain(free).map(|(carrier, m)| Particle { carrier, mass: m.value });
    let mut assembly = Assembly {
        bodies: spec.bars.iter().map(body).collect(),
        particles: particles.collect(),
        hinges: marks.values().flat_map(joined).collect(),
        pins: spec.pins.iter().map(pin).collect(),
        ties: ties(spec),
        supports: spec.supports.iter().flat_map(|support| supports(spec, support, &places)).collect(),
        gravity: gravity(&spec.gravity),
        ..Assembly::default()
    };
    parts(spec, &places, &mut assembly);
    (assembly, places)
}

fn locate(spec: &Spec, point: &str, marks: &[Mark]) -> Place {
    let free = spec.parts.particles.iter().position(|(name, _)| name == point);
    match (marks.first(), free) {
        (Some(&mark), _) => mark.into(),
        (None, Some(index)) => Place::Particle(spec.masses.len() + index),
        (None, None) => Place::Ground(vector(&spec.figure[point])),
    }
}

pub(super) fn vector([x, y]: &Pair) -> Vector2<f64> {
    Vector2::new(x.value, y.value)
}

fn marks(spec: &Spec, point: &str) -> Vec<Mark> {
    let places = spec.on(point).into_iter();
    places.map(|(body, local)| Mark { body, local: vector(&local) }).collect()
}

fn body(bar: &Bar) -> Body {
    let mut body = Body::uniform(&bar.name, bar.mass.value, bar.length.value);
    if let Some(inertia) = &bar.inertia {
        body.inertia = inertia.value;
    }
    if let Some((_, corner)) = &bar.corner {
        triangle(&mut body, vector(corner), bar.inertia.is_some());
    }
    if let Some((along, across)) = &bar.centre {
        body.centre = Vector2::new(along.value, across.as_ref().map_or(0.0, |q| q.value));
    }
    body
}

/// The uniform triangle with corners at 0, (l, 0) and `third`: I = m Σ|edge|²/36 about the mean of
/// the corners.
fn triangle(body: &mut Body, third: Vector2<f64>, said: bool) {
    let second = Vector2::new(body.length, 0.0);
    body.centre = (second + third) / 3.0;
    if !said {
        let edges = [second, third, third - second];
        body.inertia = body.mass * edges.iter().map(Vector2::norm_squared).sum::<f64>() / 36.0;
    }
}

fn gravity(gravity: &Gravity) -> Vector2<f64> {
    match gravity {
        Gravity::None => Vector2::zeros(),
        Gravity::Down(g) => Vector2::new(0.0, -g.value),
        Gravity::Vector(g) => vector(g),
    }
}

/// The two of a slot, else one.
fn supports(spec: &Spec, declared: &super::spec::SupportSpec, places: &Places) -> Vec<Support> {
    let support = |name: String, contact| Support { name, contact, rough: declared.manner.rough };
    let line = |through, normal| Contact::Point { point: places[&declared.point], through, normal };
    let contact = match &declared.shape {
        Shape::Floor(height) => {
            let height = height.as_ref().map_or(0.0, |q| q.value);
            line(Vector2::new(0.0, height), Vector2::y())
        }
        Shape::Wall { at, side, .. } => line(Vector2::new(at.value, 0.0), Vector2::x() * *side),
        Shape::Slope { angle, through } => {
            line(through.as_ref().map_or(Vector2::zeros(), vector), normal(angle.value))
        }
        Shape::Corner { bar, at, under } => {
            let normal_up = spec.bars[*bar].heading.p > 0;
            let side = if normal_up == *under { 1.0 } else { -1.0 };
            Contact::Corner { body: *bar, corner: vector(at), side }
        }
        Shape::Circle { centre, radius, inside } => Contact::Circle {
            point: places[&declared.point],
            centre: vector(centre),
            radius: radius.value,
            inside: *inside,
        },
        Shape::Slot { angle, through, width } => {
            let (across, middle) = (normal(angle.value), vector(through));
            let half = across * (width.value / 2.0);
            let sides = [("lower", middle - half, across), ("upper", middle + half, -across)];
            let side =
                |(side, through, normal)| support(format!("{}_{side}", declared.name), line(through, normal));
            return sides.map(side).into();
        }
    };
    vec![support(declared.name.clone(), contact)]
}

/// A quarter turn counter-clockwise from a direction.
pub(super) fn normal(angle: f64) -> Vector2<f64> {
    let (sin, cos) = angle.sin_cos();
    Vector2::new(-sin, cos)
}

/// direction = reference + sign·q of a declared angle, the reference a constant.
fn counted(spec: &Spec, bar: usize, origin: &Origin) -> (f64, f64) {
    let Heading { p, q, .. } = spec.bars[bar].heading;
    match origin {
        Origin::Line("horizontal") => {
            let base = if p >= 0 { 0.0 } else { PI.copysign(f64::from(q)) };
            (base, if q == 0 || (p > 0) == (q > 0) { 1.0 } else { -1.0 })
        }
        Origin::Line(_) => {
            let base = FRAC_PI_2.copysign(f64::from(q));
            (base, if p == 0 || (p > 0) != (q > 0) { 1.0 } else { -1.0 })
        }
        Origin::Direction(quarters, clockwise) => {
            (*quarters as f64 * FRAC_PI_2, if *clockwise { -1.0 } else { 1.0 })
        }
        Origin::Bar(_) => (0.0, 1.0),
    }
}

/// A declared coordinate as the oracle reads it.
pub fn coordinate(spec: &Spec, declared: &Declared, places: &Places) -> Coordinate {
    match declared {
        Declared::Position { point, axis, negative, .. } => {
            Coordinate::Position { at: places[point], axis: *axis, sign: if *negative { -1.0 } else { 1.0 } }
        }
        Declared::Angle { bar, origin: Origin::Bar(other), .. } => {
            Coordinate::Angle { terms: vec![(*bar, 1.0), (*other, -1.0)], offset: 0.0 }
        }
        Declared::Angle { bar, origin, .. } => {
            let (base, sign) = counted(spec, *bar, origin);
            Coordinate::Angle { terms: vec![(*bar, sign)], offset: sign * base }
        }
    }
}

/// The declared ties, and their images where there is a mirror.
fn ties(spec: &Spec) -> Vec<AngleTie> {
    let declared: Vec<_> = spec.ties.iter().map(|&tie| self::tie(spec, tie)).collect();
    let images = spec.mirror.iter().flat_map(|mirror| {
        declared.iter().map(|tie| AngleTie {
            terms: tie.terms.iter().map(|&(body, c)| (body + mirror.half, -c)).collect(),
            value: tie.value - tie.terms.iter().map(|(_, c)| c * mirror.angle(0.0)).sum::<f64>(),
        })
    });
    let welded = spec.parts.welds.iter().map(|held| weld(spec, held));
    declared.iter().cloned().chain(images).chain(welded).collect()
}

fn tie(spec: &Spec, tie: Tie) -> AngleTie {
    let angle = |index: usize| match coordinate(spec, &spec.coordinates[index], &BTreeMap::new()) {
        Coordinate::Angle { terms, offset } => (terms, offset),
        Coordinate::Position { .. } => (Vec::new(), 0.0),
    };
    match tie {
        Tie::Bars(a, b) => AngleTie { terms: vec![(a, 1.0), (b, -1.0)], value: 0.0 },
        Tie::Coordinates(a, b) => {
            let ((mut terms, left), (others, right)) = (angle(a), angle(b));
            terms.extend(others.into_iter().map(|(body, c)| (body, -c)));
            AngleTie { terms, value: left - right }
        }
    }
}
