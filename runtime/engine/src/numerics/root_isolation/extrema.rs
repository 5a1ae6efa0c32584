//! Maxima and minima of a sequence of points, those within the noise left out.

use super::bracket::Point;

/// A located maximum or minimum.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LocatedExtremum {
    /// Where in the step, 0 < θ ≤ 1.
    pub theta: f64,
    /// The value there.
    pub value: f64,
    /// Maximum or minimum.
    pub kind: ExtremumKind,
}

/// Kinds of [`LocatedExtremum`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ExtremumKind {
    /// Greater than its neighbourhood.
    Maximum,
    /// Less than its neighbourhood.
    Minimum,
}

/// Follows a sequence up and down.
#[derive(Default)]
pub(super) struct Zigzag {
    high: Option<Point>,
    low: Option<Point>,
    heading: Option<ExtremumKind>,
}

impl Zigzag {
    /// Takes the next point; the extremum that it confirms by being more than `noise` away.
    pub(super) fn push(&mut self, point: Point, noise: f64) -> Option<LocatedExtremum> {
        let high = self.high.filter(|high| high.value >= point.value).unwrap_or(point);
        let low = self.low.filter(|low| low.value <= point.value).unwrap_or(point);
        (self.high, self.low) = (Some(high), Some(low));
        if high.value - point.value > noise && self.heading != Some(ExtremumKind::Minimum) {
            self.low = Some(point);
            return self.turn(high, ExtremumKind::Maximum, ExtremumKind::Minimum);
        }
        if point.value - low.value > noise && self.heading != Some(ExtremumKind::Maximum) {
            self.high = Some(point);
            return self.turn(low, ExtremumKind::Minimum, ExtremumKind::Maximum);
        }
        None
    }

    /// The extremum at the last point, where the function is flat there.
    pub(super) fn finish(&self) -> Option<LocatedExtremum> {
        let kind = self.heading?;
        let last = match kind {
            ExtremumKind::Maximum => self.high?,
            ExtremumKind::Minimum => self.low?,
        };
        Some(LocatedExtremum { theta: last.theta, value: last.value, kind })
    }

    /// Heads for the opposite of `kind`. The first turn of all is within the noise of the start.
    fn turn(&mut self, at: Point, kind: ExtremumKind, next: ExtremumKind) -> Option<LocatedExtremum> {
        let Point { theta, value } = at;
        let extremum = LocatedExtremum { theta, value, kind };
        self.heading.replace(next).map(|_| extremum)
    }
}
