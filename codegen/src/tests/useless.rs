//! What a declaration has and nothing follows from.

use super::find_mistakes;

#[test]
fn supports_of_what_cannot_move_are_reported() {
    let declaration = |supports: &str| {
        format!(
            "#[bar(OA, mass = m, length = l)] #[bar(PB, mass = m, length = l)] #[pin(O = (0, 0))] #[pin(P = (3 * l, 0))]
             #[figure(A = (l, 0), B = (4 * l, 0))] #[coordinate(alpha = angle(OA))] #[coordinate(beta = angle(PB))]
             {supports} struct Bars {{ m: f64, l: f64 }}"
        )
    };
    let useless = |name: &str| format!("support `{name}` has no effect: the supported point cannot move");
    assert_eq!(
        find_mistakes(&declaration("#[support(O = floor)] #[support(P = floor)]")),
        [useless("O"), useless("P")]
    );
    assert!(find_mistakes(&declaration("#[support(A = floor)]")).is_empty());
}
