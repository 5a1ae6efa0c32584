//! What parameters, and the senses of sliding contacts, alone determine.

use liftoff_codegen::algebra::Symbol;
use liftoff_codegen::numbers::ParameterProgram;
use liftoff_codegen::program::{Id, Program};
use liftoff_core::model::ContactSet;

use crate::code::{Code, Lowering, Source};
use crate::pool::Number;

/// The constants that a model's functions use.
#[derive(Debug)]
pub(crate) struct Constants {
    pub ids: Vec<Id>,
    code: Code,
    parameters: usize,
    contacts: usize,
}

impl Constants {
    /// What these outputs use of the constant part of a program.
    pub fn collect(program: &Program, outputs: &[Id], parameters: usize, contacts: usize) -> Self {
        let ids: Vec<Id> = program.used_constants(outputs).into_iter().collect();
        let source = |symbol: Symbol| match symbol {
            Symbol::Parameter(i) => Source::Input(i.into()),
            Symbol::Sense(contact) => Source::Input(parameters + usize::from(contact)),
            _ => Source::Missing,
        };
        let code = Lowering::new(program, &[], parameters + contacts, &source).code(&ids);
        Self { ids, code, parameters, contacts }
    }

    /// Their values in a contact set.
    pub fn values<S: Number>(&self, parameters: &[S], set: &ContactSet) -> Vec<S> {
        let parameter = |i: usize| parameters.get(i).copied().unwrap_or_else(|| S::from_f64(f64::NAN));
        let parameters: Vec<S> = (0..self.parameters).map(parameter).collect();
        let senses: Vec<S> = (0..self.contacts).map(|contact| S::ratio(set.sense(contact), 1)).collect();
        let mut values = vec![S::ZERO; self.ids.len()];
        self.code.evaluate(&[], &[&parameters, &senses], &mut values);
        values
    }
}

/// Numbers that parameters alone determine.
pub(crate) fn of_parameters(numbers: &ParameterProgram, parameters: usize) -> Code {
    let source = |symbol: Symbol| match symbol {
        Symbol::Parameter(i) => Source::Input(i.into()),
        _ => Source::Missing,
    };
    Lowering::new(&numbers.program, &[], parameters, &source).code(&numbers.ids)
}
