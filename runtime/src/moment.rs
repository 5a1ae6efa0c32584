//! A model's constants, and its motion at one time.

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

/// The motion at one time.
pub(crate) trait Moment<M: BarSystem> {
    /// Time.
    fn t(&self) -> f64;
    /// The full state.
    fn state(&self) -> &M::State<f64>;
    /// Accelerations of all coordinates.
    fn accelerations(&self) -> Vec<f64>;
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
}

impl<'a, M: BarSystem, const N: usize> At<'a, M, N> {
    pub(crate) fn new(
        phase: &'a Phase<M, f64, N>,
        constants: &'a M::Constants<f64>,
        t: f64,
        reduced: [f64; N],
    ) -> Self {
        let state = (phase.embed)(constants, &reduced);
        Self { phase, constants, t, reduced, state }
    }
}

impl<M: BarSystem, const N: usize> Moment<M> for At<'_, M, N> {
    fn t(&self) -> f64 {
        self.t
    }

    fn state(&self) -> &M::State<f64> {
        &self.state
    }

    /// Those that the phase keeps come from its own equations, whose digits do not cancel; the others follow.
    fn accelerations(&self) -> Vec<f64> {
        let mut full = vec![0.0; M::LAYOUT.coordinates.len()];
        let mut multipliers = vec![0.0; M::LAYOUT.rows()];
        let kernel = M::kernel(self.constants, &self.state);
        kernel.solve(M::LAYOUT, self.phase.set, &mut full, &mut multipliers);
        if self.phase.form == Form::Closed {
            let own = (self.phase.derivative)(self.constants, self.phase.set, &self.reduced);
            for (k, i) in retained(self.phase).into_iter().enumerate() {
                full[i] = own[self.phase.coordinates + k];
            }
        }
        full
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
