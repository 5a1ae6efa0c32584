//! A condition followed over the pieces of a step. A piece is passed over only if bounds of the
//! condition prove that it keeps its sign there; others are divided until the condition is monotone
//! on them or all of its turns are seen.

use crate::expression::Enclosure;
use crate::numerics::root_isolation::GuardError;

/// Bounds evaluated in a step at most.
const MOST: usize = 20_000;
/// A condition is seen if its greatest slope would change it by no more than so many times what its
/// values differ by.
const SEEN: f64 = 8.0;

/// A condition over a step.
pub(super) struct Pieces<'a> {
    /// Bounds over a piece.
    pub(super) enclosure: &'a dyn Fn([f64; 2]) -> Option<Enclosure>,
    pub(super) value: &'a dyn Fn(f64) -> f64,
    /// Values within this count as zero.
    pub(super) bound: f64,
    /// A piece shorter than this is not divided: what is read is not known well enough to tell its
    /// parts apart.
    pub(super) shortest: f64,
}

/// What bounds tell of a condition over a piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PieceRegularity {
    /// It only rises, or only falls.
    Monotone,
    /// It is finite.
    Finite,
    /// It may have a pole.
    Pole,
}

impl PieceRegularity {
    fn by(bounds: &Enclosure) -> Self {
        match bounds.slope.size().is_finite() {
            true if !bounds.slope.contains(0.0) => Self::Monotone,
            _ if bounds.value.size().is_finite() => Self::Finite,
            _ => Self::Pole,
        }
    }
}

/// What became of a step.
pub(super) enum Followed {
    /// The first event.
    Event(Option<f64>),
    /// Something that the condition reads has no bounds.
    Unbounded,
}

impl Pieces<'_> {
    /// Looks for the first event in the pieces, in order of time, that are not proved to have none.
    pub(super) fn follow(
        &self,
        look: &mut dyn FnMut([f64; 2], PieceRegularity) -> Result<Option<f64>, GuardError>,
    ) -> Result<Followed, GuardError> {
        let mut left = MOST;
        let mut waiting = vec![[0.0, 1.0]];
        while let Some(piece @ [start, end]) = waiting.pop() {
            left = left.checked_sub(1).ok_or(GuardError::Unresolved { theta: start })?;
            let Some(bounds) = (self.enclosure)(piece) else { return Ok(Followed::Unbounded) };
            if bounds.value.low > self.bound || bounds.value.high < -self.bound {
                continue;
            }
            let known = PieceRegularity::by(&bounds);
            let divides = known != PieceRegularity::Monotone && end - start > self.shortest;
            if divides && !self.is_seen(&bounds, piece) {
                let middle = 0.5 * (start + end);
                waiting.extend([[middle, end], [start, middle]]);
            } else if let Some(theta) = look(piece, known)? {
                return Ok(Followed::Event(Some(theta)));
            }
        }
        Ok(Followed::Event(None))
    }

    fn is_seen(&self, bounds: &Enclosure, [start, end]: [f64; 2]) -> bool {
        let values = [start, 0.5 * (start + end), end].map(self.value);
        let [low, high] = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(*value), high.max(*value)]
        });
        bounds.slope.size() * (end - start) <= SEEN * (high - low).max(self.bound)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::event::detection::SHORTEST;
    use crate::expression::Interval;

    /// The pieces that are looked at of values that may be zero anywhere, with slopes up to
    /// `steepest` of a piece's length.
    fn looked_at(value: &dyn Fn(f64) -> f64, steepest: &dyn Fn(f64) -> f64) -> Vec<[f64; 2]> {
        let enclosure = |[start, end]: [f64; 2]| {
            let [value, slope] = [1.0, steepest(end - start)].map(|reach| Interval::around(0.0, reach));
            Some(Enclosure { value, slope })
        };
        let value = |theta: f64| {
            assert!((0.0..=1.0).contains(&theta), "{theta} is outside of the step");
            value(theta)
        };
        let pieces = Pieces { enclosure: &enclosure, value: &value, bound: 0.0, shortest: SHORTEST };
        let mut seen = Vec::new();
        let mut look = |piece, _| {
            seen.push(piece);
            Ok(None)
        };
        assert!(matches!(pieces.follow(&mut look), Ok(Followed::Event(None))));
        seen
    }

    /// A slope of 16 may hide a turn of θ, one of 7 may not: halves are seen, wherever they lie.
    #[test]
    fn a_piece_is_divided_until_its_values_show_its_slope() {
        let steepest = |length: f64| if length > 0.5 { 16.0 } else { 7.0 };
        for offset in [0.0, 100.0, -100.0] {
            assert_eq!(looked_at(&|theta| offset + theta, &steepest), [[0.0, 0.5], [0.5, 1.0]], "{offset}");
        }
    }

    /// So many times what the values differ by, or the bound.
    #[test]
    fn a_slope_is_seen_up_to_eight_times_the_difference_of_values() {
        let of =
            |most: f64| looked_at(&|theta| theta, &move |length| if length > 0.5 { most } else { 0.0 }).len();
        assert_eq!([of(7.99), of(8.01)], [1, 2]);
    }

    /// 4θ(1 − θ) is zero at both ends: only the value in the middle shows its slope of 4.
    #[test]
    fn the_middle_of_a_piece_counts() {
        assert_eq!(looked_at(&|theta| 4.0 * theta * (1.0 - theta), &|_| 4.0), [[0.0, 1.0]]);
    }

    /// |sin 2πθ| is zero at the ends of both halves, whose slopes of 15 their middles show.
    #[test]
    fn the_middle_of_every_piece_counts() {
        let wave = |theta: f64| (core::f64::consts::TAU * theta).sin().abs();
        let steepest = |length: f64| if length > 0.5 { 1e3 } else { 15.0 };
        assert_eq!(looked_at(&wave, &steepest), [[0.0, 0.5], [0.5, 1.0]]);
    }

    /// The pieces that are looked at of a condition with these bounds of values and slopes, and
    /// what is known of it there.
    fn known_of(
        bounds: &dyn Fn([f64; 2]) -> [[f64; 2]; 2],
        bound: f64,
        shortest: f64,
    ) -> Vec<([f64; 2], PieceRegularity)> {
        let enclosure = |piece: [f64; 2]| {
            let [value, slope] = bounds(piece).map(|[low, high]| Interval { low, high });
            Some(Enclosure { value, slope })
        };
        let pieces = Pieces { enclosure: &enclosure, value: &|theta| theta, bound, shortest };
        let mut seen = Vec::new();
        let mut look = |piece, known| {
            seen.push((piece, known));
            Ok(None)
        };
        assert!(matches!(pieces.follow(&mut look), Ok(Followed::Event(None))));
        seen
    }

    /// Values beyond their bound on one side of zero everywhere.
    #[test]
    fn pieces_of_one_sign_are_skipped() {
        for (low, high, looked) in
            [(2.0, 3.0, 0), (-3.0, -2.0, 0), (1.0, 3.0, 1), (-3.0, -1.0, 1), (-2.0, 2.0, 1), (0.5, 3.0, 1)]
        {
            let seen = known_of(&|_| [[low, high], [1.0, 2.0]], 1.0, SHORTEST);
            assert_eq!(seen.len(), looked, "{low} {high}");
        }
        // Zero may be in the second quarter alone.
        let quarters =
            |[start, end]: [f64; 2]| [[if start < 0.5 && end > 0.25 { -1.0 } else { 1.0 }, 2.0], [-9.0, 9.0]];
        let seen: Vec<[f64; 2]> =
            known_of(&quarters, 0.0, 0.25).into_iter().map(|(piece, _)| piece).collect();
        assert_eq!(seen, [[0.25, 0.5]]);
    }

    /// What rises or falls all the way is not divided; others are until they are so short that
    /// nothing tells more.
    #[test]
    fn pieces_are_divided_as_far_as_that_tells_more() {
        let of = |slope: [f64; 2], most: f64| known_of(&move |_| [[-1.0, most], slope], 0.0, 0.125);
        for slope in [[1e-9, 1e6], [-1e6, -1e-9]] {
            assert_eq!(of(slope, 1.0), [([0.0, 1.0], PieceRegularity::Monotone)]);
        }
        for (most, known) in [(1.0, PieceRegularity::Finite), (f64::INFINITY, PieceRegularity::Pole)] {
            for slope in [[-1e6, 1e6], [0.0, 1e6], [-f64::INFINITY, f64::INFINITY], [1.0, f64::INFINITY]] {
                let eighths: Vec<_> =
                    (0..8).map(|k| ([0.0, 0.125].map(|x| x + 0.125 * f64::from(k)), known)).collect();
                assert_eq!(of(slope, most), eighths, "{slope:?}");
            }
        }
    }

    /// The search ends at the first event, and where something has no bounds.
    #[test]
    fn the_first_event_ends_the_search() {
        let enclosure =
            |_| Some(Enclosure { value: Interval::around(0.0, 1.0), slope: Interval::around(0.0, 9.0) });
        let pieces = Pieces { enclosure: &enclosure, value: &|_| 0.0, bound: 0.0, shortest: 0.25 };
        let mut seen = 0;
        let mut look = |[start, _]: [f64; 2], _| {
            seen += 1;
            Ok((start >= 0.5).then_some(start))
        };
        assert!(matches!(pieces.follow(&mut look), Ok(Followed::Event(Some(0.5)))));
        assert_eq!(seen, 3);
        let unknown = Pieces { enclosure: &|_| None, ..pieces };
        assert!(matches!(unknown.follow(&mut |_, _| Ok(Some(0.0))), Ok(Followed::Unbounded)));
        let endless = Pieces { shortest: 0.0, ..Pieces { enclosure: &enclosure, ..unknown } };
        assert!(matches!(endless.follow(&mut |_, _| Ok(None)), Err(GuardError::Unresolved { .. })));
    }
}
