//! The phase that follows, and its integration.

use super::{Driver, OTHER_BRANCH, SMALL_PIVOT};
use crate::chart::{self, Chart};
use crate::contact::{ContactError, Decision, Question, decide, regular};
use crate::error::{RunCause, StartError};
use crate::model::{Array, BarSystem, ContactSet, Form, KernelView};
use crate::moment::Scene;
use crate::project::project;
use crate::segment::{Drive, Outcome};
use crate::simulation::Simulation;
use crate::watch::{Bounds, Roles, Watches};

impl<M: BarSystem> Driver<'_, M> {
    /// The closed contacts from now on, given those whose reaction is zero.
    pub(super) fn decide(&mut self, unloaded: ContactSet) -> Result<(), RunCause> {
        let held = ContactSet(self.held.0 & !self.removed.0);
        let question = Question { touching: self.touching, held, unloaded };
        let scene = &self.setup.scene;
        let decided = match regular::decide(scene, &self.state, &question) {
            Some(decision) => Ok(decision),
            None => decide::<M>(&scene.series, &self.state, &question),
        };
        let Decision { closed, reactions, unique } = decided.map_err(|source| self.contact_error(source))?;
        if !unique {
            self.log("the reactions are not unique; the least-norm ones are given".to_owned());
        }
        (self.closed, self.touching, self.reactions) = (closed, closed, reactions);
        self.choose_form()
    }

    pub(super) fn contact_error(&self, source: ContactError) -> RunCause {
        match self.t {
            0.0 => RunCause::Start(StartError::Contact(source)),
            t => RunCause::Contact { t, source },
        }
    }

    fn choose_form(&mut self) -> Result<(), RunCause> {
        let chart = self.chart();
        self.form = chart.form();
        match chart {
            Chart::Valid => return Ok(()),
            Chart::SmallPivot => self.log(SMALL_PIVOT.to_owned()),
            Chart::OtherBranch => self.log(OTHER_BRANCH.to_owned()),
            Chart::Absent => {}
        }
        self.restore(self.closed)
    }

    fn chart(&self) -> Chart {
        let Simulation { scene, form, tolerance, .. } = self.setup;
        if *form == Form::Projected {
            return Chart::Absent;
        }
        let ground = (&scene.constants, &scene.scales);
        chart::at::<M>(ground, self.closed, &self.state, (self.relative_bound(), *tolerance))
    }

    /// Brings the state on the contacts of a set, unless it would have to jump there.
    pub(super) fn restore(&mut self, set: ContactSet) -> Result<(), RunCause> {
        let Scene { constants, scales, .. } = &*self.setup.scene;
        let mut restored = self.state;
        let mut work = vec![0.0; M::LAYOUT.coordinates.len()];
        project::<M, _>(constants, set, &mut restored, scales.length, &mut work);
        let [positions, rates] = chart::apart::<M>(scales, &self.state, &restored);
        let by = positions.max(rates);
        if by > self.relative_bound().sqrt() {
            let contacts = set.iter().map(|i| M::LAYOUT.contacts[i].label.to_owned()).collect();
            return Err(RunCause::Jump { t: self.t, contacts, by });
        }
        // Not a number where the equations are singular, which the phase tells.
        if !(positions + rates).is_nan() {
            self.state = restored;
        }
        Ok(())
    }

    pub(super) fn advance(&mut self) -> Outcome<M> {
        let Simulation { scene, tolerance, method, .. } = self.setup;
        let bounds = Bounds { relative: self.relative_bound(), length: scene.scales.length };
        let forces = &self.forces();
        let orders = &self.orders();
        let (off, heights) = (self.beyond_end(), &self.flights.heights);
        let roles = Roles { held: self.held, removed: self.removed, off, heights, orders, forces };
        let located = |k: &usize| self.conditions[*k].time(&scene.parameters).is_none() && self.awaited(*k);
        let located: Vec<usize> = (0..self.conditions.len()).filter(located).collect();
        let drive = Drive {
            scene,
            watches: Watches::new::<M>(self.closed, roles, (&self.conditions, &located), bounds),
            tolerance: *tolerance,
            t: self.t,
            horizon: self.horizon(),
            state: self.state,
            observer: &mut *self.observer,
            cancel: self.setup.cancel,
        };
        method.drive(self.closed, self.form, drive)
    }

    /// The size of each reaction: what it is now, or what gives its contact's own mass 1/Wᵢᵢ the natural acceleration.
    fn forces(&self) -> Vec<f64> {
        let scene = &self.setup.scene;
        let kernel = M::kernel(&scene.constants, &self.state);
        let mut change = M::Accelerations::from_fn(|_| 0.0);
        let mass = |contact: usize, d: &mut [f64]| {
            let only = |row| if row == contact { 1.0 } else { 0.0 };
            kernel.correction(M::LAYOUT, ContactSet::EMPTY.with(contact), only, d);
            let row = |i: usize| d[i] * kernel.mass(i).iter().zip(&*d).map(|(m, d)| m * d).sum::<f64>();
            (0..d.len()).map(row).sum::<f64>()
        };
        let force = |(i, reaction): (usize, &f64)| {
            let own = scene.scales.acceleration() * mass(i, change.as_mut());
            let usual = scene.scales.force();
            reaction.abs().max(if own.is_finite() { own.min(usual) } else { usual })
        };
        self.reactions.iter().enumerate().map(force).collect()
    }

    /// Local errors of ten steps, or some roundings.
    pub(super) fn relative_bound(&self) -> f64 {
        (10.0 * self.setup.tolerance).max(64.0 * f64::EPSILON)
    }

    /// Whether all events have happened that the run was to wait for.
    pub(super) fn has_seen_enough(&self) -> bool {
        let (awaited, events) = (&self.setup.occurrences, &self.trajectory.events);
        !awaited.is_empty() && awaited.iter().all(|awaited| events.iter().any(|event| awaited.is(event)))
    }

    /// The next time at which something is to happen: now, where an event has come first.
    pub(super) fn horizon(&self) -> f64 {
        if self.has_seen_enough() {
            return self.t;
        }
        let settling = self.settling.map(|settling| settling.end);
        let times = self.stops().chain(self.planned_times()).chain(settling);
        times.filter(|t| *t >= self.t).fold(self.setup.limit, f64::min)
    }

    pub(super) fn is_held(&self, contact: usize) -> bool {
        self.held.contains(contact) && !self.removed.contains(contact)
    }

    /// Open contacts whose foot is at the end of its bar or beyond.
    pub(super) fn beyond_end(&self) -> ContactSet {
        let scene = &self.setup.scene;
        let feet = M::feet(&scene.constants, &self.state);
        let bound = self.relative_bound() * scene.scales.length;
        let off = |i: &usize| {
            let foot = M::LAYOUT.contacts[*i].foot.filter(|_| !self.closed.contains(*i));
            foot.is_some_and(|k| feet.as_ref()[2 * k..2 * k + 2].iter().any(|margin| *margin <= bound))
        };
        (0..M::LAYOUT.contacts.len()).filter(off).fold(ContactSet::EMPTY, ContactSet::with)
    }

    pub(super) fn stops(&self) -> impl Iterator<Item = f64> {
        let Simulation { conditions, scene, .. } = self.setup;
        conditions.iter().filter_map(|condition| condition.time(&scene.parameters))
    }
}
