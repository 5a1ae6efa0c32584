//! Values of the guards at the nodes of a step's fits: each place is evaluated once, for all guards.

use core::cell::Cell;

use super::step::{Kinds, StepView, Values};
use super::{Guard, Watch};
use crate::context::Numbers;
use crate::numerics::root_isolation::NODES;

/// Values of guards at some places of a step, one row each.
#[derive(Default)]
pub(super) struct Known {
    kinds: Kinds,
    /// Entries of a row: one for each guard.
    width: usize,
    values: Vec<f64>,
    /// The power of friction at each node, if it is told.
    powers: [f64; NODES.len()],
    has_power: bool,
    /// Slip velocities without rates, where friction is all that works.
    at_rest: Option<Numbers>,
    /// The node that is asked for next, where they are in order.
    next: Cell<usize>,
    /// The reduced states at the start of this step and at the end of the last one, at which its last values are.
    start: Vec<f64>,
    end: Vec<f64>,
}

impl Known {
    pub(super) fn of(width: usize) -> Self {
        Self { width, ..Self::default() }
    }

    /// Takes note of what a phase begins with.
    pub(super) fn begin(&mut self, start: &StepView<'_>, values: &mut Values) {
        self.at_rest = start.slips_at_rest(values);
    }

    /// Slip velocities without rates, where friction is all that works.
    pub(super) fn at_rest(&self) -> Option<&[f64]> {
        self.at_rest.as_deref()
    }

    /// Evaluates the guards of which series do not tell enough at all nodes of the first fit; what the last step ended with is not computed again.
    pub(super) fn sample(&mut self, list: &[Watch], step: &StepView<'_>, values: &mut Values) {
        let before = (self.kinds, self.has_power);
        self.kinds = Kinds::of(list.iter().filter(|watch| watch.is_sampled()).map(|watch| watch.guard));
        self.has_power = self.kinds.reactions && self.kinds.slips && self.at_rest.is_some();
        if !self.kinds.any() {
            return;
        }
        self.values.resize(self.width * NODES.len(), f64::NAN);
        step.reduced(0.0, &mut self.start);
        let last = NODES.iter().rposition(|theta| *theta == 1.0).unwrap_or(0);
        let continues =
            before == (self.kinds, self.has_power) && !self.start.is_empty() && self.start == self.end;
        if continues {
            self.values.copy_within(last * self.width..(last + 1) * self.width, 0);
            self.powers[0] = self.powers[last];
        }
        for (j, &theta) in NODES.iter().enumerate().skip(usize::from(continues)) {
            step.sample(theta, self.kinds, values);
            let row = &mut self.values[j * self.width..(j + 1) * self.width];
            row.iter_mut().zip(list).for_each(|(entry, watch)| *entry = values.get(watch.guard));
            if let Some(at_rest) = self.at_rest.as_ref().filter(|_| self.has_power) {
                self.powers[j] = step.friction_power(values, at_rest);
            }
        }
        step.reduced(1.0, &mut self.end);
    }

    /// The power of friction at the nodes, if all that it takes was evaluated.
    pub(super) fn powers(&self) -> Option<&[f64; NODES.len()]> {
        self.has_power.then_some(&self.powers)
    }

    /// The value of a guard without a series, if this is a node.
    pub(super) fn get(&self, watch: &Watch, theta: f64) -> Option<f64> {
        if !self.kinds.any() || !watch.is_sampled() || matches!(watch.guard, Guard::Condition(_)) {
            return None;
        }
        let mut j = self.next.get();
        if NODES[j] != theta {
            j = NODES.iter().position(|node| *node == theta)?;
        }
        self.next.set((j + 1) % NODES.len());
        Some(self.values[j * self.width + watch.index])
    }

    /// The largest value of a guard at the nodes.
    pub(super) fn size(&self, watch: &Watch) -> f64 {
        let values = self.values.iter().skip(watch.index).step_by(self.width.max(1));
        values.fold(0.0, |most, value| most.max(value.abs()))
    }
}
