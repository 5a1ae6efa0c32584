//! Resultants and discriminants by subresultants (Cohen, *A Course in Computational Algebraic
//! Number Theory*, 3.3.7).

use super::Polynomial;

impl Polynomial {
    /// The resultant with respect to a variable: zero exactly where both have a common root, or
    /// both leading coefficients vanish.
    pub fn resultant(&self, other: &Self, variable: usize) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::zero(self.variables);
        }
        let (mut a, mut b) = (self.clone(), other.clone());
        let odd = |p: &Self| p.degree(variable) % 2 == 1;
        let mut negative = false;
        if a.degree(variable) < b.degree(variable) {
            negative = odd(&a) && odd(&b);
            std::mem::swap(&mut a, &mut b);
        }
        let (mut g, mut h) = (Self::one(self.variables), Self::one(self.variables));
        while b.depends_on(variable) {
            let delta = a.degree(variable) - b.degree(variable);
            negative ^= odd(&a) && odd(&b);
            let remainder = a.pseudo_remainder(&b, variable);
            a = b;
            b = remainder.over(&(&g * &h.pow(delta)));
            if b.is_zero() {
                return b;
            }
            g = a.leading_coefficient(variable);
            h = raised(&g, &h, delta);
        }
        let resultant = raised(&b, &h, a.degree(variable));
        if negative { -&resultant } else { resultant }
    }

    /// The discriminant with respect to a variable, up to its sign: zero exactly where two roots
    /// are one.
    pub fn discriminant(&self, variable: usize) -> Self {
        let resultant = self.resultant(&self.derivative(variable), variable);
        resultant.over(&self.leading_coefficient(variable))
    }
}

/// gⁿ h¹⁻ⁿ.
fn raised(g: &Polynomial, h: &Polynomial, n: u32) -> Polynomial {
    match n {
        0 => h.clone(),
        _ => g.pow(n).over(&h.pow(n - 1)),
    }
}
