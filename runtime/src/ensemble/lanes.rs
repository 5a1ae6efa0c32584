//! Members side by side.

use super::{Member, MemberError};
use crate::error::{RunCause, StartError};
use crate::integrate::{Bundle, Ended, Progress, StepError};
use crate::model::{BarSystem, ContactSet, Form, Phase, PhaseSeries};
use crate::moment::{At, seen};
use crate::output::Output;
use crate::rest::Rest;
use crate::scalar::{LANES, Lanes};
use crate::segment::tolerances;
use crate::simulation::Simulation;

/// A guess at the first step, in natural times.
const FIRST: f64 = 0.1;

/// Whether nothing can happen before the end, and Taylor's method is what a run by itself would take.
pub(super) fn is_smooth<M: BarSystem>(simulation: &Simulation<M>) -> bool {
    let Simulation { scene, plan, conditions, occurrences, form, method, tolerance, limit, .. } = simulation;
    M::LAYOUT.contacts.is_empty()
        && M::LAYOUT.joints.is_empty()
        && !scene.scales.damped
        && plan.is_empty()
        && conditions.is_empty()
        && occurrences.is_empty()
        && *form == Form::Closed
        && method.takes_series()
        && *tolerance > 0.0
        && *tolerance < 1.0
        && *limit > 0.0
        && limit.is_finite()
}

/// Members of one tolerance.
pub(super) struct Group<M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> {
    pub(super) tolerance: f64,
    phase: Phase<M, f64, N>,
    bundle: Bundle<M, Q, N>,
    members: [Option<(usize, Simulation<M>)>; LANES],
}

impl<M: BarSystem, Q: PhaseSeries<M, N>, const N: usize> Group<M, Q, N> {
    /// An empty one for members like this.
    pub(super) fn new(phase: Phase<M, f64, N>, like: &Simulation<M>) -> Self {
        let constants = M::from_parameters(&like.scene.parameters).constants::<Lanes>();
        let bundle = Bundle::new(constants, like.tolerance);
        Self { tolerance: like.tolerance, phase, bundle, members: [const { None }; LANES] }
    }

    pub(super) fn is_full(&self) -> bool {
        self.bundle.free().is_none()
    }

    pub(super) fn is_empty(&self) -> bool {
        self.bundle.is_empty()
    }

    /// Puts a member into a free lane.
    pub(super) fn enter(&mut self, i: usize, simulation: Simulation<M>) -> Result<(), MemberError> {
        let Some(lane) = self.bundle.free() else { return Err(MemberError::NotRun) };
        let state = simulation.started()?.state;
        let scene = &simulation.scene;
        let (constants, scales) = (&scene.constants, &scene.scales);
        if M::phase(ContactSet::EMPTY, Form::Closed, Rest { constants, scales, state: &state }) {
            return Err(StartError::Equilibrium.into());
        }
        let tolerance = tolerances(&self.phase, scales, self.tolerance)
            .map_err(|_| RunCause::from(StepError::Floor { t: 0.0, h: 0.0 }))?;
        let progress = Progress::new(tolerance, 0.0, Q::restrict(&state)).with_end(simulation.limit);
        self.bundle.enter(lane, progress, constants, FIRST * scales.time);
        self.members[lane] = Some((i, simulation));
        Ok(())
    }

    /// One step of all; tells of those that end.
    pub(super) fn step(
        &mut self,
        outputs: &[Output],
        mut told: impl FnMut(usize, Result<Member, MemberError>),
    ) {
        for Ended { lane, progress, error } in self.bundle.step().into_iter().flatten() {
            let Some((i, simulation)) = self.members[lane].take() else { continue };
            let end = match error {
                Some(error) => Err(RunCause::from(error).into()),
                None => Ok(self.end(&simulation, &progress, outputs)),
            };
            told(i, end);
        }
    }

    fn end(&self, simulation: &Simulation<M>, progress: &Progress<f64, N>, outputs: &[Output]) -> Member {
        let scene = &simulation.scene;
        let t = progress.time();
        let state = (self.phase.embed)(&scene.constants, progress.state());
        let value = |output: &Output| {
            output.evaluate(scene, &At::new(&self.phase, &scene.constants, t, *progress.state()))
        };
        Member {
            t,
            state: seen::<M>(&state).to_vec(),
            outputs: outputs.iter().map(value).collect(),
            events: Vec::new(),
            steps: progress.counts().accepted,
        }
    }
}
