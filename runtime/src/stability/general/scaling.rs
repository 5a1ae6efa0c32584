//! The same run with lengths, times and masses in other units. The units are powers of four, so that they and the square roots
//! that natural times have are exact: what differs is the rounding of sums of parameters.

use super::{Effort, Pair, SAME, case, runs};
use crate::catalog::{Dimension, Failure, Model, of_coordinate, per};
use crate::scene::{Blow, Setup, Values};
use crate::stability::{Answer, Case, Expected, at_most};

/// About 1e6 and its inverse.
const LARGE: f64 = 1_048_576.0;
const SMALL: f64 = 1.0 / LARGE;

const UNITS: [(&str, [f64; 3]); 6] = [
    ("l=2^20", [LARGE, 1.0, 1.0]),
    ("l=2^-20", [SMALL, 1.0, 1.0]),
    ("t=2^20", [1.0, LARGE, 1.0]),
    ("t=2^-20", [1.0, SMALL, 1.0]),
    ("m=2^20", [1.0, 1.0, LARGE]),
    ("m=2^-20", [1.0, 1.0, SMALL]),
];

const TIME: Dimension = [0.0, 1.0, 0.0];
const IMPULSE: Dimension = [1.0, -1.0, 1.0];

/// Roundings of the parameters grow with the motion.
const MOST: f64 = 1e-11;
/// Of a run that is not the same in other units.
const EXCUSE: &str = "numbers with a dimension";

pub(super) fn cases(model: &'static dyn Model, effort: Effort) -> Vec<Case> {
    if !runs(model) {
        return Vec::new();
    }
    let units = if effort == Effort::Full { &UNITS[..] } else { &UNITS[..4] };
    let one = |&(name, units): &(&str, [f64; 3])| {
        let wants = vec![at_most("Δ times", MOST), at_most("Δ state", MOST)];
        let expected = Expected::Unless { said: SAME.to_owned(), wants, excuse: EXCUSE };
        let scene = format!("default run in units of {name}, against its own");
        case("scaling", (model, name), scene, "dimensions", expected, move || compared(model, units))
    };
    units.iter().map(one).collect()
}

fn compared(model: &dyn Model, units: [f64; 3]) -> Result<Answer, Failure> {
    let default = model.setup();
    let end = model.run(&default)?.interval()[1];
    // A condition to stop at may have numbers in it, a time is scaled.
    let setup = Setup { until: Vec::new(), limit: Some(end), ..default };
    let refused = |why: &str| Failure::Input(format!("{EXCUSE}: {why}"));
    if !setup.cut.is_empty() {
        return Err(refused("in the condition of a cut"));
    }
    let dimensions = model.dimensions(&setup).ok_or_else(|| refused("in the model"))?;
    let pair = Pair { model, natural: model.units(&setup)?, units };
    let other = model.run(&scaled(model, &setup, (&dimensions, units)))?;
    Ok(pair.compare(&*model.run(&setup)?, &*other))
}

/// The same run with its numbers in other units.
fn scaled(model: &dyn Model, setup: &Setup, (dimensions, units): (&[Dimension], [f64; 3])) -> Setup {
    let unit = |dimension: Dimension| factor(dimension, units);
    let time = unit(TIME);
    let of = |value: (&String, Dimension, f64)| (value.0.clone(), value.2 * unit(value.1));
    let parameter = |name: &String| model.layout().parameters.iter().position(|known| known == name);
    let parameters =
        setup.parameters.iter().filter_map(|(name, value)| Some((name, parameter(name)?, value)));
    Setup {
        parameters: parameters.map(|(name, i, value)| of((name, dimensions[i], *value))).collect(),
        start: pose(model, &setup.start, &unit),
        energy_of: pose(model, &setup.energy_of, &unit),
        release: setup.release.iter().map(|(support, at)| (support.clone(), at * time)).collect(),
        impulses: setup.impulses.iter().map(|blow| blown(blow, unit(IMPULSE), time)).collect(),
        limit: setup.limit.map(|limit| limit * time),
        ..setup.clone()
    }
}

fn blown(blow: &Blow, impulse: f64, time: f64) -> Blow {
    Blow { point: blow.point.clone(), impulse: blow.impulse.map(|p| p * impulse), at: blow.at * time }
}

fn pose(model: &dyn Model, values: &Values, unit: &dyn Fn(Dimension) -> f64) -> Values {
    let dimension = |name: &str| {
        let base = name.trim_end_matches('\'');
        let coordinate = model.layout().coordinates.iter().find(|coordinate| coordinate.name == base)?;
        let of = of_coordinate(coordinate);
        Some(if base == name { of } else { per(of, TIME) })
    };
    let scaled =
        values.iter().filter_map(|(name, value)| Some((name.clone(), value * unit(dimension(name)?))));
    scaled.collect()
}

fn factor(dimension: Dimension, units: [f64; 3]) -> f64 {
    dimension.iter().zip(units).map(|(power, unit)| unit.powf(*power)).product()
}
