//! Impacts: all contacts with g = 0 answer at once, then the accelerations decide.

use nalgebra::{DMatrix, DVector};

use crate::contact::impulse::{Collision, CollisionError, Outcome, Row};
use crate::contact::{ContactError, ReducedCollision, labels, singular};
use crate::context::{Numbers, without_rounding};
use crate::event::detection::LOW;
use crate::event::{EventKind, ImpactOrder, Note};
use crate::model::{ContactSet, Layout, SlipState};
use crate::numerics::zero::SOLVED;
use crate::simulation::RunCause;
use crate::simulation::decide::DecisionInput;
use crate::simulation::snapshot::{Snapshot, split};
use crate::system::Equations;
use crate::trajectory::LoggedDecision;

/// What an impact does, what it may gain, J, and the contacts of which the order of simultaneous
/// impacts matters.
struct Impact {
    outcome: Outcome,
    allowed: f64,
    order: Option<ImpactOrder>,
}

impl Snapshot<'_> {
    /// The impact of contacts whose gaps close.
    pub(super) fn resolve_impact(&mut self, closing: ContactSet) -> Result<(), RunCause> {
        if self.meets_smoothly(closing) {
            return self.meet(closing);
        }
        let (before, found) = (self.closed(), self.pre_impact());
        self.contacts.take_hold(closing);
        let equations = self.setup.context.system().equations(&self.state);
        let present = self.present(closing, &equations);
        let Impact { outcome, allowed, order } = self.strike(present, &equations)?;
        self.refuse_gain(&found.energy, allowed)?;
        let acting = outcome.acting.iter().fold(closing, |set, &i| set.with(i));
        // Those that were closed before pass an impulse on; of open ones within their bounds those
        // that have one are struck.
        let struck = acting.difference(before.difference(closing));
        let (threads, supports) = split(self.layout(), struck);
        let gained = self.gained(&outcome).map(Note::EnergyGained);
        let note = gained.or(self.log_order(order, struck.len() > 1));
        for (kind, set) in [(EventKind::Impact, supports), (EventKind::Taut, threads)] {
            if !set.is_empty() {
                let shown = acting.union(self.both_ways_struck(&outcome));
                let parts = (Some(found.clone()), &outcome.impulses);
                self.record_impact(kind, set, shown, parts, note.clone());
            }
        }
        self.record_rebounds(before, &outcome);
        self.follow_flights(present, &outcome)
    }

    /// The impact of what is present; that of a contact that presses on no other takes no search.
    fn strike(&mut self, present: ContactSet, equations: &Equations<f64>) -> Result<Impact, RunCause> {
        let (rows, rates) = (self.rows(present), self.known_rates());
        if let Some(mut outcome) = self.single(&rows, equations, &rates) {
            self.follow_impact(&rates, &mut outcome, present)?;
            return Ok(Impact {
                allowed: allowed_gain(equations.prescribed_gap_rate(), &outcome),
                outcome,
                order: None,
            });
        }
        let collision = collision(equations, (&rates, DVector::zeros(rates.len())), rows);
        let outcome = self.collide(&collision, present)?;
        let order = impact_order(self.layout(), &collision, &outcome);
        Ok(Impact { allowed: allowed_gain(equations.prescribed_gap_rate(), &outcome), outcome, order })
    }

    fn single(&self, rows: &[Row], equations: &Equations<f64>, rates: &[f64]) -> Option<Outcome> {
        let (mass, jacobian) = (|i, j| equations.mass(i)[j], |i, j| equations.jacobian(i)[j]);
        let struck = ReducedCollision {
            rows,
            mass,
            jacobian,
            prescribed_gap_rate: equations.prescribed_gap_rate(),
            rates,
        };
        if self.layout().has_hinges() { None } else { struck.outcome() }
    }

    /// Logs the order of impacts that matters; a note on an event of several struck contacts.
    fn log_order(&mut self, order: Option<ImpactOrder>, on_event: bool) -> Option<Note> {
        let order = order?;
        self.log(LoggedDecision::ImpactOrder(order.clone()));
        on_event.then_some(Note::ImpactOrder(order))
    }

    /// An impulse from outside.
    pub(super) fn apply_impulse(&mut self, applied: DVector<f64>, note: Note) -> Result<(), RunCause> {
        let (before, found) = (self.closed(), self.pre_impact());
        let equations = self.setup.context.system().equations(&self.state);
        let present = self.present(ContactSet::EMPTY, &equations);
        let collision = collision(&equations, (&self.known_rates(), applied), self.rows(present));
        let outcome = self.collide(&collision, present)?;
        let order = impact_order(self.layout(), &collision, &outcome);
        self.log_order(order, false);
        let acting = outcome.acting.iter().copied().collect();
        let all = ContactSet::ALL;
        let parts = (Some(found), &outcome.impulses);
        self.record_impact(EventKind::Impulse, acting, all, parts, Some(note));
        self.record_rebounds(before, &outcome);
        self.follow_flights(present, &outcome)
    }

    /// Contacts with g = 0: the closed ones, those that close, and open ones within the error bound
    /// of their gap, in a low flight a part of its height. A drive that waits is there from its own
    /// event on.
    pub(super) fn present(&self, closing: ContactSet, equations: &Equations<f64>) -> ContactSet {
        let usual = self.gap_bounds();
        let bound = |i: usize| {
            let flight = self.bounces.heights.iter().find(|(contact, _)| *contact == i);
            flight.map_or(f64::INFINITY, |(_, height)| LOW * height).min(usual(i))
        };
        let off = self.find_beyond_end().union(self.contacts.waiting());
        let zero = |i: &usize| {
            equations.gap()[*i].abs() <= bound(*i)
                && !self.contacts.absent().contains(*i)
                && !off.contains(*i)
        };
        let acting = self.closed().union(closing);
        let near: ContactSet =
            (0..self.layout().contacts.len()).filter(|i| !acting.contains(*i)).filter(zero).collect();
        // A gap that is least here opens along every motion, and its row is rounding.
        let least = if near.is_empty() { near } else { self.find_stationary_gaps(near).least };
        acting.union(near.difference(least))
    }

    /// The collision of what is present, without an impulse from outside.
    pub(super) fn collision(&self, present: ContactSet, equations: &Equations<f64>) -> Collision {
        let rates = self.known_rates();
        collision(equations, (&rates, DVector::zeros(rates.len())), self.rows(present))
    }

    /// Rates without the roundoff of zero.
    fn known_rates(&self) -> Numbers {
        let (context, n) = (&self.setup.context, self.layout().coordinates.len());
        let unit = |i: usize| context.scales.entry(self.layout(), n + i);
        (0..n).map(|i| without_rounding(self.state[n + i], unit(i))).collect()
    }

    fn rows(&self, present: ContactSet) -> Vec<Row> {
        let (guides, slips) = (self.contacts.guides(), self.slip_states());
        (0..self.layout().rows()).map(|row| self.row(row, (present, guides), &slips)).collect()
    }

    fn row(&self, row: usize, (present, guides): (ContactSet, ContactSet), slips: &[SlipState<f64>]) -> Row {
        let held = self.contacts.held();
        let (contacts, joints) = (self.layout().contacts.len(), self.layout().joints.len());
        if row >= contacts + joints {
            let of = self.layout().tangents[row - contacts - joints];
            let friction = self.layout().contacts[of].friction;
            friction.map_or(Row::Tangent { of }, |entry| self.rubbing(of, entry, slips[entry].kinetic))
        } else if row < contacts && self.layout().contacts[row].is_hinge() {
            Row::Open
        } else if guides.contains(row) {
            Row::Guide
        } else if row >= contacts || held.contains(row) {
            Row::TwoSided
        } else if present.contains(row) {
            Row::Contact { restitution: self.restitution(row), law: self.layout().contacts[row].law }
        } else {
            Row::Open
        }
    }

    /// What holds both ways and bears a part of the impulses: guides, drives that have taken hold,
    /// held supports.
    pub(super) fn both_ways_struck(&self, outcome: &Outcome) -> ContactSet {
        let held = self.contacts.held().union(self.contacts.guides());
        held.iter().filter(|&i| outcome.impulses[i] != 0.0).collect()
    }

    /// The part of a slip's row in a collision, with its μ.
    pub(super) fn rubbing(&self, of: usize, entry: usize, mu: f64) -> Row {
        let restitution = self.setup.restitution.get(self.layout().contacts.len() + entry);
        Row::Friction { of, mu, restitution: restitution.copied().unwrap_or(0.0) }
    }

    /// The energy that a law of impact has gained by more than rounding, J.
    pub(super) fn gained(&self, outcome: &Outcome) -> Option<f64> {
        let scales = &self.setup.context.scales;
        let natural = scales.force() * scales.length;
        let rubs = self.layout().frictions.iter().any(|friction| outcome.impulses[friction.row] != 0.0);
        Some(outcome.gained).filter(|gained| rubs && *gained > SOLVED * natural)
    }

    /// What the collision does, and the phase that follows.
    fn collide(&mut self, collision: &Collision, present: ContactSet) -> Result<Outcome, RunCause> {
        let most = self.setup.budget.trials;
        let system = self.setup.context.system();
        let struck = (self.setup.parts.laws.strike)(system, &self.state, collision, most);
        let mut outcome = struck.map_err(|error| self.collision_error(error, present))?;
        self.follow_impact(collision.rates.as_slice(), &mut outcome, present)?;
        Ok(outcome)
    }

    /// The state after an impact, exactly zero where contacts stay closed, and the phase that
    /// follows.
    fn follow_impact(
        &mut self,
        before: &[f64],
        outcome: &mut Outcome,
        present: ContactSet,
    ) -> Result<(), RunCause> {
        self.round_openings(before, outcome);
        if !outcome.unique {
            self.log(LoggedDecision::ImpulsesNotUnique);
        }
        if outcome.solutions > 1 {
            self.log(LoggedDecision::SeveralImpacts(outcome.solutions));
        }
        if outcome.factor < 1.0 {
            self.log(LoggedDecision::RestitutionScaled(outcome.factor));
        }
        let stays = |i: &usize| outcome.opening[*i] == 0.0;
        let touching = present.iter().filter(stays).collect();
        self.proceed(&outcome.rates, touching)
    }

    /// A contact does not open at a speed that the rounding of the pose makes of zero, relative to
    /// the fastest motion before.
    fn round_openings(&self, before: &[f64], outcome: &mut Outcome) {
        let (layout, scales) = (self.layout(), &self.setup.context.scales);
        let n = layout.coordinates.len();
        let natural = |i: usize| before[i].abs() / scales.entry(layout, n + i);
        let fastest = (0..n).map(natural).fold(1.0, f64::max);
        for (row, speed) in outcome.opening.iter_mut().enumerate() {
            *speed = without_rounding(*speed, fastest * layout.unit(row, scales.length) / scales.time);
        }
    }

    /// Records what an impact has opened: undecided where a contact that it leaves at rest opens by
    /// an acceleration that the rounding of the pose makes of zero.
    fn record_rebounds(&mut self, before: ContactSet, outcome: &Outcome) {
        let recorded = self.transition.events.len();
        self.record_changes(before);
        let rests = |i: &usize| outcome.opening[*i] == 0.0;
        let opened: ContactSet = before.difference(self.closed()).iter().filter(rests).collect();
        if opened.is_empty() {
            return;
        }
        let (context, layout) = (&self.setup.context, self.layout());
        let scales = context.scales.moving_at(layout, self.rates());
        let a = self.accelerations(&self.state, self.active_basis());
        let equations = context.system().equations(&self.state);
        let rounded = |i: usize| {
            let unit = scales.acceleration() * layout.unit(i, scales.length) / scales.length;
            without_rounding(equations.gap_acceleration(i, &a), unit) == 0.0
        };
        if opened.iter().any(rounded) {
            self.mark_undecided(recorded);
        }
    }

    /// Continues with these rates and contacts.
    pub(super) fn proceed(&mut self, rates: &DVector<f64>, touching: ContactSet) -> Result<(), RunCause> {
        let touching = touching.union(self.contacts.guides());
        let (n, rounding) = (rates.len(), self.rounding_of_the_way());
        self.state[n..2 * n].copy_from_slice(rates.as_slice());
        self.onset.is_struck = true;
        (self.state, _) = self.project(touching, rounding, false)?;
        self.go_on(DecisionInput::about(touching))
    }

    pub(super) fn collision_error(&self, error: CollisionError, present: ContactSet) -> RunCause {
        let contacts = labels(self.layout(), present);
        let model = &self.setup.context.model;
        self.contact_error(match error {
            CollisionError::Jammed => ContactError::Impulses { contacts },
            CollisionError::Several => ContactError::Several { contacts },
            CollisionError::Exhausted => ContactError::Undecided { contacts },
            CollisionError::Singular | CollisionError::Dimensions => singular(model, &self.state, present),
        })
    }
}

/// The energy that an impact may gain, J: what its law has told, and the work of moving surfaces
/// and drives, −Σ P ∂g/∂t.
pub(super) fn allowed_gain(drift: &[f64], outcome: &Outcome) -> f64 {
    let work: f64 = outcome.impulses.iter().zip(drift).map(|(impulse, drift)| impulse * drift).sum();
    outcome.gained.max(0.0) - work
}

fn collision(
    equations: &Equations<f64>,
    (rates, applied): (&[f64], DVector<f64>),
    rows: Vec<Row>,
) -> Collision {
    let (n, r) = (rates.len(), rows.len());
    Collision {
        mass: DMatrix::from_fn(n, n, |i, j| equations.mass(i)[j]),
        jacobian: DMatrix::from_fn(r, n, |i, j| equations.jacobian(i)[j]),
        rates: DVector::from_row_slice(rates),
        prescribed_gap_rate: DVector::from_row_slice(equations.prescribed_gap_rate()),
        applied,
        rows,
    }
}

/// The contacts of which the order of simultaneous impacts matters, if there are any.
fn impact_order(layout: &Layout, collision: &Collision, outcome: &Outcome) -> Option<ImpactOrder> {
    let pairs = collision.kinetic_angles(&outcome.acting).into_iter();
    let pairs: Vec<_> = pairs.map(|(pair, angle)| (pair.map(|i| layout.contacts[i].label), angle)).collect();
    (!pairs.is_empty()).then_some(ImpactOrder { pairs })
}
