//! Operations on Taylor coefficients as Rust: linear ones are plain arithmetic, the others are calls that take a column
//! of the tape.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::super::body::{self, Inputs, Names, ratio};
use super::super::functions::State;
use crate::algebra::{Rational, Symbol};
use crate::functions::PhaseFunctions;
use crate::program::{Id, Operation, Part, Program};

/// An expression nested deeper than this is split.
const DEPTH: usize = 6;

/// What the series of a phase are written in terms of.
pub(super) struct Scope<'a> {
    pub state: &'a State<'a>,
    pub phase: &'a PhaseFunctions,
    pub program: &'a Program,
}

/// The statements and results of one order.
pub(super) struct Written {
    pub statements: TokenStream,
    pub results: Vec<TokenStream>,
    /// The inputs that are read.
    pub inputs: BTreeSet<Symbol>,
    /// How many columns the tape needs.
    pub columns: usize,
}

struct Writer<'a> {
    scope: &'a Scope<'a>,
    uses: BTreeMap<Id, usize>,
    written: BTreeMap<Id, (TokenStream, usize)>,
    /// How late in an order each coefficient is known.
    lateness: BTreeMap<Id, usize>,
    waves: BTreeMap<Vec<(Id, i16)>, [TokenStream; 2]>,
    names: Names,
    statements: TokenStream,
    inputs: BTreeSet<Symbol>,
    columns: usize,
}

/// Writes one order of `outputs`.
pub(super) fn write(scope: &Scope, outputs: &[Id]) -> Written {
    let (needed, uses) = scope.needed(outputs);
    let read = needed.iter().filter_map(|&id| scope.input(id)).collect::<BTreeSet<Symbol>>();
    let names = read.iter().map(|&symbol| scope.state.input(symbol).to_string());
    let names = Names::besides(names.chain(["order", "k", "state"].map(str::to_owned)));
    let mut writer = Writer {
        scope,
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
    let Writer { statements, inputs, columns, .. } = writer;
    Written { statements, results, inputs, columns }
}

impl Scope<'_> {
    /// The symbol that `id` reads from the state.
    fn input(&self, id: Id) -> Option<Symbol> {
        match self.program.operation(id) {
            Operation::Input(symbol) if !self.program.is_constant(id) && self.stands_for(id).is_none() => {
                Some(symbol)
            }
            _ => None,
        }
    }

    /// What a coordinate or rate that the reduced state lacks, or an acceleration, is made of.
    fn stands_for(&self, id: Id) -> Option<Id> {
        let Operation::Input(Symbol::Coordinate { index, order }) = self.program.operation(id) else {
            return None;
        };
        let (index, n) = (usize::from(index), self.phase.embedding.len() / 2);
        let place = |list: &[usize]| list.iter().position(|&i| i == index);
        match order {
            0 if place(&self.phase.kept).is_none() => Some(self.phase.embedding[index]),
            1 if place(&self.phase.moving).is_none() => Some(self.phase.embedding[n + index]),
            2 => place(&self.phase.moving).map(|k| self.phase.accelerations[k]),
            _ => None,
        }
    }

    fn operands(&self, id: Id) -> Vec<Id> {
        if self.program.is_constant(id) {
            Vec::new()
        } else if let Some(wave) = self.program.wave(id) {
            wave.angle.iter().map(|&(value, _)| value).collect()
        } else if let Some(other) = self.stands_for(id) {
            vec![other]
        } else {
            let operands = match self.quotient(id) {
                Some((a, b)) => vec![a, b],
                None => self.program.operation(id).operands().collect(),
            };
            operands.into_iter().filter(|&a| !self.program.is_constant(a)).collect()
        }
    }

    /// a and b of a product a · (1 / b), which is one convolution as a quotient and two as it stands.
    fn quotient(&self, id: Id) -> Option<(Id, Id)> {
        let Operation::Mul(a, b) = self.program.operation(id) else { return None };
        let varies = |id: Id| !self.program.is_constant(id);
        let below = |id: Id| match self.program.operation(id) {
            Operation::Div(one, b) if self.program.is_one(one) && varies(b) => Some(b),
            _ => None,
        };
        if !(varies(a) && varies(b)) || a == b {
            return None;
        }
        below(b).map(|d| (a, d)).or_else(|| below(a).map(|d| (b, d)))
    }

    /// The rates are what an order waits for: of the coordinates it has the coefficient since the order before last.
    fn lateness(&self, id: Id, known: &BTreeMap<Id, usize>) -> usize {
        match self.input(id) {
            Some(Symbol::Coordinate { order: 1, .. }) => self.program.operations().len(),
            _ => self.operands(id).iter().filter_map(|a| known.get(a)).max().map_or(0, |last| last + 1),
        }
    }

    /// What varies of all that `outputs` need, operands first, and how often each is used.
    fn needed(&self, outputs: &[Id]) -> (Vec<Id>, BTreeMap<Id, usize>) {
        let mut uses: BTreeMap<Id, usize> = BTreeMap::new();
        let mut needed = Vec::new();
        let mut stack: Vec<(Id, bool)> = outputs.iter().rev().map(|&id| (id, false)).collect();
        while let Some((id, done)) = stack.pop() {
            if done {
                needed.push(id);
                continue;
            }
            let count = uses.entry(id).or_default();
            *count += 1;
            if *count == 1 {
                stack.push((id, true));
                stack.extend(self.operands(id).into_iter().rev().map(|a| (a, false)));
            }
        }
        (needed, uses)
    }
}

impl Writer<'_> {
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
                self.written.insert(id, (self.scope.state.input(symbol), 0));
            }
            Operation::Sin(angle) | Operation::Cos(angle) => self.sin_cos(angle),
            operation => {
                match self.call(self.scope.quotient(id).map_or(operation, |(a, b)| Operation::Div(a, b))) {
                    Some((call, rest)) => self.bind_call(id, call, rest),
                    None => self.linear(id, operation),
                }
            }
        }
    }

    /// The coefficient of a value: zero above order 0 where it does not vary.
    fn term(&self, id: Id) -> TokenStream {
        if !self.scope.program.is_constant(id) {
            return self.written[&id].0.clone();
        }
        let value = self.value(id);
        if self.scope.program.is_zero(id) { value } else { quote!(order.constant(#value)) }
    }

    /// What does not vary, as a factor.
    fn value(&self, id: Id) -> TokenStream {
        if let Some(stored) = self.scope.state.constant(id) {
            return stored;
        }
        let written = body::write(self.scope.program, &[id], self.scope.state, &quote!(S));
        let (statements, results) = (written.statements, written.results);
        if statements.is_empty() { quote!(#(#results)*) } else { quote!({ #statements #(#results)* }) }
    }

    fn depth(&self, id: Id) -> usize {
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
            _ => return None,
        };
        self.columns += 1;
        Some((call, rest))
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

    fn bind(&mut self, id: Id, expression: TokenStream) {
        let input = match self.scope.program.operation(id) {
            Operation::Input(symbol) => Some(self.scope.state.input(symbol).to_string()),
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

    fn operand(&self, id: Id) -> TokenStream {
        let term = self.term(id);
        if self.depth(id) == 0 { term } else { quote!((#term)) }
    }

    /// The sine and the cosine of a value.
    fn sin_cos(&mut self, angle: Id) {
        let program = self.scope.program;
        let find = |operation: Operation| program.find(operation).filter(|id| self.uses.contains_key(id));
        let found = [find(Operation::Sin(angle)), find(Operation::Cos(angle))];
        if found.iter().flatten().any(|id| self.written.contains_key(id)) {
            return;
        }
        let known = self.waves.get(&[(angle, 1)][..]).cloned();
        let pair = known.unwrap_or_else(|| {
            let (operand, term) = (self.operand(angle), self.term(angle));
            self.pair(found, &[(angle, 1)], term, quote!(#operand.sin_cos()))
        });
        for (id, token) in found.into_iter().zip(pair) {
            id.map(|id| self.written.insert(id, (token, 0)));
        }
    }

    /// What is made by addition theorems: its value is, its coefficients are those of a sine and cosine.
    fn wave(&mut self, id: Id, part: Part, angle: &[(Id, i16)], (sin, cos): (Id, Id)) {
        let [sine, cosine] = match self.waves.get(angle) {
            Some(known) => known.clone(),
            None => {
                let values = self.values(&[sin, cos]);
                let term = self.combination(angle);
                self.pair([Some(sin), Some(cos)], angle, term, values)
            }
        };
        match part {
            Part::Sine => self.written.insert(id, (sine, 0)),
            Part::Cosine => self.written.insert(id, (cosine, 0)),
            Part::Versed => {
                let value = self.values(&[id]);
                self.bind(id, quote!(order.versed(|| #value, #cosine)));
                None
            }
        };
    }

    fn pair(
        &mut self,
        ids: [Option<Id>; 2],
        angle: &[(Id, i16)],
        term: TokenStream,
        values: TokenStream,
    ) -> [TokenStream; 2] {
        let column = Literal::usize_unsuffixed(self.columns);
        self.columns += 2;
        let names = [(ids[0], "sin"), (ids[1], "cos")].map(|(id, default)| {
            let name = id.and_then(|id| self.scope.program.name(id)).unwrap_or(default);
            let name = self.names.fresh(name);
            quote!(#name)
        });
        let [sin, cos] = &names;
        self.statements.extend(quote!(let (#sin, #cos) = order.sin_cos(#column, #term, || #values);));
        self.waves.insert(angle.to_vec(), names.clone());
        names
    }

    /// Σ k x.
    fn combination(&self, angle: &[(Id, i16)]) -> TokenStream {
        angle.iter().fold(TokenStream::new(), |sum, &(id, k)| {
            let x = self.operand(id);
            let size = ratio(Rational::integer(k.unsigned_abs().into()), &quote!(S));
            let multiple = if k.abs() == 1 { x } else { quote!(#x * #size) };
            match (sum.is_empty(), k < 0) {
                (true, false) => multiple,
                (true, true) => quote!(-#multiple),
                (false, false) => quote!(#sum + #multiple),
                (false, true) => quote!(#sum - #multiple),
            }
        })
    }

    /// Values at order 0, by the operations of the program.
    fn values(&self, ids: &[Id]) -> TokenStream {
        let written = body::write(self.scope.program, ids, &Known(self), &quote!(S));
        let (statements, results) = (written.statements, written.results);
        let result = if let [result] = &results[..] { quote!(#result) } else { quote!((#(#results),*)) };
        if statements.is_empty() { result } else { quote!({ #statements #result }) }
    }
}

/// What is written so far, at order 0.
struct Known<'a, 'b>(&'a Writer<'b>);

impl Known<'_, '_> {
    fn written(&self, id: Id) -> Option<TokenStream> {
        self.0.written.get(&id).filter(|(_, depth)| *depth == 0).map(|(token, _)| token.clone())
    }
}

impl Inputs for Known<'_, '_> {
    fn input(&self, symbol: Symbol) -> TokenStream {
        self.0.scope.state.input(symbol)
    }

    fn constant(&self, id: Id) -> Option<TokenStream> {
        self.0.scope.state.constant(id).or_else(|| self.written(id))
    }

    fn is_stored(&self, id: Id) -> bool {
        self.0.scope.state.is_stored(id) || self.written(id).is_some()
    }

    fn taken(&self) -> Vec<String> {
        self.0.names.taken().cloned().collect()
    }
}

fn infix(a: TokenStream, sign: TokenStream, b: TokenStream) -> TokenStream {
    quote!(#a #sign #b)
}
