//! Gragg's method extrapolated (Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations
//! I*, 2nd ed., II.9): the midpoint rule (9.13a,b) with n = 2, 4, 6, … substeps of h = H/n,
//!
//! ```text
//! z₁ = z₀ + h f(z₀),    zᵢ₊₁ = zᵢ₋₁ + 2h f(zᵢ),    T₍ⱼ₁₎ = z₍ₙⱼ₎
//! ```
//!
//! has an error in even powers of h, which the scheme of Aitken and Neville (9.10) removes one by
//! one:
//!
//! ```text
//! T₍ⱼ,ₖ₊₁₎ = T₍ⱼₖ₎ + (T₍ⱼₖ₎ − T₍ⱼ₋₁,ₖ₎) / ((nⱼ/nⱼ₋ₖ)² − 1)
//! ```
//!
//! The number of rows r is the one with the least work per time, `(1 + r²)/H` with the step H that
//! its error asks for, and is looked for from step to step among its neighbours (the same, II.9,
//! order and step size control).
//!
//! The state is a slice, so that one copy of this code serves every model.

use crate::Number;

/// Weights of 12 rows grow to some 10², two digits.
const ROWS: usize = 12;
/// The fewest rows that an error is read from.
const FEWEST: usize = 3;
/// A row whose last two entries differ by this part of the tolerance, by rounding alone, is the
/// last one: short steps, on the way to a root, need few.
const ENOUGH: f64 = 1e-9;
/// A row fewer is taken where it has so much less work, a row more where the last one made it so
/// much less.
const FEWER: f64 = 0.8;
const MORE: f64 = 0.9;
const SAFETY: f64 = 0.9;
const SMALLEST: f64 = 0.1;
const LARGEST: f64 = 3.0;
/// Evaluations after which a motion is too stiff or too long for an explicit method.
const MOST_EVALUATIONS: u64 = 2_000_000;

/// Why the extrapolation did not reach its end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum IntegrationFailure {
    /// The step shrank to nothing: the equations are singular there or not finite.
    Step,
    /// The work has no end in sight.
    Work,
}

/// The right-hand side of y′ = f(y), and what is done to y after each step.
pub(crate) trait Field<S> {
    /// f(y).
    fn rates(&self, y: &[S], rates: &mut [S]);
    /// Brings y back on its constraints, if it has any.
    fn restore(&self, y: &mut [S]);
}

/// An integration with error control per step.
pub(crate) struct Extrapolation<'a, S> {
    field: &'a dyn Field<S>,
    /// Natural size of each component.
    units: &'a [f64],
    /// Error per step, relative.
    tolerance: f64,
    /// The step to try next, its sign included.
    pub(crate) step: f64,
    /// How many rows it is meant to have.
    rows: usize,
    pub(crate) evaluations: u64,
}

/// A step that was tried.
struct Trial<S> {
    state: Vec<S>,
    /// In units of the tolerance, NaN if it is not finite.
    error: f64,
    /// Factor of the step, and how many rows the next one has.
    growth: f64,
    rows: usize,
}

impl<'a, S: Number> Extrapolation<'a, S> {
    /// From a first step on.
    pub(crate) fn new(field: &'a dyn Field<S>, units: &'a [f64], tolerance: f64, step: f64) -> Self {
        // Three rows for every five digits.
        let rows = (1.5 - 0.6 * tolerance.log10()).clamp(FEWEST as f64, ROWS as f64) as usize;
        Self { field, units, tolerance, step, rows, evaluations: 0 }
    }

    /// Replaces y by the solution after the time `span`, which may be negative.
    pub(crate) fn advance(&mut self, y: &mut [S], span: S) -> Result<(), IntegrationFailure> {
        if span == S::ZERO {
            self.shift(y, span);
        }
        let mut left = span;
        let shortest = 1e-18 * self.step.abs();
        while left != S::ZERO {
            let whole = self.step.abs() >= left.abs().to_f64();
            let h = if whole { left } else { S::from_f64(self.step.abs().copysign(left.to_f64())) };
            let trial = self.trial(y, h);
            if self.evaluations > MOST_EVALUATIONS {
                return Err(IntegrationFailure::Work);
            }
            if trial.error <= 1.0 {
                y.copy_from_slice(&trial.state);
                self.field.restore(y);
                left = if whole { S::ZERO } else { left - h };
                // A last short step says nothing of the next.
                if !whole {
                    (self.step, self.rows) = (h.to_f64() * trial.growth, trial.rows);
                }
                continue;
            }
            self.step = h.to_f64() * trial.growth.min(SAFETY);
            if self.step.abs() <= shortest {
                return Err(IntegrationFailure::Step);
            }
        }
        Ok(())
    }

    /// The same down to rounding, over a time that is short beside a step.
    pub(crate) fn refine(&mut self, y: &mut [S], span: S) -> Result<(), IntegrationFailure> {
        let rows = core::mem::replace(&mut self.rows, ROWS);
        let refined = self.advance(y, span);
        self.rows = rows;
        refined
    }

    /// One step, of a row fewer to a row more than were meant.
    fn trial(&mut self, y: &[S], h: S) -> Trial<S> {
        let mut rates = vec![S::ZERO; y.len()];
        self.rates(y, &mut rates);
        let mut row: Vec<Vec<S>> = Vec::with_capacity(ROWS);
        let mut before = None;
        for j in 0..ROWS {
            let mut entry = self.midpoint(y, &rates, h, j);
            // Row j replaces row j − 1 from the left, each entry from its neighbours in both.
            for k in 0..j {
                let ratio = S::ratio(1 + j as i64, (j - k) as i64);
                let divisor = ratio * ratio - S::ratio(1, 1);
                let next = entry.iter().zip(&row[k]).map(|(&t, &above)| t + (t - above) / divisor).collect();
                row[k] = core::mem::replace(&mut entry, next);
            }
            row.push(entry);
            let rows = j + 1;
            if rows < FEWEST {
                continue;
            }
            let error = self.error(y, &row[j - 1], &row[j]);
            let growth = growth(error, rows);
            let found = error <= ENOUGH || error <= 1.0 && rows + 1 >= self.rows;
            if found || rows == ROWS || rows > self.rows || error.is_nan() {
                let (growth, rows) = following((growth, rows), before);
                return Trial { state: row.swap_remove(j), error, growth, rows };
            }
            before = Some(growth);
        }
        Trial { state: y.to_vec(), error: f64::NAN, growth: SMALLEST, rows: self.rows }
    }

    /// The midpoint rule with 2(j + 1) substeps.
    fn midpoint(&mut self, y: &[S], rates: &[S], h: S, j: usize) -> Vec<S> {
        let substeps = 2 * (j + 1);
        let h = h / S::ratio(substeps as i64, 1);
        let twice = h + h;
        let mut before = y.to_vec();
        let mut now: Vec<_> = y.iter().zip(rates).map(|(&y, &f)| h.mul_add(f, y)).collect();
        let mut rates = rates.to_vec();
        for _ in 1..substeps {
            self.rates(&now, &mut rates);
            for (z, &f) in before.iter_mut().zip(&rates) {
                *z = twice.mul_add(f, *z);
            }
            core::mem::swap(&mut before, &mut now);
        }
        now
    }

    fn rates(&mut self, y: &[S], rates: &mut [S]) {
        self.evaluations += 1;
        self.field.rates(y, rates);
    }

    /// y + f(y) δ for a δ whose square is nothing: of a derivative, or of a rounding.
    pub(crate) fn shift(&mut self, y: &mut [S], by: S) {
        let mut rates = vec![S::ZERO; y.len()];
        self.rates(y, &mut rates);
        y.iter_mut().zip(rates).for_each(|(y, f)| *y = by.mul_add(f, *y));
    }

    /// The largest of all parts.
    fn error(&self, y: &[S], before: &[S], last: &[S]) -> f64 {
        let mut largest = 0.0;
        for part in 0..S::PARTS {
            let size = |x: S, i: usize| x.part(part).abs() / self.units[i];
            for i in 0..y.len() {
                let own = size(y[i], i).max(size(last[i], i)) + S::FLOOR;
                let difference = size(last[i] - before[i], i);
                let error = if difference == 0.0 { 0.0 } else { difference / own / self.tolerance };
                if !error.is_finite() {
                    return f64::NAN;
                }
                largest = f64::max(largest, error);
            }
        }
        largest
    }
}

/// By how much the step may grow: the difference of the last two entries of the last of so many
/// rows is O(H²ʳ⁻¹).
fn growth(error: f64, rows: usize) -> f64 {
    let growth = SAFETY / error.powf(1.0 / (2 * rows - 1) as f64);
    if growth.is_nan() { SMALLEST } else { growth.clamp(SMALLEST, LARGEST) }
}

/// Growth and rows of the next step, given those of this one and what a row fewer would have grown
/// by.
fn following((growth, rows): (f64, usize), before: Option<f64>) -> (f64, usize) {
    let evaluations = |rows: usize| (1 + rows * rows) as f64;
    let work = evaluations(rows) / growth;
    match before.map(|before| (before, evaluations(rows - 1) / before)) {
        Some((before, fewer)) if fewer < FEWER * work => (before, rows - 1),
        Some((_, fewer)) if work >= MORE * fewer => (growth, rows),
        _ if rows == ROWS => (growth, rows),
        _ => (growth * evaluations(rows + 1) / evaluations(rows), rows + 1),
    }
}
