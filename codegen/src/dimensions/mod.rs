//! Dimensions of the parameters, from what each expression of a declaration stands for.
//!
//! A mass is a mass and a position a length; the terms of a sum are alike; what a sine is taken of
//! is a number. With one unknown dimension d for each parameter these are linear equations, Σ cᵢ dᵢ =
//! D in the powers of length, time and mass, solved exactly in the order of the declaration, so
//! that the equation that contradicts those before it is known with its place.
//!
//! A number with a dimension fits wherever it stands (`length = 2`, `stiffness = 3 * m`). So
//! equations of expressions with numbers in them, or without parameters, are taken after the
//! others; where they contradict, the declaration holds in one system of units only, which is no
//! mistake. 0 has every dimension. Of a declaration in pure numbers, `#[liftoff(dimensionless)]`,
//! nothing is demanded.

mod affine;
mod declared;
mod equation;
mod message;
mod name;
mod reader;
mod solution;
#[cfg(test)]
mod tests;

use crate::algebra::Rational;
use crate::syntax::{Description, Report};
use equation::DimensionEquation;
use solution::EchelonForm;

/// Powers of length, time and mass.
pub type Dimension = [Rational; 3];

/// The powers as numerators over a common denominator; none where they do not fit a byte.
pub fn in_bytes(powers: Dimension) -> Option<([i8; 3], i8)> {
    let times = |power: Rational, denominator: i8| {
        let whole = power * Rational::integer(denominator.into());
        i8::try_from(whole.numerator()).ok().filter(|_| whole.denominator() == 1)
    };
    (1..=i8::MAX).find_map(|denominator| {
        let [length, time, mass] = powers.map(|power| times(power, denominator));
        Some(([length?, time?, mass?], denominator))
    })
}

/// What the dimensions of a declaration are.
#[derive(Clone, Debug)]
pub struct Dimensions {
    /// Of each parameter; none where the declaration does not determine it.
    pub parameters: Vec<Option<Dimension>>,
    /// Whether no number has a dimension: the equations hold in every system of units.
    pub covariant: bool,
}

impl Dimensions {
    /// The dimensions of what a resolved description declares.
    ///
    /// # Errors
    /// Every expression whose dimension contradicts those before it.
    pub(crate) fn infer(description: &Description) -> syn::Result<Self> {
        if description.dimensionless {
            return Ok(Self { parameters: vec![None; description.fields.len()], covariant: false });
        }
        let (numeric, strict): (Vec<DimensionEquation>, Vec<DimensionEquation>) =
            declared::equations(description).into_iter().partition(|equation| equation.numeric);
        let mut sure = EchelonForm::default();
        let mut report = Report::default();
        let mut told = Vec::new();
        for (i, equation) in strict.iter().enumerate() {
            let Some(conflict) = sure.add(i, &equation.zero) else { continue };
            let about: Vec<usize> = equation.zero.unknowns().collect();
            if about.is_empty() || !told.contains(&about) {
                report.over(equation.at, message::contradiction(&strict, equation, &conflict, &sure));
                told.push(about);
            }
        }
        report.finish()?;
        let mut all = sure.clone();
        let agree =
            |(i, equation): (usize, &DimensionEquation)| all.add(strict.len() + i, &equation.zero).is_none();
        let covariant = numeric.iter().enumerate().all(agree);
        let known = if covariant { all } else { sure };
        let parameters = (0..description.fields.len()).map(|i| known.parameter(i)).collect();
        Ok(Self { parameters, covariant })
    }
}
