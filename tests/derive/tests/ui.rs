//! Mistakes are told at their place, all of a declaration at once: what the compiler prints of each.

#[test]
#[ignore = "starts compilers: `.ci/long ui`"]
fn mistakes_are_reported_at_their_place() {
    let cases = trybuild::TestCases::new();
    cases.compile_fail("tests/ui/*.rs");
    // Of models that know the runtime by another name; names of another kind among them.
    cases.compile_fail("tests/renamed/*.rs");
}
