//! How a run is computed.

use super::MethodId;
use liftoff::{Budget, Simulation};
use liftoff_core::model::Form;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// How a run is computed: by which method, from which equations, and until when.
#[derive(Clone, Debug)]
pub struct RunOptions {
    /// The method of integration.
    pub method: MethodId,
    /// The equations, where a phase has both.
    pub form: Form,
    /// Stops the run once it is true.
    pub cancel: Option<Arc<AtomicBool>>,
    /// What the run may take.
    pub budget: Budget,
}

impl RunOptions {
    /// By this method.
    pub fn by(method: MethodId) -> Self {
        Self { method, ..Self::default() }
    }

    /// The same, stopped once this is true.
    #[must_use]
    pub fn cancel(self, flag: Arc<AtomicBool>) -> Self {
        Self { cancel: Some(flag), ..self }
    }

    /// The same within these limits.
    #[must_use]
    pub fn budget(self, budget: Budget) -> Self {
        Self { budget, ..self }
    }

    /// A simulation with these options.
    pub(super) fn apply(self, simulation: Simulation) -> Simulation {
        let simulation = simulation.method(self.method).form(self.form).budget(self.budget);
        match self.cancel {
            Some(flag) => simulation.cancel(flag),
            None => simulation,
        }
    }
}

impl Default for RunOptions {
    /// As the product chooses, to the end.
    fn default() -> Self {
        Self { method: MethodId::Auto, form: Form::Reduced, cancel: None, budget: Budget::default() }
    }
}
