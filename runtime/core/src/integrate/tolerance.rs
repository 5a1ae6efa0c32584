//! The weighted norm of Hairer, Nørsett, Wanner I, (II.4.11): ‖x‖² = Σ (xᵢ / sᵢ)² / N,
//! sᵢ = absoluteᵢ + relative · |yᵢ|.

#[cfg(not(feature = "std"))]
use crate::scalar::Elementary as _;
use crate::scalar::Scalar;

/// Error allowed per step, in the unit of each component.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tolerance<const N: usize> {
    relative: f64,
    absolute: [f64; N],
}

/// A tolerance that cannot be met or measured.
#[derive(Clone, Copy, PartialEq, Debug, thiserror::Error)]
pub enum ToleranceError {
    /// The relative tolerance is negative, infinite or not a number.
    #[error("relative tolerance {0} is not a finite number ≥ 0")]
    Relative(f64),
    /// An absolute tolerance is not positive and finite.
    #[error("absolute tolerance {value} of component {component} is not a finite number > 0")]
    Absolute {
        /// Index of the component.
        component: usize,
        /// Its tolerance.
        value: f64,
    },
}

impl<const N: usize> Tolerance<N> {
    /// `absolute` is the natural scale of each component times the tolerance wanted.
    pub fn new(relative: f64, absolute: [f64; N]) -> Result<Self, ToleranceError> {
        Self::of_first(relative, &absolute)
    }

    /// Of the first components of a state that is filled up with others, which stand still and do
    /// not count.
    pub(crate) fn of_first(relative: f64, absolute: &[f64]) -> Result<Self, ToleranceError> {
        if !(relative >= 0.0 && relative.is_finite()) {
            return Err(ToleranceError::Relative(relative));
        }
        let bad = |value: f64| !(value > 0.0 && value.is_finite());
        if let Some(component) = absolute.iter().position(|&value| bad(value)) {
            let value = absolute[component];
            return Err(ToleranceError::Absolute { component, value });
        }
        let absolute = core::array::from_fn(|i| absolute.get(i).copied().unwrap_or(f64::INFINITY));
        Ok(Self { relative, absolute })
    }

    /// The relative part.
    pub const fn relative(&self) -> f64 {
        self.relative
    }

    /// The size of a state in units of the tolerance.
    pub(super) fn measure<S: Scalar>(&self, y: &[S; N]) -> f64 {
        if self.relative > 0.0 { 1.0 / self.relative } else { norm(y, &self.scale(y, y)).max(1.0) }
    }

    /// The absolute parts.
    pub(super) const fn absolute(&self) -> &[f64; N] {
        &self.absolute
    }

    /// The same, wider by a factor.
    #[cfg(feature = "std")]
    pub(crate) fn times(&self, factor: f64) -> Self {
        Self { relative: factor * self.relative, absolute: self.absolute.map(|a| factor * a) }
    }

    /// sᵢ for each component of the larger of |y0ᵢ| and |y1ᵢ|.
    #[inline]
    pub(super) fn scale<S: Scalar>(&self, y0: &[S; N], y1: &[S; N]) -> [f64; N] {
        core::array::from_fn(|i| {
            let size = y0[i].to_f64().abs().max(y1[i].to_f64().abs());
            self.relative.mul_add(size, self.absolute[i])
        })
    }
}

/// ‖x‖ with the scale s; where that is infinite a component does not count.
#[inline]
pub(super) fn norm<S: Scalar, const N: usize>(x: &[S; N], scale: &[f64; N]) -> f64 {
    let square = |i: usize| (x[i].to_f64() / scale[i]).powi(2);
    let count = scale.iter().filter(|scale| **scale < f64::INFINITY).count();
    ((0..N).map(square).sum::<f64>() / count.max(1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{Tolerance, norm};

    #[test]
    fn padding_is_not_weighted() {
        let (whole, first) = (Tolerance::new(1e-3, [0.1, 0.2]), Tolerance::<8>::of_first(1e-3, &[0.1, 0.2]));
        let (x, mut wide) = ([0.3, -0.4], [0.0; 8]);
        wide[..2].copy_from_slice(&x);
        let sizes =
            [norm(&x, &whole.unwrap().scale(&x, &x)), norm(&wide, &first.unwrap().scale(&wide, &wide))];
        assert_eq!(sizes[0], sizes[1]);
    }
}
