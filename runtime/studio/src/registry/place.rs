//! Where a value is given: its name, and what it is measured in.

use super::Units;
use super::run_spec::TIME;
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

    /// Names that can be given.
    pub fn names(self, layout: &Layout) -> Vec<String> {
        match self {
            Self::Parameter => layout.parameters.iter().map(|name| (*name).to_owned()).collect(),
            Self::Start => layout.names_of_motion().chain([TIME.to_owned()]).collect(),
            Self::EnergyOf => layout.names_of_motion().collect(),
            Self::Release => {
                let supports = layout.contacts.iter().flat_map(|contact| contact.supports);
                supports.map(|support| (*support).to_owned()).collect()
            }
        }
    }

    /// What they are names of.
    pub const fn kind(self) -> &'static str {
        match self {
            Self::Parameter => "parameter",
            Self::Start | Self::EnergyOf => "coordinate",
            Self::Release => "support",
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
        let measured = if self == Self::Release { TIME } else { name };
        let checked = Units::from_layout(layout).check(measured, unit);
        checked.map_err(|wrong| format!("--{} {name}: {wrong}", self.word()))
    }
}
