//! The first time in a step that a condition becomes true.

mod pieces;

use core::cell::Cell;

use self::pieces::{Followed, PieceRegularity, Pieces};
use super::watch::{Findings, Kind, Tracking, Watch};
use crate::event::detection::advance::Advance;
use crate::event::detection::guard_source::{EXACT, GuardSource};
use crate::event::detection::sample::Quantities;
use crate::event::detection::sampled_step::SampledStep;
use crate::event::detection::step::Leaves;
use crate::event::detection::{Guard, SHORTEST};
use crate::expression::{Condition, Relation, Sides};
use crate::numerics::root_isolation::{Accuracy, Crossing, GuardError, NODES, Root, RootStart, Smooth};
use crate::numerics::zero::{MARGIN, SOLVED, roundoff};
use smallvec::SmallVec;

/// Halvings of a piece: to the spacing of doubles.
const HALVINGS: usize = 53;

/// Beside a root values are smaller than this part of those at the ends of its piece, beside a pole
/// larger.
const NEAR: f64 = 0.01;

/// Values within a shortest piece; a function without poles differs there from a line by less than
/// this part of its ends, one with a pole of even order is greater than at its lesser end by this
/// factor.
const LOOKS: u32 = 64;
const FLAT: f64 = 1e-3;
const POLE: f64 = 8.0;

/// A condition is evaluated so often in a step at most, or bounded over a piece of it. Beyond, it
/// is undecided whether it is met there, and less is tried in the steps that follow, but at least
/// so much.
const PATIENCE: u32 = 100_000;
const LEAST_PATIENCE: u32 = 256;

/// What a condition reads is fitted to this part of it at least, and to its error bound where that
/// is less.
const FINEST: f64 = 1e-10;

/// The part of a step after which a difference of the sides that begins at zero has its sign.
const SOON: f64 = 1e-3;

/// A condition that ends the run or starts something planned.
pub(super) struct ConditionGuard<'a> {
    condition: &'a Condition,
    /// Whether it arms or disarms: what holds or not on either side of a pole is then there or not.
    is_state: bool,
    /// Whether series of its sides show by their size how well they converge.
    is_entire: bool,
    /// Whether the difference of its sides is above zero at the end of the last step.
    sign: Option<bool>,
    /// Whether a comparison has ended the last step at zero: it is on the side that it came from.
    stays: bool,
    /// The difference at the end of the step, if its series is known there to be beyond its bound.
    end: Option<f64>,
    /// What counted as zero in the step.
    zero: f64,
    /// How often it is evaluated in a step at most.
    patience: u32,
}

impl<'a> ConditionGuard<'a> {
    /// Of the condition with a place among those of the run.
    pub(super) fn watch(place: usize, condition: &'a Condition, is_state: bool) -> Watch<'a> {
        Watch::new(Guard::Condition(place), Quantities::NONE, Self::new(condition, is_state))
    }

    fn new(condition: &'a Condition, is_state: bool) -> Self {
        Self {
            condition,
            is_state,
            is_entire: condition.is_entire(),
            sign: None,
            stays: false,
            end: None,
            zero: 0.0,
            patience: PATIENCE,
        }
    }

    /// When it becomes true.
    fn find_met(
        &mut self,
        search: &ConditionSearch<'_>,
        tracking: &Tracking,
    ) -> Result<Option<f64>, GuardError> {
        let ConditionSearch { condition, step, .. } = *search;
        let of_series = |sides: &Sides| step.scales.bounds.relative * sides.size();
        let sides = self.is_entire.then(|| step.view.sides(condition)).flatten();
        let exact = sides.filter(|sides| sides.tail() <= EXACT * of_series(sides));
        let is_told = |sides: &&Sides| sides.end().abs() > of_series(sides);
        self.end = exact.as_ref().filter(is_told).map(Sides::end);
        let start = match self.sign {
            _ if tracking.at_root => RootStart::Root,
            Some(positive) if condition.relation() == Relation::Equal => RootStart::Continues { positive },
            sign if was_false(condition, sign) && self.stays => RootStart::Root,
            _ => RootStart::Free,
        };
        if start == RootStart::Free && self.is_state && self.sign.is_none() && search.holds_from_zero() {
            return Ok(Some(0.0));
        }
        if let Some(sides) = exact {
            self.zero = of_series(&sides);
            let counts = |root: Root| search.counts(root);
            return of_difference(condition, sides.difference(), (start, self.zero), &counts);
        }
        self.zero = tracking.bound(self, step, &[0.0, 0.5, 1.0]);
        let found = search.find_by_values(start, self.zero);
        if search.spent.get() <= search.most {
            return found;
        }
        let theta = match found {
            Err(GuardError::NotFinite { theta } | GuardError::Unresolved { theta }) => theta,
            Ok(_) => 0.0,
        };
        self.patience = (search.most / 2).max(LEAST_PATIENCE);
        search.note_undecided(theta);
        Ok(None)
    }
}

impl Kind for ConditionGuard<'_> {
    fn value(&self, step: &SampledStep<'_>, theta: f64) -> f64 {
        step.difference(theta, self.condition).0
    }

    /// The median of the larger side over the sample times, so that a pole does not dominate.
    fn size(&self, step: &SampledStep<'_>, at: &[f64]) -> f64 {
        let least = find_rounding(self.condition, step, at) / step.scales.bounds.relative;
        let sizes = at.iter().map(|&theta| step.difference(theta, self.condition).1);
        middle(sizes.collect()).map_or(least, |size| size.max(least))
    }

    fn begin(&mut self, start: &SampledStep<'_>) -> Option<bool> {
        let (value, size) = start.difference(0.0, self.condition);
        let is_equal = value.abs() <= start.scales.bounds.relative * size;
        Some(is_equal || value.abs() <= find_rounding(self.condition, start, &[0.0]))
    }

    fn find_event(
        &mut self,
        tracking: &Tracking,
        step: &SampledStep<'_>,
        findings: &mut Findings,
    ) -> Option<Result<Option<f64>, GuardError>> {
        let search = ConditionSearch {
            condition: self.condition,
            step,
            is_state: self.is_state,
            is_noisy: tracking.is_noisy,
            most: self.patience,
            spent: Cell::new(0),
            undecided: Cell::new(findings.undecided),
        };
        let found = self.find_met(&search, tracking);
        findings.undecided = search.undecided.get();
        Some(found)
    }

    fn may_arrive(&self, _: &SampledStep<'_>) -> bool {
        false
    }

    /// An equation and an event may be about one quantity, located by different means: the event
    /// then keeps it at zero.
    fn precedence(&self) -> f64 {
        if self.condition.relation() == Relation::Equal { SOLVED } else { 0.0 }
    }

    fn leave_step(&mut self, tracking: &Tracking, step: &SampledStep<'_>) {
        let value = self.end.take().unwrap_or_else(|| self.value(step, 1.0));
        self.stays = self.condition.relation() != Relation::Equal
            && (value.abs() <= self.zero || tracking.is_zero(self, step, 1.0));
        // A step that begins and ends at zero tells between them where it came from.
        let inner = || [0.0, 0.5].map(|theta| self.value(step, theta));
        let came_from =
            || self.sign.unwrap_or_else(|| inner().iter().find(|x| x.abs() > self.zero) > Some(&0.0));
        self.sign = Some(if self.stays { came_from() } else { value > 0.0 });
    }
}

/// The least rounding of a condition at the given times: it grows beyond all bounds towards poles.
fn find_rounding(condition: &Condition, step: &SampledStep<'_>, at: &[f64]) -> f64 {
    let rounding = |&theta: &f64| step.evaluate(|view, scratch| view.rounding(theta, condition, scratch));
    at.iter().map(rounding).reduce(f64::min).unwrap_or(0.0)
}

/// The one in the middle, the greater of two.
fn middle(mut sizes: SmallVec<[f64; 4]>) -> Option<f64> {
    sizes.sort_unstable_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied()
}

/// A search for the first time in a step that a condition becomes true.
struct ConditionSearch<'s> {
    condition: &'s Condition,
    step: &'s SampledStep<'s>,
    is_state: bool,
    is_noisy: bool,
    /// How often it may be evaluated, and has been.
    most: u32,
    spent: Cell<u32>,
    /// Where it may hide a root.
    undecided: Cell<Option<f64>>,
}

impl ConditionSearch<'_> {
    fn note_undecided(&self, theta: f64) {
        self.undecided.set(self.undecided.get().or(Some(theta)));
    }

    /// Whether it may be evaluated once more.
    fn may_spend(&self) -> bool {
        self.spent.set(self.spent.get() + 1);
        self.spent.get() <= self.most
    }

    fn difference(&self, theta: f64) -> f64 {
        self.step.difference(theta, self.condition).0
    }

    /// The difference, no number if it may not be evaluated once more.
    fn value(&self, theta: f64) -> f64 {
        if self.may_spend() { self.difference(theta) } else { f64::NAN }
    }

    /// Whether an equality is met at a root: where the sides only come near each other, they are
    /// equal but for rounding. Within the error bound it is undecided.
    fn counts(&self, root: Root) -> bool {
        let size =
            || [0.0, 0.5, 1.0].map(|theta| self.difference(theta).abs()).into_iter().fold(0.0, f64::max);
        let rounding =
            || find_rounding(self.condition, self.step, &[root.theta]).max(roundoff(16.0) * size());
        let is_met = root.value == 0.0 || root.value.abs() <= rounding();
        if !is_met {
            self.note_undecided(root.theta);
        }
        is_met
    }

    /// Whether the condition holds from the start of a phase on, which begins with its sides equal
    /// but for rounding: an event at the same place, a slip that is reversed, may have hidden that
    /// it became true.
    fn holds_from_zero(&self) -> bool {
        let [first, soon, last] = [0.0, SOON, 1.0].map(|theta| self.difference(theta));
        let holds = |difference: f64| match self.condition.relation() {
            Relation::Equal => false,
            Relation::Less => difference < 0.0,
            Relation::Greater => difference > 0.0,
        };
        holds(first) && holds(soon) && first.abs() <= MARGIN * last.abs()
    }

    /// Where nothing has series.
    fn find_by_values(&self, start: RootStart, bound: f64) -> Result<Option<f64>, GuardError> {
        let is_rounding = || {
            let rounding = find_rounding(self.condition, self.step, &[0.0, 0.5, 1.0]);
            NODES.iter().all(|theta| self.value(*theta).abs() <= rounding)
        };
        if start == RootStart::Root && is_rounding() {
            self.note_undecided(0.0);
            return Ok(None);
        }
        let leaves = if self.is_noisy { None } else { self.leaves()? };
        match leaves {
            Some(leaves) => self.find_by_pieces(&leaves, start, bound),
            None => self.find_by_values_alone(start, Accuracy { delta: bound, is_noisy: self.is_noisy }),
        }
    }

    fn find_by_values_alone(&self, start: RootStart, accuracy: Accuracy) -> Result<Option<f64>, GuardError> {
        let (value, counts) = (|theta: f64| self.value(theta), |root: Root| self.counts(root));
        of_values(self.condition, &value, (start, accuracy), &counts)
    }

    /// What the condition reads: polynomials of the step where it has them, others fitted more
    /// closely than to their error, so that arguments of steep functions are told apart; none if
    /// something has no polynomial that fits it.
    fn leaves(&self) -> Result<Option<Leaves>, GuardError> {
        let mut leaves = Leaves::new();
        for variable in self.condition.reads() {
            if let Some(exact) = self.step.view.polynomial(variable) {
                leaves.push((variable, exact?));
                continue;
            }
            let mut value = |theta: f64| {
                self.step.evaluate(|view, scratch| view.evaluate_variable(theta, variable, scratch))
            };
            let size = [0.0, 0.5, 1.0].map(|theta| value(theta).abs()).into_iter().fold(0.0, f64::max);
            let finest = self.step.scales.bounds.relative.min(FINEST);
            let Some(fit) = Smooth::fit(&mut value, finest * size)? else { return Ok(None) };
            leaves.push((variable, fit));
        }
        Ok(Some(leaves))
    }

    /// By bounds over pieces of the step; only what they leave open is looked into. Of one that
    /// arms or disarms a passage through a pole counts.
    fn find_by_pieces(
        &self,
        leaves: &Leaves,
        mut start: RootStart,
        bound: f64,
    ) -> Result<Option<f64>, GuardError> {
        let condition = self.condition;
        let enclosure = |piece: [f64; 2]| {
            self.may_spend().then(|| self.step.view.enclosure(condition, leaves, piece)).flatten()
        };
        let known = leaves.iter().map(|(_, smooth)| smooth.resolution()).fold(1.0, f64::min);
        let shortest = known.max(SHORTEST);
        let mut side = None;
        let mut look = |[from, to]: [f64; 2], known: PieceRegularity| {
            let is_monotone = known == PieceRegularity::Monotone;
            let first = self.value(from);
            let begins = if from == 0.0 { start } else { after(condition, start, (side, first), bound) };
            if first.abs() > bound {
                side = Some(first > 0.0);
            }
            let within = |s: f64| self.value(from + (to - from) * s);
            let at = |s: f64| from + (to - from) * s;
            let continues = begins != RootStart::Continues { positive: within(0.0) <= 0.0 };
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
            let counts = |root: Root| self.counts(root.map_theta(at));
            let found = match of_values(condition, &within, (begins, accuracy), &counts) {
                Err(_) if jumps && [0.0, 1.0].map(within).iter().all(|end| end.is_finite()) => None,
                found => found.map_err(|error| error.map_theta(at))?,
            };
            let found = found.filter(|s| !jumps || is_near(&within, *s, bound));
            let found = found.or_else(|| changed(condition, &within, bound));
            // Well behind the pole: its time is known to some roundings.
            let passes = jumps && self.is_state && found.is_none() && passed(&within, bound) == Some(true);
            if passes && is_wanted(condition, &within) {
                return Ok(Some((to + shortest).min(1.0)));
            }
            if jumps && found.is_none() && may_hide(&within, known) {
                self.note_undecided(from);
            }
            start = begins;
            Ok(found.map(at))
        };
        let value = |theta: f64| self.value(theta);
        match (Pieces { enclosure: &enclosure, value: &value, bound, shortest }).follow(&mut look)? {
            Followed::Event(event) => Ok(event),
            Followed::Unbounded => self.find_by_values_alone(start, bound.into()),
        }
    }
}

/// By values alone.
fn of_values(
    condition: &Condition,
    value: &dyn Fn(f64) -> f64,
    (start, accuracy): (RootStart, Accuracy),
    counts: &dyn Fn(Root) -> bool,
) -> Result<Option<f64>, GuardError> {
    let (Accuracy { delta, is_noisy }, negated) = (accuracy, |theta: f64| -value(theta));
    let value = if condition.relation() == Relation::Greater { &negated } else { value };
    find_first(condition, &GuardSource::Values { value, size: 0.0, is_noisy }, (start, delta), counts)
}

/// Whether a condition that compares was false up to a step, before its sides came so near that
/// they may be equal.
fn was_false(condition: &Condition, sign: Option<bool>) -> bool {
    match condition.relation() {
        Relation::Equal => false,
        Relation::Less => sign == Some(true),
        Relation::Greater => sign == Some(false),
    }
}

/// Whether the values in a shortest piece may hide a root: they have the same sign at both ends,
/// and do not lie on a line as those of a function without a pole do, or grow from both sides as
/// towards a pole of even order.
fn may_hide(value: &dyn Fn(f64) -> f64, known: PieceRegularity) -> bool {
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
    (known == PieceRegularity::Pole || bent > FLAT * size) && most < POLE * least
}

/// Whether the values at the ends of a piece are on different sides of zero; none where one is
/// within its bound.
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

/// Where the values at the ends of a piece are beyond their bound on different sides, and become so
/// through zero, not a pole: what is lost in the rounding of a steep function.
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

/// How a later piece begins: at the root that is known at the start of the step, until the
/// condition has left it, or at one that a comparison, false on the side that it was on before, has
/// come to between the pieces.
fn after(
    condition: &Condition,
    before: RootStart,
    (side, value): (Option<bool>, f64),
    bound: f64,
) -> RootStart {
    match before {
        RootStart::Root if value.abs() <= bound => RootStart::Root,
        _ if condition.relation() == Relation::Equal => RootStart::Continues { positive: value > 0.0 },
        _ if value.abs() <= bound && was_false(condition, side) => RootStart::Root,
        _ => RootStart::Free,
    }
}

fn of_difference(
    condition: &Condition,
    difference: &[f64],
    (start, bound): (RootStart, f64),
    counts: &dyn Fn(Root) -> bool,
) -> Result<Option<f64>, GuardError> {
    let negated: Vec<f64>;
    let mut series = difference;
    if condition.relation() == Relation::Greater {
        negated = difference.iter().map(|c| -c).collect();
        series = &negated;
    }
    find_first(condition, &GuardSource::Series(series), (start, bound), counts)
}

/// The first time that a condition is met by a difference, negated where it is to rise.
fn find_first(
    condition: &Condition,
    difference: &GuardSource<'_>,
    (start, bound): (RootStart, f64),
    counts: &dyn Fn(Root) -> bool,
) -> Result<Option<f64>, GuardError> {
    match condition.relation() {
        Relation::Equal => vanishes(difference, start, bound, counts),
        _ => falls(difference, start, bound),
    }
}

/// The first root of a difference that counts.
fn vanishes(
    difference: &GuardSource<'_>,
    start: RootStart,
    bound: f64,
    counts: &dyn Fn(Root) -> bool,
) -> Result<Option<f64>, GuardError> {
    let (mut from, mut begins, mut advance) = (0.0, start, Advance::BEGUN);
    while from < 1.0 {
        let Some(root) = difference.find_root(from, begins, (0.0, bound))? else { return Ok(None) };
        if counts(root) {
            return Ok(Some(root.theta));
        }
        (from, begins) = (advance.behind(root.theta, from), RootStart::Root);
    }
    Ok(None)
}

/// Where a difference first falls through zero: from a known root, or from above, to which it may
/// have to rise first. What only touches zero has not fallen.
fn falls(difference: &GuardSource<'_>, start: RootStart, bound: f64) -> Result<Option<f64>, GuardError> {
    let (mut from, mut begins, mut advance) = (0.0, start, Advance::BEGUN);
    while from < 1.0 {
        let next = match difference.watch(from, begins, bound)? {
            Crossing::Clear => return Ok(None),
            Crossing::At { theta } => return Ok(Some(theta)),
            Crossing::LeavesAtStart if from == 0.0 && start == RootStart::Root => return Ok(Some(0.0)),
            Crossing::LeavesAtStart => difference.first_root(from, RootStart::Root, (0.0, bound))?,
            Crossing::Touch { theta, .. } => Some(theta),
        };
        let Some(next) = next else { return Ok(None) };
        (from, begins) = (advance.behind(next, from), RootStart::Root);
    }
    Ok(None)
}

#[cfg(test)]
mod tests;
