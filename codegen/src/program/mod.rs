//! The program of a model: hash-consed straight-line arithmetic over parameters, coordinates and
//! rates.
//!
//! Every function of a model is a list of outputs in one shared [`Program`]; the interpreter, the
//! operation count and the emitted Rust are folds over it.

mod arithmetic;
mod cost;
mod group;
mod interpret;
mod lower;
mod perfect;
mod polynomial;
mod solve;
mod wave;
mod waves;

use std::collections::{BTreeMap, BTreeSet};

use rustc_hash::FxHashMap;

use crate::algebra::{Rational, Symbol};
use crate::elementary::Elementary;

pub use cost::Cost;
pub use lower::Lowering;
pub(crate) use polynomial::Polynomial;
pub use solve::{Factored, solve_symmetric};
pub use wave::{Part, WaveStep};

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
    /// eᵃ, log a, tanh a, atan a.
    Elementary(Elementary, Id),
}

impl Operation {
    /// The values it uses.
    pub fn operands(self) -> impl Iterator<Item = Id> {
        let operands = match self {
            Self::Ratio(_) | Self::Pi | Self::Input(_) => [None; 3],
            Self::Neg(a) | Self::Sqrt(a) | Self::Sin(a) | Self::Cos(a) | Self::Elementary(_, a) => {
                [Some(a), None, None]
            }
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
    waves: BTreeMap<Id, WaveStep>,
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

    /// Whether `id` depends on parameters and senses of sliding only.
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

    /// The angle whose sine, cosine or versed sine `id` is, where that is known of a value made by
    /// addition theorems.
    pub fn wave(&self, id: Id) -> Option<&WaveStep> {
        self.waves.get(&id)
    }

    /// The operations that `outputs` need, ascending.
    pub fn reachable(&self, outputs: &[Id]) -> Vec<Id> {
        self.reachable_beyond(outputs, |_| false)
    }

    /// The same without what only those of `stored` need, whose values are at hand.
    pub fn reachable_beyond(&self, outputs: &[Id], stored: impl Fn(Id) -> bool) -> Vec<Id> {
        // Operands come before what they are operands of.
        let last = outputs.iter().map(|id| id.index() + 1).max();
        let mut needed = vec![false; last.unwrap_or(0)];
        for id in outputs {
            needed[id.index()] = true;
        }
        for index in (0..needed.len()).rev() {
            if needed[index] && !stored(Id(index as u32)) {
                for operand in self.operations[index].operands() {
                    needed[operand.index()] = true;
                }
            }
        }
        (0..needed.len()).filter(|&i| needed[i]).map(|i| Id(i as u32)).collect()
    }

    /// What of the constant part `outputs` use: operands of what varies, and outputs that do not.
    pub fn used_constants(&self, outputs: &[Id]) -> BTreeSet<Id> {
        let varying = self.reachable(outputs).into_iter().filter(|&id| !self.is_constant(id));
        let operands = varying.flat_map(|id| self.operation(id).operands());
        operands.chain(outputs.iter().copied()).filter(|&id| self.is_constant(id)).collect()
    }

    fn push(&mut self, operation: Operation) -> Id {
        if let Some(&id) = self.known.get(&operation) {
            return id;
        }
        let id = Id(self.operations.len() as u32);
        let constant = match operation {
            Operation::Input(symbol) => matches!(symbol, Symbol::Parameter(_) | Symbol::Sense(_)),
            other => other.operands().all(|a| self.is_constant(a)),
        };
        self.operations.push(operation);
        self.constant.push(constant);
        self.known.insert(operation, id);
        id
    }
}
