//! Conditions that are waited for during a motion.

use super::guards::Guard;
use super::{Change, Follower, NotJudged, Number, Side};
use crate::condition::Relation;
use crate::expansion::Expansion;
use crate::numerics::root::first;
use liftoff_core::scalar::Scalar;

/// Terms below this part of the largest one in a step are zero where a difference may begin with
/// zero.
const ZERO: f64 = 1e-12;
/// The last terms of a difference within a step are this part of the first.
const TAIL: f64 = 1e-20;
const PASSES: usize = 4;
/// A difference whose series reach less than this part of the motion's is not analytic: it is
/// passed.
const POLE: f64 = 1e-9;

impl Follower<'_> {
    /// A reach within which the series of what is waited for converge too.
    pub(super) fn heard(&self, expansion: &Expansion<Number>, reach: f64) -> f64 {
        let awaited = self.watch.series(expansion).into_iter().zip(&self.sides);
        let awaited = awaited.filter(|(_, side)| **side != Side::Done).map(|(series, _)| series);
        let least = awaited.map(|series| converges(&series, reach)).fold(reach, f64::min);
        if least < POLE * reach { reach } else { least }
    }

    /// When conditions are met, or are no longer true, within a step.
    pub(super) fn met(&self, expansion: &Expansion<Number>, h: Number, all: &mut Vec<(Number, Guard)>) {
        for (k, series) in self.watch.series(expansion).iter().enumerate() {
            let from = match self.sides[k] {
                Side::Done => continue,
                Side::Fresh => leading(series, h.to_f64()),
                Side::Known => 0,
            };
            let terms = &series[from.min(series.len())..];
            let Some(first_term) = terms.first().filter(|_| terms.iter().all(|c| c.is_finite())) else {
                continue;
            };
            let positive = *first_term > Number::ZERO;
            let sinking: Vec<Number> = terms.iter().map(|&c| if positive { c } else { -c }).collect();
            let waits = match self.conditions[k].relation {
                Relation::Changes => true,
                Relation::Falls => positive,
                Relation::Rises => !positive,
            };
            let guard = if waits { Guard::Met(k) } else { Guard::Over(k) };
            all.extend(first(&sinking, h).map(|s| (s, guard)));
        }
    }

    /// What is known of the differences after a step.
    pub(super) fn hear(&mut self, guards: &[Guard]) {
        for (k, side) in self.sides.iter_mut().enumerate() {
            let at_zero = guards.contains(&Guard::Over(k)) || guards.contains(&Guard::Met(k));
            *side = match *side {
                Side::Done => Side::Done,
                _ if at_zero => Side::Fresh,
                _ => Side::Known,
            };
        }
    }

    /// Whether the motion ends with these: in the state before any impact.
    pub(super) fn ends(&mut self, guards: &[Guard], struck: &[usize]) -> bool {
        let stops = |k: usize| self.conditions[k].action.is_none();
        let met = guards.iter().any(|guard| matches!(*guard, Guard::Met(k) if stops(k)));
        let barred = struck.iter().any(|&i| self.ends_at_impacts || self.scene.contacts[i].stop);
        if !met && !barred {
            return false;
        }
        if barred {
            self.record(Change::Impact, struck.to_vec());
        }
        if met {
            self.record(Change::Stop, Vec::new());
        }
        self.ended = true;
        true
    }

    /// Does what was to be done where a condition is met.
    pub(super) fn answer(&mut self, guards: &[Guard]) -> Result<(), NotJudged> {
        for guard in guards {
            let Guard::Met(k) = *guard else { continue };
            self.sides[k] = Side::Done;
            if let Some(action) = &self.conditions[k].action {
                self.act(action)?;
            }
        }
        Ok(())
    }
}

/// The place of the first term that is not zero.
fn leading(series: &[Number], h: f64) -> usize {
    let sizes = series.iter().enumerate().map(|(k, c)| c.abs().to_f64() * h.powi(k as i32));
    let sizes: Vec<f64> = sizes.collect();
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    sizes.iter().position(|&size| size > ZERO * largest).unwrap_or(series.len())
}

/// How far a series reaches, if it is no further than this: its first terms are those within that
/// reach.
fn converges(series: &[Number], reach: f64) -> f64 {
    (0..PASSES).fold(reach, |reach, _| nearer(series, reach))
}

fn nearer(series: &[Number], reach: f64) -> f64 {
    let size = |k: usize| series.get(k).map_or(0.0, |c| c.abs().to_f64());
    let first = (0..4).map(|k| size(k) * reach.min(1e100).powi(k as i32)).fold(0.0, f64::max);
    let last = series.len().saturating_sub(3).max(4)..series.len();
    let of = |k: usize| (TAIL * first / size(k)).powf(1.0 / k as f64);
    last.map(of).filter(|x| !x.is_nan()).fold(reach, f64::min)
}
