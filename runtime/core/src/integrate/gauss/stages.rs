//! The stages by fixed-point iteration, to rounding (Hairer, McLachlan, Razakarivony, *BIT* 48
//! (2008) 231; the stopping criterion is that of Antoñana, Makazaga, Murua, *Numer. Algorithms* 76
//! (2017) 861): until no component changes, or none changes less than it did before.

use super::tableau::{Stages, Tableau};
use crate::integrate::{Rates, is_finite};

/// An iteration that takes longer has a step that is too long.
const MOST: usize = 40;
/// Changes in units of rounding, relative to the state, that an iteration may stall with.
const ROUNDING: f64 = 1e4 * f64::EPSILON;

/// Why there are no stages.
pub(super) enum IterationFailure {
    /// The iteration does not contract.
    Slow,
    /// f is not finite.
    NotFinite,
}

/// A state as the sum of a double and of what that leaves.
#[derive(Clone, Copy)]
pub(super) struct Sum<const N: usize> {
    pub(super) high: [f64; N],
    pub(super) low: [f64; N],
}

impl<const N: usize> Sum<N> {
    pub(super) fn new(high: [f64; N]) -> Self {
        Self { high, low: [0.0; N] }
    }

    /// The sum with all Lⱼ added, the small ones first.
    pub(super) fn advance<const S: usize>(&self, l: &Stages<N, S>) -> Self {
        let mut sum = *self;
        for i in 0..N {
            let change = l.iter().map(|l| l[i]).sum::<f64>() + self.low[i];
            sum.high[i] = self.high[i] + change;
            let part = sum.high[i] - self.high[i];
            sum.low[i] = (self.high[i] - (sum.high[i] - part)) + (change - part);
        }
        sum
    }
}

/// What is solved.
pub(super) struct CollocationEquations<'a, const N: usize, const S: usize> {
    pub(super) f: Rates<'a, f64, N>,
    pub(super) tableau: &'a Tableau<S>,
    /// The rates of the first so many entries are the entries that follow.
    pub(super) pairs: usize,
}

impl<const N: usize, const S: usize> CollocationEquations<'_, N, S> {
    /// Lⱼ = h bⱼ f(y + Σ μⱼₖ Lₖ), found from `l` with each entry used as soon as it is known, until
    /// it changes by no more than `enough`; where it stalls, changes within `rounding` are rounding
    /// too. Counts evaluations of f.
    pub(super) fn solve(
        &self,
        (y, h): (&Sum<N>, f64),
        l: &mut Stages<N, S>,
        [enough, rounding]: [&[f64; N]; 2],
        evaluations: &mut u64,
    ) -> Result<(), IterationFailure> {
        let mut least = [f64::INFINITY; N];
        for sweep in 0..MOST {
            let changes = self.sweep((y, h), l);
            *evaluations += S as u64;
            if !l.iter().all(is_finite) {
                return Err(IterationFailure::NotFinite);
            }
            if (0..N).all(|i| changes[i] <= enough[i]) {
                return Ok(());
            }
            if (0..N).all(|i| changes[i] <= enough[i] || changes[i] >= least[i]) {
                let size = |i: usize| y.high[i].abs() + l.iter().map(|l| l[i].abs()).sum::<f64>();
                let settled = (0..N).all(|i| changes[i] <= (ROUNDING * size(i)).max(rounding[i]));
                // The first sweep changes what the guess left, which may be next to nothing in some
                // components.
                match settled {
                    true => return Ok(()),
                    false if sweep > 1 => return Err(IterationFailure::Slow),
                    false => {}
                }
            }
            least = core::array::from_fn(|i| least[i].min(changes[i]));
        }
        Err(IterationFailure::Slow)
    }

    /// The largest change of each component.
    fn sweep(&self, (y, h): (&Sum<N>, f64), l: &mut Stages<N, S>) -> [f64; N] {
        let Tableau { mu, weights, .. } = self.tableau;
        let at = |l: &Stages<N, S>, j: usize, i: usize| {
            y.high[i] + (0..S).fold(y.low[i], |sum, k| sum + mu[j][k] * l[k][i])
        };
        let mut changes = [0.0f64; N];
        let mut set = |l: &mut Stages<N, S>, j: usize, i: usize, rate: f64| {
            let new = h * weights[j] * rate;
            changes[i] = changes[i].max((new - l[j][i]).abs());
            l[j][i] = new;
        };
        for i in 0..self.pairs {
            for j in 0..S {
                let rate = at(l, j, self.pairs + i);
                set(l, j, i, rate);
            }
        }
        for j in 0..S {
            let slope = (self.f)(&core::array::from_fn(|i| at(l, j, i)));
            for i in self.pairs..N {
                set(l, j, i, slope[i]);
            }
        }
        changes
    }
}
