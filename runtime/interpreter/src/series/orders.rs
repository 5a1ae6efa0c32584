//! The series of the full equations, for phases that keep all coordinates.

use liftoff_codegen::Analysis;
use liftoff_codegen::algebra::Symbol;
use liftoff_codegen::functions::SeriesScope;
use liftoff_codegen::program::Id;
use liftoff_core::model::Varying;
use liftoff_core::series::TapeOf;
use liftoff_core::system::{KernelOrders, TakeOrder};

use super::SeriesCode;
use super::lowering::SeriesWriter;
use crate::code::Source;
use crate::pool::Lent;
use crate::system::{FullCode, Kernel};

/// One order of the full equations as code, with the entries of M and J that vary.
#[derive(Debug)]
pub(crate) struct KernelCode {
    /// The outputs of the kernel stand in place of reactions.
    code: SeriesCode,
    mass: Vec<[usize; 2]>,
    jacobian: Vec<[usize; 2]>,
}

impl KernelCode {
    /// None where no phase needs it.
    pub fn lower(
        analysis: &Analysis,
        constants: &[Id],
        kernel: &[Id],
        source: &dyn Fn(Symbol) -> Source,
    ) -> Option<Self> {
        let functions = &analysis.functions;
        let scope = SeriesScope { phase: functions.projected.as_ref()?, program: &functions.program };
        let entries = analysis.motion.entries();
        let outputs: Vec<Id> = kernel.iter().chain(&functions.feet).copied().collect();
        let mut writer = SeriesWriter::new(&scope, constants, entries, source, &outputs);
        let [kernel, feet] =
            [kernel, &functions.feet].map(|ids| ids.iter().map(|&id| writer.term(id)).collect());
        let code = writer.finish((Vec::new(), kernel, Vec::new(), feet), (entries, false));
        let [mass, jacobian] = functions.varying();
        Some(Self { code, mass, jacobian })
    }
}

/// The orders of a model with values of its constants.
pub(crate) struct Orders<'a> {
    of: &'a KernelCode,
    full: &'a FullCode,
    constants: usize,
    registers: Vec<f64>,
    tape: TapeOf<f64>,
}

impl<'a> Orders<'a> {
    pub fn new(of: &'a KernelCode, full: &'a FullCode, constants: &[f64]) -> Self {
        let mut registers = vec![0.0; of.code.registers];
        registers[..constants.len()].copy_from_slice(constants);
        Self { of, full, constants: constants.len(), registers, tape: TapeOf::new(of.code.columns) }
    }
}

impl KernelOrders for Orders<'_> {
    fn varying(&self) -> Varying<'_> {
        Varying { mass: &self.of.mass, jacobian: &self.of.jacobian }
    }

    fn order(&mut self, n: usize, state: &[f64], take: &mut TakeOrder<'_>) {
        let Self { of: KernelCode { code, .. }, full, constants, registers, tape } = self;
        registers[*constants..][..state.len()].copy_from_slice(state);
        match n {
            0 => code.order(&mut tape.values(), registers, true),
            _ => code.higher_order(n, tape, registers),
        }
        let mut values = Lent::new(code.reactions.len());
        let mut feet = Lent::new(code.feet.len());
        for (value, &register) in values.iter_mut().zip(&code.reactions) {
            *value = registers[register as usize];
        }
        for (foot, &register) in feet.iter_mut().zip(&code.feet) {
            *foot = registers[register as usize];
        }
        take(&Kernel::from_values(full, values), &feet);
    }
}
