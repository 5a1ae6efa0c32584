//! What comes first on the way of a motion.

use core::f64::consts::TAU;

use super::chart::{Charted, Place};
use super::zeros::{First, Function};

/// Values nearer than this, relative to 1 or to themselves, are one: three units in the last place
/// of a double.
const ALIKE: f64 = 4.0 * f64::EPSILON;

/// A direction of the motion from its start.
pub(super) struct Way<'a> {
    pub start: &'a Place,
    pub rising: bool,
}

impl Way<'_> {
    fn distance(&self, place: &Place) -> f64 {
        let ahead = place.value() - self.start.value();
        let ahead = if self.rising { ahead } else { -ahead };
        if self.start.turns { ahead.rem_euclid(TAU) } else { ahead }
    }

    /// A place ahead as the coordinate has it, whole turns counted.
    fn value(&self, place: &Place) -> f64 {
        let (at, start) = (place.value(), self.start.value());
        match self.start.turns {
            true if self.rising && at < start => at + TAU,
            true if !self.rising && at > start => at - TAU,
            _ => at,
        }
    }

    /// Those ahead, the nearest first.
    fn ahead(&self, places: impl IntoIterator<Item = (Place, u32)>) -> Vec<(f64, Place, u32)> {
        let ahead = places.into_iter().map(|(place, k)| (self.distance(&place), place, k));
        let mut ahead: Vec<_> = ahead.filter(|(distance, ..)| *distance > 0.0).collect();
        ahead.sort_by(|a, b| a.0.total_cmp(&b.0));
        ahead
    }

    /// Where a function that is not negative at the start becomes so: its sign changes at each zero
    /// and pole of odd multiplicity.
    fn opening(&self, function: &Function) -> Option<(f64, f64)> {
        let side = usize::from(self.rising);
        let mut negative = function.signs_about(self.start)[side] < 0;
        if negative {
            return Some((0.0, self.start.value()));
        }
        let changes = [&function.above, &function.below].map(|part| part.without(self.start).zeros());
        for (distance, place, k) in self.ahead(changes.into_iter().flatten()) {
            negative ^= k % 2 == 1;
            if negative {
                return Some((distance, self.value(&place)));
            }
        }
        None
    }

    /// Up to where the motion comes to rest, at a zero of its rate.
    pub fn first(&self, functions: &[(String, Function)], turning: &Charted) -> First {
        let openings = functions.iter().filter_map(|(label, of)| Some((self.opening(of)?, label)));
        let openings: Vec<((f64, f64), &String)> = openings.collect();
        let nearest = openings.iter().map(|(opening, _)| *opening).min_by(|a, b| a.0.total_cmp(&b.0));
        let rest = self.ahead(turning.zeros()).into_iter().next();
        match (nearest, rest) {
            (Some((distance, at)), rest) if rest.as_ref().is_none_or(|(far, ..)| distance <= *far) => {
                let same = openings.iter().filter(|((_, other), _)| alike(at, *other));
                First::Opens { at, contacts: same.map(|(_, label)| (*label).clone()).collect() }
            }
            (_, Some((_, place, _))) => First::Rests { at: self.value(&place) },
            _ => First::Never,
        }
    }
}

fn alike(a: f64, b: f64) -> bool {
    (a - b).abs() <= ALIKE * a.abs().max(1.0)
}
