//! The acceleration-level problem with its degenerate set taken order by order.
//!
//! With Taylor coefficients aₙ, λₙ, g̈ₙ of the motion that follows, order n of the equations reads
//!
//! ```text
//! M₀ aₙ − J₀ᵀ λₙ = fₙ − Σₖ₌₁ⁿ (Mₖ aₙ₋ₖ − Jₖᵀ λₙ₋ₖ)
//! J₀ aₙ − g̈ₙ    = −bₙ − Σₖ₌₁ⁿ Jₖ aₙ₋ₖ
//! ```
//!
//! Order 0 decides every contact but those with neither reaction nor opening; those are decided by
//! order 1, and so on. Contacts with friction have modes (open, stick, slide), of which each order
//! leaves those that it does not refuse; see [`super::friction`].
//!
//! A rough contact without reaction is different: its tangential reaction may be there, and opening
//! would end it, so that the two are different motions from order 0 on. It stays if the first
//! reaction that does not vanish is ≥ 0, and opens otherwise, where it then must not be pressed on.

mod rubbing;
#[cfg(test)]
mod tests;

pub(crate) use rubbing::Alternatives;

use nalgebra::{Cholesky, DVector};
use rubbing::FrictionAtOrder;

use super::complementarity::{LcpRows, Solution};
use super::equations::SeriesEquations;
use super::equilibrated_kkt::EquilibratedKkt;
use super::friction::{ContactMode, FrictionError, FrictionProblem, Frictional, SlipVelocity as KnownSlip};
use super::least_constraint::LeastConstraint;
use super::trials::LcpError;
use super::{ContactError, Trials, joint_names, singular};
use crate::context::reactions_of;
use crate::model::{Contact, ContactSet, Layout};
use crate::numerics::zero::{MARGIN, SOLVED};
use crate::system::{MOST_TIME_ORDERS, Model, TIME_ORDERS};

/// Terms of order n below this part of those of order 0 in a natural time are what the rounding of
/// a state at rest makes. What counts as rounding of terms is a thousand times less.
const AT_REST: f64 = 1e-3;

/// What is to be decided at a state.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ContactProblem<'a> {
    /// One-sided contacts with g = 0 and ġ = 0.
    pub(crate) touching: ContactSet,
    /// Contacts held closed whatever their reaction.
    pub(crate) held: ContactSet,
    /// Touching contacts whose reaction was located at zero.
    pub(crate) unloaded: ContactSet,
    /// The sets that may be tried, if not any number.
    pub(crate) most_trials: Option<usize>,
    /// The touching contacts with friction, and what is known of their slips.
    pub(crate) slips: &'a [(usize, KnownSlip)],
    /// The natural time, s, if the rounding of the state counts.
    pub(crate) time: Option<f64>,
}

/// The motion that follows.
#[derive(Debug, Clone)]
pub(crate) struct ContactSolution {
    /// Closed contacts, held ones among them.
    pub(crate) closed: ContactSet,
    /// Independent ones among them that hold the others too.
    pub(crate) active_basis: ContactSet,
    /// Reactions of all contacts, the shortest where they are not unique.
    pub(crate) reactions: Vec<f64>,
    /// Whether the reactions are the only ones possible.
    pub(crate) unique: bool,
    /// The motions that friction lets follow, where they are several or not all were looked for.
    pub(crate) alternatives: Option<Alternatives>,
}

/// Solves for the closed contacts at a state that satisfies the touching ones.
pub(crate) fn decide(
    model: &Model,
    state: &[f64],
    question: &ContactProblem,
) -> Result<ContactSolution, ContactError> {
    decide_by::<true>(model, state, question)
}

/// The same for contacts without friction.
pub(crate) fn decide_smooth(
    model: &Model,
    state: &[f64],
    question: &ContactProblem,
) -> Result<ContactSolution, ContactError> {
    decide_by::<false>(model, state, question)
}

fn decide_by<const ROUGH: bool>(
    model: &Model,
    state: &[f64],
    question: &ContactProblem,
) -> Result<ContactSolution, ContactError> {
    let named = |failure| name(model, state, failure, question);
    let trials = question.most_trials.map(Trials::up_to);
    // Contacts that have come off, with the reactions that they had.
    let mut off: Vec<(usize, f64)> = Vec::new();
    loop {
        let touching = question.touching.difference(off.iter().map(|(row, _)| *row).collect());
        let mut ladder = OrderLadder::new(model.layout(), &ContactProblem { touching, ..*question });
        if ROUGH {
            ladder.rub(model, state, &ContactProblem { touching, ..*question })?;
        }
        let lifted = ladder.raise_order::<ROUGH>(model, state, trials.as_ref()).map_err(named)?;
        if !lifted.is_empty() {
            off.extend(lifted.iter().map(|row| (row, ladder.reactions[0][row])));
            continue;
        }
        if ladder.is_any_pressed(model, state, &off) {
            return Err(named(LcpError::Jammed));
        }
        return Ok(ladder.decision(model.layout()));
    }
}

fn name(model: &Model, state: &[f64], failure: LcpError, question: &ContactProblem) -> ContactError {
    let acting = question.touching.union(question.held);
    let told = |i: usize| match model.layout().contacts[i] {
        Contact { label, rough: true, .. } => format!("{label} (rough: it cannot slip)"),
        Contact { label, .. } => label.to_owned(),
    };
    let contacts =
        if acting.is_empty() { joint_names(model.layout()) } else { acting.iter().map(told).collect() };
    match failure {
        LcpError::Jammed => ContactError::Jammed { contacts },
        LcpError::Singular => singular(model, state, acting),
        LcpError::NotFinite => ContactError::NotFinite,
        LcpError::Exhausted => ContactError::Undecided { contacts },
    }
}

impl From<FrictionError> for LcpError {
    fn from(error: FrictionError) -> Self {
        match error {
            FrictionError::Inconsistent => Self::Jammed,
            FrictionError::Singular => Self::Singular,
            FrictionError::NotFinite => Self::NotFinite,
            FrictionError::Exhausted => Self::Exhausted,
        }
    }
}

/// Orders solved so far.
pub(super) struct OrderLadder {
    /// Rows that stay closed: two-sided ones and those found to bear.
    closed: Vec<usize>,
    /// Rows not decided by the orders so far.
    open_question: Vec<usize>,
    /// Rough contacts that bear nothing by the orders so far, closed for the sake of their
    /// tangential rows.
    pledged: Vec<usize>,
    /// Tangential rows with their contacts.
    tied: Vec<(usize, usize)>,
    /// The contacts that take part.
    acting: ContactSet,
    /// Rows whose order-0 reaction is known to vanish.
    unloaded: ContactSet,
    accelerations: Vec<DVector<f64>>,
    reactions: Vec<DVector<f64>>,
    unique: bool,
    lowest: Option<Lowest>,
    rubbing: Vec<FrictionAtOrder>,
    layout: &'static Layout,
    time: Option<f64>,
}

/// What order 0 has found.
struct Lowest {
    problem: EquilibratedKkt,
    solution: Solution,
    /// The closed rows where reactions are shared, those that bear alone first.
    first_to_bear: Vec<usize>,
    alternatives: Option<Alternatives>,
}

impl OrderLadder {
    pub(super) fn new(layout: &'static Layout, question: &ContactProblem) -> Self {
        let contacts = layout.contacts.len();
        let joints = contacts..contacts + layout.joints.len();
        let rubs = |contact: usize| layout.contacts[contact].friction.is_some();
        let tangents = layout.tangents.iter().enumerate().filter(|(_, contact)| !rubs(**contact));
        let tied: Vec<_> = tangents.map(|(k, &contact)| (joints.end + k, contact)).collect();
        let rough = |row: &usize| tied.iter().any(|(_, with)| with == row);
        let loose = question.touching.iter().filter(|&i| !question.held.contains(i) && !rubs(i));
        let (pledged, open_question) = loose.partition(|row| question.unloaded.contains(*row) && rough(row));
        Self {
            closed: joints.chain(question.held.iter().filter(|&i| !rubs(i))).collect(),
            open_question,
            pledged,
            tied,
            acting: question.touching.union(question.held),
            unloaded: question.unloaded,
            accelerations: Vec::new(),
            reactions: Vec::new(),
            unique: true,
            lowest: None,
            rubbing: Vec::new(),
            layout,
            time: question.time,
        }
    }

    fn is_rough(&self, row: usize) -> bool {
        self.tied.iter().any(|(_, contact)| *contact == row)
    }

    fn is_decided(&self) -> bool {
        let rubs = |rubbing: &FrictionAtOrder| rubbing.later.is_none() && rubbing.frictional.is_decided();
        self.open_question.is_empty() && self.pledged.is_empty() && self.rubbing.iter().all(rubs)
    }

    /// Solves order by order until all contacts are decided. Returns the rough contacts that a
    /// lower order kept closed and a higher one opens.
    fn raise_order<const ROUGH: bool>(
        &mut self,
        model: &Model,
        state: &[f64],
        trials: Option<&Trials>,
    ) -> Result<ContactSet, LcpError> {
        // A load of time alone begins in any order; what rests on the same motion is not worth more
        // of them.
        let orders = if self.layout.timed { MOST_TIME_ORDERS } else { TIME_ORDERS };
        for _ in 0..orders {
            let (layout, acting) = (model.layout(), &self.acting);
            let acts = |row: usize| layout.contact_of(row).is_none_or(|contact| acting.contains(contact));
            let equations = SeriesEquations::along(model, state, &self.accelerations).acting(acts);
            let lifted = match self.solve_next_order::<ROUGH>(&equations, trials) {
                // How rows that are dependent here only share the load follows from the orders
                // above: with another share these contradict each other.
                Err(LcpError::Jammed) if !self.unique => return Ok(ContactSet::EMPTY),
                lifted => lifted?,
            };
            if !lifted.is_empty() || self.is_decided() {
                return Ok(lifted);
            }
        }
        Ok(ContactSet::EMPTY)
    }

    /// Solves the next order and keeps as undecided what it leaves at zero.
    fn solve_next_order<const ROUGH: bool>(
        &mut self,
        equations: &SeriesEquations,
        trials: Option<&Trials>,
    ) -> Result<ContactSet, LcpError> {
        let order = self.accelerations.len();
        if order == 0 && !equations.are_finite() {
            return Err(LcpError::NotFinite);
        }
        let known: Vec<usize> = match order {
            0 => self.open_question.iter().copied().filter(|&row| self.unloaded.contains(row)).collect(),
            _ => Vec::new(),
        };
        let candidates: Vec<usize> =
            self.open_question.iter().copied().filter(|row| !known.contains(row)).collect();
        let fixed: Vec<usize> = self.closed.iter().chain(&self.pledged).copied().collect();
        let choice = LcpRows { fixed: &fixed, candidates: &candidates, tied: &self.tied, trials };
        let mut problem = self.problem(equations, order);
        let (mut first_to_bear, mut alternatives) = (Vec::new(), None);
        let mut solution = match !ROUGH || self.rubbing.is_empty() {
            true => {
                let found = self.solve_smooth(&problem, &choice, &known, equations)?;
                let shared = (order == 0).then(|| self.share_rough(&problem, &found)).flatten();
                if let Some(shared) = &shared {
                    let question = FrictionProblem { rows: choice, contacts: &[] };
                    first_to_bear = problem.order_active_basis(&question, &[], shared);
                }
                shared.unwrap_or(found)
            }
            false => {
                let contacts: Vec<Frictional> =
                    self.rubbing.iter().map(|one| one.frictional.clone()).collect();
                let question = FrictionProblem { rows: choice, contacts: &contacts };
                let mut found = problem.solve_with_friction(&question).map_err(LcpError::from)?;
                if order == 0 && (found.solutions.len() > 1 || !found.complete || !found.determined) {
                    alternatives = Some(self.alternatives_of(&found, &candidates));
                }
                if order == 0 && !found.solution.unique {
                    found.solution.reactions = problem.share_with_friction(&question, &found);
                    first_to_bear = problem.order_active_basis(&question, &found.modes, &found.solution);
                    found.solution = self.keep_bearing(&problem, found.solution);
                }
                for ((rubbing, mode), next) in self.rubbing.iter_mut().zip(found.modes).zip(found.next) {
                    rubbing.mode = mode;
                    rubbing.frictional = rubbing.later.take().unwrap_or(next);
                }
                found.solution
            }
        };
        known.iter().for_each(|&row| solution.reactions[row] = 0.0);
        solution.degenerate.extend(known);
        let lifted = if order == 0 { ContactSet::EMPTY } else { self.lifted(&solution) };
        if order == 0 {
            self.lowest = Some(Lowest { problem, solution: solution.clone(), first_to_bear, alternatives });
        }
        let Solution { accelerations, reactions, active_basis: bearing, degenerate, pushing, unique, .. } =
            solution;
        let (kept, pledged): (Vec<_>, Vec<_>) =
            self.pledged.iter().partition(|row| order > 0 && pushing.contains(row));
        let (rough, smooth): (Vec<_>, Vec<_>) = degenerate.into_iter().partition(|row| self.is_rough(*row));
        self.closed.extend(bearing.into_iter().chain(kept));
        self.pledged = pledged.into_iter().chain(rough).collect();
        self.open_question = smooth;
        self.open_question.sort_unstable();
        self.accelerations.push(accelerations);
        self.reactions.push(reactions);
        self.unique &= unique;
        Ok(lifted)
    }

    /// The solution without friction. A reaction that was located at zero is zero but for the error
    /// of the place, and that error accelerates contacts that depend on this one. Where it opens
    /// one of them, the located contact is held in this order, if it bears no more than the error.
    fn solve_smooth(
        &self,
        problem: &EquilibratedKkt,
        choice: &LcpRows,
        known: &[usize],
        equations: &SeriesEquations,
    ) -> Result<Solution, LcpError> {
        let free = problem.solve(choice)?;
        let mut opened = choice.candidates.iter().filter(|row| !free.tight.contains(row)).peekable();
        if known.is_empty() || opened.peek().is_none() {
            return Ok(free);
        }
        let fixed = [choice.fixed, known].concat();
        let Ok(held) = problem.solve(&LcpRows { fixed: &fixed, ..*choice }) else { return Ok(free) };
        let leans = opened.any(|row| held.tight.contains(row));
        let loads = DVector::from_fn(held.reactions.len(), |row, _| {
            if known.contains(&row) { held.reactions[row] } else { 0.0 }
        });
        let borne = equations.jacobian[0].tr_mul(&loads);
        let rate = equations.force.get(1).zip(self.time).map_or(0.0, |(rate, time)| rate.amax() * time);
        let is_error = borne.amax() <= MARGIN * (equations.force[0].amax() + rate);
        Ok(if leans && is_error { held } else { free })
    }

    /// The same with redundant rough contacts that bear their shares of the load: without any they
    /// would be pledged, and the sign of what they bear at the next order is that of no share.
    fn share_rough(&self, problem: &EquilibratedKkt, found: &Solution) -> Option<Solution> {
        if found.unique || !found.degenerate.iter().any(|row| self.is_rough(*row)) {
            return None;
        }
        let one_sided = |row: usize| found.degenerate.contains(&row) || found.active_basis.contains(&row);
        let reactions = problem.share(found, &one_sided);
        Some(self.keep_bearing(problem, Solution { reactions, ..found.clone() }))
    }

    /// The same with the rough contacts that bear a share among those that stay closed.
    fn keep_bearing(&self, problem: &EquilibratedKkt, mut solution: Solution) -> Solution {
        let bears = |row: &usize| {
            self.is_rough(*row)
                && solution.reactions[*row] > problem.scale[problem.n + row] * problem.slack(*row)
        };
        let (bearing, degenerate): (Vec<_>, Vec<_>) = solution.degenerate.iter().partition(|row| bears(row));
        solution.active_basis.extend(bearing);
        Solution { degenerate, ..solution }
    }

    /// Pledged contacts whose reaction falls below zero.
    fn lifted(&self, solution: &Solution) -> ContactSet {
        let pulled = self.pledged.iter().filter(|row| solution.pulling.contains(row));
        pulled.copied().collect()
    }

    /// Whether an open contact would close at once: g̈ < 0 beyond the rounding of its terms. An
    /// event is located to some 1e-11, so that the accelerations after it are known no better, nor
    /// than what those reactions accelerate that were located at zero, and what forces change by in
    /// the error of the place.
    fn is_any_pressed(&self, model: &Model, state: &[f64], off: &[(usize, f64)]) -> bool {
        if off.is_empty() {
            return false;
        }
        let equations = SeriesEquations::along(model, state, &[]);
        let (jacobian, bias) = (&equations.jacobian[0], &equations.bias[0]);
        let mut force = equations.force[0].abs();
        if let Some((rate, time)) = equations.force.get(1).zip(self.time) {
            force += rate.abs() * time;
        }
        let compliance = Cholesky::new(equations.mass[0].clone());
        let compute_error = |gap: &DVector<f64>| {
            let Some(mass) = &compliance else { return 0.0 };
            let response = mass.solve(gap);
            let moved = jacobian * &response;
            let located = off.iter().map(|&(row, load)| moved[row].abs() * load.max(0.0));
            2.0 * located.sum::<f64>() + SOLVED * response.abs().dot(&force)
        };
        let is_pressed = |row: usize| {
            let gap = jacobian.row(row).transpose();
            let terms = gap.component_mul(&self.accelerations[0]);
            let error = compute_error(&gap) + 1e-9 * (terms.abs().sum() + bias[row].abs());
            terms.sum() + bias[row] < -error
        };
        off.iter().any(|(row, _)| is_pressed(*row))
    }

    pub(super) fn problem(&self, equations: &SeriesEquations, order: usize) -> EquilibratedKkt {
        let mut force = equations.force[order].clone();
        let mut bias = equations.bias[order].clone();
        let (mut force_size, mut bias_size) = (force.abs(), bias.abs());
        for k in 1..=order {
            let (a, reactions) = (&self.accelerations[order - k], &self.reactions[order - k]);
            let inertia = &equations.mass[k] * a;
            let load = equations.jacobian[k].tr_mul(reactions);
            let turn = &equations.jacobian[k] * a;
            force_size += inertia.abs() + load.abs();
            bias_size += turn.abs();
            force += load - inertia;
            bias += turn;
        }
        if let Some(time) = self.time.filter(|_| order > 0) {
            let part = AT_REST / time.powi(order as i32);
            force_size += part * equations.force[0].abs();
            bias_size += part * equations.bias[0].abs();
        }
        // Where a load that grows balances all others, nothing else is left of their size.
        if let (0, Some(time), Some(rate)) = (order, self.time, equations.force.get(1)) {
            force_size += AT_REST * time * rate.abs();
        }
        EquilibratedKkt::new(
            &equations.mass[0],
            &equations.jacobian[0],
            (&force, &bias),
            (&force_size, &bias_size),
        )
        .with_layout(self.layout)
    }

    /// Contacts that no order decides stay closed with zero reaction; they bear only what friction
    /// does not hold.
    fn decision(&self, layout: &Layout) -> ContactSolution {
        let contacts = layout.contacts.len();
        let undecided: Vec<usize> = self.open_question.iter().chain(&self.pledged).copied().collect();
        let rubbing = self.rubbing.iter().filter(|rubbing| rubbing.mode != ContactMode::Open);
        let normals: Vec<usize> = rubbing.clone().map(|rubbing| rubbing.contact).collect();
        let held: Vec<usize> = self.closed.iter().chain(&normals).copied().collect();
        let rows = [&held[..], &undecided].concat();
        let is_contact = |row: &usize| *row < contacts;
        let slipping = |set: ContactSet| self.rubbing.iter().fold(set, |set, rubbing| rubbing.slip(set));
        ContactSolution {
            closed: slipping(rows.iter().copied().filter(is_contact).collect()),
            active_basis: slipping(
                self.find_active_basis(&held, &undecided).into_iter().filter(is_contact).collect(),
            ),
            reactions: self.shared(&rows, layout),
            unique: self.unique,
            alternatives: self.lowest.as_ref().and_then(|lowest| lowest.alternatives.clone()),
        }
    }

    /// Rows that bear: independent ones, joints and those that bear at the lowest order first. A
    /// rough contact whose normal joints hold bears across.
    fn find_active_basis(&self, held: &[usize], undecided: &[usize]) -> Vec<usize> {
        let rows = || held.iter().chain(undecided).copied();
        let is_shared = !self.unique || !(self.rubbing.is_empty() || self.open_question.is_empty());
        let Some(lowest) = self.lowest.as_ref().filter(|_| is_shared) else { return rows().collect() };
        let Ok(least) = lowest.problem.least_constraint() else { return rows().collect() };
        let first = lowest.first_to_bear.iter().filter(|row| held.contains(row));
        let sticking = self.rubbing.iter().filter(|it| it.mode.holds_tangent());
        let across = sticking.map(|it| it.frictional.tangent);
        let all: Vec<usize> =
            first.chain(held).copied().chain(across).chain(undecided.iter().copied()).collect();
        let independent = least.independent(&all);
        rows().filter(|&row| independent.contains(&row) || self.rolls(&least, row)).collect()
    }

    /// Whether a contact is rough and joints hold its normal: it bears across under any load.
    fn rolls(&self, least: &LeastConstraint, row: usize) -> bool {
        let contacts = self.layout.contacts.len();
        let joints = contacts..contacts + self.layout.joints.len();
        self.is_rough(row) && !least.independent(&joints.chain([row]).collect::<Vec<_>>()).contains(&row)
    }

    /// The shortest reactions at order 0 of the contacts that stay closed.
    fn shared(&self, rows: &[usize], layout: &Layout) -> Vec<f64> {
        let contacts = layout.contacts.len();
        let shares = self.lowest.as_ref().filter(|_| !self.unique && self.rubbing.is_empty());
        let shared = shares.map(|Lowest { problem, solution, .. }| {
            let one_sided =
                |row: usize| solution.degenerate.contains(&row) || solution.active_basis.contains(&row);
            let tight = solution.tight.iter().copied().filter(|row| *row >= contacts || rows.contains(row));
            problem.share(&Solution { tight: tight.collect(), ..solution.clone() }, &one_sided)
        });
        reactions_of(layout, shared.as_ref().unwrap_or(&self.reactions[0]).as_slice()).to_vec()
    }
}
