//! Expressions of time and motion, evaluated with their first two time derivatives.
//!
//! A value is a jet (f, ḟ, f̈); what is read off the motion has no known derivatives here and is
//! given zeros, so that only functions of time alone (drives) have meaningful ones.

use super::{Assembly, Coordinate, State};

/// An expression.
#[derive(Clone, Debug)]
pub enum Formula {
    /// A number.
    Constant(f64),
    /// t.
    Time,
    /// The value of a coordinate.
    Value(Coordinate),
    /// The rate of a coordinate.
    Rate(Coordinate),
    /// a + b.
    Sum(Box<Formula>, Box<Formula>),
    /// a · b.
    Product(Box<Formula>, Box<Formula>),
    /// 1/a.
    Inverse(Box<Formula>),
    /// √a.
    Sqrt(Box<Formula>),
    /// sin a.
    Sin(Box<Formula>),
    /// cos a.
    Cos(Box<Formula>),
    /// eᵃ.
    Exp(Box<Formula>),
    /// log a.
    Log(Box<Formula>),
    /// tanh a.
    Tanh(Box<Formula>),
    /// atan a.
    Atan(Box<Formula>),
    /// |a|, away from zero.
    Abs(Box<Formula>),
}

/// f, ḟ, f̈.
pub type Jet = [f64; 3];

/// F(f): F', F'' by the chain rule.
fn chain([f, v, a]: Jet, of: impl Fn(f64) -> Jet) -> Jet {
    let [value, first, second] = of(f);
    [value, first * v, second * v * v + first * a]
}

impl Formula {
    /// Its value and its time derivatives.
    pub fn jet(&self, assembly: &Assembly, state: &State) -> Jet {
        let of = |formula: &Self| formula.jet(assembly, state);
        let read = |coordinate: &Coordinate, order: usize| assembly.measure(state, coordinate)[order];
        match self {
            Self::Constant(value) => [*value, 0.0, 0.0],
            Self::Time => [state.time, 1.0, 0.0],
            Self::Value(coordinate) => [read(coordinate, 0), 0.0, 0.0],
            Self::Rate(coordinate) => [read(coordinate, 1), 0.0, 0.0],
            Self::Sum(a, b) => {
                let (a, b) = (of(a), of(b));
                [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
            }
            Self::Product(a, b) => {
                let (a, b) = (of(a), of(b));
                [a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + 2.0 * a[1] * b[1] + a[0] * b[2]]
            }
            Self::Inverse(a) => chain(of(a), |x| [1.0 / x, -x.powi(-2), 2.0 * x.powi(-3)]),
            Self::Sqrt(a) => chain(of(a), |x| [x.sqrt(), 0.5 * x.powf(-0.5), -0.25 * x.powf(-1.5)]),
            Self::Sin(a) => chain(of(a), |x| [x.sin(), x.cos(), -x.sin()]),
            Self::Cos(a) => chain(of(a), |x| [x.cos(), -x.sin(), -x.cos()]),
            Self::Exp(a) => chain(of(a), |x| [x.exp(); 3]),
            Self::Log(a) => chain(of(a), |x| [x.ln(), 1.0 / x, -x.powi(-2)]),
            Self::Tanh(a) => chain(of(a), |x| {
                let slope = x.cosh().powi(-2);
                [x.tanh(), slope, -2.0 * x.tanh() * slope]
            }),
            Self::Atan(a) => chain(of(a), |x| {
                let slope = 1.0 / (1.0 + x * x);
                [x.atan(), slope, -2.0 * x * slope * slope]
            }),
            Self::Abs(a) => chain(of(a), |x| [x.abs(), x.signum(), 0.0]),
        }
    }

    /// Its value.
    pub fn value(&self, assembly: &Assembly, state: &State) -> f64 {
        self.jet(assembly, state)[0]
    }
}
