//! Exact division, and division with remainder in one variable.

use num_integer::Integer;
use num_traits::Zero;

use super::{Exponents, Polynomial};

impl Polynomial {
    /// self / divisor where that is a polynomial with integer coefficients, by leading terms.
    pub fn divide_exact(&self, divisor: &Self) -> Option<Self> {
        let (leading, d) = divisor.leading()?;
        let mut quotient = Self::zero(self.variables);
        let mut remainder = self.clone();
        while let Some((exponents, c)) = remainder.leading() {
            let lowered: Option<Exponents> =
                exponents.iter().zip(leading).map(|(a, b)| a.checked_sub(*b)).collect();
            let (c, rest) = c.div_rem(d);
            let exponents = lowered.filter(|_| rest.is_zero())?;
            remainder = &remainder - &divisor.times_term(&exponents, &c);
            quotient.terms.insert(exponents, c);
        }
        Some(quotient)
    }

    /// R with `lc(B)^(deg A − deg B + 1) A = Q B + R`, `deg R < deg B` in a variable.
    pub(super) fn pseudo_remainder(&self, divisor: &Self, variable: usize) -> Self {
        let degree = divisor.degree(variable);
        let leading = divisor.leading_coefficient(variable);
        let mut remainder = self.clone();
        let mut steps = (self.degree(variable) + 1).saturating_sub(degree);
        while !remainder.is_zero() && remainder.degree(variable) >= degree && steps > 0 {
            let mut shift = vec![0; self.variables];
            shift[variable] = remainder.degree(variable) - degree;
            let top = remainder.leading_coefficient(variable);
            let shifted = divisor.times_term(&shift, &1.into());
            remainder = &(&remainder * &leading) - &(&shifted * &top);
            steps -= 1;
        }
        &remainder * &leading.pow(steps)
    }
}
