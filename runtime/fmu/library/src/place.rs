//! Where a motion is, and what is read there.

use liftoff::{Output, Segment, Simulation};
use liftoff_fmu::{ContactState, Interface, Quantity};

/// Where a motion is.
#[derive(Debug, Clone)]
pub(crate) struct Instant {
    /// The time, s.
    pub(crate) t: f64,
    /// Coordinates, then rates.
    pub(crate) state: Vec<f64>,
    /// The phase that it is in.
    pub(crate) phase: Segment,
    /// How many events there have been since the start, which is none.
    pub(crate) events: i32,
}

/// What is read of a motion: an expression for each variable that has one.
#[derive(Debug, Clone)]
pub(crate) struct Readings {
    outputs: Vec<Output>,
    /// The place among the outputs of each variable.
    of: Vec<Option<usize>>,
}

impl Readings {
    /// Those of the variables.
    ///
    /// # Errors
    /// An expression that the model does not have, as none is.
    pub(crate) fn from_interface(interface: &Interface) -> Result<Self, String> {
        let (mut outputs, mut of) = (Vec::new(), Vec::new());
        for variable in &interface.variables {
            of.push(variable.expression.as_ref().map(|_| outputs.len()));
            if let Some(text) = &variable.expression {
                outputs.push(Output::parse(interface.layout, text).map_err(|error| error.to_string())?);
            }
        }
        Ok(Self { outputs, of })
    }

    /// All values at a place.
    pub(crate) fn evaluate(&self, simulation: &Simulation, place: &Instant) -> Vec<f64> {
        simulation.values(&place.phase, (place.t, &place.state), &self.outputs)
    }

    /// That of a variable among all.
    pub(crate) fn value(&self, values: &[f64], reference: usize) -> Option<f64> {
        values.get((*self.of.get(reference)?)?).copied()
    }
}

impl Instant {
    /// The value of a variable that is an integer.
    pub(crate) fn integer(&self, interface: &Interface, quantity: &Quantity) -> Option<i64> {
        match *quantity {
            Quantity::Contact(i) => {
                Some(ContactState::new(self.phase.set, i, &interface.layout.contacts[i]) as i64)
            }
            Quantity::Events => Some(self.events.into()),
            _ => None,
        }
    }
}
