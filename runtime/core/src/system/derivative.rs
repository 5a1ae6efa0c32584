//! ẏ = f(y) of a closed form by doubles that the processor multiplies and adds in one instruction,
//! where the target need not.

use core::marker::PhantomData;
use std::sync::OnceLock;

use super::lifted::Lifted;
use crate::model::{BarSystem, ClosedForm, ContactSet};
use crate::scalar::dispatch::{ForDouble, by_doubles};
use crate::scalar::{Double, Inside, Real};

/// Writes the derivative of a reduced state in the one contact set of a phase.
pub(super) trait Derivative<M: BarSystem, S: Real, const N: usize>: Send + Sync {
    fn write(&self, system: &Lifted<M, S>, set: &ContactSet, y: &[S; N], derivative: &mut [S; N]);
}

/// That of a closed form; none where the target's own doubles are as good.
pub(super) fn fused<M: BarSystem, Q: ClosedForm<M, N>, const N: usize>()
-> Option<Box<dyn Derivative<M, f64, N>>> {
    by_doubles(Find::<M, Q, N>(PhantomData))
}

struct Find<M, Q, const N: usize>(PhantomData<(M, Q)>);

impl<M: BarSystem, Q: ClosedForm<M, N>, const N: usize> ForDouble for Find<M, Q, N> {
    type Output = Option<Box<dyn Derivative<M, f64, N>>>;

    fn plain(self) -> Self::Output {
        None
    }

    fn with<S: Double>(self) -> Self::Output {
        Some(Box::new(By::<M, Q, S, N> { constants: OnceLock::new(), form: PhantomData }))
    }
}

/// The constants are made where they are first needed: by Taylor series never.
struct By<M: BarSystem, Q, S: Double, const N: usize> {
    constants: OnceLock<M::Constants<S>>,
    form: PhantomData<fn() -> Q>,
}

impl<M: BarSystem, Q: ClosedForm<M, N>, S: Double, const N: usize> Derivative<M, f64, N> for By<M, Q, S, N> {
    fn write(&self, system: &Lifted<M, f64>, set: &ContactSet, y: &[f64; N], derivative: &mut [f64; N]) {
        let constants = self.constants.get_or_init(|| M::constants_from(system.parameters.as_ref(), set));
        S::inside(One::<M, Q, S, N> { constants, y, derivative, form: PhantomData });
    }
}

struct One<'a, M: BarSystem, Q, S: Double, const N: usize> {
    constants: &'a M::Constants<S>,
    y: &'a [f64; N],
    derivative: &'a mut [f64; N],
    form: PhantomData<Q>,
}

impl<M: BarSystem, Q: ClosedForm<M, N>, S: Double, const N: usize> Inside for One<'_, M, Q, S, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        *self.derivative = Q::derivative(self.constants, &self.y.map(S::from_f64)).map(S::value);
    }
}
