//! Arithmetic of positions, rates and time as a list of operations, each after those it uses.

mod derivative;
mod series;

pub use series::{Inputs, Series};

use derivative::Memo;
use liftoff_core::scalar::{Real, Scalar};

/// A value on the tape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Node(usize);

/// What a value is computed from.
#[derive(Clone, Copy, Debug)]
enum Operation<S> {
    Constant(S),
    Time,
    Position(usize),
    Rate(usize),
    Sum(Node, Node),
    Difference(Node, Node),
    Product(Node, Node),
    Quotient(Node, Node),
    Root(Node),
    Exponential(Node),
    Logarithm(Node),
    /// Of the first, 1 + whose square is the second.
    Arctangent(Node, Node),
    /// Its cosine is the next value.
    Sine(Node),
    /// Its sine is the value before.
    Cosine(Node),
}

/// On what a value depends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// On parameters alone.
    Fixed,
    /// On positions and time.
    Position,
    /// On rates too.
    Rate,
}

/// By what is differentiated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Variable {
    /// Time where it stands explicitly.
    Time,
    /// A position.
    Position(usize),
}

/// Operations.
#[derive(Clone, Debug)]
pub struct Tape<S> {
    operations: Vec<Operation<S>>,
    levels: Vec<Level>,
    memo: Memo,
    time: Node,
    positions: Vec<Node>,
    rates: Vec<Node>,
}

impl<S: Scalar> Tape<S> {
    /// 0.
    pub const ZERO: Node = Node(0);
    /// 1.
    pub const ONE: Node = Node(1);

    /// The number of operations.
    pub fn size(&self) -> usize {
        self.operations.len()
    }

    /// No arithmetic yet of so many positions.
    pub fn new(n: usize) -> Self {
        let mut tape = Self {
            operations: Vec::new(),
            levels: Vec::new(),
            memo: Memo::default(),
            time: Self::ZERO,
            positions: Vec::new(),
            rates: Vec::new(),
        };
        tape.push(Operation::Constant(S::ZERO), Level::Fixed);
        tape.push(Operation::Constant(S::from_f64(1.0)), Level::Fixed);
        tape.time = tape.push(Operation::Time, Level::Position);
        tape.positions = (0..n).map(|i| tape.push(Operation::Position(i), Level::Position)).collect();
        tape.rates = (0..n).map(|i| tape.push(Operation::Rate(i), Level::Rate)).collect();
        tape
    }

    fn push(&mut self, operation: Operation<S>, level: Level) -> Node {
        self.operations.push(operation);
        self.levels.push(level);
        Node(self.operations.len() - 1)
    }

    fn join(&mut self, operation: Operation<S>, a: Node, b: Node) -> Node {
        let level = self.level(a).max(self.level(b));
        self.push(operation, level)
    }

    /// On what a value depends.
    pub fn level(&self, node: Node) -> Level {
        self.levels[node.0]
    }

    /// The value of what depends on nothing.
    pub fn fixed(&self, node: Node) -> Option<S> {
        if let Operation::Constant(value) = self.operations[node.0] { Some(value) } else { None }
    }

    /// A number.
    pub fn number(&mut self, value: S) -> Node {
        if value == S::ZERO {
            Self::ZERO
        } else if value == S::from_f64(1.0) {
            Self::ONE
        } else {
            self.push(Operation::Constant(value), Level::Fixed)
        }
    }

    /// A number of its own, to be set later.
    pub fn adjustable(&mut self) -> Node {
        self.push(Operation::Constant(S::ZERO), Level::Fixed)
    }

    /// Sets it.
    pub fn adjust(&mut self, node: Node, value: S) {
        self.operations[node.0] = Operation::Constant(value);
    }

    /// t.
    pub fn time(&self) -> Node {
        self.time
    }

    /// A position.
    pub fn position(&self, i: usize) -> Node {
        self.positions[i]
    }

    /// Its rate.
    pub fn speed(&self, i: usize) -> Node {
        self.rates[i]
    }

    /// a + b.
    pub fn add(&mut self, a: Node, b: Node) -> Node {
        match (self.fixed(a), self.fixed(b)) {
            (Some(x), Some(y)) => self.number(x + y),
            _ if a == Self::ZERO => b,
            _ if b == Self::ZERO => a,
            _ => self.join(Operation::Sum(a, b), a, b),
        }
    }

    /// a − b.
    pub fn subtract(&mut self, a: Node, b: Node) -> Node {
        match (self.fixed(a), self.fixed(b)) {
            (Some(x), Some(y)) => self.number(x - y),
            _ if b == Self::ZERO => a,
            _ => self.join(Operation::Difference(a, b), a, b),
        }
    }

    /// −a.
    pub fn negate(&mut self, a: Node) -> Node {
        self.subtract(Self::ZERO, a)
    }

    /// a · b.
    pub fn multiply(&mut self, a: Node, b: Node) -> Node {
        match (self.fixed(a), self.fixed(b)) {
            (Some(x), Some(y)) => self.number(x * y),
            _ if a == Self::ZERO || b == Self::ZERO => Self::ZERO,
            _ if a == Self::ONE => b,
            _ if b == Self::ONE => a,
            _ => self.join(Operation::Product(a, b), a, b),
        }
    }

    /// a / b.
    pub fn divide(&mut self, a: Node, b: Node) -> Node {
        match (self.fixed(a), self.fixed(b)) {
            (Some(x), Some(y)) => self.number(x / y),
            _ if a == Self::ZERO || b == Self::ONE => a,
            _ => self.join(Operation::Quotient(a, b), a, b),
        }
    }

    /// √a.
    pub fn root(&mut self, a: Node) -> Node {
        match self.fixed(a) {
            Some(x) => self.number(x.sqrt()),
            None => {
                let level = self.level(a);
                self.push(Operation::Root(a), level)
            }
        }
    }

    /// eᵃ.
    pub fn exponential(&mut self, a: Node) -> Node {
        match self.fixed(a) {
            Some(x) => self.number(x.exp()),
            None => self.push(Operation::Exponential(a), self.level(a)),
        }
    }

    /// log a.
    pub fn logarithm(&mut self, a: Node) -> Node {
        match self.fixed(a) {
            Some(x) => self.number(x.ln()),
            None => self.push(Operation::Logarithm(a), self.level(a)),
        }
    }

    /// atan a.
    pub fn arctangent(&mut self, a: Node) -> Node {
        if let Some(x) = self.fixed(a) {
            return self.number(x.atan());
        }
        let square = self.multiply(a, a);
        let below = self.add(Self::ONE, square);
        self.push(Operation::Arctangent(a, below), self.level(a))
    }

    /// sin a, cos a.
    pub fn sin_cos(&mut self, a: Node) -> [Node; 2] {
        if let Some(x) = self.fixed(a) {
            let (sin, cos) = x.sin_cos();
            return [self.number(sin), self.number(cos)];
        }
        if let Some(&sine) = self.memo.waves.get(&a) {
            return [sine, Node(sine.0 + 1)];
        }
        let level = self.level(a);
        let sine = self.push(Operation::Sine(a), level);
        self.memo.waves.insert(a, sine);
        [sine, self.push(Operation::Cosine(a), level)]
    }

    /// a · b of vectors.
    pub fn dot(&mut self, a: [Node; 2], b: [Node; 2]) -> Node {
        let [first, second] = [0, 1].map(|axis| self.multiply(a[axis], b[axis]));
        self.add(first, second)
    }
}

/// A whole number.
pub fn whole<S: Real>(n: i64) -> S {
    S::ratio(n, 1)
}
