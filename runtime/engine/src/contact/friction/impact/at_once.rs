//! All contacts at once: Newton's and Poisson's laws with friction (Glocker and Pfeiffer, *Multiple
//! impacts with friction in rigid multibody systems*, Nonlinear Dynamics 7, 1995). With Coulomb's
//! law `v ∈ −N(P_t | μ P)` for
//!
//! ```text
//! v = 0: |P_t| ≤ μ P,        v ≠ 0: P_t = −μ P sign v
//! Newton        0 ≤ ġ⁺ + e ġ⁻ ⟂ P ≥ 0,               v⁺ + e_t v⁻ with P_t, P
//! Poisson, 1    0 ≤ ġᶜ ⟂ Pᶜ ≥ 0,                     vᶜ with P_tᶜ, Pᶜ
//! Poisson, 2    0 ≤ ġ⁺ ⟂ Pᵉ − e Pᶜ ≥ 0,              v⁺ with P_tᵉ, Pᵉ;    P = Pᶜ + Pᵉ, P_t = P_tᶜ + P_tᵉ
//! ```
//!
//! Poisson's law with one e gains no energy by contacts, P_tᵉ of which is as large as e P_tᶜ where
//! they slip. By guides it may: their reactions follow from the stage alone, and rub less in the
//! second one than e times those of the first would.
//!
//! Each stage has friction of its own, bounded by the normal impulse of that stage, as it would
//! along a path. Where e_t is declared the second stage gives back at least `e e_t P_tᶜ`: that is
//! what P_tᵉ is while the contact slips along it. Velocities change by `M Δu = Jᵀ P`: each stage is
//! the acceleration problem of contacts at rest.

use nalgebra::DVector;

use super::super::super::impact::Stages;
use super::super::super::impulse::{CollisionError, ImpulseMethod, Outcome};
use super::super::FrictionProblem;
use super::super::decision::{FrictionError, FrictionSolution};
use super::super::modes::{Bound, Frictional, ImpulseBounds};
use super::ImpactFriction;
use crate::contact::complementarity::LcpRows;
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::model::Law;

impl From<FrictionError> for CollisionError {
    fn from(failure: FrictionError) -> Self {
        match failure {
            FrictionError::Inconsistent => Self::Jammed,
            FrictionError::Singular | FrictionError::NotFinite => Self::Singular,
            FrictionError::Exhausted => Self::Exhausted,
        }
    }
}

/// Which solutions of a stage count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum SolutionFilter {
    Any,
    /// Those that change the velocities.
    Moved,
}

/// Rates and impulses so far, and how they were found.
pub(super) struct ImpactStage {
    pub(super) rates: DVector<f64>,
    pub(super) impulses: DVector<f64>,
    opening: DVector<f64>,
    unique: bool,
    solutions: usize,
}

impl ImpactStage {
    pub(super) fn acting(&self, candidates: &[usize]) -> Vec<usize> {
        candidates.iter().copied().filter(|&row| self.impulses[row] > 0.0).collect()
    }
}

impl Stages<'_> {
    /// The outcome with every restitution multiplied by a factor.
    pub(super) fn all_at_once(&self, law: Law, factor: f64) -> Result<Outcome, CollisionError> {
        let (stage, compression) = if law.has_phases() {
            let first = self.stage(&self.approach, &self.at_rest(), SolutionFilter::Any)?;
            let second = self.expansion(&first, factor)?;
            (second, Some((first.rates, first.impulses)))
        } else {
            (self.stage(&self.newton_bias(factor), &self.at_rest(), SolutionFilter::Any)?, None)
        };
        Ok(Outcome { factor, ..self.outcome_of(stage, law, compression) })
    }

    pub(super) fn outcome_of(
        &self,
        stage: ImpactStage,
        law: Law,
        compression: Option<(DVector<f64>, DVector<f64>)>,
    ) -> Outcome {
        let acting = stage.acting(&self.candidates);
        let ImpactStage { rates, impulses, opening, unique, solutions } = stage;
        let (factor, method, gained) = (1.0, ImpulseMethod::AtOnce, 0.0);
        let outcome = Outcome {
            rates,
            impulses,
            opening,
            acting,
            law,
            compression,
            factor,
            unique,
            method,
            gained,
            solutions,
            groups: Vec::new(),
        };
        Outcome { gained: self.work(&outcome).0, ..outcome }
    }

    /// The contacts with friction of a stage without anything given.
    pub(super) fn at_rest(&self) -> Vec<Frictional> {
        self.collision.rubbing().iter().map(ImpactFriction::at_rest).collect()
    }

    /// The first stage.
    pub(super) fn stage(
        &self,
        bias: &DVector<f64>,
        contacts: &[Frictional],
        wanted: SolutionFilter,
    ) -> Result<ImpactStage, CollisionError> {
        let mut kkt = self.problem(&self.collision.applied, bias);
        let found = solve(&mut kkt, &self.choice(), (&self.candidates, contacts), wanted)?;
        let nothing = DVector::zeros(self.approach.len());
        Ok(self.add(&kkt, &self.collision.rates, &nothing, found))
    }

    /// The second stage of Poisson's law: contacts are given e Pᶜ.
    pub(super) fn expansion(&self, first: &ImpactStage, factor: f64) -> Result<ImpactStage, CollisionError> {
        let rebound = DVector::from_fn(first.impulses.len(), |row, _| {
            factor * self.restitution(row) * first.impulses[row].max(0.0)
        });
        let contacts = self.collision.rubbing().into_iter().map(|it| {
            let given = rebound[it.normal];
            if given <= 0.0 {
                return it.at_rest();
            }
            let friction = Bound { slope: it.mu, offset: it.mu * given };
            let returned = factor * self.restitution(it.normal) * it.restitution * first.impulses[it.tangent];
            let least = Bound { slope: 0.0, offset: -returned.abs() };
            Frictional::given(
                (it.normal, it.tangent),
                ImpulseBounds {
                    forward: if returned > 0.0 { least } else { friction },
                    backward: if returned < 0.0 { least } else { friction },
                },
            )
        });
        let contacts: Vec<Frictional> = contacts.collect();
        let rebounds = |(_, of): &&(usize, usize)| rebound[*of] > 0.0;
        let rough = self.tied.iter().filter(rebounds).map(|(row, _)| *row);
        let fixed: Vec<usize> = self.fixed.iter().copied().chain(rough).collect();
        let tied: Vec<_> = self.tied.iter().filter(|tie| !rebounds(tie)).copied().collect();
        let rows = LcpRows { fixed: &fixed, tied: &tied, ..self.choice() };
        let mut kkt = self.problem(&self.collision.jacobian.tr_mul(&rebound), &first.opening);
        let found = solve(&mut kkt, &rows, (&self.candidates, &contacts), SolutionFilter::Any)?;
        let stage = self.add(&kkt, &first.rates, &(&first.impulses + rebound), found);
        Ok(ImpactStage {
            unique: stage.unique && first.unique,
            solutions: stage.solutions.max(first.solutions),
            ..stage
        })
    }

    fn add(
        &self,
        kkt: &EquilibratedKkt,
        rates: &DVector<f64>,
        impulses: &DVector<f64>,
        found: FrictionSolution,
    ) -> ImpactStage {
        let rates = rates + found.solution.accelerations;
        ImpactStage {
            opening: self.opening(kkt, &rates),
            rates,
            impulses: impulses + found.solution.reactions,
            unique: found.solution.unique,
            solutions: found.solutions.len(),
        }
    }
}

fn solve(
    kkt: &mut EquilibratedKkt,
    rows: &LcpRows,
    (candidates, contacts): (&[usize], &[Frictional]),
    wanted: SolutionFilter,
) -> Result<FrictionSolution, CollisionError> {
    let smooth = |row: &usize| contacts.iter().all(|contact| contact.normal != *row);
    let candidates: Vec<usize> = candidates.iter().copied().filter(smooth).collect();
    let question = FrictionProblem { rows: LcpRows { candidates: &candidates, ..*rows }, contacts };
    let mut found = match wanted {
        SolutionFilter::Any => kkt.solve_with_friction(&question)?,
        SolutionFilter::Moved => kkt.moved_with_friction(&question)?,
    };
    found.solution.reactions = kkt.share_with_friction(&question, &found);
    Ok(found)
}
