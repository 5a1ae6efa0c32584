//! Linear equations in dimensions, solved one after the other.

use std::collections::{BTreeMap, BTreeSet};

use super::Dimension;
use super::affine::AffineDimension;
use crate::algebra::Rational;

/// Equations in reduced row echelon form: the pivots, of coefficient 1, occur in no other row.
#[derive(Clone, Debug, Default)]
pub(super) struct EchelonForm(BTreeMap<usize, ReducedRow>);

/// zero = 0, and the equations that it follows from.
#[derive(Clone, Debug)]
struct ReducedRow {
    zero: AffineDimension,
    from: BTreeSet<usize>,
}

/// What is left of an equation that contradicts others.
#[derive(Clone, Debug)]
pub(super) struct Conflict {
    /// What should have been 0.
    pub rest: Dimension,
    /// The others.
    pub with: BTreeSet<usize>,
}

impl EchelonForm {
    /// Adds the equation of this number, or gives what it contradicts; one whose powers overflow
    /// says nothing.
    pub fn add(&mut self, number: usize, zero: &AffineDimension) -> Option<Conflict> {
        let mut row = self.reduced(zero);
        if row.zero.is_overflow() {
            return None;
        }
        let Some((&pivot, &coefficient)) = row.zero.sought.first_key_value() else {
            let fits = row.zero.known.iter().all(|power| power.is_zero());
            return (!fits).then_some(Conflict { rest: row.zero.known, with: row.from });
        };
        row.zero = row.zero.times(coefficient.recip());
        row.from.insert(number);
        for other in self.0.values_mut() {
            other.eliminate(pivot, &row);
        }
        self.0.insert(pivot, row);
        None
    }

    /// The dimension of a parameter, if it is determined.
    pub fn parameter(&self, index: usize) -> Option<Dimension> {
        self.value(&AffineDimension::parameter(index))
    }

    /// The value of an expression in dimensions, if it is determined.
    pub fn value(&self, affine: &AffineDimension) -> Option<Dimension> {
        let row = self.reduced(affine);
        row.zero.sought.is_empty().then_some(row.zero.known)
    }

    fn reduced(&self, zero: &AffineDimension) -> ReducedRow {
        let mut row = ReducedRow { zero: zero.clone(), from: BTreeSet::new() };
        for index in zero.unknowns() {
            if let Some(known) = self.0.get(&index) {
                row.eliminate(index, known);
            }
        }
        row
    }
}

impl ReducedRow {
    fn eliminate(&mut self, pivot: usize, row: &Self) {
        if let Some(&coefficient) = self.zero.sought.get(&pivot) {
            self.zero = core::mem::replace(&mut self.zero, AffineDimension::known([Rational::ZERO; 3]))
                .plus(-coefficient, &row.zero);
            self.from.extend(&row.from);
        }
    }
}
