//! The scheme as the oracle's data.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector2;

use super::scheme::{Bar, Declared, Gravity, Heading, Origin, Pair, Scheme, Shape, Tie};
use crate::oracle::{AngleTie, Assembly, Body, Contact, Coordinate, Hinge, Mark, Particle, Pin, Support};

/// The bodies and what ties them, and a mark for each named point.
pub fn assembly(scheme: &Scheme) -> (Assembly, BTreeMap<String, Mark>) {
    let names = || scheme.figure.keys();
    let marks: BTreeMap<_, Vec<Mark>> = names().map(|name| (name.clone(), marks(scheme, name))).collect();
    let first = |name: &str| marks[name][0];
    let pin = |name: &String| Pin { at: first(name), ground: vector(&scheme.figure[name]) };
    let joined = |all: &Vec<Mark>| {
        let hinge = |&second: &Mark| Hinge { first: all[0], second };
        all[1..].iter().map(hinge).collect::<Vec<_>>()
    };
    let particles = scheme.masses.iter();
    let support = |support: &super::scheme::Support| Support {
        name: support.name.clone(),
        contact: contact(scheme, &support.shape, marks.get(&support.point)),
        rough: false,
    };
    let assembly = Assembly {
        bodies: scheme.bars.iter().map(body).collect(),
        particles: particles.map(|(at, m)| Particle { carrier: Some(first(at)), mass: m.value }).collect(),
        hinges: marks.values().flat_map(joined).collect(),
        pins: scheme.pins.iter().map(pin).collect(),
        supports: scheme.supports.iter().map(support).collect(),
        ties: ties(scheme),
        gravity: gravity(&scheme.gravity),
        ..Assembly::default()
    };
    (assembly, marks.into_iter().map(|(name, marks)| (name, marks[0])).collect())
}

fn vector([x, y]: &Pair) -> Vector2<f64> {
    Vector2::new(x.value, y.value)
}

fn marks(scheme: &Scheme, point: &str) -> Vec<Mark> {
    let places = scheme.on(point).into_iter();
    places.map(|(body, local)| Mark { body, local: vector(&local) }).collect()
}

fn body(bar: &Bar) -> Body {
    let mut body = Body::uniform(&bar.name, bar.mass.value, bar.length.value);
    if let Some(inertia) = &bar.inertia {
        body.inertia = inertia.value;
    }
    if let Some((along, across)) = &bar.centre {
        body.centre = Vector2::new(along.value, across.as_ref().map_or(0.0, |q| q.value));
    }
    body
}

fn gravity(gravity: &Gravity) -> Vector2<f64> {
    match gravity {
        Gravity::None => Vector2::zeros(),
        Gravity::Down(g) => Vector2::new(0.0, -g.value),
        Gravity::Vector(g) => vector(g),
    }
}

fn contact(scheme: &Scheme, shape: &Shape, point: Option<&Vec<Mark>>) -> Contact {
    let line = |through, normal| Contact::Point {
        point: point.map_or(Mark::along(0, 0.0), |marks| marks[0]).into(),
        through,
        normal,
    };
    match shape {
        Shape::Floor(height) => {
            let height = height.as_ref().map_or(0.0, |q| q.value);
            line(Vector2::new(0.0, height), Vector2::y())
        }
        Shape::Wall { at, side, .. } => line(Vector2::new(at.value, 0.0), Vector2::x() * *side),
        Shape::Slope { angle, through } => {
            let (sin, cos) = angle.value.sin_cos();
            let through = through.as_ref().map_or(Vector2::zeros(), vector);
            line(through, Vector2::new(-sin, cos))
        }
        Shape::Corner { bar, at, under } => {
            let normal_up = scheme.bars[*bar].heading.p > 0;
            let side = if normal_up == *under { 1.0 } else { -1.0 };
            Contact::Corner { body: *bar, corner: vector(at), side }
        }
    }
}

/// direction = reference + sign·q of a declared angle, the reference a constant.
fn counted(scheme: &Scheme, bar: usize, origin: &Origin) -> (f64, f64) {
    let Heading { p, q, .. } = scheme.bars[bar].heading;
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
pub fn coordinate(scheme: &Scheme, declared: &Declared, marks: &BTreeMap<String, Mark>) -> Coordinate {
    match declared {
        Declared::Position { point, axis, negative, .. } => Coordinate::Position {
            at: marks[point].into(),
            axis: *axis,
            sign: if *negative { -1.0 } else { 1.0 },
        },
        Declared::Angle { bar, origin: Origin::Bar(other), .. } => {
            Coordinate::Angle { terms: vec![(*bar, 1.0), (*other, -1.0)], offset: 0.0 }
        }
        Declared::Angle { bar, origin, .. } => {
            let (base, sign) = counted(scheme, *bar, origin);
            Coordinate::Angle { terms: vec![(*bar, sign)], offset: sign * base }
        }
    }
}

/// The declared ties, and their images where there is a mirror.
fn ties(scheme: &Scheme) -> Vec<AngleTie> {
    let declared: Vec<_> = scheme.ties.iter().map(|&tie| self::tie(scheme, tie)).collect();
    let images = scheme.mirror.iter().flat_map(|mirror| {
        declared.iter().map(|tie| AngleTie {
            terms: tie.terms.iter().map(|&(body, c)| (body + mirror.half, -c)).collect(),
            value: tie.value - tie.terms.iter().map(|(_, c)| c * mirror.angle(0.0)).sum::<f64>(),
        })
    });
    declared.iter().cloned().chain(images).collect()
}

fn tie(scheme: &Scheme, tie: Tie) -> AngleTie {
    let angle = |index: usize| match coordinate(scheme, &scheme.coordinates[index], &BTreeMap::new()) {
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
