//! Impulses of all contacts with g = 0 at once. With ġ⁻ ≤ 0 everywhere Newton's law,
//!
//! ```text
//! 0 ≤ ġ⁺ + e ġ⁻ ⟂ P ≥ 0
//! ```
//!
//! otherwise, or where an acting contact declares it, Poisson's law in two stages:
//!
//! ```text
//! 0 ≤ ġᶜ ⟂ Pᶜ ≥ 0,    then    0 ≤ ġ⁺ ⟂ P − (1 + e) Pᶜ ≥ 0
//! ```
//!
//! (Glocker and Pfeiffer, *Multiple impacts with friction in rigid multibody systems*, Nonlinear
//! Dynamics 7, 1995.) Both are the acceleration problem with u⁺ − u⁻ for a and ġ⁻ in the bias.
//!
//! A rough contact has besides P a tangential impulse P_t of either sign. It acts in a stage if its
//! P grows in it, and then does not slip at the end of that stage:
//!
//! ```text
//! Newton          P > 0:      J_t u⁺ = 0,    else P_t = 0
//! Poisson, 1      Pᶜ > 0:     J_t uᶜ = 0,    else P_tᶜ = 0
//! Poisson, 2      P > Pᶜ:     J_t u⁺ = 0,    else P_t = P_tᶜ
//! ```
//!
//! The tangential impulse of the second stage adds to that of the first, and is what keeps the
//! contact from slipping, not e P_tᶜ: e says nothing of the tangent. A contact with e = 0 that does
//! not act in the second stage may slip by what the others do then. In the limit P = 0 a contact
//! that stays closed without slip counts as one that acts. With rough contacts there may be several
//! solutions, of which the one with the most contacts closed is taken, or none: sticking may need P
//! < 0 where the contact slips fast. Of one approaching contact, W its Delassus matrix, this is ġ⁻
//! W_tt > J_t u⁻ W_nt, and the answer is [`CollisionError::Jammed`]; laws with slip are needed
//! there, and contacts with Coulomb friction have them ([`friction`](super::friction)).
//!
//! Stronge's law, e² of the work of compression, is of a single contact, and without slip the same
//! as Poisson's.
//!
//! Without friction neither law gains energy: the contacts' work is Σ P (ġ⁺ + ġ⁻)/2, and with P > 0
//! Newton's law makes it (1 − e) P ġ⁻/2 ≤ 0 whatever the coefficients. With it either may; then
//! every restitution is reduced by one factor.

use nalgebra::DVector;

use super::complementarity::{LcpRows, Solution};
use super::equilibrated_kkt::EquilibratedKkt;
use super::impulse::{Collision, CollisionError, ImpulseMethod, Outcome, Row};
use super::trials::{LcpError, Trials};
use crate::model::{ContactSet, Law};

/// Work of the contacts that counts as none, relative to the terms it is summed from.
const ROUNDING: f64 = 1e-13;
/// Residual allowed at a reduced factor: its limit is often the edge of what is admissible at all.
const BOUNDARY: f64 = 1e-13;
/// Halvings of the interval in which the largest factor without a gain lies: to the unit roundoff.
const HALVINGS: usize = 53;

impl From<LcpError> for CollisionError {
    fn from(failure: LcpError) -> Self {
        match failure {
            LcpError::Jammed => Self::Jammed,
            LcpError::Singular | LcpError::NotFinite => Self::Singular,
            LcpError::Exhausted => Self::Exhausted,
        }
    }
}

impl Collision {
    /// The rates and impulses after the collision. Without Coulomb friction no energy is gained:
    /// where it would be, every restitution is reduced by one factor, the largest that bisection
    /// from 1 finds. With it the outcome tells what is.
    pub fn solve(&self) -> Result<Outcome, CollisionError> {
        self.solve_within(usize::MAX)
    }

    /// The same with so many sets of contacts tried at most, which only rough contacts need.
    pub fn solve_within(&self, most_trials: usize) -> Result<Outcome, CollisionError> {
        self.solve_by::<true>(most_trials)
    }

    /// The same of contacts without friction.
    pub(super) fn solve_smooth(&self, most_trials: usize) -> Result<Outcome, CollisionError> {
        self.solve_by::<false>(most_trials)
    }

    fn solve_by<const ROUGH: bool>(&self, most_trials: usize) -> Result<Outcome, CollisionError> {
        self.check()?;
        self.of_single().map_or_else(|| self.search::<ROUGH>(most_trials), Ok)
    }

    pub(super) fn search<const ROUGH: bool>(&self, most_trials: usize) -> Result<Outcome, CollisionError> {
        let acting = self.without_open_rows();
        let acting = acting.as_ref().unwrap_or(self);
        match acting.solve_groups::<ROUGH>(most_trials)? {
            Some(outcome) => Ok(outcome),
            None => acting.search_at_once::<ROUGH>(most_trials),
        }
    }

    /// The outcome of contacts that are all coupled.
    pub(super) fn solve_alone<const ROUGH: bool>(
        &self,
        most_trials: usize,
    ) -> Result<Outcome, CollisionError> {
        let acting = self.without_open_rows();
        let at_once = || acting.as_ref().unwrap_or(self).search_at_once::<ROUGH>(most_trials);
        self.of_single().map_or_else(at_once, Ok)
    }

    fn search_at_once<const ROUGH: bool>(&self, most_trials: usize) -> Result<Outcome, CollisionError> {
        let stages = Stages::new(self, Trials::up_to(most_trials));
        if ROUGH && self.has_friction() {
            return stages.with_friction();
        }
        let law = stages.law()?;
        let admissible = |factor: f64| {
            let outcome = stages.outcome(law, factor).ok()?;
            let (gained, size) = stages.work(&outcome);
            let rounding = if factor < 1.0 { 0.0 } else { ROUNDING };
            if gained > rounding * size { None } else { Some(Outcome { gained, ..outcome }) }
        };
        if law == Law::Stronge
            && stages.outcome(law, 1.0).is_err_and(|error| error == CollisionError::Several)
        {
            return Err(CollisionError::Several);
        }
        if let Some(outcome) = admissible(1.0) {
            return Ok(outcome);
        }
        stages.trials.any_left()?;
        let mut best = stages.plastic(law)?;
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            match admissible(middle).filter(|outcome| self.residual(outcome) <= BOUNDARY) {
                Some(outcome) => (best, low) = (outcome, middle),
                None => high = middle,
            }
            stages.trials.any_left()?;
        }
        Ok(best)
    }
}

impl Collision {
    /// The outcome of contacts without friction with those of a set closed.
    pub(super) fn come_to_rest_smoothly(
        &self,
        set: &ContactSet,
        most_trials: usize,
    ) -> Result<Outcome, CollisionError> {
        self.plastic(set).solve_smooth(most_trials)
    }

    /// The same without restitution, and with the contacts of a set held closed.
    pub(super) fn plastic(&self, set: &ContactSet) -> Self {
        let hold = |(i, row): (usize, &Row)| match row {
            Row::Contact { .. } if set.contains(i) => Row::TwoSided,
            Row::Contact { law, .. } => Row::Contact { restitution: 0.0, law: *law },
            other => *other,
        };
        Self { rows: self.rows.iter().enumerate().map(hold).collect(), ..self.clone() }
    }
}

/// A collision with its rows sorted by their parts.
pub(super) struct Stages<'a> {
    pub(super) collision: &'a Collision,
    pub(super) approach: DVector<f64>,
    pub(super) fixed: Vec<usize>,
    pub(super) candidates: Vec<usize>,
    pub(super) tied: Vec<(usize, usize)>,
    pub(super) trials: Trials,
}

impl<'a> Stages<'a> {
    pub(super) fn new(collision: &'a Collision, trials: Trials) -> Self {
        let rows = collision.rows.iter().enumerate();
        let of = |kind: fn(&Row) -> bool| rows.clone().filter(move |(_, row)| kind(row)).map(|(i, _)| i);
        let tied = rows
            .clone()
            .filter_map(|(i, row)| if let Row::Tangent { of } = row { Some((i, *of)) } else { None });
        let stages = Self {
            collision,
            approach: collision.approach(),
            fixed: of(|row| matches!(row, Row::TwoSided)).collect(),
            candidates: of(|row| matches!(row, Row::Contact { .. })).collect(),
            tied: tied.collect(),
            trials,
        };
        Self { approach: stages.known_approach(), ..stages }
    }

    /// ġ⁻ without the rounding of rates that other contacts hold at zero: it is small beside the
    /// speeds of what is connected with it, if not beside its own terms.
    fn known_approach(&self) -> DVector<f64> {
        let problem = self.problem(&self.collision.applied, &self.approach);
        let slack = |row: usize| problem.slack(row) / problem.scale[problem.n + row];
        let known = |(row, speed): (usize, &f64)| if speed.abs() <= slack(row) { 0.0 } else { *speed };
        DVector::from_iterator(self.approach.len(), self.approach.iter().enumerate().map(known))
    }

    pub(super) fn restitution(&self, row: usize) -> f64 {
        if let Row::Contact { restitution, .. } = self.collision.rows[row] { restitution } else { 0.0 }
    }

    fn law(&self) -> Result<Law, CollisionError> {
        let departs = self.candidates.iter().any(|&row| self.approach[row] > 0.0);
        let declared = |law: Law| self.candidates.iter().any(|&row| self.declares(row, law));
        if !self.candidates.is_empty() && self.candidates.iter().all(|&row| self.declares(row, Law::Moreau)) {
            return Ok(Law::Moreau);
        }
        if !declared(Law::Stronge) {
            if departs {
                return Ok(Law::Poisson);
            }
            if !declared(Law::Poisson) {
                return Ok(Law::Newton);
            }
        }
        self.law_of(&self.newton(Law::Newton, 0.0)?.acting, departs)
    }

    pub(super) fn declares(&self, row: usize, law: Law) -> bool {
        matches!(self.collision.rows[row], Row::Contact { law: declared, .. } if declared == law)
    }

    /// The law of contacts that act at once: Moreau's where all declare it, Poisson's where one
    /// does, or where contacts depart. A single smooth or rough contact gains as much by Stronge's
    /// law as by Poisson's.
    pub(super) fn law_of(&self, acting: &[usize], departs: bool) -> Result<Law, CollisionError> {
        let any = |law: Law| acting.iter().any(|&row| self.declares(row, law));
        match acting.len() {
            _ if any(Law::Stronge) && acting.len() > 1 => Err(CollisionError::Several),
            _ if any(Law::Stronge) => Ok(Law::Stronge),
            1.. if acting.iter().all(|&row| self.declares(row, Law::Moreau)) => Ok(Law::Moreau),
            _ if departs || any(Law::Poisson) => Ok(Law::Poisson),
            _ => Ok(Law::Newton),
        }
    }

    fn outcome(&self, law: Law, factor: f64) -> Result<Outcome, CollisionError> {
        match law {
            Law::Newton | Law::Moreau => self.newton(law, factor),
            Law::Poisson => self.poisson(factor),
            Law::Stronge => {
                let outcome = self.poisson(factor)?;
                match outcome.acting.len() {
                    0 | 1 => Ok(Outcome { law, ..outcome }),
                    _ => Err(CollisionError::Several),
                }
            }
        }
    }

    /// The outcome without any restitution.
    fn plastic(&self, law: Law) -> Result<Outcome, CollisionError> {
        let outcome = self.outcome(law, 0.0)?;
        Ok(Outcome { gained: self.work(&outcome).0, ..outcome })
    }

    pub(super) fn choice(&self) -> LcpRows<'_> {
        let Self { fixed, candidates, tied, trials, .. } = self;
        LcpRows { fixed, candidates, tied, trials: Some(trials) }
    }

    fn newton(&self, law: Law, factor: f64) -> Result<Outcome, CollisionError> {
        let choice = self.choice();
        let problem = self.problem(&self.collision.applied, &self.newton_bias(factor));
        let found = problem.solve(&choice)?;
        Ok(self.finish(law, factor, &problem, found, None))
    }

    /// ġ⁻ + e ġ⁻ of contacts that approach, v⁻ + e_t v⁻ of tangents, ġ⁻ of all others.
    pub(super) fn newton_bias(&self, factor: f64) -> DVector<f64> {
        DVector::from_fn(self.approach.len(), |row, _| {
            let before = self.approach[row];
            let returned = match self.collision.rows[row] {
                Row::Contact { restitution, .. } => restitution * before.min(0.0),
                Row::Friction { restitution, .. } => restitution * before,
                Row::Open | Row::TwoSided | Row::Guide | Row::Tangent { .. } => 0.0,
            };
            before + factor * returned
        })
    }

    fn poisson(&self, factor: f64) -> Result<Outcome, CollisionError> {
        let choice = self.choice();
        let problem = self.problem(&self.collision.applied, &self.approach);
        let compressed = problem.solve(&choice)?;
        let first = self.finish(Law::Poisson, factor, &problem, compressed, None);
        let rebound = DVector::from_fn(first.impulses.len(), |row, _| {
            factor * self.restitution(row) * first.impulses[row]
        });
        // A contact that is given an impulse acts, whatever is added to it.
        let rebounds = |(_, of): &&(usize, usize)| rebound[*of] > 0.0;
        let rough = self.tied.iter().filter(rebounds).map(|(row, _)| *row);
        let fixed: Vec<usize> = self.fixed.iter().copied().chain(rough).collect();
        let tied: Vec<_> = self.tied.iter().filter(|tie| !rebounds(tie)).copied().collect();
        let choice = LcpRows { fixed: &fixed, tied: &tied, ..choice };
        let second = self.problem(&self.collision.jacobian.tr_mul(&rebound), &first.opening);
        let found = second.solve(&choice)?;
        let compression = (first.rates, &first.impulses + rebound);
        let mut outcome = self.finish(Law::Poisson, factor, &second, found, Some(compression));
        outcome.compression = outcome.compression.map(|(rates, _)| (rates, first.impulses));
        outcome.unique &= first.unique;
        Ok(outcome)
    }

    /// `M Δu − Jᵀ P = force`, `0 ≤ J Δu + bias`.
    pub(super) fn problem(&self, force: &DVector<f64>, bias: &DVector<f64>) -> EquilibratedKkt {
        let collision = self.collision;
        let size = bias.abs() + collision.speed_size();
        EquilibratedKkt::new(&collision.mass, &collision.jacobian, (force, bias), (&force.abs(), &size))
    }

    /// The sum of what was before, u⁻ or the rates and impulses given, and of the change found.
    fn finish(
        &self,
        law: Law,
        factor: f64,
        problem: &EquilibratedKkt,
        found: Solution,
        before: Option<(DVector<f64>, DVector<f64>)>,
    ) -> Outcome {
        let shared = problem.share(&found, &|row| self.candidates.contains(&row));
        let (rates, impulses) = match &before {
            Some((rates, impulses)) => (rates + found.accelerations, impulses + shared),
            None => (&self.collision.rates + found.accelerations, shared),
        };
        let mut opening = self.collision.speed(&rates);
        for (row, speed) in opening.iter_mut().enumerate() {
            if (*speed * problem.scale[problem.n + row]).abs() <= problem.slack(row) {
                *speed = 0.0;
            }
        }
        let acting = self.candidates.iter().copied().filter(|&row| impulses[row] > 0.0).collect();
        Outcome {
            rates,
            impulses,
            opening,
            acting,
            law,
            compression: before,
            factor,
            unique: found.unique,
            method: ImpulseMethod::AtOnce,
            gained: 0.0,
            solutions: 1,
            groups: Vec::new(),
        }
    }

    /// The work of the contacts, ½ Σ P (ġ⁺ + ġ°), ġ° with the applied impulse but without the
    /// contacts', and the size of its terms; none where that is not determined.
    pub(super) fn work(&self, outcome: &Outcome) -> (f64, f64) {
        let Some(free) = self.free() else { return (0.0, 0.0) };
        let rows = self.collision.rows.iter().enumerate();
        let acts =
            |row: &Row| matches!(row, Row::Contact { .. } | Row::Tangent { .. } | Row::Friction { .. });
        let work = rows.filter(|(_, row)| acts(row)).map(|(row, _)| {
            let half = 0.5 * outcome.impulses[row];
            (
                half * (outcome.opening[row] + free[row]),
                half.abs() * (outcome.opening[row].abs() + free[row].abs()),
            )
        });
        work.fold((0.0, 0.0), |(sum, size), (w, s)| (sum + w, size + s))
    }

    /// ġ of every row after the applied impulse alone; `None` where that is not determined without
    /// the contacts.
    fn free(&self) -> Option<DVector<f64>> {
        if self.collision.applied.amax() == 0.0 {
            return Some(self.approach.clone());
        }
        let problem = self.problem(&self.collision.applied, &self.approach);
        let none = LcpRows { fixed: &self.fixed, ..LcpRows::default() };
        let change = problem.solve(&none).ok()?.accelerations;
        Some(&self.approach + &self.collision.jacobian * change)
    }
}
