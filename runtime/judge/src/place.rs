//! Public states, coordinates and rates as a user sees them, and maximal ones.

use crate::expansion::{Expansion, Slot, State};
use crate::numerics::linear::Factors;
use crate::scene::{Row, Scene};
use crate::tape::{Node, whole};
use liftoff_core::scalar::Scalar;

const ITERATIONS: usize = 60;

/// Whole turns, which leave (−π, π] of an angle.
fn turns<S: Scalar>(angle: S) -> f64 {
    let turns = angle.to_f64() / core::f64::consts::TAU;
    (turns - 0.5 - 1e-9).ceil()
}

impl<S: Scalar> Scene<S> {
    /// The maximal state of a public one, nearest to a guess, and by how much the constraints
    /// contradict it, in natural lengths.
    pub(crate) fn placed(&self, t: S, public: &[S], guess: &[S]) -> (State<S>, f64) {
        let m = self.readings.len();
        let zeros = vec![S::ZERO; self.n()];
        let mut state = State { t, q: guess.to_vec(), v: zeros };
        let rows: Vec<&Row> = self.readings.iter().chain(&self.joints).collect();
        let target = |i: usize| if i < m { public[i] } else { S::ZERO };
        // Directions are linear in the coordinates, and positions are once directions are known.
        let angular: Vec<usize> = (0..rows.len()).filter(|&i| self.is_angular(rows[i])).collect();
        let turning: Vec<&Row> = angular.iter().map(|&i| rows[i]).collect();
        self.newton(&mut state, &turning, |i| target(angular[i]), 1);
        let left = self.newton(&mut state, &rows, target, ITERATIONS);
        let expansion = Expansion::new(self, &state);
        let rates: Vec<S> = rows
            .iter()
            .enumerate()
            .map(|(i, row)| {
                let given = if i < m { public[m + i] } else { S::ZERO };
                given - expansion.series.get(row.prescribed_gap_rate, 0)
            })
            .collect();
        state.v = self.nearest(&expansion, &rows, &rates);
        (state, left)
    }

    /// The state that the kept entries of a public one have where rows are closed.
    pub(crate) fn complete(&self, state: &mut State<S>, public: &[S], (kept, closed): (&[usize], &[Slot])) {
        let m = self.readings.len();
        let closed: Vec<&Row> = closed.iter().map(|&slot| self.slot(slot)).collect();
        let read = |entries: core::ops::Range<usize>| {
            kept.iter().copied().filter(|entry| entries.contains(entry)).collect::<Vec<_>>()
        };
        let (positions, rates) = (read(0..m), read(m..2 * m));
        let holonomic = closed.iter().copied().filter(|row| row.value.is_some());
        let rows: Vec<&Row> = positions.iter().map(|&i| &self.readings[i]).chain(holonomic).collect();
        let target = |i: usize| positions.get(i).map_or(S::ZERO, |&entry| public[entry]);
        self.newton(state, &rows, target, ITERATIONS);
        let expansion = Expansion::new(self, state);
        let rows: Vec<&Row> = rates.iter().map(|&i| &self.readings[i - m]).chain(closed).collect();
        let wanted = |i: usize| rates.get(i).map_or(S::ZERO, |&entry| public[entry]);
        let targets: Vec<S> =
            rows.iter().enumerate().map(|(i, row)| wanted(i) - expansion.rate(row)).collect();
        let change = self.nearest(&expansion, &rows, &targets);
        state.v.iter_mut().zip(&change).for_each(|(v, &change)| *v = *v + change);
    }

    /// Springs and drives measure angles that lie within half a turn at the figure.
    pub(crate) fn wind(&mut self, turned: &[(Node, Node)]) {
        if turned.is_empty() {
            return;
        }
        let figure = State { t: S::ZERO, q: self.figure.clone(), v: vec![S::ZERO; self.n()] };
        let mut public = self.public(&figure);
        for (value, row) in public.iter_mut().zip(&self.readings) {
            if self.is_angular(row) {
                *value = *value - S::from_f64(turns(*value)) * (S::pi() + S::pi());
            }
        }
        let (state, _) = self.placed(S::ZERO, &public, &self.figure);
        let series = Expansion::new(self, &state).series;
        for &(measured, taken) in turned {
            let whole = S::from_f64(turns(series.get(measured, 0)));
            self.tape.adjust(taken, whole * (S::pi() + S::pi()));
        }
    }

    fn is_angular(&self, row: &Row) -> bool {
        !row.gradient.is_empty() && row.gradient.iter().all(|(i, _)| self.angles[*i])
    }

    /// The smallest change of positions that satisfies rows, again and again; the largest residual
    /// that stays.
    fn newton(&self, state: &mut State<S>, rows: &[&Row], target: impl Fn(usize) -> S, most: usize) -> f64 {
        let mut best = f64::INFINITY;
        for _ in 0..most {
            let expansion = Expansion::new(self, state);
            let value = |row: &Row| row.value.map_or(S::ZERO, |node| expansion.series.get(node, 0));
            let residuals: Vec<S> = rows.iter().enumerate().map(|(i, row)| target(i) - value(row)).collect();
            let unit = |row: &Row| if self.is_angular(row) { 1.0 } else { self.length };
            let sizes = residuals.iter().zip(rows).map(|(x, row)| x.abs().to_f64() / unit(row));
            let size = sizes.fold(0.0, f64::max);
            let settled = size <= 64.0 * S::EPSILON.to_f64() || (size < 1e-9 && size >= 0.5 * best);
            best = best.min(size);
            if settled && most > 1 {
                break;
            }
            let change = self.nearest(&expansion, rows, &residuals);
            state.q.iter_mut().zip(&change).for_each(|(q, &change)| *q = *q + change);
        }
        best
    }

    /// The least x with J x = targets, angles in the natural length.
    fn nearest(&self, expansion: &Expansion<S>, rows: &[&Row], targets: &[S]) -> Vec<S> {
        let n = self.n();
        let size = n + rows.len();
        let mut matrix = vec![vec![S::ZERO; size]; size];
        for i in 0..n {
            let weight = if self.angles[i] { self.length * self.length } else { 1.0 };
            matrix[i][i] = S::from_f64(weight);
        }
        for (r, row) in rows.iter().enumerate() {
            for &(i, node) in &row.gradient {
                let entry = expansion.series.get(node, 0);
                matrix[n + r][i] = entry;
                matrix[i][n + r] = entry;
            }
        }
        let mut right = vec![S::ZERO; n];
        right.extend(targets);
        let (mut x, ..) = Factors::factorise(matrix, n).solve(&right);
        x.truncate(n);
        x
    }

    /// Coordinates and rates as a user sees them.
    pub(crate) fn public(&self, state: &State<S>) -> Vec<S> {
        let expansion = Expansion::new(self, state);
        let value = |row: &Row| row.value.map_or(S::ZERO, |node| expansion.series.get(node, 0));
        let values = self.readings.iter().map(value);
        values.chain(self.readings.iter().map(|row| expansion.rate(row))).collect()
    }

    /// Brings a state back on rows: positions, then rates.
    pub(crate) fn project(&self, state: &mut State<S>, slots: &[Slot]) -> f64 {
        let rows: Vec<&Row> = slots.iter().map(|&slot| self.slot(slot)).collect();
        let holonomic: Vec<&Row> = rows.iter().copied().filter(|row| row.value.is_some()).collect();
        let left = self.newton(state, &holonomic, |_| S::ZERO, 8);
        let expansion = Expansion::new(self, state);
        let targets: Vec<S> = rows.iter().map(|row| -expansion.rate(row)).collect();
        let change = self.nearest(&expansion, &rows, &targets);
        state.v.iter_mut().zip(&change).for_each(|(v, &change)| *v = *v + change);
        left
    }

    /// The largest speed of a state, angles in the natural length.
    pub(crate) fn speed(&self, state: &State<S>) -> f64 {
        let size = |(v, &angle): (&S, &bool)| v.abs().to_f64() * if angle { self.length } else { 1.0 };
        state.v.iter().zip(&self.angles).map(size).fold(0.0, f64::max)
    }

    /// T and V.
    pub(crate) fn energy(&self, state: &State<S>) -> [S; 2] {
        let squares = state.v.iter().zip(&self.masses).map(|(&v, &m)| m * v * v);
        let kinetic = squares.fold(S::ZERO, |sum, x| sum + x) / whole(2);
        let expansion = Expansion::new(self, state);
        [kinetic, expansion.series.get(self.potential, 0)]
    }
}
