//! Random guards that turn from a thousandth of a time to a million times over the first step
//! tried: none missed, none invented. As a run does it: over a step that does not resolve the guard
//! nothing is concluded, and a shorter one is tried.

use core::f64::consts::{FRAC_PI_2, TAU};

use super::super::{Crossing, GuardError, RootStart, TERMS, tail, watch, watch_series};
use super::known::{Random, sine_series};

/// Guards of each kind without `LIFTOFF_GUARDS`.
const USUAL: usize = 5_000;
/// A series counts as exact whose tail is at most this part of the error bound.
const EXACT: f64 = 0.1;
/// Steps that are not resolved are repeated with this part of their length; the next may be longer
/// again.
const SHORTER: f64 = 0.125;
const LONGER: f64 = 2.0;
/// Radians over which a guard is followed.
const FAR: f64 = 60.0;

/// What a guard is, positive at the start.
#[derive(Debug, Clone, Copy)]
enum Shape {
    /// sin(ωθ + φ).
    Wave,
    /// 1 + m − sin(ωθ + φ): below zero where m < 0 only.
    Crest(f64),
    /// (r − θ)(2 + sin(ωθ + φ)).
    Ripple(f64),
}

#[derive(Debug, Clone, Copy)]
struct Guard {
    shape: Shape,
    omega: f64,
    phase: f64,
    height: f64,
    /// Where following it ends.
    end: f64,
    delta: f64,
}

impl Guard {
    fn random(random: &mut Random) -> Self {
        let omega = 10f64.powf(random.within(-3.0, 6.0));
        let height = 10f64.powf(random.within(-6.0, 6.0));
        let end = (FAR / omega).min(1.0);
        let r = random.within(0.01, 1.5) * end;
        let (shape, phase) = match random.below(3) {
            // Falls through zero at r, a wave of many turns within the first of them.
            0 => (Shape::Wave, core::f64::consts::PI - omega * r.min(3.0 / omega)),
            1 => {
                let m = 10f64.powf(random.within(-3.0, 0.0));
                let crest = if omega > 2.0 { random.within(0.0, TAU) } else { FRAC_PI_2 - omega * r };
                // Below 2 rad the crest lies at r; it is deep or flat by the curvature there.
                let m = if omega > 2.0 { m } else { m * omega * omega * 0.01 };
                (Shape::Crest(if random.below(2) == 0 { m } else { -m }), crest)
            }
            _ => (Shape::Ripple(r), random.within(0.0, TAU)),
        };
        Self { shape, omega, phase, height, end, delta: 1e-13 * height }
    }

    fn value(&self, theta: f64) -> f64 {
        let sin = (self.omega * theta + self.phase).sin();
        self.height
            * match self.shape {
                Shape::Wave => sin,
                Shape::Crest(m) => 1.0 + m - sin,
                Shape::Ripple(r) => (r - theta) * (2.0 + sin),
            }
    }

    /// Over a step from `x` of length `h`.
    fn series(&self, x: f64, h: f64) -> [f64; TERMS] {
        let sine = sine_series(self.omega * h, self.omega * x + self.phase);
        let terms: [f64; TERMS] = core::array::from_fn(|k| match self.shape {
            Shape::Wave => sine[k],
            Shape::Crest(m) if k == 0 => 1.0 + m - sine[0],
            Shape::Crest(_) => -sine[k],
            Shape::Ripple(r) => {
                let wave = |k: usize| sine[k] + if k == 0 { 2.0 } else { 0.0 };
                (r - x) * wave(k) - if k == 0 { 0.0 } else { h * wave(k - 1) }
            }
        });
        terms.map(|c| self.height * c)
    }

    /// Where it first falls through zero, and the rate there in units of its height.
    fn root(&self) -> Option<[f64; 2]> {
        let first = |angle: f64| {
            let turns = ((self.phase - angle) / TAU).ceil();
            (angle + turns * TAU - self.phase) / self.omega
        };
        match self.shape {
            Shape::Wave => Some([first(core::f64::consts::PI), self.omega]),
            Shape::Crest(m) if m < 0.0 => {
                let angle = (1.0 + m).asin();
                Some([first(angle), self.omega * angle.cos()])
            }
            Shape::Crest(_) => None,
            Shape::Ripple(r) => Some([r, 1.0]),
        }
    }

    /// Whether it starts above zero, and its root is neither at an end nor one that rounding moves
    /// far.
    fn is_distinguishable(&self) -> bool {
        let far = self.root().is_none_or(|[at, rate]| {
            let near = self.slack(rate);
            near < 1e-3 * self.end && at > 1e-3 * self.end && (at - self.end).abs() > 1e-3 * self.end
        });
        far && self.value(0.0) > 1e2 * self.delta
    }

    /// How far from its root rounding of the argument and of the series, and what the series leaves
    /// out, may let it be found.
    fn slack(&self, rate: f64) -> f64 {
        let argument = 4.0 * f64::EPSILON * (self.omega * self.end + self.phase.abs() + 1.0);
        let wave = if matches!(self.shape, Shape::Ripple(_)) { 0.0 } else { argument };
        let rest = 2.0 * EXACT * self.delta / self.height;
        // Sums of terms up to e⁷ times the height.
        let span = if matches!(self.shape, Shape::Ripple(_)) { self.end } else { 1.0 };
        (wave + rest + 1e3 * 16.0 * f64::EPSILON * span) / rate + 4.0 * f64::EPSILON
    }
}

fn look(guard: &Guard, is_series: bool, x: f64, h: f64) -> Result<Crossing, GuardError> {
    if !is_series {
        return watch(|s| guard.value(x + h * s), RootStart::Free, guard.delta);
    }
    let c = guard.series(x, h);
    if tail(&c) > EXACT * guard.delta {
        return Err(GuardError::Unresolved { theta: 0.0 });
    }
    watch_series(&c, RootStart::Free, guard.delta)
}

/// Where a run finds it.
fn followed(guard: &Guard, is_series: bool) -> Option<f64> {
    let (mut x, mut h) = (0.0, 1.0);
    while x < guard.end {
        match look(guard, is_series, x, h) {
            Err(GuardError::Unresolved { .. }) => h *= SHORTER,
            Err(error) => panic!("{error}"),
            Ok(Crossing::Clear) => (x, h) = (x + h, (LONGER * h).min(1.0)),
            Ok(Crossing::At { theta }) => return Some(x + h * theta).filter(|at| *at <= guard.end),
            Ok(other) => panic!("{other:?} at {x}, {h}: {guard:?}"),
        }
    }
    None
}

fn count(is_series: bool, seed: u64) {
    let wanted = std::env::var("LIFTOFF_GUARDS").ok().and_then(|n| n.parse().ok()).unwrap_or(USUAL);
    let mut random = Random(seed);
    let (mut guards, mut roots) = (0, 0);
    while guards < wanted {
        let guard = Guard::random(&mut random);
        if !guard.is_distinguishable() {
            continue;
        }
        guards += 1;
        let root = guard.root().filter(|[at, _]| *at < guard.end);
        roots += usize::from(root.is_some());
        let found = followed(&guard, is_series);
        match (root, found) {
            (None, None) => (),
            (Some([at, rate]), Some(theta)) if (theta - at).abs() <= guard.slack(rate) => (),
            _ => panic!("guard {guards}: {found:?} for {root:?}, {guard:?}"),
        }
    }
    assert!(4 * roots > guards, "{roots} roots of {guards} guards");
}

#[test]
fn series_of_any_bandwidth() {
    count(true, 3);
}

#[test]
fn functions_of_any_bandwidth() {
    count(false, 4);
}
