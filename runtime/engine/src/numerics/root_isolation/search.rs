//! A function followed to its first root through points between which it is monotone.

use super::RootStart;
use super::bracket::Point;
use super::extrema::{ExtremumKind, LocatedExtremum, Zigzag};
use super::partition::Node;

#[derive(Clone, Copy)]
pub(super) enum SearchResult {
    At(f64),
    /// An extremum within δ of zero, with its value.
    Tangent {
        theta: f64,
        value: f64,
    },
    /// A change of sign.
    Between {
        ends: [Point; 2],
        /// Whether the function is sure to pass through zero there.
        smooth: bool,
    },
}

/// The function's history since θ = 0.
pub(super) struct RootSearch {
    delta: f64,
    /// Values no larger than this belong to the start's root until the first that is.
    known: f64,
    /// Whether it is positive, once that is known.
    side: Option<bool>,
    zigzag: Zigzag,
    last: Option<Point>,
    found: Option<SearchResult>,
}

impl RootSearch {
    pub(super) fn new(start: RootStart, delta: f64) -> Self {
        let known = if matches!(start, RootStart::Root | RootStart::Order(_)) { delta } else { 0.0 };
        let side = if let RootStart::Continues { positive } = start { Some(positive) } else { None };
        Self { delta, known, side, zigzag: Zigzag::default(), last: None, found: None }
    }

    /// With the root of known order divided out, every sign behind it counts.
    pub(super) fn of_series(start: RootStart, delta: f64) -> Self {
        let search = Self::new(start, delta);
        let known = if matches!(start, RootStart::Order(_)) { 0.0 } else { search.known };
        Self { known, ..search }
    }

    pub(super) fn found(&self) -> Option<SearchResult> {
        self.found
    }

    pub(super) fn follow(&mut self, node: Node) {
        if self.found.is_some() {
            return;
        }
        let point = node.point;
        if self.last.is_none() && point.value == 0.0 {
            // The root of the step before.
            self.side = None;
        }
        let extremum = self.zigzag.push(point, node.noise.min(0.5 * self.delta));
        self.found = match (self.side, self.last) {
            (Some(_), Some(_)) if point.value == 0.0 => Some(SearchResult::At(point.theta)),
            (Some(side), _) if point.value != 0.0 && side != point.value.is_sign_positive() => {
                let between = |last| SearchResult::Between { ends: [last, point], smooth: node.smooth };
                Some(self.last.map_or(SearchResult::At(point.theta), between))
            }
            _ => self.tangent(extremum),
        };
        if self.side.is_none() && point.value.abs() > self.known {
            self.side = Some(point.value.is_sign_positive());
        }
        self.last = Some(point);
        if point.theta == 1.0 && self.found.is_none() {
            self.found = self.end(node);
        }
    }

    /// A root at the end or nearer to it than the function is known. Half of δ is the most that the
    /// step after this one takes for noise.
    fn end(&self, Node { point, noise, beyond, .. }: Node) -> Option<SearchResult> {
        let zero = self.side.is_some() && point.value.abs() <= noise.min(self.delta);
        let last = || self.zigzag.finish().filter(|_| beyond <= noise.max(0.5 * self.delta));
        if zero { Some(SearchResult::At(point.theta)) } else { self.tangent(last()) }
    }

    /// An extremum that comes within δ of zero from its side.
    fn tangent(&self, extremum: Option<LocatedExtremum>) -> Option<SearchResult> {
        let LocatedExtremum { theta, value, kind } = extremum?;
        let towards_zero = self.side? == (kind == ExtremumKind::Minimum);
        (towards_zero && value.abs() <= self.delta).then_some(SearchResult::Tangent { theta, value })
    }
}
