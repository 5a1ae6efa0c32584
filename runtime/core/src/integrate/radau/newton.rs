//! Newton iteration for the stages zᵢ = h Σ aᵢⱼ f(y + zⱼ), with the stopping criterion of Hairer &
//! Wanner II, IV.8, eqs. 8.10, 8.11. What a change is compared with is never below the rounding of
//! f.

use crate::integrate::is_finite;
use crate::integrate::tolerance::norm;

/// So many iterations are made.
const MOST: i32 = 7;
/// A slower contraction is none.
const SLOWEST: f64 = 0.99;

/// z₁, z₂, z₃.
pub(super) type Stages<const N: usize> = [[f64; N]; 3];

/// How the iteration is judged.
pub(super) struct Criterion<const N: usize> {
    /// The unit of each component.
    pub(super) scale: [f64; N],
    /// The error allowed.
    pub(super) target: f64,
    /// Changes below this are rounding.
    pub(super) rounding: f64,
}

/// Why there are no stages.
pub(super) enum NewtonFailure {
    /// A step shorter by this factor is likely to do better.
    Slow(f64),
    /// The iteration does not contract.
    Diverges,
    /// f is not finite.
    NotFinite,
}

/// The last iteration's speed.
pub(super) struct Newton {
    /// Θ: of two changes in a row, since one stiff direction can hide behind another for one
    /// iteration.
    pub(super) contraction: f64,
    /// How many changes were made.
    pub(super) iterations: i32,
}

impl Newton {
    pub(super) const MOST: i32 = MOST;

    pub(super) fn new() -> Self {
        Self { contraction: 0.0, iterations: 0 }
    }

    /// The stages of a step from `y`, found from `z` by adding the `change` for the slopes there; 3
    /// evaluations of f for each iteration.
    pub(super) fn solve<const N: usize>(
        &mut self,
        f: &impl Fn(&[f64; N]) -> [f64; N],
        y: &[f64; N],
        mut z: Stages<N>,
        criterion: &Criterion<N>,
        mut change: impl FnMut(&Stages<N>, &Stages<N>) -> Option<Stages<N>>,
    ) -> Result<Stages<N>, NewtonFailure> {
        let Criterion { scale, target, rounding } = criterion;
        self.contraction = 0.0;
        let (mut previous, mut ratio) = (f64::NAN, f64::NAN);
        for iteration in 1..=MOST {
            self.iterations = iteration;
            let slopes = z.map(|z| f(&core::array::from_fn(|i| y[i] + z[i])));
            if !slopes.iter().all(is_finite) {
                return Err(NewtonFailure::NotFinite);
            }
            let change = change(&slopes, &z).ok_or(NewtonFailure::Diverges)?;
            for (z, change) in z.iter_mut().flatten().zip(change.iter().flatten()) {
                *z += change;
            }
            let size = (change.iter().map(|d| norm(d, scale).powi(2)).sum::<f64>() / 3.0).sqrt();
            if size <= *rounding {
                return Ok(z);
            }
            if iteration > 1 {
                let last = core::mem::replace(&mut ratio, size / previous);
                self.contraction = ratio.max(last);
                if self.excess(iteration, size / target)? <= 1.0 {
                    return Ok(z);
                }
            }
            previous = size.max(f64::EPSILON);
        }
        Err(NewtonFailure::Diverges)
    }

    /// The error left after a change of `size` targets, Θ/(1 − Θ) of it; an error if the iterations
    /// left will not bring it down to one.
    fn excess(&self, iteration: i32, size: f64) -> Result<f64, NewtonFailure> {
        if self.contraction >= SLOWEST || self.contraction.is_nan() {
            return Err(NewtonFailure::Diverges);
        }
        let excess = self.contraction / (1.0 - self.contraction) * size;
        let left = MOST - iteration;
        let expected = excess * self.contraction.powi(left);
        if expected > 1.0 {
            return Err(NewtonFailure::Slow(0.8 * expected.min(20.0).powf(-1.0 / f64::from(4 + left))));
        }
        Ok(excess)
    }
}
