//! What importers have set before the start.

use liftoff_fmu::{Interface, Quantity, Variable};
use liftoff_studio::RunSpec;
use liftoff_studio::run_spec::{Values, overridden};

/// What has been set, in the order of setting.
#[derive(Debug, Clone, Default)]
pub(crate) struct Settings {
    parameters: Values,
    start: Values,
}

impl Settings {
    /// Sets a variable.
    ///
    /// # Errors
    /// It is none that can be set.
    pub(crate) fn set(&mut self, variable: &Variable, value: f64) -> Result<(), String> {
        let list = match variable.quantity {
            Quantity::Parameter(_) => &mut self.parameters,
            Quantity::State { .. } => &mut self.start,
            _ => return Err(format!("`{}` cannot be set: it follows from the motion", variable.name)),
        };
        if !value.is_finite() {
            return Err(format!("`{}` cannot be set to {value}", variable.name));
        }
        let name = variable.expression.as_ref().unwrap_or(&variable.name);
        *list = overridden(core::mem::take(list), &[(name.clone(), value)]);
        Ok(())
    }

    /// The value of a variable that can be set.
    pub(crate) fn value(&self, variable: &Variable) -> Option<f64> {
        let name = variable.expression.as_ref().unwrap_or(&variable.name);
        let set = self.parameters.iter().chain(&self.start).find(|(known, _)| known == name);
        set.map(|(_, value)| *value).or(variable.start)
    }

    /// A run with these values in place of others. A start that is set drops an energy level.
    pub(crate) fn spec(&self, spec: &RunSpec) -> RunSpec {
        let energy_of = if self.start.is_empty() { spec.energy_of.clone() } else { Vec::new() };
        RunSpec {
            parameters: overridden(spec.parameters.clone(), &self.parameters),
            start: overridden(spec.start.clone(), &self.start),
            energy_of,
            ..spec.clone()
        }
    }
}

/// The variable of a value reference.
///
/// # Errors
/// There is none.
pub(crate) fn variable(interface: &Interface, reference: u32) -> Result<(usize, &Variable), String> {
    let place = reference as usize;
    let found = interface.variables.get(place).map(|variable| (place, variable));
    found.ok_or_else(|| format!("no variable has the value reference {reference}"))
}
