//! Mistakes are told at their place, all of a declaration at once: what the compiler prints of each.

#[test]
fn mistakes_are_told_at_their_place() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
