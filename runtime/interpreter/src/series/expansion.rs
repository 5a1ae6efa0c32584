//! The series of a phase with the guards of its contacts.

use liftoff_core::integrate::{Guards, SeriesExpansion};
use liftoff_core::model::Layout;
use liftoff_core::series::{ORDERS, TapeOf};

use super::SeriesCode;
use crate::code::Register;

/// A source of Taylor coefficients; it keeps those of the last expansion.
pub(crate) struct Expansion<'a> {
    code: &'a SeriesCode,
    constants: usize,
    registers: Vec<f64>,
    tape: TapeOf<f64>,
    /// c₀, c₁, …, `entries` numbers each.
    series: Vec<f64>,
    /// One coefficient of all guards after the other.
    guards: Vec<f64>,
    scaled: Vec<[f64; ORDERS]>,
    has_contacts: bool,
    terms: usize,
    values: Values,
}

/// Order 0, which is on the tape.
struct Values {
    /// Whether it is, at the state.
    known: bool,
    state: Vec<f64>,
    rates: Vec<f64>,
    guard: Vec<f64>,
}

impl<'a> Expansion<'a> {
    pub fn new(code: &'a SeriesCode, constants: &[f64], layout: &Layout) -> Self {
        let mut registers = vec![0.0; code.registers];
        registers[..constants.len()].copy_from_slice(constants);
        let (entries, guards) = (code.entries, code.guards());
        Self {
            code,
            constants: constants.len(),
            registers,
            tape: TapeOf::new(code.columns),
            series: vec![0.0; entries * ORDERS],
            guards: vec![0.0; guards * ORDERS],
            scaled: vec![[0.0; ORDERS]; guards],
            has_contacts: !layout.contacts.is_empty(),
            terms: 0,
            values: Values {
                known: false,
                state: vec![f64::NAN; entries],
                rates: vec![f64::NAN; entries],
                guard: vec![0.0; guards],
            },
        }
    }

    /// Order n of everything from that of the state; the rates and the guards.
    fn order(&mut self, n: usize, rates: &mut [f64], guard: &mut [f64]) {
        let Self { code, registers, tape, .. } = self;
        match n {
            0 => code.order(&mut tape.values(), registers, true),
            _ => code.higher_order(n, tape, registers),
        }
        code.read(registers, if n == 0 { 1.0 } else { 0.0 }, rates, guard);
    }

    fn set_state(&mut self, state: &[f64]) {
        self.registers[self.constants..][..state.len()].copy_from_slice(state);
    }

    /// Order 0 at a state, unless it is known.
    fn begin(&mut self, state: &[f64]) {
        if self.values.known && self.values.state == state {
            return;
        }
        self.set_state(state);
        let mut values = core::mem::replace(&mut self.values, Values::nothing());
        self.order(0, &mut values.rates, &mut values.guard);
        values.known = true;
        values.state.copy_from_slice(state);
        self.values = values;
    }
}

impl Values {
    const fn nothing() -> Self {
        Self { known: false, state: Vec::new(), rates: Vec::new(), guard: Vec::new() }
    }
}

impl SeriesCode {
    /// An order n > 0.
    pub(super) fn higher_order(&self, n: usize, tape: &mut TapeOf<f64>, registers: &mut [f64]) {
        #[cfg(feature = "jit")]
        if let Some(native) = self.native.get(|| crate::native::Order::of(self)) {
            return native.call(registers, tape.row(n), n);
        }
        self.order(&mut tape.coefficients(n), registers, false);
    }

    fn guards(&self) -> usize {
        self.reactions.len() + self.gaps.len() + self.feet.len()
    }

    /// What an order has left in the registers; `one` is the coefficient of 1, the rate of the time.
    fn read(&self, registers: &[f64], one: f64, rates: &mut [f64], guard: &mut [f64]) {
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

impl SeriesExpansion for Expansion<'_> {
    fn expand(&mut self, state: &[f64], unit: f64, order: usize) {
        let (entries, width) = (state.len(), self.code.guards());
        self.begin(state);
        self.series[..entries].copy_from_slice(state);
        self.terms = if self.has_contacts { order } else { 0 };
        self.guards[..width].copy_from_slice(&self.values.guard);
        for (next, rate) in self.series[entries..].iter_mut().zip(&self.values.rates) {
            *next = unit * rate;
        }
        // The orders that follow write over some of it.
        self.values.known = false;
        let mut series = core::mem::take(&mut self.series);
        let mut guards = core::mem::take(&mut self.guards);
        for n in 1..order {
            let (below, above) = series.split_at_mut((n + 1) * entries);
            self.set_state(&below[n * entries..]);
            let rates = &mut above[..entries];
            self.order(n, rates, &mut guards[n * width..][..width]);
            let part = unit / (n + 1) as f64;
            rates.iter_mut().for_each(|rate| *rate *= part);
        }
        (self.series, self.guards) = (series, guards);
    }

    fn series(&self) -> &[f64] {
        &self.series
    }

    fn rates(&mut self, state: &[f64], rates: &mut [f64]) {
        self.begin(state);
        rates.copy_from_slice(&self.values.rates);
    }

    fn guards(&mut self, ratio: f64) -> Option<Guards<'_>> {
        let (terms, width) = (self.terms, self.code.guards());
        let mut power = 1.0;
        for (k, row) in self.guards.chunks_exact(width.max(1)).take(terms).enumerate() {
            for (series, term) in self.scaled.iter_mut().zip(row) {
                series[k] = if *term == 0.0 { 0.0 } else { power * term };
            }
            power *= ratio;
        }
        let (reactions, rest) = self.scaled.split_at(self.code.reactions.len());
        let (gaps, feet) = rest.split_at(self.code.gaps.len());
        Some(Guards::new(terms, reactions, gaps, feet))
    }
}
