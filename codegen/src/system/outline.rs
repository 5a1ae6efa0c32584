//! Outlines of bodies: corners in the order declared.

type Corner = [f64; 2];

/// Part of a length or an area that is roundoff.
const ROUNDING: f64 = 1e-9;

/// The first two sides that cross between their ends, each by the index of the corner where it
/// begins.
pub fn find_crossed_sides(corners: &[Corner]) -> Option<[usize; 2]> {
    let count = corners.len();
    let side = |i: usize| [corners[i], corners[(i + 1) % count]];
    let mut pairs = (0..count).flat_map(|i| (i + 2..count).map(move |j| [i, j]));
    pairs.find(|&[i, j]| (j + 1) % count != i && cross(side(i), side(j)))
}

/// The first two sides that lie on one another over some length, likewise. A body all of whose
/// corners are in line has no outline.
fn find_folded_sides(corners: &[Corner]) -> Option<[usize; 2]> {
    let count = corners.len();
    let side = |i: usize| [corners[i], corners[(i + 1) % count]];
    let size = corners.iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
    let is_flat = |area: f64| area.abs() <= ROUNDING * size * size;
    let lies_on = |[a, b]: [Corner; 2], [c, d]: [Corner; 2]| {
        // Places of the second side along the first, in units of its length.
        let along = |p: Corner| {
            let [x, y] = [b[0] - a[0], b[1] - a[1]];
            ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y)
        };
        let [from, to] = [along(c), along(d)];
        let shared = from.max(to).min(1.0) - from.min(to).max(0.0);
        is_flat(area(a, b, c)) && is_flat(area(a, b, d)) && shared > ROUNDING
    };
    if (2..count).all(|i| is_flat(area(corners[0], corners[1], corners[i]))) {
        return None;
    }
    let mut pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| [i, j]));
    pairs.find(|&[i, j]| lies_on(side(i), side(j)))
}

fn cross([a, b]: [Corner; 2], [c, d]: [Corner; 2]) -> bool {
    area(a, b, c) * area(a, b, d) < 0.0 && area(c, d, a) * area(c, d, b) < 0.0
}

/// Twice the area of a triangle, positive counter-clockwise.
fn area(p: Corner, q: Corner, r: Corner) -> f64 {
    (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
}

/// The corners in order of their direction from their mean, the first as declared: no two sides
/// cross then.
pub fn order_around(corners: &[Corner]) -> Vec<usize> {
    let mean =
        [0, 1].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<f64>() / corners.len() as f64);
    let angle = |&i: &usize| (corners[i][1] - mean[1]).atan2(corners[i][0] - mean[0]);
    let mut order: Vec<usize> = (0..corners.len()).collect();
    order.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    let first = order.iter().position(|&i| i == 0).unwrap_or(0);
    order.rotate_left(first);
    order
}

/// Which sides of a body cross or lie on one another, and in which order its corners stand around
/// it, by their names.
pub fn describe_crossing(names: &[&str], corners: &[Corner]) -> Option<String> {
    let crossed = find_crossed_sides(corners).map(|sides| (sides, "cross"));
    let (sides, how) = crossed.or_else(|| Some((find_folded_sides(corners)?, "lie on one another")))?;
    let [first, second] = sides.map(|i| format!("{}–{}", names[i], names[(i + 1) % names.len()]));
    let order: Vec<&str> = order_around(corners).into_iter().map(|i| names[i]).collect();
    Some(format!(
        "sides {first} and {second} {how}; list the corners in order around it, {}",
        order.join(", ")
    ))
}

#[cfg(test)]
mod tests {
    use super::{describe_crossing, find_crossed_sides, find_folded_sides, order_around};

    #[test]
    fn an_outline_that_folds_back_lies_on_itself() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let [a, b, c, d] = square;
        let half = [0.5, 0.0];
        for simple in [&square[..], &[a, half, b, c, d], &[a, b, half], &[a, b]] {
            assert_eq!(find_folded_sides(simple), None, "{simple:?}");
        }
        // Beside each other, and with another side between them.
        assert_eq!(find_folded_sides(&[a, b, half, c]), Some([0, 1]));
        assert_eq!(find_folded_sides(&[a, b, c, [0.5, 0.5], half, [2.0, 0.0], [0.0, -1.0]]), Some([0, 4]));
        let text = describe_crossing(&["A", "B", "M", "C"], &[a, b, half, c]).expect("a fold");
        assert_eq!(
            text,
            "sides A–B and B–M lie on one another; list the corners in order around it, A, M, B, C"
        );
    }

    #[test]
    fn a_bow_tie_crosses_itself_and_a_square_does_not() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let [a, b, c, d] = square;
        for simple in [&square[..], &square[..3], &square[..2], &[a, [0.2, 0.4], d, [1.0, 0.5]]] {
            assert_eq!(find_crossed_sides(simple), None, "{simple:?}");
        }
        assert_eq!(find_crossed_sides(&[a, c, b, d]), Some([0, 2]));
        assert_eq!(order_around(&[a, c, b, d]), [0, 2, 1, 3]);
        let text = describe_crossing(&["A", "C", "B", "D"], &[a, c, b, d]).expect("a bow tie");
        assert_eq!(text, "sides A–C and B–D cross; list the corners in order around it, A, B, C, D");
    }
}
