//! Lengths, and values that no parameter changes.

use super::Definition;
use super::constants::Constants;
use super::figure::SAMPLES;
use super::scope::Scope;
use crate::algebra::{Series, Symbol};

impl Scope<'_> {
    /// x² + y².
    pub fn square(&self, [x, y]: &[Series; 2]) -> Series {
        &self.constants.multiply(x, x) + &self.constants.multiply(y, y)
    }

    /// √(x² + y²); along an axis the component itself, with the sign that makes it positive where
    /// that is the same at every sample.
    pub fn norm(&mut self, vector: &[Series; 2]) -> Series {
        let along = match vector {
            [x, y] if y.is_zero() => Some(x),
            [x, y] if x.is_zero() => Some(y),
            _ => None,
        };
        let signs = along.map(|x| {
            let values: Vec<f64> =
                self.candidates().take(SAMPLES).map(|numbers| numbers.evaluate(x)).collect();
            (x, values.iter().all(|x| *x >= 0.0), values.iter().all(|x| *x <= 0.0))
        });
        match signs {
            Some((x, true, _)) => x.clone(),
            Some((x, _, true)) => -x,
            // A sum of squares is never a negative constant.
            _ => {
                let square = self.square(vector);
                self.constants.sqrt(&square).unwrap_or(square)
            }
        }
    }

    /// The value of a series, if it is the same for all parameters.
    pub fn literal(&self, series: &Series) -> Option<f64> {
        self.constants.independent(series).then(|| self.nominal().evaluate(series)).filter(|x| x.is_finite())
    }

    /// The value of a position, if it is the same for all parameters.
    pub fn literal_pair(&self, [x, y]: &[Series; 2]) -> Option<[f64; 2]> {
        Some([self.literal(x)?, self.literal(y)?])
    }
}

impl Constants {
    /// Whether a series has the same value for all parameters.
    fn independent(&self, series: &Series) -> bool {
        series.symbols().into_iter().all(|symbol| match symbol {
            Symbol::Parameter(i) => match self.definition(i.into()) {
                Some(Definition::Sqrt(a)) => self.independent(a),
                Some(Definition::Ratio(a, b)) => self.independent(a) && self.independent(b),
                None => false,
            },
            _ => false,
        })
    }
}
