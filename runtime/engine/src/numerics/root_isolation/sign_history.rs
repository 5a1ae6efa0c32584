//! A guard g ≥ 0 followed through points between which it is monotone.

use super::RootStart;
use super::bracket::{Point, root};
use super::extrema::{ExtremumKind, LocatedExtremum, Zigzag};
use super::partition::Node;

/// The first thing that happens to a guard in (0, 1].
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Crossing {
    /// Nothing.
    Clear,
    /// It changes from + to − and goes below −δ.
    At {
        /// The root.
        theta: f64,
    },
    /// It has a minimum within ±δ and rises again.
    Touch {
        /// Where the rate is zero.
        theta: f64,
        /// The value there.
        value: f64,
    },
    /// It goes below −δ without having been positive: from its known root, or from a start at or
    /// below zero. The event is at θ = 0.
    LeavesAtStart,
}

#[derive(Clone, Copy, Default)]
enum SignFinding {
    #[default]
    Nothing,
    /// Below −δ, with the last change from + to −.
    Below(Option<[Point; 2]>),
    Minimum(LocatedExtremum),
}

/// The guard's history since θ = 0.
#[derive(Default)]
pub(super) struct History {
    delta: f64,
    /// Not yet above δ since the known root.
    at_root: bool,
    /// The root at the start is divided out: every sign behind it counts.
    divided: bool,
    last: Option<Node>,
    descent: Option<[Point; 2]>,
    zigzag: Zigzag,
    /// The lowest minimum within ±δ, until the guard is out of that band.
    touch: Option<LocatedExtremum>,
    found: SignFinding,
}

impl History {
    pub(super) fn new(start: RootStart, delta: f64) -> Self {
        Self { delta, at_root: matches!(start, RootStart::Root | RootStart::Order(_)), ..Self::default() }
    }

    pub(super) fn of_series(start: RootStart, delta: f64) -> Self {
        Self { divided: matches!(start, RootStart::Order(_)), ..Self::new(start, delta) }
    }

    pub(super) fn follow(&mut self, node: Node) {
        if !matches!(self.found, SignFinding::Nothing) {
            return;
        }
        let value = node.point.value;
        let extremum = self.zigzag.push(node.point, self.noise(node));
        self.consider(extremum);
        if let Some(last) = self.last.filter(|last| is_plus(last.point) && value < 0.0) {
            self.descent = Some([last.point, node.point]);
        }
        if value < -self.delta {
            self.found = SignFinding::Below(self.descent.filter(|_| self.divided || !self.at_root));
        } else if value > self.delta {
            self.at_root = false;
            self.found = self.touch.map_or(SignFinding::Nothing, SignFinding::Minimum);
        }
        self.last = Some(node);
    }

    fn noise(&self, node: Node) -> f64 {
        node.noise.min(0.5 * self.delta)
    }

    fn consider(&mut self, extremum: Option<LocatedExtremum>) {
        let touch = extremum
            .filter(|e| e.kind == ExtremumKind::Minimum && e.value.abs() <= self.delta && !self.at_root);
        if let Some(new) = touch {
            let lower = self.touch.filter(|old| old.value <= new.value);
            self.touch = Some(lower.unwrap_or(new));
        }
    }

    fn finding(&mut self) -> SignFinding {
        if !matches!(self.found, SignFinding::Nothing) {
            return self.found;
        }
        // Half of δ is the most that the step after this one takes for noise.
        if self.last.is_some_and(|last| last.beyond <= last.noise.max(0.5 * self.delta)) {
            self.consider(self.zigzag.finish());
        }
        self.touch.map_or(SignFinding::Nothing, SignFinding::Minimum)
    }

    pub(super) fn verdict(mut self, g: &mut dyn FnMut(f64) -> f64) -> Crossing {
        match self.finding() {
            SignFinding::Nothing => Crossing::Clear,
            SignFinding::Below(None) => Crossing::LeavesAtStart,
            SignFinding::Below(Some([a, b])) => Crossing::At { theta: root(g, a, b)[0].theta },
            SignFinding::Minimum(LocatedExtremum { theta, value, .. }) => Crossing::Touch { theta, value },
        }
    }
}

/// Positive, or zero on the way; zero at the start is no place to come down from.
fn is_plus(point: Point) -> bool {
    point.value > 0.0 || point.value == 0.0 && point.theta > 0.0
}
