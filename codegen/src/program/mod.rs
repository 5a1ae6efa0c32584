//! The program of a model: hash-consed straight-line arithmetic over parameters, coordinates and rates.
//!
//! Every function of a model is a list of outputs in one shared [`Program`]; the interpreter, the operation
//! count and the emitted Rust are folds over it.

mod cost;
mod interpret;
mod lower;
mod polynomial;
mod solve;
mod waves;

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use crate::algebra::{Rational, Symbol};

pub use cost::Cost;
pub use lower::Lowering;
pub(crate) use polynomial::Polynomial;
pub use solve::solve_symmetric;

/// A value of the program.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Id(u32);

impl Id {
    /// Its place in [`Program::operations`].
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// How a value is made.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Operation {
    /// A number.
    Ratio(Rational),
    /// π.
    Pi,
    /// A parameter, a coordinate or a rate.
    Input(Symbol),
    /// a + b.
    Add(Id, Id),
    /// a − b.
    Sub(Id, Id),
    /// a · b.
    Mul(Id, Id),
    /// a / b.
    Div(Id, Id),
    /// −a.
    Neg(Id),
    /// a · b + c.
    MulAdd(Id, Id, Id),
    /// √a.
    Sqrt(Id),
    /// sin a.
    Sin(Id),
    /// cos a.
    Cos(Id),
}

impl Operation {
    /// The values it uses.
    pub fn operands(self) -> impl Iterator<Item = Id> {
        let operands = match self {
            Self::Ratio(_) | Self::Pi | Self::Input(_) => [None; 3],
            Self::Neg(a) | Self::Sqrt(a) | Self::Sin(a) | Self::Cos(a) => [Some(a), None, None],
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => [Some(a), Some(b), None],
            Self::MulAdd(a, b, c) => [Some(a), Some(b), Some(c)],
        };
        operands.into_iter().flatten()
    }
}

/// Operations in the order of their dependence, each once.
#[derive(Clone, Default, Debug)]
pub struct Program {
    operations: Vec<Operation>,
    known: FxHashMap<Operation, Id>,
    constant: Vec<bool>,
    names: BTreeMap<Id, String>,
    coordinates: Vec<String>,
}

impl Program {
    /// An empty program whose values may be named after these coordinates.
    pub fn new(coordinates: Vec<String>) -> Self {
        Self { coordinates, ..Self::default() }
    }

    /// The name of a coordinate.
    fn coordinate(&self, symbol: Symbol) -> Option<&str> {
        match symbol {
            Symbol::Coordinate { index, .. } => self.coordinates.get(usize::from(index)).map(String::as_str),
            _ => None,
        }
    }

    /// All operations; those of a value come before it.
    pub fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// The value made by `operation`, if the program has it.
    pub fn find(&self, operation: Operation) -> Option<Id> {
        self.known.get(&operation).copied()
    }

    /// How `id` is made.
    pub fn operation(&self, id: Id) -> Operation {
        self.operations[id.index()]
    }

    /// Whether `id` depends on parameters only.
    pub fn is_constant(&self, id: Id) -> bool {
        self.constant[id.index()]
    }

    /// The name given to `id`, if any.
    pub fn name(&self, id: Id) -> Option<&str> {
        self.names.get(&id).map(String::as_str)
    }

    /// Names a computed value; the first name stays, inputs and numbers keep theirs.
    pub fn set_name(&mut self, id: Id, name: impl FnOnce() -> String) {
        let plain = matches!(self.operation(id), Operation::Ratio(_) | Operation::Input(_));
        if !plain && !self.is_constant(id) {
            self.names.entry(id).or_insert_with(name);
        }
    }

    /// The operations that `outputs` need, ascending.
    pub fn reachable(&self, outputs: &[Id]) -> Vec<Id> {
        let mut needed = vec![false; self.operations.len()];
        for id in outputs {
            needed[id.index()] = true;
        }
        for index in (0..needed.len()).rev() {
            if needed[index] {
                for operand in self.operations[index].operands() {
                    needed[operand.index()] = true;
                }
            }
        }
        (0..needed.len()).filter(|&i| needed[i]).map(|i| Id(i as u32)).collect()
    }

    fn push(&mut self, operation: Operation) -> Id {
        if let Some(&id) = self.known.get(&operation) {
            return id;
        }
        let id = Id(self.operations.len() as u32);
        let constant = match operation {
            Operation::Input(symbol) => matches!(symbol, Symbol::Parameter(_)),
            other => other.operands().all(|a| self.is_constant(a)),
        };
        self.operations.push(operation);
        self.constant.push(constant);
        self.known.insert(operation, id);
        id
    }

    /// A number.
    pub fn ratio(&mut self, value: Rational) -> Id {
        self.push(Operation::Ratio(value))
    }

    /// An integer.
    pub fn integer(&mut self, value: i128) -> Id {
        self.ratio(Rational::integer(value))
    }

    /// π.
    pub fn pi(&mut self) -> Id {
        self.push(Operation::Pi)
    }

    /// A parameter, coordinate or rate.
    pub fn input(&mut self, symbol: Symbol) -> Id {
        self.push(Operation::Input(symbol))
    }

    fn number(&self, id: Id) -> Option<Rational> {
        match self.operation(id) {
            Operation::Ratio(value) => Some(value),
            _ => None,
        }
    }

    /// Whether `id` is the number zero.
    pub fn is_zero(&self, id: Id) -> bool {
        self.number(id).is_some_and(Rational::is_zero)
    }

    fn is_one(&self, id: Id) -> bool {
        self.number(id) == Some(Rational::ONE)
    }

    /// a + b.
    pub fn add(&mut self, a: Id, b: Id) -> Id {
        match (self.number(a), self.number(b)) {
            (Some(a), Some(b)) => return self.ratio(a + b),
            (Some(zero), _) if zero.is_zero() => return b,
            (_, Some(zero)) if zero.is_zero() => return a,
            _ => {}
        }
        match (self.operation(a), self.operation(b)) {
            (_, Operation::Neg(b)) => self.sub(a, b),
            (Operation::Neg(a), _) => self.sub(b, a),
            _ => self.push(Operation::Add(a.min(b), a.max(b))),
        }
    }

    /// a − b.
    pub fn sub(&mut self, a: Id, b: Id) -> Id {
        match (self.number(a), self.number(b)) {
            (Some(a), Some(b)) => return self.ratio(a - b),
            (Some(zero), _) if zero.is_zero() => return self.neg(b),
            (_, Some(zero)) if zero.is_zero() => return a,
            _ => {}
        }
        match self.operation(b) {
            _ if a == b => self.integer(0),
            Operation::Neg(b) => self.add(a, b),
            _ => self.push(Operation::Sub(a, b)),
        }
    }

    /// a · b.
    pub fn mul(&mut self, a: Id, b: Id) -> Id {
        match (self.number(a), self.number(b)) {
            (Some(a), Some(b)) => return self.ratio(a * b),
            (Some(k), _) => return self.scale(k, b),
            (_, Some(k)) => return self.scale(k, a),
            _ => {}
        }
        match (self.operation(a), self.operation(b)) {
            (Operation::Neg(a), Operation::Neg(b)) => self.mul(a, b),
            (Operation::Neg(a), _) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            (_, Operation::Neg(b)) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            _ => self.push(Operation::Mul(a.min(b), a.max(b))),
        }
    }

    fn scale(&mut self, k: Rational, a: Id) -> Id {
        if k.is_zero() {
            return self.integer(0);
        } else if k == Rational::ONE {
            return a;
        } else if k == -Rational::ONE {
            return self.neg(a);
        }
        match self.operation(a) {
            Operation::Neg(a) => self.scale(-k, a),
            _ => {
                let k = self.ratio(k);
                self.push(Operation::Mul(k.min(a), k.max(a)))
            }
        }
    }

    /// aᵏ by repeated squaring.
    pub fn power(&mut self, a: Id, k: u32) -> Id {
        match k {
            0 => self.integer(1),
            1 => a,
            _ => {
                let half = self.power(a, k / 2);
                let square = self.mul(half, half);
                if k.is_multiple_of(2) { square } else { self.mul(square, a) }
            }
        }
    }

    /// a / b.
    pub fn div(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) || self.is_one(b) {
            return a;
        }
        match (self.operation(a), self.operation(b)) {
            (Operation::Neg(a), Operation::Neg(b)) => self.div(a, b),
            (Operation::Neg(a), _) => {
                let quotient = self.div(a, b);
                self.neg(quotient)
            }
            (_, Operation::Neg(b)) => {
                let quotient = self.div(a, b);
                self.neg(quotient)
            }
            _ => self.push(Operation::Div(a, b)),
        }
    }

    /// −a.
    pub fn neg(&mut self, a: Id) -> Id {
        match self.operation(a) {
            Operation::Ratio(value) => self.ratio(-value),
            Operation::Neg(a) => a,
            Operation::Sub(a, b) => self.sub(b, a),
            _ => self.push(Operation::Neg(a)),
        }
    }

    /// a · b + c, as one operation where neither factor is ±1 and both matter.
    pub fn mul_add(&mut self, a: Id, b: Id, c: Id) -> Id {
        let unit = |id: Id| self.number(id).is_some_and(|k| k.abs() == Rational::ONE || k.is_zero());
        let constant = self.is_constant(a) && self.is_constant(b);
        if unit(a) || unit(b) || self.is_zero(c) || constant {
            let product = self.mul(a, b);
            return self.add(product, c);
        }
        self.push(Operation::MulAdd(a.min(b), a.max(b), c))
    }

    /// √a.
    pub fn sqrt(&mut self, a: Id) -> Id {
        self.push(Operation::Sqrt(a))
    }

    /// (sin a, cos a).
    pub fn sin_cos(&mut self, a: Id) -> (Id, Id) {
        (self.push(Operation::Sin(a)), self.push(Operation::Cos(a)))
    }

    /// Σ aᵢ bᵢ, as a chain of [`Operation::MulAdd`].
    pub fn dot(&mut self, products: impl IntoIterator<Item = (Id, Id)>) -> Id {
        let zero = self.integer(0);
        products.into_iter().fold(zero, |sum, (a, b)| self.mul_add(a, b, sum))
    }
}
