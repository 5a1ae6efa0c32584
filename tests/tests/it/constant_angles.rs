//! Taylor's method where angles differ by what does not vary: welds, offsets, slopes.

use liftoff::method::{Dop853, Method, Taylor};
use liftoff::prelude::*;

const G: f64 = 9.81;

/// Two bars welded at an angle.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[weld(OA, AB, angle = a)]
#[coordinate(phi = angle(OA), from = down)]
struct Welded {
    m: f64,
    l: f64,
    a: f64,
    g: f64,
}

/// A bar with a mass beside it, at a number's angle.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[point(C = OA, at = (c * cos(0.7), c * sin(0.7)))]
#[mass(C, m)]
#[pin(O = (0, 0))]
#[coordinate(phi = angle(OA), from = down)]
struct Beside {
    m: f64,
    l: f64,
    c: f64,
    g: f64,
}

/// A bar whose foot slides down a slope.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = slope(-a))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(phi = angle(AB), from = right)]
#[figure(A = (0, 0), B = (0, l))]
struct Sliding {
    m: f64,
    l: f64,
    a: f64,
    g: f64,
}

/// Two spokes of a rimless wheel on a rough slope.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(HA, mass = m, length = l)]
#[bar(HB, mass = m, length = l)]
#[weld(HA, HB, angle = b)]
#[support(A = slope(-a), rough)]
#[support(B = slope(-a), rough)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(phi = angle(HA), from = down)]
#[figure(H = (0, l), A = (0, 0), B = (4 * l / 5, 2 * l / 5))]
struct Wheel {
    m: f64,
    l: f64,
    a: f64,
    b: f64,
    g: f64,
}

fn ran<M: BarSystem>(model: &M, method: impl Method, start: Pose, until: &str) -> Trajectory {
    let simulation = Simulation::new(model).unwrap().tolerance(1e-12).method(method);
    simulation.start(start).unwrap().until(until).unwrap().limit(20.0).run().unwrap()
}

fn energy(run: &Trajectory, t: f64) -> f64 {
    run.value(&Output::parse(run.layout(), "E").unwrap(), t)
}

/// φ and φ̇ after two seconds against an equation by hand, at rest from φ = 1. Both err by less
/// than 1e-12 a step, some hundred steps of which grow no faster than t.
fn swings<M: BarSystem>(model: &M, acceleration: impl Fn(f64) -> f64) {
    let run = ran(model, Taylor, Pose::new("phi", 1.0), "t = 2");
    let expected = swung(acceleration);
    for (x, y) in run.final_state().iter().zip(expected) {
        assert!((x - y).abs() < 1e-9, "{x} for {y}");
    }
    let drift = energy(&run, 2.0) - energy(&run, 0.0);
    assert!(drift.abs() < 1e-10, "{drift:e}");
}

#[test]
fn a_welded_pendulum_swings_as_by_hand() {
    let (m, l, a) = (1.3, 0.7, 0.6_f64);
    // J/ml² = 1/3 + 1/12 + |1, a/2|² of the second centre; the moment of both weights about O.
    let inertia = 5.0 / 3.0 + a.cos();
    swings(&Welded { m, l, a, g: G }, |phi| -G / l / inertia * (1.5 * phi.sin() + 0.5 * (phi + a).sin()));
}

#[test]
fn a_mass_beside_its_bar_swings_as_by_hand() {
    let (m, l, c) = (1.3, 0.7, 0.4);
    let inertia = l * l / 3.0 + c * c;
    swings(&Beside { m, l, c, g: G }, |phi| -G / inertia * (l / 2.0 * phi.sin() + c * (phi + 0.7).sin()));
}

/// The classical method at so small a step that its error is rounding.
fn swung(acceleration: impl Fn(f64) -> f64) -> [f64; 2] {
    let (steps, mut state) = (20_000, [1.0, 0.0]);
    let h = 2.0 / f64::from(steps);
    let rate = |[phi, pace]: [f64; 2]| [pace, acceleration(phi)];
    let along = |x: [f64; 2], k: [f64; 2], h: f64| [x[0] + h * k[0], x[1] + h * k[1]];
    for _ in 0..steps {
        let k1 = rate(state);
        let k2 = rate(along(state, k1, h / 2.0));
        let k3 = rate(along(state, k2, h / 2.0));
        let k4 = rate(along(state, k3, h));
        for i in 0..2 {
            state[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        }
    }
    state
}

/// Nothing happens on the way; energy is kept, DOP853 ends alike.
#[test]
fn a_foot_slides_down_a_slope_without_events() {
    let model = Sliding { m: 1.3, l: 0.7, a: 0.3, g: G };
    let start = || Pose::new("phi", 1.2).with("x", 0.0).with("y", 0.0);
    let runs = [ran(&model, Taylor, start(), "t = 0.3"), ran(&model, Dop853, start(), "t = 0.3")];
    for run in &runs {
        let kinds: Vec<EventKind> = run.events().iter().map(|event| event.kind).collect();
        assert_eq!(kinds, [EventKind::Start, EventKind::Stop]);
        assert!((energy(run, 0.3) - energy(run, 0.0)).abs() < 1e-10);
    }
    let [taylor, dop853] = runs.map(|run| run.final_state());
    assert!(taylor.iter().zip(&dop853).all(|(x, y)| (x - y).abs() < 1e-9), "{taylor:?} for {dop853:?}");
}

/// The other spoke strikes where both feet are on the slope, their bisector across it: φ + b/2 =
/// −a.
#[test]
fn a_rimless_wheel_strikes_the_slope_where_it_is() {
    let (a, b) = (0.1, 0.8);
    let model = Wheel { m: 1.3, l: 0.7, a, b, g: G };
    let start = Pose::new("phi", 0.0).with("phi'", -1.0).with("x", 0.0).with("y", 0.0);
    let simulation = Simulation::new(&model).unwrap().tolerance(1e-12).method(Taylor).start(start).unwrap();
    let run = simulation.stop_at_impacts().limit(2.0).run().unwrap();
    let strike = run.events().iter().find(|event| event.kind == EventKind::Close).unwrap();
    assert_eq!(strike.supports, ["B"]);
    let phi = run.value(&Output::parse(Wheel::LAYOUT, "phi").unwrap(), strike.t);
    assert!((phi + a + b / 2.0).abs() < 1e-10, "{phi}");
    assert!((energy(&run, strike.t) - energy(&run, 0.0)).abs() < 1e-10);
}
