//! Where a value is given: its name, and what it is measured in.

use super::Units;
use liftoff::__private::expression::si_unit::SiUnit;
use liftoff_core::model::Layout;

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

    /// Refuses a unit that does not measure what has this name. Of unknown names, and where the
    /// declaration leaves the dimension of a parameter open, every unit is taken.
    pub fn check_unit(self, layout: &'static Layout, name: &str, unit: Option<SiUnit>) -> Result<(), String> {
        let measured = if self == Self::Release { "t" } else { name };
        let checked = Units::from_layout(layout).check(measured, unit);
        checked.map_err(|wrong| format!("--{} {name}: {wrong}", self.word()))
    }
}
