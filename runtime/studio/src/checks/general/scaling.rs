//! The same run with lengths, times and masses in other units. The units are powers of four, so
//! that they and the square roots that natural times have are exact: what differs is the rounding
//! of sums of parameters.

use super::{Effort, Pair, SAME, case, differences, runs, shown};
use crate::checks::{Answer, Case, Expected};
use crate::registry::{Dimension, Entry, MotionError, of_coordinate, per};
use crate::run_spec::{PointImpulse, RunSpec, Values};

/// About 1e9 and its inverse.
const LARGE: f64 = 1_073_741_824.0;
const SMALL: f64 = 1.0 / LARGE;

const UNITS: [(&str, [f64; 3]); 6] = [
    ("l=2^30", [LARGE, 1.0, 1.0]),
    ("l=2^-30", [SMALL, 1.0, 1.0]),
    ("t=2^30", [1.0, LARGE, 1.0]),
    ("t=2^-30", [1.0, SMALL, 1.0]),
    ("m=2^30", [1.0, 1.0, LARGE]),
    ("m=2^-30", [1.0, 1.0, SMALL]),
];

const TIME: Dimension = [0.0, 1.0, 0.0];
const IMPULSE: Dimension = [1.0, -1.0, 1.0];

/// Roundings of the parameters grow with the motion.
const MOST: f64 = 1e-11;
/// Of a run that is not the same in other units.
const EXCUSE: &str = "numbers with a dimension";

pub(super) fn cases(model: &'static Entry, effort: Effort) -> Vec<Case> {
    if !runs(model) {
        return Vec::new();
    }
    let units = if effort == Effort::Full { &UNITS[..] } else { &UNITS[..4] };
    let one = |&(name, units): &(&str, [f64; 3])| {
        let expectations = differences(model, MOST);
        let expected = Expected::Unless { text: SAME.to_owned(), expectations, excuse: EXCUSE };
        let scene = format!("default run in units of {name}, against its own");
        case("scaling", (model, name), scene, "dimensions", expected, move || compared(model, units))
    };
    units.iter().map(one).collect()
}

fn compared(model: &Entry, units: [f64; 3]) -> Result<Answer, MotionError> {
    let default = model.default_run();
    let end = model.run(&default)?.interval()[1];
    // A condition to stop at may have numbers in it, a time is scaled.
    let spec = RunSpec { until: Vec::new(), limit: Some(end), ..default };
    let refused = |why: &str| MotionError::Input(format!("{EXCUSE}: {why}"));
    if !spec.cut.is_empty() {
        return Err(refused("in the condition of a cut"));
    }
    let dimensions = model.dimensions().ok_or_else(|| refused("in the model"))?;
    let pair = Pair { model, natural: model.units(&spec)?, units };
    let scaled = scaled(model, &spec, (&dimensions, units));
    let other = shown(&scaled, model.run(&scaled)?);
    Ok(pair.compare(&model.run(&spec)?, &other))
}

/// The same run with its numbers in other units.
fn scaled(model: &Entry, spec: &RunSpec, (dimensions, units): (&[Dimension], [f64; 3])) -> RunSpec {
    let unit = |dimension: Dimension| factor(dimension, units);
    let time = unit(TIME);
    let of = |value: (&String, Dimension, f64)| (value.0.clone(), value.2 * unit(value.1));
    let parameter = |name: &String| model.layout().parameters.iter().position(|known| known == name);
    let parameters = spec.parameters.iter().filter_map(|(name, value)| Some((name, parameter(name)?, value)));
    RunSpec {
        parameters: parameters.map(|(name, i, value)| of((name, dimensions[i], *value))).collect(),
        start: pose(model, &spec.start, &unit),
        energy_of: pose(model, &spec.energy_of, &unit),
        release: spec.release.iter().map(|(support, at)| (support.clone(), at * time)).collect(),
        impulses: spec.impulses.iter().map(|blow| blown(blow, unit(IMPULSE), time)).collect(),
        limit: spec.limit.map(|limit| limit * time),
        ..spec.clone()
    }
}

fn blown(blow: &PointImpulse, impulse: f64, time: f64) -> PointImpulse {
    PointImpulse { point: blow.point.clone(), impulse: blow.impulse.map(|p| p * impulse), at: blow.at * time }
}

fn pose(model: &Entry, values: &Values, unit: &dyn Fn(Dimension) -> f64) -> Values {
    let dimension = |name: &str| {
        let base = name.trim_end_matches('\'');
        let of = of_coordinate(model.layout(), base)?;
        Some(if base == name { of } else { per(of, TIME) })
    };
    let scaled =
        values.iter().filter_map(|(name, value)| Some((name.clone(), value * unit(dimension(name)?))));
    scaled.collect()
}

fn factor(dimension: Dimension, units: [f64; 3]) -> f64 {
    dimension.iter().zip(units).map(|(power, unit)| unit.powf(*power)).product()
}
