//! Where no polynomial fits, as at a kink: samples, and between them the function's nearest
//! approaches to zero, or dips below it, by golden section (Brent, *Algorithms for Minimization
//! without Derivatives*, 1973, ch. 5).

use super::GuardError;
use super::bracket::Point;
use super::polynomial::{FINE, node};

/// The function at a point of a piece, 0 to 1.
pub(super) type PieceFunction<'a> = dyn FnMut(f64) -> Result<Point, GuardError> + 'a;

/// 0.618ⁿ of an interval between nodes is below the spacing of doubles.
const DIVISIONS: usize = 72;

/// (√5 − 1)/2.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Visits the samples, both ends among them, and the nearest approaches to zero, in ascending
/// order.
pub(super) fn approaches(sample: &mut PieceFunction, visit: &mut dyn FnMut(Point)) -> Result<(), GuardError> {
    let mut sizes = [f64::INFINITY; FINE + 3];
    let mut points = [Point { theta: 0.0, value: 0.0 }; FINE + 1];
    for (j, point) in points.iter_mut().enumerate() {
        *point = sample(node(j, FINE))?;
        sizes[j + 1] = point.value.abs();
    }
    for (j, &here) in points.iter().enumerate() {
        let nearest = here.value != 0.0 && sizes[j + 1] <= sizes[j].min(sizes[j + 2]);
        let around = [j.saturating_sub(1), (j + 1).min(FINE)].map(|i| node(i, FINE));
        let positive = here.value.is_sign_positive();
        let found = if nearest { Some(approach(sample, around, positive)?) } else { None };
        let before = found.filter(|found| found.theta < here.theta);
        let after = found.filter(|_| before.is_none());
        before.into_iter().chain([here]).chain(after).for_each(&mut *visit);
    }
    Ok(())
}

/// The least value between `a` and `b`, or the greatest of a function below zero.
fn approach(
    sample: &mut PieceFunction,
    [mut a, mut b]: [f64; 2],
    positive: bool,
) -> Result<Point, GuardError> {
    let inner = |a: f64, b: f64| [b - GOLDEN * (b - a), a + GOLDEN * (b - a)];
    let [x, y] = inner(a, b);
    let [mut left, mut right] = [sample(x)?, sample(y)?];
    for _ in 0..DIVISIONS {
        if (left.value < right.value) == positive {
            (b, right) = (inner(a, b)[1], left);
            left = sample(inner(a, b)[0])?;
        } else {
            (a, left) = (inner(a, b)[0], right);
            right = sample(inner(a, b)[1])?;
        }
    }
    Ok(if (left.value < right.value) == positive { left } else { right })
}
