//! Operations on Taylor coefficients as Rust: linear ones are plain arithmetic, the others are
//! calls that take a column of the tape.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Literal, TokenStream};

use super::super::body::{self, Inputs, VariableNames};
use super::super::functions::State;
use super::super::variable;
use crate::algebra::Symbol;
use crate::functions::SeriesScope;
use crate::program::{Id, Operation};

/// An expression nested deeper than this is split.
const DEPTH: usize = 6;

/// The statements and results of one order.
pub(super) struct Written {
    pub statements: TokenStream,
    pub results: Vec<TokenStream>,
    /// The inputs that are read.
    pub inputs: BTreeSet<Symbol>,
    /// How many columns the tape needs.
    pub columns: usize,
}

pub(super) struct SeriesWriter<'a> {
    pub(super) scope: &'a SeriesScope<'a>,
    pub(super) state: &'a State<'a>,
    pub(super) uses: BTreeMap<Id, usize>,
    pub(super) written: BTreeMap<Id, (TokenStream, usize)>,
    /// How late in an order each coefficient is known.
    pub(super) lateness: BTreeMap<Id, usize>,
    pub(super) waves: BTreeMap<Vec<(Id, i16)>, [TokenStream; 2]>,
    pub(super) names: VariableNames,
    pub(super) statements: TokenStream,
    pub(super) inputs: BTreeSet<Symbol>,
    pub(super) columns: usize,
}

/// Writes one order of `outputs`.
pub(super) fn write(scope: &SeriesScope, state: &State, outputs: &[Id]) -> Written {
    let (needed, uses) = scope.needed(outputs);
    let read = needed.iter().filter_map(|&id| scope.input(id)).collect::<BTreeSet<Symbol>>();
    let names = read.iter().map(|&symbol| state.input(symbol).to_string());
    let names = VariableNames::besides(names.chain(["order", "k", "state"].map(str::to_owned)));
    let mut writer = SeriesWriter {
        scope,
        state,
        uses,
        written: BTreeMap::new(),
        lateness: BTreeMap::new(),
        waves: BTreeMap::new(),
        names,
        statements: TokenStream::new(),
        inputs: read,
        columns: 0,
    };
    needed.iter().for_each(|&id| writer.write(id));
    let results = outputs.iter().map(|&id| writer.term(id)).collect();
    let SeriesWriter { statements, inputs, columns, .. } = writer;
    Written { statements, results, inputs, columns }
}

impl SeriesWriter<'_> {
    fn write(&mut self, id: Id) {
        let program = self.scope.program;
        let lateness = self.scope.lateness(id, &self.lateness);
        self.lateness.insert(id, lateness);
        if program.is_constant(id) {
            return;
        }
        if let Some(wave) = program.wave(id) {
            return self.wave(id, wave.part, &wave.angle, wave.sin_cos);
        }
        if let Some(other) = self.scope.stands_for(id) {
            let term = self.term(other);
            if self.depth(other) > 0 || program.is_constant(other) {
                return self.bind(id, term);
            }
            self.written.insert(id, (term, 0));
            return;
        }
        match program.operation(id) {
            Operation::Input(symbol) => {
                self.written.insert(id, (self.state.input(symbol), 0));
            }
            Operation::Sin(angle) | Operation::Cos(angle) => self.sin_cos(angle),
            _ if self.scope.magnitude(id).is_some() => self.magnitude(id),
            operation => {
                match self.call(self.scope.quotient(id).map_or(operation, |(a, b)| Operation::Div(a, b))) {
                    Some((call, rest)) => self.bind_call(id, call, rest),
                    None => self.linear(id, operation),
                }
            }
        }
    }

    /// The coefficient of a value: zero above order 0 where it does not vary.
    pub(super) fn term(&self, id: Id) -> TokenStream {
        if !self.scope.program.is_constant(id) {
            return self.written[&id].0.clone();
        }
        let value = self.value(id);
        if self.scope.program.is_zero(id) { value } else { quote!(order.constant(#value)) }
    }

    /// What does not vary, as a factor.
    fn value(&self, id: Id) -> TokenStream {
        if let Some(stored) = self.state.constant(id) {
            return stored;
        }
        let written = body::write(self.scope.program, &[id], self.state, &quote!(S));
        let (statements, results) = (written.statements, written.results);
        if statements.is_empty() { quote!(#(#results)*) } else { quote!({ #statements #(#results)* }) }
    }

    pub(super) fn depth(&self, id: Id) -> usize {
        self.written.get(&id).map_or(0, |(_, depth)| *depth)
    }

    /// The call of an operation that is not linear, and what is added to it.
    fn call(&mut self, operation: Operation) -> Option<(TokenStream, Option<Id>)> {
        let varies = |id: Id| !self.scope.program.is_constant(id);
        let column = Literal::usize_unsuffixed(self.columns);
        let (call, rest) = match operation {
            Operation::Mul(a, b) if varies(a) && varies(b) => (self.product(a, b), None),
            Operation::MulAdd(a, b, c) if varies(a) && varies(b) => (self.product(a, b), Some(c)),
            Operation::Div(a, b) if varies(b) => {
                let (kind, over) = if varies(a) {
                    (quote!(quotient), self.term(a))
                } else {
                    (quote!(inverse), self.value(a))
                };
                let under = self.term(b);
                (quote!(order.#kind(#column, #over, #under)), None)
            }
            Operation::Sqrt(a) => {
                let a = self.term(a);
                (quote!(order.sqrt(#column, #a)), None)
            }
            Operation::Elementary(function, a) => {
                let (a, method) = (self.term(a), variable(function.method()));
                self.columns += function.columns() - 1;
                let data = body::table(function);
                let data = (!data.is_empty()).then(|| quote!(, #data));
                (quote!(order.#method(#column, #a #data)), None)
            }
            _ => return None,
        };
        self.columns += 1;
        Some((call, rest))
    }

    /// √(a a) is |a|, of which no digits cancel as a becomes zero.
    fn magnitude(&mut self, id: Id) {
        let Some(a) = self.scope.magnitude(id) else { return };
        let (column, a) = (Literal::usize_unsuffixed(self.columns), self.term(a));
        self.columns += 1;
        self.bind(id, quote!(order.magnitude(#column, #a)));
    }

    /// The operand that is known later stands first: it is the last to be multiplied.
    fn product(&self, a: Id, b: Id) -> TokenStream {
        let column = Literal::usize_unsuffixed(self.columns);
        let late = |id: Id| self.lateness.get(&id);
        let (later, earlier) = if late(a) > late(b) { (a, b) } else { (b, a) };
        let (later, earlier) = (self.term(later), self.term(earlier));
        if a == b {
            quote!(order.square(#column, #later))
        } else {
            quote!(order.product(#column, #later, #earlier))
        }
    }

    fn bind_call(&mut self, id: Id, call: TokenStream, rest: Option<Id>) {
        let sum = match rest {
            None => call,
            Some(c) if self.scope.program.is_constant(c) => {
                let product = self.names.fresh("x");
                self.statements.extend(quote!(let #product = #call;));
                let value = self.value(c);
                quote!(order.offset(#product, #value))
            }
            Some(c) => {
                let c = self.term(c);
                quote!(#call + #c)
            }
        };
        self.bind(id, sum);
    }

    pub(super) fn bind(&mut self, id: Id, expression: TokenStream) {
        let input = match self.scope.program.operation(id) {
            Operation::Input(symbol) => Some(self.state.input(symbol).to_string()),
            _ => None,
        };
        let name = self.names.fresh(input.as_deref().or(self.scope.program.name(id)).unwrap_or("x"));
        self.statements.extend(quote!(let #name = #expression;));
        self.written.insert(id, (quote!(#name), 0));
    }

    fn linear(&mut self, id: Id, operation: Operation) {
        let depth = self.scope.operands(id).into_iter().map(|a| self.depth(a)).max().unwrap_or(0) + 1;
        let expression = self.sum(operation);
        if self.uses[&id] > 1 || depth > DEPTH || self.scope.program.name(id).is_some() {
            self.bind(id, expression);
        } else {
            self.written.insert(id, (expression, depth));
        }
    }

    /// A linear operation; what is added without varying is felt at order 0 only.
    fn sum(&self, operation: Operation) -> TokenStream {
        let constant = |id: Id| self.scope.program.is_constant(id);
        let offset = |sum: TokenStream, id: Id| {
            let value = self.value(id);
            quote!(order.offset(#sum, #value))
        };
        match operation {
            Operation::Add(a, b) if constant(a) => offset(self.term(b), a),
            Operation::Add(a, b) if constant(b) => offset(self.term(a), b),
            Operation::Add(a, b) => infix(self.operand(a), quote!(+), self.operand(b)),
            Operation::Sub(a, b) if constant(a) => {
                let b = self.operand(b);
                offset(quote!(-#b), a)
            }
            Operation::Sub(a, b) if constant(b) => {
                let (a, value) = (self.term(a), self.value(b));
                quote!(order.offset(#a, -#value))
            }
            Operation::Sub(a, b) => infix(self.operand(a), quote!(-), self.operand(b)),
            Operation::Mul(a, b) => {
                let (factor, x) = if constant(a) { (a, b) } else { (b, a) };
                infix(self.operand(x), quote!(*), self.value(factor))
            }
            Operation::Div(a, b) => infix(self.operand(a), quote!(/), self.value(b)),
            Operation::MulAdd(a, b, c) => {
                let (factor, x) = if constant(a) { (a, b) } else { (b, a) };
                let (x, factor) = (self.operand(x), self.value(factor));
                if constant(c) {
                    return offset(quote!(#x * #factor), c);
                }
                let c = self.term(c);
                quote!(#x.mul_add(#factor, #c))
            }
            Operation::Neg(a) => {
                let a = self.operand(a);
                quote!(-#a)
            }
            _ => TokenStream::new(),
        }
    }

    pub(super) fn operand(&self, id: Id) -> TokenStream {
        let term = self.term(id);
        if self.depth(id) == 0 { term } else { quote!((#term)) }
    }
}

fn infix(a: TokenStream, sign: TokenStream, b: TokenStream) -> TokenStream {
    quote!(#a #sign #b)
}
