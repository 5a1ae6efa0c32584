//! What happens at one instant: impacts, openings, what is done from outside.

use super::guards::Guard;
use super::{Action, Change, Follower, NotJudged, Number, Touch};
use crate::decision;
use crate::expansion::Expansion;
use crate::impact::collide;
use liftoff_core::scalar::{Real, Scalar};

impl Follower<'_> {
    /// Takes in what has become zero.
    pub(super) fn pass(&mut self, guards: &[Guard]) -> Result<(), NotJudged> {
        let mut slid = Vec::new();
        let mut struck = Vec::new();
        for guard in guards {
            match *guard {
                Guard::Gap(i) => struck.push(i),
                Guard::Reaction(_) | Guard::Met(_) | Guard::Over(_) => {}
                Guard::Foot(i) => {
                    slid.push(i);
                    self.touches[i] = Touch::Beyond;
                }
            }
        }
        slid.dedup();
        if self.ends(guards, &struck) {
            return Ok(());
        }
        if guards.iter().any(|guard| !matches!(guard, Guard::Met(_) | Guard::Over(_))) {
            self.change(&struck, slid)?;
        }
        self.answer(guards)
    }

    fn change(&mut self, struck: &[usize], slid: Vec<usize>) -> Result<(), NotJudged> {
        let before = self.closed();
        self.collide(struck, None)?;
        self.decide()?;
        if !slid.is_empty() {
            self.record(Change::SlideOff, slid);
        }
        self.record_openings(&before);
        Ok(())
    }

    fn record_openings(&mut self, before: &[usize]) {
        let open = |&i: &usize| matches!(self.touches[i], Touch::Open(order) if order != 1);
        let opened: Vec<usize> = before.iter().copied().filter(open).collect();
        if !opened.is_empty() {
            self.record(Change::Open, opened);
        }
    }

    /// Contacts that approach at the start are struck.
    pub(super) fn strike_at_start(&mut self) -> Result<(), NotJudged> {
        let touching = self.find_contacts(|touch| touch == Touch::Open(1));
        let struck: Vec<usize> = touching.into_iter().filter(|&i| self.rate(i) < -self.still()).collect();
        if struck.is_empty() { Ok(()) } else { self.collide(&struck, None) }
    }

    fn rate(&self, contact: usize) -> f64 {
        Expansion::new(self.scene, &self.state).rate(&self.scene.contacts[contact].row).to_f64()
    }

    /// The impact of contacts whose gaps have become zero, if they approach.
    fn collide(&mut self, struck: &[usize], applied: Option<&[Number]>) -> Result<(), NotJudged> {
        let still = self.still();
        let approaching: Vec<usize> = struck.iter().copied().filter(|&i| self.rate(i) < -still).collect();
        struck.iter().for_each(|&i| self.touches[i] = Touch::Resting);
        if approaching.is_empty() && applied.is_none() {
            return Ok(());
        }
        let touching =
            self.find_contacts(|touch| matches!(touch, Touch::Bearing(_) | Touch::Idle | Touch::Resting));
        let none = vec![Number::ZERO; self.scene.n()];
        let answer =
            collide(self.scene, &self.state, (&self.held(), &touching), applied.unwrap_or(&none), false);
        let settles = applied.is_none() && self.beats(&approaching, &answer);
        let answer = match settles {
            true => {
                self.rest();
                collide(self.scene, &self.state, (&self.held(), &touching), &none, true)
            }
            false => answer,
        };
        let answer = self.decided(answer)?;
        self.state.v = answer.v;
        self.leave(&touching);
        if applied.is_some() {
            self.record(Change::Impulse, approaching);
        } else {
            self.record(if settles { Change::Settle } else { Change::Impact }, approaching);
        }
        Ok(())
    }

    /// Which of the contacts that touched have speed, and which rest.
    fn leave(&mut self, touching: &[usize]) {
        let still = self.still();
        let rates: Vec<f64> = touching.iter().map(|&i| self.rate(i)).collect();
        for (&i, rate) in touching.iter().zip(rates) {
            self.touches[i] = if rate > still { Touch::Open(1) } else { Touch::Resting };
        }
        let resting = self.find_contacts(|touch| matches!(touch, Touch::Resting | Touch::Held));
        self.scene.project(&mut self.state, &self.scene.slots(&resting));
    }

    /// Which of the contacts that rest stay closed.
    pub(super) fn decide(&mut self) -> Result<(), NotJudged> {
        let resting =
            self.find_contacts(|touch| matches!(touch, Touch::Bearing(_) | Touch::Idle | Touch::Resting));
        if resting.is_empty() {
            return Ok(());
        }
        let decision = self.decided(decision::decide(self.scene, &self.state, (&self.held(), &resting)))?;
        for (i, order) in decision.bearing {
            self.touches[i] = Touch::Bearing(order);
        }
        for i in decision.idle {
            self.touches[i] = Touch::Idle;
        }
        for (i, order) in decision.opening {
            self.touches[i] = Touch::Open(order);
        }
        Ok(())
    }

    /// Does what is done from outside.
    pub(super) fn act(&mut self, action: &Action) -> Result<(), NotJudged> {
        let before = self.closed();
        match action {
            Action::Remove(names) => {
                let mut removed = Vec::new();
                for name in names {
                    let place = self.scene.contacts.iter().position(|contact| contact.name == *name);
                    let i = place.ok_or_else(|| NotJudged::Name(name.clone()))?;
                    self.touches[i] = Touch::Removed;
                    removed.push(i);
                }
                self.decide()?;
                self.record(Change::Remove, removed);
            }
            Action::Impulse { point, impulse } => {
                let place = self.scene.names.iter().position(|name| name == point);
                let i = place.ok_or_else(|| NotJudged::Name(point.clone()))?;
                let applied = self.generalised(i, *impulse);
                self.collide(&[], Some(&applied))?;
                self.decide()?;
            }
        }
        self.record_openings(&before);
        Ok(())
    }

    /// ∂P/∂qᵀ F by the rates of P for unit speeds.
    fn generalised(&self, point: usize, impulse: [f64; 2]) -> Vec<Number> {
        let mut tape = self.scene.tape.clone();
        let gradients = self.scene.points[point].map(|part| tape.gradient(part));
        let mut series = crate::tape::Series::new(&tape);
        let inputs = crate::tape::Inputs {
            t: self.state.t,
            positions: self.state.q.iter().map(|&q| vec![q]).collect(),
            rates: self.state.v.iter().map(|&v| vec![v]).collect(),
        };
        series.extend(&tape, crate::tape::Level::Position, 0, &inputs);
        let mut applied = vec![Number::ZERO; self.scene.n()];
        for (gradient, component) in gradients.into_iter().zip(impulse) {
            for (i, node) in gradient {
                applied[i] = applied[i] + series.get(node, 0) * Number::from_f64(component);
            }
        }
        applied
    }
}
