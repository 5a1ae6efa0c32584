//! How a run is computed.

use super::Integrator;
use crate::Simulation;
use crate::model::{BarSystem, Form};
use core::sync::atomic::AtomicBool;

/// How a run is computed: by which method, from which equations, and until when.
#[derive(Clone, Copy, Debug)]
pub struct Way {
    /// The method of integration.
    pub method: Integrator,
    /// The equations, where a phase has both.
    pub form: Form,
    /// What stops it once it is true.
    pub cancel: Option<&'static AtomicBool>,
}

impl Way {
    /// By this method.
    pub fn by(method: Integrator) -> Self {
        Self { method, ..Self::default() }
    }

    /// The same, stopped once this is true.
    #[must_use]
    pub fn cancel(self, flag: &'static AtomicBool) -> Self {
        Self { cancel: Some(flag), ..self }
    }

    /// The same simulation in this way.
    pub(super) fn of<M: BarSystem>(self, simulation: Simulation<M>) -> Simulation<M> {
        let simulation = self.method.of(simulation).form(self.form);
        match self.cancel {
            Some(flag) => simulation.cancel(flag),
            None => simulation,
        }
    }
}

impl Default for Way {
    /// As the product chooses, to the end.
    fn default() -> Self {
        Self { method: Integrator::Auto, form: Form::Closed, cancel: None }
    }
}
