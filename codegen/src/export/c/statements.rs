//! Operations as statements of C99: a variable for what is named or used twice, nested expressions
//! for the rest. Every operation is done as the program has it, in its order.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::{Rational, Symbol};
use crate::elementary::Elementary;
use crate::export::identifiers::Identifiers;
use crate::program::{Id, Operation, Program};
use crate::spline::Spline;

/// An expression of more letters has a variable.
const LONG: usize = 72;
/// Whole numbers up to here have a `double` each.
const EXACT: i128 = 1 << f64::MANTISSA_DIGITS;

/// Where the inputs of a function come from.
pub(super) trait CInputs {
    /// The expression of a parameter, coordinate or rate.
    fn input(&self, symbol: Symbol) -> String;
    /// The expression of a value that is stored with the constants, if `id` is one.
    fn constant(&self, id: Id) -> Option<String>;
}

/// What a function computes.
pub(super) struct Statements {
    /// A line for each variable.
    pub text: String,
    /// The expressions of the outputs.
    pub results: Vec<String>,
    /// The inputs that are read.
    pub reads: BTreeSet<Symbol>,
}

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Sum,
    Product,
    Atom,
}

/// Statements for `outputs`.
pub(super) fn statements(
    program: &Program,
    outputs: &[Id],
    inputs: &dyn CInputs,
    names: Identifiers,
) -> Statements {
    let needed = program.reachable_beyond(outputs, |id| inputs.constant(id).is_some());
    let mut uses: BTreeMap<Id, usize> = BTreeMap::new();
    let operands = needed.iter().filter(|&&id| inputs.constant(id).is_none());
    let operands = operands.flat_map(|&id| program.operation(id).operands());
    operands.chain(outputs.iter().copied()).for_each(|id| *uses.entry(id).or_default() += 1);
    let mut writer =
        CWriter { program, names, uses, written: BTreeMap::new(), unnamed: 0, text: String::new() };
    let mut reads = BTreeSet::new();
    for &id in &needed {
        if let Some(constant) = inputs.constant(id) {
            writer.written.insert(id, (constant, Level::Atom));
        } else if let Operation::Input(symbol) = program.operation(id) {
            reads.insert(symbol);
            writer.written.insert(id, (inputs.input(symbol), Level::Atom));
        } else {
            writer.write(id);
        }
    }
    let results = outputs.iter().map(|id| writer.written[id].0.clone()).collect();
    Statements { text: writer.text, results, reads }
}

struct CWriter<'a> {
    program: &'a Program,
    names: Identifiers,
    uses: BTreeMap<Id, usize>,
    written: BTreeMap<Id, (String, Level)>,
    /// How many variables there are for what has no name.
    unnamed: usize,
    text: String,
}

impl CWriter<'_> {
    fn write(&mut self, id: Id) {
        let operation = self.program.operation(id);
        let (expression, level) = self.expression(operation);
        let name = self.program.name(id);
        let number = matches!(operation, Operation::Ratio(_) | Operation::Pi);
        let keep = name.is_some() || self.uses.get(&id).is_some_and(|&n| n > 1) || expression.len() > LONG;
        if number || !keep {
            self.written.insert(id, (expression, level));
            return;
        }
        let name = match (name, operation) {
            (Some(name), _) => self.names.make_unique(name),
            (None, Operation::Sin(_)) => self.names.make_unique("sine"),
            (None, Operation::Cos(_)) => self.names.make_unique("cosine"),
            (None, _) => {
                self.unnamed += 1;
                self.names.make_unique(&format!("x{}", self.unnamed))
            }
        };
        self.text += &format!("    const double {name} = {expression};\n");
        self.written.insert(id, (name, Level::Atom));
    }

    fn expression(&self, operation: Operation) -> (String, Level) {
        // Equal operators are read from the left, so only what stands on the right is bracketed
        // where it is on their level.
        let (left, right) = (|id, level| self.operand(id, level), |id, above| self.operand(id, above));
        match operation {
            Operation::Add(a, b) => {
                (format!("{} + {}", left(a, Level::Sum), right(b, Level::Product)), Level::Sum)
            }
            Operation::Sub(a, b) => {
                (format!("{} - {}", left(a, Level::Sum), right(b, Level::Product)), Level::Sum)
            }
            Operation::Mul(a, b) => {
                (format!("{}*{}", left(a, Level::Product), right(b, Level::Atom)), Level::Product)
            }
            Operation::Div(a, b) => {
                (format!("{}/{}", left(a, Level::Product), right(b, Level::Atom)), Level::Product)
            }
            Operation::Neg(a) => (format!("-{}", left(a, Level::Product)), Level::Sum),
            Operation::MulAdd(a, b, c) => {
                let product = format!("{}*{}", left(a, Level::Product), right(b, Level::Atom));
                (format!("{product} + {}", right(c, Level::Product)), Level::Sum)
            }
            Operation::Sqrt(a) => (format!("sqrt({})", self.written[&a].0), Level::Atom),
            Operation::Sin(a) => (format!("sin({})", self.written[&a].0), Level::Atom),
            Operation::Cos(a) => (format!("cos({})", self.written[&a].0), Level::Atom),
            Operation::Elementary(Elementary::Table(table), a) => {
                (pieces(&table, &self.written[&a].0), Level::Atom)
            }
            Operation::Elementary(function, a) => {
                (format!("{}({})", function.name(), self.written[&a].0), Level::Atom)
            }
            Operation::Ratio(value) => ratio(value),
            Operation::Pi => (format!("{:?}", core::f64::consts::PI), Level::Atom),
            Operation::Input(_) => unreachable!("inputs are written before"),
        }
    }

    /// The expression of a value, in brackets where it is looser than this.
    fn operand(&self, id: Id, least: Level) -> String {
        let (text, level) = &self.written[&id];
        if *level < least { format!("({text})") } else { text.clone() }
    }
}

/// The value of a table, piece by piece.
fn pieces(table: &Spline, x: &str) -> String {
    let piece = |(end, text): (Option<f64>, String)| match end {
        Some(end) => format!("({x}) < {end:?} ? {text} : "),
        None => text,
    };
    format!("({})", table.write_pieces(x).into_iter().map(piece).collect::<String>())
}

/// An exact number: a quotient of whole numbers where both are `double`s, which is rounded once as
/// its decimal would be.
fn ratio(value: Rational) -> (String, Level) {
    let (p, q) = (value.numerator(), value.denominator());
    let exact = p.abs() <= EXACT && q <= EXACT;
    match exact {
        true if q == 1 && p >= 0 => (format!("{p}.0"), Level::Atom),
        true if q == 1 => (format!("{p}.0"), Level::Sum),
        true if p >= 0 => (format!("{p}.0/{q}.0"), Level::Product),
        true => (format!("{p}.0/{q}.0"), Level::Sum),
        false if p >= 0 => (format!("{:?}", value.to_f64()), Level::Atom),
        false => (format!("{:?}", value.to_f64()), Level::Sum),
    }
}
