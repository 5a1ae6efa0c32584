//! What a phase's series need: of the program, of what stands for coordinates that the reduced state lacks, in which order.

use std::collections::BTreeMap;

use super::super::functions::State;
use crate::algebra::Symbol;
use crate::functions::PhaseFunctions;
use crate::program::{Id, Operation, Program};

/// What the series of a phase are written in terms of.
pub(super) struct Scope<'a> {
    pub state: &'a State<'a>,
    pub phase: &'a PhaseFunctions,
    pub program: &'a Program,
}

impl Scope<'_> {
    /// The symbol that `id` reads from the state.
    pub(super) fn input(&self, id: Id) -> Option<Symbol> {
        match self.program.operation(id) {
            Operation::Input(symbol) if !self.program.is_constant(id) && self.stands_for(id).is_none() => {
                Some(symbol)
            }
            _ => None,
        }
    }

    /// What a coordinate or rate that the reduced state lacks, or an acceleration, is made of.
    pub(super) fn stands_for(&self, id: Id) -> Option<Id> {
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

    pub(super) fn operands(&self, id: Id) -> Vec<Id> {
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

    /// a and b of a product a · (1 / b), which is one convolution as a quotient and two as it stands.
    pub(super) fn quotient(&self, id: Id) -> Option<(Id, Id)> {
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
    pub(super) fn magnitude(&self, id: Id) -> Option<Id> {
        let Operation::Sqrt(square) = self.program.operation(id) else { return None };
        match self.program.operation(square) {
            Operation::Mul(a, b) if a == b && !self.program.is_constant(a) => Some(a),
            _ => None,
        }
    }

    /// The rates are what an order waits for: of the coordinates it has the coefficient since the order before last.
    pub(super) fn lateness(&self, id: Id, known: &BTreeMap<Id, usize>) -> usize {
        match self.input(id) {
            Some(Symbol::Coordinate { order: 1, .. }) => self.program.operations().len(),
            _ => self.operands(id).iter().filter_map(|a| known.get(a)).max().map_or(0, |last| last + 1),
        }
    }

    /// What varies of all that `outputs` need, operands first, and how often each is used.
    pub(super) fn needed(&self, outputs: &[Id]) -> (Vec<Id>, BTreeMap<Id, usize>) {
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
