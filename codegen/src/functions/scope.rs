//! What a phase's series need: of the program, of what stands for coordinates that the reduced
//! state lacks, in which order.

use std::collections::BTreeMap;

use super::{Functions, PhaseFunctions};
use crate::algebra::Symbol;
use crate::motion::{Motion, contains};
use crate::program::{Id, Operation, Program};

/// What the series of a phase give: everything that varies along a motion and tells when a contact
/// opens or closes.
#[derive(Clone, Debug)]
pub struct SeriesOutputs {
    /// The derivative of the reduced state, without that of the time.
    pub rates: Vec<Id>,
    /// Of each contact, zero where open, then the friction forces.
    pub reactions: Vec<Id>,
    /// Of the contacts the gaps of the open ones, then of those with friction the slip velocities
    /// of the sliding ones.
    pub gaps: Vec<Option<Id>>,
    /// Distances of the feet.
    pub feet: Vec<Id>,
}

impl SeriesOutputs {
    /// All of them, one after the other.
    pub fn outputs(&self) -> Vec<Id> {
        let gaps = self.gaps.iter().flatten();
        self.rates.iter().chain(&self.reactions).chain(gaps).chain(&self.feet).copied().collect()
    }
}

impl Functions {
    /// What the series of a phase give.
    pub fn series(&self, motion: &Motion, phase: &PhaseFunctions) -> SeriesOutputs {
        let set = &phase.set;
        let open = (0..motion.contacts.len()).map(|i| !contains(set.closed, i));
        let gaps = open.zip(&self.kernel.gap).map(|(open, gap)| open.then_some(*gap));
        let slides = |contact| contains(set.closed, contact) && !contains(set.stick, contact);
        let slips = motion.frictions().zip(&self.slips);
        let slips = slips.map(|((contact, _), [velocity, ..])| slides(contact).then_some(*velocity));
        SeriesOutputs {
            rates: phase.rates.iter().chain(&phase.accelerations).copied().collect(),
            reactions: phase.reactions.clone(),
            gaps: gaps.chain(slips).collect(),
            feet: self.feet.clone(),
        }
    }
}

/// What the series of a phase are written in terms of.
#[derive(Clone, Copy, Debug)]
pub struct SeriesScope<'a> {
    /// The phase.
    pub phase: &'a PhaseFunctions,
    /// The program of its functions.
    pub program: &'a Program,
}

impl SeriesScope<'_> {
    /// The symbol that `id` reads from the state.
    pub fn input(&self, id: Id) -> Option<Symbol> {
        match self.program.operation(id) {
            Operation::Input(symbol) if !self.program.is_constant(id) && self.stands_for(id).is_none() => {
                Some(symbol)
            }
            _ => None,
        }
    }

    /// What a coordinate or rate that the reduced state lacks, or an acceleration, is made of.
    pub fn stands_for(&self, id: Id) -> Option<Id> {
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

    /// What varies of the values that a value is made of along a motion.
    pub fn operands(&self, id: Id) -> Vec<Id> {
        if self.program.is_constant(id) {
            Vec::new()
        } else if let Some(wave) = self.program.wave(id) {
            wave.angle.iter().map(|&(value, _)| value).collect()
        } else if let Some(other) = self.stands_for(id) {
            vec![other]
        } else {
            let operands = match (self.quotient(id), self.magnitude(id)) {
                (Some((a, b)), _) => vec![a, b],
                (None, Some(a)) => vec![a],
                (None, None) => self.program.operation(id).operands().collect(),
            };
            operands.into_iter().filter(|&a| !self.program.is_constant(a)).collect()
        }
    }

    /// a and b of a product a · (1 / b), which is one convolution as a quotient and two as it
    /// stands.
    pub fn quotient(&self, id: Id) -> Option<(Id, Id)> {
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

    /// a of √(a a).
    pub fn magnitude(&self, id: Id) -> Option<Id> {
        let Operation::Sqrt(square) = self.program.operation(id) else { return None };
        match self.program.operation(square) {
            Operation::Mul(a, b) if a == b && !self.program.is_constant(a) => Some(a),
            _ => None,
        }
    }

    /// The rates are what an order waits for: of the coordinates it has the coefficient since the
    /// order before last.
    pub fn lateness(&self, id: Id, known: &BTreeMap<Id, usize>) -> usize {
        match self.input(id) {
            Some(Symbol::Coordinate { order: 1, .. }) => self.program.operations().len(),
            _ => self.operands(id).iter().filter_map(|a| known.get(a)).max().map_or(0, |last| last + 1),
        }
    }

    /// What varies of all that `outputs` need, operands first, and how often each is used.
    pub fn needed(&self, outputs: &[Id]) -> (Vec<Id>, BTreeMap<Id, usize>) {
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
