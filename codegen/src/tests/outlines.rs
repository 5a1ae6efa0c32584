//! Bodies whose sides cross.

use super::find_mistakes;

fn plate(points: &str) -> Vec<String> {
    find_mistakes(&format!(
        "#[body(plate, points({points}), mass = m, inertia = m * b * b, centre = (b / 2, h / 2))] #[pin(A = (0, 0))]
         struct Plate {{ m: f64, b: f64, h: f64 }}"
    ))
}

#[test]
fn sides_that_cross_for_all_parameters_are_named_with_the_order_of_corners() {
    let crossed = plate("A = (0, 0), B = (b, h), C = (b, 0), D = (0, h)");
    assert_eq!(
        crossed,
        [
            "body `plate`: sides A–B and C–D cross; list the corners in order around it, A, C, B, D; a point within it \
          is declared by `#[point(P = plate, at = (x, y))]`"
        ]
    );
    assert!(plate("A = (0, 0), C = (b, 0), B = (b, h), D = (0, h)").is_empty());
    let folded = plate("A = (0, 0), B = (b, 0), M = (b / 2, 0), C = (b, h)");
    assert!(folded[0].starts_with("body `plate`: sides A–B and B–M lie on one another; list"), "{folded:?}");
    // The third corner is on either side of the first, as b is smaller or larger than h.
    assert!(plate("A = (0, 0), C = (b, 0), B = (b - h, h), D = (0, h)").is_empty());
}
