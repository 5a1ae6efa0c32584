//! Conditions by the polynomials of a step, against closed forms.

use super::super::EventDetector;
use super::given::*;
use crate::expression::Variable;
use crate::model::ContactSet;

const STEPS: [&[f64]; 3] = [&[1.0], &[0.41, 1.0], &[0.25, 0.5, 0.75, 1.0]];

/// When a condition on s = t becomes true, a polynomial of each step.
fn met(text: &str, is_state: bool, steps: &[f64]) -> Option<f64> {
    let scene = Scene::closed(ContactSet::EMPTY, |t| Shown { z: [(3.0 * t).sin(), 0.0], ..Shown::default() });
    let conditions = [scene.condition(text)];
    let mut detector: EventDetector<'_> = scene.begun(waits(), (&conditions, is_state));
    let (first, _) = scene.follow_by(|view| view.with_series(None), &mut detector, steps).expect("followed");
    first.map(|(t, _)| t)
}

#[test]
fn conditions_on_polynomials_are_met_where_they_become_true() {
    let root = 0.12_f64.sqrt();
    for (text, at) in [
        ("s = 0.35", Some(0.35)),
        ("s > 0.35", Some(0.35)),
        ("0.35 < s", Some(0.35)),
        ("s < 0.35", None),
        ("s = 1.5", None),
        ("s = 1", Some(1.0)),
        ("t = 0.35", Some(0.35)),
        ("t + 2*s > 0.6", Some(0.2)),
        ("s*(s - 0.7) > 0", Some(0.7)),
        ("s*(s - 0.7) = 0", Some(0.7)),
        ("(s - 0.2)*(s - 0.7) < 0", Some(0.2)),
        ("(s - 0.2)*(0.7 - s) < 0", Some(0.7)),
        ("(s - 0.2)*(0.7 - s) > 0", Some(0.2)),
        ("s^2 = 0.12", Some(root)),
        ("s > 0", Some(0.0)),
        ("s < 0", None),
        ("s = 0", None),
        // The rate is one.
        ("s' = 0.5", None),
        ("s' > s + 0.6", None),
        ("s' < s + 0.6", Some(0.4)),
        // By values and bounds: neither has a series that tells of all of the step.
        ("abs(s - 0.5) = 0.15", Some(0.35)),
        ("abs(s - 0.5) < 0.15", Some(0.35)),
        ("abs(s - 0.5) > 0.15", Some(0.65)),
        ("1/(s + 0.5) = 1.25", Some(0.3)),
        ("1/(s + 0.5) < 1.25", Some(0.3)),
        // At a seam of the pieces that bounds are taken of.
        ("sqrt(s) > 0.5", Some(0.25)),
        ("sqrt(1 - s) < 0.5", Some(0.75)),
        ("sqrt(s) < 0.5", None),
        ("abs(s - 0.5) < 0.25", Some(0.25)),
        ("abs(s - 0.5) > 0.25", Some(0.75)),
        ("1/(s + 0.5) < 1", Some(0.5)),
        ("-1/(s + 0.5) > -1", Some(0.5)),
        ("1/(s + 0.5) = 1", Some(0.5)),
        ("1/(s + 0.5) > 1", None),
        ("tan(s) > t + 0.05", None),
        ("z > 0.5 + 0*s", Some(core::f64::consts::PI / 18.0)),
    ] {
        for steps in STEPS {
            let found = met(text, false, steps);
            let near = match (found, at) {
                (Some(found), Some(at)) => (found - at).abs() < 1e-13,
                (found, at) => found == at,
            };
            assert!(near || text.starts_with("tan"), "`{text}` {steps:?}: {found:?} for {at:?}");
        }
    }
    // tan x = x + 1/20 by bisection.
    let (mut low, mut high) = (0.0_f64, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *(if middle.tan() < middle + 0.05 { &mut low } else { &mut high }) = middle;
    }
    for steps in STEPS {
        assert!(
            met("tan(s) > t + 0.05", false, steps).is_some_and(|at| (at - low).abs() < 1e-12),
            "{steps:?}"
        );
    }
}

/// Whether an equality is met is undecided where its sides come within a millionth of the larger
/// one, at the ends of the step: of 50/4. Equal but for rounding they are equal.
#[test]
fn a_near_miss_of_a_polynomial_is_undecided() {
    for (text, is_undecided) in [
        ("50*(s - 0.5)^2 = -0.000012", true),
        ("50*(s - 0.5)^2 = -0.000013", false),
        ("-50*(s - 0.5)^2 = 0.000012", true),
        ("-50*(s - 0.5)^2 = 0.000013", false),
        ("0.5*(s - 0.5)^2 = -0.00000012", true),
        ("0.5*(s - 0.5)^2 = -0.00000013", false),
        ("50*(s - 0.5)^2 = -1e-13", true),
    ] {
        let scene = Scene::closed(ContactSet::EMPTY, |_| Shown::default());
        let conditions = [scene.condition(text)];
        let mut detector: EventDetector<'_> = scene.begun(waits(), (&conditions, false));
        let found = scene.follow_by(|view| view.with_series(None), &mut detector, &[1.0]).expect("followed");
        assert!(found.0.is_none(), "{text}");
        assert_eq!(detector.undecided().is_some(), is_undecided, "{text}");
        assert!(detector.undecided().is_none_or(|at| (at - 0.5).abs() < 1e-12), "{text}");
        assert_eq!(met(&text.replace('=', "<"), false, &[1.0]), None, "{text}");
    }
    assert!(met("50*(s - 0.5)^2 = 0", false, &[1.0]).is_some_and(|at| (at - 0.5).abs() < 1e-7));
}

/// In other units the time of a step, and a coordinate, have the same polynomial, and the same
/// error of it.
#[test]
fn polynomials_of_a_step_have_their_unit() {
    let scene = Scene::closed(ContactSet::EMPTY, |_| Shown::default());
    let told = |variable: Variable, unit: f64| {
        let dense = scene.dense([-0.7, 2.1].map(|t| unit * t));
        let view = scene.view(&dense).with_series(None);
        let smooth = view.polynomial(variable).expect("a line").expect("finite");
        [[0.3; 2], [0.25, 0.75]].map(|piece| smooth.value(piece))
    };
    for variable in [Variable::Time, Variable::Coordinate { index: 0, order: 0 }] {
        let [at, over] = told(variable, 1.0);
        assert!((at.0 + 0.7 - 0.3 * 2.8).abs() < 1e-15 && (over.0 - 0.7).abs() < 1e-15);
        // Rounding, and the slope over half of the piece.
        assert!(at.1 > 4.0 * f64::EPSILON && at.1 < 1e-13 && (over.1 - 0.25 * 2.8).abs() < 1e-13);
        for unit in [-40, -20, 20, 40].map(|k| f64::powi(2.0, k)) {
            let scaled = [at, over].map(|(value, reach)| (unit * value, unit * reach));
            assert_eq!(told(variable, unit), scaled, "{unit}");
        }
    }
    let dense = scene.dense([0.0, 1.0]);
    let view = scene.view(&dense).with_series(None);
    for other in [Variable::Coordinate { index: 1, order: 0 }, Variable::Coordinate { index: 0, order: 1 }] {
        assert!(view.polynomial(other).is_none(), "the step has only the coordinate s");
    }
}
