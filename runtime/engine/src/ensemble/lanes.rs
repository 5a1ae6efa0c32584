//! Members side by side.

use super::{Member, MemberError};
use crate::assembly::StartError;
use crate::audit::{AuditBounds, energy_finding};
use crate::expression::Output;
use crate::integrate::StepError;
use crate::integration::equilibrium::is_equilibrium;
use crate::integration::phase_point::PhasePoint;
use crate::model::{ContactSet, Energy, Form, Layout};
use crate::scalar::LANES;
use crate::simulation::RunCause;
use crate::simulation::phase_run::absolute_tolerance;
use crate::simulation::{Budget, Simulation};
use crate::system::{LaneConstructor, LaneEnd, LaneGroup, LaneStart};
use crate::trajectory::Work;

/// A guess at the first step, in natural times.
const FIRST: f64 = 0.1;

/// Whether the run can have no event before its end, would use Taylor's method by itself too, and
/// nothing else may end it.
pub(super) fn is_smooth(simulation: &Simulation) -> bool {
    let Simulation { context, plan, ends, begin, form, method, tolerance, budget, cancel, .. } = simulation;
    let layout = context.layout();
    layout.contacts.is_empty()
        && layout.joints.is_empty()
        && !context.scales.damped
        && plan.is_empty()
        && ends.conditions.is_empty()
        && ends.events.is_empty()
        && *begin == 0.0
        && *budget == Budget::default()
        && cancel.is_none()
        && *form == Form::Reduced
        && method.takes_series()
        && *tolerance > 0.0
        && *tolerance < 1.0
        && simulation.time_limit() > 0.0
        && simulation.time_limit().is_finite()
}

/// Members of one tolerance.
pub(super) struct MemberGroup {
    pub(super) tolerance: f64,
    lanes: Box<dyn LaneGroup>,
    members: [Option<Entered>; LANES],
}

/// A member under way: its number, and its energy at the start where nothing works on it.
struct Entered {
    i: usize,
    simulation: Simulation,
    energy: Option<Energy<f64>>,
}

impl MemberGroup {
    /// An empty one for members like this; none where the lanes are those of another model, or
    /// there are none.
    pub(super) fn new(lanes: LaneConstructor, like: &Simulation) -> Option<Self> {
        let lanes = lanes(&like.context.model.parameters, like.tolerance)?;
        let own = is_same(lanes.layout(), like.layout());
        own.then(|| Self { tolerance: like.tolerance, lanes, members: [const { None }; LANES] })
    }

    /// Whether it is for members like this.
    pub(super) fn suits(&self, simulation: &Simulation) -> bool {
        self.tolerance == simulation.tolerance && is_same(self.lanes.layout(), simulation.layout())
    }

    pub(super) fn is_full(&self) -> bool {
        self.lanes.free().is_none()
    }

    pub(super) fn is_empty(&self) -> bool {
        self.lanes.is_empty()
    }

    /// Puts a member into a free lane.
    pub(super) fn enter(&mut self, i: usize, simulation: Simulation) -> Result<(), MemberError> {
        let Some(lane) = self.lanes.free() else { return Err(MemberError::NotRun) };
        let state = simulation.started()?.state;
        let context = &*simulation.context;
        let phase = context.phase(ContactSet::EMPTY, Form::Reduced);
        if !simulation.ends_at_a_time() && is_equilibrium(context, &*phase, &state) {
            return Err(StartError::Equilibrium.into());
        }
        let start = LaneStart {
            parameters: &context.model.parameters,
            state: &state,
            end: simulation.time_limit(),
            absolute: &absolute_tolerance(&*phase, &context.scales, (self.tolerance, 0.0)),
            first_step: FIRST * context.scales.time,
        };
        let entered = self.lanes.enter(lane, &start);
        entered.map_err(|_| RunCause::from(StepError::Floor { t: 0.0, h: 0.0 }))?;
        let energy = context.is_conservative().then(|| context.system().energy(&state));
        self.members[lane] = Some(Entered { i, simulation, energy });
        Ok(())
    }

    /// Steps all members once; reports those that end. One whose energy has changed is run by
    /// itself, which tells why.
    pub(super) fn step(
        &mut self,
        outputs: &[Output],
        mut told: impl FnMut(usize, Result<Member, MemberError>),
    ) {
        let members = &mut self.members;
        self.lanes.step(&mut |end| {
            let Some(entered) = members[end.lane].take() else { return };
            let result = match end.error {
                Some(error) => Err(RunCause::from(error).into()),
                None => entered.member(&end, outputs),
            };
            told(entered.i, result);
        });
    }
}

impl Entered {
    fn member(&self, end: &LaneEnd<'_>, outputs: &[Output]) -> Result<Member, MemberError> {
        let context = &*self.simulation.context;
        let phase = context.phase(ContactSet::EMPTY, Form::Reduced);
        let point = PhasePoint::new(phase, ContactSet::EMPTY, end.t, end.reduced.into());
        if !self.keeps_energy(end, point.state()) {
            return Member::alone(&self.simulation, outputs);
        }
        Ok(Member {
            t: end.t,
            state: context.layout().public_state(point.state()).to_vec(),
            outputs: outputs.iter().map(|output| output.evaluate(context, &point)).collect(),
            events: Vec::new(),
            steps: end.counts.accepted,
        })
    }

    fn keeps_energy(&self, end: &LaneEnd<'_>, state: &[f64]) -> bool {
        let Some(before) = &self.energy else { return true };
        let (context, steps) = (&*self.simulation.context, end.counts.accepted + end.counts.rejected);
        let bounds = AuditBounds::new(self.simulation.tolerance, steps);
        let now = context.system().energy(state);
        !energy_finding(context, end.t, [before, &now], (&Work::default(), &bounds)).is_violation()
    }
}

/// Whether two layouts are of one model: a constant may lie at several places.
fn is_same(a: &'static Layout, b: &'static Layout) -> bool {
    core::ptr::eq(a, b) || (a.name == b.name && a.declaration == b.declaration)
}
