//! Routh's path of a single contact (*Dynamics of a System of Rigid Bodies*, 1905, part I, articles 180 to 194): velocities are
//! linear in the normal impulse P while the contact slips in one sense, or sticks,
//!
//! ```text
//! dġ/dP = W_NN + r W_Nt,    dv/dP = W_Nt + r W_tt,    dP_t/dP = r
//! slip        r = −σ μ
//! v = 0       r = −W_Nt / W_tt    where that is at most μ, else slip in the sense of W_Nt
//! ```
//!
//! The compression ends at ġ = 0 with Pᶜ. The restitution ends
//!
//! ```text
//! Newton      at ġ⁺ = −e ġ⁻
//! Poisson     at P = (1 + e) Pᶜ
//! Stronge     where ∫ ġ dP from Pᶜ on is −e² ∫ ġ dP up to Pᶜ      (Stronge, Impact Mechanics, 2000)
//! ```
//!
//! While the contact slips towards Painlevé's side, dġ/dP < 0, the compression grows until the slip ends, as it does on a
//! path from ġ = 0: the impact without collision.

use nalgebra::DVector;

use super::super::super::impact::Stages;
use super::super::super::impulse::{CollisionError, Method, Outcome, Row};
use super::super::problem::Closed;
use super::Rubbing;
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::model::Law;

/// Velocities below this part of the approach are zero: the path stops slipping, and others are not pressed.
const ROUNDING: f64 = 1e-12;
/// Pieces of a path at most: slip, reversed slip or stick, each in compression and restitution.
const PIECES: usize = 8;

/// The contact in plain numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Striker {
    pub(super) w_nn: f64,
    pub(super) w_nt: f64,
    pub(super) w_tt: f64,
    pub(super) mu: f64,
    pub(super) e: f64,
    pub(super) law: Law,
}

/// A point of a path.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Point {
    /// ġ and v.
    pub(super) normal: f64,
    pub(super) slip: f64,
    /// P and P_t.
    pub(super) impulse: f64,
    pub(super) friction: f64,
    /// ∫ ġ dP.
    work: f64,
}

/// The vertices of a path, the one where the compression ends among them.
#[derive(Debug, Clone)]
pub(super) struct Path {
    pub(super) vertices: Vec<Point>,
    pub(super) compressed: usize,
}

impl Striker {
    /// The path from approach and slip velocities; `None` where it has no end.
    pub(super) fn path(&self, normal: f64, slip: f64) -> Option<Path> {
        let start = Point { normal, slip, ..Point::default() };
        let mut vertices = vec![start];
        let mut compressed = None;
        let mut sense = if slip == 0.0 { self.sense_from_rest() } else { slip.signum() };
        for _ in 0..PIECES {
            let now = vertices[vertices.len() - 1];
            let ratio = self.ratio(sense);
            let stops = (now.slip != 0.0).then(|| -now.slip / (self.w_nt + ratio * self.w_tt));
            let stops = stops.filter(|length| *length > 0.0).unwrap_or(f64::INFINITY);
            let ends = match compressed {
                None => self.compression(&now, ratio),
                Some(at) => self.restitution(&start, &vertices[at], &now, ratio),
            };
            let length = stops.min(ends);
            if !length.is_finite() {
                return None;
            }
            let mut next = self.advance(&now, sense, length);
            if length == stops {
                next.slip = 0.0;
                sense = self.sense_from_rest();
            }
            if length == ends && compressed.is_none() {
                next.normal = 0.0;
                compressed = Some(vertices.len());
            } else if length == ends {
                vertices.push(next);
                return compressed.map(|compressed| Path { vertices, compressed });
            }
            vertices.push(next);
        }
        None
    }

    /// r of a sense, zero for a contact that sticks.
    fn ratio(&self, sense: f64) -> f64 {
        match sense == 0.0 {
            true if self.w_tt > 0.0 => -self.w_nt / self.w_tt,
            true => 0.0,
            false => -sense * self.mu,
        }
    }

    /// What follows at v = 0.
    fn sense_from_rest(&self) -> f64 {
        if self.w_nt.abs() <= self.mu * self.w_tt { 0.0 } else { self.w_nt.signum() }
    }

    fn advance(&self, now: &Point, sense: f64, length: f64) -> Point {
        let ratio = self.ratio(sense);
        let rise = self.w_nn + ratio * self.w_nt;
        Point {
            normal: now.normal + rise * length,
            slip: match sense == 0.0 {
                true => 0.0,
                false => now.slip + (self.w_nt + ratio * self.w_tt) * length,
            },
            impulse: now.impulse + length,
            friction: now.friction + ratio * length,
            work: now.work + (now.normal + 0.5 * rise * length) * length,
        }
    }

    /// The impulse to the end of the compression on this piece.
    fn compression(&self, now: &Point, ratio: f64) -> f64 {
        let rise = self.w_nn + ratio * self.w_nt;
        if rise > 0.0 { (-now.normal / rise).max(0.0) } else { f64::INFINITY }
    }

    /// The impulse to the end of the restitution on this piece.
    fn restitution(&self, start: &Point, compressed: &Point, now: &Point, ratio: f64) -> f64 {
        let rise = self.w_nn + ratio * self.w_nt;
        let left = match self.law {
            Law::Newton if rise > 0.0 => (-self.e * start.normal - now.normal) / rise,
            Law::Newton => f64::INFINITY,
            Law::Poisson => (1.0 + self.e) * compressed.impulse - now.impulse,
            Law::Stronge => {
                // ġ L + rise L²/2 = what is left to be given back.
                let left = -self.e * self.e * compressed.work - (now.work - compressed.work);
                let root = (now.normal * now.normal + 2.0 * rise * left).max(0.0).sqrt();
                if left <= 0.0 { 0.0 } else { 2.0 * left / (now.normal + root) }
            }
        };
        left.max(0.0)
    }
}

impl Stages<'_> {
    /// The outcome where a single contact strikes and presses on no other; `None` where that is not so.
    pub(super) fn along_path(&self) -> Result<Option<Outcome>, CollisionError> {
        let approaching = || self.candidates.iter().filter(|&&row| self.approach[row] < 0.0);
        let (Some(&normal), 1) = (approaching().next(), approaching().count()) else { return Ok(None) };
        if self.tied.iter().any(|(_, with)| *with == normal) {
            return Ok(None);
        }
        let rubbing = self.collision.rubbing().into_iter().find(|it| it.normal == normal);
        self.path_of(normal, rubbing)
    }

    /// The same of a given contact, whether it approaches or has ġ = 0.
    pub(super) fn path_of(
        &self,
        normal: usize,
        rubbing: Option<Rubbing>,
    ) -> Result<Option<Outcome>, CollisionError> {
        let Row::Contact { restitution, law } = self.collision.rows[normal] else { return Ok(None) };
        if rubbing.is_some_and(|it| it.restitution > 0.0) {
            return Ok(None);
        }
        let still = DVector::zeros(self.approach.len());
        let kkt = self.problem(&self.collision.applied, &still);
        let held = Closed { rows: self.held(), ..Closed::default() };
        let singular = CollisionError::Singular;
        let along = |row: usize| {
            let unit = kkt.scale[kkt.n + row];
            kkt.response(&held, &(kkt.column_of(row) / unit)).ok_or(singular)
        };
        let speed = |row: usize, a: &DVector<f64>| kkt.column_of(row).dot(a) / kkt.scale[kkt.n + row];
        let by_normal = along(normal)?;
        let by_tangent = match rubbing {
            Some(it) => along(it.tangent)?,
            None => DVector::zeros(kkt.n),
        };
        let w_nn = speed(normal, &by_normal);
        let tangential = |a: &DVector<f64>| rubbing.map_or(0.0, |it| speed(it.tangent, a));
        let (w_nt, w_tt) = (tangential(&by_normal), tangential(&by_tangent));
        let mu = rubbing.map_or(0.0, |it| it.mu);
        let striker = Striker { w_nn, w_nt, w_tt, mu, e: restitution, law };
        let slip = rubbing.map_or(0.0, |it| self.approach[it.tangent]);
        let Some(path) = striker.path(self.approach[normal].min(0.0), slip) else { return Ok(None) };
        let pressed = |point: &Point, row: usize| {
            let parts = [point.impulse * speed(row, &by_normal), point.friction * speed(row, &by_tangent)];
            let size = self.approach[row].abs() + parts[0].abs() + parts[1].abs();
            self.approach[row] + parts[0] + parts[1] < -ROUNDING * size
        };
        let mut others = self.candidates.iter().filter(|row| **row != normal);
        if others.any(|&row| path.vertices.iter().any(|point| pressed(point, row))) {
            return Ok(None);
        }
        self.end_of_path(&kkt, (normal, rubbing), law, &path).map(Some)
    }

    /// Two-sided rows with their tangents.
    fn held(&self) -> Vec<usize> {
        self.choice().rows(&[])
    }

    fn end_of_path(
        &self,
        kkt: &EquilibratedKkt,
        (normal, rubbing): (usize, Option<Rubbing>),
        law: Law,
        path: &Path,
    ) -> Result<Outcome, CollisionError> {
        let at = |point: &Point| {
            let mut impulses = DVector::zeros(self.approach.len());
            impulses[normal] = point.impulse;
            if let Some(it) = rubbing {
                impulses[it.tangent] = point.friction;
            }
            self.after(kkt, impulses)
        };
        let end = path.vertices[path.vertices.len() - 1];
        let (rates, impulses) = at(&end)?;
        let mut opening = self.opening(kkt, &rates);
        if let Some(it) = rubbing.filter(|_| end.slip == 0.0) {
            opening[it.tangent] = 0.0;
        }
        let compression = match law {
            Law::Newton => None,
            Law::Poisson | Law::Stronge => Some(at(&path.vertices[path.compressed])?),
        };
        let acting = if end.impulse > 0.0 { vec![normal] } else { Vec::new() };
        let outcome = Outcome {
            rates,
            impulses,
            opening,
            acting,
            law,
            compression,
            factor: 1.0,
            unique: true,
            method: Method::Path,
            gained: 0.0,
            solutions: 1,
        };
        Ok(Outcome { gained: self.work(&outcome).0, ..outcome })
    }

    /// Rates after impulses of contacts, and these with the impulses of two-sided rows.
    fn after(
        &self,
        kkt: &EquilibratedKkt,
        mut impulses: DVector<f64>,
    ) -> Result<(DVector<f64>, DVector<f64>), CollisionError> {
        let n = kkt.n;
        let held = Closed { rows: self.held(), ..Closed::default() };
        let equations = kkt.equations(&held)?;
        let force = self.collision.jacobian.tr_mul(&impulses).component_mul(&kkt.scale.rows(0, n));
        let mut right = DVector::zeros(equations.index.len());
        right.rows_mut(0, n).copy_from(&force);
        let x = match equations.solve_for(&right) {
            Some(x) => x,
            None => equations.least_norm(&right, n).ok_or(CollisionError::Singular)?.0,
        };
        for (k, &row) in held.rows.iter().enumerate() {
            impulses[row] += x[n + k] * kkt.scale[n + row];
        }
        let change = DVector::from_fn(n, |i, _| x[i] * kkt.scale[i]);
        Ok((&self.collision.rates + change, impulses))
    }

    /// ġ of every row at the rates, zero where it is but for rounding.
    pub(super) fn opening(&self, kkt: &EquilibratedKkt, rates: &DVector<f64>) -> DVector<f64> {
        let mut opening = self.collision.speed(rates);
        let size = self.collision.speed_size();
        for (row, speed) in opening.iter_mut().enumerate() {
            let changed = self.collision.jacobian.row(row).abs() * rates.abs();
            let slack = (ROUNDING * size[row].max(changed[0])).max(kkt.slack(row) / kkt.scale[kkt.n + row]);
            if speed.abs() <= slack {
                *speed = 0.0;
            }
        }
        opening
    }
}
