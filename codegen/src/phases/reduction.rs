//! Reduced equations of a contact set from the full ones and the eliminated coordinates.

use super::eliminate::{substitute_all, turned_by_all};
use super::elimination::{CoordinateValue, Elimination};
use super::{Phase, Sliding};
use crate::algebra::{Angle, Quotient, Rational, Series, Symbol};
use crate::motion::{ClosedSet, Dense, Expression, Motion, OpaqueTerm};

/// A phase with an expression of more terms than this is left to the projected form.
pub(super) const TERMS: usize = 200;

/// `None` where an expression outgrows [`TERMS`] or overflows.
pub(super) fn reduce(
    motion: &Motion,
    dense: &Dense,
    set: ClosedSet,
    eliminated: Vec<Elimination>,
) -> Option<Phase> {
    let follows = |e: &&Elimination| !matches!(e.value, CoordinateValue::Rate(_));
    let follow: Vec<usize> = eliminated.iter().filter(follows).map(|e| e.coordinate).collect();
    let kept: Vec<usize> = (0..motion.n).filter(|i| !follow.contains(i)).collect();
    let stuck = |i: &usize| eliminated.iter().any(|e| e.coordinate == *i);
    let moving: Vec<usize> = (0..motion.n).filter(|i| !stuck(i)).collect();
    let substitution = Substitution { eliminated: &eliminated };
    let rates: Vec<Quotient> =
        (0..motion.n).map(|i| substitution.apply(&Series::symbol(Symbol::rate(i)))).collect();
    let accelerations: Vec<Quotient> =
        (0..motion.n).map(|i| substitution.apply(&Series::symbol(Symbol::acceleration(i)))).collect();
    let full = Full {
        mass: grid(motion.n, |i, j| substitution.apply(&dense.mass[i][j])),
        velocity_terms: dense.velocity_terms.iter().map(|h| substitution.apply(h)).collect(),
        forces: forces(motion, dense, set).iter().map(|q| substitution.apply(q)).collect(),
    };
    let Full { mass, velocity_terms, forces } = if eliminated.is_empty() {
        full.clone()
    } else if full.is_small() {
        full.project(&moving, &rates, &accelerations)
    } else {
        return None;
    };
    // Without inertia nothing follows from this set: the run names it.
    if (0..moving.len()).any(|k| mass[k][k].is_zero()) {
        return None;
    }
    let equations = full.reaction_equations(motion, set, &substitution, &accelerations);
    let reactions = equations.solve()?;
    let reaction_steps = equations.back_substitute(&reactions);
    // What sticks to a moving surface has its velocity, whether that depends on time or not.
    let kinetic = match rates.iter().any(|rate| !without_rates(rate, &moving).is_zero()) {
        true => kinetic(&full.mass, &rates),
        false => kinetic(&mass, &own_rates(&moving)),
    };
    let phase = Phase {
        set,
        pivots: eliminated.iter().filter_map(|e| e.pivot.clone()).collect(),
        coordinates: (0..motion.n).map(|i| substitution.coordinate(i)).collect(),
        rates,
        accelerations,
        mass,
        velocity_terms,
        forces,
        kinetic,
        potential: substitution.apply(&motion.potential),
        reactions,
        reaction_steps,
        sliding: motion.sliding(set).filter_map(|slides| substitution.sliding(motion, slides)).collect(),
        opaque_terms: motion
            .opaque_terms
            .iter()
            .map(|opaque_term| substitution.opaque_term(opaque_term))
            .collect(),
        kept,
        moving,
        eliminated,
    };
    (phase.is_small() && !phase.overflows()).then_some(phase)
}

/// Q with the friction forces of sliding contacts, `J_tᵀ R`.
fn forces(motion: &Motion, dense: &Dense, set: ClosedSet) -> Vec<Series> {
    let friction = |i: usize| -> Series {
        let rows = motion.sliding(set);
        rows.map(|(_, row)| &motion.rows[row].jacobian[i] * &Series::symbol(Symbol::reaction(row))).sum()
    };
    dense.forces.iter().enumerate().map(|(i, q)| q + &friction(i)).collect()
}

impl Phase {
    fn is_small(&self) -> bool {
        let reactions = self.reactions.iter().map(|(_, r)| r);
        let all = self.mass.iter().flatten().chain(&self.velocity_terms).chain(&self.forces);
        self.eliminated.is_empty() || all.chain(reactions).all(is_small)
    }
}

impl Phase {
    fn overflows(&self) -> bool {
        let reactions = self.reactions.iter().map(|(_, reaction)| reaction);
        let all = self.mass.iter().flatten().chain(&self.velocity_terms).chain(&self.forces).chain(reactions);
        let all = all.chain(&self.rates).chain(&self.accelerations).chain([&self.kinetic, &self.potential]);
        all.map(Quotient::numerator).chain(&self.pivots).any(Series::is_overflow)
    }
}

pub(super) fn is_small(quotient: &Quotient) -> bool {
    quotient.numerator().len() <= TERMS && !quotient.is_overflow()
}

struct Substitution<'a> {
    eliminated: &'a [Elimination],
}

impl Substitution<'_> {
    fn apply(&self, series: &Series) -> Quotient {
        substitute_all(&series.clone().into(), self.eliminated)
    }

    fn opaque_term(&self, opaque_term: &OpaqueTerm) -> OpaqueTerm {
        let value = |quotient: &Quotient| substitute_all(quotient, self.eliminated);
        let angle = |angle: &Angle| {
            let (angle, lost_turns) = turned_by_all(angle, self.eliminated);
            Expression::Angle(angle).plus_turns(lost_turns)
        };
        let orders = opaque_term.orders.iter().map(|expression| expression.map(&value, &angle)).collect();
        OpaqueTerm { name: opaque_term.name.clone(), orders }
    }

    fn sliding(&self, motion: &Motion, (contact, row): (usize, usize)) -> Option<Sliding> {
        let kinetic = self.apply(&motion.contacts[contact].friction.as_ref()?.kinetic);
        Some(Sliding { contact, row, kinetic })
    }

    fn coordinate(&self, i: usize) -> CoordinateValue {
        match self.eliminated.iter().find(|e| e.coordinate == i) {
            Some(Elimination {
                value: value @ (CoordinateValue::Length(_) | CoordinateValue::Angle(_)),
                ..
            }) => value.clone(),
            _ => CoordinateValue::Angle(Angle::from_symbol(Symbol::coordinate(i))),
        }
    }
}

#[derive(Clone)]
struct Full {
    mass: Vec<Vec<Quotient>>,
    velocity_terms: Vec<Quotient>,
    forces: Vec<Quotient>,
}

impl Full {
    fn is_small(&self) -> bool {
        self.mass.iter().flatten().chain(&self.velocity_terms).chain(&self.forces).all(is_small)
    }

    /// `M̂ = Gᵀ M G`, `ĥ = Gᵀ (h + M β)`, `Q̂ = Gᵀ Q`.
    fn project(&self, kept: &[usize], rates: &[Quotient], accelerations: &[Quotient]) -> Self {
        let n = rates.len();
        let g = grid_of(n, kept.len(), |i, k| rates[i].derivative(Symbol::rate(kept[k])));
        let beta: Vec<Quotient> = accelerations.iter().map(|a| at_rest(a, kept)).collect();
        let moved = grid_of(n, kept.len(), |i, k| dot(&self.mass[i], g.iter().map(|row| &row[k])));
        let rest: Vec<Quotient> =
            (0..n).map(|i| &self.velocity_terms[i] + &dot(&self.mass[i], &beta)).collect();
        let column = |k: usize| g.iter().map(move |row| &row[k]);
        Self {
            mass: grid(kept.len(), |k, l| sum(column(k).zip(&moved).map(|(g, row)| g * &row[l]))),
            velocity_terms: (0..kept.len()).map(|k| dot(&rest, column(k))).collect(),
            forces: (0..kept.len()).map(|k| dot(&self.forces, column(k))).collect(),
        }
    }

    /// `J_eᵀ λ = (M a + h − Q)_e`, eliminated in the order in which the rows gave their
    /// coordinates.
    fn reaction_equations(
        &self,
        motion: &Motion,
        set: ClosedSet,
        substitution: &Substitution,
        accelerations: &[Quotient],
    ) -> ReactionEquations {
        let rows: Vec<usize> = substitution.eliminated.iter().map(|e| e.row).collect();
        debug_assert_eq!(rows.len(), super::rows(motion, set).len());
        let at: Vec<usize> = substitution.eliminated.iter().map(|e| e.coordinate).collect();
        let matrix = grid(rows.len(), |e, r| substitution.apply(&motion.rows[rows[r]].jacobian[at[e]]));
        let right = at.iter().map(|&e| {
            let inertia = dot(&self.mass[e], accelerations);
            &(&inertia + &self.velocity_terms[e]) - &self.forces[e]
        });
        ReactionEquations { right: right.collect(), rows, matrix }
    }
}

/// `matrix · λ = right`, λ those of `rows`.
struct ReactionEquations {
    rows: Vec<usize>,
    matrix: Vec<Vec<Quotient>>,
    right: Vec<Quotient>,
}

impl ReactionEquations {
    /// λ, each by itself.
    fn solve(&self) -> Option<Vec<(usize, Quotient)>> {
        let mut right = self.right.clone();
        solve(&mut self.matrix.clone(), &mut right)?;
        Some(self.rows.iter().copied().zip(right).collect())
    }

    /// λ one after the other: one whose own quotient has several factors below its line follows
    /// from an equation in which the others stand before it. Multiplied out, such a numerator
    /// cancels where one of the factors is small.
    fn back_substitute(&self, solved: &[(usize, Quotient)]) -> Vec<(usize, Quotient)> {
        let n = solved.len();
        let (mut steps, mut left): (Vec<usize>, Vec<usize>) = (0..n).partition(|&r| is_simple(&solved[r].1));
        let mut values: Vec<(usize, Quotient)> = steps.iter().map(|&r| solved[r].clone()).collect();
        let next = |steps: &[usize], left: &[usize]| {
            let pairs = left.iter().flat_map(|&r| (0..n).map(move |equation| (r, equation)));
            let known = |&(r, equation): &(usize, usize)| {
                let other = |k: usize| k == r || self.matrix[equation][k].is_zero() || steps.contains(&k);
                !self.matrix[equation][r].is_zero() && (0..n).all(other)
            };
            let step = |(r, equation)| Some((r, self.step(r, equation))).filter(|(_, step)| is_simple(step));
            pairs.filter(known).find_map(step)
        };
        while let Some((r, step)) = next(&steps, &left) {
            values.push((self.rows[r], step));
            steps.push(r);
            left.retain(|&other| other != r);
        }
        values.extend(left.iter().map(|&r| solved[r].clone()));
        values
    }

    /// λ of one row by one equation and the other λ.
    fn step(&self, r: usize, equation: usize) -> Quotient {
        let others = (0..self.rows.len()).filter(|&k| k != r);
        let symbol = |k: usize| Quotient::from(Series::symbol(Symbol::reaction(self.rows[k])));
        let loads = sum(others.map(|k| &self.matrix[equation][k] * &symbol(k)));
        &(&self.right[equation] - &loads) * &self.matrix[equation][r].recip()
    }
}

/// Whether at most one factor stands below the line.
fn is_simple(quotient: &Quotient) -> bool {
    quotient.factors().len() <= 1
}

/// Gauss–Jordan elimination; a pivot that vanishes is exchanged for a later row's.
pub(super) fn solve(matrix: &mut [Vec<Quotient>], right: &mut [Quotient]) -> Option<()> {
    let n = right.len();
    for k in 0..n {
        let pivot = (k..n)
            .filter(|&i| !matrix[i][k].is_zero())
            .min_by_key(|&i| (matrix[i][k].numerator().len(), i))?;
        matrix.swap(k, pivot);
        right.swap(k, pivot);
        let inverse = matrix[k][k].recip();
        for entry in &mut matrix[k] {
            *entry = &*entry * &inverse;
        }
        right[k] = &right[k] * &inverse;
        for i in (0..n).filter(|&i| i != k) {
            let factor = matrix[i][k].clone();
            if factor.is_zero() {
                continue;
            }
            for j in k..n {
                matrix[i][j] = &matrix[i][j] - &(&factor * &matrix[k][j]);
            }
            right[i] = &right[i] - &(&factor * &right[k]);
            if !is_small(&right[i]) {
                return None;
            }
        }
    }
    Some(())
}

/// β: what remains of an acceleration when the kept ones vanish.
fn at_rest(acceleration: &Quotient, kept: &[usize]) -> Quotient {
    kept.iter().fold(acceleration.clone(), |a, &k| {
        a.substitute_quotient(Symbol::acceleration(k), &Series::zero().into())
    })
}

/// What remains of a rate when the kept ones vanish.
fn without_rates(rate: &Quotient, kept: &[usize]) -> Quotient {
    kept.iter()
        .fold(rate.clone(), |rate, &k| rate.substitute_quotient(Symbol::rate(k), &Series::zero().into()))
}

fn own_rates(moving: &[usize]) -> Vec<Quotient> {
    moving.iter().map(|&i| Series::symbol(Symbol::rate(i)).into()).collect()
}

/// `½ uᵀ M u`.
fn kinetic(mass: &[Vec<Quotient>], rates: &[Quotient]) -> Quotient {
    let half = Quotient::from(Series::constant(Rational::new(1, 2)));
    let n = rates.len();
    let pairs = (0..n).flat_map(|k| (0..n).map(move |l| (k, l)));
    sum(pairs.map(|(k, l)| &mass[k][l] * &(&(&rates[k] * &rates[l]) * &half)))
}

fn dot<'a>(a: &'a [Quotient], b: impl IntoIterator<Item = &'a Quotient>) -> Quotient {
    sum(a.iter().zip(b).filter(|(a, b)| ![a, b].iter().any(|factor| factor.is_zero())).map(|(a, b)| a * b))
}

/// The sum, series among the terms all at once.
fn sum(terms: impl Iterator<Item = Quotient>) -> Quotient {
    let mut quotients = Vec::new();
    let series: Series = terms
        .filter_map(|term| match term.as_series() {
            Some(series) => Some(series.clone()),
            None => {
                quotients.push(term);
                None
            }
        })
        .sum();
    quotients.into_iter().fold(series.into(), |sum: Quotient, term| &sum + &term)
}

fn grid(n: usize, entry: impl Fn(usize, usize) -> Quotient) -> Vec<Vec<Quotient>> {
    grid_of(n, n, entry)
}

fn grid_of(n: usize, m: usize, entry: impl Fn(usize, usize) -> Quotient) -> Vec<Vec<Quotient>> {
    (0..n).map(|i| (0..m).map(|j| entry(i, j)).collect()).collect()
}
