//! A root between two points of opposite sign: inverse quadratic interpolation where it is safe,
//! else bisection (Chandrupatla, *Adv. Eng. Softw.* 28 (1997) 145).

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

/// The first place is that of the chord, and at least so much of the interval from its ends.
const FIRST: f64 = 0.1;

/// The root between `a` and `b`, to rounding: the nearest point found, and the one across the
/// change of sign.
pub(super) fn root(f: &mut dyn FnMut(f64) -> f64, a: Point, b: Point) -> [Point; 2] {
    let (mut new, mut old, mut fraction) = (a, b, (a.value / (a.value - b.value)).clamp(FIRST, 1.0 - FIRST));
    for _ in 0..MOST {
        let [best, other] = if new.value.abs() < old.value.abs() { [new, old] } else { [old, new] };
        let width = (old.theta - new.theta).abs();
        let resolution = RESOLUTION.max(f64::EPSILON * best.theta.abs()) / width;
        if best.value == 0.0 || resolution > 0.5 {
            return [best, other];
        }
        let theta = new.theta + f64::clamp(fraction, resolution, 1.0 - resolution) * (old.theta - new.theta);
        let next = Point { theta, value: f(theta) };
        let same_side = next.value.is_sign_positive() == new.value.is_sign_positive();
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

#[cfg(test)]
mod tests {
    use super::*;

    fn points(all: [[f64; 2]; 3]) -> [Point; 3] {
        all.map(|[theta, value]| Point { theta, value })
    }

    /// Of θ = 0.3 + 0.5 v + 0.1 v², quadratic in the values, the zero is at 0.3. At the borders 1 −
    /// √(1 − ξ) = φ and φ = √ξ of what is safe it is the middle.
    #[test]
    fn the_next_point_is_the_zero_of_the_inverse_quadratic_where_that_is_safe() {
        let inverse = |v: f64| [0.3 + 0.5 * v + 0.1 * v * v, v];
        let [a, b, c] = points([-0.2, 0.3, -0.5].map(inverse));
        let theta = a.theta + step(a, b, c) * (b.theta - a.theta);
        assert!((theta - 0.3).abs() < 1e-15, "{theta}");
        for xi in [0.25, 0.75] {
            let [a, b, c] = points([[xi, 1.0], [0.0, -1.0], [1.0, 3.0]]);
            assert_eq!(step(a, b, c), 0.5, "{xi}");
        }
    }

    /// Between 1 and 1 + 2ε there is one more place.
    #[test]
    fn an_interval_of_two_spacings_is_divided_once_more() {
        let middle = 1.0 + f64::EPSILON;
        let [a, b, _] = points([[1.0, -0.5 * f64::EPSILON], [middle + f64::EPSILON, f64::EPSILON], [0.0; 2]]);
        let [best, _] = root(&mut |theta| theta - middle, a, b);
        assert_eq!((best.theta, best.value), (middle, 0.0));
    }

    /// Few places of smooth functions; of flat ones no more than three times those of bisection.
    #[test]
    fn a_root_takes_few_evaluations() {
        let cases: [(&dyn Fn(f64) -> f64, u32); 5] = [
            (&|x| x.exp() - 1.3, 9),
            (&|x| x.cos() - 0.8, 9),
            (&|x| x * x * x - 0.02, 12),
            (&|x| (x - 0.7).powi(9), 159),
            (&|x| if x < 0.31 { -1e-9 } else { 1.0 }, 159),
        ];
        for (k, (f, most)) in cases.into_iter().enumerate() {
            let [a, b] = [0.0, 1.0].map(|theta| Point { theta, value: f(theta) });
            let mut count = 0;
            let counted = &mut |theta| {
                count += 1;
                f(theta)
            };
            let [one, other] = root(counted, a, b);
            assert!((one.value > 0.0) != (other.value > 0.0) || one.value == 0.0, "{k}");
            assert!(one.value == 0.0 || (one.theta - other.theta).abs() <= 4.0 * f64::EPSILON, "{k}");
            assert!(count <= most, "{k}: {count}");
        }
    }
}
