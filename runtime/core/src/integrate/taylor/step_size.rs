//! How far the series reach.

use crate::integrate::Tolerance;
use crate::integrate::tolerance::norm;
#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;
use crate::series::ORDERS;

/// The last term of the series, against the tolerance: what is left out is smaller.
pub(super) const LAST: f64 = 0.01;

/// log₂ of how much farther the last two coefficients may reach than the two before.
pub(super) const SYMMETRY: f64 = 0.25;

/// log₂ of how much farther they may reach than the two before those.
pub(super) const SPARSENESS: f64 = 1.0;

/// The order, and how far a series of that order goes.
pub(super) struct StepSize {
    pub order: usize,
    /// log₂ ε, ε the tolerance relative to the state.
    tolerance: f64,
}

impl StepSize {
    /// p = 6 − 0.55 ln ε. A step goes as far as the radius of convergence times ε^(1/p): least work
    /// per time is at p = −½ ln ε where an order costs as much as it has terms (Jorba & Zou, §
    /// 3.2), and a little above that where all columns of a tape are summed at once; even, as two
    /// orders are. Measured on the double pendulum from 21 starts, ε = 1e-2 … 1e-13.
    pub fn new<const N: usize>(tolerance: &Tolerance<N>, state: &[f64; N]) -> Self {
        let relative = if tolerance.relative() > 0.0 {
            tolerance.relative()
        } else {
            let scale = tolerance.scale(state, state);
            (0..N).map(|i| scale[i] / state[i].abs()).fold(1.0, f64::min)
        };
        let relative = relative.clamp(f64::MIN_POSITIVE, 1.0);
        let half = 0.5 * (6.0 - 0.55 * relative.ln());
        let order = (2 * half.round() as usize).min(ORDERS - 1);
        Self { order, tolerance: relative.log2() }
    }

    /// θ up to which the series meets the tolerance: the radius of convergence r by the last two
    /// coefficients, ‖cₚ‖ rᵖ = ‖y‖ (Jorba & Zou, (3–8)), times the part of it in which the last
    /// term falls to a hundredth of the tolerance. Two, as one of them may vanish by symmetry; and
    /// no farther than a fifth above what the two before tell, as both may: of a pendulum let go
    /// level only every fourth is there; nor than twice what the two before those tell. Infinite
    /// where all vanish.
    pub fn compute_theta<const N: usize>(
        &self,
        series: &[[f64; N]; ORDERS],
        tolerance: &Tolerance<N>,
    ) -> f64 {
        let part = (LAST.log2() + self.tolerance) / self.order as f64;
        let within = |theta: f64| {
            let end = core::array::from_fn(|i| series[0][i].abs() + theta * series[1][i].abs());
            let scale = tolerance.scale(&series[0], &end);
            let inverse = scale.map(|scale| 1.0 / scale);
            let size = |k: usize| (0..N).map(|i| series[k][i].abs() * inverse[i]).fold(0.0, f64::max);
            let radius = |size: f64, k: usize| -(log2(size) + self.tolerance) / k as f64;
            let of = |k: usize| radius(size(k), k);
            let pair = |k: usize| of(self.order - k).min(of(self.order - k - 1));
            let k = self.order - 4;
            // Of these two the larger is enough: what it allows is less by far.
            let sparse = radius(size(k).max(size(k - 1)), k);
            exp2(pair(0).min(pair(2) + SYMMETRY).min(sparse + SPARSENESS) + part)
        };
        let theta = within(1.0);
        if theta < 0.5 { within(theta) } else { theta }
    }

    /// The part of a step to take instead where its defect is so many times what is allowed: as the
    /// first term that is left out has it, which is O(hᵖ⁺¹), or where f is not analytic much less.
    pub fn shorter(&self, defect: f64) -> f64 {
        let part = 0.9 * exp2(-log2(defect) / (self.order + 1) as f64);
        if defect.is_finite() { part.clamp(0.25, 0.9) } else { 0.25 }
    }
}

/// How often the state changes by its own size in a unit of time, by its first two coefficients.
pub(super) fn rate<const N: usize>([y, slope, bend]: &[[f64; N]; 3], tolerance: &Tolerance<N>) -> f64 {
    let scale = tolerance.scale(y, y);
    let size = tolerance.measure(y);
    let second = (2.0 * norm(bend, &scale) / size).sqrt();
    (norm(slope, &scale) / size).max(second)
}

/// To 0.01: the exponent, and a parabola through the ends and the middle of what the fraction adds.
fn log2(x: f64) -> f64 {
    const FRACTION: u32 = f64::MANTISSA_DIGITS - 1;
    let bits = x.to_bits();
    let exponent = (bits >> FRACTION) as i64 - i64::from(f64::MAX_EXP - 1);
    let fraction = (bits & ((1 << FRACTION) - 1)) as f64 / (1_u64 << FRACTION) as f64;
    exponent as f64 + fraction * (1.34 - 0.34 * fraction)
}

/// To 0.3 %.
fn exp2(x: f64) -> f64 {
    let floor = x.floor().clamp(-1000.0, 1000.0);
    let fraction = x - floor;
    let scale = f64::from_bits(((floor as i64 + 1023) as u64) << (f64::MANTISSA_DIGITS - 1));
    scale * (1.0 + fraction * (0.66 + 0.34 * fraction))
}
