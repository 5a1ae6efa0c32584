//! A system and its phase in which everything is a given function of time, with a contact of every
//! kind.

use core::cell::RefCell;
use core::sync::atomic::{AtomicUsize, Ordering};
use std::sync::Arc;

use liftoff_fixtures::Particle;

use super::super::guards::Watch;
use super::super::sampled_step::{SampledStep, Scales};
use super::super::samples::Samples;
use super::super::{ContactStatus, EventDetector, Guard, GuardBounds, StepView};
use crate::context::{Numbers, RunContext, scales_of};
use crate::expression::Condition;
use crate::integrate::Guards;
use crate::model::*;
use crate::numerics::root_isolation::GuardError;
use crate::series::ORDERS;
use crate::system::{DenseOutput, Equations, Model, PhaseEquations, PhaseInfo, System};

pub(crate) const CONTACTS: usize = 8;
pub(crate) const FRICTIONS: usize = 3;
const ROWS: usize = CONTACTS + FRICTIONS;

/// The contacts by what they are.
pub(crate) const PLAIN: usize = 0;
pub(crate) const RUBBING: usize = 1;
pub(crate) const GUIDE: usize = 2;
pub(crate) const CORNER: usize = 3;
pub(crate) const THREAD: usize = 4;
pub(crate) const DRIVE: usize = 5;
pub(crate) const TURN: usize = 6;
pub(crate) const HINGE: usize = 7;

const fn contact(label: &'static str, kind: ContactKind, friction: Option<usize>) -> Contact {
    Contact {
        label,
        supports: &[],
        shared: false,
        foot: None,
        kind,
        rough: false,
        friction,
        jams: false,
        law: Law::Newton,
        stop: false,
        armed: None,
        breaks: None,
    }
}

const fn friction(contact: usize, row: usize) -> Friction {
    Friction { contact, row, follows_slip: false }
}

pub(crate) static LAYOUT: Layout = Layout::new("Given")
    .coordinates(&[Coordinate { name: "s", is_angle: false }, Coordinate { name: "z", is_angle: false }])
    .contacts(&[
        contact("plain", ContactKind::Support, None),
        contact("rubbing", ContactKind::Support, Some(0)),
        contact("guide", ContactKind::Guide, Some(1)),
        Contact { foot: Some(0), ..contact("corner", ContactKind::Support, None) },
        contact("thread", ContactKind::Thread, None),
        contact("drive", ContactKind::Drive, None),
        contact("turn", ContactKind::Turn, None),
        contact("hinge", ContactKind::Hinge { force: [0, 0] }, Some(2)),
    ])
    .tangents(&[RUBBING, GUIDE, HINGE])
    .frictions(&[friction(RUBBING, CONTACTS), friction(GUIDE, CONTACTS + 1), friction(HINGE, CONTACTS + 2)])
    .closed_forms(&[ContactSet::EMPTY]);

/// What there is at one time.
#[derive(Clone, Default)]
pub(crate) struct Shown {
    /// Reactions, then friction forces.
    pub(crate) reactions: [f64; ROWS],
    pub(crate) gaps: [f64; CONTACTS],
    /// v and μₛ.
    pub(crate) slips: [[f64; 2]; FRICTIONS],
    pub(crate) feet: [f64; 2],
    /// g̈.
    pub(crate) curvatures: [f64; CONTACTS],
    /// The coordinate z and its rate.
    pub(crate) z: [f64; 2],
}

/// The coordinate s is the time.
struct Given {
    info: PhaseInfo,
    at: Box<dyn Fn(f64) -> Shown + Send + Sync>,
    asked: Arc<AtomicUsize>,
}

impl System for Given {
    fn layout(&self) -> &'static Layout {
        &LAYOUT
    }

    fn equations(&self, state: &[f64]) -> Equations<f64> {
        let mut bias = [0.0; ROWS];
        bias[..CONTACTS].copy_from_slice(&(self.at)(state[0]).curvatures);
        Equations::from_kernel(&Kernel::<f64, 2, ROWS, { 2 + ROWS }> {
            mass: [[1.0, 0.0], [0.0, 1.0]],
            force: [0.0; 2],
            gap: [0.0; ROWS],
            jacobian: [[0.0; 2]; ROWS],
            bias,
            prescribed_gap_rate: [0.0; ROWS],
            friction: [0.0; ROWS],
        })
    }

    fn gaps(&self, state: &[f64], gaps: &mut [f64]) {
        gaps.copy_from_slice(&(self.at)(state[0]).gaps);
    }

    fn feet(&self, state: &[f64], feet: &mut [f64]) {
        feet.copy_from_slice(&(self.at)(state[0]).feet);
    }

    fn slips(&self, state: &[f64], slips: &mut [SlipState<f64>]) {
        for (slip, [velocity, limit]) in slips.iter_mut().zip((self.at)(state[0]).slips) {
            *slip = SlipState { velocity, kinetic: limit, limit };
        }
    }

    fn solve(&self, _: &[f64], _: ContactSet, accelerations: &mut [f64], multipliers: &mut [f64]) -> bool {
        accelerations.fill(0.0);
        multipliers.fill(0.0);
        true
    }

    fn phase(self: Arc<Self>, _: ContactSet, _: Form) -> Arc<dyn PhaseEquations> {
        self
    }

    fn correction(&self, _: &[f64], _: ContactSet, _: &[f64], change: &mut [f64]) {
        change.fill(0.0);
    }

    fn project(&self, _: ContactSet, _: &mut [f64], _: f64) {}

    fn energy(&self, _: &[f64]) -> Energy<f64> {
        Energy { kinetic: 0.0, potential: 0.0 }
    }

    fn points(&self, _: &[f64], _: &mut [f64]) {}

    fn kinks(&self, _: &[f64], _: &mut [f64]) {}

    fn quantity(&self, _: usize, _: &[f64], _: &[f64], _: &[f64]) -> f64 {
        f64::NAN
    }
}

impl PhaseEquations for Given {
    fn system(&self) -> &dyn System {
        self
    }

    fn info(&self) -> &PhaseInfo {
        &self.info
    }

    fn kept(&self) -> &[usize] {
        &[0]
    }

    fn derivative(&self, _: &[f64], derivative: &mut [f64]) {
        derivative.fill(1.0);
    }

    fn reactions(&self, y: &[f64], reactions: &mut [f64]) {
        self.asked.fetch_add(1, Ordering::Relaxed);
        reactions.copy_from_slice(&(self.at)(y[0]).reactions);
    }

    fn embed(&self, y: &[f64], state: &mut [f64]) {
        let [z, rate] = (self.at)(y[0]).z;
        state.copy_from_slice(&[y[0], z, 1.0, rate]);
    }

    fn pivots(&self, _: &[f64]) -> Pivots<f64> {
        Pivots::collect([])
    }

    fn energy(&self, _: &[f64]) -> Energy<f64> {
        Energy { kinetic: 0.0, potential: 0.0 }
    }
}

/// Error bounds, and natural reactions and slips, each another number.
pub(crate) const BOUNDS: GuardBounds = GuardBounds { relative: 1e-6, length: 2.0 };
pub(crate) const FORCES: [f64; CONTACTS] = [1.0, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 4.0];
pub(crate) const SLIPS: [f64; FRICTIONS] = [0.5, 0.25, 8.0];

/// Where nothing is said of the contacts.
pub(crate) fn roles(closed: ContactSet) -> ContactStatus<'static> {
    ContactStatus { closed, forces: &FORCES, slips: &SLIPS, ..ContactStatus::default() }
}

pub(crate) fn set(contacts: &[usize]) -> ContactSet {
    contacts.iter().fold(ContactSet::EMPTY, |set, &contact| set.with(contact))
}

impl EventDetector<'_> {
    /// A guard that it watches.
    pub(crate) fn find(&self, guard: Guard) -> &Watch<'_> {
        self.list.iter().find(|watch| watch.tracking.guard == guard).expect("it is watched")
    }
}

/// A phase with what is given, from time 0.
pub(crate) struct Scene {
    pub(crate) context: RunContext,
    pub(crate) phase: Arc<dyn PhaseEquations>,
    asked: Arc<AtomicUsize>,
}

/// The first event with its guards, and the touches before.
pub(crate) type Told = (Option<(f64, Vec<Guard>)>, Vec<(f64, Guard)>);

impl Scene {
    pub(crate) fn new(
        (set, form): (ContactSet, Form),
        at: impl Fn(f64) -> Shown + Send + Sync + 'static,
    ) -> Self {
        let asked = Arc::new(AtomicUsize::new(0));
        let info = PhaseInfo { set, form, coordinates: 1, rates: 0, entries: 1, affine: false };
        let given = Arc::new(Given { info, at: Box::new(at), asked: Arc::clone(&asked) });
        let mut model = Model::new(&Particle { m: 1.0, g: 1.0, e: 0.0 });
        let scales = scales_of(&model).expect("natural scales");
        model.system = given.clone();
        Self { context: RunContext { model, scales }, phase: given, asked }
    }

    /// Of guards that are evaluated one by one, with some contacts closed.
    pub(crate) fn closed(set: ContactSet, at: impl Fn(f64) -> Shown + Send + Sync + 'static) -> Self {
        Self::new((set, Form::Reduced), at)
    }

    pub(crate) fn dense(&self, [from, to]: [f64; 2]) -> DenseOutput {
        DenseOutput::series([from, to], &[to], [from, to - from].into_iter())
    }

    pub(crate) fn view<'a>(&'a self, dense: &'a DenseOutput) -> StepView<'a> {
        StepView::new(&self.phase, &self.context, dense)
    }

    /// What is told of a step from 0 to 1 by its samples alone.
    pub(crate) fn look<T>(&self, tell: impl FnOnce(&SampledStep<'_>) -> T) -> T {
        self.look_with(None, tell)
    }

    /// The same with series of the guards.
    pub(crate) fn look_with<T>(
        &self,
        guards: Option<Guards<'_>>,
        tell: impl FnOnce(&SampledStep<'_>) -> T,
    ) -> T {
        let dense = self.dense([0.0, 1.0]);
        let view = self.view(&dense).with_series(guards);
        let scales = Scales {
            bounds: BOUNDS,
            layout: &LAYOUT,
            forces: &FORCES,
            slips: &SLIPS,
            roundings: Numbers::new(),
        };
        tell(&SampledStep { view: &view, samples: &RefCell::new(Samples::new(&LAYOUT)), scales: &scales })
    }

    /// How often reactions were evaluated since this was asked.
    pub(crate) fn asked(&self) -> usize {
        self.asked.swap(0, Ordering::Relaxed)
    }

    pub(crate) fn condition(&self, text: &str) -> Condition {
        Condition::parse(&LAYOUT, text).expect("a condition")
    }

    /// What is watched, as the phase begins.
    pub(crate) fn begun<'a>(
        &self,
        roles: ContactStatus<'a>,
        conditions: (&'a [Condition], bool),
    ) -> EventDetector<'a> {
        let located: Vec<(usize, bool)> = (0..conditions.0.len()).map(|k| (k, conditions.1)).collect();
        let (set, conditions) = (self.phase.info().set, (conditions.0, &located[..]));
        let mut detector = EventDetector::new(&LAYOUT, set, roles, conditions, BOUNDS);
        let start = DenseOutput::still(0.0, &[0.0]);
        detector.begin(&self.view(&start));
        detector
    }

    /// What is found in steps that end at some times, as times.
    pub(crate) fn follow(&self, detector: &mut EventDetector<'_>, ends: &[f64]) -> Result<Told, GuardError> {
        self.follow_by(|view| view, detector, ends)
    }

    /// The same, in steps that are seen otherwise.
    pub(crate) fn follow_by(
        &self,
        seen: impl for<'v> Fn(StepView<'v>) -> StepView<'v>,
        detector: &mut EventDetector<'_>,
        ends: &[f64],
    ) -> Result<Told, GuardError> {
        let (mut from, mut touches) = (0.0, Vec::new());
        for (k, &to) in ends.iter().enumerate() {
            let dense = self.dense([from, to]);
            let found = detector.examine(&seen(self.view(&dense)), k + 1 == ends.len())?;
            let time = |theta: f64| from + (to - from) * theta;
            touches.extend(found.touches.into_iter().map(|(theta, guard)| (time(theta), guard)));
            if let Some((theta, guards)) = found.first {
                return Ok((Some((time(theta), guards)), touches));
            }
            from = to;
        }
        Ok((None, touches))
    }

    /// The time of the first event of the only guard, in the steps that end at some times.
    pub(crate) fn first(&self, roles: ContactStatus<'_>, ends: &[f64]) -> Option<f64> {
        let mut detector = self.begun(roles, (&[], false));
        let (first, _) = self.follow(&mut detector, ends).expect("followed");
        first.map(|(t, guards)| {
            assert_eq!(guards.len(), 1, "{guards:?}");
            t
        })
    }
}

/// A series that ends.
pub(crate) fn padded(c: &[f64]) -> [f64; ORDERS] {
    let mut terms = [0.0; ORDERS];
    terms[..c.len()].copy_from_slice(c);
    terms
}

/// z is a function of time, and nothing touches.
pub(crate) fn from_function(z: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Scene {
    Scene::closed(ContactSet::EMPTY, move |t| Shown { z: [z(t), f64::NAN], ..Shown::default() })
}

/// Nothing is there but what is waited for.
pub(crate) fn waits() -> ContactStatus<'static> {
    ContactStatus { removed: (0..CONTACTS).collect(), ..roles(ContactSet::EMPTY) }
}

/// When a condition becomes true in steps that end at some times.
pub(crate) fn met(scene: &Scene, text: &str, is_state: bool, steps: &[f64]) -> Option<f64> {
    let conditions = [scene.condition(text)];
    let mut detector: EventDetector<'_> = scene.begun(waits(), (&conditions, is_state));
    let (first, _) = scene.follow(&mut detector, steps).expect("followed");
    first.map(|(t, _)| t)
}
