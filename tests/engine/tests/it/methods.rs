//! The methods through a whole run: closed and projected phases, a lift-off, stiff springs.

use liftoff::LoggedDecision;
use liftoff::method::{Auto, Dop853, Gauss, Method, Radau, Taylor, Tsit5};
use liftoff::prelude::*;
use liftoff_fixtures::PairOnCorners;
use liftoff_fixtures::SpringPendulum;

/// From φ = 0.1 at rest: lift-off and φ = π/2, by quadrature with 21 digits.
const OPENS: f64 = 0.829_361_847_228_260_4;
const ENDS: f64 = 1.244_461_483_164_527;

fn falls(method: impl Method, form: Form) {
    let (name, tolerance) = (method.name(), 1e-8);
    let pair = PairOnCorners { m: 1.0, l: 1.0, g: 9.81 };
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

/// What integrates the pair's first phase.
fn told(method: impl Method, form: Form, tolerance: f64) -> &'static str {
    let pair = PairOnCorners { m: 1.0, l: 1.0, g: 9.81 };
    let simulation = Simulation::new(&pair).unwrap().method(method).tolerance(tolerance).form(form);
    let run = simulation.start(Pose::at("phi", 0.1)).unwrap().limit(0.1).run().unwrap();
    run.segments()[0].choice.method
}

#[test]
fn a_segment_tells_what_integrates_it() {
    assert_eq!(told(Taylor, Form::Closed, 1e-8), "taylor");
    assert_eq!(told(Taylor, Form::Projected, 1e-8), "dop853");
    assert_eq!(told(Auto, Form::Closed, 1e-8), "taylor");
    assert_eq!(told(Auto, Form::Projected, 1e-8), "dop853");
    assert_eq!(told(Auto, Form::Projected, 1e-4), "tsit5");
    assert_eq!(told(Gauss, Form::Projected, 1e-8), "gauss");
    let damped = SpringPendulum { m: 1.0, k: 1e6, l: 1.0, c: 2e3, g: 1.0 };
    let run = Simulation::new(&damped).unwrap().limit(1e-3).run().unwrap();
    assert_eq!(run.segments()[0].choice.method, "radau");
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

/// A bar whose bearing seizes twice a turn of the time: c sin⁸ t.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
#[couple(OA = -c * sin(t).powi(8) * rate(phi))]
struct Seizing {
    m: f64,
    l: f64,
    c: f64,
    g: f64,
}

fn seized(model: &Seizing, method: impl Method) -> Trajectory {
    let simulation = Simulation::new(model).unwrap().tolerance(1e-7).method(method);
    simulation.start(Pose::at("phi", 1.0)).unwrap().limit(6.8).run().unwrap()
}

#[test]
fn auto_changes_its_method_as_damping_comes_and_goes() {
    let model = Seizing { m: 1.0, l: 1.0, c: 1e5, g: 9.81 };
    let (auto, explicit) = (seized(&model, Auto), seized(&model, Dop853));
    let methods: Vec<&str> = auto
        .log()
        .iter()
        .filter_map(|entry| match &entry.decision {
            LoggedDecision::Method(choice) => Some(choice.method),
            _ => None,
        })
        .collect();
    assert_eq!(auto.segments()[0].choice.method, "taylor");
    assert_eq!(methods, ["radau", "taylor", "radau", "taylor"], "{:?}", auto.log());
    let [steps, others] = [&auto, &explicit].map(|run| run.statistics().steps);
    assert!(20 * steps < others, "{steps}, {others}");
    for (a, b) in auto.final_state().iter().zip(explicit.final_state()) {
        assert!((a - b).abs() < 1e-5, "{a} {b}");
    }
}
