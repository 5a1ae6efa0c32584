//! Whether values are affine functions of the reduced state, with coefficients that parameters
//! alone determine: over a step they are then as good as the step's own polynomial.

use std::collections::BTreeMap;

use super::{Functions, PhaseFunctions, SeriesScope};
use crate::motion::Motion;
use crate::program::{Id, Operation};

impl Functions {
    /// Whether all that tells when a contact opens, closes or slips is affine in a phase.
    pub fn are_guards_affine(&self, motion: &Motion, phase: &PhaseFunctions) -> bool {
        let along = self.series(motion, phase);
        let guards = along.reactions.iter().chain(along.gaps.iter().flatten()).chain(&along.feet);
        let guards: Vec<Id> = guards.copied().collect();
        SeriesScope { phase, program: &self.program }.are_affine(&guards)
    }
}

impl SeriesScope<'_> {
    /// Whether values are polynomials of at most first degree of the reduced state.
    pub fn are_affine(&self, values: &[Id]) -> bool {
        let mut degrees = BTreeMap::new();
        for id in self.needed(values).0 {
            let degree = self.degree(id, &degrees);
            degrees.insert(id, degree);
        }
        values.iter().all(|id| matches!(self.known_degree(*id, &degrees), Some(0 | 1)))
    }

    /// The degree of a value whose operands are known; none of what is no polynomial.
    fn degree(&self, id: Id, known: &BTreeMap<Id, Option<u32>>) -> Option<u32> {
        let of = |id: Id| self.known_degree(id, known);
        if self.program.is_constant(id) {
            return Some(0);
        }
        if self.program.wave(id).is_some() {
            return None;
        }
        if let Some(other) = self.stands_for(id) {
            return of(other);
        }
        match self.program.operation(id) {
            Operation::Ratio(_) | Operation::Pi => Some(0),
            Operation::Input(_) => Some(1),
            Operation::Add(a, b) | Operation::Sub(a, b) => Some(of(a)?.max(of(b)?)),
            Operation::Mul(a, b) => Some(of(a)?.saturating_add(of(b)?)),
            Operation::MulAdd(a, b, c) => Some(of(a)?.saturating_add(of(b)?).max(of(c)?)),
            Operation::Neg(a) => of(a),
            Operation::Div(a, b) => of(b).filter(|degree| *degree == 0).and_then(|_| of(a)),
            Operation::Sqrt(_) | Operation::Sin(_) | Operation::Cos(_) | Operation::Elementary(..) => None,
        }
    }

    fn known_degree(&self, id: Id, known: &BTreeMap<Id, Option<u32>>) -> Option<u32> {
        if self.program.is_constant(id) { Some(0) } else { known.get(&id).copied().flatten() }
    }
}
