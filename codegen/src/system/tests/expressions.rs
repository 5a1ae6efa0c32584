//! Expressions against the same arithmetic in `f64`: a dozen operations, so a few units in the last
//! place.

use super::{resolve, text};
use crate::algebra::Series;
use crate::system::{OneSided, System};

const VALUES: [f64; 4] = [1.3, 0.7, 9.81, 0.4];

/// The system in which the expression is a bar's inertia.
fn resolve_inertia(expression: &str) -> (System, Series) {
    let attributes = format!(
        "#[bar(AB, mass = m, length = l, inertia = {expression})] #[gravity(g)] #[mass(A, a)] #[pin(A = (0, 0))]"
    );
    let system = resolve(&attributes).unwrap();
    let inertia = system.bodies[0].inertia.clone();
    (system, inertia)
}

#[test]
fn values_are_those_of_the_same_arithmetic() {
    let [m, l, g, a] = VALUES;
    let cases: [(&str, f64); 13] = [
        ("m * l * l / 12", m * l * l / 12.0),
        ("-(m - 2 * l) + 0.125", -(m - 2.0 * l) + 0.125),
        ("2.5e-3 * m + 1e2", 2.5e-3 * m + 100.0),
        ("m / (m + l)", m / (m + l)),
        ("(m + l).powi(-2)", 1.0 / ((m + l) * (m + l))),
        ("l.powi(3)", l * l * l),
        ("sqrt(3) / 2 * l", 3.0_f64.sqrt() / 2.0 * l),
        ("1 / sqrt(m + a)", 1.0 / (m + a).sqrt()),
        ("sin(a) * cos(2 * a)", a.sin() * (2.0 * a).cos()),
        ("cos(pi / 6 - a)", (core::f64::consts::FRAC_PI_6 - a).cos()),
        ("sin(a / 3 + g * m)", (a / 3.0 + g * m).sin()),
        ("abs(l - 5 * m) * (-a).abs()", (l - 5.0 * m).abs() * a.abs()),
        ("pi * l.sqrt()", core::f64::consts::PI * l.sqrt()),
    ];
    for (expression, expected) in cases {
        let (system, series) = resolve_inertia(expression);
        let value = system.parameter_value(&series, &VALUES);
        assert!(
            (value - expected).abs() <= 8.0 * f64::EPSILON * expected.abs(),
            "{expression}: {value} {expected}"
        );
    }
}

#[test]
fn pi_is_the_nearest_double() {
    let (system, series) = resolve_inertia("pi");
    assert_eq!(system.parameter_value(&series, &VALUES), core::f64::consts::PI);
}

#[test]
fn equal_expressions_have_one_form() {
    let pairs = [
        ("sqrt(l * l - a * a) * sqrt(l * l - a * a)", "(l - a) * (l + a)"),
        ("sqrt(12)", "2 * sqrt(3)"),
        ("1 / sqrt(3)", "sqrt(3) / 3"),
        ("sqrt(9 / 4)", "1.5"),
        ("(m * m - l * l) / (m + l)", "m - l"),
        ("m / (2 * m + 2 * l)", "m / (m + l) / 2"),
        ("sin(a + pi / 2)", "cos(a)"),
        ("cos(3 * pi / 2 + a)", "sin(a)"),
        ("sin(-pi / 6)", "-sin(pi / 6)"),
        ("cos(5 * pi / 6)", "-cos(pi / 6)"),
    ];
    for (a, b) in pairs {
        let attributes = format!(
            "#[bar(AB, mass = m, length = l, inertia = {a}, centre = ({b}, 0))] #[gravity(g)] #[mass(A, a)] \
             #[pin(A = (0, 0))]"
        );
        let system = resolve(&attributes).unwrap();
        let body = &system.bodies[0];
        assert_eq!(body.inertia, body.centre[0], "{a}: {} is not {}", text(&system, &body.inertia), b);
    }
}

#[test]
fn named_constants_stand_for_their_values() {
    let attributes = "#[constant(h = l / 2)] #[constant(k = h + a)] #[bar(AB, mass = m, length = k)] \
                      #[gravity(g)] #[pin(A = (0, 0))]";
    let system = resolve(attributes).unwrap();
    assert_eq!(system.parameter_value(&system.bodies[0].length, &VALUES), 0.7 / 2.0 + 0.4);
    assert!(system.constants.is_empty());
}

#[test]
fn directions_of_slopes_are_exact_where_they_can_be() {
    let direction = |angle: &str| {
        let attributes = format!(
            "#[bar(AB, mass = m, length = l)] #[gravity(g)] #[mass(A, a)] #[figure(A = (0, 0))] \
             #[support(A = slope({angle}))]"
        );
        let system = resolve(&attributes).unwrap();
        let OneSided::Line { direction, .. } = system.supports[0].contact.clone() else { panic!() };
        (system, direction)
    };
    let (system, exact) = direction("pi - 2 * a");
    assert_eq!((exact.terms().len(), exact.quarter_turns(), system.constants.len()), (1, 2, 1));
    let (system, third) = direction("a / 3");
    let named = Series::symbol(third.terms()[0].0);
    assert_eq!(text(&system, &named), "a/3");
    assert_eq!(system.parameter_value(&named, &VALUES), 0.4 / 3.0);
}
