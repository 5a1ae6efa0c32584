//! Motion without events: a stepper and what it steps through, nothing round it. No guard, contact
//! or impact is compiled for it, and without the standard library nothing is allocated.

use core::marker::PhantomData;

use crate::integrate::{
    Dop853, Expansion, ExpansionBy, PhaseExpansion, StepError, StepState, Stepper, Taylor, Tolerance,
    ToleranceError,
};
use crate::model::{Array, BarSystem, ContactSet, Form, Phase, PhaseSeries, PhaseVisitor};
use crate::project::project;
use crate::scalar::Double;
use crate::scalar::dispatch::{ForDouble, by_doubles};
use crate::scales::Scales;

/// Why a motion was not computed.
#[derive(Clone, Copy, PartialEq, Debug, thiserror::Error)]
pub enum FlowError {
    /// The tolerance is none, or the model has no natural scales: a parameter is not a number.
    #[error(transparent)]
    Tolerance(#[from] ToleranceError),
    /// A step failed.
    #[error(transparent)]
    Step(#[from] StepError),
    /// Guides with friction stick and slide in turn, and press to one side or the other: there is
    /// no one phase to integrate.
    #[error("guides with friction change their state during the motion; run a `Simulation`")]
    Guides,
}

/// The full state a `duration` > 0 later with all contacts open, if the model has any: they are not
/// watched. `state` has the coordinates in the order of the layout, the rates and, where
/// [`Layout::timed`](crate::model::Layout::timed), the time, and satisfies the joints.
///
/// The error per step is relative to each entry and, in natural units, absolute, as that of a
/// `Simulation`. Closed forms are integrated by Taylor's method, unless their equations are
/// somewhere not analytic ([`Layout::kinks`](crate::model::Layout::kinks)), others by DOP853 with
/// projection.
///
/// # Errors
/// If the tolerance is none, a guide has friction, or a step fails.
///
/// ```
/// use liftoff::{BarSystem, flow};
///
/// #[derive(BarSystem)]
/// #[gravity(g)]
/// #[bar(OA, mass = m, length = l)]
/// #[pin(O = (0, 0))]
/// #[figure(A = (l, 0))]
/// #[coordinate(phi = angle(OA), from = horizontal)]
/// struct Pendulum {
///     m: f64,
///     l: f64,
///     g: f64,
/// }
///
/// let pendulum = Pendulum { m: 1.0, l: 1.0, g: 9.81 };
/// let [phi, rate] = flow(&pendulum, &[0.0, 0.0], 1.0, 1e-12)?;
/// // ⅙ m l² φ̇² = −½ m g l sin φ
/// assert!((rate * rate + 3.0 * 9.81 * phi.sin()).abs() < 1e-10);
/// # Ok::<(), liftoff::FlowError>(())
/// ```
pub fn flow<M: BarSystem>(
    model: &M,
    state: &M::State<f64>,
    duration: f64,
    tolerance: f64,
) -> Result<M::State<f64>, FlowError> {
    if const { M::LAYOUT.has_guides() } {
        return Err(FlowError::Guides);
    }
    let (constants, measures, nominal) = (model.constants(), model.measures(), model.nominal());
    let scales = Scales::natural(M::LAYOUT, measures.as_ref(), nominal.as_ref());
    M::phase(
        ContactSet::EMPTY,
        Form::Reduced,
        Flow { model, constants: &constants, scales, state, duration, tolerance },
    )
}

struct Flow<'a, M: BarSystem> {
    #[allow(dead_code, reason = "for doubles that the target need not have")]
    model: &'a M,
    constants: &'a M::Constants<f64>,
    scales: Scales,
    state: &'a M::State<f64>,
    duration: f64,
    tolerance: f64,
}

impl<M: BarSystem> Flow<'_, M> {
    fn start<const N: usize>(&self, phase: &Phase<M, f64, N>) -> Result<StepState<f64, N>, FlowError> {
        let absolute = |i| self.tolerance * self.scales.entry(M::LAYOUT, i);
        let absolute = (phase.restrict)(&M::State::from_fn(absolute));
        let tolerance = Tolerance::new(self.tolerance, absolute)?;
        Ok(StepState::new(tolerance, 0.0, (phase.restrict)(self.state)).with_end(self.duration))
    }
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Flow<'_, M> {
    type Output = Result<M::State<f64>, FlowError>;

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> Self::Output {
        let rates = |y: &[f64; N]| (phase.derivative)(self.constants, &phase.set, y);
        let mut stepper = Dop853::new(&rates, self.start(&phase)?);
        let mut work = M::Accelerations::from_fn(|_| 0.0);
        while stepper.step_state().time() < self.duration {
            stepper.step()?;
            let mut state = (phase.embed)(self.constants, stepper.step_state().state());
            let length = self.scales.length;
            project::<M, f64>(self.constants, &phase.set, &mut state, length, work.as_mut());
            stepper.replace_end((phase.restrict)(&state))?;
        }
        Ok((phase.embed)(self.constants, stepper.step_state().state()))
    }

    fn visit_series<const N: usize, Q: PhaseSeries<M, N>>(self, phase: Phase<M, f64, N>) -> Self::Output {
        if const { !M::LAYOUT.kinks.is_empty() } {
            return self.visit(phase);
        }
        by_doubles(FlowBy::<M, Q, N> { flow: self, phase, series: PhantomData })
    }
}

/// A motion by Taylor's method.
struct FlowBy<'a, M: BarSystem, Q, const N: usize> {
    flow: Flow<'a, M>,
    phase: Phase<M, f64, N>,
    series: PhantomData<Q>,
}

impl<M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> ForDouble for FlowBy<'_, M, Q, N> {
    type Output = Result<M::State<f64>, FlowError>;

    fn plain(self) -> Self::Output {
        let constants = self.flow.constants;
        self.run(PhaseExpansion::<M, Q, N>::new(constants))
    }

    fn with<S: Double>(self) -> Self::Output {
        let constants = self.flow.model.constants();
        self.run(ExpansionBy::<_, S, M, Q, N>::new(&constants))
    }
}

impl<M: BarSystem, Q, const N: usize> FlowBy<'_, M, Q, N> {
    fn run(self, expansion: impl Expansion<N>) -> Result<M::State<f64>, FlowError> {
        let Self { flow, phase, .. } = self;
        let mut stepper = Taylor::new(expansion, flow.start(&phase)?);
        while stepper.step_state().time() < flow.duration {
            stepper.step()?;
        }
        Ok((phase.embed)(flow.constants, stepper.step_state().state()))
    }
}
