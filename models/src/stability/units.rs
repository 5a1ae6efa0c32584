//! One motion in many units. Scaled by powers of two every rounding is the same: so must be the
//! number of steps and every digit of the state. Powers of ten change the roundings of the
//! parameters.

use super::reference::{MPMATH, reference};
use super::run;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{MethodId, MotionError};
use liftoff_verification::cases::event_summary::{event, first, last};
use liftoff_verification::cases::{Case, Effort, at_most, expect};

/// Units of length, time and mass.
type Units = [f64; 3];

/// A model, its run in units, and the dimension of each coordinate: its power of the unit of
/// length.
type Scene = (&'static str, fn(Units) -> RunSpec, &'static [i32]);

const SCENES: [Scene; 5] = [
    ("falling-pair", pair, &[0, 1]),
    ("double-pendulum", pendulum, &[0, 0]),
    ("zigzag", zigzag, &[0, 0, 1]),
    ("spring-pendulum", spring, &[1, 1]),
    ("bouncing-ball", ball, &[1, 1]),
];

/// Units by powers of two, lengths and times over eighteen orders of magnitude.
const BINARY: [(&str, [i32; 3]); 5] = [
    ("l = 2^30", [30, 0, 0]),
    ("l = 2^-30", [-30, 0, 0]),
    ("t = 2^30", [0, 30, 0]),
    ("t = 2^-30", [0, -30, 0]),
    ("m = 2^40, l = 2^-30, t = 2^30", [-30, 30, 40]),
];

const DECIMAL: [Units; 4] = [[1e9, 1.0, 1.0], [1e-9, 1.0, 1.0], [1.0, 1e9, 1.0], [1e-9, 1e-9, 1e12]];

pub(super) fn cases(_: MethodId, _: Effort) -> Vec<Case> {
    let binary =
        SCENES.iter().flat_map(|scene| BINARY.iter().map(|(name, powers)| same(scene, name, *powers)));
    binary.chain(DECIMAL.into_iter().map(near)).collect()
}

fn gravity([l, t, _]: Units) -> f64 {
    l / (t * t)
}

fn pair(units: Units) -> RunSpec {
    let [l, t, m] = units;
    RunSpec::with(&[("m", m), ("l", l), ("g", gravity(units))])
        .start(&[("phi", 0.1)])
        .until("phi = pi/2")
        .limit(100.0 * t)
}

fn pendulum(units: Units) -> RunSpec {
    let [l, t, m] = units;
    RunSpec::with(&[("m", m), ("l", l), ("g", gravity(units))])
        .start(&[("phi_1", 2.0), ("phi_2", 1.0)])
        .limit(4.0 * t)
}

fn zigzag(units: Units) -> RunSpec {
    let [l, t, m] = units;
    RunSpec::with(&[("m1", 0.5 * m), ("m2", 0.5 * m), ("l", l), ("g", gravity(units))])
        .start(&[("phi_inner", 1.5), ("phi_outer", 1.5)])
        .limit(100.0 * t)
}

fn spring(units: Units) -> RunSpec {
    let [l, t, m] = units;
    let parameters =
        [("m", m), ("k", 100.0 * m / (t * t)), ("l", l), ("c", 0.5 * m / t), ("g", gravity(units))];
    RunSpec::with(&parameters).start(&[("x", 0.5 * l), ("y", l)]).limit(4.0 * t)
}

fn ball(units: Units) -> RunSpec {
    let [l, t, m] = units;
    RunSpec::with(&[("m", m), ("g", gravity(units)), ("e", 0.75)])
        .start(&[("y", l), ("x", 0.0), ("x'", l / t)])
        .limit(16.0 * t)
}

fn same(&(model, spec, dimensions): &Scene, name: &str, powers: [i32; 3]) -> Case {
    let units = powers.map(|power| 2.0_f64.powi(power));
    let scene = format!("{model}, {name}, against 1, 1, 1");
    // Nothing but exact factors differs; a rounding each for what adds up to a parameter.
    let expectations = vec![at_most("Δ state", 1e-15), at_most("Δ time", 1e-15), at_most("Δ steps", 0.0)];
    Case::numbers(format!("units.{model} {name}"), scene, "exact scaling", expectations, move |by| {
        difference((model, by), spec, dimensions, units)
    })
}

fn difference(
    (model, by): (&str, MethodId),
    spec: fn(Units) -> RunSpec,
    dimensions: &[i32],
    units: Units,
) -> Result<Vec<f64>, MotionError> {
    let one = run(model, by, &spec([1.0; 3]))?;
    let other = run(model, by, &spec(units))?;
    let rates = dimensions.iter().map(|power| units[0].powi(*power) / units[1]);
    let scale = dimensions.iter().map(|power| units[0].powi(*power)).chain(rates);
    let pairs = last(&one).into_iter().zip(last(&other)).zip(scale);
    let states = pairs.map(|((a, b), unit)| (b / unit - a).abs() / a.abs().max(1.0));
    let times = (other.interval()[1] / units[1] / one.interval()[1] - 1.0).abs();
    let steps = one.statistics().steps.abs_diff(other.statistics().steps);
    Ok(vec![states.fold(0.0, f64::max), times, steps as f64])
}

fn near(units: Units) -> Case {
    let [length, time, mass] = units;
    let spec = pair(units);
    let name = format!("l = {length:e}, t = {time:e}, m = {mass:e}");
    let expectations = vec![
        expect("φ", reference("falling-pair.lift-off[1e-1]"), 1e-11),
        expect("t", reference("falling-pair.time[1e-1]"), 1e-10),
    ];
    let scene = format!("falling-pair from rest at φ = 0.1, {name}");
    Case::text_and_numbers(
        format!("units.falling-pair {name}"),
        scene,
        MPMATH,
        ("open P, Q", expectations),
        move |by| {
            let record = run("falling-pair", by, &spec)?;
            let open = event(&record, 0);
            Ok((first(&record), vec![open.state[0], open.t / time]))
        },
    )
}
