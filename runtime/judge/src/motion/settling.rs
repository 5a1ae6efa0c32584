//! Infinitely many impacts: once the flights between them are too low to matter, the rest of them
//! takes Δ r/(1 − r), Δ the last interval, r the ratio of the last two.

use super::{Follower, Number};
use crate::decision::Undecided;
use crate::expansion::Expansion;
use crate::impact::Impact;
use liftoff_core::scalar::Scalar;

/// The last impacts.
#[derive(Clone, Debug, Default)]
pub(super) struct Rhythm {
    impacts: Vec<(Number, Vec<usize>)>,
}

/// Flights lower than this, in natural lengths, are the last.
const LOW: f64 = 1e-26;
/// Impacts that do not lose more than this do not come to an end.
const KEPT: f64 = 0.9999;
/// With several contacts in turn so many low flights are the end.
const TURNS: usize = 12;

impl Follower<'_> {
    /// Whether the impact of these contacts is the last of infinitely many.
    pub(super) fn beats(&mut self, struck: &[usize], answer: &Result<Impact<Number>, Undecided>) -> bool {
        let Ok(answer) = answer else { return false };
        self.rhythm.impacts.push((self.state.t, struck.to_vec()));
        let count = self.rhythm.impacts.len();
        let [.., (t0, a), (t1, b), (t2, c)] = &self.rhythm.impacts[..] else { return false };
        let [before, last] = [*t1 - *t0, *t2 - *t1].map(Scalar::to_f64);
        let expansion = Expansion::new(self.scene, &self.state);
        let rises =
            struck.iter().map(|&i| expansion.along(&self.scene.contacts[i].row, &answer.v).0.to_f64());
        let low = last * rises.fold(0.0, f64::max) < LOW * self.scene.length;
        let same = a == b && b == c;
        low && last < KEPT * before && (same || count > TURNS)
    }

    /// Lets the flights that are left pass.
    pub(super) fn rest(&mut self) {
        let [.., (t0, a), (t1, b), (t2, c)] = &self.rhythm.impacts[..] else { return };
        let (before, last) = (*t1 - *t0, *t2 - *t1);
        if a == b && b == c {
            let left = last * last / (before - last);
            for (q, &v) in self.state.q.iter_mut().zip(&self.state.v) {
                *q = *q + v * left;
            }
            self.state.t = self.state.t + left;
        }
        self.rhythm.impacts.clear();
    }
}
