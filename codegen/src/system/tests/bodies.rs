//! Bodies of any shape, particles and fixed points.

use super::{messages, point, resolve, text, write_position};

const HULL: &str = "#[gravity(g)] #[body(hull, points(A = (0, 0), B = (l, 0), C = (0, a)), mass = m)]";
const STRUCT: &str = "struct S { m: f64, l: f64, g: f64, a: f64 }";

fn find_mistakes(attributes: &str) -> Vec<String> {
    messages(&format!("{attributes} {STRUCT}"))
}

#[test]
fn a_uniform_triangle_has_its_centre_at_the_mean_of_its_corners() {
    let system = resolve(&format!("{HULL} #[figure(A = (0, 0), B = (l, 0))]")).unwrap();
    let hull = &system.bodies[0];
    assert_eq!(hull.centre.each_ref().map(|c| text(&system, c)), ["⅓ l", "⅓ a"]);
    // Sides l, a and √(l² + a²), so I = m (l² + a²)/18; by parallel axes from the corner's m (l² +
    // a²)/6.
    let [m, l, g, a] = [1.3, 0.7, 9.81, 0.4];
    let inertia = system.parameter_value(&hull.inertia, &[m, l, g, a]);
    assert!((inertia - m * (l * l + a * a) * (1.0 / 6.0 - 1.0 / 9.0)).abs() < 1e-15);
    assert_eq!((hull.from, hull.to, hull.uniform), (0, 1, false));
    assert_eq!((&hull.outline[..], text(&system, &hull.length)), (&[0, 1, 2][..], "l".into()));
    assert_eq!(write_position(&system, "C"), "0, a");
}

#[test]
fn the_length_of_a_body_is_the_distance_of_its_first_two_points() {
    let length = |b: &str| {
        let attributes = format!(
            "#[gravity(g)] #[body(hull, points(A = (l, l), B = {b}), mass = m, inertia = a, centre = (0, 0))] \
             #[figure(A = (0, 0))]"
        );
        let system = resolve(&attributes).unwrap();
        text(&system, &system.bodies[0].length)
    };
    assert_eq!(length("(l, 3 * l)"), "2 l");
    assert_eq!(length("(-l, l)"), "2 l");
    assert_eq!(length("(l + 3, l + 4)"), "5");
    assert_eq!(length("(2 * l, l + a)"), "√(l² + a²)");
}

#[test]
fn bodies_are_placed_from_any_two_points() {
    let system =
        resolve(&format!("{HULL} #[point(G = hull, at = (l, a))] #[figure(C = (-a, 0), B = (0, l))]"));
    let system = system.unwrap();
    // A quarter turn counter-clockwise about A at the origin.
    assert_eq!([write_position(&system, "A"), write_position(&system, "G")], ["0, 0", "−a, l"]);
}

#[test]
fn a_body_held_at_one_point_hangs_with_its_centre_below() {
    let attributes = "#[gravity(g)] #[body(hull, points(A = (0, 0), B = (l, l)), mass = m, inertia = a, \
                      centre = (0, 0))] #[pin(B = (l, l))]";
    let system = resolve(attributes).unwrap();
    // The centre, A, lies at (−1, −1) l from B on the body, at (0, −√2) l when it hangs.
    let drawn = &system.figure[point(&system, "A")];
    let [x, y] = drawn.each_ref().map(|c| system.parameter_value(c, &[1.0; 4]));
    assert!((x - 1.0).abs() < 1e-15 && (y - 1.0 + 2.0_f64.sqrt()).abs() < 1e-15, "{x} {y}");
}

#[test]
fn directions_are_those_of_the_frame() {
    let attributes = "#[gravity(g)] #[body(hull, points(A = (0, 0), B = (0, l), C = (a, a)), mass = m)] \
                      #[figure(A = (0, 0), B = (l, 0))] #[coordinate(phi = angle(hull), from = vertical)]";
    let system = resolve(attributes).unwrap();
    let crate::system::CoordinateKind::Angle { reference, sign, .. } = &system.coordinates[0].kind else {
        panic!()
    };
    let crate::system::Reference::Ground(from) = reference else { panic!() };
    // AB points right, so the frame's first axis points down.
    assert_eq!((from.quarter_turns(), *sign), (3, 1));
}

#[test]
fn particles_and_fixed_points_belong_to_no_body() {
    let system = resolve(
        "#[gravity(g)] #[particle(P, mass = m)] #[ground(O = (0, l))] #[thread(rope = O -> P, length = a)] \
         #[figure(P = (0, 0))]",
    )
    .unwrap();
    let [p, o] = ["P", "O"].map(|name| point(&system, name));
    assert!(system.points[p].on.is_empty() && system.points[p].ground.is_none());
    assert_eq!((system.particles[0].point, text(&system, &system.particles[0].mass)), (p, "m".into()));
    assert!(system.points[o].on.is_empty() && system.points[o].ground.is_some());
    assert_eq!(write_position(&system, "O"), "0, l");
}

#[test]
fn mistakes_in_bodies_are_reported() {
    let figure = "#[figure(A = (0, 0), B = (l, 0))]";
    let cases = [
        (
            HULL.replace(", C = (0, a)", "").replace("(l, 0)", "(a, 0)"),
            "`hull` is no triangle, so its centre of mass and inertia are not known; add `inertia = …` and `centre = (x, y)`",
        ),
        (
            HULL.replace("(0, a)", "(2 * l + a, 0)"),
            "`hull` is no triangle, so its centre of mass and inertia are not known; add `inertia = …` and `centre = (x, y)`",
        ),
        (HULL.replace("C =", "B ="), "body `hull` has point `B` twice; remove one"),
        (
            HULL.replace("(0, a)", "(a - a, 0)")
                .replace("mass = m", "mass = m, inertia = a, centre = (0, 0)"),
            "points `A` and `C` of body `hull` are at one place",
        ),
        (
            format!("{HULL} #[bar(hull = A -> D, mass = m, length = l)]"),
            "bar `hull` is declared twice; remove one, or name it: `other = A -> D`",
        ),
        (
            format!("{HULL} #[support(P = corner(0, 0), under = hull)]"),
            "`hull` is no bar; a corner under a side of a body is a fixed point at it: `#[ground(P = (x, y))] #[support(P = edge(A, B))]`",
        ),
        (
            HULL.replace(", C = (0, a)", "").replace(", B = (l, 0)", ""),
            "a body needs two points or more (for example `#[body(hull, points(A = (0, 0), B = (l, 0), C = (l / 2, h)), mass = m)]`)",
        ),
    ];
    for (attributes, expected) in cases {
        let told = find_mistakes(&format!("{attributes} #[mass(A, a)] {figure}"));
        assert_eq!(told.first().map(String::as_str), Some(expected), "{attributes}: {told:?}");
    }
    assert_eq!(
        find_mistakes(&format!("{HULL} #[figure(A = (0, 0), B = (l, 0), C = (0, -a))]")),
        ["the figure draws body `hull` turned over, as in a mirror; list its points in the other direction"]
    );
}

#[test]
fn mistakes_in_free_points_are_reported() {
    let bar = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[mass(A, a)] #[figure(A = (0, 0))]";
    let cases = [
        ("#[particle(B, mass = m)]", "`B` is a point of `AB` already; give it a mass by `#[mass(B, …)]`"),
        ("#[ground(B = (0, 0))]", "`B` is a point of `AB` already; hold it by `#[pin(B = …)]`"),
        ("#[ground(O = (0, 0))] #[ground(O = (l, 0))]", "point `O` is declared twice; remove one"),
        (
            "#[ground(O = (0, 0))] #[figure(O = (l, 0))]",
            "`O` is fixed to another place than the figure says; leave it out of the figure",
        ),
        ("#[ground(O = (0, 0))] #[support(O = floor)]", "`O` is a fixed point; name one that moves"),
        ("#[particle(P, mass = -1)] #[figure(P = (0, 0))]", "the mass of `P` is -1; it cannot be negative"),
        ("#[particle(P, mass = m)]", "point `P` is needed in `#[figure(…)]`: nothing else says where it is"),
    ];
    for (attributes, expected) in cases {
        assert_eq!(find_mistakes(&format!("{bar} {attributes}")), [expected], "{attributes}");
    }
}
