//! Numbers in place of parameters and of the start, as the exact rationals that doubles are.

use std::collections::BTreeMap;

use liftoff_codegen::algebra::{Series, Symbol};
use liftoff_codegen::system::{Definition, System};
use liftoff_codegen::{Analysis, plain};
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::{Ring, Variable};
use crate::error::ConditionError;
use crate::level::start_of;
use crate::numeric::chart::Place;

/// Values of variables.
#[derive(Clone)]
pub(crate) struct Values(BTreeMap<Variable, BigRational>);

impl Values {
    /// Those of the parameters, by name, and of a start with its rate.
    pub fn new(
        analysis: &Analysis,
        given: &[(String, f64)],
        coordinate: usize,
        start: &Place,
        rate: f64,
    ) -> Result<Self, ConditionError> {
        let mut values = BTreeMap::new();
        let parameters = parameters(&analysis.system, given)?;
        for (i, value) in with_derived(&analysis.system, &parameters).into_iter().enumerate() {
            // A derived constant that is no number here does not occur in what is evaluated.
            if let Some(value) = BigRational::from_float(value) {
                values.insert(Variable::Plain(Symbol::parameter(i)), value);
            }
        }
        let [at, rate_of] = [0, 1].map(|order| start_of(analysis, coordinate, order));
        let rate = BigRational::from_float(rate)
            .ok_or_else(|| ConditionError::NotFinite { name: "the rate at the start".to_owned() })?;
        values.insert(Variable::Plain(rate_of), rate);
        Ok(Self(values).with(at, start))
    }

    /// These, and that of a coordinate or its start.
    pub fn with(&self, coordinate: Symbol, place: &Place) -> Self {
        let mut values = self.0.clone();
        match place.circle() {
            Some([sine, cosine]) => {
                values.insert(Variable::Sine(coordinate), sine);
                values.insert(Variable::Cosine(coordinate), cosine);
            }
            None => {
                values.insert(Variable::Plain(coordinate), place.number());
            }
        }
        Self(values)
    }

    pub fn value(&self, ring: &Ring, polynomial: &Polynomial) -> BigRational {
        self.coefficients(ring, polynomial, []).into_values().sum()
    }

    /// The coefficients by the powers of some variables, whose values are left open; zero where a
    /// variable has no value.
    pub fn coefficients<const N: usize>(
        &self,
        ring: &Ring,
        polynomial: &Polynomial,
        open: [usize; N],
    ) -> BTreeMap<[u32; N], BigRational> {
        let mut coefficients = BTreeMap::new();
        for (exponents, c) in polynomial.terms() {
            let closed = exponents.iter().enumerate().filter(|(x, k)| **k > 0 && !open.contains(x));
            let value = closed.fold(BigRational::from(c.clone()), |product, (x, k)| {
                let value = self.0.get(&ring.variables[x]).cloned().unwrap_or_else(BigRational::zero);
                product * power(&value, *k)
            });
            *coefficients.entry(open.map(|x| exponents[x])).or_insert_with(BigRational::zero) += value;
        }
        coefficients
    }
}

/// Values of all parameters in their order.
fn parameters(system: &System, given: &[(String, f64)]) -> Result<Vec<f64>, ConditionError> {
    let value = |name: String| {
        let found = given.iter().rev().find(|(known, _)| *known == name).map(|(_, value)| *value);
        match found {
            None => Err(ConditionError::Parameter { name }),
            Some(value) if !value.is_finite() => Err(ConditionError::NotFinite { name }),
            Some(value) => Ok(value),
        }
    };
    system.parameters.iter().map(plain).map(value).collect()
}

/// Values of parameters, and behind them those of the constants that are derived of them.
pub(crate) fn with_derived(system: &System, parameters: &[f64]) -> Vec<f64> {
    let mut values = parameters.to_vec();
    for constant in &system.constants {
        let value = |series: &Series| {
            series.evaluate(&|symbol| match symbol {
                Symbol::Parameter(i) => values.get(usize::from(i)).copied().unwrap_or(f64::NAN),
                _ => f64::NAN,
            })
        };
        let derived = match constant {
            Definition::Sqrt(a) => value(a).sqrt(),
            Definition::Ratio(a, b) => value(a) / value(b),
        };
        values.push(derived);
    }
    values
}

/// xᵏ.
pub(crate) fn power(x: &BigRational, k: u32) -> BigRational {
    (0..k).fold(BigRational::one(), |power, _| power * x)
}
