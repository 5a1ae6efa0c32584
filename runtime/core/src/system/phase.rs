//! A phase of a compiled model, its dimension forgotten.

use core::marker::PhantomData;
use std::sync::Arc;

use super::arrays::to_array;
use super::derivative::{Derivative, fused};
use super::jacobian::{self, JacobianOf};
use super::lifted::{Liftable, Lifted};
use super::projected::{KernelOrders, TakeOrder, projected_series};
use super::{Jacobian, PhaseEquations, System};
use crate::integrate::{ExpansionBy, PhaseExpansion};
use crate::model::{
    self, Array, BarSystem, ClosedForm, ContactSet, Energy, Form, KernelSeries, OfState, PhaseSeries,
    PhaseVisitor, Pivots, Varying,
};
use crate::scalar::dispatch::{ForDouble, by_doubles};
use crate::scalar::{Double, DoubleDouble, Dual4, Scalar};
use crate::series::TaylorTape;
use crate::system::{Methods, SeriesExpansion};

/// What a phase is and how large.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct PhaseInfo {
    /// The closed contacts.
    pub set: ContactSet,
    /// Closed form or projected.
    pub form: Form,
    /// How many entries of the reduced state are coordinates; they come first.
    pub coordinates: usize,
    /// How many entries are rates; they follow.
    pub rates: usize,
    /// All entries: the last is the time, if the equations depend on it.
    pub entries: usize,
    /// Whether reactions, gaps, slip velocities and feet are affine functions of the reduced state,
    /// with constant coefficients.
    pub affine: bool,
}

impl PhaseInfo {
    /// The places of the rates in the reduced state.
    pub const fn places_of_rates(&self) -> core::ops::Range<usize> {
        self.coordinates..self.coordinates + self.rates
    }
}

impl Liftable for f64 {
    fn lift<M: BarSystem>(
        system: Arc<Lifted<M, f64>>,
        set: ContactSet,
        form: Form,
    ) -> Arc<dyn PhaseEquations> {
        M::phase(set, form, WithSeries(system))
    }
}

impl Liftable for DoubleDouble {
    fn lift<M: BarSystem>(
        system: Arc<Lifted<M, Self>>,
        set: ContactSet,
        form: Form,
    ) -> Arc<dyn PhaseEquations<Self>> {
        M::phase(set, form, Plain(system))
    }
}

impl Liftable for Dual4 {
    fn lift<M: BarSystem>(
        system: Arc<Lifted<M, Self>>,
        set: ContactSet,
        form: Form,
    ) -> Arc<dyn PhaseEquations<Self>> {
        M::phase(set, form, Plain(system))
    }
}

struct WithSeries<M: BarSystem>(Arc<Lifted<M, f64>>);

impl<M: BarSystem> PhaseVisitor<M, f64> for WithSeries<M> {
    type Output = Arc<dyn PhaseEquations>;

    fn visit<const N: usize>(self, phase: model::Phase<M, f64, N>) -> Self::Output {
        let jacobian = jacobian::of_projected::<M, N>();
        Arc::new(LiftedPhase { jacobian, ..LiftedPhase::new(self.0, phase) })
    }

    fn visit_projected<const N: usize, Q: KernelSeries<M, N>>(
        self,
        phase: model::Phase<M, f64, N>,
    ) -> Self::Output {
        let jacobian = jacobian::of_projected::<M, N>();
        let series: SeriesOf<M, f64> = |system, set| {
            let orders = OrdersOf::<M, Q, N> {
                constants: &system.constants,
                tape: Box::default(),
                series: PhantomData,
            };
            projected_series(M::LAYOUT, set, Box::new(orders))
        };
        Arc::new(LiftedPhase { jacobian, series: Some(series), ..LiftedPhase::new(self.0, phase) })
    }

    fn visit_closed<const N: usize, Q: ClosedForm<M, N>>(
        self,
        phase: model::Phase<M, f64, N>,
    ) -> Self::Output {
        Arc::new(LiftedPhase::of_closed::<Q>(self.0, phase))
    }

    fn visit_series<const N: usize, Q: PhaseSeries<M, N>>(
        self,
        phase: model::Phase<M, f64, N>,
    ) -> Self::Output {
        let series: SeriesOf<M, f64> =
            |system, set| Some(by_doubles(SeriesBy::<M, Q, N> { system, set, series: PhantomData }));
        let products = <Q::Columns<f64> as TaylorTape<f64>>::COLUMNS;
        Arc::new(LiftedPhase { series: Some(series), products, ..LiftedPhase::of_closed::<Q>(self.0, phase) })
    }
}

struct Plain<M: BarSystem, S: Scalar>(Arc<Lifted<M, S>>);

impl<M: BarSystem, S: Liftable> PhaseVisitor<M, S> for Plain<M, S> {
    type Output = Arc<dyn PhaseEquations<S>>;

    fn visit<const N: usize>(self, phase: model::Phase<M, S, N>) -> Self::Output {
        Arc::new(LiftedPhase::new(self.0, phase))
    }
}

type SeriesOf<M, S> = for<'a> fn(&'a Lifted<M, S>, ContactSet) -> Option<Box<dyn SeriesExpansion + 'a>>;

/// The series of a closed form.
struct SeriesBy<'a, M: BarSystem, Q, const N: usize> {
    system: &'a Lifted<M, f64>,
    #[allow(dead_code, reason = "for doubles that the target need not have")]
    set: ContactSet,
    series: PhantomData<Q>,
}

impl<'a, M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> ForDouble for SeriesBy<'a, M, Q, N> {
    type Output = Box<dyn SeriesExpansion + 'a>;

    fn plain(self) -> Self::Output {
        Box::new(PhaseExpansion::<M, Q, N>::new(&self.system.constants))
    }

    fn with<S: Double>(self) -> Self::Output {
        let constants = M::constants_from(self.system.parameters.as_ref(), &self.set);
        Box::new(ExpansionBy::<_, S, M, Q, N>::new(Box::new(constants)))
    }
}

/// The full equations of a compiled model, order by order.
struct OrdersOf<'a, M: BarSystem, Q: KernelSeries<M, N>, const N: usize> {
    constants: &'a M::Constants<f64>,
    tape: Box<Q::Tape<f64>>,
    series: PhantomData<Q>,
}

impl<M: BarSystem, Q: KernelSeries<M, N>, const N: usize> KernelOrders for OrdersOf<'_, M, Q, N> {
    fn varying(&self) -> Varying<'_> {
        Q::VARYING
    }

    fn order(&mut self, n: usize, state: &[f64], take: &mut TakeOrder<'_>) {
        let state = to_array(state);
        let (kernel, feet) = match n {
            0 => Q::order(self.constants, &mut self.tape.values(), &state),
            _ => Q::order(self.constants, &mut self.tape.coefficients(n), &state),
        };
        take(&kernel, feet.as_ref());
    }
}

struct LiftedPhase<M: BarSystem, S: Scalar, const N: usize> {
    system: Arc<Lifted<M, S>>,
    phase: model::Phase<M, S, N>,
    info: PhaseInfo,
    kept: [usize; N],
    reduced: Option<Reduced<M, S, N>>,
    series: Option<SeriesOf<M, S>>,
    products: usize,
    jacobian: Option<JacobianOf<M, S>>,
    fused: Option<Box<dyn Derivative<M, S, N>>>,
}

/// What a closed form has of its own where digits could cancel: not in double-double, which has
/// enough of them.
struct Reduced<M: BarSystem, S: Scalar, const N: usize> {
    pivots: OfState<M, S, [S; N], Pivots<S>>,
    energy: OfState<M, S, [S; N], Energy<S>>,
}

impl<M: BarSystem, S: Scalar, const N: usize> Reduced<M, S, N> {
    fn new<Q: ClosedForm<M, N>>() -> Option<Self> {
        Some(Self { pivots: Q::pivots, energy: Q::energy })
    }
}

impl<M: BarSystem, S: Scalar, const N: usize> LiftedPhase<M, S, N> {
    /// `restrict` picks entries, so it tells which from a state of indices.
    fn new(system: Arc<Lifted<M, S>>, phase: model::Phase<M, S, N>) -> Self {
        let indices = (phase.restrict)(&M::State::from_fn(|i| S::ratio(i as i64, 1)));
        let kept = indices.map(|index| index.to_f64() as usize);
        let model::Phase { set, form, coordinates, rates, affine, .. } = phase;
        let info = PhaseInfo { set, form, coordinates, rates, entries: N, affine };
        Self {
            system,
            phase,
            info,
            kept,
            reduced: None,
            series: None,
            products: 0,
            jacobian: None,
            fused: None,
        }
    }
}

impl<M: BarSystem, const N: usize> LiftedPhase<M, f64, N> {
    fn of_closed<Q: ClosedForm<M, N>>(system: Arc<Lifted<M, f64>>, phase: model::Phase<M, f64, N>) -> Self {
        let (reduced, jacobian) = (Reduced::new::<Q>(), jacobian::of_closed::<M, Q, N>());
        Self { reduced, jacobian, fused: fused::<M, Q, N>(), ..Self::new(system, phase) }
    }
}

impl<M: BarSystem, S: Liftable, const N: usize> PhaseEquations<S> for LiftedPhase<M, S, N> {
    fn system(&self) -> &dyn System<S> {
        &*self.system
    }

    fn info(&self) -> &PhaseInfo {
        &self.info
    }

    fn kept(&self) -> &[usize] {
        &self.kept
    }

    #[inline]
    fn derivative(&self, y: &[S], derivative: &mut [S]) {
        let (Ok(y), Ok(f)) = (y.try_into(), <&mut [S; N]>::try_from(&mut *derivative)) else {
            return derivative.fill(S::from_f64(f64::NAN));
        };
        match &self.fused {
            Some(fused) => fused.write(&self.system, &self.phase.set, y, f),
            None => *f = (self.phase.derivative)(&self.system.constants, &self.phase.set, y),
        }
    }

    fn reactions(&self, y: &[S], reactions: &mut [S]) {
        let all = (self.phase.reactions)(&self.system.constants, &self.phase.set, &to_array::<S, N>(y));
        reactions.copy_from_slice(all.as_ref());
    }

    fn embed(&self, y: &[S], state: &mut [S]) {
        state.copy_from_slice((self.phase.embed)(&self.system.constants, &to_array::<S, N>(y)).as_ref());
    }

    fn pivots(&self, y: &[S]) -> Pivots<S> {
        let none = || Pivots::collect([]);
        self.reduced
            .as_ref()
            .map_or_else(none, |own| (own.pivots)(&self.system.constants, &to_array::<S, N>(y)))
    }

    fn energy(&self, y: &[S]) -> Energy<S> {
        let (constants, y) = (&self.system.constants, to_array::<S, N>(y));
        match &self.reduced {
            Some(own) => (own.energy)(constants, &y),
            None => M::energy(constants, &(self.phase.embed)(constants, &y)),
        }
    }

    fn series(&self) -> Option<Box<dyn SeriesExpansion + '_>> {
        self.series.and_then(|series| series(&self.system, self.phase.set))
    }

    fn products(&self) -> usize {
        self.products
    }

    fn methods(&self) -> Methods {
        const { Methods::for_entries(N, M::LAYOUT.compliant) }
    }

    fn jacobian(&self) -> Option<Jacobian<'_>> {
        self.jacobian.map(|jacobian| jacobian(&self.system, self.phase.set))
    }
}
