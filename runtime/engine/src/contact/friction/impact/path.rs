//! Routh's path of a single contact (*Dynamics of a System of Rigid Bodies*, 1905, part I, articles
//! 180 to 194): velocities are linear in the normal impulse P while the contact slips in one sense,
//! or sticks,
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
//! Where normal and tangent move as one, W_NN W_tt = W_Nt² as at the tip of a bar on a pin, ġ and v
//! vanish together, and a contact that then sticks moves no more: by Poisson's and Stronge's laws
//! it stays so, and by Newton's with e > 0 there is no path.
//!
//! While the contact slips towards Painlevé's side, dġ/dP < 0, the compression grows until the slip
//! ends, as it does on a path from ġ = 0: the impact without collision.

use nalgebra::DVector;

use super::super::super::impact::Stages;
use super::super::super::impulse::{CollisionError, ImpulseMethod, Outcome, Row};
use super::super::problem::ActiveRows;
use super::ImpactFriction;
use crate::contact::equilibrated_kkt::EquilibratedKkt;
use crate::model::Law;
use crate::numerics::zero::SOLVED;
use crate::scalar::Scalar;

/// Pieces of a path at most: slip, reversed slip or stick, each in compression and restitution.
const PIECES: usize = 8;

/// A contact that strikes, on numbers `S`.
#[derive(Debug, Clone, Copy)]
pub struct RouthContact<S> {
    /// W_NN, its normal velocity by its normal impulse, 1/kg.
    pub w_nn: S,
    /// W_Nt.
    pub w_nt: S,
    /// W_tt, its slip velocity by its friction impulse.
    pub w_tt: S,
    /// μ.
    pub mu: S,
    /// e, between 0 and 1.
    pub e: S,
    /// What e relates.
    pub law: Law,
}

/// A point of a path.
#[derive(Debug, Clone, Copy)]
pub struct Vertex<S> {
    /// ġ, m/s.
    pub normal: S,
    /// v, m/s.
    pub slip: S,
    /// P, N s.
    pub impulse: S,
    /// P_t, N s.
    pub friction: S,
    /// ∫ ġ dP.
    work: S,
}

/// The vertices of a path, the one where the compression ends among them.
#[derive(Debug, Clone)]
pub struct Path<S> {
    /// From the approach to the end.
    pub vertices: Vec<Vertex<S>>,
    /// The one where the compression ends.
    pub compressed: usize,
}

impl<S: Scalar> RouthContact<S> {
    /// The path from approach and slip velocities; `None` where it has no end.
    pub fn path(&self, normal: S, slip: S) -> Option<Path<S>> {
        let zero = S::ZERO;
        let start = Vertex { normal, slip, impulse: zero, friction: zero, work: zero };
        let mut vertices = Vec::with_capacity(PIECES / 2);
        vertices.push(start);
        let mut compressed = None;
        let mut sense = if slip == zero { self.sense_from_rest() } else { signum(slip) };
        for _ in 0..PIECES {
            let now = vertices[vertices.len() - 1];
            let ratio = self.ratio(sense);
            let stops = (now.slip != zero).then(|| -(now.slip / (self.w_nt + ratio * self.w_tt)));
            let stops = stops.filter(|length| *length > zero);
            let ends = match compressed {
                None => self.compression(&now, ratio),
                Some(at) => self.restitution(&start, &vertices[at], &now, ratio),
            };
            let is_stopped = stops.is_some_and(|stops| ends.is_none_or(|ends| no_later(stops, ends)));
            let is_ended = ends.is_some_and(|ends| stops.is_none_or(|stops| no_later(ends, stops)));
            let length = if is_stopped { stops? } else { ends? };
            if !length.is_finite() {
                return None;
            }
            let mut next = self.advance(&now, sense, length);
            if is_stopped {
                next.slip = zero;
                sense = self.sense_from_rest();
            }
            if is_ended && compressed.is_none() {
                next.normal = zero;
                compressed = Some(vertices.len());
            } else if is_ended {
                if !self.law.has_phases() {
                    next.normal = -self.e * start.normal;
                }
                vertices.push(next);
                return compressed.map(|compressed| Path { vertices, compressed });
            }
            vertices.push(next);
        }
        None
    }

    /// r of a sense, zero for a contact that sticks.
    fn ratio(&self, sense: i8) -> S {
        match sense {
            0 if self.w_tt > S::ZERO => -(self.w_nt / self.w_tt),
            0 => S::ZERO,
            _ => -(S::ratio(sense.into(), 1) * self.mu),
        }
    }

    /// What follows at v = 0.
    fn sense_from_rest(&self) -> i8 {
        if self.w_nt.abs() <= self.mu * self.w_tt { 0 } else { signum(self.w_nt) }
    }

    /// dġ/dP.
    fn rise(&self, ratio: S) -> S {
        let rise = self.w_nn + ratio * self.w_nt;
        if rise.abs() <= S::from_f64(SOLVED) * self.w_nn { S::ZERO } else { rise }
    }

    fn advance(&self, now: &Vertex<S>, sense: i8, length: S) -> Vertex<S> {
        let ratio = self.ratio(sense);
        let rise = self.rise(ratio);
        Vertex {
            normal: now.normal + rise * length,
            slip: match sense {
                0 => S::ZERO,
                _ => now.slip + (self.w_nt + ratio * self.w_tt) * length,
            },
            impulse: now.impulse + length,
            friction: now.friction + ratio * length,
            work: now.work + (now.normal + S::ratio(1, 2) * rise * length) * length,
        }
    }

    /// The impulse to the end of the compression on this piece; none where it does not end.
    fn compression(&self, now: &Vertex<S>, ratio: S) -> Option<S> {
        let rise = self.rise(ratio);
        (rise > S::ZERO).then(|| positive(-(now.normal / rise)))
    }

    /// The impulse to the end of the restitution on this piece; none where it does not end.
    fn restitution(&self, start: &Vertex<S>, compressed: &Vertex<S>, now: &Vertex<S>, ratio: S) -> Option<S> {
        let rise = self.rise(ratio);
        let left = match self.law {
            Law::Newton | Law::Moreau if now.normal >= -self.e * start.normal => S::ZERO,
            Law::Newton | Law::Moreau if rise > S::ZERO => (-self.e * start.normal - now.normal) / rise,
            Law::Newton | Law::Moreau => return None,
            Law::Poisson => (S::ratio(1, 1) + self.e) * compressed.impulse - now.impulse,
            Law::Stronge => {
                // ġ L + rise L²/2 = what is left to be given back.
                let left = -self.e * self.e * compressed.work - (now.work - compressed.work);
                let two = S::ratio(2, 1);
                let root = positive(now.normal * now.normal + two * rise * left).sqrt();
                let is_over = left <= S::ZERO || rise == S::ZERO && now.normal == S::ZERO;
                if is_over { S::ZERO } else { two * left / (now.normal + root) }
            }
        };
        Some(positive(left))
    }
}

/// Whether one impulse is no larger than another, but for rounding.
fn no_later<S: Scalar>(one: S, other: S) -> bool {
    one <= other + S::from_f64(SOLVED) * other
}

fn signum<S: Scalar>(x: S) -> i8 {
    if x < S::ZERO { -1 } else { 1 }
}

fn positive<S: Scalar>(x: S) -> S {
    if x > S::ZERO { x } else { S::ZERO }
}

impl Stages<'_> {
    /// The outcome where a single contact strikes and presses on no other; `None` where that is not
    /// so.
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
        rubbing: Option<ImpactFriction>,
    ) -> Result<Option<Outcome>, CollisionError> {
        let Row::Contact { restitution, law } = self.collision.rows[normal] else { return Ok(None) };
        if rubbing.is_some_and(|it| it.restitution > 0.0 || law == Law::Moreau) {
            return Ok(None);
        }
        let still = DVector::zeros(self.approach.len());
        let kkt = self.problem(&self.collision.applied, &still);
        let held = ActiveRows { rows: self.held(), ..ActiveRows::default() };
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
        let striker = RouthContact { w_nn, w_nt, w_tt, mu, e: restitution, law };
        let slip = rubbing.map_or(0.0, |it| self.approach[it.tangent]);
        let Some(path) = striker.path(self.approach[normal].min(0.0), slip) else { return Ok(None) };
        let pressed = |point: &Vertex<f64>, row: usize| {
            let parts = [point.impulse * speed(row, &by_normal), point.friction * speed(row, &by_tangent)];
            let size = self.approach[row].abs() + parts[0].abs() + parts[1].abs();
            self.approach[row] + parts[0] + parts[1] < -SOLVED * size
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
        (normal, rubbing): (usize, Option<ImpactFriction>),
        law: Law,
        path: &Path<f64>,
    ) -> Result<Outcome, CollisionError> {
        let at = |point: &Vertex<f64>| {
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
        // What the path ends with is known better than from the rates, in which an ill-conditioned
        // mass matrix costs digits.
        if end.normal == 0.0 {
            opening[normal] = 0.0;
        }
        if let Some(it) = rubbing.filter(|_| end.slip == 0.0) {
            opening[it.tangent] = 0.0;
        }
        let compression = if law.has_phases() { Some(at(&path.vertices[path.compressed])?) } else { None };
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
            method: ImpulseMethod::Path,
            gained: 0.0,
            solutions: 1,
            groups: Vec::new(),
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
        let held = ActiveRows { rows: self.held(), ..ActiveRows::default() };
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
            let slack = (SOLVED * size[row].max(changed[0])).max(kkt.slack(row) / kkt.scale[kkt.n + row]);
            if speed.abs() <= slack {
                *speed = 0.0;
            }
        }
        opening
    }
}
