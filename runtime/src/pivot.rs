//! Where a closed form can be trusted. A coordinate is eliminated by 1/p with p its pivot relative to its natural size,
//! its second derivative by 1/p³: rounding ε/p³ must stay below the tolerance.

use crate::model::{BarSystem, ContactSet, Form, Phase, PhaseVisitor};

/// Below this the elimination is all but singular, however loose the tolerance.
const SINGULAR: f64 = 1e-3;
/// Above this no closed form is given up, however tight the tolerance.
const REGULAR: f64 = 0.3;
/// Roundings in one elimination, their cube root.
const MARGIN: f64 = 3.0;

/// The least pivot for a tolerance.
pub(crate) fn least_pivot(tolerance: f64) -> f64 {
    (MARGIN * (f64::EPSILON / tolerance).cbrt()).clamp(SINGULAR, REGULAR)
}

/// The closed form where it is asked for and its pivots at the state are large enough for the tolerance.
pub(crate) fn form_at<M: BarSystem>(
    constants: &M::Constants<f64>,
    set: ContactSet,
    asked: Form,
    state: &M::State<f64>,
    tolerance: f64,
) -> Form {
    M::phase(set, asked, Judge { constants, state, least: least_pivot(tolerance) })
}

struct Judge<'a, M: BarSystem> {
    constants: &'a M::Constants<f64>,
    state: &'a M::State<f64>,
    least: f64,
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Judge<'_, M> {
    type Output = Form;

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> Form {
        let pivot = (phase.pivot)(self.constants, &(phase.restrict)(self.state));
        if pivot >= self.least { phase.form } else { Form::Projected }
    }
}
