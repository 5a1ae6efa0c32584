//! How the phases of a run are integrated.
//!
//! A method is named in `Simulation::method`; only those that a program names are compiled.

mod auto;
mod dop853;
mod gauss;
mod radau;
mod taylor;
mod tsit5;

pub use auto::Auto;
pub use dop853::Dop853;
pub use gauss::Gauss;
pub use radau::Radau;
pub use taylor::Taylor;
pub use tsit5::Tsit5;

use crate::integrate::{Progress, Rates, Stepper};
use crate::model::{BarSystem, ContactSet, Form, Phase, PhaseSeries, PhaseVisitor};
use crate::segment::{Drive, Outcome};

/// A way of integrating phases.
pub trait Method: 'static {
    /// Its name in reports: `dop853`.
    fn name(&self) -> &'static str;
    /// Whether phases in closed form are integrated by Taylor's method, unless their damping is stiff.
    fn takes_series(&self) -> bool {
        false
    }
    /// An integration of a phase from its start.
    fn begin<'a, M: BarSystem, const N: usize>(&self, problem: Problem<'a, M, N>) -> Begun<'a, N>;
    /// The same for a phase in closed form, whose Taylor series are `Q`.
    fn begin_series<'a, M: BarSystem, const N: usize, Q: PhaseSeries<M, N>>(
        &self,
        problem: Problem<'a, M, N>,
    ) -> Begun<'a, N> {
        self.begin(problem)
    }
}

/// An integration that has begun.
pub struct Begun<'a, const N: usize> {
    /// What integrates, and why.
    pub choice: Choice,
    /// The integration.
    pub stepper: Box<dyn Stepper<f64, N> + 'a>,
}

impl<'a, const N: usize> Begun<'a, N> {
    /// An integration by the method that was asked for.
    pub fn asked(method: &impl Method, stepper: impl Stepper<f64, N> + 'a) -> Self {
        Self { choice: Choice { method: method.name(), why: "asked for" }, stepper: Box::new(stepper) }
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

/// A phase to integrate.
pub struct Problem<'a, M: BarSystem, const N: usize> {
    /// The phase.
    pub phase: &'a Phase<M, f64, N>,
    /// Constants of its equations.
    pub constants: &'a M::Constants<f64>,
    /// The model's parameters, from which constants of another scalar can be made.
    pub parameters: &'a [f64],
    /// The natural time of the model.
    pub time: f64,
    /// Whether the model has dampers.
    pub damped: bool,
    /// Its right-hand side.
    pub rates: Rates<'a, f64, N>,
    /// Where it starts, with the tolerance and the end.
    pub progress: Progress<f64, N>,
}

/// A [`Method`] for one model.
pub(crate) trait MethodOf<M: BarSystem> {
    #[cfg(feature = "ensemble")]
    fn takes_series(&self) -> bool;
    fn drive(&self, set: ContactSet, form: Form, drive: Drive<'_, M>) -> Outcome<M>;
}

impl<M: BarSystem, I: Method> MethodOf<M> for I {
    #[cfg(feature = "ensemble")]
    fn takes_series(&self) -> bool {
        Method::takes_series(self)
    }

    fn drive(&self, set: ContactSet, form: Form, drive: Drive<'_, M>) -> Outcome<M> {
        M::phase(set, form, Driven { method: self, drive })
    }
}

struct Driven<'a, 'b, M: BarSystem, I> {
    method: &'a I,
    drive: Drive<'b, M>,
}

impl<M: BarSystem, I: Method> PhaseVisitor<M, f64> for Driven<'_, '_, M, I> {
    type Output = Outcome<M>;

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> Outcome<M> {
        self.drive.run(phase, &|problem| self.method.begin(problem))
    }

    fn visit_series<const N: usize, Q: PhaseSeries<M, N>>(self, phase: Phase<M, f64, N>) -> Outcome<M> {
        self.drive.run(phase, &|problem| self.method.begin_series::<M, N, Q>(problem))
    }
}
