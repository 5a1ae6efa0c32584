//! Taylor's method on [`LANES`] motions side by side, each with its own time, step and end.
//!
//! A motion's bits depend neither on its lane nor on what is beside it: the order follows from the tolerance, which all
//! share, and every operation acts on each lane alone. The steps are those of [`Taylor`](super::Taylor), with an order that
//! suits convolutions whose cost grows with its square.

use super::step_size::{LAST, SPARSENESS, SYMMETRY};
use super::{LARGEST, is_finite};
use crate::integrate::{StepError, StepState};
use crate::model::{BarSystem, PhaseSeries};
#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;
use crate::scalar::{LANES, Lanes, Real};
use crate::series::{ORDERS, TaylorTape};

/// An integration of as many motions of one phase as there are lanes.
pub struct LaneStepper<M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> {
    constants: M::Constants<Lanes>,
    tape: Box<Q::Columns<Lanes>>,
    /// y(t₀ + uθ) = Σ cₖ θᵏ.
    series: Box<[[Lanes; N]; ORDERS]>,
    order: usize,
    relative: f64,
    /// log₂ of the relative tolerance, and of the part of it that the last term may have.
    logarithms: [f64; 2],
    absolute: [Lanes; N],
    state: [Lanes; N],
    /// u, the length of the last step.
    unit: Lanes,
    motions: [Option<LaneMotion<N>>; LANES],
}

/// What a lane integrates.
struct LaneMotion<const N: usize> {
    step_state: StepState<f64, N>,
    /// Whether the unit has been shortened since the last step, as the series was not finite.
    shortened: bool,
}

/// A motion that has reached its end, or could not.
pub struct Ended<const N: usize> {
    /// Its lane, which is free now.
    pub lane: usize,
    /// Where it is.
    pub step_state: StepState<f64, N>,
    /// Why it is not at its end.
    pub error: Option<StepError>,
}

impl<M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> LaneStepper<M, Q, N> {
    /// An empty one for a relative tolerance > 0, with any constants.
    pub fn new(constants: M::Constants<Lanes>, relative: f64) -> Self {
        let zero = Lanes::splat(0.0);
        Self {
            constants,
            tape: Box::default(),
            series: Box::new([[zero; N]; ORDERS]),
            order: order(relative),
            relative,
            logarithms: [relative.log2(), relative.log2() + LAST.log2()],
            absolute: [Lanes::splat(1.0); N],
            state: [zero; N],
            unit: zero,
            motions: [const { None }; LANES],
        }
    }

    /// A lane without a motion.
    pub fn free(&self) -> Option<usize> {
        self.motions.iter().position(Option::is_none)
    }

    /// Whether no lane has a motion.
    pub fn is_empty(&self) -> bool {
        self.motions.iter().all(Option::is_none)
    }

    /// Puts a motion into a lane; its tolerance has the relative part of this stepper. `unit` is a guess at its first step, which
    /// may be many times too long or too short.
    pub fn enter(
        &mut self,
        lane: usize,
        step_state: StepState<f64, N>,
        constants: &M::Constants<f64>,
        unit: f64,
    ) {
        Q::fill(&mut self.constants, constants, |all, own| all.set(lane, own));
        for i in 0..N {
            self.state[i].set(lane, step_state.state[i]);
            self.absolute[i].set(lane, step_state.tolerance.absolute()[i]);
        }
        self.unit.set(lane, unit);
        self.motions[lane] = Some(LaneMotion { step_state, shortened: false });
    }

    /// One step of all; those that end with it.
    pub fn step(&mut self) -> [Option<Ended<N>>; LANES] {
        self.expand();
        let (step_size, finite) = (self.step_size().to_array(), self.are_finite());
        let unit = self.unit.to_array();
        let mut ended = [const { None }; LANES];
        let (mut ratio, mut next, mut t1) = ([0.0; LANES], unit, [0.0; LANES]);
        for lane in 0..LANES {
            let Some(motion) = &mut self.motions[lane] else { continue };
            match motion.plan(unit[lane], finite[lane].then_some(step_size[lane])) {
                Ok(step) => (ratio[lane], next[lane], t1[lane]) = step,
                Err(error) => ended[lane] = Some(Some(error)),
            }
        }
        let mut value = self.value(Lanes::new(ratio));
        for lane in 0..LANES {
            let (Some(motion), None) = (&mut self.motions[lane], &ended[lane]) else { continue };
            if ratio[lane] > 0.0 {
                let y1 = value.map(|y| y.lane(lane));
                ended[lane] = motion.accept(y1, (t1[lane], next[lane]), self.order);
            }
        }
        for lane in (0..LANES).filter(|&lane| ratio[lane] == 0.0) {
            for i in 0..N {
                value[i].set(lane, self.state[i].lane(lane));
            }
        }
        (self.state, self.unit) = (value, Lanes::new(next));
        let motions = &mut self.motions;
        core::array::from_fn(|lane| {
            let error = ended[lane].take()?;
            motions[lane].take().map(|motion| Ended { lane, step_state: motion.step_state, error })
        })
    }

    fn expand(&mut self) {
        let Self { constants, tape, series, unit, .. } = self;
        series[0] = self.state;
        let rates = Q::order(constants, &mut tape.values(), &self.state).rates;
        let mut state = rates.map(|rate| *unit * rate);
        series[1] = state;
        for n in 1..self.order {
            let part = *unit * Lanes::splat(1.0 / (n + 1) as f64);
            let rates = Q::order(constants, &mut tape.coefficients(n), &state).rates;
            state = rates.map(|rate| part * rate);
            series[n + 1] = state;
        }
    }

    /// θ up to which each series meets the tolerance, as for one motion; of those that go less than half as far as the last,
    /// once more with the state's size there.
    fn step_size(&self) -> Lanes {
        let theta = self.step_size_within(Lanes::splat(1.0));
        if theta.to_array().iter().all(|theta| *theta >= 0.5) {
            return theta;
        }
        let (far, near) = (theta.to_array(), self.step_size_within(theta).to_array());
        Lanes::new(core::array::from_fn(|lane| if far[lane] < 0.5 { near[lane] } else { far[lane] }))
    }

    fn step_size_within(&self, theta: Lanes) -> Lanes {
        let (p, relative) = (self.order, Lanes::splat(self.relative));
        let [tolerance, last] = self.logarithms.map(Lanes::splat);
        let inverse: [Lanes; N] = core::array::from_fn(|i| {
            let end = theta.mul_add(self.series[1][i].abs(), self.series[0][i].abs());
            Lanes::splat(1.0) / relative.mul_add(end, self.absolute[i])
        });
        let radius = |k: usize| {
            let sizes = (0..N).map(|i| self.series[k][i].abs() * inverse[i]);
            let size = sizes.fold(Lanes::splat(f64::MIN_POSITIVE), Lanes::max);
            (size.rough_log2() + tolerance) * Lanes::splat(-1.0 / k as f64)
        };
        let pair = |k: usize, slack: f64| radius(p - k).min(radius(p - k - 1)) + Lanes::splat(slack);
        let part = last * Lanes::splat(1.0 / p as f64);
        let reach = pair(0, 0.0).min(pair(2, SYMMETRY));
        let reach = if p > 4 { reach.min(pair(4, SPARSENESS)) } else { reach };
        (reach + part).rough_exp2()
    }

    /// Whether the last two coefficients are finite.
    fn are_finite(&self) -> [bool; LANES] {
        let sizes = self.series[self.order - 1..=self.order].iter().flatten().map(|c| c.abs());
        sizes.fold(Lanes::splat(0.0), |sum, size| sum + size).to_array().map(f64::is_finite)
    }

    /// Σ cₖ θᵏ, even and odd terms side by side; the order is even.
    fn value(&self, theta: Lanes) -> [Lanes; N] {
        let square = theta * theta;
        let (mut even, mut odd) = (self.series[self.order], [Lanes::splat(0.0); N]);
        for pair in self.series[..self.order].rchunks_exact(2) {
            for i in 0..N {
                odd[i] = odd[i].mul_add(square, pair[1][i]);
                even[i] = even[i].mul_add(square, pair[0][i]);
            }
        }
        core::array::from_fn(|i| odd[i].mul_add(theta, even[i]))
    }
}

impl<const N: usize> LaneMotion<N> {
    /// The ratio of the next step to the unit, the unit of the next series, and the time it leads to; no step where the unit
    /// is shortened first.
    fn plan(&mut self, unit: f64, step_size: Option<f64>) -> Result<(f64, f64, f64), StepError> {
        let t = self.step_state.time;
        match step_size {
            Some(step_size) => {
                let wanted = step_size.min(LARGEST) * unit;
                let (h, t1) = self.step_state.fit(wanted, true)?;
                Ok((h / unit, wanted.min(LARGEST * h), t1))
            }
            None if self.shortened => Err(StepError::NotFinite { t }),
            None => {
                self.shortened = true;
                Ok((0.0, unit * f64::EPSILON, t))
            }
        }
    }

    /// Goes on to the end of a step; `Some` if that is the end of the motion, or is not finite.
    fn accept(&mut self, y1: [f64; N], (t1, next): (f64, f64), order: usize) -> Option<Option<StepError>> {
        if !is_finite(&y1) {
            return Some(Some(StepError::NotFinite { t: self.step_state.time }));
        }
        self.shortened = false;
        self.step_state.counts.evaluations += order as u64;
        self.step_state.accept(t1, y1, next);
        self.step_state.is_at_end().then_some(None)
    }
}

/// p = 4 − 0.55 ln ε, even as two orders are summed at once. Of four hundred double pendula at ε = 1e-9, 13.8, 15.9, 16.8 and
/// 16.8 thousand were done in a second at p = 12, 14, 16 and 18.
fn order(relative: f64) -> usize {
    let half = 0.5 * (4.0 - 0.55 * relative.ln());
    (2 * half.round() as usize).clamp(4, ORDERS - 2)
}
