//! The first time in a step that a condition becomes true.

use core::cell::RefCell;

use super::guard_source::EXACT;
use super::pieces::{Followed, Pieces, SHORTEST};
use super::{EventDetector, StepView, Watch};
use crate::event::root_isolation::{self, Crossing, GuardError, Smooth, Start};
use crate::expression::{Condition, Enclosure, Interval, Relation, Sides, Variable};

/// Halvings of a piece: to the spacing of doubles.
const HALVINGS: usize = 53;

/// Beside a root values are smaller than this part of those at the ends of its piece, beside a pole larger.
const NEAR: f64 = 0.01;

/// What a condition reads, over a step.
type Leaves = Vec<(Variable, Smooth)>;

impl EventDetector<'_> {
    /// When a condition becomes true.
    pub(super) fn condition(
        &self,
        watch: &Watch,
        k: usize,
        step: &StepView<'_>,
    ) -> Result<Option<f64>, GuardError> {
        let condition = &self.conditions[k];
        let of_series = |sides: &Sides| self.bounds.relative * sides.size();
        let sides = condition.is_entire().then(|| step.sides(condition)).flatten();
        let exact = sides.filter(|sides| sides.tail() <= EXACT * of_series(sides));
        let start = match watch.sign {
            _ if watch.at_root => Start::Root,
            Some(positive) if condition.relation() == Relation::Equal => Start::Continues { positive },
            _ => Start::Free,
        };
        if let Some(sides) = exact {
            return of_difference(condition, sides.difference(), start, of_series(&sides));
        }
        let bound = self.bound(watch, step, &[0.0, 0.5, 1.0]);
        let value = |theta: f64| step.difference(theta, condition, &mut self.values.borrow_mut()).0;
        let leaves = if self.is_noisy { None } else { self.leaves(condition, step)? };
        let Some(leaves) = leaves else {
            return of_values(condition, self.is_noisy, &value, (start, bound));
        };
        self.of_pieces(condition, (step, &leaves), &value, (start, bound))
    }

    /// What the condition reads; none if something has no polynomial that fits it.
    fn leaves(&self, condition: &Condition, step: &StepView<'_>) -> Result<Option<Leaves>, GuardError> {
        let reads = condition.reads();
        let known: RefCell<Vec<(f64, Vec<f64>)>> = RefCell::default();
        let value = |k: usize, theta: f64| {
            let mut known = known.borrow_mut();
            if let Some((_, values)) = known.iter().find(|(at, _)| *at == theta) {
                return values[k];
            }
            let values = step.read(theta, &reads, &mut self.values.borrow_mut());
            let own = values[k];
            known.push((theta, values));
            own
        };
        let mut leaves = Vec::with_capacity(reads.len());
        for (k, variable) in reads.iter().enumerate() {
            let size = [0.0, 0.5, 1.0].map(|theta| value(k, theta).abs()).into_iter().fold(0.0, f64::max);
            let fit = Smooth::fit(&mut |theta| value(k, theta), self.bounds.relative * size)?;
            let Some(fit) = fit else { return Ok(None) };
            leaves.push((*variable, fit));
        }
        Ok(Some(leaves))
    }

    /// By bounds over pieces of the step; only what they leave open is looked into.
    fn of_pieces(
        &self,
        condition: &Condition,
        (step, leaves): (&StepView<'_>, &Leaves),
        value: &dyn Fn(f64) -> f64,
        (start, bound): (Start, f64),
    ) -> Result<Option<f64>, GuardError> {
        let enclosure = |piece: [f64; 2]| {
            let leaf = |variable: Variable| {
                let (_, smooth) = leaves.iter().find(|(known, _)| *known == variable)?;
                let [value, slope] = [smooth.value(piece), smooth.slope(piece)];
                let around = |(middle, reach)| Interval::around(middle, reach);
                Some(Enclosure { value: around(value), slope: around(slope) })
            };
            step.enclosure(condition, &leaf)
        };
        let known = leaves.iter().map(|(_, smooth)| smooth.resolution()).fold(1.0, f64::min);
        let shortest = known.max(SHORTEST);
        let mut start = start;
        let mut look = |[from, to]: [f64; 2]| {
            let begins = if from == 0.0 { start } else { after(condition, start, value(from), bound) };
            let within = |s: f64| value(from + (to - from) * s);
            let at = |s: f64| from + (to - from) * s;
            // What is not resolved in so short a piece is a pole or a jump.
            let jumps = to - from <= shortest;
            let found = match of_values(condition, jumps, &within, (begins, bound)) {
                Err(_) if jumps && [0.0, 1.0].map(within).iter().all(|end| end.is_finite()) => None,
                found => found.map_err(|error| error.at(at))?,
            };
            let found = found.filter(|s| !jumps || is_near(&within, *s, bound));
            let found = found.or_else(|| changed(condition, &within, bound));
            start = begins;
            Ok(found.map(at))
        };
        match (Pieces { enclosure: &enclosure, value, bound, shortest }).follow(&mut look)? {
            Followed::Event(event) => Ok(event),
            Followed::Unbounded => of_values(condition, false, value, (start, bound)),
        }
    }
}

/// By values alone; those of noise are followed as they are.
fn of_values(
    condition: &Condition,
    is_noisy: bool,
    value: &dyn Fn(f64) -> f64,
    (start, bound): (Start, f64),
) -> Result<Option<f64>, GuardError> {
    let sign = if condition.relation() == Relation::Greater { -1.0 } else { 1.0 };
    let signed = |theta: f64| sign * value(theta);
    let crossing = match (condition.relation(), is_noisy) {
        (Relation::Equal, true) => return root_isolation::first_root_noisy(value, start, bound),
        (Relation::Equal, false) => return root_isolation::first_root(value, start, bound),
        (_, true) => root_isolation::watch_noisy(None, signed, start, bound)?,
        (_, false) => root_isolation::watch(signed, start, bound)?,
    };
    Ok(becomes_true(crossing, start))
}

/// Where the values at the ends of a piece are beyond their bound on different sides, and become so through zero, not a pole:
/// what is lost in the rounding of a steep function.
fn changed(condition: &Condition, value: &dyn Fn(f64) -> f64, bound: f64) -> Option<f64> {
    let ends @ [first, last] = [value(0.0), value(1.0)];
    let counts = match condition.relation() {
        Relation::Equal => true,
        Relation::Less => first > last,
        Relation::Greater => first < last,
    };
    let apart = first * last < 0.0 && ends.iter().all(|end| end.abs() > bound);
    if !(counts && apart) {
        return None;
    }
    let [mut low, mut high] = [0.0, 1.0];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        let before = (value(middle) > 0.0) == (first > 0.0);
        *(if before { &mut low } else { &mut high }) = middle;
    }
    (is_near(value, low, bound) && is_near(value, high, bound)).then_some(high)
}

/// Whether a value is near zero, compared with those at the ends of its piece.
fn is_near(value: &dyn Fn(f64) -> f64, at: f64, bound: f64) -> bool {
    value(at).abs() <= bound.max(NEAR * value(0.0).abs().min(value(1.0).abs()))
}

/// How a later piece begins: at the root that is known at the start of the step, until the condition has left it.
fn after(condition: &Condition, before: Start, value: f64, bound: f64) -> Start {
    match before {
        Start::Root if value.abs() <= bound => Start::Root,
        _ if condition.relation() == Relation::Equal => Start::Continues { positive: value > 0.0 },
        _ => Start::Free,
    }
}

fn of_difference(
    condition: &Condition,
    difference: &[f64],
    start: Start,
    bound: f64,
) -> Result<Option<f64>, GuardError> {
    let crossing = match condition.relation() {
        Relation::Equal => return root_isolation::first_root_series(difference, start, bound),
        Relation::Less => root_isolation::watch_series(difference, start, bound)?,
        Relation::Greater => {
            let negated: Vec<f64> = difference.iter().map(|c| -c).collect();
            root_isolation::watch_series(&negated, start, bound)?
        }
    };
    Ok(becomes_true(crossing, start))
}

fn becomes_true(crossing: Crossing, start: Start) -> Option<f64> {
    match crossing {
        Crossing::At { theta } => Some(theta),
        Crossing::LeavesAtStart if start == Start::Root => Some(0.0),
        _ => None,
    }
}
