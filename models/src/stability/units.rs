//! One motion in many units. Scaled by powers of two every rounding is the same: so must be the number of steps and every
//! digit of the state. Powers of ten change the roundings of the parameters.

use super::reference::{MPMATH, reference};
use crate::{BouncingBall, DoublePendulum, FallingPair, SpringPendulum, Zigzag};
use liftoff::catalog::{Failure, Integrator, Record, run};
use liftoff::scene::Setup;
use liftoff::stability::Case;
use liftoff::stability::Effort;
use liftoff::stability::story::{event, first, last};
use liftoff::stability::{at_most, want};

/// Units of length, time and mass.
type Units = [f64; 3];

/// How a model is run.
type Run = fn(Integrator, &Setup) -> Result<Box<dyn Record>, Failure>;
/// A model, its run in units, and the dimension of each coordinate: its power of the unit of length.
type Scene = (&'static str, Run, fn(Units) -> Setup, &'static [i32]);

const SCENES: [Scene; 5] = [
    ("falling-pair", run::<FallingPair>, pair, &[0, 1]),
    ("double-pendulum", run::<DoublePendulum>, pendulum, &[0, 0]),
    ("zigzag", run::<Zigzag>, zigzag, &[0, 0, 1]),
    ("spring-pendulum", run::<SpringPendulum>, spring, &[1, 1]),
    ("bouncing-ball", run::<BouncingBall>, ball, &[1, 1]),
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

pub(super) fn cases(_: Integrator, _: Effort) -> Vec<Case> {
    let binary =
        SCENES.iter().flat_map(|scene| BINARY.iter().map(|(name, powers)| same(scene, name, *powers)));
    binary.chain(DECIMAL.into_iter().map(near)).collect()
}

fn gravity([l, t, _]: Units) -> f64 {
    l / (t * t)
}

fn pair(units: Units) -> Setup {
    let [l, t, m] = units;
    Setup::with(&[("m", m), ("l", l), ("g", gravity(units))])
        .start(&[("phi", 0.1)])
        .until("phi = pi/2")
        .limit(100.0 * t)
}

fn pendulum(units: Units) -> Setup {
    let [l, t, m] = units;
    Setup::with(&[("m", m), ("l", l), ("g", gravity(units))])
        .start(&[("phi_1", 2.0), ("phi_2", 1.0)])
        .limit(4.0 * t)
}

fn zigzag(units: Units) -> Setup {
    let [l, t, m] = units;
    Setup::with(&[("m1", 0.5 * m), ("m2", 0.5 * m), ("l", l), ("g", gravity(units))])
        .start(&[("phi_inner", 1.5), ("phi_outer", 1.5)])
        .limit(100.0 * t)
}

fn spring(units: Units) -> Setup {
    let [l, t, m] = units;
    let parameters =
        [("m", m), ("k", 100.0 * m / (t * t)), ("l", l), ("c", 0.5 * m / t), ("g", gravity(units))];
    Setup::with(&parameters).start(&[("x", 0.5 * l), ("y", l)]).limit(4.0 * t)
}

fn ball(units: Units) -> Setup {
    let [l, t, m] = units;
    Setup::with(&[("m", m), ("g", gravity(units)), ("e", 0.75)])
        .start(&[("y", l), ("x", 0.0), ("x'", l / t)])
        .limit(16.0 * t)
}

fn same(&(model, run, setup, dimensions): &Scene, name: &str, powers: [i32; 3]) -> Case {
    let units = powers.map(|power| 2.0_f64.powi(power));
    let scene = format!("{model}, {name}, against 1, 1, 1");
    // Nothing but exact factors differs; a rounding each for what adds up to a parameter.
    let wants = vec![at_most("Δ state", 1e-15), at_most("Δ time", 1e-15), at_most("Δ steps", 0.0)];
    Case::numbers(format!("units.{model} {name}"), scene, "exact scaling", wants, move |by| {
        difference((run, by), setup, dimensions, units)
    })
}

fn difference(
    (run, by): (Run, Integrator),
    setup: fn(Units) -> Setup,
    dimensions: &[i32],
    units: Units,
) -> Result<Vec<f64>, Failure> {
    let one = run(by, &setup([1.0; 3]))?;
    let other = run(by, &setup(units))?;
    let rates = dimensions.iter().map(|power| units[0].powi(*power) / units[1]);
    let scale = dimensions.iter().map(|power| units[0].powi(*power)).chain(rates);
    let pairs = last(&*one).into_iter().zip(last(&*other)).zip(scale);
    let states = pairs.map(|((a, b), unit)| (b / unit - a).abs() / a.abs().max(1.0));
    let times = (other.interval()[1] / units[1] / one.interval()[1] - 1.0).abs();
    let steps = one.statistics().steps.abs_diff(other.statistics().steps);
    Ok(vec![states.fold(0.0, f64::max), times, steps as f64])
}

fn near(units: Units) -> Case {
    let [length, time, mass] = units;
    let setup = pair(units);
    let name = format!("l = {length:e}, t = {time:e}, m = {mass:e}");
    let wants = vec![
        want("φ", reference("falling-pair.lift-off[1e-1]"), 1e-11),
        want("t", reference("falling-pair.time[1e-1]"), 1e-10),
    ];
    let scene = format!("falling-pair from rest at φ = 0.1, {name}");
    Case::told(format!("units.falling-pair {name}"), scene, MPMATH, ("open P, Q", wants), move |by| {
        let record = run::<FallingPair>(by, &setup)?;
        let open = event(&*record, 0);
        Ok((first(&*record), vec![open.state[0], open.t / time]))
    })
}
