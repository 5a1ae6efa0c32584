//! A smooth function over a step with bounds of its values and slopes over any piece: those in the
//! middle, and what the greatest slope and curvature allow to either side.

use super::GuardError;
use super::polynomial::Polynomial;

/// A polynomial that fits a function.
pub struct Smooth {
    value: Polynomial,
    /// Half the first derivative and a quarter of the second.
    slope: Polynomial,
    curvature: Polynomial,
    error: f64,
}

impl Smooth {
    /// Fits a function that is known to within `delta`; none if no polynomial does.
    ///
    /// # Errors
    /// It is infinite or not a number somewhere.
    pub fn fit(g: &mut dyn FnMut(f64) -> f64, delta: f64) -> Result<Option<Self>, GuardError> {
        let value = Polynomial::fit(g, [0.0, 1.0], delta, &|_| false)?;
        Ok(value.resolved.then(|| Self::new(value)))
    }

    /// A polynomial of at most this degree, known to within `error` beside rounding.
    ///
    /// # Errors
    /// It is infinite or not a number somewhere.
    pub fn polynomial(g: &mut dyn FnMut(f64) -> f64, degree: usize, error: f64) -> Result<Self, GuardError> {
        Ok(Self::new(Polynomial::exact(g, degree, error)?))
    }

    fn new(value: Polynomial) -> Self {
        let (slope, error) = (value.derivative(), 2.0 * value.error);
        let curvature = slope.derivative();
        Self { value, slope, curvature, error }
    }

    /// The value in the middle of a piece and the most that others there differ from it.
    pub fn value(&self, [start, end]: [f64; 2]) -> (f64, f64) {
        let steepest = 2.0 * reach(&self.slope);
        (self.value.evaluate(0.5 * (start + end)), 0.5 * (end - start) * steepest + self.error)
    }

    /// The length of a piece over which the function changes by its error at most.
    pub fn resolution(&self) -> f64 {
        let steepest = 2.0 * reach(&self.slope);
        if steepest > 0.0 { 2.0 * self.error / steepest } else { 1.0 }
    }

    /// The same of the slope. The derivative of an error ε of degree n is at most 2 n² ε (Markov).
    pub fn slope(&self, [start, end]: [f64; 2]) -> (f64, f64) {
        let bend = 4.0 * reach(&self.curvature);
        let error = 2.0 * (self.value.degree.max(1) as f64).powi(2) * self.error;
        (2.0 * self.slope.evaluate(0.5 * (start + end)), 0.5 * (end - start) * bend + error)
    }
}

/// The greatest value, at most.
fn reach(polynomial: &Polynomial) -> f64 {
    let [low, high] = polynomial.range();
    low.abs().max(high.abs())
}
