//! The first time in a step that a condition becomes true.

use super::advance::Advance;
use super::guard_source::{EXACT, GuardSource};
use super::pieces::{Bounded, Followed, Pieces, SHORTEST};
use super::step::Leaves;
use super::{EventDetector, StepView, Watch};
use crate::expression::{Condition, Relation, Sides, Variable};
use crate::numerics::root_isolation::{Accuracy, Crossing, GuardError, NODES, Root, Smooth, Start};
use core::cell::Cell;

/// Halvings of a piece: to the spacing of doubles.
const HALVINGS: usize = 53;

/// Beside a root values are smaller than this part of those at the ends of its piece, beside a pole larger.
const NEAR: f64 = 0.01;

/// Values within a shortest piece; a function without poles differs there from a line by less than this part of its ends, one
/// with a pole of even order is greater than at its lesser end by this factor.
const LOOKS: u32 = 64;
const FLAT: f64 = 1e-3;
const POLE: f64 = 8.0;

/// And at least so many.
const LEAST_PATIENCE: u32 = 256;

/// What a condition reads is fitted to this part of it at least, and to its error bound where that is less.
const FINEST: f64 = 1e-10;

/// A difference of this part of what it is at the end of the step is rounding; soon after the start it has its sign.
const ROUNDED: f64 = 1e-6;
const SOON: f64 = 1e-3;

/// Roundoff of a touch, in differences of the sides over the step.
const TOUCHED: f64 = 16.0 * f64::EPSILON;

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
        let sides = watch.is_entire.then(|| step.sides(condition)).flatten();
        let exact = sides.filter(|sides| sides.tail() <= EXACT * of_series(sides));
        let is_told = |sides: &&Sides| sides.end().abs() > of_series(sides);
        watch.end.set(exact.as_ref().filter(is_told).map(Sides::end));
        let start = match watch.sign {
            _ if watch.at_root => Start::Root,
            Some(positive) if condition.relation() == Relation::Equal => Start::Continues { positive },
            sign if was_false(condition, sign) && watch.stays => Start::Root,
            _ => Start::Free,
        };
        if start == Start::Free && watch.is_state && watch.sign.is_none() && self.holds_from_zero(step, k) {
            return Ok(Some(0.0));
        }
        let counts = |root: Root| self.counts(k, step, root);
        if let Some(sides) = exact {
            watch.zero.set(of_series(&sides));
            return of_difference(condition, sides.difference(), (start, of_series(&sides)), &counts);
        }
        let (spent, most) = (Cell::new(0), watch.patience.get());
        let found = self.by_values((watch, k), step, start, &|| {
            spent.set(spent.get() + 1);
            spent.get() <= most
        });
        if spent.get() <= most {
            return found;
        }
        let theta = match found {
            Err(GuardError::NotFinite { theta } | GuardError::Unresolved { theta }) => theta,
            Ok(_) => 0.0,
        };
        watch.patience.set((most / 2).max(LEAST_PATIENCE));
        self.undecided.set(self.undecided.get().or(Some(theta)));
        Ok(None)
    }

    /// Whether an equality is met at a root: where the sides only come near each other, they are equal but for rounding. Within the
    /// error bound it is undecided.
    fn counts(&self, k: usize, step: &StepView<'_>, root: Root) -> bool {
        let difference =
            |theta: f64| step.difference(theta, &self.conditions[k], &mut self.values.borrow_mut()).0;
        let size = || [0.0, 0.5, 1.0].map(|theta| difference(theta).abs()).into_iter().fold(0.0, f64::max);
        let rounding = || self.rounding(k, step, &[root.theta]).max(TOUCHED * size());
        let is_met = root.value == 0.0 || root.value.abs() <= rounding();
        if !is_met {
            self.undecided.set(self.undecided.get().or(Some(root.theta)));
        }
        is_met
    }

    /// Whether a condition holds from the start of a phase on, which begins with its sides equal but for rounding: an event at the same
    /// place, a slip that is reversed, may have hidden that it became true.
    fn holds_from_zero(&self, step: &StepView<'_>, k: usize) -> bool {
        let condition = &self.conditions[k];
        let at = |theta: f64| step.difference(theta, condition, &mut self.values.borrow_mut()).0;
        let [first, soon, last] = [0.0, SOON, 1.0].map(at);
        let holds = |difference: f64| match condition.relation() {
            Relation::Equal => false,
            Relation::Less => difference < 0.0,
            Relation::Greater => difference > 0.0,
        };
        holds(first) && holds(soon) && first.abs() <= ROUNDED * last.abs()
    }

    /// The same where nothing has series; `spend` tells whether it may be evaluated once more, and it has no value if not.
    fn by_values(
        &self,
        (watch, k): (&Watch, usize),
        step: &StepView<'_>,
        start: Start,
        spend: &dyn Fn() -> bool,
    ) -> Result<Option<f64>, GuardError> {
        let condition = &self.conditions[k];
        let bound = self.bound(watch, step, &[0.0, 0.5, 1.0]);
        watch.zero.set(bound);
        let value = |theta: f64| match spend() {
            true => step.difference(theta, condition, &mut self.values.borrow_mut()).0,
            false => f64::NAN,
        };
        let is_rounding = |k: usize| {
            let rounding = self.rounding(k, step, &[0.0, 0.5, 1.0]);
            NODES.iter().all(|theta| value(*theta).abs() <= rounding)
        };
        if start == Start::Root && is_rounding(k) {
            self.undecided.set(self.undecided.get().or(Some(0.0)));
            return Ok(None);
        }
        let leaves = if watch.is_noisy { None } else { self.leaves(&condition.reads(), step)? };
        let Some(leaves) = leaves else {
            let accuracy = Accuracy { delta: bound, is_noisy: watch.is_noisy };
            return of_values(condition, &value, (start, accuracy), &|root| self.counts(k, step, root));
        };
        self.of_pieces((k, watch.is_state), (step, &leaves), (&value, spend), (start, bound))
    }

    /// What a condition reads: polynomials of the step where it has them, others fitted more closely than to their error, so
    /// that arguments of steep functions are told apart; none if something has no polynomial that fits it.
    fn leaves(&self, reads: &[Variable], step: &StepView<'_>) -> Result<Option<Leaves>, GuardError> {
        let mut leaves = Vec::with_capacity(reads.len());
        for &variable in reads {
            if let Some(exact) = step.polynomial(variable) {
                leaves.push((variable, exact?));
                continue;
            }
            let mut value = |theta: f64| step.read(theta, variable, &mut self.values.borrow_mut());
            let size = [0.0, 0.5, 1.0].map(|theta| value(theta).abs()).into_iter().fold(0.0, f64::max);
            let Some(fit) = Smooth::fit(&mut value, self.bounds.relative.min(FINEST) * size)? else {
                return Ok(None);
            };
            leaves.push((variable, fit));
        }
        Ok(Some(leaves))
    }

    /// By bounds over pieces of the step; only what they leave open is looked into. Of one that arms or disarms a passage through a
    /// pole counts.
    fn of_pieces(
        &self,
        (k, is_state): (usize, bool),
        (step, leaves): (&StepView<'_>, &Leaves),
        (value, spend): (&dyn Fn(f64) -> f64, &dyn Fn() -> bool),
        (start, bound): (Start, f64),
    ) -> Result<Option<f64>, GuardError> {
        let condition = &self.conditions[k];
        let enclosure = |piece: [f64; 2]| {
            if !spend() {
                return None;
            }
            step.enclosure(condition, leaves, piece)
        };
        let known = leaves.iter().map(|(_, smooth)| smooth.resolution()).fold(1.0, f64::min);
        let shortest = known.max(SHORTEST);
        let (mut start, mut side) = (start, None);
        let mut look = |[from, to]: [f64; 2], known: Bounded| {
            let is_monotone = known == Bounded::Monotone;
            let first = value(from);
            let begins = if from == 0.0 { start } else { after(condition, start, (side, first), bound) };
            if first.abs() > bound {
                side = Some(first > 0.0);
            }
            let within = |s: f64| value(from + (to - from) * s);
            let at = |s: f64| from + (to - from) * s;
            let continues = begins != Start::Continues { positive: within(0.0) <= 0.0 };
            if is_monotone
                && continues
                && let Some(passes) = passed(&within, bound)
            {
                start = begins;
                let counts = passes && is_wanted(condition, &within);
                return Ok(counts.then(|| at(halved(&within)[1])));
            }
            // What is not resolved in so short a piece is a pole or a jump.
            let jumps = !is_monotone && to - from <= shortest;
            let accuracy = Accuracy { delta: bound, is_noisy: jumps || is_monotone };
            let counts = |root: Root| self.counts(k, step, root.map_theta(at));
            let found = match of_values(condition, &within, (begins, accuracy), &counts) {
                Err(_) if jumps && [0.0, 1.0].map(within).iter().all(|end| end.is_finite()) => None,
                found => found.map_err(|error| error.at(at))?,
            };
            let found = found.filter(|s| !jumps || is_near(&within, *s, bound));
            let found = found.or_else(|| changed(condition, &within, bound));
            // Well behind the pole: its time is known to some roundings.
            let passes = jumps && is_state && found.is_none() && passed(&within, bound) == Some(true);
            if passes && is_wanted(condition, &within) {
                return Ok(Some((to + shortest).min(1.0)));
            }
            if jumps && found.is_none() && may_hide(&within, known) {
                self.undecided.set(self.undecided.get().or(Some(from)));
            }
            start = begins;
            Ok(found.map(at))
        };
        match (Pieces { enclosure: &enclosure, value, bound, shortest }).follow(&mut look)? {
            Followed::Event(event) => Ok(event),
            Followed::Unbounded => {
                of_values(condition, value, (start, bound.into()), &|root| self.counts(k, step, root))
            }
        }
    }
}

/// By values alone.
fn of_values(
    condition: &Condition,
    value: &dyn Fn(f64) -> f64,
    (start, accuracy): (Start, Accuracy),
    counts: &dyn Fn(Root) -> bool,
) -> Result<Option<f64>, GuardError> {
    let Accuracy { delta, is_noisy } = accuracy;
    let negated = |theta: f64| -value(theta);
    let source = |value| GuardSource::Values { value, size: 0.0, is_noisy };
    match condition.relation() {
        Relation::Equal => vanishes(&source(value), start, delta, counts),
        Relation::Less => falls(&source(value), start, delta),
        Relation::Greater => falls(&source(&negated), start, delta),
    }
}

/// Whether a condition that compares was false up to a step, before its sides came so near that they may be equal.
fn was_false(condition: &Condition, sign: Option<bool>) -> bool {
    match condition.relation() {
        Relation::Equal => false,
        Relation::Less => sign == Some(true),
        Relation::Greater => sign == Some(false),
    }
}

/// Whether the values in a shortest piece may hide a root: they have the same sign at both ends, and do not lie on a line as
/// those of a function without a pole do, or grow from both sides as towards a pole of even order.
fn may_hide(value: &dyn Fn(f64) -> f64, known: Bounded) -> bool {
    let [first, last] = [value(0.0), value(1.0)];
    if first * last <= 0.0 || !(first.is_finite() && last.is_finite()) {
        return false;
    }
    let (mut bent, mut most) = (0.0_f64, 0.0_f64);
    for k in 1..LOOKS {
        let theta = f64::from(k) / f64::from(LOOKS);
        let inner = value(theta);
        bent = bent.max((inner - (first + theta * (last - first))).abs());
        most = most.max(if inner.is_finite() { inner * first.signum() } else { f64::INFINITY });
    }
    let [least, size] = [first.abs().min(last.abs()), first.abs().max(last.abs())];
    (known == Bounded::Pole || bent > FLAT * size) && most < POLE * least
}

/// Whether the values at the ends of a piece are on different sides of zero; none where one is within its bound.
fn passed(value: &dyn Fn(f64) -> f64, bound: f64) -> Option<bool> {
    let [first, last] = [value(0.0), value(1.0)];
    (first.abs() > bound && last.abs() > bound).then_some(first * last < 0.0)
}

/// Whether a passage from one end to the other is one that the condition asks for.
fn is_wanted(condition: &Condition, value: &dyn Fn(f64) -> f64) -> bool {
    match condition.relation() {
        Relation::Equal => true,
        Relation::Less => value(0.0) > value(1.0),
        Relation::Greater => value(0.0) < value(1.0),
    }
}

/// The places on both sides of a change of sign.
fn halved(value: &dyn Fn(f64) -> f64) -> [f64; 2] {
    let (first, [mut low, mut high]) = (value(0.0), [0.0, 1.0]);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        let before = (value(middle) > 0.0) == (first > 0.0);
        *(if before { &mut low } else { &mut high }) = middle;
    }
    [low, high]
}

/// Where the values at the ends of a piece are beyond their bound on different sides, and become so through zero, not a pole:
/// what is lost in the rounding of a steep function.
fn changed(condition: &Condition, value: &dyn Fn(f64) -> f64, bound: f64) -> Option<f64> {
    if !(passed(value, bound)? && is_wanted(condition, value)) {
        return None;
    }
    let ends = halved(value);
    ends.iter().all(|end| is_near(value, *end, bound)).then_some(ends[1])
}

/// Whether a value is near zero, compared with those at the ends of its piece.
fn is_near(value: &dyn Fn(f64) -> f64, at: f64, bound: f64) -> bool {
    value(at).abs() <= bound.max(NEAR * value(0.0).abs().min(value(1.0).abs()))
}

/// How a later piece begins: at the root that is known at the start of the step, until the condition has left it, or at one that a
/// comparison, false on the side that it was on before, has come to between the pieces.
fn after(condition: &Condition, before: Start, (side, value): (Option<bool>, f64), bound: f64) -> Start {
    match before {
        Start::Root if value.abs() <= bound => Start::Root,
        _ if condition.relation() == Relation::Equal => Start::Continues { positive: value > 0.0 },
        _ if value.abs() <= bound && was_false(condition, side) => Start::Root,
        _ => Start::Free,
    }
}

fn of_difference(
    condition: &Condition,
    difference: &[f64],
    (start, bound): (Start, f64),
    counts: &dyn Fn(Root) -> bool,
) -> Result<Option<f64>, GuardError> {
    match condition.relation() {
        Relation::Equal => vanishes(&GuardSource::Series(difference), start, bound, counts),
        Relation::Less => falls(&GuardSource::Series(difference), start, bound),
        Relation::Greater => {
            let negated: Vec<f64> = difference.iter().map(|c| -c).collect();
            falls(&GuardSource::Series(&negated), start, bound)
        }
    }
}

/// The first root of a difference that counts.
fn vanishes(
    difference: &GuardSource<'_>,
    start: Start,
    bound: f64,
    counts: &dyn Fn(Root) -> bool,
) -> Result<Option<f64>, GuardError> {
    let (mut from, mut begins, mut advance) = (0.0, start, Advance::BEGUN);
    while from < 1.0 {
        let Some(root) = difference.find_root(from, begins, (0.0, bound))? else { return Ok(None) };
        if counts(root) {
            return Ok(Some(root.theta));
        }
        (from, begins) = (advance.behind(root.theta, from), Start::Root);
    }
    Ok(None)
}

/// Where a difference first falls through zero: from a known root, or from above, to which it may have to rise first. What only
/// touches zero has not fallen.
fn falls(difference: &GuardSource<'_>, start: Start, bound: f64) -> Result<Option<f64>, GuardError> {
    let (mut from, mut begins, mut advance) = (0.0, start, Advance::BEGUN);
    while from < 1.0 {
        let next = match difference.watch(from, begins, bound)? {
            Crossing::Clear => return Ok(None),
            Crossing::At { theta } => return Ok(Some(theta)),
            Crossing::LeavesAtStart if from == 0.0 && start == Start::Root => return Ok(Some(0.0)),
            Crossing::LeavesAtStart => difference.first_root(from, Start::Root, (0.0, bound))?,
            Crossing::Touch { theta, .. } => Some(theta),
        };
        let Some(next) = next else { return Ok(None) };
        (from, begins) = (advance.behind(next, from), Start::Root);
    }
    Ok(None)
}

#[cfg(test)]
mod tests;
