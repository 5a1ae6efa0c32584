//! Values of variables.

use super::{Begun, Instance};
use crate::exchange::Bands;
use crate::settings::variable;
use liftoff_fmu::{Guard, Quantity, Variable};

impl Instance {
    /// `fmi3GetFloat64`. What follows from the motion is that of the start before it has begun.
    pub(crate) fn floats(&mut self, references: &[u32]) -> Result<Vec<f64>, String> {
        let mut moves = false;
        for &reference in references {
            let (_, Variable { name, quantity, .. }) = variable(&self.interface, reference)?;
            if quantity.is_integer() {
                return Err(format!("`{name}` is no Float64"));
            }
            moves |= !matches!(quantity, Quantity::Time | Quantity::Parameter(_));
        }
        if moves {
            self.begin()?;
        }
        let (values, guards) = (self.values(), self.guards());
        references.iter().map(|&reference| self.float(reference, &values, &guards)).collect()
    }

    fn values(&self) -> Vec<f64> {
        self.instant().map_or_else(Vec::new, |(simulation, place)| self.readings.evaluate(simulation, place))
    }

    /// Event indicators, in the order of their variables.
    fn guards(&self) -> Vec<(Guard, f64)> {
        let Some((simulation, place)) = self.instant() else { return Vec::new() };
        let tolerance = self.experiment.tolerance.unwrap_or(super::TOLERANCE);
        let bands = match &self.begun {
            Some(Begun::Exchange(exchange)) => exchange.bands(),
            _ => Bands { tolerance, loose: &[] },
        };
        self.indicators.named(simulation, place, bands)
    }

    fn float(&self, reference: u32, values: &[f64], guards: &[(Guard, f64)]) -> Result<f64, String> {
        let (place, variable) = variable(&self.interface, reference)?;
        let value = match variable.quantity {
            Quantity::Time => Some(self.instant().map_or(self.experiment.start, |(_, place)| place.t)),
            Quantity::Parameter(_) => self.settings.value(variable),
            Quantity::Guard(guard) => {
                guards.iter().find(|(known, _)| *known == guard).map(|(_, value)| *value)
            }
            _ => self.readings.value(values, place),
        };
        value.ok_or_else(|| format!("`{}` has no value", variable.name))
    }

    /// `fmi3GetInt32` and `fmi3GetInt64`: the count of events is one, states of contacts are the
    /// other.
    pub(crate) fn integers(
        &mut self,
        references: &[u32],
        is: fn(&Quantity) -> bool,
    ) -> Result<Vec<i64>, String> {
        self.begin()?;
        let Some((_, place)) = self.instant() else { return Err("the motion has not begun".to_owned()) };
        let of = |variable: &Variable| {
            let value = place.integer(&self.interface, &variable.quantity);
            value
                .filter(|_| is(&variable.quantity))
                .ok_or_else(|| format!("`{}` has another type", variable.name))
        };
        references.iter().map(|&reference| of(variable(&self.interface, reference)?.1)).collect()
    }
}
