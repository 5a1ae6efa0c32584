//! Closed loops at singular positions, where their rows of J lose rank and the equations say
//! nothing of how to go on.
//!
//! A motion through such a position is smooth along its branch. Up to a distance w in time it is
//! integrated; from there to the same distance beyond one step of collocation is made whose points
//! the singular position lies between ([`bridge`]). The distance: the smallest singular value σ of
//! the closed rows of J in natural units falls like |t − tₛ|, so σ and its rate along the motion
//! tell tₛ. Steps towards it are bounded by what is left. Times are those of the motion, R, in
//! which the fastest coordinate moves by a natural unit at its rate or at its acceleration.

mod bridge;

#[cfg(test)]
mod tests;

use nalgebra::DMatrix;

use crate::context::{Numbers, RunContext};
use crate::model::{ContactSet, Layout};
use crate::numerics::decomposition::{least_ratio_bound, range, singular_values, svd};
use crate::numerics::zero::{MARGIN, roundoff};
use crate::system::Equations;
pub(crate) use bridge::Bridge;
use bridge::BridgeMotion;

/// The loosest tolerance near a singular position: errors must still be small enough to tell the
/// branches apart.
const LOOSEST: f64 = 1e-10;
/// The rounding of rates at the distance w from a singular position, ε/w², in natural units: no
/// error estimate resolves less.
pub(crate) const ROUNDED: f64 = roundoff(2.0) / (NEAR * NEAR);
/// w in units of R.
const NEAR: f64 = 0.1;
/// Parts of w at which one trial after another is made to find a branch that goes on smoothly.
const TRIALS: [f64; 4] = [1.0, 0.5, 0.25, 0.1];
/// σ beyond is at least this part of what it was before; a motion that slows down takes steps so
/// much longer, so many times.
const BEYOND: f64 = 0.5;
const LONGER: f64 = 1.4;
const MOST_LONGER: usize = 5;
/// No step is longer than this part of R, twice that where no singular position is within R, nor
/// than this part of the time to a singular position.
const LONGEST: f64 = 0.25;
const APPROACH: f64 = 0.5;
/// σ vanishes in no less than this part of σ R.
const FALL: f64 = 0.25;
/// Above this σ a singular position is another one.
const FAR: f64 = 0.3;
/// Part of R over which the fall of σ is seen.
const PROBE: f64 = 1e-5;
/// Below this fraction a failed step is blamed on the loop.
const LOST: f64 = 1e-4;
/// Where σ is below this the digits of a start determine the branch only if they satisfy the
/// equations of second order.
const UNDECIDED: f64 = 5e-4;
/// The energy may change in a step by so many tolerances.
const ENERGY: f64 = 1e4;

/// The closed rows of a phase, and how near they are to losing rank.
pub(crate) struct SingularityMonitor {
    set: ContactSet,
    rows: Vec<usize>,
    unit: Vec<f64>,
    sizes: Vec<f64>,
    rank: usize,
    tolerance: f64,
    /// How often no branch was found before the singular position ahead.
    trials: usize,
    /// Kinetic and total energy at the last state, where the energy is kept.
    energy: Option<[f64; 2]>,
}

/// What comes next.
pub(crate) enum Forecast {
    /// No singular position within the next steps.
    Regular,
    /// Integrate no further than this time.
    Until(f64),
    /// One at the first time; it can be passed from here up to the second.
    Here([f64; 2]),
}

/// Where a motion is: σ, and R.
struct SingularPoint {
    sigma: f64,
    time: f64,
}

impl SingularityMonitor {
    /// Nothing to watch without joints.
    pub(crate) fn new(set: ContactSet, context: &RunContext, tolerance: f64) -> Option<Self> {
        let layout = context.layout();
        let rows: Vec<usize> = (0..layout.rows()).filter(|&row| layout.is_closed(row, &set)).collect();
        let unit = layout.coordinates.iter().map(|c| context.scales.coordinate(c)).collect();
        let sizes = vec![0.0; rows.len()];
        let loops = Self { set, rows, unit, sizes, rank: 0, tolerance, trials: 0, energy: None };
        (!layout.joints.is_empty() && !loops.rows.is_empty()).then_some(loops)
    }

    /// The tolerance to integrate with from here on.
    pub(crate) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Takes note of the start: what comes next, or the joints of a loop that starts in a singular
    /// position.
    pub(crate) fn begin(
        &mut self,
        context: &RunContext,
        t: f64,
        state: &[f64],
    ) -> Result<Forecast, Vec<String>> {
        let (layout, nominal) = (context.layout(), &context.model.nominal);
        // The figure shows how long the rows are at a regular position, and of what rank. Where it
        // is drawn from rounded numbers, rows of equal cranks are independent that are not.
        let mut figure = layout.state_at(&[&nominal[..], &vec![0.0; nominal.len()]].concat(), t);
        context.system().project(ContactSet::EMPTY, &mut figure, context.scales.length);
        self.measure(context, &figure);
        if self.is_obstructed(context, &figure) {
            self.rank += 1;
        }
        // The row of a contact that is open there has another length: that of two discs grows with
        // their distance.
        let equations = context.system().equations(&figure);
        let is_open = |row: usize| {
            let gap = equations.gap().get(row).filter(|_| row < layout.contacts.len());
            gap.is_some_and(|gap| gap.abs() > MARGIN * layout.unit(row, context.scales.length))
        };
        let open = self.rows.iter().zip(&mut self.sizes).filter(|(row, _)| is_open(**row));
        open.for_each(|(_, size)| *size = 0.0);
        self.energy = conserved(context, state);
        let place = self.measure(context, state);
        let left = self.left(context, state, &place);
        if place.sigma < UNDECIDED || left.abs() <= place.time {
            self.tolerance = self.tolerance.min(LOOSEST);
        }
        let forecast = self.forecast((t, f64::INFINITY), &place, left);
        match forecast {
            Forecast::Here(_) => Ok(forecast),
            _ if place.sigma >= UNDECIDED => Ok(forecast),
            _ => Err(self.singular(context, state)),
        }
    }

    /// Whether rows depend on each other in a position and in none beside it: with ν J = 0 and J n
    /// = J m = 0, ν is that of rows which depend on each other throughout only if ν ∂J/∂n m = 0.
    fn is_obstructed(&mut self, context: &RunContext, state: &[f64]) -> bool {
        if self.rank >= self.rows.len() {
            return false;
        }
        let jacobian = self.scaled_jacobian(&context.system().equations(state));
        if jacobian.iter().any(|x| !x.is_finite()) {
            return false;
        }
        let [left, right] = [range(&jacobian), range(&jacobian.transpose())];
        let free = DMatrix::identity(self.unit.len(), self.unit.len()) - &right * right.transpose();
        free.column_iter().any(|direction| {
            let moved = |(i, value): (usize, &f64)| {
                value + direction.get(i).map_or(0.0, |part| PROBE * part * self.unit[i])
            };
            let moved: Numbers = state.iter().enumerate().map(moved).collect();
            let change = (self.scaled_jacobian(&context.system().equations(&moved)) - &jacobian) * &free;
            (&change - &left * left.tr_mul(&change)).amax() > LOST * PROBE
        })
    }

    /// Takes note of a state at `t`, before a step of about `next`.
    pub(crate) fn note(&mut self, context: &RunContext, (t, next): (f64, f64), state: &[f64]) -> Forecast {
        let equations = context.system().equations(state);
        let (jacobian, time) = (self.scaled_jacobian(&equations), self.time(&equations, state));
        let bound = least_bound(&jacobian);
        if self.trials == 0 && self.is_far(context, state, (bound, time, next)) {
            return self.forecast((t, next), &SingularPoint { sigma: bound, time }, f64::INFINITY);
        }
        let place = SingularPoint { sigma: self.least(jacobian), time };
        if place.sigma > FAR {
            self.trials = 0;
        }
        self.look_ahead(context, (t, next), state, &place)
    }

    /// The same of the position at which a passage has failed.
    pub(crate) fn note_failure(&mut self, context: &RunContext, t: f64, state: &[f64]) -> Forecast {
        let place = self.measure(context, state);
        self.look_ahead(context, (t, f64::INFINITY), state, &place)
    }

    fn look_ahead(
        &mut self,
        context: &RunContext,
        (t, next): (f64, f64),
        state: &[f64],
        place: &SingularPoint,
    ) -> Forecast {
        self.tolerance = self.tolerance.min(LOOSEST);
        if next <= FALL * place.sigma * place.time {
            return Forecast::Regular;
        }
        let left = self.left(context, state, place);
        if left <= 0.0 {
            return Forecast::Until(t + LONGEST * place.time);
        }
        self.forecast((t, next), place, left)
    }

    /// Whether no singular position is within several steps, as a lower bound of σ, which vanishes
    /// where σ does, and the rate of that bound tell.
    fn is_far(&mut self, context: &RunContext, state: &[f64], (bound, time, next): (f64, f64, f64)) -> bool {
        let ahead = |loops: &mut Self, ahead: &[f64]| {
            least_bound(&loops.scaled_jacobian(&context.system().equations(ahead)))
        };
        next <= FALL * bound * time
            || bound > 0.0 && {
                let left = self.left_by((bound, time), state, ahead);
                left <= 0.0 || left > time
            }
    }

    /// What comes `left` after, or before if it is negative, a singular position.
    fn forecast(&self, (t, next): (f64, f64), place: &SingularPoint, left: f64) -> Forecast {
        let window = TRIALS.get(self.trials).unwrap_or(&0.0) * NEAR * place.time;
        if left.abs() <= 1.5 * window {
            return Forecast::Here([t + left, t + left.max(0.0) + window]);
        }
        let longest = if left.is_finite() { LONGEST } else { 2.0 * LONGEST } * place.time;
        let end = match left {
            _ if left <= 0.0 || left > 2.0 * longest => longest,
            _ if left - window < APPROACH * left => left - window,
            _ => APPROACH * left,
        };
        if end < next { Forecast::Until(t + end) } else { Forecast::Regular }
    }

    /// The time to a singular position as σ and its rate tell it; negative where σ rises.
    fn left(&mut self, context: &RunContext, state: &[f64], place: &SingularPoint) -> f64 {
        let ahead = |loops: &mut Self, ahead: &[f64]| loops.measure(context, ahead).sigma;
        self.left_by((place.sigma, place.time), state, ahead)
    }

    /// The same, as what vanishes there and its value a little ahead tell it.
    fn left_by(
        &mut self,
        (here, time): (f64, f64),
        state: &[f64],
        ahead: impl FnOnce(&mut Self, &[f64]) -> f64,
    ) -> f64 {
        let (n, dt) = (self.unit.len(), PROBE * time);
        let moved = |i: usize| if i < n { state[i] + dt * state[n + i] } else { state[i] };
        let moved: Numbers = (0..state.len()).map(moved).collect();
        let fall = here - ahead(self, &moved);
        // The fall is lost in rounding where the motion is at rest.
        if fall.abs() <= roundoff(64.0) { f64::INFINITY } else { here * dt / fall }
    }

    /// σ and R at a state.
    fn measure(&mut self, context: &RunContext, state: &[f64]) -> SingularPoint {
        let equations = context.system().equations(state);
        let jacobian = self.scaled_jacobian(&equations);
        SingularPoint { sigma: self.least(jacobian), time: self.time(&equations, state) }
    }

    /// R = 1/max(|u|, √|f/m|) in natural units.
    fn time(&self, equations: &Equations<f64>, state: &[f64]) -> f64 {
        let n = self.unit.len();
        let speed = |(i, unit): (usize, &f64)| {
            let (rate, fall) = (state[n + i] / unit, equations.force()[i] / equations.mass(i)[i] / unit);
            rate.abs().max(if fall.is_finite() { fall.abs().sqrt() } else { 0.0 })
        };
        1.0 / self.unit.iter().enumerate().map(speed).fold(f64::MIN_POSITIVE, f64::max)
    }

    /// The closed rows of J in natural units, each in units of the longest that it has been: a row
    /// may vanish.
    fn scaled_jacobian(&mut self, equations: &Equations<f64>) -> DMatrix<f64> {
        let n = self.unit.len();
        let mut jacobian =
            DMatrix::from_fn(self.rows.len(), n, |i, j| equations.jacobian(self.rows[i])[j] * self.unit[j]);
        for (mut row, longest) in jacobian.row_iter_mut().zip(&mut self.sizes) {
            *longest = longest.max(row.norm());
            row /= if *longest > 0.0 { *longest } else { 1.0 };
        }
        jacobian
    }

    /// The least singular value that the rank counts, relative to the largest.
    fn least(&mut self, jacobian: DMatrix<f64>) -> f64 {
        if jacobian.iter().any(|x| !x.is_finite()) {
            return f64::INFINITY;
        }
        let values = singular_values(jacobian);
        let largest = if values.len() == 1 { 1.0 } else { values[0] };
        let regular = values.iter().filter(|value| **value > MARGIN * largest).count();
        self.rank = self.rank.max(regular);
        self.rank.checked_sub(1).map_or(f64::INFINITY, |last| values[last] / largest)
    }

    /// The joints to blame where a motion cannot go on.
    pub(crate) fn diagnose(&mut self, context: &RunContext, state: &[f64]) -> Option<Vec<String>> {
        (self.measure(context, state).sigma <= LOST).then(|| self.singular(context, state))
    }

    /// Whether the state is a singular position itself.
    pub(crate) fn is_singular(&mut self, context: &RunContext, state: &[f64]) -> bool {
        self.measure(context, state).sigma < MARGIN
    }

    /// The joints whose rows all but depend on each other.
    pub(crate) fn singular(&mut self, context: &RunContext, state: &[f64]) -> Vec<String> {
        let jacobian = self.scaled_jacobian(&context.system().equations(state));
        self.dependent(jacobian, context.layout())
    }

    fn dependent(&self, jacobian: DMatrix<f64>, layout: &Layout) -> Vec<String> {
        let svd = svd(jacobian);
        let mut order: Vec<usize> = (0..svd.singular_values.len()).collect();
        order.sort_by(|&a, &b| svd.singular_values[b].total_cmp(&svd.singular_values[a]));
        let weakest = order.get(self.rank.saturating_sub(1)).zip(svd.u.as_ref()).map(|(&k, u)| u.column(k));
        let contacts = layout.contacts.len();
        let depends = |(i, row): (usize, &usize)| {
            let joint = row.checked_sub(contacts).and_then(|joint| layout.joints.get(joint))?;
            weakest.is_none_or(|weakest| weakest[i].abs() > LOST).then(|| joint.name.to_owned())
        };
        let mut joints: Vec<String> = self.rows.iter().enumerate().filter_map(depends).collect();
        joints.dedup();
        joints
    }

    /// The motion from a state at `t` past a singular position; none where it does not go on
    /// smoothly.
    pub(crate) fn cross(
        &mut self,
        context: &RunContext,
        (t, [at, end]): (f64, [f64; 2]),
        state: &[f64],
    ) -> Option<Bridge> {
        let place = self.measure(context, state);
        let motion = BridgeMotion { context, set: self.set, time: place.time, from: state };
        let shortest = bridge::length([at - t, end - t]);
        let lengths = core::iter::successors(Some(shortest), |h| Some(LONGER * h)).take(MOST_LONGER);
        let bridge = lengths
            .filter_map(|h| motion.over(t, state, h))
            .find(|bridge| self.is_beyond(context, &place, bridge));
        self.trials = if bridge.is_some() { 0 } else { self.trials + 1 };
        bridge
    }

    /// Whether a step ends on the other side, or as far away as it began.
    fn is_beyond(&mut self, context: &RunContext, from: &SingularPoint, bridge: &Bridge) -> bool {
        let sigma = self.measure(context, &bridge.state).sigma;
        sigma >= BEYOND * from.sigma && (from.sigma >= UNDECIDED || self.opens(context, bridge))
    }

    /// Whether σ rises in proportion to the time from a singular start: where it rises later,
    /// another branch leaves the position in the same direction.
    fn opens(&mut self, context: &RunContext, bridge: &Bridge) -> bool {
        let [near, far] =
            [0.25, 1.0].map(|theta| self.measure(context, &bridge.state_at(context, theta)).sigma);
        near > 0.2 * far && far > MARGIN
    }

    /// Whether a step to a state has kept the energy, where there is any to keep.
    pub(crate) fn keeps_energy(&mut self, context: &RunContext, state: &[f64]) -> bool {
        let Some([kinetic, total]) = self.energy else { return true };
        let now = context.system().energy(state);
        self.energy = Some([now.kinetic, now.kinetic + now.potential]);
        let size = kinetic.max(now.kinetic).max(context.scales.force() * context.scales.length);
        (now.kinetic + now.potential - total).abs() <= ENERGY * self.tolerance * size
    }
}

/// A lower bound of σ. A row by itself loses its rank where it vanishes.
fn least_bound(jacobian: &DMatrix<f64>) -> f64 {
    if jacobian.nrows() == 1 { jacobian.norm() } else { least_ratio_bound(jacobian) }
}

/// Kinetic and total energy, if it is kept.
fn conserved(context: &RunContext, state: &[f64]) -> Option<[f64; 2]> {
    let energy = context.system().energy(state);
    context.is_conservative().then_some([energy.kinetic, energy.kinetic + energy.potential])
}
