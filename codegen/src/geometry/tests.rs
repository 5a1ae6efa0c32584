//! Kinds and the forms that they become.

use super::{DrawnDirection, DrawnReading, DrawnShape, Geometry, Look, Solid, Spot, Value};
use crate::algebra::{Series, Symbol};
use crate::kinematics::Kinematics;
use crate::resolve;
use crate::system::System;

fn geometry(declaration: &str) -> (System, Geometry) {
    let system = resolve(declaration.parse().unwrap()).unwrap();
    let coordinates = Kinematics::derive(&system).unwrap().coordinates;
    let geometry = Geometry::from_system(&system, &coordinates);
    (system, geometry)
}

const ELBOW: &str = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = l / 2)] \
    #[bar(CD, mass = m, length = 2)] #[weld(AB, BC)] #[pin(A = (0, 0))] #[ground(O = (l, 0))] #[mass(C, m)] \
    #[point(G = AB, at = l / 3)] #[spring(OC, stiffness = k, damping = 3)] #[torsion(AB, BC, damping = m)] \
    #[figure(B = (0, -l), C = (l / 2, -l), D = (l / 2 + 2, -l))] struct Elbow { m: f64, l: f64, k: f64, g: f64 }";

/// Marks tell a foot from the ground, and a joint that turns from one that does not.
#[test]
fn joints_are_marked_by_what_they_hold() {
    let (system, geometry) = geometry(ELBOW);
    let marks = |name: &str| {
        let point = system.points.iter().position(|point| point.name == name).unwrap();
        let marks = geometry.marks.iter().filter(|(on, _)| *on == point);
        marks.map(|(_, look)| *look).collect::<Vec<_>>()
    };
    assert_eq!(marks("A"), [Look::Foot, Look::Ring]);
    assert_eq!(marks("B"), [Look::Disc]);
    assert_eq!(marks("C"), [Look::Mass, Look::Ring]);
    assert_eq!(marks("O"), [Look::Ring, Look::Ground]);
    assert!(marks("D").is_empty() && marks("G").is_empty());
    assert_eq!(geometry.bodies[0].inner.len(), 1);
}

/// Plain numbers have no name in a drawing; lengths are written once.
#[test]
fn texts_are_formulas() {
    let (_, geometry) = geometry(ELBOW);
    let texts: Vec<&str> = geometry.lengths.iter().map(|length| length.text.as_str()).collect();
    assert_eq!(texts, ["l", "½ l", ""]);
    assert_eq!(geometry.springs[0].text, "k");
    assert!(geometry.springs[0].coil && geometry.springs[0].dashpot);
    assert!(matches!(geometry.spirals[..], [(1, DrawnDirection::Towards(Spot::Point(1), Spot::Point(2)))]));
}

/// A line of the ground is seen, the axis of a bar is a bar already; both have a block.
#[test]
fn guides_are_lines_and_blocks() {
    let (system, geometry) = geometry(
        "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(CD, mass = m, length = l)] #[pin(C = (l, 0))] \
         #[slider(A = line(pi / 6))] #[slider(D = bar(AB))] \
         #[figure(A = (0, 0), B = (4 / 5 * l, 3 / 5 * l), D = (l / 4, 2 * l / 3))] \
         struct Guided { m: f64, l: f64, g: f64 }",
    );
    assert_eq!(geometry.blocks.len(), system.sliders.len());
    let [(_, DrawnDirection::Fixed(angle)), (_, DrawnDirection::Towards(..))] = geometry.blocks[..] else {
        panic!("{:?}", geometry.blocks)
    };
    let line = |shape: &DrawnShape| matches!(shape, DrawnShape::Line { angle: same, solid: false } if *same == angle);
    assert!(matches!(&geometry.fixtures[..], [fixture] if line(&fixture.shape)));
    assert!(geometry.pushes.is_empty());
}

/// A body whose first two points are not along its first axis keeps the step between them.
#[test]
fn a_body_is_turned_as_its_frame() {
    let (system, geometry) = geometry(
        "#[gravity(g)] #[body(hull, points(A = (0, 0), B = (l, l), C = (0, l)), mass = m)] \
         #[bar(CD, mass = m, length = l * sqrt(5) / 2)] #[figure(A = (0, 0), B = (l, l), C = (0, l), D = (l, l / 2))] \
         #[coordinate(phi = angle(hull))] #[coordinate(psi = angle(CD), from = hull)] \
         struct Hull { m: f64, l: f64, g: f64 }",
    );
    let axes = geometry.readings.iter().filter_map(|reading| match reading {
        DrawnReading::Angle { from: DrawnDirection::Axis([0, 1], step), .. } => Some(*step),
        _ => None,
    });
    let l = system.parameters.iter().position(|name| name == "l").map(Symbol::parameter).unwrap();
    let steps: Vec<_> = axes.map(|step| step.map(|i| geometry.numbers.0[i].clone())).collect();
    assert_eq!(steps, [[(); 2].map(|()| Value::Length(Series::symbol(l)))]);
}

/// A thread pulls at both of its ends, and what it passes over is a peg.
#[test]
fn threads_pull_at_their_ends() {
    let (_, geometry) = geometry(
        "#[gravity(g)] #[particle(P, mass = m)] #[particle(Q, mass = m)] #[ground(O = (0, 0))] \
         #[thread(rope = P -> O -> Q, length = 4 * l)] #[figure(P = (-l, -l), Q = (l, -l))] \
         struct Mobile { m: f64, l: f64, g: f64 }",
    );
    let ends = geometry.pushes.iter().map(|push| (push.at, push.along, push.turns, push.slip));
    let ends: Vec<_> = ends.map(|end| format!("{end:?}")).collect();
    let [p, q, o] = geometry.threads[0].path[..].try_into().map(|[p, o, q]: [usize; 3]| [p, q, o]).unwrap();
    let end = |end| {
        let [at, over] = [end, o].map(Spot::Point);
        format!("{:?}", (at, DrawnDirection::Towards(at, over), 0, 0))
    };
    assert_eq!(ends, [end(p), end(q)]);
    assert!(geometry.marks.contains(&(o, Look::Peg)) && geometry.marks.contains(&(o, Look::Ring)));
    assert!(!geometry.marks.contains(&(o, Look::Ground)));
}

/// A disc turns with its body, a particle's does not; circles about points are drawn once for all
/// they carry, and what touches with a rim is pushed there. A circular guide is a line, a bowl is
/// not.
#[test]
fn discs_are_circles_about_points() {
    let (system, geometry) = geometry(
        "#[gravity(g)] #[bar(AB, mass = m, length = 3 * r)] #[disc(A, radius = r)] #[support(A = floor)] \
         #[particle(P, mass = m)] #[disc(P, radius = r / 2)] #[slider(P = circle((9 * r, 0), r))] \
         #[particle(Q, mass = m)] #[support(Q = circle(B, r / 4))] #[support(q = circle(B, r / 4), under = P)] \
         #[support(p = bowl((0, 0), 30 * r), under = Q)] \
         #[figure(A = (0, r), B = (3 * r, r), P = (10 * r, 0), Q = (6 * r, 0))] struct Rims { m: f64, r: f64, g: f64 }",
    );
    let point = |name: &str| system.points.iter().position(|point| point.name == name).unwrap();
    let [a, b, p] = ["A", "B", "P"].map(point);
    let rounds = geometry.rounds.iter();
    let rounds: Vec<_> =
        rounds.map(|round| (round.centre, round.text.as_str(), round.along.is_some())).collect();
    assert_eq!(rounds, [(a, "r", true), (p, "½ r", false), (b, "¼ r", true)]);
    assert!(geometry.rounds.iter().all(|round| round.solid == Solid::Within));
    let rim = |support: &str| geometry.pushes.iter().find(|push| push.support == support).unwrap().rim;
    assert_eq!((rim("A"), rim("q")), (Some(geometry.rounds[0].radius), Some(geometry.rounds[1].radius)));
    assert_eq!((rim("Q"), rim("p")), (None, None));
    let solids = geometry.fixtures.iter().filter_map(|fixture| match fixture.shape {
        DrawnShape::Circle { solid, .. } => Some(solid),
        _ => None,
    });
    assert_eq!(solids.collect::<Vec<_>>(), [Solid::Around, Solid::Nowhere]);
}
