//! Dimensions in words.

use super::Dimension;
use crate::algebra::Rational;

/// Dimensions that have a name in mechanics, by powers of length, time and mass.
const NAMES: [([i64; 3], &str); 15] = [
    ([0, 0, 0], "a pure number"),
    ([1, 0, 0], "a length"),
    ([0, 1, 0], "a time"),
    ([0, 0, 1], "a mass"),
    ([1, -1, 0], "a velocity"),
    ([1, -2, 0], "an acceleration"),
    ([0, -1, 0], "a rate (1/time)"),
    ([2, 0, 0], "an area"),
    ([2, 0, 1], "a moment of inertia"),
    ([1, -2, 1], "a force"),
    ([2, -2, 1], "a torque (force length)"),
    ([0, -2, 1], "a stiffness (force/length)"),
    ([0, -1, 1], "a damping (force/velocity)"),
    ([2, -1, 1], "a torsional damping (torque time)"),
    ([1, -1, 1], "a momentum"),
];

/// `a force`; `length^3/time` for what has no name.
pub(super) fn name(dimension: Dimension) -> String {
    let named = NAMES.iter().find(|(powers, _)| dimension == powers.map(Rational::from));
    named.map_or_else(|| units(dimension), |(_, name)| (*name).to_owned())
}

fn units(dimension: Dimension) -> String {
    let units = ["length", "time", "mass"];
    let factor = |(unit, power): (&str, Rational)| match power {
        power if power.is_zero() => None,
        Rational::ONE => Some(unit.to_owned()),
        power if power.denominator() == 1 => Some(format!("{unit}^{power}")),
        power => Some(format!("{unit}^({power})")),
    };
    units.into_iter().zip(dimension).filter_map(factor).collect::<Vec<_>>().join(" ")
}
