//! Derivatives of values, as further values of the same tape.

use std::collections::HashMap;

use super::{Level, Node, Operation, Tape, Variable, whole};
use liftoff_core::scalar::Scalar;

/// What has been differentiated already.
#[derive(Clone, Debug, Default)]
pub(super) struct Memo {
    pub(super) derivatives: HashMap<(Node, Variable), Node>,
    pub(super) waves: HashMap<Node, Node>,
}

impl<S: Scalar> Tape<S> {
    /// ∂a/∂x; rates are held.
    pub fn derivative(&mut self, a: Node, by: Variable) -> Node {
        if self.level(a) == Level::Fixed {
            return Self::ZERO;
        }
        if let Some(&known) = self.memo.derivatives.get(&(a, by)) {
            return known;
        }
        let found = self.differentiate(a, by);
        self.memo.derivatives.insert((a, by), found);
        found
    }

    fn differentiate(&mut self, a: Node, by: Variable) -> Node {
        match self.operations[a.0] {
            Operation::Constant(_) | Operation::Rate(_) => Self::ZERO,
            Operation::Time => self.unit(by == Variable::Time),
            Operation::Position(i) => self.unit(by == Variable::Position(i)),
            Operation::Sum(x, y) => {
                let [x, y] = [x, y].map(|node| self.derivative(node, by));
                self.add(x, y)
            }
            Operation::Difference(x, y) => {
                let [x, y] = [x, y].map(|node| self.derivative(node, by));
                self.subtract(x, y)
            }
            Operation::Product(x, y) => {
                let [dx, dy] = [x, y].map(|node| self.derivative(node, by));
                self.dot([dx, x], [y, dy])
            }
            Operation::Quotient(x, y) => {
                let [dx, dy] = [x, y].map(|node| self.derivative(node, by));
                let back = self.multiply(a, dy);
                let numerator = self.subtract(dx, back);
                self.divide(numerator, y)
            }
            Operation::Root(x) => {
                let dx = self.derivative(x, by);
                let two = self.number(whole(2));
                let twice = self.multiply(two, a);
                self.divide(dx, twice)
            }
            Operation::Exponential(x) => {
                let dx = self.derivative(x, by);
                self.multiply(dx, a)
            }
            Operation::Logarithm(x) => {
                let dx = self.derivative(x, by);
                self.divide(dx, x)
            }
            Operation::Arctangent(x, below) => {
                let dx = self.derivative(x, by);
                self.divide(dx, below)
            }
            Operation::Sine(x) => {
                let dx = self.derivative(x, by);
                self.multiply(dx, Node(a.0 + 1))
            }
            Operation::Cosine(x) => {
                let dx = self.derivative(x, by);
                let back = self.multiply(dx, Node(a.0 - 1));
                self.negate(back)
            }
        }
    }

    fn unit(&self, is: bool) -> Node {
        if is { Self::ONE } else { Self::ZERO }
    }

    /// The non-zero ∂a/∂xᵢ.
    pub fn gradient(&mut self, a: Node) -> Vec<(usize, Node)> {
        let all = (0..self.positions.len()).map(|i| (i, self.derivative(a, Variable::Position(i))));
        all.filter(|&(_, slope)| slope != Self::ZERO).collect()
    }

    /// da/dt of a function of positions and time.
    pub fn rate(&mut self, a: Node) -> Node {
        let explicit = self.derivative(a, Variable::Time);
        let gradient = self.gradient(a);
        gradient.into_iter().fold(explicit, |sum, (i, slope)| {
            let part = self.multiply(slope, self.speed(i));
            self.add(sum, part)
        })
    }
}
