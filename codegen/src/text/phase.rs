//! The equations of a contact set.

use super::{PhaseEquations, TextWriter};
use crate::algebra::Symbol;
use crate::math::{Equation, Math};
use crate::motion::ClosedSet;
use crate::phases::{CoordinateValue, Elimination, Phase};
use crate::program::Cost;

impl TextWriter<'_> {
    pub(super) fn phase(&self, phase: &Phase) -> PhaseEquations {
        let energies = [("T", &phase.kinetic), ("V", &phase.potential)];
        let energy = |(name, energy)| Equation::new(Math::symbol(name), self.quotient(energy));
        let motion = |k: usize| Equation::new(self.inertial(phase, k), self.quotient(&phase.forces[k]));
        PhaseEquations {
            closed: self.labels(phase.set),
            unclosed: self.unclosed(),
            multipliers: Vec::new(),
            eliminated: phase.eliminated.iter().map(|e| self.elimination(e)).collect(),
            energies: match phase.eliminated.is_empty() {
                true => Vec::new(),
                false => energies.into_iter().map(energy).collect(),
            },
            motion: (0..phase.moving.len()).map(motion).collect(),
            reactions: phase
                .reactions
                .iter()
                .flat_map(|(row, reaction)| {
                    self.total(*row)
                        .into_iter()
                        .chain([Equation::new(self.row(*row), self.quotient(reaction))])
                })
                .chain(self.frictions(phase.set))
                .collect(),
            cost: self.cost(phase),
        }
    }

    /// What a contact set is called: `free`, or `on A, E`.
    pub fn title(&self, set: ClosedSet) -> String {
        let named =
            PhaseEquations { closed: self.labels(set), unclosed: self.unclosed(), ..Default::default() };
        named.title()
    }

    /// What stands for `free` where nothing could be closed, or a drive moves it.
    pub(super) fn unclosed(&self) -> Option<&'static str> {
        match (
            self.analysis.motion.contacts.is_empty(),
            self.analysis.system.drives.iter().all(|drive| drive.switched),
        ) {
            (true, _) => Some("no contacts"),
            (false, false) => Some("no contact closed"),
            (false, true) => None,
        }
    }

    fn elimination(&self, elimination: &Elimination) -> Equation {
        let Elimination { coordinate, value, .. } = elimination;
        let (left, right) = match value {
            CoordinateValue::Rate(rate) => (Symbol::rate(*coordinate), self.quotient(rate)),
            CoordinateValue::Length(length) => (Symbol::coordinate(*coordinate), self.quotient(length)),
            CoordinateValue::Angle(angle) => (Symbol::coordinate(*coordinate), angle.math(self)),
        };
        Equation::new(self.symbol(left), right)
    }

    /// `M₁₁ q̈₁ + M₁₂ q̈₂ + h₁`.
    fn inertial(&self, phase: &Phase, k: usize) -> Math {
        let entries = phase.moving.iter().zip(&phase.mass[k]).filter(|(_, entry)| !entry.is_zero());
        let terms =
            entries.map(|(&i, entry)| times(self.quotient(entry), self.symbol(Symbol::acceleration(i))));
        let velocity = &phase.velocity_terms[k];
        let velocity = (!velocity.is_zero()).then(|| self.quotient(velocity));
        Math::sum(terms.chain(velocity))
    }

    fn cost(&self, phase: &Phase) -> Option<Cost> {
        let functions = &self.analysis.functions;
        let own = functions.phases.iter().find(|p| p.set == phase.set)?;
        Some(functions.program.cost(&own.accelerations))
    }
}

/// A product with one factor more, which stands before functions: `m l φ̈ cos φ`, not
/// `m l cos φ φ̈`.
pub(super) fn times(math: Math, factor: Math) -> Math {
    match math {
        Math::Minus(inner) => times(*inner, factor).minus(),
        Math::Product(mut factors) if matches!(factors.last(), Some(Math::Fraction { .. })) => {
            let fraction = factors.pop().map(|fraction| times(fraction, factor));
            Math::product(factors.into_iter().chain(fraction))
        }
        Math::Product(mut factors) => {
            let functions =
                factors.iter().rev().take_while(|last| matches!(last, Math::Apply { .. })).count();
            factors.insert(factors.len() - functions, factor);
            Math::product(factors)
        }
        function @ Math::Apply { .. } => Math::product([factor, function]),
        Math::Fraction { parts, wide } => {
            let [above, below] = *parts;
            Math::Fraction { parts: Box::new([times(above, factor), below]), wide }
        }
        other => Math::product([other, factor]),
    }
}
