//! A model's constants, and its motion at one time.

#[cfg(test)]
mod tests;

use std::cell::OnceCell;

use crate::contact::Series;
use crate::model::{Array, BarSystem, Energy, Form, KernelView, Phase};
use crate::scales::Scales;

/// What of a model does not change during a run.
pub(crate) struct Scene<M: BarSystem> {
    pub(crate) constants: M::Constants<f64>,
    pub(crate) series: M::Constants<Series>,
    pub(crate) parameters: Vec<f64>,
    pub(crate) nominal: Vec<f64>,
    pub(crate) scales: Scales,
}

// A derive would ask that `M` be `Clone`.
impl<M: BarSystem> Clone for Scene<M> {
    fn clone(&self) -> Self {
        let Self { constants, series, parameters, nominal, scales } = self;
        let (constants, series) = (constants.clone(), series.clone());
        Self { constants, series, parameters: parameters.clone(), nominal: nominal.clone(), scales: *scales }
    }
}

/// The state that a model works with: coordinates and rates as users see them, and the time if the model depends on it.
/// Entries missing from values that are too few are taken as not a number.
pub(crate) fn state_at<M: BarSystem>(values: &[f64], t: f64) -> M::State<f64> {
    let seen = 2 * M::LAYOUT.coordinates.len();
    M::State::from_fn(|i| if i < seen { values.get(i).copied().unwrap_or(f64::NAN) } else { t })
}

/// A state as users see it: coordinates, then rates.
pub(crate) fn seen<M: BarSystem>(state: &M::State<f64>) -> &[f64] {
    &state.as_ref()[..2 * M::LAYOUT.coordinates.len()]
}

/// The motion at one time.
pub(crate) trait Moment<M: BarSystem> {
    /// Time.
    fn t(&self) -> f64;
    /// The full state.
    fn state(&self) -> &M::State<f64>;
    /// Accelerations of all coordinates.
    fn accelerations(&self) -> M::Accelerations<f64>;
    /// Multipliers of all rows of the kernel, zero where open.
    fn multipliers(&self) -> M::Multipliers<f64>;
    /// Reactions of all contacts.
    fn reactions(&self) -> M::Reactions<f64>;
    /// T and V.
    fn energy(&self) -> Energy<f64>;
}

/// A reduced state of a phase at a time.
pub(crate) struct At<'a, M: BarSystem, const N: usize> {
    phase: &'a Phase<M, f64, N>,
    constants: &'a M::Constants<f64>,
    t: f64,
    reduced: [f64; N],
    state: M::State<f64>,
    solution: OnceCell<Solution<M>>,
}

/// Accelerations and multipliers.
type Solution<M> = (<M as BarSystem>::Accelerations<f64>, <M as BarSystem>::Multipliers<f64>);

impl<'a, M: BarSystem, const N: usize> At<'a, M, N> {
    /// The time counts, where the reduced state has an entry of its own for it.
    pub(crate) fn new(
        phase: &'a Phase<M, f64, N>,
        constants: &'a M::Constants<f64>,
        t: f64,
        mut reduced: [f64; N],
    ) -> Self {
        if let Some(time) = reduced.get_mut(phase.coordinates + phase.rates) {
            *time = t;
        }
        let state = (phase.embed)(constants, &reduced);
        Self { phase, constants, t, reduced, state, solution: OnceCell::new() }
    }

    /// Accelerations that the phase keeps come from its own equations, whose digits do not cancel; the others follow.
    fn solve(&self) -> Solution<M> {
        let mut accelerations = M::Accelerations::from_fn(|_| 0.0);
        let mut multipliers = M::Multipliers::from_fn(|_| 0.0);
        let kernel = M::kernel(self.constants, &self.state);
        kernel.solve(M::LAYOUT, self.phase.set, accelerations.as_mut(), multipliers.as_mut());
        if self.phase.form == Form::Closed {
            let own = (self.phase.derivative)(self.constants, self.phase.set, &self.reduced);
            for (k, i) in retained(self.phase).into_iter().enumerate() {
                accelerations.as_mut()[i] = own[self.phase.coordinates + k];
            }
        }
        (accelerations, multipliers)
    }
}

impl<M: BarSystem, const N: usize> Moment<M> for At<'_, M, N> {
    fn t(&self) -> f64 {
        self.t
    }

    fn state(&self) -> &M::State<f64> {
        &self.state
    }

    fn accelerations(&self) -> M::Accelerations<f64> {
        self.solution.get_or_init(|| self.solve()).0
    }

    fn multipliers(&self) -> M::Multipliers<f64> {
        self.solution.get_or_init(|| self.solve()).1
    }

    fn reactions(&self) -> M::Reactions<f64> {
        (self.phase.reactions)(self.constants, self.phase.set, &self.reduced)
    }

    fn energy(&self) -> Energy<f64> {
        (self.phase.energy)(self.constants, &self.reduced)
    }
}

/// The coordinates whose rates a phase keeps: `restrict` picks entries, so it tells which from a state of indices.
pub(crate) fn retained<M: BarSystem, const N: usize>(phase: &Phase<M, f64, N>) -> Vec<usize> {
    let indices = (phase.restrict)(&M::State::from_fn(|i| i as f64));
    let n = M::LAYOUT.coordinates.len();
    let rates = phase.coordinates..phase.coordinates + phase.rates;
    indices[rates].iter().map(|&i| i as usize - n).collect()
}
