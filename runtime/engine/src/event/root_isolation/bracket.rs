//! A root between two points of opposite sign: inverse quadratic interpolation where it is safe, else
//! bisection (Chandrupatla, *Adv. Eng. Softw.* 28 (1997) 145).

use super::GuardError;

/// A function's value at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub(super) theta: f64,
    pub(super) value: f64,
}

/// g at `theta`.
pub(super) fn sample(g: &mut dyn FnMut(f64) -> f64, theta: f64) -> Result<Point, GuardError> {
    let value = g(theta);
    if value.is_finite() { Ok(Point { theta, value }) } else { Err(GuardError::NotFinite { theta }) }
}

/// Half the spacing of doubles below 1.
const RESOLUTION: f64 = f64::EPSILON / 4.0;
/// Bisection alone needs 53; the method at most some three times that.
const MOST: usize = 200;

/// The root between `a` and `b`, to rounding: the nearest point found, and the one across the change of sign.
pub(super) fn root(f: &mut dyn FnMut(f64) -> f64, a: Point, b: Point) -> [Point; 2] {
    let (mut new, mut old, mut fraction) = (a, b, 0.5);
    for _ in 0..MOST {
        let [best, other] = if new.value.abs() < old.value.abs() { [new, old] } else { [old, new] };
        let width = (old.theta - new.theta).abs();
        let resolution = RESOLUTION.max(f64::EPSILON * best.theta.abs()) / width;
        if best.value == 0.0 || resolution > 0.5 {
            return [best, other];
        }
        let theta = new.theta + f64::clamp(fraction, resolution, 1.0 - resolution) * (old.theta - new.theta);
        let next = Point { theta, value: f(theta) };
        let same_side = (next.value > 0.0) == (new.value > 0.0);
        let oldest = if same_side { new } else { old };
        if !same_side {
            old = new;
        }
        new = next;
        fraction = step(new, old, oldest);
    }
    [new, old]
}

/// Where to go next, as a fraction of the way from `a` to `b`; `c` is the point left before.
fn step(a: Point, b: Point, c: Point) -> f64 {
    let xi = (a.theta - b.theta) / (c.theta - b.theta);
    let phi = (a.value - b.value) / (c.value - b.value);
    if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
        let along = (c.theta - a.theta) / (b.theta - a.theta);
        a.value / (b.value - a.value) * c.value / (b.value - c.value)
            + along * a.value / (c.value - a.value) * b.value / (c.value - b.value)
    } else {
        0.5
    }
}
