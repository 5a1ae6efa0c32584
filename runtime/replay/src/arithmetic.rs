//! Arithmetic of conditions and outputs.

use crate::Number;
use liftoff::__private::expression::{Function, Operator};

/// What is read as π is meant as π.
pub(crate) fn number<S: Number>(x: f64) -> S {
    if x == core::f64::consts::PI { S::pi() } else { S::from_f64(x) }
}

pub(crate) fn apply<S: Number>(function: Function, x: S) -> S {
    match function {
        Function::Negate => -x,
        Function::Sqrt => x.sqrt(),
        Function::Sin => x.sin_cos().0,
        Function::Cos => x.sin_cos().1,
        Function::Tan => x.sin_cos().0 / x.sin_cos().1,
        Function::Abs => x.abs(),
        Function::Exp => x.exp(),
        Function::Log => x.ln(),
        Function::Tanh => x.tanh(),
        Function::Atan => x.atan(),
        Function::Sign if x == S::ZERO => S::ZERO,
        Function::Sign => x / x.abs(),
    }
}

/// `None` of powers that are not whole.
pub(crate) fn join<S: Number>(operator: Operator, a: S, b: S) -> Option<S> {
    Some(match operator {
        Operator::Add => a + b,
        Operator::Subtract => a - b,
        Operator::Multiply => a * b,
        Operator::Divide => a / b,
        Operator::Power => return power(a, b),
        Operator::Atan2 => direction(a, b),
        Operator::Where => {
            if a > S::ZERO {
                b
            } else {
                S::ZERO
            }
        }
        Operator::Unless => {
            if a > S::ZERO {
                S::ZERO
            } else {
                b
            }
        }
    })
}

/// The direction of (x, y): a right angle less one with a tangent up to 1 where y is the larger.
fn direction<S: Number>(y: S, x: S) -> S {
    let quarter = S::pi() * S::ratio(1, 2);
    if y.abs() > x.abs() {
        return if y > S::ZERO { quarter - (x / y).atan() } else { -quarter - (x / y).atan() };
    }
    match x < S::ZERO {
        true if y < S::ZERO => (y / x).atan() - S::pi(),
        true => (y / x).atan() + S::pi(),
        false if x == S::ZERO => x,
        false => (y / x).atan(),
    }
}

/// xⁿ for whole n up to 64.
fn power<S: Number>(x: S, n: S) -> Option<S> {
    let exponent = n.to_f64();
    if n != S::from_f64(exponent) || exponent.fract() != 0.0 || exponent.abs() > 64.0 {
        return None;
    }
    let one = S::ratio(1, 1);
    let power = (0..exponent.abs() as u32).fold(one, |product, _| product * x);
    Some(if exponent < 0.0 { one / power } else { power })
}
