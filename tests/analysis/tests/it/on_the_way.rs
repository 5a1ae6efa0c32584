//! What a run passes that ends no phase or has derivatives to one side only: touches, singular
//! positions, given times at events.

use liftoff::prelude::*;
use liftoff_analysis::{Sensitivities, SensitivityError, Variable};
use liftoff_core::system::varied;
use liftoff_replay::ReplayError;

/// Derivatives by all parameters of a run whose start depends on them so.
fn by_parameters<M: BarSystem>(
    run: &Trajectory,
    start: impl Fn(&[f64]) -> Vec<f64>,
) -> Result<Sensitivities, SensitivityError> {
    let named = M::LAYOUT.parameters.iter().enumerate().zip(run.parameters());
    let variable = |((k, name), &value): ((usize, &&str), &f64)| Variable {
        name: (*name).to_owned(),
        parameter: Some(k),
        value,
        unit: value.abs(),
    };
    let variables: Vec<Variable> = named.map(variable).collect();
    let start = |variable: &Variable, value: f64| {
        let mut parameters = run.parameters().to_vec();
        variable.parameter.into_iter().for_each(|k| parameters[k] = value);
        Ok(start(&parameters))
    };
    Sensitivities::compute(run, |parameters| Ok(varied::<M>(parameters)), &variables, start)
}

fn start(run: &Trajectory) -> Vec<f64> {
    run.events()[0].state.clone()
}

/// The place of a coordinate or rate in a state.
fn entry(run: &Trajectory, name: &str) -> usize {
    run.layout().names_of_state().position(|known| known == name).expect("a name")
}

/// A rod about a rough point on the floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, rough)]
#[figure(A = (0, 0), B = (3 * l / 5, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = vertical)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Rod {
    m: f64,
    l: f64,
    g: f64,
}

/// From φ₀ with the energy of rest upright φ̇² = (3g/l) (1 − cos φ): the reaction touches zero
/// where cos φ = 1/3. φ is a function of √(g/l) t, so that at a fixed time 2g ∂φ/∂g = t φ̇ and 2g
/// ∂φ̇/∂g = φ̇ + t φ̈, with φ̈ = (3g/2l) sin φ; and those by l are opposite.
#[test]
fn derivatives_at_a_touch_are_those_at_its_time() {
    let [m, l, g] = [1.3, 0.8, 9.0_f64];
    let simulation = |p: &[f64]| {
        let rate = (3.0 * p[2] / p[1] * (1.0 - 1.0_f64.cos())).sqrt();
        let rod = Rod { m: p[0], l: p[1], g: p[2] };
        Simulation::new(&rod).unwrap().start(Pose::new("phi", 1.0).with("phi'", rate)).unwrap()
    };
    let run = simulation(&[m, l, g]).limit(0.2).tolerance(1e-13).run().unwrap();
    let found = by_parameters::<Rod>(&run, |p| simulation(p).start_state().unwrap()).unwrap();
    let k = run.events().iter().position(|event| event.kind == EventKind::Touch).expect("a touch");
    let touch = &run.events()[k];
    assert!((touch["phi"].cos() - 1.0 / 3.0).abs() < 1e-6 && touch.t < 0.15, "{touch}");
    assert!(found.events[k].time.is_none());
    let (t, rate) = (touch.t, touch["phi'"]);
    let acceleration = 1.5 * g / l * touch["phi"].sin();
    for (name, expected) in [("phi", t * rate), ("phi'", rate + t * acceleration)] {
        let row = &found.events[k].state[entry(&run, name)];
        let told = [row[0], 2.0 * l * row[1] + expected, 2.0 * g * row[2] - expected];
        assert!(told.iter().all(|x| x.abs() < 1e-9 * expected), "{name}: {row:?}, {expected}: {told:?}");
    }
}

/// A bar on two equal cranks, which flattens where they point along the line of their pins.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = c, length = d)]
#[bar(QB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[pin(Q = (d, 0))]
#[figure(A = (3 * l / 5, -4 * l / 5), B = (d + 3 * l / 5, -4 * l / 5))]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(QB), from = down)]
#[coordinate(tilt = angle(AB))]
struct Cranks {
    m: f64,
    l: f64,
    c: f64,
    d: f64,
    g: f64,
}

/// φ̈ = −λ sin φ with λ = (m + c) g/(l (⅔ m + c)): φ ≈ φ₀ + ω t − λ sin φ₀ t²/2 up to t³, and its
/// derivative by g.
#[test]
fn a_singular_position_is_named_and_derivatives_end_there() {
    let [m, l, c, d, g] = [1.0, 1.0, 2.0, 2.0, 9.81];
    let (phi, rate) = (1.5_f64, 6.0);
    let run = |limit: f64| {
        let start = Pose::new("phi", phi).with("phi'", rate);
        let simulation = Simulation::new(&Cranks { m, l, c, d, g }).unwrap().start(start).unwrap();
        simulation.limit(limit).run().unwrap()
    };
    let across = run(0.02);
    let error = by_parameters::<Cranks>(&across, |_| start(&across)).unwrap_err();
    let SensitivityError::Replay(ReplayError::Singular { t }) = error else { panic!("{error}") };
    assert!((across.state(t)[entry(&across, "phi")] - core::f64::consts::FRAC_PI_2).abs() < 1e-3, "{error}");
    assert!(error.to_string().contains("singular position near t = 0.01"), "{error}");
    let before = run(0.001);
    let found = by_parameters::<Cranks>(&before, |_| start(&before)).unwrap();
    let factor = (m + c) / (l * (2.0 / 3.0 * m + c));
    let expected = -0.5 * factor * phi.sin() * 1e-6;
    let told = found.end[entry(&before, "phi")][4];
    assert!((told / expected - 1.0).abs() < 1e-3, "{told} or {expected}");
}

/// A ball on a floor.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, h))]
#[coordinate(y = y(P))]
#[coordinate(x = x(P))]
struct Ball {
    m: f64,
    e: f64,
    h: f64,
    g: f64,
}

/// A ball that reaches the floor at a given time has rates before or behind its impact there, as g
/// falls or grows.
#[test]
fn a_given_time_at_an_event_has_derivatives_to_one_side_only() {
    let ball = |g: f64| {
        let simulation = Simulation::new(&Ball { m: 2.0, e: 0.5, h: 1.3, g }).unwrap();
        simulation.start(Pose::new("y", 1.3).with("x'", 1.0)).unwrap().limit(0.8)
    };
    let t = ball(9.0).run().unwrap().events()[1].t;
    let refused = |simulation: Simulation| {
        let run = simulation.run().unwrap();
        let error = by_parameters::<Ball>(&run, |_| start(&run)).unwrap_err();
        assert_eq!(error, SensitivityError::Replay(ReplayError::Simultaneous { t }), "{:?}", run.events());
    };
    refused(ball(9.0).limit(t));
    refused(ball(9.0).until(&format!("t = {t}")).unwrap());
    refused(ball(9.0).impulse("P", [0.0, 1.0], t).unwrap());
    // With a little more time the ball has bounced, with a little less it has not.
    for (limit, has_bounced) in [(t + 1e-3, true), (t - 1e-3, false)] {
        let run = ball(9.0).limit(limit).run().unwrap();
        let found = by_parameters::<Ball>(&run, |_| start(&run)).unwrap();
        // ẏ = −g t before, and behind it e g t₁ − g (t − t₁) = (1 + e) √(2gh) − g t.
        let expected = if has_bounced { 1.5 * (1.3_f64 / 18.0).sqrt() - limit } else { -limit };
        let told = found.end[entry(&run, "y'")][3];
        assert!((told - expected).abs() < 1e-10, "{told} or {expected}");
    }
}
