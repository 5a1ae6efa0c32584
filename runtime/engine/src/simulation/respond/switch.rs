//! Contacts, springs and loads that come and go on conditions.

use smallvec::smallvec;
use std::sync::Arc;

use crate::context::Numbers;
use crate::event::{EventKind, Note};
use crate::expression::{Condition, Switch, Switched};
use crate::integration::phase_point::PhasePoint;
use crate::model::{ContactSet, Form};
use crate::simulation::RunCause;
use crate::simulation::snapshot::Snapshot;

/// Part of the natural time over which the slope of a condition is a difference.
const MOMENT: f64 = 1e-6;

impl Snapshot<'_> {
    /// Arms and disarms what conditions have been met for.
    pub(super) fn switch(&mut self, met: &[(usize, bool)]) -> Result<(), RunCause> {
        self.switch_loads(met)?;
        self.switch_contacts(met)
    }

    /// Springs and loads begin or cease to act: forces jump, and with them reactions may.
    fn switch_loads(&mut self, met: &[(usize, bool)]) -> Result<(), RunCause> {
        let before = self.closed();
        let mut changed = Vec::new();
        for &(switch, arms) in met {
            let Switch { switched, conditions } = &self.setup.rules.switches[switch];
            let Switched::Loads(i) = *switched else { continue };
            let entry = self.layout().switch(i);
            self.state[entry] = f64::from(u8::from(arms));
            changed.push((switched.label(self.layout()), arms, conditions[usize::from(!arms)].clone()));
        }
        if changed.is_empty() {
            return Ok(());
        }
        self.go_on(self.question())?;
        self.refuse_chatter(met, |switched| matches!(switched, Switched::Loads(_)))?;
        for (label, arms, condition) in changed {
            let kind = if arms { EventKind::Arm } else { EventKind::Disarm };
            self.record(kind, ContactSet::EMPTY, Some(Note::Condition(condition)));
            if let Some(event) = self.transition.events.last_mut() {
                event.supports = label.split(", ").collect();
            }
        }
        self.record_changes(before);
        Ok(())
    }

    /// Refuses loads or contacts that turn the motion back across the border of their condition.
    fn refuse_chatter(&self, met: &[(usize, bool)], is_asked: fn(&Switched) -> bool) -> Result<(), RunCause> {
        let switches = &self.setup.rules.switches;
        for &(switch, arms) in met.iter().filter(|it| is_asked(&switches[it.0].switched)) {
            let Switch { switched, conditions } = &switches[switch];
            let [behind, here, ahead] = self.margins_along(&conditions[usize::from(arms)]);
            // After a jump the motion is well away from the border.
            let slope = 0.5 * (ahead - behind);
            if here.abs() < slope && ahead > 0.0 {
                let (of, condition) =
                    (switched.label(self.layout()).to_owned(), Box::new(conditions[0].clone()));
                return Err(RunCause::Chatter { t: self.t, of, condition });
            }
        }
        Ok(())
    }

    /// How far a condition holds a moment ago, now and in a moment, along the phase that is decided
    /// on.
    fn margins_along(&self, condition: &Condition) -> [f64; 3] {
        let context = &self.setup.context;
        let phase = context.phase(self.active_basis(), Form::Multipliers);
        let mut rates: Numbers = smallvec![0.0; self.state.len()];
        phase.derivative(&self.state, &mut rates);
        let moment = MOMENT * context.scales.time;
        [-moment, 0.0, moment].map(|dt| {
            let state = self.state.iter().zip(&rates).map(|(x, rate)| rate.mul_add(dt, *x)).collect();
            let point = PhasePoint::new(Arc::clone(&phase), self.closed(), self.t + dt, state);
            condition.margin(context, &point).unwrap_or(0.0)
        })
    }

    /// Arms and disarms contacts. One that is armed below its ground is there once it has come up.
    fn switch_contacts(&mut self, met: &[(usize, bool)]) -> Result<(), RunCause> {
        let switches = &self.setup.rules.switches;
        let of = |arms: bool| -> ContactSet {
            met.iter().filter(|it| it.1 == arms).filter_map(|it| switches[it.0].contact()).collect()
        };
        let (armed, disarmed) =
            (of(true).intersection(self.contacts.absent()), of(false).difference(self.contacts.absent()));
        let note = |arms: bool| {
            let is_it = |it: &&(usize, bool)| it.1 == arms && switches[it.0].contact().is_some();
            let condition = met.iter().find(is_it)?;
            Some(Note::Condition(switches[condition.0].conditions[usize::from(!arms)].clone()))
        };
        let notes = [note(true), note(false)];
        if !disarmed.is_empty() {
            self.disarm(disarmed, notes[1].clone())?;
        }
        if !armed.is_empty() {
            self.contacts.arm(armed);
            self.contacts.set_below(self.contacts.below().union(self.find_below(armed)));
            self.refuse_vanishing()?;
            self.record(EventKind::Arm, armed, notes[0].clone());
            let equations = self.setup.context.system().equations(&self.state);
            let struck = self.present(ContactSet::EMPTY, &equations).intersection(armed);
            let bound = self.relative_bound() * self.setup.context.scales.speed();
            let (met, [mut closing, struck]) =
                (self.met(armed), [-bound, bound].map(|v| self.slower(struck, v)));
            if self.differs(met) {
                closing = closing.union(met);
            }
            let struck = struck.union(met);
            if !closing.is_empty() {
                self.resolve_impact(closing)?;
            } else if !struck.is_empty() {
                let before = self.join(struck)?;
                self.record_changes(before);
            }
        }
        self.refuse_chatter(met, |switched| matches!(switched, Switched::Contact(_)))
    }

    fn disarm(&mut self, disarmed: ContactSet, note: Option<Note>) -> Result<(), RunCause> {
        let bore = !self.closed().intersection(disarmed).is_empty();
        self.contacts.disarm(disarmed);
        let before = self.closed();
        if bore {
            self.go_on(self.question())?;
        }
        self.record(EventKind::Disarm, disarmed, note);
        self.record_changes(before);
        Ok(())
    }

    /// Those of a set with ġ below a speed.
    fn slower(&self, set: ContactSet, speed: f64) -> ContactSet {
        let equations = self.setup.context.system().equations(&self.state);
        set.iter().filter(|&i| equations.gap_rate(i, self.rates()) < speed).collect()
    }
}
