//! Taylor's method on [`LANES`] motions side by side, each with its own time, step and end.
//!
//! A motion's bits depend neither on its lane nor on what is beside it: the order follows from the
//! tolerance, which all share, and every operation acts on each lane alone. The steps are those of
//! [`Taylor`](super::Taylor), with an order that suits convolutions whose cost grows with its
//! square.

use super::lane_series::{Each, LaneSeries};
use super::{LARGEST, is_finite};
use crate::integrate::{StepError, StepState};
use crate::model::{BarSystem, PhaseSeries};
use crate::scalar::{Inside, LANES, Vector};

/// An integration of as many motions of one phase as there are lanes.
pub struct LaneStepper<M: BarSystem, Q: PhaseSeries<M, N>, X: Vector, const N: usize> {
    series: LaneSeries<M, Q, X, N>,
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

impl<M: BarSystem, Q: PhaseSeries<M, N>, X: Vector, const N: usize> LaneStepper<M, Q, X, N> {
    /// An empty one for a relative tolerance > 0, with any constants.
    pub fn new(constants: M::Constants<Each<X>>, relative: f64) -> Self {
        Self { series: LaneSeries::new(constants, relative), motions: [const { None }; LANES] }
    }

    /// A lane without a motion.
    pub fn free(&self) -> Option<usize> {
        self.motions.iter().position(Option::is_none)
    }

    /// Whether no lane has a motion.
    pub fn is_empty(&self) -> bool {
        self.motions.iter().all(Option::is_none)
    }

    /// Puts a motion into a lane; its tolerance has the relative part of this stepper. `unit` is a
    /// guess at its first step, which may be many times too long or too short.
    pub fn enter(
        &mut self,
        lane: usize,
        step_state: StepState<f64, N>,
        constants: &M::Constants<f64>,
        unit: f64,
    ) {
        let series = &mut self.series;
        Q::fill(&mut series.constants, constants, |all, own| all.set(lane, own));
        for i in 0..N {
            series.state[i].set(lane, step_state.state[i]);
            series.absolute[i].set(lane, step_state.tolerance.absolute()[i]);
        }
        series.unit.set(lane, unit);
        self.motions[lane] = Some(LaneMotion { step_state, shortened: false });
    }

    /// One step of all; those that end with it.
    pub fn step(&mut self) -> [Option<Ended<N>>; LANES] {
        X::inside(Step(self))
    }
}

/// One step of all.
struct Step<'a, M: BarSystem, Q: PhaseSeries<M, N>, X: Vector, const N: usize>(
    &'a mut LaneStepper<M, Q, X, N>,
);

impl<M: BarSystem, Q: PhaseSeries<M, N>, X: Vector, const N: usize> Inside for Step<'_, M, Q, X, N> {
    type Output = [Option<Ended<N>>; LANES];

    #[inline(always)]
    fn run(self) -> Self::Output {
        let LaneStepper { series, motions } = self.0;
        series.expand();
        let (step_size, finite) = (series.step_size(), series.are_finite());
        let unit = series.unit.to_array();
        let mut ended = [const { None }; LANES];
        let (mut ratio, mut next, mut t1) = ([0.0; LANES], unit, [0.0; LANES]);
        for lane in 0..LANES {
            let Some(motion) = &mut motions[lane] else { continue };
            match motion.plan(unit[lane], finite[lane].then_some(step_size[lane])) {
                Ok(step) => (ratio[lane], next[lane], t1[lane]) = step,
                Err(error) => ended[lane] = Some(Some(error)),
            }
        }
        let mut value = series.value(Each::new(ratio));
        for lane in 0..LANES {
            let (Some(motion), None) = (&mut motions[lane], &ended[lane]) else { continue };
            if ratio[lane] > 0.0 {
                let y1 = core::array::from_fn(|i| value[i].lane(lane));
                ended[lane] = motion.accept(y1, (t1[lane], next[lane]), series.order);
            }
        }
        for lane in (0..LANES).filter(|&lane| ratio[lane] == 0.0) {
            for i in 0..N {
                value[i].set(lane, series.state[i].lane(lane));
            }
        }
        (series.state, series.unit) = (value, Each::new(next));
        core::array::from_fn(|lane| {
            let error = ended[lane].take()?;
            motions[lane].take().map(|motion| Ended { lane, step_state: motion.step_state, error })
        })
    }
}

impl<const N: usize> LaneMotion<N> {
    /// The ratio of the next step to the unit, the unit of the next series, and the time it leads
    /// to; no step where the unit is shortened first.
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
