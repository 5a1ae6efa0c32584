//! What a run passes that ends no phase or has derivatives to one side only: touches, singular positions, given times at events.

use liftoff::prelude::*;
use liftoff::system::varied;
use liftoff_analysis::{Sensitivities, SensitivityError, Variable};
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
    Sensitivities::of(run, |parameters| Ok(varied::<M>(parameters)), &variables, start)
}

fn start(run: &Trajectory) -> Vec<f64> {
    run.events()[0].state.clone()
}

/// The place of a coordinate or rate in a state.
fn entry(run: &Trajectory, name: &str) -> usize {
    run.layout().names_of_state().position(|known| known == name).expect("a name")
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

/// φ̈ = −λ sin φ with λ = (m + c) g/(l (⅔ m + c)): φ ≈ φ₀ + ω t − λ sin φ₀ t²/2 up to t³, and its derivative by g.
#[test]
fn a_singular_position_is_named_and_derivatives_end_there() {
    let [m, l, c, d, g] = [1.0, 1.0, 2.0, 2.0, 9.81];
    let (phi, rate) = (1.5_f64, 6.0);
    let run = |limit: f64| {
        let start = Pose::at("phi", phi).with("phi'", rate);
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
