//! What the figure settles: one of several alternatives, by lengths of the figure that are not
//! negative. An alternative that holds at every sample is taken, and its lengths are checked again
//! with a model's own parameters, unless they cannot be negative.

use super::{Figure, NEAR, Place, SAMPLES};
use crate::algebra::{Series, Symbol};
use crate::system::scope::Scope;
use crate::system::{Body, Definition, ParameterValues, Settled, Settles, Structure, System};

/// How the samples of the figure decide between alternatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::system) enum Verdict {
    /// This one.
    One(usize),
    /// This one as well as others, everywhere.
    Several(usize),
    /// Some say this, some that.
    None,
}

/// A direction of the figure as a vector, `factor` times as long as the body.
pub(in crate::system) struct Heading {
    pub along: Place,
    pub factor: Series,
}

impl Figure {
    /// The alternative whose lengths are nowhere negative; where the samples differ, that of the
    /// first sample, if it has only one.
    pub fn decide(&self, scope: &Scope, alternatives: &[Vec<Series>]) -> Verdict {
        let first = hold(&self.now(scope, 1), alternatives);
        match (&self.everywhere(scope, alternatives)[..], &first[..]) {
            (&[one], _) | (&[], &[one]) => Verdict::One(one),
            (&[one, ..], _) => Verdict::Several(one),
            ([], _) => Verdict::None,
        }
    }

    /// The alternatives whose lengths are nowhere negative.
    pub fn everywhere(&self, scope: &Scope, alternatives: &[Vec<Series>]) -> Vec<usize> {
        hold(&self.now(scope, SAMPLES), alternatives)
    }

    /// The first samples with the constants derived by now, where all are numbers, and what is near
    /// to zero there.
    fn now(&self, scope: &Scope, count: usize) -> Vec<(ParameterValues, f64)> {
        let (fields, constants) = (scope.description.fields.len(), scope.constants.definitions());
        let samples = self.samples.iter();
        let samples = samples.map(|sample| (sample.numbers.with(fields, constants), NEAR * sample.extent()));
        samples.filter(|(numbers, _)| numbers.are_finite()).take(count).collect()
    }

    /// Notes what was settled, to be checked with a model's parameters.
    pub fn settle(
        &mut self,
        scope: &Scope,
        structure: &Structure,
        settles: Settles,
        name: &str,
        lengths: &[Series],
        factor: &Series,
    ) {
        let known = SignFacts { definition: &|i| scope.constants.definition(i), bodies: &structure.bodies };
        let open = lengths.iter().filter(|length| !known.never_negative(length));
        let settled = open.map(|length| Settled {
            settles,
            name: name.to_owned(),
            length: length.clone(),
            factor: factor.clone(),
        });
        self.settled.extend(settled);
    }

    /// The direction of a body's frame.
    pub fn heading(&self, scope: &Scope, structure: &Structure, body: usize) -> Heading {
        let minus = |a: &Place, b: &Place| [&a[0] - &b[0], &a[1] - &b[1]];
        let bar = &structure.bodies[body];
        let along = minus(&self.positions[bar.to], &self.positions[bar.from]);
        match structure.members(body) {
            [(_, a), (_, b), ..] if !structure.is_bar(body) => {
                Heading { along: unturned(scope, &along, &minus(b, a)), factor: bar.length.clone() }
            }
            _ => Heading { along, factor: Series::one() },
        }
    }
}

/// a b*, complex.
pub(in crate::system) fn unturned(scope: &Scope, a: &Place, b: &Place) -> Place {
    let times = |x: &Series, y: &Series| scope.constants.multiply(x, y);
    [&times(&a[0], &b[0]) + &times(&a[1], &b[1]), &times(&a[1], &b[0]) - &times(&a[0], &b[1])]
}

/// The alternatives that hold at all of some samples, of which there is one at least.
fn hold(samples: &[(ParameterValues, f64)], alternatives: &[Vec<Series>]) -> Vec<usize> {
    let not_negative =
        |length: &Series| samples.iter().all(|(numbers, near)| numbers.evaluate(length) >= -near);
    let holds = |i: &usize| !samples.is_empty() && alternatives[*i].iter().all(not_negative);
    (0..alternatives.len()).filter(holds).collect()
}

impl System {
    /// That a body has its direction, in quarter turns, if a model's parameters might say
    /// otherwise.
    pub fn settled_direction(&self, body: usize, quarters: i64) -> Option<Settled> {
        let Body { from, to, ref name, ref length, .. } = self.bodies[body];
        let minus = |[a, b]: &Place, [c, d]: &Place| [a - c, b - d];
        let [x, y] = minus(&self.figure[to], &self.figure[from]);
        let [along, across] = minus(&self.local(body, to), &self.local(body, from));
        let [x, y] = [&(&x * &along) + &(&y * &across), &(&y * &along) - &(&x * &across)];
        let holds = [x.clone(), y.clone(), -x, -y][quarters.rem_euclid(4) as usize].clone();
        let constant = |i: usize| self.constants.get(i.checked_sub(self.parameters.len())?);
        let known = SignFacts { definition: &constant, bodies: &self.bodies };
        let open = !known.never_negative(&holds);
        let (name, factor) = (name.clone(), length.clone());
        open.then_some(Settled { settles: Settles::Direction, name, length: holds, factor })
    }
}

/// What is known of parameters without their values.
struct SignFacts<'a> {
    definition: &'a dyn Fn(usize) -> Option<&'a Definition>,
    bodies: &'a [Body],
}

impl SignFacts<'_> {
    /// Whether every term is a positive number times lengths of bars, roots and even powers.
    fn never_negative(&self, series: &Series) -> bool {
        series.terms().all(|(term, coefficient)| {
            let mut factors = term.monomial.factors().iter();
            let positive = factors.all(|&(x, k)| k % 2 == 0 || self.positive(x));
            coefficient.signum() > 0 && term.wave.is_one() && positive
        })
    }

    fn positive(&self, symbol: Symbol) -> bool {
        let Symbol::Parameter(i) = symbol else { return false };
        match (self.definition)(i.into()) {
            Some(Definition::Sqrt(_)) => true,
            Some(Definition::Ratio(a, b)) => self.never_negative(a) && self.never_negative(b),
            None => self.bodies.iter().any(|body| body.length == Series::symbol(symbol)),
        }
    }
}
