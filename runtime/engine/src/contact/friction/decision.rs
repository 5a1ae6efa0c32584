//! Which of the solutions is taken, and what it leaves to the next order.

use nalgebra::{DMatrix, DVector};

use super::enumeration::FEW;
use super::modes::{Bound, ContactMode, Frictional, ModeChoice, ModeCondition, SlipDirection};
use super::problem::{BalancedProblem, Candidate, FrictionProblem, Trial, Unit};
use crate::contact::complementarity::Solution;
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::contact::least_constraint::add_change;
use crate::contact::trials::LcpError;
use crate::numerics::zero::{RANK, SOLVED};

/// Two accelerations are one up to this, relative to the larger one and to what the forces alone
/// would cause.
const SAME: f64 = 1e-8;
/// The unit roundoff's margin that tolerances of [`EquilibratedKkt`] contain, taken back.
const SIZE: f64 = 1.0 / SOLVED;

/// Why one of the solutions was taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reason {
    /// There is no other.
    Only,
    /// All others are unstable with stiff compliant contacts.
    Stable,
    /// Of the stable ones it has the fewest closed contacts.
    LiftOff,
    /// Of these it has the most contacts that stick.
    Sticks,
    /// Of these it is the first in the order Stick, Slide forward, Slide backward, Open of the
    /// contacts.
    First,
    /// It is the only one, or the first by the same rules, and all are unstable.
    Unstable,
}

/// Why there is no motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FrictionError {
    /// No modes satisfy the law (Painlevé's paradox), or supports and joints contradict each other.
    Inconsistent,
    /// The accelerations are not determined.
    Singular,
    /// Matrices or vectors are not finite.
    NotFinite,
    /// More combinations of modes would have to be tried than are allowed.
    Exhausted,
}

impl From<LcpError> for FrictionError {
    fn from(failure: LcpError) -> Self {
        match failure {
            LcpError::Jammed => Self::Inconsistent,
            LcpError::Singular => Self::Singular,
            LcpError::NotFinite => Self::NotFinite,
            LcpError::Exhausted => Self::Exhausted,
        }
    }
}

/// The motion that follows.
#[derive(Debug, Clone)]
pub(crate) struct FrictionSolution {
    /// Accelerations and multipliers of all rows, R among them. `bearing` and `degenerate` tell of
    /// contacts without friction only.
    pub(crate) solution: Solution,
    /// The mode of each contact with friction.
    pub(crate) modes: Vec<ContactMode>,
    /// The same contacts with what is left to the next order.
    pub(crate) next: Vec<Frictional>,
    /// The modes of all solutions with different accelerations, contacts with friction first, then
    /// the candidates without.
    pub(crate) solutions: Vec<Vec<ContactMode>>,
    /// Which of them it is.
    pub(crate) taken: usize,
    pub(crate) reason: Reason,
    /// Whether all modes were tried, so that there are no other solutions.
    pub(crate) complete: bool,
    /// Whether the accelerations do not depend on how contacts that are redundant share their load.
    pub(crate) determined: bool,
}

/// What some of the contacts do: one choice of each, in the order of the problem's units.
pub(super) struct FrictionDecision {
    chosen: Vec<usize>,
    trial: Trial,
    /// The choices of all motions.
    solutions: Vec<Vec<usize>>,
    taken: usize,
    reason: Reason,
    complete: bool,
}

impl EquilibratedKkt {
    /// The motion with friction, its modes found among those that the contacts may have.
    pub(crate) fn solve_with_friction(
        &mut self,
        question: &FrictionProblem,
    ) -> Result<FrictionSolution, FrictionError> {
        self.couple(question.contacts);
        let problem = BalancedProblem::new(self, question);
        let decision = match problem.decide_groups()? {
            Some(decision) => decision,
            None => problem.decide_alone()?,
        };
        Ok(problem.conclude(decision))
    }

    /// The same with the solutions alone whose accelerations are not zero.
    pub(super) fn moved_with_friction(
        &mut self,
        question: &FrictionProblem,
    ) -> Result<FrictionSolution, FrictionError> {
        self.couple(question.contacts);
        let problem = BalancedProblem::new(self, question);
        let mut found = problem.enumerate()?;
        found.retain(|it| (0..self.n).any(|i| it.trial.a[i].abs() > SAME * SIZE * self.tolerance[i]));
        Ok(problem.conclude(problem.decide(found, true)?))
    }
}

impl BalancedProblem<'_> {
    /// All solutions, or where there are many contacts one; and whether these are all.
    fn candidates(&self) -> Result<(Vec<Candidate>, bool), LcpError> {
        if self.is_small() {
            return Ok((self.enumerate()?, true));
        }
        let has_guides = self.units.iter().any(Unit::is_guide);
        let found = if has_guides { None } else { self.pivot()? };
        match found {
            Some(found) => Ok((vec![found], false)),
            None => Ok((self.enumerate()?, true)),
        }
    }

    /// The decisions of groups of contacts that nothing couples, each with all others open; `None`
    /// where all are coupled, or where a group does not determine its motion without the others.
    fn decide_groups(&self) -> Result<Option<FrictionDecision>, FrictionError> {
        let groups = self.find_groups()?;
        let apart = |group: &Vec<usize>| self.with_units(group).decide_alone();
        let decisions = match groups.len() {
            0 | 1 => return Ok(None),
            _ => groups.iter().map(apart).collect::<Result<Vec<FrictionDecision>, _>>(),
        };
        let free = self.with_units(&[]).attempt(&[])?.filter(|free| free.determined);
        match (free, decisions) {
            (None, _) | (_, Err(FrictionError::Singular)) => Ok(None),
            (Some(free), decisions) => Ok(Some(self.join(&free, &groups, &decisions?))),
        }
    }

    fn find_groups(&self) -> Result<Vec<Vec<usize>>, FrictionError> {
        if self.units.len() < 2 {
            return Ok(Vec::new());
        }
        let rows = &self.question.rows;
        let of_unit = |(k, unit): (usize, &Unit)| {
            let acting = [unit.normal].into_iter().chain(unit.tangent).chain(rows.tied_to(&[unit.normal]));
            acting.map(|row| (row, k)).collect::<Vec<_>>()
        };
        let acting: Vec<_> = self.units.iter().enumerate().flat_map(of_unit).collect();
        Ok(self.kkt.least_constraint()?.find_groups(&rows.rows(&[]), &acting))
    }

    /// Motions of groups as one: each changes what no contact at all would do.
    fn join(&self, free: &Trial, groups: &[Vec<usize>], decisions: &[FrictionDecision]) -> FrictionDecision {
        let put = |mut all: Vec<usize>, group: &[usize], chosen: &[usize]| {
            group.iter().zip(chosen).for_each(|(&unit, &k)| all[unit] = k);
            all
        };
        let mut chosen = vec![0; self.units.len()];
        let (mut solutions, mut taken, mut complete) = (vec![chosen.clone()], 0, true);
        for (group, it) in groups.iter().zip(decisions) {
            chosen = put(chosen, group, &it.chosen);
            let all = &it.solutions;
            let counted = all.len() * solutions.len() <= FEW;
            let (own, place) = if counted { (&all[..], it.taken) } else { (&all[it.taken..=it.taken], 0) };
            let with =
                |known: &Vec<usize>| own.iter().map(|own| put(known.clone(), group, own)).collect::<Vec<_>>();
            taken = taken * own.len() + place;
            solutions = solutions.iter().flat_map(with).collect();
            complete &= counted && it.complete;
        }
        let joined = |of: fn(&Trial) -> &DVector<f64>| {
            let changed = decisions.iter().map(|it| of(&it.trial));
            changed.fold(of(free).clone(), |sum, changed| add_change(&sum, of(free), changed))
        };
        let trial = Trial {
            a: joined(|trial| &trial.a),
            reactions: joined(|trial| &trial.reactions),
            unique: free.unique && decisions.iter().all(|it| it.trial.unique),
            determined: decisions.iter().all(|it| it.trial.determined),
        };
        let reason = decisions.iter().map(|it| it.reason).find(|reason| *reason != Reason::Only);
        FrictionDecision { chosen, trial, solutions, taken, reason: reason.unwrap_or(Reason::Only), complete }
    }

    pub(super) fn decide_alone(&self) -> Result<FrictionDecision, FrictionError> {
        let (found, complete) = self.candidates()?;
        self.decide(found, complete)
    }

    pub(super) fn decide(
        &self,
        found: Vec<Candidate>,
        complete: bool,
    ) -> Result<FrictionDecision, FrictionError> {
        let distinct = self.distinct(found);
        let (taken, reason) = self.choose(&distinct).ok_or(FrictionError::Inconsistent)?;
        let solutions = distinct.iter().map(|candidate| candidate.chosen.clone()).collect();
        let Candidate { chosen, trial, .. } = distinct[taken].clone();
        let slides = self.modes(&chosen).iter().any(|mode| mode.sense().is_some());
        match trial.determined || slides {
            true => Ok(FrictionDecision { chosen, trial, solutions, taken, reason, complete }),
            false => Err(FrictionError::Singular),
        }
    }

    pub(super) fn conclude(&self, decision: FrictionDecision) -> FrictionSolution {
        let FrictionDecision { chosen, trial, solutions, taken, reason, complete } = decision;
        let modes = self.modes(&chosen);
        let contacts = self.question.contacts.iter().zip(&self.units).zip(&modes);
        let solution = self.finish(&modes, &trial);
        let inside = (!solution.unique).then(|| self.move_inside(&chosen, &trial)).flatten();
        let borne = inside.as_ref().unwrap_or(&trial);
        let next = contacts.map(|((contact, unit), mode)| Frictional {
            choices: self.left_open(unit, *mode, borne),
            ..contact.clone()
        });
        FrictionSolution {
            next: next.collect(),
            determined: solution.unique || trial.determined && self.is_determined(&modes),
            solution,
            modes: modes[..self.question.contacts.len()].to_vec(),
            solutions: solutions.iter().map(|chosen| self.modes(chosen)).collect(),
            taken,
            reason,
            complete,
        }
    }

    pub(super) fn modes(&self, chosen: &[usize]) -> Vec<ContactMode> {
        self.units.iter().zip(chosen).map(|(unit, &k)| unit.choices[k].mode).collect()
    }

    /// Solutions with different accelerations, each with as many contacts closed as it allows.
    /// Those in the same modes differ in how redundant contacts share their load, and count as one.
    fn distinct(&self, found: Vec<Candidate>) -> Vec<Candidate> {
        let mut distinct: Vec<Candidate> = Vec::new();
        for mut candidate in found {
            self.close_touching(&mut candidate);
            let known = distinct.iter_mut().find(|other| {
                other.chosen == candidate.chosen || self.are_one(&other.trial, &candidate.trial)
            });
            match known {
                Some(known) if candidate.trial.unique && !known.trial.unique => {
                    (known.trial, known.acting) = (candidate.trial, candidate.acting);
                }
                Some(_) => {}
                None => distinct.push(candidate),
            }
        }
        distinct
    }

    /// Whether the accelerations are one, and the reactions of guides: where these leave no freedom
    /// nothing else differs.
    fn are_one(&self, one: &Trial, other: &Trial) -> bool {
        let same = |x: f64, y: f64, least: f64| (x - y).abs() <= SAME * x.abs().max(y.abs()).max(least);
        let moves = |i: usize| same(one.a[i], other.a[i], SIZE * self.kkt.tolerance[i]);
        let bears = |unit: &Unit| {
            let row = unit.normal;
            same(one.reactions[row], other.reactions[row], SIZE * self.kkt.slack(row))
        };
        let shared = !one.unique || !other.unique;
        (0..self.kkt.n).all(moves) && (shared || self.units.iter().filter(|it| it.is_guide()).all(bears))
    }

    /// Gives each contact the first mode that the motion is one of: what does not open is closed,
    /// what does not slip sticks.
    fn close_touching(&self, candidate: &mut Candidate) {
        for (unit, chosen) in self.units.iter().zip(&mut candidate.chosen) {
            let first = unit.choices.iter().position(|it| self.is_mode_of(unit, it, &candidate.trial));
            *chosen = first.unwrap_or(*chosen);
        }
    }

    /// Whether a motion is one of a contact in a mode.
    fn is_mode_of(&self, unit: &Unit, choice: &ModeChoice, trial: &Trial) -> bool {
        let kkt = self.kkt;
        let still = |row: usize| kkt.opening(row, &trial.a).abs() <= kkt.slack(row);
        let free = |row: usize| trial.reactions[row].abs() <= kkt.slack(row);
        let tied = self.question.rows.tied_to(&[unit.normal]);
        let mut tangents = tied.iter().copied().chain(unit.tangent);
        let meets = match choice.mode {
            ContactMode::Open => free(unit.normal) && tangents.all(free),
            ContactMode::Stick => still(unit.normal) && tangents.all(still),
            ContactMode::Slide(sense) => still(unit.normal) && self.is_kinetic(unit, sense, trial),
            ContactMode::Guide { sense: None, .. } => tangents.all(still),
            ContactMode::Guide { sense: Some(sense), side } => {
                self.is_kinetic_with(unit, sense, f64::from(side.sign()), trial)
            }
            ContactMode::Part(None) => free(unit.normal) && tangents.all(still),
            ContactMode::Part(Some(sense)) => free(unit.normal) && self.is_kinetic(unit, sense, trial),
        };
        meets && self.holds(unit, choice, trial)
    }

    /// Whether R = −σ μ λ_N.
    fn is_kinetic(&self, unit: &Unit, sense: SlipDirection, trial: &Trial) -> bool {
        self.is_kinetic_with(unit, sense, 1.0, trial)
    }

    /// Whether R = −σ μ s λ_N.
    fn is_kinetic_with(&self, unit: &Unit, sense: SlipDirection, side: f64, trial: &Trial) -> bool {
        unit.tangent.is_some_and(|tangent| {
            let Bound { slope, offset } = unit.kinetic(sense);
            let share = slope * self.kkt.ratio(unit.normal, tangent);
            let most =
                side * share * trial.reactions[unit.normal] + offset / self.kkt.scale[self.kkt.n + tangent];
            let slack = share.abs() * self.kkt.slack(unit.normal) + self.kkt.slack(tangent);
            let size = trial.reactions[tangent].abs().max(SIZE * slack);
            (trial.reactions[tangent] + sense.sign() * most).abs() <= size / SIZE
        })
    }

    /// The modes that a motion leaves possible, that which it has been solved in among them, each
    /// with the conditions that it meets with zero.
    fn left_open(&self, unit: &Unit, own: ContactMode, trial: &Trial) -> Vec<ModeChoice> {
        // Nearly singular equations are solved to more than the rounding of their rows.
        let is_possible = |choice: &&ModeChoice| choice.mode == own || self.is_mode_of(unit, choice, trial);
        let possible = unit.choices.iter().filter(is_possible);
        let vanishes = |choice: &ModeChoice, condition: &ModeCondition| {
            let (value, slack) = self.value(unit, choice.mode, *condition, trial);
            value.abs() <= slack && *condition != ModeCondition::Follows
        };
        let open = |choice: &ModeChoice| ModeChoice {
            mode: choice.mode,
            conditions: choice.conditions.iter().copied().filter(|it| vanishes(choice, it)).collect(),
        };
        possible.map(open).collect()
    }

    /// Whether redundant contacts move the system alike however they share their load: those that
    /// slide at different μ do not, and have more independent columns than rows.
    fn is_determined(&self, modes: &[ContactMode]) -> bool {
        let closed = self.closed(modes);
        let rows: Vec<_> = closed.rows.iter().map(|&row| self.kkt.column_of(row)).collect();
        let mut columns = rows.clone();
        for &(normal, tangent, factor) in &closed.bends {
            let place = closed.rows.iter().position(|&row| row == normal);
            let bent = self.kkt.bent_column(normal, tangent, factor);
            place.into_iter().for_each(|place| columns[place] = bent.clone());
        }
        rank(&columns) == rank(&rows)
    }

    fn finish(&self, modes: &[ContactMode], trial: &Trial) -> Solution {
        let kkt = self.kkt;
        let smooth = self.units.iter().zip(modes).filter(|(unit, _)| unit.tangent.is_none());
        let closed = smooth.filter(|(_, mode)| mode.is_closed()).map(|(unit, _)| unit.normal);
        let bears = |row: &usize| trial.reactions[*row] > kkt.slack(*row);
        let pulls = |row: &usize| trial.reactions[*row] < -kkt.slack(*row);
        let (bearing, degenerate) = closed.partition(bears);
        let tight = self.closed(modes).rows;
        let two_sided = || self.question.rows.fixed.iter().copied();
        let independent = |rows: &[usize]| {
            kkt.least_constraint().is_ok_and(|least| least.independent(rows).len() == rows.len())
        };
        Solution {
            accelerations: trial.a.component_mul(&kkt.scale.rows(0, kkt.n)),
            reactions: trial.reactions.component_mul(&kkt.scale.rows(kkt.n, trial.reactions.len())),
            active_basis: bearing,
            degenerate,
            pulling: two_sided().filter(pulls).collect(),
            pushing: two_sided().filter(bears).collect(),
            unique: trial.unique && independent(&tight),
            tight,
        }
    }
}

fn rank(vectors: &[DVector<f64>]) -> usize {
    if vectors.is_empty() { 0 } else { DMatrix::from_columns(vectors).rank(RANK) }
}
