//! The stages of a step: which Jacobian serves, and which iteration.

use super::coefficients::DEFECT;
use super::factors::NewtonFactors;
use super::full::Full;
use super::newton::{Criterion, Newton, NewtonFailure, Stages};
use crate::integrate::growth::{compute_growth, compute_reach};
use crate::integrate::tolerance::norm;
use crate::integrate::{StepState, Tolerance, is_finite};

/// A Jacobian is kept while the iteration contracts faster than this.
const FAST: f64 = 1e-3;
/// Factors serve a step that differs by no more than times are rounded.
const SAME: f64 = 1e-6;
/// Roundings are allowed to be larger than estimated by this: they must not hold the step back.
const MARGIN: f64 = 10.0;
/// So many steps are made with the Jacobian of every stage once one Jacobian did not serve all
/// three.
const TURNING: u32 = 20;

/// e^z − R(z) = −z⁶/7200 + O(z⁷) (Hairer & Wanner II, IV.3, on Padé approximations).
const ERROR_CONSTANT: f64 = 1.0 / 7200.0;

/// ∂f/∂y.
type Exact<'a, const N: usize> = Box<dyn Fn(&[f64; N]) -> [[f64; N]; N] + 'a>;

/// The Jacobian last computed, of which jump it is and whether of the present state, and its
/// factors.
pub(super) struct NewtonSystem<'a, const N: usize> {
    jacobian: Exact<'a, N>,
    known: Option<([[f64; N]; N], u64)>,
    /// The largest rate at which a motion grows by it.
    growth: f64,
    fresh: bool,
    factors: Option<NewtonFactors<N>>,
    newton: Newton,
    full: Full<N>,
    /// So many steps more are made with the Jacobian of every stage.
    turning: u32,
}

/// The stages of a step, and the unit in which its error counts.
pub(super) struct Solved<const N: usize> {
    pub(super) z: Stages<N>,
    pub(super) scale: [f64; N],
}

impl<'a, const N: usize> NewtonSystem<'a, N> {
    pub(super) fn new(jacobian: impl Fn(&[f64; N]) -> [[f64; N]; N] + 'a) -> Self {
        let (newton, full) = (Newton::new(), Full::new());
        Self {
            jacobian: Box::new(jacobian),
            known: None,
            growth: 0.0,
            fresh: false,
            factors: None,
            newton,
            full,
            turning: 0,
        }
    }

    /// How many iterations the last step took.
    pub(super) fn iterations(&self) -> i32 {
        self.newton.iterations
    }

    /// To be called after each accepted step.
    pub(super) fn move_on(&mut self) {
        self.fresh = false;
        self.turning = self.turning.saturating_sub(1);
    }

    /// The stages of a step of length `h`, by the simplified iteration, and where it fails even
    /// with the Jacobian of this state by Newton's own.
    pub(super) fn solve(
        &mut self,
        f: &impl Fn(&[f64; N]) -> [f64; N],
        step_state: &mut StepState<f64, N>,
        tolerance: &Tolerance<N>,
        (h, guess): (f64, Stages<N>),
    ) -> Result<Solved<N>, NewtonFailure> {
        self.factor(h, tolerance.absolute());
        let Self { jacobian, fresh, factors, newton, full, turning, .. } = self;
        let factors = factors.as_ref().ok_or(NewtonFailure::NotFinite)?;
        let (y, counts) = (&step_state.state, &mut step_state.counts);
        let criterion = criterion(tolerance, factors, y);
        let scale = criterion.scale;
        if *turning == 0 {
            let change = |f: &Stages<N>, z: &Stages<N>| Some(factors.change(h, f, z));
            let solved = newton.solve(f, y, guess, &criterion, change);
            counts.evaluations += 3 * newton.iterations as u64;
            match solved {
                Ok(z) => return Ok(Solved { z, scale }),
                Err(failure) if !*fresh || matches!(failure, NewtonFailure::NotFinite) => {
                    return Err(failure);
                }
                Err(_) => *turning = TURNING,
            }
        }
        let change = |f: &Stages<N>, z: &Stages<N>| full.change(jacobian, (y, h, tolerance.absolute()), f, z);
        let solved = newton.solve(f, y, guess, &criterion, change);
        counts.evaluations += 3 * newton.iterations as u64;
        counts.jacobians += 3 * newton.iterations as u64;
        solved.map(|z| Solved { z, scale })
    }

    /// (γ/h − J)⁻¹ (f − p′(0)) with the collocation polynomial p through these stages; NaN without
    /// factors.
    pub(super) fn defect(&self, h: f64, f: &[f64; N], z: &Stages<N>) -> [f64; N] {
        let [e1, e2, e3] = DEFECT;
        let rate = |i: usize| (e1 * z[0][i] + e2 * z[1][i] + e3 * z[2][i]) / h;
        let defect = core::array::from_fn(|i| f[i] + rate(i));
        self.factors.as_ref().map_or([f64::NAN; N], |factors| factors.filter(&defect))
    }

    /// The Jacobian where there is none, or the last one served badly or keeps a step short.
    /// Returns the step that is `wanted`, or the longest over which what grows is followed.
    pub(super) fn update_jacobian(&mut self, step_state: &mut StepState<f64, N>, wanted: f64) -> f64 {
        let (jumps, reach) =
            (step_state.jumps(), compute_reach(step_state.tolerance.relative(), 5.0, ERROR_CONSTANT));
        let serves = self.turning == 0 && self.newton.contraction <= FAST && wanted * self.growth <= reach;
        if !((self.fresh || serves) && self.known.is_some_and(|(_, at)| at == jumps)) {
            step_state.counts.jacobians += 1;
            (self.fresh, self.factors) = (true, None);
            let jacobian = (self.jacobian)(&step_state.state);
            self.growth = compute_growth(&jacobian, step_state.tolerance.absolute());
            self.known = Some((jacobian, jumps));
        }
        wanted.min(reach / self.growth)
    }

    /// The factors for a step of length `h`; `unit`: that of each entry of the state.
    fn factor(&mut self, h: f64, unit: &[f64; N]) {
        let serves = |factors: &NewtonFactors<N>| (factors.h - h).abs() <= SAME * h;
        if self.factors.as_ref().is_some_and(serves) {
            return;
        }
        let finite = self.known.as_ref().filter(|(jacobian, _)| jacobian.iter().all(is_finite));
        self.factors = finite.and_then(|(jacobian, _)| NewtonFactors::new(h, jacobian, unit));
    }
}

/// The tolerance, not below rounding.
fn criterion<const N: usize>(
    tolerance: &Tolerance<N>,
    factors: &NewtonFactors<N>,
    y: &[f64; N],
) -> Criterion<N> {
    let rounding = factors.rounding(y);
    let mut scale = tolerance.scale(y, y);
    for (scale, rounding) in scale.iter_mut().zip(rounding) {
        *scale += MARGIN * rounding;
    }
    let target = tolerance.relative().sqrt().clamp(1e-4, 0.03);
    Criterion { target, rounding: norm(&rounding, &scale), scale }
}
