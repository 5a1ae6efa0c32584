//! The equations of one contact set, interpreted.

use std::sync::Arc;

use liftoff_codegen::Analysis;
use liftoff_codegen::algebra::Symbol;
use liftoff_codegen::functions::PhaseFunctions;
use liftoff_codegen::motion::UNROLLED;
use liftoff_codegen::program::Id;
use liftoff_core::kernel::are_trusted;
use liftoff_core::model::{ContactSet, Energy, Form, Pivots};
use liftoff_core::scalar::{DoubleDouble, Dual4};
use liftoff_core::system::{Jacobian, PhaseEquations, PhaseInfo, System, projected_series};
use liftoff_core::system::{Methods, SeriesExpansion};

use super::evaluator::Evaluator;
use super::full::HeldCode;
use super::jacobian;
use crate::code::{Code, Lowering, Source};
use crate::pool::{Lent, Number};
use crate::series::{Orders, SeriesCode, expansion};

/// The functions of a closed form as code.
#[derive(Debug)]
pub(crate) struct PhaseCode {
    set: (u64, u64),
    /// The entries of the full state that the reduced one has.
    kept: Vec<usize>,
    coordinates: usize,
    rates: usize,
    pub(super) derivative: Code,
    reactions: Code,
    /// None where the reduced state is the full one.
    embed: Option<Code>,
    pivots: Code,
    energy: Code,
    series: Option<SeriesCode>,
    /// Whether reactions, gaps, slip velocities and feet are affine.
    affine: bool,
}

impl PhaseCode {
    pub fn lower(analysis: &Analysis, constants: &[Id], phase: &PhaseFunctions) -> Self {
        let (n, program) = (analysis.motion.n, &analysis.functions.program);
        let (coordinates, rates) = (phase.kept.len(), phase.moving.len());
        let place = |list: &[usize], index: u16| list.iter().position(|&i| i == usize::from(index));
        let source = |symbol: Symbol| {
            let found = match symbol {
                Symbol::Coordinate { index, order: 0 } => place(&phase.kept, index),
                Symbol::Coordinate { index, order: 1 } => {
                    place(&phase.moving, index).map(|k| coordinates + k)
                }
                Symbol::Coordinate { index, .. } => {
                    let acceleration = place(&phase.moving, index).map(|k| phase.accelerations[k]);
                    return acceleration.map_or(Source::Missing, Source::Value);
                }
                carried => {
                    let place = analysis.motion.carried().position(|symbol| symbol == carried);
                    place.map(|k| coordinates + rates + k)
                }
            };
            found.map_or(Source::Missing, Source::Input)
        };
        let carried = 2 * n..analysis.motion.entries();
        let entries = coordinates + rates + carried.len();
        let code = |outputs: &[Id]| Lowering::new(program, constants, entries, &source).code(outputs);
        let derivative: Vec<Id> = phase.rates.iter().chain(&phase.accelerations).copied().collect();
        let kept = phase.kept.iter().copied().chain(phase.moving.iter().map(|i| n + i)).chain(carried);
        let is_full = rates == n;
        let energy = if is_full { analysis.functions.energy } else { phase.energy };
        Self {
            set: (phase.set.closed, phase.set.stick),
            kept: kept.collect(),
            coordinates,
            rates,
            derivative: code(&derivative),
            reactions: code(&phase.reactions),
            embed: (!is_full).then(|| code(&phase.embedding)),
            pivots: code(&phase.pivots),
            energy: code(&energy),
            affine: analysis.functions.are_guards_affine(&analysis.motion, phase),
            series: (rates <= UNROLLED)
                .then(|| SeriesCode::lower(analysis, constants, phase, entries, &source)),
        }
    }
}

/// A phase in either form.
pub(crate) struct InterpretedPhase<S> {
    pub(super) system: Arc<Evaluator<S>>,
    info: PhaseInfo,
    /// Which closed form; none of the projected one.
    pub(super) closed: Option<usize>,
    /// Which of the projected forms with code of their own, if it is one.
    held: Option<usize>,
    kept: Vec<usize>,
}

impl<S: Number> InterpretedPhase<S> {
    pub fn new(system: Arc<Evaluator<S>>, set: ContactSet, form: Form) -> Self {
        let model = Arc::clone(&system.model);
        let has_friction = !model.layout.frictions.is_empty();
        let wanted = if has_friction { set.bits_and_stick() } else { set.bits().map(|bits| (bits, 0)) };
        let is_it = |phase: &PhaseCode| Some(phase.set) == wanted;
        let closed = model.phases.iter().position(is_it).filter(|_| form == Form::Reduced);
        let held = model.full.held.iter().position(|held| Some(held.set) == wanted);
        let held = held.filter(|_| closed.is_none());
        let (n, entries) = (model.full.coordinates, model.full.entries);
        let (info, kept) = match closed.map(|k| &model.phases[k]) {
            Some(code) => {
                let (coordinates, rates, entries) = (code.coordinates, code.rates, code.kept.len());
                (PhaseInfo { set, form, coordinates, rates, entries, affine: code.affine }, code.kept.clone())
            }
            None => {
                let form = Form::Multipliers;
                (
                    PhaseInfo { set, form, coordinates: n, rates: n, entries, affine: false },
                    (0..entries).collect(),
                )
            }
        };
        Self { system, info, closed, held, kept }
    }

    pub(super) fn code(&self) -> Option<&PhaseCode> {
        self.closed.map(|k| &self.system.model.phases[k])
    }

    fn evaluate(&self, code: &Code, y: &[S], outputs: &mut [S]) {
        code.evaluate(&self.system.constants, &[y], outputs);
    }

    /// The motion by the code of the contact set, if it has some and its pivots can be trusted:
    /// `take` gets rates and accelerations, and the reactions of the closed rows.
    fn held(&self, y: &[S], take: impl FnOnce(&HeldCode, &[S], &[S])) -> bool {
        let Some(held) = self.held.map(|k| &self.system.full().held[k]).filter(|_| S::PLAIN) else {
            return false;
        };
        let mut values = Lent::new(held.code.outputs.len());
        self.evaluate(&held.code, y, &mut values);
        let (motion, rest) = values.split_at(2 * self.info.coordinates);
        let (pivots, reactions) = rest.split_at(held.pivots);
        let trusted = are_trusted(pivots.as_chunks().0);
        if trusted {
            take(held, motion, reactions);
        }
        trusted
    }

    /// Rates and accelerations of the projected form.
    fn projected(&self, y: &[S], derivative: &mut [S]) {
        let (system, n) = (&self.system, self.info.coordinates);
        if self.held(y, |_, motion, _| derivative[..2 * n].copy_from_slice(motion)) {
            return;
        }
        let (rates, accelerations) = derivative[..2 * n].split_at_mut(n);
        rates.copy_from_slice(&y[n..2 * n]);
        let mut multipliers = Lent::new(system.full().rows);
        system.motion(y, &self.info.set, accelerations, &mut multipliers);
    }

    fn derive(&self, y: &[S], derivative: &mut [S]) {
        if y.len() != self.info.entries || derivative.len() != y.len() {
            return derivative.fill(S::from_f64(f64::NAN));
        }
        match self.code() {
            Some(code) => self.evaluate(&code.derivative, y, derivative),
            None => self.projected(y, derivative),
        }
        let carried = self.info.coordinates + self.info.rates..self.info.entries;
        for (slope, entry) in derivative[carried].iter_mut().zip(2 * self.system.full().coordinates..) {
            *slope = S::ratio(self.system.model.layout.slope(entry), 1);
        }
    }

    fn react(&self, y: &[S], reactions: &mut [S]) {
        if let Some(code) = self.code() {
            return self.evaluate(&code.reactions, y, reactions);
        }
        if self.info.set.is_empty() {
            return reactions.fill(S::ZERO);
        }
        let by_place = |held: &HeldCode, _: &[S], closed: &[S]| {
            for (reaction, place) in reactions.iter_mut().zip(&held.reactions) {
                *reaction = place.map_or(S::ZERO, |k| closed[k]);
            }
        };
        if self.held(y, by_place) {
            return;
        }
        let (layout, full) = (self.system.model.layout, self.system.full());
        let mut solution = Lent::new(full.coordinates + full.rows);
        let (accelerations, multipliers) = solution.split_at_mut(full.coordinates);
        self.system.motion(y, &self.info.set, accelerations, multipliers);
        for (entry, reaction) in reactions.iter_mut().enumerate() {
            *reaction = multipliers[layout.row_of_reaction(entry)];
        }
    }

    fn embedded(&self, y: &[S], state: &mut [S]) {
        match self.code().and_then(|code| code.embed.as_ref()) {
            Some(embed) => {
                self.evaluate(embed, y, state);
                let carried = &y[self.info.coordinates + self.info.rates..];
                state[2 * self.system.full().coordinates..].copy_from_slice(carried);
            }
            None => state.copy_from_slice(y),
        }
    }

    /// T and V at the full state.
    fn energy_embedded(&self, y: &[S]) -> Energy<S> {
        let mut state = Lent::new(self.system.full().entries);
        self.embedded(y, &mut state);
        self.system.energy_at(&state)
    }
}

macro_rules! common {
    ($number:ty) => {
        fn system(&self) -> &dyn System<$number> {
            &*self.system
        }

        fn info(&self) -> &PhaseInfo {
            &self.info
        }

        fn kept(&self) -> &[usize] {
            &self.kept
        }

        fn derivative(&self, y: &[$number], derivative: &mut [$number]) {
            self.derive(y, derivative);
        }

        fn reactions(&self, y: &[$number], reactions: &mut [$number]) {
            self.react(y, reactions);
        }

        fn embed(&self, y: &[$number], state: &mut [$number]) {
            self.embedded(y, state);
        }
    };
}

impl PhaseEquations for InterpretedPhase<f64> {
    common!(f64);

    fn pivots(&self, y: &[f64]) -> Pivots<f64> {
        let Some(code) = self.code() else { return Pivots::collect([]) };
        let mut values = Lent::new(code.pivots.outputs.len());
        self.evaluate(&code.pivots, y, &mut values);
        Pivots::collect(values.iter().copied())
    }

    fn energy(&self, y: &[f64]) -> Energy<f64> {
        let Some(code) = self.code() else { return self.energy_embedded(y) };
        let mut energy = [0.0; 2];
        self.evaluate(&code.energy, y, &mut energy);
        let [kinetic, potential] = energy;
        Energy { kinetic, potential }
    }

    fn series(&self) -> Option<Box<dyn SeriesExpansion + '_>> {
        let (system, layout) = (&self.system, self.system.model.layout);
        if let Some(code) = self.code() {
            return Some(Box::new(expansion(code.series.as_ref()?, &system.constants)));
        }
        let orders = Orders::new(system.full().series.as_ref()?, system.full(), &system.constants);
        projected_series(layout, self.info.set, Box::new(orders))
    }

    fn products(&self) -> usize {
        let series = self.code().and_then(|code| code.series.as_ref());
        series.map_or(0, |series| series.columns)
    }

    fn methods(&self) -> Methods {
        Methods::for_entries(self.info.entries, self.system.model.layout.compliant)
    }

    fn jacobian(&self) -> Option<Jacobian<'_>> {
        self.system.model.layout.compliant.then(|| jacobian::build_jacobian(self))
    }
}

macro_rules! plain {
    ($number:ty) => {
        impl PhaseEquations<$number> for InterpretedPhase<$number> {
            common!($number);

            fn pivots(&self, _: &[$number]) -> Pivots<$number> {
                Pivots::collect([])
            }

            fn energy(&self, y: &[$number]) -> Energy<$number> {
                self.energy_embedded(y)
            }
        }
    };
}

plain!(DoubleDouble);
plain!(Dual4);
