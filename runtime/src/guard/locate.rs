//! Roots of either direction, for stop conditions, and extrema, for reports.

use super::bracket::{Point, root};
use super::partition::{Division, Node};
use super::zigzag::{Extremum, ExtremumKind, Zigzag};
use super::{NotFinite, Start};

/// The search goes on at least so far behind a pole, twice as far each time.
const BEHIND: f64 = 1e-13;

/// The first root of `g`, known to within `delta` ≥ 0, in (0, 1]: a change of sign either way, or an
/// extremum within ±δ of zero. A change of sign through a pole or a jump is no root.
///
/// # Errors
/// If `g` is infinite or not a number somewhere.
pub fn first_root(mut g: impl FnMut(f64) -> f64, start: Start, delta: f64) -> Result<Option<f64>, NotFinite> {
    let (mut from, mut start, mut least) = (0.0, start, BEHIND);
    while from < 1.0 {
        let at = |s: f64| from + (1.0 - from) * s;
        let mut rest = |s: f64| g(at(s));
        match search(&mut rest, start, delta)? {
            None => return Ok(None),
            Some(Found::At(s)) => return Ok(Some(at(s))),
            Some(Found::Between(a, b)) => {
                let s = root(&mut rest, a, b);
                if is_continuous(rest(s), a, b, delta) {
                    return Ok(Some(at(s)));
                }
                (from, start) = (at(s) + least, Start::Free);
                least *= 2.0;
            }
        }
    }
    Ok(None)
}

/// Whether the value nearest to a change of sign between `a` and `b` is smaller than theirs, as it is where the function
/// passes through zero, and not where it jumps over it or has a pole.
fn is_continuous(value: f64, a: Point, b: Point, delta: f64) -> bool {
    let resolved = b.theta - a.theta > 8.0 * f64::EPSILON;
    !resolved || value.abs() <= delta.max(0.5 * a.value.abs().min(b.value.abs()))
}

fn search(g: &mut dyn FnMut(f64) -> f64, start: Start, delta: f64) -> Result<Option<Found>, NotFinite> {
    let mut search = Search {
        delta,
        known: if start == Start::Root { delta } else { 0.0 },
        side: None,
        zigzag: Zigzag::default(),
        last: None,
        found: None,
    };
    let division = Division { samples: None, delta, dull: |[low, high], delta| low > delta || high < -delta };
    division.visit(g, &mut |node| search.follow(node))?;
    Ok(search.found)
}

/// Visits every maximum and minimum of `g` in (0, 1] that stands out by more than `delta` ≥ 0 and by
/// more than rounding, in ascending order.
///
/// # Errors
/// If `g` is infinite or not a number somewhere.
pub fn extrema(
    mut g: impl FnMut(f64) -> f64,
    delta: f64,
    mut visit: impl FnMut(Extremum),
) -> Result<(), NotFinite> {
    let mut zigzag = Zigzag::default();
    let division = Division { samples: None, delta, dull: |_, _| false };
    division.visit(&mut g, &mut |node| {
        let passed = zigzag.push(node.point, node.noise.max(delta));
        let last = zigzag.finish().filter(|_| node.flat);
        passed.into_iter().chain(last).for_each(&mut visit);
    })
}

#[derive(Clone, Copy)]
enum Found {
    At(f64),
    Between(Point, Point),
}

/// The function's history since θ = 0.
struct Search {
    delta: f64,
    /// Values no larger than this belong to the start's root until the first that is.
    known: f64,
    /// Whether it is positive, once that is known.
    side: Option<bool>,
    zigzag: Zigzag,
    last: Option<Point>,
    found: Option<Found>,
}

impl Search {
    fn follow(&mut self, node: Node) {
        if self.found.is_some() {
            return;
        }
        let Node { point, noise, .. } = node;
        let extremum = self.zigzag.push(point, noise.min(0.5 * self.delta));
        self.found = match (self.side, self.last) {
            (Some(_), _) if point.value == 0.0 => Some(Found::At(point.theta)),
            (Some(side), Some(last)) if side != (point.value > 0.0) => Some(Found::Between(last, point)),
            _ => self.tangent(extremum),
        };
        if self.side.is_none() && point.value.abs() > self.known {
            self.side = Some(point.value > 0.0);
        }
        self.last = Some(point);
        if node.flat && self.found.is_none() {
            self.found = self.tangent(self.zigzag.finish());
        }
    }

    /// An extremum that comes within δ of zero from its side.
    fn tangent(&self, extremum: Option<Extremum>) -> Option<Found> {
        let Extremum { theta, value, kind } = extremum?;
        let towards_zero = self.side? == (kind == ExtremumKind::Minimum);
        (towards_zero && value.abs() <= self.delta).then_some(Found::At(theta))
    }
}
