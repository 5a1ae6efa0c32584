//! Derivatives of starts by differences (Fornberg, Mathematics of Computation 51, 1988), of the
//! fourth order where there are starts on both sides:
//!
//! ```text
//! 12 h x′ = 8 (x₁ − x₋₁) − (x₂ − x₋₂)
//! 60 h x′ = −147 x₀ + 360 x₁ − 450 x₂ + 400 x₃ − 225 x₄ + 72 x₅ − 10 x₆     where there is nothing on one side
//! ```
//!
//! Beside a dead centre, a turning point of the energy or a kink of the start these steps are too
//! long. So they are shortened until the difference of the second order is the same within four
//! digits; on one side, that with a shorter step, which is taken. The error of what is taken is of
//! the square of that at most.

/// First steps, in units of the variable: the error of the order is rounding.
const STEP: f64 = 3e-4;
const ONE_SIDED_STEP: f64 = 1e-3;
/// The last of so many steps is 1e-8, of which rounding leaves eight digits.
const SHORTER: f64 = 0.125;
const TIMES: i32 = 6;
const ONE_SIDED: [f64; 7] = [-147.0, 360.0, -450.0, 400.0, -225.0, 72.0, -10.0];
/// Two slopes are the same within this part of themselves, and of natural units for one of the
/// variable.
const SAME: f64 = 1e-4;
const SLIGHT: f64 = 1e-7;
/// Slopes to both sides differ by more than twice this part of themselves at a kink, or if the step
/// is too long.
const BENT: f64 = 0.05;
/// Roundings by which entries of starts differ that do not depend on a variable.
const ROUNDED: f64 = 8.0 * f64::EPSILON;
const NO_SLOPE: &str = "it has no derivative there";

/// Starts near a state.
pub(super) struct Differences<'a, F> {
    /// The start with a variable changed by so much, or why there is none.
    pub(super) of: F,
    pub(super) state: &'a [f64],
    /// Natural units of the entries of the state.
    pub(super) units: Vec<f64>,
    /// That of the variable.
    pub(super) unit: f64,
}

impl<F: Fn(f64) -> Result<Vec<f64>, String>> Differences<'_, F> {
    /// The derivative of each entry of the start.
    ///
    /// # Errors
    /// There is no start beside it, or its slopes depend on the step, and to both sides differ.
    pub(super) fn slopes(&self) -> Result<Vec<f64>, String> {
        let steps = |first: f64| (0..TIMES).map(move |k| first * self.unit * SHORTER.powi(k));
        let found = first_of(steps(STEP).map(|h| self.central(h)));
        let sided = |first: f64| first_of(steps(first).map(|h| self.sided(h)));
        let found = found.or_else(|_| sided(ONE_SIDED_STEP)).or_else(|_| sided(-ONE_SIDED_STEP));
        found?.ok_or_else(|| NO_SLOPE.to_owned())
    }

    /// Slopes from starts on both sides, if the step is short enough.
    fn central(&self, h: f64) -> Result<Option<Vec<f64>>, String> {
        let [before, after] = [(self.of)(-h)?, (self.of)(h)?];
        let entries = || 0..self.state.len();
        let is_kept = |i: usize| {
            let slight = ROUNDED * self.state[i].abs();
            [before[i], after[i]].iter().all(|x| (x - self.state[i]).abs() <= slight)
        };
        if entries().all(is_kept) {
            return Ok(Some(vec![0.0; self.state.len()]));
        }
        let [first, last] = [(self.of)(-2.0 * h)?, (self.of)(2.0 * h)?];
        let fourth = |i: usize| (8.0 * (after[i] - before[i]) - (last[i] - first[i])) / (12.0 * h);
        let fourth: Vec<f64> = entries().map(fourth).collect();
        let is_smooth = |i: usize| {
            let second = (after[i] - before[i]) / (2.0 * h);
            let bend = (after[i] - 2.0 * self.state[i] + before[i]) / (2.0 * h);
            self.are_same(i, [second, fourth[i]]) && bend.abs() <= BENT * fourth[i].abs() + self.slight(i)
        };
        Ok(entries().all(is_smooth).then_some(fourth))
    }

    /// Slopes from starts on one side, if the step is short enough.
    fn sided(&self, h: f64) -> Result<Option<Vec<f64>>, String> {
        let [long, short] = [self.one_sided(h)?, self.one_sided(SHORTER * h)?];
        let are_same = (0..self.state.len()).all(|i| self.are_same(i, [long[i], short[i]]));
        Ok(are_same.then_some(short))
    }

    fn one_sided(&self, h: f64) -> Result<Vec<f64>, String> {
        let mut slopes = vec![0.0; self.state.len()];
        for (k, weight) in ONE_SIDED.iter().enumerate() {
            let start = (self.of)(k as f64 * h)?;
            slopes.iter_mut().zip(start).for_each(|(slope, x)| *slope += weight * x / (60.0 * h));
        }
        Ok(slopes)
    }

    fn are_same(&self, i: usize, [one, other]: [f64; 2]) -> bool {
        (one - other).abs() <= SAME * one.abs().max(other.abs()) + self.slight(i)
    }

    /// A slope of entry `i` that is as good as none.
    fn slight(&self, i: usize) -> f64 {
        SLIGHT * self.units[i] / self.unit.abs()
    }
}

/// The first slopes that are found; none where the last step finds none; and why, if the last step
/// has no start.
fn first_of(
    tried: impl Iterator<Item = Result<Option<Vec<f64>>, String>>,
) -> Result<Option<Vec<f64>>, String> {
    let mut last = Ok(None);
    for next in tried {
        if let Ok(Some(found)) = next {
            return Ok(Some(found));
        }
        last = next;
    }
    last
}

#[cfg(test)]
mod tests;
