//! First integrals of a contact set.
//!
//! - The energy `T + V`, where every force has a potential and nothing depends on time.
//! - The momentum `p = ξᵀ M q̇` of a displacement ξ of the coordinates that changes neither T nor
//!   V: `ṗ = ξᵀ (∂T/∂q + Q) = 0`; of one coordinate it is the momentum of a cyclic coordinate.
//! - The energy about the mass centre along such a displacement with a constant force F,
//!   `M̄ = ξᵀ M ξ` constant: `T − p²/(2 M̄) + V + F x` with `p = M̄ ẋ`: falls under gravity.

mod evaluate;
mod kernel;

use liftoff_codegen::Analysis;
use liftoff_codegen::algebra::{Quotient, Rational, Series, Symbol, work};
use liftoff_codegen::math::{Equation, Math};
use liftoff_codegen::motion::OpaqueTerm;
use liftoff_codegen::phases::Phase;

use crate::phase::Named;
use kernel::kernel;

/// Term operations for the integrals of a contact set.
const WORK: u64 = 5_000_000;

/// What an integral is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// T + V.
    Energy,
    /// Of coordinates that nothing depends on: their names, with the multiples in which they move
    /// together.
    Momentum(Vec<(i64, String)>),
    /// That of the motion about the mass centre.
    InternalEnergy,
}

/// A function of coordinates and rates that stays what it is.
#[derive(Clone, Debug)]
pub struct Integral {
    /// What it is.
    pub kind: Kind,
    /// `E = …`.
    pub equation: Equation,
    value: Quotient,
    /// What it contains that is no series.
    opaque_terms: Vec<OpaqueTerm>,
}

/// All of a contact set.
pub(crate) fn find_integrals(analysis: &Analysis, phase: &Phase) -> Vec<Integral> {
    let named = Named::new(analysis, phase);
    work::limited(WORK, || {
        let mut integrals = Vec::new();
        if phase.moving.is_empty() {
            return integrals;
        }
        if named.conserves_energy().is_ok() || named.has_springs_only() {
            integrals.push(named.energy());
        }
        // A coordinate whose rate alone is determined has no equation of motion of its own.
        if phase.kept == phase.moving && !analysis.motion.is_timed() {
            integrals.extend(named.momenta());
            integrals.extend(named.internal_energy());
        }
        integrals.retain(|integral| !integral.value.is_overflow());
        integrals
    })
}

impl Named<'_> {
    fn integral(&self, kind: Kind, left: Math, value: Quotient) -> Integral {
        let equation = Equation::new(left, self.writer.quotient(&value));
        Integral { kind, equation, value, opaque_terms: self.phase.opaque_terms.clone() }
    }

    fn energy(&self) -> Integral {
        let energy = &self.phase.kinetic + &self.phase.potential;
        self.integral(Kind::Energy, Math::symbol("E"), energy)
    }

    fn momenta(&self) -> Vec<Integral> {
        let slopes = self
            .phase
            .moving
            .iter()
            .zip(&self.phase.forces)
            .map(|(&i, force)| vec![self.phase.kinetic.derivative(Symbol::coordinate(i)), force.clone()]);
        let displacements = kernel(&slopes.collect::<Vec<_>>());
        let momentum = |displacement: Vec<Rational>| {
            let named = self.displaced(&displacement);
            let left = match named.as_slice() {
                [(1, name)] => Math::Entry("p", vec![Math::symbol(name)]),
                _ => Math::symbol("p"),
            };
            self.integral(Kind::Momentum(named), left, self.momentum(&displacement))
        };
        displacements.into_iter().map(momentum).collect()
    }

    /// Coordinates with their multiples.
    fn displaced(&self, displacement: &[Rational]) -> Vec<(i64, String)> {
        let name = |i: usize| self.analysis.kinematics.coordinates[i].name.clone();
        let parts = self.phase.moving.iter().zip(displacement).filter(|(_, k)| !k.is_zero());
        parts.map(|(&i, k)| (i64::try_from(k.numerator()).unwrap_or(0), name(i))).collect()
    }

    /// ξᵀ M q̇.
    fn momentum(&self, displacement: &[Rational]) -> Quotient {
        let rows = displacement.iter().zip(&self.phase.mass);
        let moving = || self.phase.moving.iter().map(|&i| Quotient::from(Series::symbol(Symbol::rate(i))));
        rows.flat_map(|(k, row)| row.iter().zip(moving()).map(|(m, rate)| scaled(&(m * &rate), *k))).sum()
    }

    fn internal_energy(&self) -> Option<Integral> {
        let slopes = self.phase.moving.iter();
        let slopes = slopes.map(|&i| vec![self.phase.kinetic.derivative(Symbol::coordinate(i))]);
        let displacements = kernel(&slopes.collect::<Vec<_>>());
        displacements.into_iter().find_map(|displacement| {
            let force: Quotient =
                displacement.iter().zip(&self.phase.forces).map(|(k, q)| scaled(q, *k)).sum();
            let carried: Vec<Quotient> = self
                .phase
                .mass
                .iter()
                .map(|row| row.iter().zip(&displacement).map(|(m, k)| scaled(m, *k)).sum())
                .collect();
            let mass: Quotient = displacement.iter().zip(&carried).map(|(k, m)| scaled(m, *k)).sum();
            let constant = |q: &Quotient| !q.is_zero() && self.is_constant(q);
            // The force on every coordinate is that of a field along the displacement.
            let uniform =
                self.phase.forces.iter().zip(&carried).all(|(q, m)| (&(q * &mass) - &(&force * m)).is_zero());
            if !constant(&force) || !constant(&mass) || !uniform || self.phase.moving.len() < 2 {
                return None;
            }
            let momentum = self.momentum(&displacement);
            let half = scaled(&(&(&momentum * &momentum) / &mass), Rational::HALF);
            Some(self.integral(Kind::InternalEnergy, Math::symbol("E_c"), &self.phase.kinetic - &half))
        })
    }

    fn is_constant(&self, quotient: &Quotient) -> bool {
        quotient.as_series().is_some_and(|series| series.symbols().iter().all(|symbol| symbol.is_parameter()))
    }
}

fn scaled(quotient: &Quotient, k: Rational) -> Quotient {
    quotient * &Quotient::from(Series::constant(k))
}
