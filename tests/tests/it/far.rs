//! Motions far along a slope are those near its top: the height of a point is there a difference of
//! terms as large as it is far, and nothing is decided by less than their rounding.

use liftoff::method::{Dop853, Gauss, Method, Taylor};
use liftoff::prelude::*;
use liftoff_compiled::RimlessWheel;

const GAMMA: f64 = 0.2;

/// A square block with friction and restitution at its corners.
#[derive(BarSystem)]
#[gravity(g)]
#[body(
    block,
    points(A = (0, 0), B = (b, 0), C = (b, b), D = (0, b)),
    mass = m,
    inertia = m * b * b / 6,
    centre = (b / 2, b / 2),
)]
#[support(A = slope(-gamma), friction = mu, restitution = e)]
#[support(B = slope(-gamma), friction = mu, restitution = e)]
#[support(C = slope(-gamma), friction = mu, restitution = e)]
#[support(D = slope(-gamma), friction = mu, restitution = e)]
#[figure(A = (0, 0), B = (b * cos(gamma), -b * sin(gamma)))]
#[coordinate(phi = angle(block), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Block {
    m: f64,
    b: f64,
    gamma: f64,
    mu: f64,
    e: f64,
    g: f64,
}

/// A point on the slope, so far down.
fn on_slope(far: f64) -> [f64; 2] {
    [far * GAMMA.cos(), -far * GAMMA.sin()]
}

fn run(simulation: Simulation, method: impl Method, tolerance: f64, far: f64) -> Trajectory {
    let name = method.name();
    let run = simulation.method(method).tolerance(tolerance).run();
    let run = run.unwrap_or_else(|error| panic!("{name} {tolerance:e} {far:e}: {error}"));
    assert!(run.audit().is_clean(), "{name} {tolerance:e} {far:e}: {}", run.audit());
    run
}

/// On both feet A and F, it turns about A.
fn rolling(method: impl Method, tolerance: f64, far: f64) -> Trajectory {
    let wheel = RimlessWheel { m: 1.0, j: 0.1, l: 1.0, gamma: GAMMA, mu: 1.5, g: 9.81 };
    let ([x, y], rate) = (on_slope(far), -2.0);
    let (sin, cos) = (-GAMMA - core::f64::consts::FRAC_PI_3).sin_cos();
    let start = Pose::new("phi", -GAMMA).with("x", x - cos).with("y", y - sin);
    let start = start.with("phi'", rate).with("x'", rate * sin).with("y'", -rate * cos);
    run(Simulation::new(&wheel).unwrap().start(start).unwrap().limit(5.0), method, tolerance, far)
}

fn rolls_alike(method: &(impl Method + Clone)) {
    for tolerance in [1e-9, 1e-12, 1e-14] {
        let near = rolling(method.clone(), tolerance, 0.0);
        assert!(near.events().len() > 10);
        for far in [1e2, 1e4, 1e6] {
            let run = rolling(method.clone(), tolerance, far);
            let course = |run: &Trajectory| -> Vec<_> {
                run.events().iter().map(|event| (event.kind, event.supports.clone())).collect()
            };
            assert_eq!(course(&run), course(&near), "{} {tolerance:e} {far:e}", method.name());
            // Some roundings of the place at each of the steps, at about the natural speed.
            let within = 1e3 * tolerance + 64.0 * f64::EPSILON * far;
            for (event, other) in run.events().iter().zip(near.events()) {
                let apart = (event.t - other.t).abs();
                assert!(apart < within, "{} {tolerance:e} {far:e}: {apart:e}", method.name());
            }
        }
    }
}

#[test]
fn a_wheel_rolls_alike_wherever_on_its_slope() {
    rolls_alike(&Taylor);
    rolls_alike(&Dop853);
    rolls_alike(&Gauss);
}

/// It bounces and comes to rest on a face, φ + γ a multiple of a right angle, and slides on with g
/// (sin γ − μ cos γ).
#[test]
fn a_block_comes_to_rest_on_a_face_wherever_on_its_slope() {
    bounces(&Taylor);
    bounces(&Dop853);
    bounces(&Gauss);
}

fn bounces(method: &(impl Method + Clone)) {
    let block = Block { m: 1.0, b: 0.6, gamma: GAMMA, mu: 0.1, e: 0.4, g: 9.81 };
    let turn = core::f64::consts::FRAC_PI_2;
    for (tolerance, far) in [1e-4, 1e-9, 1e-14].into_iter().flat_map(|t| [0.0, 1e2, 1e4, 1e6].map(|d| (t, d)))
    {
        for (phi, spin) in [(0.4, -1.0), (-0.3, 2.0), (0.1, 3.5), (-0.5, -4.0), (0.5, -8.0)] {
            let what = || format!("{} {tolerance:e} {far:e} {phi}", method.name());
            let [x, y] = on_slope(far);
            let start =
                Pose::new("phi", phi).with("x", x).with("y", y + 1.0).with("phi'", spin).with("x'", 1.0);
            let simulation = Simulation::new(&block).unwrap().start(start).unwrap().limit(4.0);
            let run = run(simulation, method.clone(), tolerance, far);
            let [before, end] = [3.5, 4.0].map(|t| run.state(t));
            let off = (end[0] + GAMMA) / turn;
            assert!(
                (off - off.round()).abs() < 1e-2 * tolerance.sqrt() + 4.0 * f64::EPSILON * far,
                "{}: {off}",
                what()
            );
            let along = |state: &[f64]| state[4] * GAMMA.cos() - state[5] * GAMMA.sin();
            let gained = along(&end) - along(&before);
            let expected = 0.5 * block.g * (GAMMA.sin() - block.mu * GAMMA.cos());
            assert!(
                (gained - expected).abs() < 10.0 * tolerance + 64.0 * f64::EPSILON * far,
                "{}: {gained}",
                what()
            );
        }
    }
}

/// Completed by its contacts from x alone, or given whole, it lies on the slope and slides: so far
/// off that the rounding of the gaps is more than what is closed near the origin, and that the path
/// there from the nominal figure is billions of lengths.
#[test]
fn a_block_is_put_on_its_slope_however_far() {
    let block = Block { m: 1.0, b: 0.6, gamma: GAMMA, mu: 0.1, e: 0.4, g: 9.81 };
    for (far, is_whole) in [1e2, 1e6, 1e9].into_iter().flat_map(|far| [(far, false), (far, true)]) {
        let [x, y] = on_slope(far);
        let start = Pose::new("x", x);
        let start = if is_whole { start.with("y", y).with("phi", -GAMMA) } else { start };
        let simulation = Simulation::new(&block).unwrap().start(start).unwrap();
        let start = simulation.start_state().unwrap();
        let rounding = 8.0 * f64::EPSILON * far;
        assert!(
            (start[0] + GAMMA).abs() < 1e-9 + rounding && (start[2] - y).abs() < 1e-9 + rounding,
            "{far:e} {is_whole}"
        );
        let run = run(simulation.limit(1.0), Taylor, 1e-9, far);
        assert_eq!(run.events().len(), 2, "{far:e} {is_whole}: {:?}", run.events());
        let end = run.state(1.0);
        let along = end[4] * GAMMA.cos() - end[5] * GAMMA.sin();
        let expected = block.g * (GAMMA.sin() - block.mu * GAMMA.cos());
        assert!((along - expected).abs() < 1e-8 + rounding, "{far:e} {is_whole}: {along}");
    }
}
