//! Least and greatest outputs beside closed forms: inside, at bounds, through events, and what is
//! refused.

use liftoff::__private::event::Occurrence;
use liftoff::EventFilter;
use liftoff::prelude::*;
use liftoff_analysis::{Best, Ending, Free, Optimum, OptimumError, Place, TrialError, Variable};
use liftoff_core::scalar::Dual4;
use liftoff_core::system::varied;

/// A body with its centre at d from the pivot.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = 2 * d, centre = d, inertia = i)]
#[pin(O = (0, 0))]
#[figure(A = (0, -2 * d))]
#[coordinate(phi = angle(OA), from = down)]
struct Body {
    m: f64,
    d: f64,
    i: f64,
    g: f64,
}

/// A stone that is thrown, and bounces.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Stone {
    m: f64,
    e: f64,
    g: f64,
}

fn error_text<E: ToString>(error: E) -> String {
    error.to_string()
}

fn parameter(name: &str, index: usize, value: f64) -> Variable {
    Variable { name: name.to_owned(), parameter: Some(index), value, unit: value }
}

fn started(name: &str, value: f64) -> Variable {
    Variable { name: name.to_owned(), parameter: None, value, unit: 1.0 }
}

/// Released at rest at φ₀ and i = 0.03 kg m², until it hangs: a quarter of a period.
fn quarter(variable: Variable, bounds: Option<[f64; 2]>) -> Result<Best, OptimumError> {
    let simulate = |d: &[f64]| {
        let body = Body { m: 2.0, d: d[0], i: 0.03, g: 9.81 };
        let simulation =
            Simulation::new(&body).map_err(error_text)?.start(Pose::new("phi", 1.0)).map_err(error_text)?;
        simulation.until("phi = 0").map_err(error_text)
    };
    let model = |parameters: &[Dual4]| Ok(varied::<Body>(parameters));
    let variables = vec![Free { variable, bounds }];
    let output = None;
    Optimum { simulate: &simulate, model: &model, variables, place: Place::End, output, greatest: false }
        .solve()
}

/// The period is that of √((i/m + d²)/d), whatever the amplitude: it is least for d = √(i/m)
/// (Kater's pendulum). Slopes of 1e-7 of the time and a curvature of 1 of it give d to 1e-7; runs
/// have ten digits.
#[test]
fn a_period_is_least_where_the_centre_is_as_far_as_the_radius_of_gyration() {
    let least = (0.03_f64 / 2.0).sqrt();
    for begin in [0.5, 0.13, 0.02] {
        for bounds in [None, Some([0.01, 1.0])] {
            let found = quarter(parameter("d", 1, begin), bounds).unwrap();
            assert_eq!(found.ending, Ending::Converged, "{found:?}");
            assert!((found.values[0] - least).abs() < 1e-7 * least, "{begin} {bounds:?} {found:?}");
            assert!(found.value < found.first && found.slopes[0].abs() < 1e-6 && !found.at_bounds[0]);
        }
    }
}

#[test]
fn a_value_at_a_bound_is_reported_to_be() {
    let found = quarter(parameter("d", 1, 0.5), Some([0.3, 1.0])).unwrap();
    assert_eq!((found.ending, found.at_bounds), (Ending::Converged, vec![true]));
    // Outwards it would become less.
    assert!((found.values[0] - 0.3).abs() < 1e-6 && found.slopes[0] > 0.1, "{:?}", found.slopes);
}

/// From a 1e9th of its range: slopes by θ are small there.
#[test]
fn a_wide_range_does_not_hide_a_bound() {
    let found = quarter(parameter("d", 1, 0.5), Some([0.3, 1e8])).unwrap();
    assert_eq!((found.ending, found.at_bounds), (Ending::Converged, vec![true]));
    assert!((found.values[0] - 0.3).abs() < 1e-6, "{:?}", found.values);
}

type Read<'a> = (Place, Option<&'a str>, bool);

/// From x = 0 and y with these rates.
fn stone(rates: [f64; 2], e: f64, (place, output, greatest): Read<'_>) -> Result<Best, OptimumError> {
    let simulate = |u: &[f64]| {
        let simulation = Simulation::new(&Stone { m: 1.0, e, g: 10.0 }).map_err(error_text)?;
        let start = Pose::new("x", 0.0).with("y", 1.0).with("x'", u[0]).with("y'", u[1]);
        Ok(simulation.start(start).map_err(error_text)?.limit(0.8))
    };
    let model = |parameters: &[Dual4]| Ok(varied::<Stone>(parameters));
    let output = output.map(|text| Output::parse(Stone::LAYOUT, text).unwrap());
    let free = |(name, value)| Free { variable: started(name, value), bounds: None };
    let variables = [("x'", rates[0]), ("y'", rates[1])].map(free).to_vec();
    Optimum { simulate: &simulate, model: &model, variables, place, output, greatest }.solve()
}

fn impact(n: usize) -> Place {
    Place::Event(Occurrence::Nth(n), EventFilter { kind: EventKind::Impact, support: None })
}

/// Behind a first impact at t₁, x = u t₁ and y′ = e √(v² + 2g): both are met by one u and one v.
#[test]
fn a_target_behind_an_impact_is_hit() {
    let [t1, e]: [f64; 2] = [0.5, 0.6];
    // y = 1 + v t − 5 t² = 0 at t₁; it then goes upwards by e (g t₁ − v).
    let v = 5.0 * t1 - 1.0 / t1;
    let (x, up) = (2.0 * t1, e * (10.0 * t1 - v));
    let miss = format!("(x - {x})^2 + (y' - {up})^2");
    let found = stone([1.0, 1.5], e, (impact(1), Some(&miss), false)).unwrap();
    assert_eq!(found.ending, Ending::Converged, "{found:?}");
    // A square of 1e-14 has a root of 1e-7.
    assert!((found.values[0] - 2.0).abs() < 1e-6 && (found.values[1] - v).abs() < 1e-6, "{found:?}");
}

/// −(x − 1)² − (y − 2)² at 0.8 s, in free flight.
#[test]
fn the_greatest_value_is_that_of_the_least_with_the_other_sign() {
    let found = stone([0.3, 5.0], 0.6, (Place::End, Some("-(x - 1)^2 - (y - 2)^2"), true)).unwrap();
    assert_eq!(found.ending, Ending::Converged, "{found:?}");
    let expected = [1.0 / 0.8, (1.0 + 5.0 * 0.64) / 0.8];
    assert!(found.values.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6), "{found:?}");
    assert!(found.value > -1e-12 && found.first < -0.5);
}

/// The later the second impact, the better, and at 0.8 s there is none any more.
#[test]
fn a_search_that_is_held_up_says_by_what() {
    let found = stone([0.0, 0.0], 0.2, (impact(2), None, true)).unwrap();
    let Ending::Stopped(why) = &found.ending else { panic!("{found:?}") };
    assert!(why.starts_with("no step leads on: there is no 2nd impact"), "{why}");
    assert!(found.value > found.first && found.value <= 0.8, "{found:?}");
}

/// A slope of 1e6 at the start says nothing of those near the end, where x is 3 at the first
/// impact, and y′ as near to 1 as may be.
#[test]
fn a_steep_start_does_not_end_the_search_too_soon() {
    let target = (impact(1), Some("(x - 3)^2 + (y' - 1)^4"), false);
    for begin in [10.0, 1e3] {
        let found = stone([begin, 2.0], 0.5, target).unwrap();
        assert_eq!(found.ending, Ending::Converged, "{found:?}");
        let t = (found.values[1] + (found.values[1].powi(2) + 20.0).sqrt()) / 10.0;
        assert!((found.values[0] * t - 3.0).abs() < 1e-6, "{begin} {found:?}");
    }
}

#[test]
fn unbounded_objectives_are_reported() {
    let found = stone([1.0, 2.0], 0.5, (Place::End, Some("x + y"), false)).unwrap();
    let Ending::Stopped(why) = &found.ending else { panic!("{found:?}") };
    assert!(why.contains("without bound") && why.contains("LOW:HIGH"), "{why}");
}

/// At x′ = 0 the cosine is greatest, and has no slope.
#[test]
fn a_search_does_not_stay_on_top() {
    let found = stone([0.0, 2.0], 0.5, (Place::End, Some("cos(x)"), false)).unwrap();
    assert_eq!(found.ending, Ending::Converged, "{found:?}");
    assert!((found.value + 1.0).abs() < 1e-12 && found.first == 1.0, "{found:?}");
}

#[test]
fn constant_objectives_are_found_at_once() {
    let found = stone([1.0, 2.0], 0.5, (Place::End, Some("3"), false)).unwrap();
    assert_eq!((found.ending, found.runs, found.values), (Ending::Converged, 5, vec![1.0, 2.0]));
}

#[test]
fn invalid_starts_are_refused() {
    let outside = quarter(parameter("d", 1, 0.5), Some([0.6, 1.0]));
    assert_eq!(outside.unwrap_err().to_string(), "d = 0.5 is not between its bounds, 0.6 and 1");
    let never = stone([1.0, 0.0], 0.6, (impact(9), None, false));
    assert!(matches!(never, Err(OptimumError::Start(TrialError::NoEvent { .. }))), "{never:?}");
    let negative = quarter(parameter("d", 1, -0.1), None);
    assert!(matches!(negative, Err(OptimumError::Start(_))), "{negative:?}");
}
