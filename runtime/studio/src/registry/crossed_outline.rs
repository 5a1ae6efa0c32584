//! Outlines of bodies that cross themselves, because their points are not listed in turn.

use super::Configuration;

/// The corners of the first body two sides of which cross, in the order declared.
pub fn crossed_outline(configuration: &Configuration) -> Option<Vec<&'static str>> {
    let places =
        |outline: &[usize]| outline.iter().map(|&point| configuration.points[point]).collect::<Vec<_>>();
    let outlines = configuration.geometry().bodies.iter().map(|body| body.outline);
    let crossed = outlines.into_iter().find(|outline| is_crossed(&places(outline)))?;
    Some(crossed.iter().map(|&point| configuration.layout.points[point]).collect())
}

/// Whether two sides that share no corner cross between their ends.
fn is_crossed(corners: &[[f64; 2]]) -> bool {
    let count = corners.len();
    let side = |i: usize| [corners[i], corners[(i + 1) % count]];
    let pairs = (0..count).flat_map(|i| (i + 2..count).map(move |j| (i, j)));
    pairs.filter(|&(i, j)| (j + 1) % count != i).any(|(i, j)| cross(side(i), side(j)))
}

fn cross([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let area =
        |p: [f64; 2], q: [f64; 2], r: [f64; 2]| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    area(a, b, c) * area(a, b, d) < 0.0 && area(c, d, a) * area(c, d, b) < 0.0
}

#[cfg(test)]
mod tests {
    use super::is_crossed;

    #[test]
    fn a_bow_tie_crosses_itself_and_a_square_does_not() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let [a, b, c, d] = square;
        assert!(!is_crossed(&square) && !is_crossed(&square[..3]) && !is_crossed(&square[..2]));
        assert!(is_crossed(&[a, c, b, d]));
        // An arrow's head is no bow-tie.
        assert!(!is_crossed(&[a, [0.2, 0.4], d, [1.0, 0.5]]));
    }
}
