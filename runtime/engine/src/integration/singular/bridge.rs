//! One step of a closed loop across a singular position, or from one.
//!
//! Along a branch of the loop the motion is smooth, through the singular position too; only the
//! equations say nothing there. The step is Gauss's collocation, whose points the singular position
//! lies between:
//!
//! ```text
//! ü = a(P q, P u) at the points,   P the projection onto the closed constraints
//! ```
//!
//! by repeated integration from the state at its start. At each point the branch is the nearest
//! one: the guess q₀ + u₀ t + ½a₀ t² is off by (t/R)³/6, R the time in which the motion moves by a
//! natural unit, the other branch by t/R. What the projection has left to correct, and the gaps
//! between the points, the singular position among them, say whether there is such a branch.

use crate::context::{RunContext, reduce};
use crate::integration::chart::nan_max;
use crate::model::ContactSet;
use crate::numerics::legendre::{LegendreSeries, POINTS, X};
use crate::numerics::zero::{MARGIN, SOLVED};
use crate::system::{DenseOutput, PhaseEquations};

/// Repeated integrations; each is ten times nearer and more.
const MOST: usize = 40;
/// The motion is known when it changes by no more than this, or no less than before by no more than
/// that: what rounding changes is transverse to the branch, and the projection at the end corrects
/// it.
const SETTLED: [f64; 2] = [1e-14, 1e-7];
/// The largest correction of positions by the projection, in natural units. That of rates, in those
/// per R, is [`MARGIN`], and the largest gap [`SOLVED`].
///
/// Rounding ε of the gaps turns rates at a distance x from the singular position by ε/x². A loop
/// that does not close in the singular position turns back before it: its gap there is what it
/// lacks.
const POSITIONS: f64 = 1e-8;
/// At a turning point rates are not what an energy determines.
const TURNING: f64 = 1e-2;

/// What moves, and how: R and the constraints that are closed.
pub(super) struct BridgeMotion<'a> {
    pub(super) context: &'a RunContext,
    pub(super) set: ContactSet,
    pub(super) time: f64,
    /// The state that it begins in.
    pub(super) from: &'a [f64],
}

/// A motion over one step.
pub(crate) struct Bridge {
    pub(crate) t: [f64; 2],
    /// The full state at the end.
    pub(crate) state: Vec<f64>,
    /// Coordinates, then rates.
    series: Vec<LegendreSeries>,
}

impl Bridge {
    /// The full state after a part of the step.
    pub(super) fn state_at(&self, context: &RunContext, theta: f64) -> Vec<f64> {
        let values: Vec<f64> = self.series.iter().map(|series| series.evaluate(2.0 * theta - 1.0)).collect();
        let state = context.layout().state_at(&values, self.t[0] + theta * (self.t[1] - self.t[0]));
        context.switched_as(&state, &self.state).into_vec()
    }

    /// As dense output of a phase.
    pub(crate) fn dense(&self, phase: &dyn PhaseEquations) -> DenseOutput {
        let [t0, t1] = self.t;
        let time = |k: usize| [t0, t1 - t0].get(k).copied().unwrap_or(0.0);
        let powers: Vec<_> = self.series.iter().map(LegendreSeries::powers).collect();
        let entries = phase.kept();
        let switches = phase.system().layout().switch(0);
        let switch = |k: usize, entry: usize| if k == 0 { self.state[entry] } else { 0.0 };
        let term = |k: usize, entry: usize| match powers.get(entry) {
            Some(powers) => powers[k],
            None if entry < switches => time(k),
            None => switch(k, entry),
        };
        let coefficients =
            (0..crate::numerics::legendre::TERMS).flat_map(|k| entries.iter().map(move |&entry| (k, entry)));
        let end = reduce(phase, &self.state);
        DenseOutput::series(self.t, &end, coefficients.map(|(k, entry)| term(k, entry)))
    }
}

impl BridgeMotion<'_> {
    /// The motion from a state over the time `h`; none where no branch goes on smoothly.
    pub(super) fn over(&self, t: f64, state: &[f64], h: f64) -> Option<Bridge> {
        let mut at = self.guess(t, state, h);
        let mut last = f64::INFINITY;
        for _ in 0..MOST {
            let forces: Vec<_> = at.iter().map(|state| self.accelerations(state)).collect();
            let series = self.integrated(state, h, &forces);
            let next: Vec<_> = X.map(|x| self.state(&series, (t, h), x)).to_vec();
            let change = at.iter().zip(&next).fold(0.0, |most, (a, b)| nan_max(most, self.apart(a, b)));
            at = next;
            if change <= SETTLED[0] || change <= SETTLED[1] && change >= last {
                return self.checked(series, (t, h), state);
            }
            if !(change.is_finite() && change < 10.0 * last) {
                return None;
            }
            last = change;
        }
        None
    }

    fn coordinates(&self) -> usize {
        self.context.layout().coordinates.len()
    }

    fn guess(&self, t: f64, state: &[f64], h: f64) -> Vec<Vec<f64>> {
        let n = self.coordinates();
        let (mut a, mut multipliers) = (vec![0.0; n], vec![0.0; self.context.layout().rows()]);
        // In a singular position nothing is known of it.
        if !self.context.system().solve(state, self.set, &mut a, &mut multipliers)
            || a.iter().any(|a| !self.is_usual(a))
        {
            a.fill(0.0);
        }
        let moved = |x: &f64| {
            let dt = 0.5 * h * (x + 1.0);
            let entry = |i: usize| match i {
                _ if i < n => state[i] + dt * (state[n + i] + 0.5 * dt * a[i]),
                _ if i < 2 * n => state[i] + dt * a[i - n],
                _ if i < self.context.layout().switch(0) => t + dt,
                _ => state[i],
            };
            (0..state.len()).map(entry).collect()
        };
        X.iter().map(moved).collect()
    }

    fn is_usual(&self, a: &f64) -> bool {
        (a * self.time * self.time / self.context.scales.length.max(1.0)).abs() < 100.0
    }

    fn accelerations(&self, state: &[f64]) -> Vec<f64> {
        let system = self.context.system();
        let mut on = state.to_vec();
        system.project(self.set, &mut on, self.context.scales.length);
        let mut a = vec![0.0; self.coordinates()];
        system.solve(&on, self.set, &mut a, &mut vec![0.0; self.context.layout().rows()]);
        a
    }

    /// The motion with these accelerations at Gauss's points.
    fn integrated(&self, state: &[f64], h: f64, a: &[Vec<f64>]) -> Vec<LegendreSeries> {
        let n = self.coordinates();
        let rate = |i: usize| LegendreSeries::through(|k| a[k][i]).integral(state[n + i], h);
        let rates: Vec<LegendreSeries> = (0..n).map(rate).collect();
        let coordinate = |(i, rate): (usize, &LegendreSeries)| rate.integral(state[i], h);
        let coordinates: Vec<LegendreSeries> = rates.iter().enumerate().map(coordinate).collect();
        [coordinates, rates].concat()
    }

    fn state(&self, series: &[LegendreSeries], (t, h): (f64, f64), x: f64) -> Vec<f64> {
        let values: Vec<f64> = series.iter().map(|series| series.evaluate(x)).collect();
        let state = self.context.layout().state_at(&values, t + 0.5 * h * (x + 1.0));
        self.context.switched_as(&state, self.from).into_vec()
    }

    /// The largest difference of two states, lengths and angles in natural units and rates in those
    /// per R.
    fn apart(&self, a: &[f64], b: &[f64]) -> f64 {
        let [positions, rates] = self.differences(a, b);
        nan_max(positions, rates)
    }

    fn differences(&self, a: &[f64], b: &[f64]) -> [f64; 2] {
        let (n, layout) = (self.coordinates(), self.context.layout());
        let unit = |i: usize| self.context.scales.coordinate(&layout.coordinates[i]);
        let largest = |place: usize, factor: f64| {
            (0..n).fold(0.0, |most, i| nan_max(most, factor * (a[place + i] - b[place + i]).abs() / unit(i)))
        };
        [largest(0, 1.0), largest(n, self.time)]
    }

    /// The motion, if it stays on the constraints and keeps its energy.
    fn checked(&self, series: Vec<LegendreSeries>, (t, h): (f64, f64), from: &[f64]) -> Option<Bridge> {
        let (context, layout) = (self.context, self.context.layout());
        let ahead = self.state(&series, (t, h), 1.0);
        let mut state = ahead.clone();
        context.system().project(self.set, &mut state, context.scales.length);
        let near = |a: &[f64], b: &[f64]| {
            let [positions, rates] = self.differences(a, b);
            positions <= POSITIONS && rates <= MARGIN
        };
        let on = |x: &f64| {
            let at = self.state(&series, (t, h), *x);
            let mut on = at.clone();
            context.system().project(self.set, &mut on, context.scales.length);
            near(&at, &on)
        };
        let between = (0..=4 * POINTS).map(|k| k as f64 / (2 * POINTS) as f64 - 1.0);
        let closes = |x: f64| {
            let equations = context.system().equations(&self.state(&series, (t, h), x));
            let rows = (0..layout.rows()).filter(|&row| layout.is_closed(row, &self.set));
            let gap = |row: usize| equations.gap()[row].abs() / layout.unit(row, context.scales.length);
            rows.fold(0.0, |most, row| nan_max(most, gap(row))) <= SOLVED
        };
        let held = near(&ahead, &state) && X.iter().all(on) && between.into_iter().all(closes);
        (held && self.keeps_energy(from, &mut state)).then_some(Bridge { t: [t, t + h], state, series })
    }

    /// Gives a state beyond the energy of one before, if it is near; the velocity constraints are
    /// homogeneous without drives.
    fn keeps_energy(&self, from: &[f64], to: &mut [f64]) -> bool {
        if !self.context.is_conservative() {
            return true;
        }
        let (n, system) = (self.coordinates(), self.context.system());
        let [before, after] = [system.energy(from), system.energy(to)];
        let gained = after.gained_since(&before);
        let square = 1.0 - gained / after.kinetic;
        if (square - 1.0).abs() < TURNING {
            to[n..2 * n].iter_mut().for_each(|rate| *rate *= square.sqrt());
        }
        gained.abs() <= MARGIN * before.kinetic.max(after.kinetic)
    }
}

/// The length of a step past a singular position at the first of two times and at least to the
/// second, so that no point is near the position.
pub(super) fn length([at, end]: [f64; 2]) -> f64 {
    let clear =
        |h: &f64| X.iter().fold(f64::INFINITY, |least, x| least.min((0.5 * h * (x + 1.0) - at).abs()));
    let lengths = (0..8).map(|k| end * (1.0 + 0.05 * f64::from(k)));
    lengths.max_by(|a, b| (clear(a) / a).total_cmp(&(clear(b) / b))).unwrap_or(end)
}
