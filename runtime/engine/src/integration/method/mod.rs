//! How the phases of a run are integrated.

mod auto;
mod dop853;
mod gauss;
mod id;
mod kinks;
mod pair;
mod radau;
mod stiffness;
mod taylor;
mod tsit5;

pub use auto::Auto;
pub use dop853::Dop853;
pub use gauss::Gauss;
pub use id::MethodId;
pub(crate) use kinks::cut;
pub use radau::Radau;
pub use taylor::Taylor;
pub use tsit5::Tsit5;

use std::cell::RefCell;
use std::rc::Rc;

use crate::system::{InitialValueProblem, PhaseStepper};

/// A way of integrating phases.
pub trait Method: Send + Sync + 'static {
    /// Its name in reports: `dop853`.
    fn name(&self) -> &'static str;
    /// Whether phases in closed form are integrated by Taylor's method, unless their damping is
    /// stiff.
    fn takes_series(&self) -> bool {
        false
    }
    /// Begins the integration of a phase; none if the tolerance is invalid.
    fn begin<'a>(&self, problem: &Problem<'a>) -> Option<StartedStepper<'a>>;
}

/// An integration that has begun.
pub struct StartedStepper<'a> {
    /// What integrates, and why.
    pub choice: Choice,
    /// The integration.
    pub stepper: Box<dyn PhaseStepper + 'a>,
    /// What integrates from later times on.
    pub(crate) switches: MethodChanges,
}

/// Changes of the method on the way, as they are made.
#[derive(Clone, Default)]
pub(crate) struct MethodChanges(Rc<RefCell<Vec<(f64, Choice)>>>);

impl MethodChanges {
    fn note(&self, t: f64, choice: Choice) {
        self.0.borrow_mut().push((t, choice));
    }

    /// When, to what and why.
    pub(crate) fn take(&self) -> Vec<(f64, Choice)> {
        self.0.take()
    }
}

impl<'a> StartedStepper<'a> {
    /// An integration by the method that was asked for.
    pub fn asked(method: &dyn Method, stepper: Box<dyn PhaseStepper + 'a>) -> Self {
        let choice = Choice { method: method.name(), why: "asked for" };
        Self { choice, stepper, switches: MethodChanges::default() }
    }

    /// The same with another reason.
    #[must_use]
    pub fn because(mut self, why: &'static str) -> Self {
        self.choice.why = why;
        self
    }
}

/// The method that integrates a phase, and why.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Choice {
    /// Its name: `taylor`.
    pub method: &'static str,
    /// The reason: `asked for`.
    pub why: &'static str,
}

/// A phase to integrate, with what a method may choose by.
#[derive(Clone, Copy)]
pub struct Problem<'a> {
    /// The equations, the start, the end and the tolerance.
    pub problem: InitialValueProblem<'a>,
    /// The natural time of the model.
    pub time: f64,
    /// Whether the model has dampers.
    pub damped: bool,
}

/// The methods that its phase names.
impl<'a> Problem<'a> {
    fn start_dop853(&self) -> Option<Box<dyn PhaseStepper + 'a>> {
        (self.problem.phase.methods().explicit?.dop853)(&self.problem)
    }

    fn start_tsit5(&self) -> Option<Box<dyn PhaseStepper + 'a>> {
        (self.problem.phase.methods().explicit?.tsit5)(&self.problem)
    }

    fn start_taylor(&self) -> Option<Box<dyn PhaseStepper + 'a>> {
        (self.problem.phase.methods().explicit?.taylor)(&self.problem)
    }

    fn start_implicit(&self) -> Option<Box<dyn PhaseStepper + 'a>> {
        self.problem.phase.methods().implicit?(&self.problem)
    }
}
