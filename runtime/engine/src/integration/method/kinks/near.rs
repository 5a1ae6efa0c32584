//! How far a state is from a kink, in time.

use super::CutAtKinks;
use crate::context::Numbers;
use crate::model::Kink;
use crate::numerics::zero::roundoff;
use smallvec::smallvec;

/// What differs along the motion by this part of a step tells its rate.
const PROBE: f64 = 1e-6;
/// The part of the tolerance within which a kink is met: the right-hand side errs by as much as its
/// slopes on both sides differ, over so much of a step.
const CLOSE: f64 = 1e-3;
/// The part of a step within which a kink is close.
const REACH: f64 = 1e-3;
/// Rounding of a zero of what varies over a step, and of the time.
const ROUNDING: f64 = roundoff(64.0);

/// The kinks near a state.
#[derive(Default)]
pub(super) struct Near {
    /// One that is there.
    pub at: Option<usize>,
    /// Whether one is so near, before or behind, that Taylor series reach little farther.
    pub close: bool,
    /// The time until the next of the others vanishes, as it goes on now.
    pub ahead: Option<f64>,
}

impl CutAtKinks<'_> {
    /// The time within which a kink counts as met.
    pub(super) fn resolution(&self, t: f64) -> f64 {
        let part = (CLOSE * self.problem.relative).max(ROUNDING);
        (part * self.usual).max(ROUNDING * t.abs())
    }

    /// The kinks near a reduced state.
    pub(super) fn near(&self, t: f64, y: &[f64]) -> Near {
        let (f, probe) = (self.slope(y), PROBE * self.usual);
        let [before, here, beyond] = [-probe, 0.0, probe].map(|s| self.along(y, &f, s));
        let mut near = Near::default();
        for (j, kink) in self.kinks.iter().enumerate() {
            // What vanishes and stays so, as the slip of a contact that sticks, is no kink of the
            // motion.
            if [&before, &here, &beyond].iter().all(|values| values[j] == 0.0) {
                continue;
            }
            let rate = (beyond[j] - before[j]) / (2.0 * probe);
            // A radicand vanishes as a square does.
            let order = if *kink == Kink::Sign { 1.0 } else { 2.0 };
            let ahead = -order * here[j] / rate;
            near.close |= ahead.abs() <= REACH * self.usual;
            if here[j] == 0.0 || ahead.abs() <= self.resolution(t) {
                near.at = Some(j);
            } else if ahead > 0.0 && near.ahead.is_none_or(|first| ahead < first) {
                near.ahead = Some(ahead);
            }
        }
        near
    }

    /// Moves a state at a kink just beyond it, by no more than rounding.
    pub(super) fn pass(&self, j: usize, y: &mut Numbers) {
        let f = self.slope(y);
        if !f.iter().all(|f| f.is_finite()) {
            return;
        }
        let probe = PROBE * self.usual;
        let value = |s: f64| self.along(y, &f, s)[j];
        let rate = value(probe) - value(-probe);
        let is_beyond = |s: f64| match self.kinks[j] {
            Kink::Sign => value(s) * rate > 0.0,
            Kink::Radicand => value(s) > value(0.5 * s),
        };
        let doubled = core::iter::successors(Some(f64::EPSILON * self.usual), |s| Some(2.0 * s));
        let s = if self.kinks[j] == Kink::Sign && is_beyond(0.0) {
            0.0
        } else {
            doubled.take_while(|s| *s < probe).find(|s| is_beyond(*s)).unwrap_or(0.0)
        };
        y.iter_mut().zip(&f).for_each(|(y, f)| *y += s * f);
    }

    fn slope(&self, y: &[f64]) -> Numbers {
        let mut f: Numbers = smallvec![0.0; y.len()];
        self.problem.phase.derivative(y, &mut f);
        f
    }

    /// The kinks at y + s f.
    fn along(&self, y: &[f64], f: &[f64], s: f64) -> Numbers {
        let mut values: Numbers = smallvec![0.0; self.kinks.len()];
        let beside: Numbers = y.iter().zip(f).map(|(y, f)| y + s * f).collect();
        self.values(&beside, &mut values);
        values
    }

    /// The kinks at a reduced state.
    pub(super) fn values(&self, y: &[f64], values: &mut [f64]) {
        let system = self.problem.phase.system();
        let [state, _] = &mut *self.scratch.borrow_mut();
        state.resize(system.layout().entries(), 0.0);
        self.problem.phase.embed(y, state);
        system.kinks(state, values);
    }
}
