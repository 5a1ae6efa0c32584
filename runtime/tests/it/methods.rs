//! The methods through a whole run: closed and projected phases, a lift-off, stiff springs.

use liftoff::method::{Dop853, Gauss, Method, Radau, Tsit5};
use liftoff::prelude::*;

/// Two equal bars, hinged at D, across a gap (Fig. 1a).
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(P = corner(-l / 2, 0), under = AD)]
#[support(Q = corner(l / 2, 0), under = DB)]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(phi = angle(DB), from = horizontal)]
#[coordinate(y = -y(D))]
#[mirror(x = 0)]
struct FallingPair {
    m: f64,
    l: f64,
    g: f64,
}

/// A point mass on a stiff spring, in coordinates along which the stiff direction turns.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[ground(O = (0, 0))]
#[particle(P, mass = m)]
#[spring(OP, stiffness = k, length = l, damping = c)]
#[figure(P = (0, -l))]
#[coordinate(x = x(P))]
#[coordinate(y = -y(P))]
struct SpringPendulum {
    m: f64,
    k: f64,
    l: f64,
    c: f64,
    g: f64,
}

/// From φ = 0.1 at rest: lift-off and φ = π/2, by quadrature with 21 digits.
const OPENS: f64 = 0.829_361_847_228_260_4;
const ENDS: f64 = 1.244_461_483_164_527;

fn falls(method: impl Method, form: Form) {
    let (name, tolerance) = (method.name(), 1e-8);
    let pair = FallingPair { m: 1.0, l: 1.0, g: 9.81 };
    let simulation = Simulation::new(&pair).unwrap().method(method).tolerance(tolerance).form(form);
    let run = simulation.start(Pose::at("phi", 0.1)).unwrap().until("phi = pi/2").unwrap().run().unwrap();
    let opens = &run.events()[1];
    assert_eq!(opens.supports, ["P", "Q"]);
    let (first, last) = ((opens.t - OPENS).abs(), (run.events().last().unwrap().t - ENDS).abs());
    // Ten times the tolerance.
    assert!(first < 10.0 * tolerance && last < 10.0 * tolerance, "{name} {form:?}: {first:e}, {last:e}");
}

#[test]
fn each_method_finds_the_lift_off() {
    for form in [Form::Closed, Form::Projected] {
        falls(Dop853, form);
        falls(Tsit5, form);
        falls(Gauss, form);
        falls(Radau, form);
    }
}

/// One period of the rigid pendulum from 60°; the spring lengthens the period by some mg/kl.
#[test]
fn radau_passes_over_stiff_springs() {
    let start = 60f64.to_radians();
    let mean = (0..8).fold((1.0f64, (0.5 * start).cos()), |(a, b), _| (0.5 * (a + b), (a * b).sqrt())).0;
    for (k, damped) in [(1e6, true), (1e9, false), (1e12, true), (1e12, false)] {
        let c = if damped { 2.0 * f64::sqrt(k) } else { 0.0 };
        let model = SpringPendulum { m: 1.0, k, l: 1.0, c, g: 1.0 };
        let r = 1.0 + start.cos() / k;
        let pose = Pose::at("x", r * start.sin()).with("y", r * start.cos());
        let simulation = Simulation::new(&model).unwrap().method(Radau).tolerance(1e-6);
        let run = simulation.start(pose).unwrap().limit(core::f64::consts::TAU / mean).run().unwrap();
        let state = run.final_state();
        let error = (state[0].atan2(state[1]) - start).abs();
        assert!(error < 1e-5, "k = {k:e}: {error:e}");
        assert!(run.statistics().steps < 2500, "k = {k:e}: {:?}", run.statistics());
    }
}
