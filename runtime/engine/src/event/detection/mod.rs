//! The guards of a phase over one step: reactions of closed contacts, gaps of open ones, feet of closed corners, of contacts
//! with friction the limits of those that stick and the slip velocities of those that slide, and the conditions that are
//! waited for.

mod advance;
mod affine;
mod condition;
mod first;
mod guard_source;
mod known;
mod low_flight;
mod memo;
mod pieces;
mod rubbing;
mod signals;
mod step;
mod watch;
mod zero;

#[cfg(test)]
mod tests;

pub(crate) use affine::{AffineGuards, KnownAffineGuards};
pub(crate) use signals::{Broken, Signal, Signals, Unseen};
pub(crate) use step::StepView;
pub(crate) use watch::ContactStatus;

use std::cell::{Cell, RefCell};

use crate::context::Numbers;
use crate::expression::{Condition, Relation, Variable};
use crate::model::{ContactSet, Layout, Side, Slip};
use crate::numerics::root_isolation::{GuardError, NODES};
use known::Known;
use memo::Memo;
use smallvec::SmallVec;
use step::{Kinds, Values};
use watch::{Watch, guards};

/// The fraction of a flight's height that counts as zero.
pub(crate) const LOW: f64 = 1.0 / 64.0;
/// Where a guard that began a step at zero is looked at: a flight may be over in a single step.
const WITHIN: [f64; 4] = [1.0, 0.75, 0.5, 0.25];

/// What is watched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Guard {
    /// The reaction of a closed contact.
    Reaction(usize),
    /// s N of a guide with friction that presses to a side: at zero it changes the side.
    Side(usize, Side),
    /// The gap of an open contact.
    Gap(usize),
    /// −g of a closed contact that depends on those that bear: below zero it depended on them only where the phase began.
    Parting(usize),
    /// A foot of a contact: how far it is from the end of its bar.
    Foot {
        /// The contact.
        contact: usize,
        /// The entry of the model's feet.
        entry: usize,
    },
    /// μₛ |N| + σ R of a contact that sticks: at zero it begins to slide with the sense σ.
    Limit(Rub),
    /// How far contacts that share their load are from slipping together.
    Grip,
    /// σ v of a contact that slides with the sense σ: at zero it stops.
    Slip(Rub),
    /// A condition that ends the run or starts something planned.
    Condition(usize),
}

/// A contact with friction, and a sense in which it slides or may slide.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rub {
    /// The contact.
    pub contact: usize,
    /// The entry of the model's frictions.
    pub friction: usize,
    /// The sense.
    pub slip: Slip,
    /// The side that it presses to.
    pub side: Side,
}

impl Guard {
    /// The contact whose gap it is, if it is one.
    pub(crate) fn gap(self) -> Option<usize> {
        if let Self::Gap(contact) = self { Some(contact) } else { None }
    }

    /// The contact that it watches, if it is of one.
    pub(crate) fn contact(&self) -> Option<usize> {
        match *self {
            Self::Reaction(contact)
            | Self::Side(contact, _)
            | Self::Gap(contact)
            | Self::Parting(contact) => Some(contact),
            Self::Foot { contact, .. }
            | Self::Limit(Rub { contact, .. })
            | Self::Slip(Rub { contact, .. }) => Some(contact),
            Self::Grip | Self::Condition(_) => None,
        }
    }
}

/// Error bounds of the guards, relative to natural scales.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounds {
    pub(crate) relative: f64,
    pub(crate) length: f64,
}

/// What happens in a step.
#[derive(Debug, Default)]
pub(crate) struct StepEvents {
    /// Guards that touch zero, before the first event.
    pub(crate) touches: Vec<(f64, Guard)>,
    /// The first event, and all guards that are within their bound of zero there.
    pub(crate) first: Option<(f64, Vec<Guard>)>,
}

/// All guards of a phase.
pub(crate) struct EventDetector<'a> {
    list: Vec<Watch>,
    conditions: &'a [Condition],
    bounds: Bounds,
    layout: &'static Layout,
    forces: &'a [f64],
    slips: &'a [f64],
    /// What rounding makes of each gap in the step, in its own unit; none where that is less than any of their bounds.
    roundings: Numbers,
    values: RefCell<Values>,
    known: Known,
    memo: Memo,
    /// The guard that was not resolved.
    unresolved: Option<Guard>,
    /// Where a condition may hide a root beside a pole in the last step.
    undecided: Cell<Option<f64>>,
}

impl<'a> EventDetector<'a> {
    /// Of a phase in which the contacts of a set bear; with each condition that is located whether it arms or disarms.
    pub(crate) fn new(
        layout: &'static Layout,
        set: ContactSet,
        roles: ContactStatus<'a>,
        (conditions, located): (&'a [Condition], &[(usize, bool)]),
        bounds: Bounds,
    ) -> Self {
        let mut list = Vec::with_capacity(layout.contacts.len() + located.len());
        guards(layout, &set, &roles, &mut |guard| {
            list.push(Watch::of(guard, list.len(), &roles, conditions))
        });
        for &(k, is_state) in located {
            let watch = Watch::of(Guard::Condition(k), list.len(), &roles, conditions);
            list.push(Watch { is_state, ..watch });
        }
        let ContactStatus { forces, slips, .. } = roles;
        let values = RefCell::new(Values::of(layout));
        let (known, undecided) = (Known::of(list.len()), Cell::new(None));
        let memo = Memo::default();
        Self {
            list,
            conditions,
            bounds,
            layout,
            forces,
            slips,
            roundings: Numbers::new(),
            values,
            known,
            memo,
            unresolved: None,
            undecided,
        }
    }

    /// From now on the guard that was not resolved is taken for noise where it turns too often to be followed.
    pub(crate) fn expect_noise(&mut self) {
        let noisy = |watch: &&mut Watch| self.unresolved == Some(watch.guard);
        self.list.iter_mut().filter(noisy).for_each(|watch| watch.is_noisy = true);
    }

    /// The power of friction at the nodes of the last step, where all of it is known from the guards.
    pub(crate) fn friction_powers(&self) -> Option<&[f64; NODES.len()]> {
        self.known.powers()
    }

    /// The work of friction over a step up to `end`, where the method has the series of all that it takes.
    pub(crate) fn friction_work(&self, step: &StepView<'_>, end: f64) -> Option<f64> {
        let (at_rest, relative) = (self.known.at_rest()?, self.bounds.relative);
        step.friction_work(end, at_rest, &|contact, [force, slip], at_rest| {
            let slow = self.layout.contacts[contact].friction.map_or(0.0, |k| self.slips[k]);
            let fastest = (slip[0] - at_rest).abs() + slip[1..].iter().map(|term| term.abs()).sum::<f64>();
            // Where nothing slips the force does no work, however well it is known.
            let share = if fastest <= relative * slow { 1.0 } else { relative };
            guard_source::is_exact(force, share * self.forces[contact])
                && guard_source::is_exact(slip, relative * slow)
        })
    }

    /// The guard of the last step that was not resolved.
    pub(crate) fn unresolved(&self) -> Option<Guard> {
        self.unresolved
    }

    /// Where in the last step it was not decided whether a condition is met, if it was not.
    pub(crate) fn undecided(&self) -> Option<f64> {
        self.undecided.get()
    }

    /// Contacts whose gaps close at a place of a step at which they are seen to be below zero, and
    /// have not been seen to be above since the phase began.
    pub(crate) fn unseen_landings(&self, step: &StepView<'_>, theta: f64, guards: &[Guard]) -> ContactSet {
        let is_unseen = |watch: &&Watch| {
            let is_gap = matches!(watch.guard, Guard::Gap(_)) && guards.contains(&watch.guard);
            is_gap && watch.at_root && self.value(step, watch, theta) < -0.5 * self.bound(watch, step, &[])
        };
        self.list.iter().filter(is_unseen).filter_map(|watch| watch.guard.gap()).collect()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Marks the guards that are zero at the start of the phase as known roots; `start` is a dense output at rest there.
    pub(crate) fn begin(&mut self, start: &StepView<'_>) {
        if self.list.iter().all(|watch| watch.guard != Guard::Grip) {
            self.known.begin(start, self.values.get_mut());
        }
        let kinds = Kinds::of(self.list.iter().map(|watch| watch.guard));
        if kinds.any() {
            start.sample(0.0, kinds, self.values.get_mut());
        }
        let least = self.least_bound();
        let known = self.values.get_mut();
        if kinds.gaps {
            self.roundings = start.context.roundings(&known.state, least);
        }
        let values: Numbers = self.list.iter().map(|watch| known.get(watch.guard)).collect();
        for k in 0..self.list.len() {
            let value = values[k];
            self.list[k].limit = start.limit(self.list[k].guard, self.values.get_mut());
            // A flight that begins so deep has its ground there.
            let height = &mut self.list[k].height;
            *height = height.max(2.0 * (-value).max(0.0) / LOW);
            self.list[k].at_root = match self.list[k].guard {
                Guard::Condition(condition) => self.is_met_at_start(condition, start),
                _ => value.abs() <= self.bound(&self.list[k], start, &[]),
            };
        }
    }

    /// The height of the lowest flight that the phase begins with; zero if a guard is zero there of which nothing is known.
    pub(crate) fn lowest_flight(&self) -> f64 {
        let zero = self.list.iter().filter(|watch| watch.at_root);
        let heights = zero.map(|watch| if watch.height.is_finite() { watch.height } else { 0.0 });
        heights.reduce(f64::min).unwrap_or(0.0)
    }

    /// Everything in (0, 1] up to the first event. On the last step a guard that has fallen to zero within rounding at its end
    /// counts as well: no later step would find it.
    pub(crate) fn examine(&mut self, step: &StepView<'_>, is_last: bool) -> Result<StepEvents, GuardError> {
        if let Some(roundings) = step.roundings(self.least_bound(), self.values.get_mut()) {
            self.roundings = roundings;
        }
        self.sample(step);
        let mut findings = StepEvents::default();
        let mut decisive: SmallVec<[(f64, Guard); 4]> = SmallVec::new();
        self.undecided.set(None);
        self.unresolved = None;
        for k in 0..self.list.len() {
            let touches = findings.touches.len();
            let event = match self.event(&self.list[k], step, &mut findings.touches) {
                Ok(event) => event,
                Err(error) => {
                    self.unresolved = Some(self.list[k].guard);
                    if !step.is_bridge() {
                        return Err(error);
                    }
                    findings.touches.truncate(touches);
                    self.as_noise(k, step, &mut findings.touches)
                }
            };
            let watch = &self.list[k];
            let arrival = || (is_last && self.arrives(watch, step)).then_some(1.0);
            decisive.extend(event.or_else(arrival).map(|theta| (theta, watch.guard)));
        }
        if let Some(first) = decisive.iter().map(|(theta, _)| *theta).min_by(f64::total_cmp) {
            findings.touches.retain(|(theta, _)| *theta < first);
            findings.first = Some((first, self.together(step, first, &decisive)));
        }
        findings.touches.sort_by(|a, b| a.0.total_cmp(&b.0));
        self.pass(step, findings.first.as_ref().map_or(1.0, |(theta, _)| theta.min(1.0)));
        // No step follows an event, but what seems one across a singular position may be none.
        if findings.first.is_none() || step.is_bridge() {
            self.leave_roots(step);
        }
        Ok(findings)
    }

    /// The first event of a guard in a step that cannot be made shorter, as far as its samples show it.
    fn as_noise(&mut self, k: usize, step: &StepView<'_>, touches: &mut Vec<(f64, Guard)>) -> Option<f64> {
        let before = core::mem::replace(&mut self.list[k].is_noisy, true);
        let event = self.event(&self.list[k], step, touches);
        self.list[k].is_noisy = before;
        event.unwrap_or(None)
    }

    /// The first event of a guard.
    fn event(
        &self,
        watch: &Watch,
        step: &StepView<'_>,
        touches: &mut Vec<(f64, Guard)>,
    ) -> Result<Option<f64>, GuardError> {
        if watch.is_clear {
            return Ok(None);
        }
        match watch.guard {
            Guard::Condition(k) => self.condition(watch, k, step),
            Guard::Gap(contact) => self.first_closure(watch, contact, step, touches),
            Guard::Reaction(_)
            | Guard::Side(..)
            | Guard::Parting(_)
            | Guard::Foot { .. }
            | Guard::Limit(_)
            | Guard::Grip
            | Guard::Slip(_) => self.first_downcrossing(watch, step, 0.0, touches),
        }
    }

    /// Which corners are below their bars at `end`, having come there from beyond the ends.
    fn pass(&mut self, step: &StepView<'_>, end: f64) {
        for k in 0..self.list.len() {
            let watch = &self.list[k];
            let Some(contact) = watch.guard.gap() else { continue };
            if self.layout.contacts[contact].foot.is_none() || watch.is_clear {
                self.list[k].passed = false;
                continue;
            }
            if self.is_above(watch, step, end) {
                self.list[k].passed = false;
                self.list[k].passes.set(None);
                continue;
            }
            let value = self.value(step, watch, end);
            let deep = value < -self.bound(watch, step, &[]);
            let came =
                watch.passed || watch.off && deep || watch.passes.get().is_some_and(|theta| theta <= end);
            let passed = value < 0.0 && (came || self.margin(step, contact, end) <= self.end());
            self.list[k].passed = passed;
            self.list[k].passes.set(None);
        }
    }

    /// Corners below their bars, which they have come to from beyond the ends.
    pub(crate) fn passed(&self) -> ContactSet {
        let passed = self.list.iter().filter(|watch| watch.passed);
        passed.filter_map(|watch| watch.guard.gap()).collect()
    }

    /// Keeps what the next step needs to know of the end of this one.
    fn leave_roots(&mut self, step: &StepView<'_>) {
        for k in 0..self.list.len() {
            self.list[k].order = None;
            let watch = &self.list[k];
            let is_condition = matches!(watch.guard, Guard::Condition(_));
            let contact = watch.guard.gap();
            let is_followed =
                is_condition || contact.is_some_and(|i| self.layout.contacts[i].kind.is_drive());
            if watch.at_root || is_followed || watch.flight.is_some() {
                let value = watch.end.take().unwrap_or_else(|| self.value(step, watch, 1.0));
                let within = |theta: &f64| self.is_zero(watch, step, *theta);
                let at_root = watch.at_root && WITHIN.iter().all(within);
                let flight = watch.flight.filter(|_| self.is_low(value)).zip(contact);
                let flight = flight.map(|(flight, contact)| self.follow(flight, contact, step));
                let stays = matches!(watch.guard, Guard::Condition(k) if self.conditions[k].relation() != Relation::Equal)
                    && (value.abs() <= watch.zero.get() || self.is_zero(watch, step, 1.0));
                let came_from = || watch.sign.unwrap_or_else(|| self.value(step, watch, 0.0) > 0.0);
                let side = if stays { came_from() } else { value > 0.0 };
                let sign = is_followed.then_some(side);
                let watch = &mut self.list[k];
                (watch.sign, watch.at_root, watch.flight) = (sign, at_root, flight);
                watch.stays = stays;
            }
        }
    }
}
