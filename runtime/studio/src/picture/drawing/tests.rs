//! Drawings of small models.

use super::*;
use crate::models;
use crate::registry::Models;
use crate::run_spec::RunSpec;
use liftoff::prelude::*;

/// A bar over a corner, on a spring and a thread over a peg.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[mass(B, m)]
#[ground(O = (0, 2 * l))]
#[ground(C = (l, 2 * l))]
#[spring(AC, stiffness = k, damping = c)]
#[thread(rope = B -> O -> A, length = 9 * l)]
#[support(P = corner(0, 0), under = AB)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Hung {
    m: f64,
    l: f64,
    k: f64,
    c: f64,
    g: f64,
}

/// A ladder between a floor and a wall.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
struct Ladder {
    m: f64,
    l: f64,
    g: f64,
}

/// Two legs with shins on a floor, each with a name of its own, as a walker has.
#[derive(BarSystem)]
#[bar(left_thigh = H -> K, mass = m, length = l)]
#[bar(right_thigh = H -> J, mass = m, length = l)]
#[bar(left_shin = K -> P, mass = m, length = l)]
#[bar(right_shin = J -> Q, mass = m, length = l)]
#[support(P = floor)]
#[support(Q = floor)]
#[figure(H = (0, 9 * l / 5), K = (-3 * l / 5, l), J = (3 * l / 5, l), P = (-3 * l / 5, 0), Q = (3 * l / 5, 0))]
#[coordinate(theta_left = angle(left_thigh), from = right)]
#[coordinate(theta_right = angle(right_thigh), from = right)]
#[coordinate(theta_left_shin = angle(left_shin), from = left)]
#[coordinate(theta_right_shin = angle(right_shin), from = left)]
#[coordinate(x = x(H))]
#[coordinate(y = y(H))]
struct Legs {
    m: f64,
    l: f64,
}

fn configuration(models: &Models, name: &str, spec: &RunSpec) -> Configuration {
    models.find(name).unwrap().configuration(spec).unwrap()
}

fn hung(l: f64) -> Configuration {
    let parameters = [("m", 1.0), ("l", l), ("k", 5.0), ("c", 1.0), ("g", 9.81)];
    configuration(&models![Hung], "hung", &RunSpec::with(&parameters))
}

fn ladder() -> Configuration {
    configuration(&models![Ladder], "ladder", &RunSpec::with(&[("m", 1.0), ("l", 2.0), ("g", 9.81)]))
}

fn drafted(configuration: &Configuration) -> (Vec<PlacedLabel>, Box2) {
    let mut draft = Draft::new(configuration);
    draft.all();
    let labels = placed(&draft.canvas);
    let area = draft.extent(&labels);
    (labels, area)
}

#[test]
fn no_word_lies_over_another() {
    for configuration in [hung(1.0), ladder()] {
        let (labels, _) = drafted(&configuration);
        for (i, a) in labels.iter().enumerate() {
            assert!(labels[..i].iter().all(|b| !a.area.overlaps(b.area)), "{:?}", a.text);
        }
    }
}

/// No word over another, none farther from what it names than the ring that a crossed line costs.
#[test]
fn words_stand_beside_what_they_name() {
    let legs = configuration(&models![Legs], "legs", &RunSpec::with(&[("m", 1.0), ("l", 1.0)]));
    let mut draft = Draft::new(&legs);
    draft.all();
    let labels = placed(&draft.canvas);
    for (i, (label, placement)) in labels.iter().zip(&draft.canvas.placements).enumerate() {
        assert!(labels[..i].iter().all(|other| !label.area.overlaps(other.area)), "{:?}", label.text);
        let away = |spot: &Spot| {
            let reach = |axis: usize| {
                (label.area.least[axis] - spot.at[axis]).max(spot.at[axis] - label.area.most[axis]).max(0.0)
            };
            reach(0).hypot(reach(1))
        };
        let nearest = placement.at.iter().map(away).fold(f64::INFINITY, f64::min);
        assert!(nearest < 40.0, "{:?} is {nearest} away", label.text);
    }
    let svg = drawing(&legs);
    assert!(svg.contains(">left shin</tspan>") && !svg.contains("left_shin<"), "{svg}");
}

#[test]
fn what_is_declared_is_named() {
    let svg = drawing(&hung(1.0));
    for word in [">A<", ">B<", ">O<", ">φ<", ">x<", ">y<", ">l<", "> = 1 m<", ">k<", ">g<"] {
        assert!(svg.contains(word), "{word}");
    }
}

/// The drawing shows proportions: only the words tell the unit.
#[test]
fn the_unit_of_length_changes_only_the_value() {
    let value = |text: &str| text.replace("> = 1000 m<", "> = 1 m<");
    let shape = |svg: String| svg.lines().filter(|line| !line.starts_with("<text")).collect::<String>();
    let (small, large) = (drawing(&hung(1.0)), value(&drawing(&hung(1000.0))));
    assert!(large.contains("> = 1 m<"));
    assert_eq!(small.lines().count(), large.lines().count());
    let lines = |svg: &str| svg.matches("<polyline").count();
    assert_eq!(lines(&small), lines(&large));
    assert!(shape(small).len().abs_diff(shape(large).len()) < 400, "wider words move the edges only");
}

#[test]
fn neither_floor_nor_wall_goes_beyond_their_corner() {
    let configuration = ladder();
    let mut draft = Draft::new(&configuration);
    draft.supports();
    let corner = draft.frame.px([0.0, 0.0]);
    let edges: Vec<Vec<Px>> = draft
        .canvas
        .shapes
        .iter()
        .map(canvas::Shape::outline)
        .filter(|line| plane::distance(line[0], line[1]) > 50.0)
        .collect();
    assert_eq!(edges.len(), 2);
    for edge in edges {
        assert!(edge.iter().any(|end| plane::distance(*end, corner) < 0.1), "{edge:?}");
    }
}

/// A wheel on a floor.
#[derive(BarSystem)]
#[gravity(g)]
#[body(wheel, points(H = (0, 0), G = (0, r / 2)), mass = m, inertia = m * r * r, centre = (0, 0))]
#[disc(H, radius = r)]
#[support(H = floor, rough)]
#[figure(H = (0, r), G = (0, 3 * r / 2))]
#[coordinate(phi = angle(wheel), from = right)]
#[coordinate(x = x(H))]
#[coordinate(y = y(H))]
struct Wheel {
    m: f64,
    r: f64,
    g: f64,
}

/// The rim is a circle that stands on the floor, with a stroke to its centre; its radius is told,
/// and all of it is seen.
#[test]
fn a_wheel_stands_on_its_rim() {
    let spec = RunSpec::with(&[("m", 1.0), ("r", 0.25), ("g", 9.81)]);
    let wheel = configuration(&models![Wheel], "wheel", &spec);
    let mut draft = Draft::new(&wheel);
    draft.all();
    let circles = draft.canvas.shapes.iter().filter_map(|shape| match shape.form {
        canvas::Form::Circle(centre, radius) => Some((centre, radius)),
        _ => None,
    });
    let (centre, radius) = circles.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
    assert!(plane::distance(centre, draft.frame.px([0.0, 0.25])) < 1e-9);
    assert!((centre[1] + radius - draft.frame.px([0.0, 0.0])[1]).abs() < 1e-9);
    assert!(
        draft.frame.area.least[0] <= centre[0] - radius && centre[0] + radius <= draft.frame.area.most[0]
    );
    let spoke = |line: &[Px]| {
        let at_centre = plane::distance(line[0], centre) < 1e-9;
        at_centre && line.len() == 2 && (plane::distance(line[0], line[1]) - radius).abs() < 1e-9
    };
    assert!(draft.canvas.shapes.iter().any(|shape| spoke(&shape.outline())));
    assert!(drawing(&wheel).contains("> = 0.25 m<"));
}
