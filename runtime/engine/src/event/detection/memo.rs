//! Reactions in a step of a phase with multipliers, each a solution of the augmented equations: what is evaluated for one guard at a
//! place that is no node is kept for the others, which are looked at in the same places.

use core::cell::RefCell;
use std::collections::HashMap;

use super::Watch;
use super::step::{Kinds, StepView, Values};
use crate::model::Form;

/// A step of so many places is not kept any further.
const MOST: usize = 4096;

/// Values of the guards that follow from reactions, by place.
#[derive(Default)]
pub(super) struct Memo {
    /// What they follow from, if two or more share it.
    kinds: Option<Kinds>,
    rows: RefCell<HashMap<u64, Vec<f64>>>,
}

impl Memo {
    /// Begins a step.
    pub(super) fn begin(&mut self, list: &[Watch], step: &StepView<'_>) {
        self.rows.get_mut().clear();
        self.kinds = None;
        if step.form() == Form::Projected {
            let mut sharing = list.iter().filter(|watch| follows(watch)).map(|watch| watch.guard);
            let (first, second) = (sharing.next(), sharing.next());
            self.kinds = second.map(|_| Kinds::of(first.into_iter().chain(second).chain(sharing)));
        }
    }

    /// The value of a guard at a place, if it is one of those.
    pub(super) fn value(
        &self,
        (list, watch): (&[Watch], &Watch),
        (step, theta): (&StepView<'_>, f64),
        values: &mut Values,
    ) -> Option<f64> {
        let kinds = self.kinds.filter(|_| follows(watch))?;
        let mut rows = self.rows.borrow_mut();
        if rows.len() >= MOST {
            rows.clear();
        }
        let row = rows.entry(theta.to_bits()).or_insert_with(|| {
            step.sample(theta, kinds, values);
            list.iter().map(|watch| values.get(watch.guard)).collect()
        });
        Some(row[watch.index])
    }
}

fn follows(watch: &Watch) -> bool {
    let kinds = Kinds::of([watch.guard]);
    watch.is_sampled() && kinds.reactions && !kinds.grip
}
