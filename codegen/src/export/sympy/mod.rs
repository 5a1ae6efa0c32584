//! The equations as a module of Python that SymPy reads.

mod names;
mod phase;
mod python;
mod rows;
mod system;

use crate::Analysis;
use crate::algebra::Symbol;
use crate::export::formula::Formulas;
use crate::motion::{Expression, OpaqueTerm};
use crate::text::written_out;
use names::names;
use std::collections::BTreeSet;

/// What every module has, whatever the model: types of rows and contact sets, the equations of any
/// contact set.
const COMMON: &str = include_str!("common.py");

/// The module.
pub(super) fn module(analysis: &Analysis) -> syn::Result<String> {
    let (dense, phases) = written_out(analysis)?;
    let (formulas, declared) = names(analysis);
    let exported = Exported { analysis, formulas };
    let mut text = exported.head();
    text += &declared;
    text += COMMON;
    text += &exported.system(&dense);
    text += &exported.rows();
    text += &exported.phases(&phases);
    Ok(text)
}

/// A model with the names of its symbols.
struct Exported<'a> {
    analysis: &'a Analysis,
    formulas: Formulas,
}

impl Exported<'_> {
    /// Assignments of the opaque terms that some symbols need, each after those that it reads.
    fn definitions(&self, terms: &[OpaqueTerm], symbols: BTreeSet<Symbol>, indent: &str) -> String {
        let (mut text, mut done) = (String::new(), BTreeSet::new());
        for symbol in symbols {
            self.define(terms, symbol, indent, &mut done, &mut text);
        }
        text
    }

    fn define(
        &self,
        terms: &[OpaqueTerm],
        symbol: Symbol,
        indent: &str,
        done: &mut BTreeSet<Symbol>,
        text: &mut String,
    ) {
        let Symbol::Opaque { index, order } = symbol else { return };
        let value = terms.get(usize::from(index)).and_then(|term| term.orders.get(usize::from(order)));
        let Some(value) = value.filter(|_| done.insert(symbol)) else { return };
        let mut read = BTreeSet::new();
        symbols(value, &mut read);
        for symbol in read {
            self.define(terms, symbol, indent, done, text);
        }
        let value = self.formulas.expression(value);
        *text += &format!("{indent}{} = {}\n", self.formulas.symbol(symbol), python::bracketed(&value));
    }
}

/// The symbols that an expression reads.
fn symbols(expression: &Expression, read: &mut BTreeSet<Symbol>) {
    match expression {
        Expression::Value(quotient) => {
            read.extend(quotient.numerator().symbols());
            read.extend(quotient.factors().iter().flat_map(|(factor, _)| factor.symbols()));
        }
        Expression::Angle(angle) => read.extend(angle.terms().iter().map(|(symbol, _)| *symbol)),
        Expression::Time => {}
        Expression::Apply(_, inner) => symbols(inner, read),
        Expression::Join(_, a, b) => {
            symbols(a, read);
            symbols(b, read);
        }
    }
}
