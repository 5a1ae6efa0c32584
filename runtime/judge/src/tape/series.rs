//! The values of a tape as power series in time, order by order.

use super::{Level, Node, Operation, Tape, whole};
use liftoff_core::scalar::Scalar;

/// What a tape reads: series of the positions and of their rates, from a time on.
#[derive(Clone, Debug)]
pub struct Inputs<S> {
    /// Where the series begin.
    pub t: S,
    /// Coefficients of each position.
    pub positions: Vec<Vec<S>>,
    /// Coefficients of each rate.
    pub rates: Vec<Vec<S>>,
}

/// Coefficients of all values of a tape.
#[derive(Clone, Debug)]
pub struct Series<S> {
    coefficients: Vec<Vec<S>>,
}

impl<S: Scalar> Series<S> {
    /// None yet.
    pub fn new(tape: &Tape<S>) -> Self {
        let of = |operation: &Operation<S>| match operation {
            Operation::Constant(value) => vec![*value],
            _ => Vec::new(),
        };
        Self { coefficients: tape.operations.iter().map(of).collect() }
    }

    /// The same with terms of lower orders only.
    pub fn truncated(&self, terms: usize) -> Self {
        let cut = |c: &Vec<S>| c[..terms.min(c.len())].to_vec();
        Self { coefficients: self.coefficients.iter().map(cut).collect() }
    }

    /// A coefficient; zero where it is beyond those computed.
    pub fn get(&self, node: Node, k: usize) -> S {
        self.coefficients[node.0].get(k).copied().unwrap_or(S::ZERO)
    }

    /// The coefficients computed.
    pub fn coefficients(&self, node: Node) -> &[S] {
        &self.coefficients[node.0]
    }

    /// Computes the coefficients of order `k` of all values of a level.
    pub fn extend(&mut self, tape: &Tape<S>, level: Level, k: usize, inputs: &Inputs<S>) {
        for (i, operation) in tape.operations.iter().enumerate() {
            if tape.levels[i] == level {
                let value = self.next(i, operation, k, inputs);
                self.coefficients[i].push(value);
            }
        }
    }

    fn next(&self, at: usize, operation: &Operation<S>, k: usize, inputs: &Inputs<S>) -> S {
        let own = &self.coefficients[at];
        let c = |node: Node| &self.coefficients[node.0][..];
        match *operation {
            Operation::Constant(_) => S::ZERO,
            Operation::Time if k == 0 => inputs.t,
            Operation::Time => whole(i64::from(k == 1)),
            Operation::Position(i) => inputs.positions[i][k],
            Operation::Rate(i) => inputs.rates[i][k],
            Operation::Sum(a, b) => self.get(a, k) + self.get(b, k),
            Operation::Difference(a, b) => self.get(a, k) - self.get(b, k),
            Operation::Product(a, b) => convolution(c(a), c(b), k, 0),
            Operation::Quotient(a, b) => (self.get(a, k) - convolution(c(b), own, k, 1)) / self.get(b, 0),
            Operation::Root(a) if k == 0 => self.get(a, 0).sqrt(),
            Operation::Root(a) => {
                let inner = (1..k).fold(S::ZERO, |sum, j| sum + own[j] * own[k - j]);
                (self.get(a, k) - inner) / (own[0] + own[0])
            }
            Operation::Exponential(a) if k == 0 => self.get(a, 0).exp(),
            Operation::Exponential(a) => turned(c(a), own, k),
            Operation::Logarithm(a) if k == 0 => self.get(a, 0).ln(),
            Operation::Logarithm(a) => {
                let inner =
                    (1..k).fold(S::ZERO, |sum, j| sum + whole::<S>(j as i64) * own[j] * self.get(a, k - j));
                (self.get(a, k) - inner / whole(k as i64)) / self.get(a, 0)
            }
            Operation::Arctangent(a, _) if k == 0 => self.get(a, 0).atan(),
            Operation::Arctangent(a, below) => {
                let inner = (1..k)
                    .fold(S::ZERO, |sum, j| sum + whole::<S>(j as i64) * own[j] * self.get(below, k - j));
                (self.get(a, k) - inner / whole(k as i64)) / self.get(below, 0)
            }
            Operation::Sine(a) if k == 0 => self.get(a, 0).sin_cos().0,
            Operation::Cosine(a) if k == 0 => self.get(a, 0).sin_cos().1,
            Operation::Sine(a) => turned(c(a), &self.coefficients[at + 1], k),
            Operation::Cosine(a) => -turned(c(a), &self.coefficients[at - 1], k),
        }
    }
}

/// Σ aⱼ bₖ₋ⱼ from j = `first`.
fn convolution<S: Scalar>(a: &[S], b: &[S], k: usize, first: usize) -> S {
    let last = k.min(a.len().saturating_sub(1));
    let least = first.max((k + 1).saturating_sub(b.len()));
    if a.is_empty() || b.is_empty() {
        return S::ZERO;
    }
    (least..=last).fold(S::ZERO, |sum, j| sum + a[j] * b[k - j])
}

/// Σ (j/k) aⱼ bₖ₋ⱼ.
fn turned<S: Scalar>(a: &[S], b: &[S], k: usize) -> S {
    let last = k.min(a.len().saturating_sub(1));
    let sum = (1..=last).fold(S::ZERO, |sum, j| sum + whole::<S>(j as i64) * a[j] * b[k - j]);
    sum / whole(k as i64)
}
