//! Where a value is given: its name, and what it is measured in.

use liftoff::expression::Formula;
use liftoff::expression::si_unit::{METRE, RADIAN, SECOND, SiUnit};
use liftoff::model::{Dimension, Layout};

/// Where a value is given.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Place {
    /// Among the parameters.
    Parameter,
    /// At the start.
    Start,
    /// In the pose whose energy a run starts with.
    EnergyOf,
    /// At which a support vanishes.
    Release,
}

impl Place {
    /// The option on the command line.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Parameter => "set",
            Self::Start => "start",
            Self::EnergyOf => "energy-of",
            Self::Release => "release",
        }
    }

    /// Refuses a name that is given twice.
    pub fn check_names(self, names: &[&str]) -> Result<(), String> {
        match (1..names.len()).find(|&i| names[..i].contains(&names[i])) {
            Some(i) => Err(format!("--{}: `{}` is given twice", self.word(), names[i])),
            None => Ok(()),
        }
    }

    /// Refuses a unit that does not measure what has this name. Of unknown names, and where the declaration leaves the dimension
    /// of a parameter open, every unit is taken.
    pub fn check_unit(self, layout: &Layout, name: &str, unit: Option<SiUnit>) -> Result<(), String> {
        let Some((given, expected)) = unit.zip(self.unit(layout, name)) else { return Ok(()) };
        if given.agrees(expected) {
            return self.check_system(layout, name, given);
        }
        let symbol = |unit: SiUnit| match unit.symbol() {
            symbol if symbol.is_empty() => "nothing".to_owned(),
            symbol => symbol,
        };
        Err(format!("--{} {name}: measured in {}, not in {}", self.word(), symbol(expected), symbol(given)))
    }

    /// Refuses a unit, which would be read in SI units, where the declaration measures in others.
    fn check_system(self, layout: &Layout, name: &str, given: SiUnit) -> Result<(), String> {
        if given.agrees(SiUnit::default()) {
            return Ok(());
        }
        let other = layout.parameters.iter().enumerate().find_map(|(i, parameter)| {
            let unit = layout.defaults.unit(i);
            is_other_system(unit).then(|| format!("{parameter} in {unit}"))
        });
        let told = |other| {
            format!(
                "--{} {name}: a unit stands for SI units, and the declaration has {other}; give the number alone",
                self.word()
            )
        };
        other.map_or(Ok(()), |other| Err(told(other)))
    }

    fn unit(self, layout: &Layout, name: &str) -> Option<SiUnit> {
        if self == Self::Parameter {
            let index = layout.parameters.iter().position(|known| *known == name)?;
            return layout.dimensions.get(index).copied().flatten().and_then(coherent);
        }
        if self == Self::Release {
            return Some(SECOND);
        }
        let bare = name.strip_suffix('\'').unwrap_or(name);
        let coordinate = layout.coordinates.iter().find(|coordinate| coordinate.name == bare)?;
        let unit = if coordinate.is_angle { RADIAN } else { METRE };
        Some(if bare == name { unit } else { unit.times(SECOND, -1) })
    }
}

/// Whether a unit as declared is known, and not that of the SI: `mm`.
fn is_other_system(unit: &str) -> bool {
    let one = Formula::parse(&format!("1 {unit}"), &[]).ok();
    let measured = one.filter(|one| one.unit().is_some_and(|unit| !unit.agrees(SiUnit::default())));
    measured.is_some_and(|one| one.value(&[]) != 1.0)
}

/// The unit of a dimension whose powers are whole numbers.
fn coherent(Dimension { numerators, denominator }: Dimension) -> Option<SiUnit> {
    let whole = denominator != 0 && numerators.iter().all(|n| n % denominator == 0);
    let [length, time, mass] = numerators.map(|n| n.checked_div(denominator).unwrap_or(0));
    whole.then(|| SiUnit::new(mass, length, time, 0))
}
