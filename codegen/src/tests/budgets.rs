//! Budgets of operations.

use super::{PAIR, find_mistakes};

fn find_mistakes_in(budget: &str) -> Vec<String> {
    find_mistakes(&format!("{budget} {PAIR}"))
}

#[test]
fn exceeded_budgets_are_reported_with_their_set() {
    assert_eq!(
        find_mistakes_in(
            "#[budget(flops = 1000)] #[budget(flops = 1000, on(P))] #[budget(flops = 1000, on())]"
        ),
        [""; 0]
    );
    let all = find_mistakes_in("#[budget(flops = 2)]");
    assert_eq!(all.len(), 2, "{all:?}");
    assert!(
        all[0].starts_with("the right-hand side in free motion takes ")
            && all[0].contains("than the budget of 2: "),
        "{all:?}"
    );
    assert!(all[1].starts_with("the right-hand side on P, Q takes "), "{all:?}");
    assert_eq!(find_mistakes_in("#[budget(flops = 2, on(Q))]"), all[1..]);
    assert_eq!(find_mistakes_in("#[budget(flops = 2, on())]"), all[..1]);
}

#[test]
fn invalid_budgets_are_reported() {
    let cases = [
        ("#[budget(flops = 9, on(R))]", "there is no support `R`"),
        ("#[budget(time = 9)]", "a budget is a number of operations: `flops = 120`"),
        ("#[budget(flops = 9, under(P))]", "expected the closed supports: `on(P, Q)`, or `on()` for none"),
        ("#[budget(flops = 0)]", "`flops` must be a whole number from 1"),
    ];
    for (budget, expected) in cases {
        let told = find_mistakes_in(budget);
        assert!(told.len() == 1 && told[0].starts_with(expected), "{budget}: {told:?}");
    }
}

#[test]
fn a_set_without_code_of_its_own_has_no_budget() {
    let three = "#[budget(flops = 9, on(A, B, C))] #[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = l)]
        #[support(A = floor)] #[support(B = floor)] #[support(C = floor)] #[support(D = wall(0), under = A, facing = right)]
        #[liftoff(sets = 1)] #[figure(A = (0, 0), B = (l, 0), C = (2 * l, 0))] struct S { m: f64, l: f64 }";
    let told = find_mistakes(three);
    assert_eq!(told, ["nothing to count: this contact set has no code of its own"]);
}
