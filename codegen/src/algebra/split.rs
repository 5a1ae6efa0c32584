//! Sines and cosines as factors of a series in waves of one angle, so that a denominator 1 + cos 2φ
//! shows as 2 cos² φ.

use super::{Angle, Series};

impl Series {
    /// Powers of cos a and sin a, a the angle of which all arguments are multiples, and what is
    /// left; everything is left where there is no such angle.
    pub fn split_waves(&self) -> (Vec<(Self, u32)>, Self) {
        let (mut factors, mut rest) = (Vec::new(), self.clone());
        let Some(angle) = self.common_angle() else {
            return (factors, rest);
        };
        for wave in [Self::cos(&angle), Self::sin(&angle)] {
            let mut k = 0;
            while let Some(quotient) = rest.divide_exact(&wave) {
                rest = quotient;
                k += 1;
            }
            factors.push((wave, k));
        }
        (factors, rest)
    }

    fn common_angle(&self) -> Option<Angle> {
        let waves = self.entries().iter().map(|(term, _)| &term.wave);
        let mut angles = waves.filter(|wave| !wave.is_one()).map(|wave| wave.argument.primitive());
        let first = angles.next()?;
        angles.all(|angle| angle == first).then(|| Angle::from_multipliers(first))
    }
}
