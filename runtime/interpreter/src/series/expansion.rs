//! The series of a closed form with the guards of its contacts.

use liftoff_core::series::TapeOf;
use liftoff_core::system::{ByOrders, SeriesExpansion, SeriesOrders};

use super::SeriesCode;
use crate::code::Register;

/// The source of Taylor coefficients of a closed form.
pub(crate) fn expansion<'a>(code: &'a SeriesCode, constants: &[f64]) -> impl SeriesExpansion + use<'a> {
    let mut registers = vec![0.0; code.registers];
    registers[..constants.len()].copy_from_slice(constants);
    let tape = TapeOf::new(code.columns);
    let orders = PhaseOrders { code, constants: constants.len(), registers, tape };
    ByOrders::new(orders, code.entries, [code.reactions.len(), code.feet.len()])
}

struct PhaseOrders<'a> {
    code: &'a SeriesCode,
    constants: usize,
    registers: Vec<f64>,
    tape: TapeOf<f64>,
}

impl SeriesOrders for PhaseOrders<'_> {
    fn order(&mut self, n: usize, state: &[f64], rates: &mut [f64], guard: &mut [f64]) {
        let Self { code, constants, registers, tape } = self;
        registers[*constants..][..state.len()].copy_from_slice(state);
        match n {
            0 => code.order(&mut tape.values(), registers, true),
            _ => code.higher_order(n, tape, registers),
        }
        code.copy_results(registers, if n == 0 { 1.0 } else { 0.0 }, rates, guard);
    }
}

impl SeriesCode {
    /// An order n > 0.
    pub(super) fn higher_order(&self, n: usize, tape: &mut TapeOf<f64>, registers: &mut [f64]) {
        #[cfg(feature = "jit")]
        if let Some(native) = self.native.get(|| crate::native::Order::compile(self)) {
            return native.call(registers, tape.row(n), n);
        }
        self.order(&mut tape.coefficients(n), registers, false);
    }

    /// What an order has left in the registers; `one` is the coefficient of 1, the rate of the
    /// time.
    fn copy_results(&self, registers: &[f64], one: f64, rates: &mut [f64], guard: &mut [f64]) {
        let at = |register: Register| registers[register as usize];
        rates.fill(0.0);
        if self.timed {
            rates[self.rates.len()] = one;
        }
        for (rate, &register) in rates.iter_mut().zip(&self.rates) {
            *rate = at(register);
        }
        let reactions = self.reactions.iter().map(|&register| at(register));
        let gaps = self.gaps.iter().map(|register| register.map_or(0.0, at));
        let feet = self.feet.iter().map(|&register| at(register));
        guard.iter_mut().zip(reactions.chain(gaps).chain(feet)).for_each(|(to, from)| *to = from);
    }
}
