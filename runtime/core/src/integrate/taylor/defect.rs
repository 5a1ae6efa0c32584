//! How well a series satisfies the equations at the end of a step.

use super::{Expansion, Taylor};
use crate::scalar::Real;

/// Rounding of a series and of f at its end, in units of that of the state and of what it moves by.
const ROUNDING: f64 = 256.0 * f64::EPSILON;
/// Roundings of a state by which f is tried where the defect is large.
const NUDGE: f64 = 4.0 * f64::EPSILON;
/// The part of the fastest rate by which those of the series and of the equations may differ,
/// however short the step.
const ASTRAY: f64 = 0.03;
/// As many times what such a nudge changes in f may f err by rounding.
const NOISE: f64 = 16.0;

impl<E: Expansion<N>, const N: usize> Taylor<E, N> {
    /// |h (y′ − f(y))| at the end of a step of length h, the largest entry, in units of what is allowed; not a number where f
    /// is none. The first term that is left out, h times whose derivative this is, is p + 1 times
    /// smaller.
    pub(super) fn defect(&mut self, (unit, h): (f64, f64), y1: &[f64; N], slope: &[f64; N]) -> f64 {
        let f = self.expansion.rates(y1);
        let theta = h / unit;
        let moved = f.map(|f| h * f);
        let defect: [f64; N] = core::array::from_fn(|i| (theta * slope[i] - moved[i]).abs());
        if self.is_small(&defect, y1, &moved) {
            return 0.0;
        }
        let allowed = self.allowed(theta, y1, &moved);
        let worst = largest(&defect, &allowed);
        if worst <= 1.0 || worst.is_nan() {
            return worst;
        }
        self.step_state.counts.evaluations += 2;
        let nudged = core::array::from_fn(|i| y1[i] * if i % 2 == 0 { 1.0 + NUDGE } else { 1.0 - NUDGE });
        let beside = self.expansion.rates(&nudged);
        let noise = |i: usize| NOISE * (h * (beside[i] - f[i])).abs();
        largest(&defect, &core::array::from_fn(|i| allowed[i] + noise(i)))
    }

    /// Whether it is allowed without a look at rounding, or at how the step began: nearly always.
    #[inline(always)]
    fn is_small(&self, defect: &[f64; N], y1: &[f64; N], moved: &[f64; N]) -> bool {
        let (tolerance, terms) = (&self.step_state.tolerance, (self.step_size.order + 1) as f64);
        let (relative, absolute) = (tolerance.relative(), tolerance.absolute());
        let (mut is_small, mut is_fast) = (true, false);
        for i in 0..N {
            let scale = Real::mul_add(relative, y1[i].abs(), absolute[i]);
            is_small &= defect[i] <= terms * scale;
            is_fast |= moved[i].abs() >= terms / ASTRAY * scale;
        }
        is_small && is_fast
    }

    /// What each entry is allowed at the end y₁, where the equations move by `moved` in the time of
    /// the step.
    fn allowed(&self, theta: f64, y1: &[f64; N], moved: &[f64; N]) -> [f64; N] {
        let [y0, first, ..] = self.expansion.series();
        let scale = self.step_state.tolerance.scale(y0, y1);
        let path: [f64; N] = core::array::from_fn(|i| moved[i].abs() + theta * first[i].abs());
        let terms = ((self.step_size.order + 1) as f64).min(ASTRAY * largest(&path, &scale));
        core::array::from_fn(|i| terms * scale[i] + ROUNDING * (y0[i].abs() + y1[i].abs() + path[i]))
    }
}

fn largest<const N: usize>(x: &[f64; N], scale: &[f64; N]) -> f64 {
    let ratios = (0..N).map(|i| if x[i] == 0.0 { 0.0 } else { x[i] / scale[i] });
    // `max` passes over what is not a number.
    ratios.fold(0.0, |most, x| if x <= most { most } else { x })
}
