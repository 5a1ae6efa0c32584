//! Orbits followed in a parameter p by pseudo-arclength (Keller, *Numerical solution of bifurcation
//! and nonlinear eigenvalue problems*, 1977; Nayfeh and Balachandran, *Applied Nonlinear Dynamics*,
//! 6.1): with z = (x, p) and t the unit tangent of the branch,
//!
//! ```text
//! P(x, p) = x + s,    tᵀ (z − z₀ − h t) = 0
//! ```
//!
//! On the way a fold is where t has no part along p, a branch point where the determinant of both
//! equations changes its sign (Keller), a flip where a multiplier is −1, a torus where a complex
//! pair has modulus 1; each is located along h by regula falsi (Illinois: Dowell and Jarratt, BIT
//! 11, 1971). A branch ends where the sequence of events of a turn changes, as at grazing: it is
//! followed up to there by bisection.

use core::fmt;

use liftoff::EventKind;
use nalgebra::{Complex, DMatrix, DVector};

use super::newton::{ACCEPTED, Attempt, FOUND};
use super::surface::{OrbitParameters, solve};
use super::turn::sequence;
use super::{Orbit, OrbitError, ReturnMap, describe_events};

/// Steps along the branch, of (x, p) in natural units and p of its first value.
const FIRST: f64 = 0.01;
const LARGEST: f64 = 0.05;
/// Below this a step fails because the branch ends.
const SMALLEST: f64 = 1e-3;
/// How closely its end is bracketed.
const BRACKET: f64 = 1e-10;
/// Singular values below this, in natural units, are zero: the root of the error of a turn, as of a
/// double multiplier 1.
const FAMILY: f64 = 1e-6;
const CORRECTIONS: usize = 12;
/// Corrections after which steps grow.
const FEW: usize = 4;
const GROWTH: f64 = 1.5;
const MOST_POINTS: usize = 2000;
/// Evaluations of regula falsi.
const LOCATIONS: usize = 40;
/// A test function this small, relative to its values at both ends, is zero.
const LOCATED: f64 = 1e-10;

/// Where branches cross, the equations of an orbit are singular: it may not be found so near to
/// that, in steps.
const BESIDE: f64 = 1e-2;

/// What is special about an orbit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Special {
    /// The branch turns back in the parameter; a multiplier is 1.
    Fold,
    /// A multiplier is 1 and the branch does not turn back: another one crosses it.
    Branch,
    /// A multiplier is −1: an orbit of twice the period branches off.
    Flip,
    /// A complex pair of multipliers has modulus 1.
    Torus,
}

impl fmt::Display for Special {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Fold => "fold",
            Self::Branch => "branch point",
            Self::Flip => "flip",
            Self::Torus => "torus",
        })
    }
}

/// An orbit of a branch.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchPoint {
    /// The orbit.
    pub orbit: Orbit,
    /// What is special about it, if anything is.
    pub special: Option<Special>,
}

/// Where a branch ends.
#[derive(Debug, Clone, PartialEq)]
pub enum BranchEnd {
    /// At the value that was asked for, or behind a fold back at that of its start.
    Reached,
    /// Beyond the last point the sequence of events is another.
    Sequence(Vec<(EventKind, Vec<&'static str>)>),
    /// Beyond the last point there is no such orbit.
    Lost(OrbitError),
    /// At the largest number of points.
    Long,
}

impl fmt::Display for BranchEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reached => f.write_str("followed to the end"),
            Self::Sequence(events) => {
                let events = describe_events(events);
                write!(f, "beyond the last one the sequence of events changes: {events}")
            }
            Self::Lost(why) => write!(f, "beyond the last one no orbit is found: {why}"),
            Self::Long => f.write_str("the branch was ended at the maximum number of orbits"),
        }
    }
}

/// A branch of orbits.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch {
    /// In their order along it.
    pub points: Vec<BranchPoint>,
    /// Where it ends.
    pub end: BranchEnd,
}

/// An orbit with the tangent of its branch.
struct TangentPoint {
    place: OrbitParameters,
    attempt: Attempt,
    /// In natural units, the part along p last.
    tangent: DVector<f64>,
    corrections: usize,
}

impl TangentPoint {
    fn value(&self) -> f64 {
        self.place.varied.map_or(0.0, |i| self.place.parameters[i])
    }

    fn along_parameter(&self) -> f64 {
        self.tangent[self.tangent.len() - 1]
    }
}

impl ReturnMap<'_> {
    /// The branch of an orbit, from its value of a parameter to another.
    ///
    /// # Errors
    /// The orbit is none, or one of a family with the same parameters.
    pub fn branch(&self, orbit: &Orbit, parameter: usize, to: f64) -> Result<Branch, OrbitError> {
        let from = orbit.parameters[parameter];
        let unit = if from == 0.0 { to.abs() } else { from.abs() };
        let run = self.follow(&orbit.parameters, &orbit.state)?;
        let units = run.scales().state(run.layout())[..orbit.state.len()].to_vec();
        let parameters = orbit.parameters.clone();
        let place =
            OrbitParameters { parameters, varied: Some(parameter), unit, units, scales: run.scales() };
        let attempt = self.attempt(&place, &orbit.state, None)?;
        if self.slopes_with_parameter(&attempt).rank(FAMILY) < attempt.surface.basis.ncols() {
            return Err(OrbitError::Family);
        }
        let mut towards = DVector::zeros(orbit.state.len() + 1);
        towards[orbit.state.len()] = (to - from).signum();
        let tangent = self.tangent(&attempt, &towards);
        let mut now = TangentPoint { place, attempt, tangent, corrections: 0 };
        let mut branch = Branch { points: vec![self.plain(&now)], end: BranchEnd::Long };
        let mut step = FIRST;
        while branch.points.len() < MOST_POINTS {
            let next = match self.next(&now, step) {
                Ok(next) => next,
                Err(_) if step > SMALLEST => {
                    step *= 0.25;
                    continue;
                }
                Err(end) => {
                    let (last, end) = self.last(&now, step, end);
                    branch.points.extend(last.map(|last| self.plain(&last)));
                    branch.end = end;
                    return Ok(branch);
                }
            };
            let outside = |value: f64| (value - to) * (from - to) < 0.0 || (value - from) * (to - from) < 0.0;
            if outside(next.value()) {
                let bound = if (next.value() - to) * (from - to) < 0.0 { to } else { from };
                if let Some((last, step)) =
                    self.located(&now, step, &|point: &TangentPoint| point.value() - bound)
                {
                    self.add_special(&mut branch, &now, (&last, step));
                    branch.points.push(self.plain(&last));
                }
                branch.end = BranchEnd::Reached;
                return Ok(branch);
            }
            self.add_special(&mut branch, &now, (&next, step));
            branch.points.push(self.plain(&next));
            step = if next.corrections <= FEW { LARGEST.min(step * GROWTH) } else { step };
            now = next;
        }
        Ok(branch)
    }

    fn plain(&self, point: &TangentPoint) -> BranchPoint {
        BranchPoint { orbit: self.orbit_of(&point.place, &point.attempt), special: None }
    }

    /// The point after a step, with the same events; else what is there.
    fn next(&self, from: &TangentPoint, step: f64) -> Result<TangentPoint, BranchEnd> {
        let next = self.corrected(from, step).map_err(BranchEnd::Lost)?;
        let [before, after] = [from, &next].map(|point| sequence(&point.attempt.turn.run));
        if before == after { Ok(next) } else { Err(BranchEnd::Sequence(after)) }
    }

    /// The last point before a step that fails, and why it does.
    fn last(&self, from: &TangentPoint, step: f64, mut end: BranchEnd) -> (Option<TangentPoint>, BranchEnd) {
        let (mut low, mut high, mut last) = (0.0, step, None);
        while high - low > BRACKET {
            let middle = 0.5 * (low + high);
            match self.next(from, middle) {
                Ok(point) => (low, last) = (middle, Some(point)),
                Err(why) => (high, end) = (middle, why),
            }
        }
        (last, end)
    }

    fn corrected(&self, from: &TangentPoint, step: f64) -> Result<TangentPoint, OrbitError> {
        let n = from.place.units.len();
        let mut z = DVector::from_fn(n + 1, |i, _| step * from.tangent[i]);
        let mut best: Option<(TangentPoint, f64)> = None;
        for corrections in 0..CORRECTIONS {
            let mut place = OrbitParameters {
                units: from.place.units.clone(),
                parameters: from.place.parameters.clone(),
                ..from.place
            };
            if let Some(i) = place.varied {
                place.parameters[i] += z[n] * place.unit;
            }
            let state = from.attempt.surface.state.iter().zip(z.iter().zip(&place.units));
            let state: Vec<f64> = state.map(|(x, (by, unit))| x + by * unit).collect();
            let attempt = self.attempt(&place, &state, Some(&from.attempt.surface))?;
            let residual = attempt.residual();
            let moves = self.moves(&attempt);
            let change = &moves * self.correction(&attempt, &moves, &from.tangent);
            let tangent = self.tangent(&attempt, &from.tangent);
            let is_better = best.as_ref().is_none_or(|(_, least)| residual < *least);
            if is_better {
                best = Some((TangentPoint { place, attempt, tangent, corrections }, residual));
            }
            if residual <= FOUND || !is_better && best.as_ref().is_some_and(|(_, least)| *least <= ACCEPTED) {
                break;
            }
            z += change;
        }
        match best {
            Some((point, residual)) if residual <= ACCEPTED => Ok(point),
            Some((point, _)) => Err(self.not_found(&point.attempt, CORRECTIONS)),
            None => Err(OrbitError::Held { section: self.section.to_string() }),
        }
    }

    /// ∂(x, p) of the surface by its tangent directions and p.
    fn moves(&self, attempt: &Attempt) -> DMatrix<f64> {
        let surface = &attempt.surface;
        let (n, free) = surface.basis.shape();
        let mut moves = DMatrix::zeros(n + 1, free + 1);
        moves.view_mut((0, 0), (n, free)).copy_from(&surface.basis);
        moves.view_mut((0, free), (n, 1)).copy_from(&surface.motion);
        moves[(n, free)] = 1.0;
        moves
    }

    /// ∂(P − x) by the same.
    fn slopes_with_parameter(&self, attempt: &Attempt) -> DMatrix<f64> {
        let slopes = attempt.slopes(&self.drifting);
        let mut last = &attempt.turn.by_parameter - &attempt.surface.motion;
        self.drifting.iter().for_each(|&entry| last[entry] = 0.0);
        let columns = slopes.ncols();
        let mut all = slopes.insert_column(columns, 0.0);
        all.column_mut(columns).copy_from(&last);
        all
    }

    /// The change of least norm that closes the orbit, across the tangent of the step.
    fn correction(&self, attempt: &Attempt, moves: &DMatrix<f64>, tangent: &DVector<f64>) -> DVector<f64> {
        let slopes = self.slopes_with_parameter(attempt);
        let rows = slopes.nrows();
        let mut system = slopes.insert_row(rows, 0.0);
        system.row_mut(rows).copy_from(&(tangent.transpose() * moves));
        solve(&system, &-attempt.miss.clone().insert_row(rows, 0.0))
    }

    /// The unit tangent that goes on as the one before.
    fn tangent(&self, attempt: &Attempt, before: &DVector<f64>) -> DVector<f64> {
        let svd = self.slopes_with_parameter(attempt).svd(false, true);
        let least = svd.singular_values.argmin().0;
        let right = svd.v_t.map_or_else(|| DVector::zeros(0), |right| right.row(least).transpose());
        let tangent = (self.moves(attempt) * right).normalize();
        if tangent.dot(before) < 0.0 { -tangent } else { tangent }
    }

    /// Adds the special orbits of a step.
    fn add_special(&self, branch: &mut Branch, from: &TangentPoint, (to, step): (&TangentPoint, f64)) {
        for special in [Special::Fold, Special::Branch, Special::Flip, Special::Torus] {
            let test = |point: &TangentPoint| self.test(special, point);
            if test(from) * test(to) < 0.0
                && let Some((point, _)) = self.located(from, step, &test)
                && (special != Special::Torus || self.has_pair_of_modulus_one(&point))
            {
                let orbit = self.orbit_of(&point.place, &point.attempt);
                branch.points.push(BranchPoint { orbit, special: Some(special) });
            }
        }
    }

    /// Changes its sign at a special orbit.
    fn test(&self, special: Special, point: &TangentPoint) -> f64 {
        let multipliers = self.multipliers(&point.attempt);
        match special {
            Special::Fold => point.along_parameter(),
            Special::Branch => self.determinant(point),
            Special::Flip => {
                multipliers.iter().map(|multiplier| multiplier + 1.0).product::<Complex<f64>>().re
            }
            Special::Torus => {
                let pairs = (0..multipliers.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
                pairs.map(|(i, j)| multipliers[i] * multipliers[j] - 1.0).product::<Complex<f64>>().re
            }
        }
    }

    /// Of the slopes of both equations along the surface and p.
    fn determinant(&self, point: &TangentPoint) -> f64 {
        let attempt = &point.attempt;
        let along = attempt.surface.basis.transpose() * self.slopes_with_parameter(attempt);
        let rows = along.nrows();
        let mut system = along.insert_row(rows, 0.0);
        system.row_mut(rows).copy_from(&(point.tangent.transpose() * self.moves(attempt)));
        system.determinant()
    }

    fn has_pair_of_modulus_one(&self, point: &TangentPoint) -> bool {
        let on_circle =
            |multiplier: &Complex<f64>| multiplier.im != 0.0 && (multiplier.norm() - 1.0).abs() < 1e-6;
        self.multipliers(&point.attempt).iter().any(on_circle)
    }

    /// The point of a step at which a function of it is zero, and how far it is.
    fn located(
        &self,
        from: &TangentPoint,
        step: f64,
        test: &dyn Fn(&TangentPoint) -> f64,
    ) -> Option<(TangentPoint, f64)> {
        let end = self.corrected(from, step).ok()?;
        let (mut a, mut b) = ((0.0, test(from)), (step, test(&end)));
        let size = a.1.abs().max(b.1.abs());
        let mut found = (end, step);
        for _ in 0..LOCATIONS {
            let at = b.0 - b.1 * (b.0 - a.0) / (b.1 - a.1);
            let Ok(point) = self.corrected(from, at) else {
                return ((found.1 - at).abs() < BESIDE * step).then_some(found);
            };
            found = (point, at);
            let value = test(&found.0);
            if value.abs() <= LOCATED * size {
                break;
            }
            if value * b.1 < 0.0 {
                a = b
            } else {
                a.1 *= 0.5
            }
            b = (at, value);
        }
        Some(found)
    }
}
