//! Operations as Rust: a `let` for what is named or used twice, nested expressions for the rest.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Literal, TokenStream};

use super::variable;
use crate::algebra::{Rational, Symbol};
use crate::elementary::Elementary;
use crate::program::{Id, Operation, Program};

/// An expression nested deeper than this is split.
const DEPTH: usize = 6;

/// Where the inputs of a function come from.
pub(super) trait Inputs {
    /// The expression of a parameter, coordinate or rate.
    fn input(&self, symbol: Symbol) -> TokenStream;
    /// The expression of a value that is computed once with the constants, if `id` is one.
    fn constant(&self, id: Id) -> Option<TokenStream>;
    /// Whether `id` is one.
    fn is_stored(&self, id: Id) -> bool;
    /// Names that are in use around the function.
    fn taken(&self) -> Vec<String> {
        Vec::new()
    }
}

/// A function's statements and results.
pub(super) struct FunctionBody {
    pub statements: TokenStream,
    pub results: Vec<TokenStream>,
    /// The inputs that are read.
    pub inputs: BTreeSet<Symbol>,
}

/// Names of variables, each given once.
#[derive(Default)]
pub(super) struct VariableNames {
    counts: BTreeMap<String, usize>,
    taken: BTreeSet<String>,
}

impl VariableNames {
    /// Names other than these.
    pub fn besides(taken: impl Iterator<Item = String>) -> Self {
        Self { counts: BTreeMap::new(), taken: taken.collect() }
    }

    /// `name`, or with a number after it where that is taken; an `x` always has one.
    pub fn fresh(&mut self, name: &str) -> Ident {
        let count = self.counts.entry(name.to_owned()).or_default();
        loop {
            *count += 1;
            let new = if *count == 1 && name != "x" { name.to_owned() } else { format!("{name}{count}") };
            if self.taken.insert(new.clone()) {
                return variable(&new);
            }
        }
    }

    /// All that are in use.
    pub fn taken(&self) -> impl Iterator<Item = &String> {
        self.taken.iter()
    }
}

struct BodyWriter<'a> {
    program: &'a Program,
    inputs: &'a dyn Inputs,
    scalar: &'a TokenStream,
    uses: BTreeMap<Id, usize>,
    written: BTreeMap<Id, (TokenStream, usize)>,
    names: VariableNames,
    statements: TokenStream,
}

/// Writes the operations that `outputs` need.
pub(super) fn write(
    program: &Program,
    outputs: &[Id],
    inputs: &dyn Inputs,
    scalar: &TokenStream,
) -> FunctionBody {
    let needed = program.reachable_beyond(outputs, |id| inputs.is_stored(id));
    let mut uses = uses(program, &needed, inputs);
    outputs.iter().for_each(|&id| *uses.entry(id).or_default() += 1);
    let read = |id: &Id| match program.operation(*id) {
        Operation::Input(symbol) if !inputs.is_stored(*id) => Some(symbol),
        _ => None,
    };
    let read: BTreeSet<Symbol> = needed.iter().filter_map(read).collect();
    let taken = read.iter().map(|&symbol| inputs.input(symbol).to_string()).chain(inputs.taken());
    let mut writer = BodyWriter {
        names: VariableNames::besides(taken),
        program,
        inputs,
        scalar,
        uses,
        written: BTreeMap::new(),
        statements: TokenStream::new(),
    };
    writer.angles(&needed);
    for &id in &needed {
        writer.write(id);
    }
    let results = outputs.iter().map(|id| writer.written[id].0.clone()).collect();
    FunctionBody { statements: writer.statements, results, inputs: read }
}

/// How often each value is written out; a sine and a cosine of one angle are one call.
fn uses(program: &Program, needed: &[Id], inputs: &dyn Inputs) -> BTreeMap<Id, usize> {
    let mut uses = BTreeMap::new();
    let mut angles = Vec::new();
    for &id in needed.iter().filter(|&&id| !inputs.is_stored(id)) {
        if let Operation::Sin(angle) | Operation::Cos(angle) = program.operation(id) {
            if angles.contains(&angle) {
                continue;
            }
            angles.push(angle);
        }
        program.operation(id).operands().for_each(|a| *uses.entry(a).or_default() += 1);
    }
    uses
}

impl BodyWriter<'_> {
    fn write(&mut self, id: Id) {
        if self.written.contains_key(&id) {
            return;
        }
        if let Some(constant) = self.inputs.constant(id) {
            self.written.insert(id, (constant, 0));
            return;
        }
        let operation = self.program.operation(id);
        if let Operation::Sin(angle) | Operation::Cos(angle) = operation {
            return self.sin_cos(angle);
        }
        let (expression, depth) = self.expression(operation);
        let opaque_term = match operation {
            Operation::Ratio(_) | Operation::Pi | Operation::Input(_) => true,
            Operation::Neg(a) => self.inputs.is_stored(a),
            _ => false,
        };
        let keep = self.uses.get(&id).copied().unwrap_or(0) > 1 || depth > DEPTH;
        let name = self.program.name(id).map(str::to_owned);
        if opaque_term || name.is_none() && !keep {
            self.written.insert(id, (expression, depth));
            return;
        }
        let ident = self.names.fresh(&name.unwrap_or_else(|| "x".to_owned()));
        self.statements.extend(quote!(let #ident = #expression;));
        self.written.insert(id, (quote!(#ident), 0));
    }

    /// Sines and cosines of all angles that need none themselves, several in one call.
    fn angles(&mut self, needed: &[Id]) {
        let (mut later, mut angles) = (BTreeSet::new(), Vec::new());
        for &id in needed.iter().filter(|&&id| !self.inputs.is_stored(id)) {
            let operation = self.program.operation(id);
            let follows = operation.operands().any(|a| later.contains(&a));
            match operation {
                Operation::Sin(angle) | Operation::Cos(angle) => {
                    later.insert(id);
                    if !follows && !angles.contains(&angle) {
                        angles.push(angle);
                    }
                }
                _ if follows => _ = later.insert(id),
                _ => {}
            }
        }
        if angles.len() < 2 {
            return;
        }
        for id in self.program.reachable_beyond(&angles, |id| self.inputs.is_stored(id)) {
            self.write(id);
        }
        let arguments: Vec<TokenStream> =
            angles.iter().map(|&angle| self.written[&angle].0.clone()).collect();
        let (sines, cosines): (Vec<_>, Vec<_>) = angles.into_iter().map(|angle| self.waves(angle)).unzip();
        let scalar = self.scalar;
        self.statements.extend(quote! {
            let ([#(#sines),*], [#(#cosines),*]) = #scalar::sin_cos_each([#(#arguments),*]);
        });
    }

    fn sin_cos(&mut self, angle: Id) {
        let argument = self.operand(angle);
        let (sin, cos) = self.waves(angle);
        self.statements.extend(quote!(let (#sin, #cos) = #argument.sin_cos();));
    }

    /// Names for the sine and the cosine of an angle, `_` for what is not used.
    fn waves(&mut self, angle: Id) -> (TokenStream, TokenStream) {
        let mut name = |operation: Operation, default: &str| {
            let found = self.program.find(operation).filter(|id| self.uses.contains_key(id));
            let Some(id) = found else { return quote!(_) };
            let ident = self.names.fresh(self.program.name(id).unwrap_or(default));
            self.written.insert(id, (quote!(#ident), 0));
            quote!(#ident)
        };
        (name(Operation::Sin(angle), "sin"), name(Operation::Cos(angle), "cos"))
    }

    fn expression(&self, operation: Operation) -> (TokenStream, usize) {
        let depth = operation.operands().map(|a| self.written[&a].1).max().unwrap_or(0) + 1;
        let at = |a: Id| &self.written[&a].0;
        let scalar = self.scalar;
        let expression = match operation {
            Operation::Ratio(value) => return (ratio(value, scalar), 0),
            Operation::Pi => return (quote!(#scalar::pi()), 0),
            Operation::Input(symbol) => return (self.inputs.input(symbol), 0),
            Operation::Add(a, b) => infix(self, a, quote!(+), b),
            Operation::Sub(a, b) => infix(self, a, quote!(-), b),
            Operation::Mul(a, b) => infix(self, a, quote!(*), b),
            Operation::Div(a, b) => infix(self, a, quote!(/), b),
            Operation::Neg(a) => {
                let a = self.operand(a);
                quote!(-#a)
            }
            Operation::MulAdd(a, b, c) => {
                let (a, b, c) = (self.operand(a), at(b), at(c));
                quote!(#a.mul_add(#b, #c))
            }
            Operation::Sqrt(a) => {
                let a = self.operand(a);
                quote!(#a.sqrt())
            }
            Operation::Elementary(function, a) => {
                let (a, method, data) = (self.operand(a), variable(function.method()), table(function));
                quote!(#a.#method(#data))
            }
            Operation::Sin(_) | Operation::Cos(_) => TokenStream::new(),
        };
        (expression, depth)
    }

    fn operand(&self, id: Id) -> TokenStream {
        let (tokens, depth) = &self.written[&id];
        let call = matches!(
            self.program.operation(id),
            Operation::MulAdd(..) | Operation::Sqrt(_) | Operation::Elementary(..)
        );
        if *depth == 0 || call { tokens.clone() } else { quote!((#tokens)) }
    }
}

fn infix(writer: &BodyWriter, a: Id, sign: TokenStream, b: Id) -> TokenStream {
    let (a, b) = (writer.operand(a), writer.operand(b));
    quote!(#a #sign #b)
}

/// What a function takes beside its argument: knots and pieces of a table.
pub(super) fn table(function: Elementary) -> TokenStream {
    let Elementary::Table(table) = function else { return TokenStream::new() };
    let number = |x: &f64| {
        let (sign, x) = ((*x < 0.0).then(|| quote!(-)), Literal::f64_unsuffixed(x.abs()));
        quote!(#sign #x)
    };
    let knots = table.knots.iter().map(number);
    let pieces = table.pieces.iter().map(|piece| {
        let piece = piece.iter().map(number);
        quote!([#(#piece),*])
    });
    quote!(&[#(#knots),*], &[#(#pieces),*])
}

/// An exact number.
pub(super) fn ratio(value: Rational, scalar: &TokenStream) -> TokenStream {
    let sign = (value.signum() < 0).then(|| quote!(-));
    let p = Literal::i128_unsuffixed(value.numerator().abs());
    let q = Literal::i128_unsuffixed(value.denominator());
    quote!(#scalar::ratio(#sign #p, #q))
}
