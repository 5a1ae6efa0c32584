//! The emitted Rust itself: what a reader of the expansion sees, and what a scene must not contain.

use liftoff::model::BarSystem;
use liftoff_models::{FallingPair, Pendulum};

fn emitted(declaration: &str) -> String {
    let tokens = liftoff_codegen::expand(declaration.parse().unwrap());
    prettyplease::unparse(&syn::parse2(tokens).unwrap())
}

/// The functions of the phases, from the first `enum` on.
fn phases(declaration: &str) -> String {
    let code = emitted(declaration);
    code[code.find("enum Free").unwrap()..].to_owned()
}

#[test]
fn pendulum() {
    insta::assert_snapshot!(phases(Pendulum::LAYOUT.declaration));
}

#[test]
fn falling_pair() {
    insta::assert_snapshot!(phases(FallingPair::LAYOUT.declaration));
}

#[test]
fn without_gravity_there_is_none() {
    let free = emitted(
        "#[bar(AB, mass = m, length = l)] #[pin(A = (0, 0))]
         struct Wheel { m: f64, l: f64 }",
    );
    assert!(!free.contains("Gravity"), "{free}");
    assert!(free.contains("potential: S::ratio(0, 1)"), "{free}");
    let analysis = liftoff_codegen::analyse(
        "#[bar(AB, mass = m, length = l)] #[pin(A = (0, 0))] struct Wheel { m: f64, l: f64 }"
            .parse()
            .unwrap(),
    )
    .unwrap();
    let phase = &analysis.functions.phases[0];
    let cost = analysis.functions.program.cost(&phase.accelerations);
    assert_eq!(cost, liftoff_codegen::program::Cost::default(), "a free wheel has no torque: {cost}");
}

/// No support, no gap, no reaction, no foot.
#[test]
fn without_supports_there_is_no_contact() {
    let analysis = liftoff_codegen::analyse(Pendulum::LAYOUT.declaration.parse().unwrap()).unwrap();
    assert!(analysis.functions.kernel.gap.is_empty() && analysis.functions.feet.is_empty());
    assert_eq!(analysis.functions.phases.len(), 1);
    assert!(analysis.functions.phases[0].reactions.is_empty());
}
