//! What a guard g ≥ 0 does over a step, with δ the bound of its error: below −δ it has crossed, at the
//! last change from + to − before; an interior minimum within ±δ is a touch; above δ, nothing.

use super::bracket::{Point, root};
use super::partition::{Division, Node, Samples};
use super::zigzag::{Extremum, ExtremumKind, Zigzag};
use super::{NotFinite, Start};

/// The first thing that happens to a guard in (0, 1].
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Verdict {
    /// Nothing.
    Clear,
    /// It changes from + to − and goes below −δ.
    Crossing {
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

/// Follows the guard `g`, known to within `delta` ≥ 0, from θ = 0 to the first event.
///
/// # Errors
/// If `g` is infinite or not a number somewhere.
pub fn watch(mut g: impl FnMut(f64) -> f64, start: Start, delta: f64) -> Result<Verdict, NotFinite> {
    decide(&mut g, None, start, delta)
}

/// [`watch`] with the values of `g` at [`NODES`](super::NODES) already known, so that they can be computed for all
/// guards at once. A guard that is sure to stay above `delta` is not evaluated again.
///
/// # Errors
/// If `g` is infinite or not a number somewhere.
pub fn watch_sampled(
    samples: &Samples,
    mut g: impl FnMut(f64) -> f64,
    start: Start,
    delta: f64,
) -> Result<Verdict, NotFinite> {
    decide(&mut g, Some(samples), start, delta)
}

fn decide(
    g: &mut dyn FnMut(f64) -> f64,
    samples: Option<&Samples>,
    start: Start,
    delta: f64,
) -> Result<Verdict, NotFinite> {
    let mut guard = Guard { delta, at_root: start == Start::Root, ..Guard::default() };
    let division = Division { samples, delta, dull: |[low, _], delta| low >= delta };
    division.visit(g, &mut |node| guard.follow(node))?;
    Ok(match guard.finish() {
        Finding::Nothing => Verdict::Clear,
        Finding::Below(None) => Verdict::LeavesAtStart,
        Finding::Below(Some([a, b])) => Verdict::Crossing { theta: root(g, a, b) },
        Finding::Minimum(Extremum { theta, value, .. }) => Verdict::Touch { theta, value },
    })
}

#[derive(Clone, Copy, Default)]
enum Finding {
    #[default]
    Nothing,
    /// Below −δ, with the last change from + to −.
    Below(Option<[Point; 2]>),
    Minimum(Extremum),
}

/// The guard's history since θ = 0.
#[derive(Default)]
struct Guard {
    delta: f64,
    /// Not yet above δ since the known root.
    at_root: bool,
    last: Option<Node>,
    descent: Option<[Point; 2]>,
    zigzag: Zigzag,
    /// The lowest minimum within ±δ, until the guard is out of that band.
    touch: Option<Extremum>,
    found: Finding,
}

impl Guard {
    fn follow(&mut self, node: Node) {
        if !matches!(self.found, Finding::Nothing) {
            return;
        }
        let value = node.point.value;
        let extremum = self.zigzag.push(node.point, node.noise.min(0.5 * self.delta));
        self.consider(extremum);
        if let Some(last) = self.last.filter(|last| is_plus(last.point) && value < 0.0) {
            self.descent = Some([last.point, node.point]);
        }
        if value < -self.delta {
            self.found = Finding::Below(self.descent.filter(|_| !self.at_root));
        } else if value > self.delta {
            self.at_root = false;
            self.found = self.touch.map_or(Finding::Nothing, Finding::Minimum);
        }
        self.last = Some(node);
    }

    fn consider(&mut self, extremum: Option<Extremum>) {
        let touch = extremum
            .filter(|e| e.kind == ExtremumKind::Minimum && e.value.abs() <= self.delta && !self.at_root);
        if let Some(new) = touch {
            let lower = self.touch.filter(|old| old.value <= new.value);
            self.touch = Some(lower.unwrap_or(new));
        }
    }

    fn finish(mut self) -> Finding {
        if !matches!(self.found, Finding::Nothing) {
            return self.found;
        }
        if self.last.is_some_and(|last| last.flat) {
            self.consider(self.zigzag.finish());
        }
        self.touch.map_or(Finding::Nothing, Finding::Minimum)
    }
}

/// Positive, or zero on the way; zero at the start is no place to come down from.
fn is_plus(point: Point) -> bool {
    point.value > 0.0 || point.value == 0.0 && point.theta > 0.0
}
