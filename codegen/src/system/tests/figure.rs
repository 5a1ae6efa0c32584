//! The figure that is completed, and the signs and sides that it decides.

use super::{messages, point, resolve, text, write_position};
use crate::system::{CoordinateKind, OneSided, Reference, System};

const PINNED: &str = "#[gravity(g)] #[mass(A, a)] #[pin(A = (0, 0))] #[bar(AB, mass = m, length = l)]";

fn angle(attributes: &str) -> (i64, i8) {
    let system = resolve(attributes).unwrap();
    let CoordinateKind::Angle { reference: Reference::Ground(from), sign, .. } = &system.coordinates[0].kind
    else {
        panic!()
    };
    (from.quarter_turns().into(), *sign)
}

fn facing(attributes: &str) -> u8 {
    let system = resolve(attributes).unwrap();
    let OneSided::Line { direction, .. } = &system.supports[0].contact else { panic!() };
    direction.quarter_turns()
}

#[test]
fn bars_hang_along_gravity_or_lie_to_the_right() {
    assert_eq!(write_position(&resolve(PINNED).unwrap(), "B"), "0, −l");
    let sideways = PINNED.replace("gravity(g)", "gravity(g, 0)");
    assert_eq!(write_position(&resolve(&sideways).unwrap(), "B"), "l, 0");
    let oblique = PINNED.replace("gravity(g)", "gravity(g, g)");
    assert_eq!(write_position(&resolve(&oblique).unwrap(), "B"), "l, 0");
    let from_its_end = PINNED.replace("AB", "BA");
    assert_eq!(write_position(&resolve(&from_its_end).unwrap(), "B"), "0, −l");
}

#[test]
fn two_points_of_a_bar_place_the_others() {
    let attributes = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[point(G = AB, at = (l / 2, a))] \
                      #[bar(GH, mass = m, length = l)] #[figure(A = (0, 0), B = (0, l), H = (l, l))]";
    // Up the y axis, the left of the bar is −x.
    assert_eq!(write_position(&resolve(attributes).unwrap(), "G"), "−a, ½ l");
    let from_within = attributes.replace("B = (0, l)", "G = (-a, l / 2)");
    let system = resolve(&from_within).unwrap();
    let b = &system.figure[point(&system, "B")];
    let values = [1.3, 0.7, 9.81, 0.4];
    assert!(system.parameter_value(&b[0], &values).abs() < 4.0 * f64::EPSILON);
    assert!((system.parameter_value(&b[1], &values) - 0.7).abs() < 4.0 * f64::EPSILON);
}

#[test]
fn chains_are_bars_and_points_in_order() {
    let attributes = "#[gravity(g)] #[mass(E, a)] #[chain(c, links = 3, from = O, to = E, mass = m, length = l)] \
                      #[pin(O = (0, 0))]";
    let system = resolve(attributes).unwrap();
    let bodies: Vec<&str> = system.bodies.iter().map(|body| body.name.as_str()).collect();
    let points: Vec<&str> = system.points.iter().map(|point| point.name.as_str()).collect();
    assert_eq!(bodies, ["c1", "c2", "c3"]);
    assert_eq!(points, ["O", "c_1", "c_2", "E"]);
    assert_eq!(system.points[1].on.iter().map(|(body, _)| *body).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(write_position(&system, "E"), "0, −3 l");
    assert_eq!(text(&system, &system.bodies[2].inertia), "¹⁄₁₂ m l²");
}

#[test]
fn an_angle_from_a_line_is_acute_and_positive_in_the_figure() {
    let ends = [
        ("(l, a)", (0, 1)),
        ("(-l, a)", (2, -1)),
        ("(-l, -a)", (2, 1)),
        ("(l, -a)", (0, -1)),
        ("(l, 0)", (0, 1)),
    ];
    for (end, expected) in ends {
        let given =
            format!("{PINNED} #[figure(B = {end})] #[coordinate(phi = angle(AB), from = horizontal)]");
        assert_eq!(angle(&given), expected, "{end}");
    }
    let upright = format!("{PINNED} #[figure(B = (a, l))] #[coordinate(phi = angle(AB), from = vertical)]");
    assert_eq!(angle(&upright), (1, -1));
}

/// With every parameter 1 the bar is upright, or is not there.
#[test]
fn signs_and_sides_hold_wherever_the_figure_can_be_drawn() {
    let phi = "#[coordinate(phi = angle(AB), from = horizontal)]";
    let bar = "#[gravity(g)] #[mass(A, m)] #[bar(AB, mass = m, length = l)]";
    let ladder = format!("{bar} #[figure(A = (sqrt(l * l - a * a), 0), B = (0, a))]");
    assert_eq!(angle(&format!("{ladder} {phi}")), (2, -1));
    assert_eq!(facing(&format!("{ladder} #[support(B = wall(0))]")), 3);
    let steep = format!("{bar} #[figure(A = (sqrt(l * l - 4 * a * a), 0), B = (0, 2 * a))]");
    assert_eq!(angle(&format!("{steep} {phi}")), (2, -1));
    let rod = "#[gravity(g)] #[bar(OA, mass = m, length = a)] #[bar(AB, mass = m, length = l)] \
               #[pin(O = (0, 0))] #[figure(A = (0, a), B = (sqrt(l * l - a * a), 0))]";
    assert_eq!(angle(&format!("{rod} {phi}")), (0, -1));
    assert_eq!(facing(&format!("{rod} #[support(B = wall(0))]")), 3);
    // A wall whose place needs constants that the figure does not.
    assert_eq!(facing(&format!("{rod} #[support(B = wall(-(g / (g + 1)) * sin(0.7)))]")), 3);
}

#[test]
fn ambiguous_figures_must_be_declared() {
    let bar =
        "#[gravity(g)] #[mass(A, a)] #[bar(AB, mass = m, length = l)] #[figure(A = (l, 0), B = (a, m))]";
    let told = |rest: &str| messages(&format!("{bar} {rest} struct S {{ m: f64, l: f64, g: f64, a: f64 }}"));
    assert_eq!(
        told("#[coordinate(phi = angle(AB), from = horizontal)]"),
        [
            "the sign of `phi` is another for other parameters; measure it from a direction: `from = right`, `up`, \
          `left` or `down`"
        ]
    );
    assert_eq!(
        told("#[support(B = wall(m))]"),
        ["the side of this wall on which the figure lies depends on the parameters; say its free side: \
          `facing = left` or `right`"]
    );
    assert_eq!(told("#[support(B = wall(m), facing = left)]"), [""; 0]);
}

#[test]
fn an_angle_from_a_direction_needs_no_figure() {
    assert_eq!(angle(&format!("{PINNED} #[coordinate(phi = angle(AB), from = down)]")), (3, 1));
    assert_eq!(angle(&format!("{PINNED} #[coordinate(phi = -angle(AB))]")), (0, -1));
}

#[test]
fn a_wall_is_free_towards_the_figure() {
    let bar = "#[gravity(g)] #[mass(A, a)] #[bar(AB, mass = m, length = l * sqrt(2))]";
    let wall = "#[support(B = wall(0))]";
    // Facing right is a line downwards, its normal a quarter turn counter-clockwise.
    assert_eq!(facing(&format!("{bar} #[figure(A = (l, 0), B = (0, l))] {wall}")), 3);
    assert_eq!(facing(&format!("{bar} #[figure(A = (-l, 0), B = (0, l))] {wall}")), 1);
    assert_eq!(facing(&format!("{bar} #[figure(A = (l, 0), B = (-a, l))] {wall}")), 1);
    let given = "#[support(B = wall(0), facing = left)]";
    assert_eq!(facing(&format!("{bar} #[figure(A = (l, 0), B = (0, l))] {given}")), 1);
}

#[test]
fn the_side_of_a_corner_follows_the_drawn_bar() {
    let side = |bar: &str, option: &str| -> i8 {
        let attributes = format!(
            "#[gravity(g)] #[mass(A, a)] #[bar({bar}, mass = m, length = l)] #[figure(A = (-l, 0), D = (0, 0))] \
             #[support(P = corner(-l / 2, 0), {option})]"
        );
        let system: System = resolve(&attributes).unwrap();
        let OneSided::Corner { side, .. } = system.supports[0].contact else { panic!() };
        side
    };
    assert_eq!(side("AD", "under = AD"), 1);
    assert_eq!(side("DA", "under = DA"), -1);
    assert_eq!(side("AD", "over = AD"), -1);
}

#[test]
fn what_depends_on_a_place_that_is_not_given_demands_it() {
    let needed =
        |rest: &str| messages(&format!("{PINNED} {rest} struct S {{ m: f64, l: f64, g: f64, a: f64 }}"));
    assert_eq!(
        needed("#[coordinate(phi = angle(AB), from = horizontal)]"),
        ["point `B` is needed in `#[figure(…)]`: the sign of `phi` depends on it"]
    );
    assert_eq!(
        needed("#[support(B = wall(0))] #[support(Q = corner(0, 0), under = AB)]"),
        ["point `B` is needed in `#[figure(…)]`: support `B` is under it"]
    );
    assert_eq!(
        needed("#[bar(BC, mass = m, length = l)] #[pin(C = (l, 0))]"),
        ["point `B` is needed in `#[figure(…)]`: there is more than one way to close the loop"]
    );
}

/// Bars that do not reach from pin to pin, and one longer than the others of its loop, by what the
/// inequality of triangles has.
#[test]
fn a_loop_that_cannot_close_is_reported_with_what_it_lacks() {
    let told = |attributes: &str| messages(&format!("#[gravity(9.81)] {attributes} struct S {{ m: f64 }}"));
    let bars =
        "#[bar(OA, mass = m, length = 1)] #[bar(AB, mass = m, length = 1)] #[bar(CB, mass = m, length = 1)]";
    let pins = "#[pin(O = (0, 0))] #[pin(C = (4, 0))] #[figure(A = (1, 0.5), B = (3, 0.5))]";
    let text = "the loop O–A–B–C cannot close: `O` and `C` are 4 apart, and the way between them is 3 long (with \
                parameters near 1): it lacks 1";
    assert_eq!(told(&format!("{bars} {pins}")), [text]);
    let bars = "#[bar(OA, mass = m, length = 1)] #[bar(AB, mass = m, length = 4.5)] #[bar(OB, mass = m, length = 2)]";
    let text = "the loop A–O–B cannot close: `A` and `B` are 4.5 apart, and the way between them is 3 long (with \
                parameters near 1): it lacks 1.5";
    assert_eq!(told(&format!("{bars} #[pin(O = (0, 0))] #[figure(A = (1, 0), B = (0, 2))]")), [text]);
}

/// Both lengths are told of a bar whose ends the figure puts somewhere else with any parameters;
/// one drawn roughly, or with numbers that fit some parameters, is as good as before.
#[test]
fn a_figure_that_contradicts_a_length_is_refused() {
    let told = |figure: &str| {
        let bar = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[pin(A = (0, 0))] #[mass(A, a)]";
        messages(&format!("{bar} #[figure(B = {figure})] struct S {{ m: f64, l: f64, g: f64, a: f64 }}"))
    };
    let text = "the figure draws bar `AB` 2 long, and its length is 1 (with parameters near 1); move `A` or `B` in \
                `#[figure(…)]`";
    assert_eq!(told("(0, -2 * l)"), [text]);
    for figure in ["(0, -l)", "(0.72 * l, 0.7 * l)", "(0.6, 0.8)", "(0, -2)"] {
        assert!(
            told(figure).iter().all(|message| !message.contains("draws")),
            "{figure}: {:?}",
            told(figure)
        );
    }
}
