//! Radicands that are the square of a monomial once they are written as a series: the speed of a
//! pendulum's end, `√((l φ̇ cos φ)² + (l φ̇ sin φ)²) = |l φ̇|`, is a root of nothing that its
//! equations could not do without.

use crate::algebra::{Quotient, Rational, Series, Symbol};
use crate::motion::Expression;
use crate::system::{Function, Operator};

/// Longer radicands are left as they are.
const LONGEST: usize = 32;

/// c and r of a radicand c r², c > 0, r a monomial that varies.
pub(super) fn root(radicand: &Expression) -> Option<(Rational, Series)> {
    let quotient = folded(radicand)?;
    let (coefficient, monomial) = quotient.as_series()?.as_monomial()?;
    let factors = monomial.factors();
    let varies = factors.iter().any(|(symbol, _)| !matches!(symbol, Symbol::Parameter(_)));
    let is_square = factors.iter().all(|(_, power)| power % 2 == 0);
    if !varies || !is_square || coefficient <= Rational::ZERO {
        return None;
    }
    let root = factors.iter().try_fold(Series::one(), |product, &(symbol, power)| {
        let factor = Series::symbol(symbol).pow((power.unsigned_abs() / 2).into());
        let factor = if power < 0 { factor.recip_monomial()? } else { factor };
        Some(&product * &factor)
    });
    Some((coefficient, root?))
}

/// A sum of products as one series, unless it is long.
fn folded(expression: &Expression) -> Option<Quotient> {
    let value = match expression {
        Expression::Value(quotient) => quotient.clone(),
        Expression::Angle(_) | Expression::Time => return None,
        Expression::Apply(function, inner) => match function {
            Function::Negate => -folded(inner)?,
            Function::Power(n @ 0..=4) => {
                let inner = folded(inner)?;
                (0..*n).try_fold(Quotient::from(Series::one()), |product, _| short(&product * &inner))?
            }
            _ => return None,
        },
        Expression::Join(operator, a, b) => {
            let (a, b) = (folded(a)?, folded(b)?);
            match operator {
                Operator::Add => &a + &b,
                Operator::Subtract => &a - &b,
                Operator::Multiply => &a * &b,
                Operator::Divide => return None,
            }
        }
    };
    short(value)
}

fn short(quotient: Quotient) -> Option<Quotient> {
    (quotient.numerator().len() <= LONGEST && !quotient.is_overflow()).then_some(quotient)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn power(expression: Expression, n: i32) -> Expression {
        Expression::Apply(Function::Power(n), Box::new(expression))
    }

    fn join(operator: Operator, a: Expression, b: Expression) -> Expression {
        Expression::Join(operator, Box::new(a), Box::new(b))
    }

    /// (l u cos φ)² + (l u sin φ)² = l² u²; 9 u²/l²; and what is no square, may be negative, or
    /// does not vary.
    #[test]
    fn squares_of_monomials_have_a_root() {
        let (l, u) = (Series::symbol(Symbol::parameter(0)), Series::symbol(Symbol::rate(0)));
        let phi = crate::algebra::Angle::from_symbol(Symbol::coordinate(0));
        let arm = &l * &u;
        let [across, along] =
            [Series::cos(&phi), Series::sin(&phi)].map(|turn| Expression::series(&arm * &turn));
        let speed = join(Operator::Add, power(across, 2), power(along, 2));
        assert_eq!(root(&speed), Some((Rational::integer(1), arm)));

        let per = &u * &l.recip_monomial().unwrap();
        let nine = Expression::series(Series::constant(Rational::integer(9)));
        let product = join(Operator::Multiply, nine, power(Expression::series(per.clone()), 2));
        assert_eq!(root(&product), Some((Rational::integer(9), per)));

        let square = power(Expression::series(u.clone()), 2);
        let negated = Expression::Apply(Function::Negate, Box::new(square.clone()));
        let sum = join(Operator::Subtract, square.clone(), Expression::series(l.clone()));
        let quotient = join(Operator::Divide, square, Expression::series(l.clone()));
        let odd = power(Expression::series(u), 3);
        for none in [negated, sum, quotient, odd, power(Expression::series(l), 2), Expression::Time] {
            assert_eq!(root(&none), None, "{none:?}");
        }
    }
}
