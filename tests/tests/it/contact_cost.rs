//! A closed contact costs no more than the same constraint declared as a joint: operation counts of
//! accelerations, and where the joint's force is a quantity, of the reactions too.

use liftoff_codegen::program::Id;
use liftoff_codegen::{Analysis, analyse};

/// A contact may cost so much more than the joint.
const RATIO: f64 = 1.3;

fn derived(declaration: &str) -> Analysis {
    let tokens = declaration.parse().expect("a declaration is Rust");
    analyse(tokens).unwrap_or_else(|error| panic!("{error}: {declaration}"))
}

fn phase(analysis: &Analysis, set: u64, extra: &[Id]) -> f64 {
    let functions = &analysis.functions;
    let phase = functions.phases.iter().find(|phase| phase.set.closed == set);
    let phase = phase.unwrap_or_else(|| panic!("{} has no closed form for {set:b}", analysis.system.ident));
    let outputs: Vec<Id> = phase.accelerations.iter().chain(extra).copied().collect();
    functions.program.cost(&outputs).weight() as f64
}

/// The contacts of `set` of the first against the joints of the second.
fn compare(contacts: &str, set: u64, joints: &str) {
    let (with_contacts, with_joints) = (derived(contacts), derived(joints));
    let (contact, joint) = (phase(&with_contacts, set, &[]), phase(&with_joints, 0, &[]));
    assert!(contact <= RATIO * joint, "{contact} for {joint}: {contacts}");
}

const LADDER: &str = "#[gravity(g)] #[bar(AB, mass = m, length = l)]
    #[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))] #[coordinate(phi = angle(AB), from = horizontal)]";

#[test]
fn ladder_on_floor_and_wall() {
    let parameters = "struct Ladder { m: f64, l: f64, g: f64 }";
    let contacts =
        format!("{LADDER} #[support(A = floor)] #[support(B = wall(0), facing = right)] {parameters}");
    let joints = format!("{LADDER} #[slider(A = horizontal(0))] #[slider(B = vertical(0))] {parameters}");
    compare(&contacts, 0b11, &joints);
}

#[test]
fn zigzag_on_three_feet() {
    let bars = "#[gravity(g)] #[bar(AB, mass = m2, length = l)] #[bar(BC, mass = m1, length = l)]
        #[bar(CD, mass = m1, length = l)] #[bar(DE, mass = m2, length = l)] #[mirror(x = 0)]
        #[figure(C = (0, 0), D = (3 * l / 5, 4 * l / 5), E = (6 * l / 5, 0))]
        #[coordinate(phi_inner = angle(CD), from = horizontal)]
        #[coordinate(phi_outer = angle(DE), from = horizontal)] #[coordinate(y = y(C))]";
    let parameters = "struct Zigzag { m1: f64, m2: f64, l: f64, g: f64 }";
    let feet = |kind: &str, line: &str| -> String {
        ["A", "C", "E"].map(|foot| format!("#[{kind}({foot} = {line})]")).concat()
    };
    let contacts = format!("{bars} {} {parameters}", feet("support", "floor"));
    let joints = format!("{bars} {} {parameters}", feet("slider", "horizontal(0)"));
    compare(&contacts, 0b11, &joints);
}

/// Rough contacts against a pin, with both components of its force.
#[test]
fn rod_on_a_rough_point() {
    let bar =
        "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[figure(A = (0, 0), B = (3 * l / 5, 4 * l / 5))]
        #[coordinate(phi = angle(AB), from = horizontal)]";
    let parameters = "struct Rod { m: f64, l: f64, g: f64 }";
    let rough = derived(&format!("{bar} #[support(A = floor, rough)] {parameters}"));
    let pinned = derived(&format!("{bar} #[pin(A = (0, 0))] {parameters}"));
    let force: Vec<Id> = pinned
        .functions
        .quantities
        .iter()
        .filter(|quantity| quantity.name == "fx(A)" || quantity.name == "fy(A)")
        .map(|quantity| quantity.value)
        .collect();
    assert_eq!(force.len(), 2);
    let reactions = rough
        .functions
        .phases
        .iter()
        .find(|phase| phase.set.closed == 1)
        .map(|phase| phase.reactions.clone());
    let reactions = reactions.expect("a closed form");
    let (contact, joint) = (phase(&rough, 1, &reactions), phase(&pinned, 0, &force));
    assert!(contact <= RATIO * joint, "{contact} for {joint}");
}
