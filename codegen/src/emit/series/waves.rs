//! Sines and cosines: by their recurrence whatever the program makes them of, which is where their
//! values come from.

use proc_macro2::{Literal, TokenStream};

use super::super::body::{self, Inputs, ratio};
use super::writer::SeriesWriter;
use crate::algebra::{Rational, Symbol};
use crate::program::{Id, Operation, Part};

impl SeriesWriter<'_> {
    /// The sine and the cosine of a value.
    pub(super) fn sin_cos(&mut self, angle: Id) {
        let program = self.scope.program;
        let find = |operation: Operation| program.find(operation).filter(|id| self.uses.contains_key(id));
        let found = [find(Operation::Sin(angle)), find(Operation::Cos(angle))];
        if found.iter().flatten().any(|id| self.written.contains_key(id)) {
            return;
        }
        let known = self.waves.get(&[(angle, 1)][..]).cloned();
        if self.depth(angle) > 0 {
            // It may use the tape, which the call of the sine borrows.
            let term = self.term(angle);
            self.bind(angle, term);
        }
        let pair = known.unwrap_or_else(|| {
            let (operand, term) = (self.operand(angle), self.term(angle));
            self.pair(found, &[(angle, 1)], term, quote!(#operand.sin_cos()))
        });
        for (id, token) in found.into_iter().zip(pair) {
            id.map(|id| self.written.insert(id, (token, 0)));
        }
    }

    /// What is made by addition theorems: its value is, its coefficients are those of a sine and
    /// cosine.
    pub(super) fn wave(&mut self, id: Id, part: Part, angle: &[(Id, i16)], (sin, cos): (Id, Id)) {
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
struct Known<'a, 'b>(&'a SeriesWriter<'b>);

impl Known<'_, '_> {
    fn written(&self, id: Id) -> Option<TokenStream> {
        self.0.written.get(&id).filter(|(_, depth)| *depth == 0).map(|(token, _)| token.clone())
    }
}

impl Inputs for Known<'_, '_> {
    fn input(&self, symbol: Symbol) -> TokenStream {
        self.0.state.input(symbol)
    }

    fn constant(&self, id: Id) -> Option<TokenStream> {
        self.0.state.constant(id).or_else(|| self.written(id))
    }

    fn is_stored(&self, id: Id) -> bool {
        self.0.state.is_stored(id) || self.written(id).is_some()
    }

    fn taken(&self) -> Vec<String> {
        self.0.names.taken().cloned().collect()
    }
}
