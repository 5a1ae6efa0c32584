//! How fast a motion changes, and how far its series reach.

use super::Expansion;
use liftoff_core::scalar::Scalar;

impl<S: Scalar> Expansion<'_, S> {
    /// One over the natural time of a state with these accelerations.
    pub fn pace(&self, a: &[S]) -> f64 {
        let length = self.scene.length;
        let size = |x: &S, angle: bool| x.abs().to_f64() * if angle { 1.0 } else { 1.0 / length };
        let angles = self.scene.angles.iter();
        let speed = self.inputs.rates.iter().zip(angles.clone()).map(|(v, &angle)| size(&v[0], angle));
        let turn = a.iter().zip(angles).map(|(a, &angle)| size(a, angle));
        speed.fold(0.0, f64::max).max(turn.fold(0.0, f64::max).sqrt())
    }

    /// The largest acceleration that an applied force alone would make.
    pub fn pull(&self, length: f64) -> f64 {
        let bodies = self.scene.forces.iter().zip(&self.scene.masses).zip(&self.scene.angles);
        let alone = bodies.filter(|((_, mass), _)| **mass > S::ZERO).map(|((&force, &mass), &angle)| {
            (self.series.get(force, 0) / mass).abs().to_f64() * if angle { length } else { 1.0 }
        });
        alone.filter(|a| a.is_finite()).fold(0.0, f64::max)
    }

    /// How far the series reach: where their last terms are rounding beside what they belong to.
    pub fn reach(&self, length: f64) -> f64 {
        let last = self.inputs.positions.first().map_or(0, Vec::len);
        self.distance(length, last.saturating_sub(3)..last, |k| (0.25 * S::EPSILON.to_f64()).powf(1.0 / k))
    }

    /// How far they would reach if terms went on as those of middle order do.
    pub fn promise(&self, length: f64) -> f64 {
        let last = self.inputs.positions.first().map_or(0, Vec::len);
        let falls = (0.25 * S::EPSILON.to_f64()).powf(1.0 / last as f64);
        self.distance(length, last / 2 - 3..last / 2, |_| falls)
    }

    /// The least of |c₀/cₖ|^(1/k) times a factor of k.
    fn distance(&self, length: f64, orders: core::ops::Range<usize>, factor: impl Fn(f64) -> f64) -> f64 {
        let mut reach = f64::INFINITY;
        for (positions, &angle) in self.inputs.positions.iter().zip(&self.scene.angles) {
            let least = if angle { 1.0 } else { length };
            let size = positions[0].abs().to_f64().max(least);
            for k in orders.clone() {
                let term = positions[k].abs().to_f64() / size;
                if term > 0.0 {
                    reach = reach.min((1.0 / term).powf(1.0 / k as f64) * factor(k as f64));
                } else if term.is_nan() {
                    return f64::NAN;
                }
            }
        }
        reach
    }
}
