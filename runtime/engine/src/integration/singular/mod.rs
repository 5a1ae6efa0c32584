//! Closed loops at singular positions, where their rows of J lose rank and the equations say nothing of how to go on.
//!
//! A motion through such a position is smooth along its branch. It is
//! integrated up to a distance w in time, continued by the polynomial through its last steps to the same distance beyond,
//! projected onto the constraints there, and given its energy back. Error O((w/R)¹¹), R the time scale of the motion;
//! what the projection has to correct measures it. The distance: the smallest singular value σ of the closed rows of J in
//! natural units falls like |t − tₛ|, so the last two of its values tell tₛ.

mod path;
#[cfg(test)]
mod tests;

use nalgebra::DMatrix;

use crate::integration::phase_point::RunContext;
use crate::model::{ContactSet, Layout};
use path::Path;

/// The loosest tolerance for closed loops: errors transverse to the branch grow like 1/σ² towards a singular position and must
/// still be small enough there to tell the branches apart.
pub(crate) const LOOSEST: f64 = 1e-8;
/// w, in steps of the regular motion.
const NEAR: f64 = 0.01;
/// How many regular steps the polynomial's data reach back.
const BACK: f64 = 5.0;
/// w in times from a start that is so near that no step is regular.
const NEAR_START: f64 = 0.05;
/// Natural times in which the fall of σ is seen at the start.
const PROBE: f64 = 1e-6;
/// Regular steps are the longest of so many.
const RECENT: usize = 24;
/// A singular value above this fraction of the largest counts for the rank of a regular position.
const REGULAR: f64 = 1e-6;
/// Below this fraction a failed step is blamed on the loop.
const LOST: f64 = 1e-4;
/// The largest correction by the projection beyond, in natural units and in tolerances; a larger one means another branch.
const ACCEPTED: f64 = 1e-7;
const TOLERANCES: f64 = 1e4;
/// At a start with σ below this the digits given do not determine the branch.
const UNDECIDED: f64 = 5e-4;

/// The closed rows of a phase, and how near they are to losing rank.
pub(crate) struct SingularityMonitor {
    set: ContactSet,
    rows: Vec<usize>,
    unit: Vec<f64>,
    sizes: Vec<f64>,
    rank: usize,
    /// The last time with its σ.
    last: Option<(f64, f64)>,
    steps: Vec<f64>,
    /// The least window, until the first crossing.
    least: f64,
    /// What a projection may correct.
    accepted: f64,
}

/// What comes next.
pub(crate) enum Forecast {
    /// No singular position within the next steps.
    Regular,
    /// One near this time; integrate no further than the second.
    Near(f64),
    /// One at this time, as near as the integration should go.
    Here(f64),
}

/// A state beyond a singular position.
pub(crate) struct Continuation {
    pub(crate) t: f64,
    pub(crate) state: Vec<f64>,
}

impl SingularityMonitor {
    /// Nothing to watch without joints.
    pub(crate) fn of(set: ContactSet, context: &RunContext, tolerance: f64) -> Option<Self> {
        let layout = context.layout();
        let rows: Vec<usize> = (0..layout.rows()).filter(|&row| layout.is_closed(row, set)).collect();
        let unit = context.scales.state(layout);
        let sizes = vec![0.0; rows.len()];
        let accepted = ACCEPTED.max(TOLERANCES * tolerance.min(LOOSEST));
        let loops =
            Self { set, rows, unit, sizes, rank: 0, last: None, steps: Vec::new(), least: 0.0, accepted };
        (!layout.joints.is_empty() && loops.rows.len() > 1).then_some(loops)
    }

    /// Takes note of the start. Gives the step to begin with where a singular position is so near that one of any length
    /// might pass it unseen, or the joints of a loop that starts in one.
    pub(crate) fn begin(
        &mut self,
        context: &RunContext,
        t: f64,
        state: &[f64],
    ) -> Result<Option<f64>, Vec<String>> {
        let (layout, nominal) = (context.layout(), &context.model.nominal);
        let n = layout.coordinates.len();
        // The figure shows how long the rows are at a regular position, and of what rank.
        self.min_singular_value(context, &layout.state_at(&[&nominal[..], &vec![0.0; n]].concat(), t));
        let sigma = self.min_singular_value(context, state);
        if sigma < UNDECIDED {
            return Err(self.singular(context, state));
        }
        self.last = Some((t, sigma));
        let dt = PROBE * context.scales.time;
        let moved = |i: usize| state[i] + if i < n { dt * state[n + i] } else { 0.0 };
        let ahead: Vec<f64> = (0..state.len()).map(moved).collect();
        let left = sigma * dt / (sigma - self.min_singular_value(context, &ahead));
        let time = context.scales.time;
        self.least = if left > 0.0 && left < NEAR * time { NEAR_START * left } else { 0.0 };
        Ok((left > 0.0 && left < time).then_some(NEAR_START * left))
    }

    /// Takes note of a step of length `h` to `t`, before one of about `next`.
    pub(crate) fn note(
        &mut self,
        context: &RunContext,
        (t, h, next): (f64, f64, f64),
        state: &[f64],
    ) -> Forecast {
        if self.steps.len() == RECENT {
            self.steps.remove(0);
        }
        self.steps.push(h);
        let sigma = self.min_singular_value(context, state);
        let before = self.last.replace((t, sigma));
        let Some((t0, sigma0)) = before.filter(|(t0, sigma0)| *t0 < t && *sigma0 > sigma) else {
            return Forecast::Regular;
        };
        let (left, window) = (sigma * (t - t0) / (sigma0 - sigma), self.window());
        if left <= 1.5 * window {
            Forecast::Here(t + left)
        } else if left < 4.0 * next.max(h) {
            // Half the way: from afar σ falls slower than it will.
            Forecast::Near(t + if left < 4.0 * window { left - window } else { 0.5 * left })
        } else {
            Forecast::Regular
        }
    }

    fn longest(&self) -> f64 {
        self.steps.iter().copied().fold(0.0, f64::max)
    }

    pub(crate) fn window(&self) -> f64 {
        self.least.max(NEAR * self.longest())
    }

    /// The closed rows of J in natural units, each in units of the longest that it has been: a row may vanish.
    fn scaled_jacobian(&mut self, context: &RunContext, state: &[f64]) -> DMatrix<f64> {
        let kernel = context.system().equations(state);
        let n = context.layout().coordinates.len();
        let mut jacobian =
            DMatrix::from_fn(self.rows.len(), n, |i, j| kernel.jacobian(self.rows[i])[j] * self.unit[j]);
        for (mut row, longest) in jacobian.row_iter_mut().zip(&mut self.sizes) {
            *longest = longest.max(row.norm());
            row /= if *longest > 0.0 { *longest } else { 1.0 };
        }
        jacobian
    }

    /// The smallest singular value of those that do not vanish at regular positions.
    fn min_singular_value(&mut self, context: &RunContext, state: &[f64]) -> f64 {
        let jacobian = self.scaled_jacobian(context, state);
        self.least(&jacobian)
    }

    /// The least singular value that the rank counts, relative to the largest.
    fn least(&mut self, jacobian: &DMatrix<f64>) -> f64 {
        if jacobian.iter().any(|x| !x.is_finite()) {
            return f64::INFINITY;
        }
        let values = jacobian.singular_values();
        let largest = values.amax();
        let regular = values.iter().filter(|value| **value > REGULAR * largest).count();
        self.rank = self.rank.max(regular);
        let mut sorted: Vec<f64> = values.iter().copied().collect();
        sorted.sort_by(|a, b| b.total_cmp(a));
        self.rank.checked_sub(1).map_or(f64::INFINITY, |last| sorted[last] / largest)
    }

    /// The joints to blame where a motion cannot go on.
    pub(crate) fn diagnose(&mut self, context: &RunContext, state: &[f64]) -> Option<Vec<String>> {
        (self.min_singular_value(context, state) <= LOST).then(|| self.singular(context, state))
    }

    /// The joints whose rows all but depend on each other.
    fn singular(&mut self, context: &RunContext, state: &[f64]) -> Vec<String> {
        let jacobian = self.scaled_jacobian(context, state);
        self.dependent(jacobian, context.layout())
    }

    fn dependent(&self, jacobian: DMatrix<f64>, layout: &Layout) -> Vec<String> {
        let svd = jacobian.svd(true, false);
        let mut order: Vec<usize> = (0..svd.singular_values.len()).collect();
        order.sort_by(|&a, &b| svd.singular_values[b].total_cmp(&svd.singular_values[a]));
        let weakest = order.get(self.rank.saturating_sub(1)).zip(svd.u.as_ref()).map(|(&k, u)| u.column(k));
        let contacts = layout.contacts.len();
        let depends = |(i, row): (usize, &usize)| {
            let name = row.checked_sub(contacts).and_then(|joint| layout.joints.get(joint))?;
            weakest.is_none_or(|weakest| weakest[i].abs() > LOST).then(|| (*name).to_owned())
        };
        let mut joints: Vec<String> = self.rows.iter().enumerate().filter_map(depends).collect();
        joints.dedup();
        joints
    }

    /// The state as far beyond a singular position at `ts` as the motion since `from` has come near it, at `t`.
    pub(crate) fn cross(
        &mut self,
        context: &RunContext,
        (from, t, ts): (f64, f64, f64),
        at: &dyn Fn(f64) -> Vec<f64>,
    ) -> Option<Continuation> {
        let reach = (t - from).min(BACK * self.longest());
        if reach < self.longest() || ts - t < 0.25 * self.window() {
            return None;
        }
        let beyond = ts + (ts - t);
        let path = Path::over([t - reach, t], 2 * context.layout().coordinates.len(), at);
        let ahead = path.state(beyond);
        let mut state = ahead.clone();
        context.system().project(self.set, &mut state, context.scales.length);
        let n = context.layout().coordinates.len();
        let fastest = (n..2 * n).fold(1.0, |most: f64, i| most.max((ahead[i] / self.unit[i]).abs()));
        let corrected = |(i, unit): (usize, &f64)| ((state[i] - ahead[i]) / unit).abs();
        let correction = self.unit.iter().enumerate().map(corrected);
        if !correction.fold(0.0, nan_max).le(&(self.accepted * fastest)) {
            return None;
        }
        self.least = 0.0;
        if !context.layout().timed {
            keep_energy(context, path.energy(context, beyond), &mut state);
        }
        Some(Continuation { t: beyond, state })
    }
}

/// The larger, NaN if either is.
fn nan_max(a: f64, b: f64) -> f64 {
    if a.is_nan() || b > a || b.is_nan() { b } else { a }
}

/// Scales the rates to an energy; the velocity constraints are homogeneous.
fn keep_energy(context: &RunContext, energy: f64, state: &mut [f64]) {
    let now = context.system().energy(state);
    let square = (energy - now.potential) / now.kinetic;
    if square.is_finite() && (square - 1.0).abs() < ACCEPTED.sqrt() {
        let n = context.layout().coordinates.len();
        state[n..2 * n].iter_mut().for_each(|rate| *rate *= square.sqrt());
    }
}
