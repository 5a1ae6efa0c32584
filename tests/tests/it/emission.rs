//! The emitted Rust itself: what a reader of the expansion sees, and what a scene must not contain.

use core::fmt::Write;

use liftoff_codegen::algebra::Symbol;
use liftoff_codegen::program::{Cost, Id};
use liftoff_codegen::{Analysis, analyse};
use liftoff_compiled::{FallingPair, Pendulum, models};
use liftoff_core::model::BarSystem;

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

#[test]
fn the_runtime_tells_as_many_contacts_as_the_generator_admits() {
    assert_eq!(liftoff_codegen::motion::MOST_CONTACTS, liftoff_core::model::ContactSet::CAPACITY);
    assert_eq!(liftoff_codegen::motion::MOST_GUIDES, liftoff_core::model::ContactSet::GUIDES);
    assert_eq!(liftoff_codegen::motion::MOST_HINGES, liftoff_core::model::Layout::HINGES);
}

/// Operations of each right-hand side, by closed contacts.
fn costs(declaration: &str) -> Vec<(String, Cost)> {
    let Analysis { system, motion, functions, .. } = analyse(declaration.parse().unwrap()).unwrap();
    let label = |set: u64| {
        let closed = motion.contacts.iter().enumerate().filter(|(i, _)| set >> i & 1 == 1);
        closed.map(|(_, contact)| contact.label(&system)).collect::<Vec<_>>().join(", ")
    };
    let cost = |outputs: Vec<Id>| functions.program.cost(&outputs);
    let phases = functions.phases.iter();
    phases
        .map(|phase| (label(phase.set.closed), cost([&phase.rates[..], &phase.accelerations].concat())))
        .collect()
}

/// What every contact set of every model costs: no change makes one dearer unseen.
#[test]
fn operations() {
    let mut table = String::new();
    for model in models().iter() {
        for (closed, cost) in costs(model.layout().declaration) {
            writeln!(table, "{:18} {closed:24} {:4}: {cost}", model.name(), cost.flops()).unwrap();
        }
    }
    insta::assert_snapshot!(table);
}

/// The paper's equation of motion of Fig. 1a on its supports,
/// `(4/3 + sec⁴φ − 2 sec φ) φ̈ + sin φ sec²φ (2 sec³φ − 1) φ̇² = (2g/l)(sec²φ − cos
/// φ)`, by hand, each product fused with the addition that follows:
///
/// ```text
/// sec = 1/cos   sec2 = sec²   p = sec2 sec                         ÷, 2 ×
/// inertia = sec2² + (−2 sec + 4/3)                                 2 ×+
/// velocity = ((sin sec2) (2 p − 1)) φ̇²                             3 × with that of φ̇², ×+
/// φ̈ = ((2g/l) (sec2 − cos) − velocity) / inertia                   −, ×, ×+, ÷
/// ```
///
/// Derived, one division is saved, and sec²φ − cos φ keeps its digits at small φ, where this has
/// none.
#[test]
fn a_pair_on_its_corners_costs_no_more_than_by_hand() {
    let by_hand =
        Cost { additions: 1, multiplications: 6, fused: 4, divisions: 2, roots: 0, angles: 1, elementary: 0 };
    let costs = costs(FallingPair::LAYOUT.declaration);
    let (_, derived) = costs.iter().find(|(closed, _)| closed == "P, Q").unwrap();
    assert!(derived.weight() <= by_hand.weight(), "{derived}, by hand {by_hand}");
}

/// By hand φ̈ = −(3 g / 2 l) sin φ: the mass cancels, and nothing is divided in a call.
#[test]
fn cancelled_terms_cost_no_operation() {
    let by_hand = Cost { multiplications: 1, angles: 1, ..Cost::default() };
    let costs = costs(Pendulum::LAYOUT.declaration);
    assert_eq!(costs[0].1, by_hand, "{}", costs[0].1);
    let code = phases(Pendulum::LAYOUT.declaration);
    assert!(code.contains("k.three_halves_g_over_l"), "{code}");
}

/// What parameters determine is named after what it is; of c and −c one is stored.
#[test]
fn constants_have_names() {
    for model in
        models().iter().filter(|model| ["pendulum", "falling-pair", "zigzag"].contains(&model.name()))
    {
        let code = emitted(model.layout().declaration);
        let fields = code.split("pub struct Constants<S> {").nth(1).unwrap().split('}').next().unwrap();
        let fields: Vec<&str> = fields.lines().filter_map(|line| line.trim().strip_suffix(": S,")).collect();
        let is_numbered =
            |name: &&&str| name.strip_prefix('k').is_some_and(|rest| rest.parse::<u32>().is_ok());
        let numbered: Vec<_> = fields.iter().filter(is_numbered).collect();
        assert!(numbered.len() <= 1, "{}: {numbered:?}", model.name());
        let signed: Vec<_> = fields.iter().filter(|name| name.starts_with("minus_")).collect();
        assert!(signed.is_empty(), "{}: {signed:?}", model.name());
    }
}

/// φ̈ has the factor cos φ that the reactions of A, C and E divide it by: the only division is that
/// by the mass.
#[test]
fn removable_divisions_are_removed() {
    let models = models();
    let zigzag = models.iter().find(|model| model.name() == "zigzag").unwrap();
    let Analysis { functions, .. } = analyse(zigzag.layout().declaration.parse().unwrap()).unwrap();
    let phase = functions.phases.iter().find(|phase| phase.set.closed == 0b011).unwrap();
    let outputs = [&phase.accelerations[..], &phase.reactions].concat();
    let cost = functions.program.cost(&outputs);
    assert_eq!(cost.divisions, 1, "{cost}");
    let upright = |symbol| match symbol {
        Symbol::Parameter(_) => 1.0,
        Symbol::Coordinate { order: 0, .. } => core::f64::consts::FRAC_PI_2,
        _ => 0.0,
    };
    // At rest upright all that is above C stands on it and on A, E: M a = f of the limit, φ̈ / cos
    // φ = −3 (m₁ + m₂) g / (2 l (m₁ + 7 m₂)).
    let found = functions.program.evaluate(&phase.reactions[..2], &upright);
    let limit = -3.0 / 8.0;
    let expected = [1.0 - 5.0 / 3.0 * limit, 3.0 + 5.0 / 3.0 * limit];
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() < 1e-14, "{found} for {expected}");
    }
}
