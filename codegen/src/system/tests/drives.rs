//! Drives of relative motions.

use super::{Series, messages, point, resolve, text};
use crate::algebra::Symbol;
use crate::system::Driven;

const BARS: &str = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = a)] #[particle(P, mass = m)] \
                    #[pin(A = (0, 0))] #[figure(B = (l, 0), C = (l, a), P = (l, 3 * a))]";
const STRUCT: &str = "struct S { m: f64, l: f64, g: f64, a: f64 }";

#[test]
fn distances_angles_and_places_along_bars_are_driven() {
    let system = resolve(&format!(
        "{BARS} #[drive(distance(P, C) = a + a * t)] #[drive(angle(AB, BC) = t)] #[drive(along(P, AB) = l * t)]"
    ));
    let system = system.unwrap();
    let names: Vec<&str> = system.drives.iter().map(|drive| drive.name.as_str()).collect();
    assert_eq!(names, ["distance(P, C)", "angle(AB, BC)", "along(P, AB)"]);
    let Driven::Distance { ends, inverse } = &system.drives[0].driven else { panic!() };
    assert_eq!(
        (*ends, text(&system, inverse)),
        (["C", "P"].map(|name| point(&system, name)), "½ (1/a)".into())
    );
    assert_eq!(system.drives[1].driven, Driven::Turn { from: 0, body: 1 });
    assert_eq!(system.drives[2].driven, Driven::Along { point: point(&system, "P"), body: 0 });
}

#[test]
fn mistakes_are_reported() {
    let cases = [
        (
            "#[drive(distance(A, B) = a)]",
            "drive `distance(A, B)` has no effect: the distance of `A` and `B` never changes",
        ),
        (
            "#[drive(distance(P, P) = a)]",
            "drive `distance(P, P)` has no effect: the distance of `P` and `P` never changes",
        ),
        (
            "#[drive(distance(P, C) = a, while = 1)]",
            "write the condition in quotes: `while(\"phi > 0\")` (for example `#[drive(phi = omega * t)]`)",
        ),
        (
            "#[drive(distance(P, C) = a, l)]",
            "one drive has one value; write another `#[drive(…)]` (for example `#[drive(phi = omega * t)]`)",
        ),
        (
            "#[drive(distance(P, C) = a, while(\"t < 1\"))] #[drive(distance(C, P) = l)]",
            "`distance(C, P)` is driven twice; remove one drive",
        ),
        ("#[drive(distance(P, C) = 0)]", "the distance driven from `P` is 0; it must be positive"),
        (
            "#[drive(distance(P, C) = a)] #[drive(distance(C, P) = l)]",
            "`distance(C, P)` is driven twice; remove one drive",
        ),
        (
            "#[drive(distance(P, C) = y(B))]",
            "a drive prescribes motion as a function of time: its value may contain `t` and parameters, no motion",
        ),
        (
            "#[ground(O = (l, a))] #[drive(distance(O, C) = a)]",
            "the figure shows `O` and `C` at one place, so the drive of their distance has no direction; draw them apart",
        ),
        ("#[drive(angle(BC, BC) = t)]", "`BC` does not turn against itself"),
        ("#[drive(along(B, BC) = a)]", "`B` is a point of `BC`; it does not move along it"),
        ("#[drive(along(P, BD) = a)]", "there is no bar `BD`; did you mean `BC`?"),
        ("#[drive(along(P) = a)]", "write `along(POINT, BAR)` (for example `#[drive(phi = omega * t)]`)"),
        (
            "#[drive(distance(P) = a)]",
            "write `distance(POINT, POINT)` (for example `#[drive(phi = omega * t)]`)",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(messages(&format!("{BARS} {attributes} {STRUCT}")), [expected], "{attributes}");
    }
}

/// A pin and a weld on conditions are the drives that one would write for them.
#[test]
fn joints_that_let_go_are_drives() {
    let analyse = |joint: &str| {
        let text = format!(
            "#[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = l)] {joint}
             #[figure(B = (a + l, 0), C = (a + l, l))] struct Rods {{ m: f64, l: f64, f: f64, a: f64 }}"
        );
        let analysis =
            crate::analyse(text.parse().unwrap()).unwrap_or_else(|error| panic!("{joint}: {error}"));
        let supports = analysis.system.supports.iter();
        let conditions: Vec<_> =
            supports.map(|s| (s.name.clone(), s.armed.clone(), s.breaks.clone())).collect();
        let gaps: Vec<Series> = analysis.motion.contacts.iter().map(|c| c.row.gap.clone()).collect();
        let quantities = analysis.functions.quantities.iter().map(|quantity| quantity.name.clone());
        (conditions, gaps, quantities.collect::<Vec<_>>())
    };
    for (joint, drives) in [
        (
            "#[pin(A = (a, 0), while(\"t < f\"))]",
            "#[drive(x(A) = a, while(\"t < f\"))] #[drive(y(A) = 0, while(\"t < f\"))] #[coordinate(x_A = x(A))]",
        ),
        (
            "#[pin(A = (a, 0), breaks(\"N(A) > f\"))]",
            "#[drive(x(A) = a, breaks(\"N(A) > f\"))] #[drive(y(A) = 0, breaks(\"N(A) > f\"))] #[coordinate(x_A = x(A))]",
        ),
        (
            "#[weld(AB, BC, angle = pi / 2, while(\"t < f\"), breaks(\"t > f\"))] #[drive(y(A) = a)]",
            "#[drive(angle(AB, BC) = pi / 2, while(\"t < f\"), breaks(\"t > f\"))] #[drive(y(A) = a)]",
        ),
        (
            "#[weld(AB, angle = 0, while(\"t < f\"))] #[drive(y(A) = a)]",
            "#[drive(angle(AB) = 0, while(\"t < f\"))] #[drive(y(A) = a)]",
        ),
    ] {
        assert_eq!(analyse(joint), analyse(drives));
    }
    let (conditions, gaps, quantities) = analyse("#[pin(A = (a, 0), breaks(\"N(A) > f\"))]");
    let condition = Some("N(A) > f".to_owned());
    let names = ["drive x(A)", "drive y(A)"];
    assert_eq!(conditions, names.map(|name| (name.to_owned(), None, condition.clone())));
    // A place that does not change is no function of time.
    let is_opaque = |symbol: Symbol| matches!(symbol, Symbol::Opaque { .. });
    assert!(gaps.iter().all(|gap| !gap.symbols().into_iter().any(is_opaque)), "{gaps:?}");
    assert!(["fx(A)", "fy(A)"].iter().all(|name| quantities.iter().any(|q| q == name)), "{quantities:?}");
}

#[test]
fn joints_that_cannot_let_go_say_what_can() {
    let cases = [
        (
            "#[pin(B = (l, 0))] #[pin(B = (l, 0), while(\"t < a\"))]",
            "point `B` is pinned twice; remove one pin",
        ),
        (
            "#[pin(B = (a, 0), breaks(\"t > a\"))]",
            "`B` is pinned to another place than the figure says; leave it out of the figure",
        ),
        (
            "#[pin(C = (l, a), breaks = 3)]",
            "write the condition in quotes: `breaks(\"phi > 0\")` (for example `#[pin(O = (0, 0))]`)",
        ),
        (
            "#[pin(C = (l, a), until(\"t > 1\"))]",
            "there is no option `until`; declared: `while`, `breaks` (for example `#[pin(O = (0, 0))]`)",
        ),
        (
            "#[weld(AB, BC, breaks(\"t > 1\"))]",
            "a weld of `AB` that lets go needs its angle, from the first to the second: `angle = a` (for example `#[weld(AB, BC)]`)",
        ),
        (
            "#[hinge(B, while(\"t < 1\"))]",
            "what shares a point does not come apart: give each body a point of its own there, `B` and `Q`, and hold `Q` by \
             `drive(along(Q, BAR) = s, while(\"…\"))` and one `support` under it on either side of the bar, `bar(BAR)`, with the same \
             condition (for example `#[hinge(A, friction = mu, radius = r)]`)",
        ),
        (
            "#[spring(PC, stiffness = m, breaks(\"t > 1\"))]",
            "`breaks` is for what bears a reaction: supports, threads, limits, the `stops` of a slider, drives, pins to the ground \
             and welds; what acts by a law of its own has `while` (for example `#[spring(AB, stiffness = k, length = l)]`)",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(messages(&format!("{BARS} {attributes} {STRUCT}")), [expected], "{attributes}");
    }
}

/// A drive on a condition is a contact that holds both ways, with the row of the joint that it
/// would be without.
#[test]
fn drives_on_conditions_are_contacts() {
    let drive = "#[drive(along(P, AB) = a + m * t, while(\"t > 1\"))]";
    let [switched, always] = [drive, "#[drive(along(P, AB) = a + m * t)]"].map(|drive| {
        let text = format!("#[liftoff(dimensionless)] {BARS} {drive} {STRUCT}");
        crate::analyse(text.parse().unwrap()).unwrap()
    });
    let [contact] = &switched.motion.contacts[..] else { panic!() };
    assert_eq!(contact.label(&switched.system), "drive along(P, AB)");
    assert_eq!(contact.support(&switched.system).armed.as_deref(), Some("t > 1"));
    let joint = always.kinematics.joints.last().unwrap();
    assert_eq!(contact.row.gap, joint.equation);
    assert_eq!(switched.kinematics.joints.len() + 1, always.kinematics.joints.len());
}

/// It and its image would have to take hold as one.
#[test]
fn drives_on_conditions_have_no_images() {
    let pair = "#[bar(AD, mass = m, length = l)] #[bar(DB, mass = m, length = l)] \
                #[figure(D = (0, 0), A = (-l, 0), B = (l, 0))] #[mirror(x = 0)]";
    let told = messages(&format!("{pair} #[drive(y(D) = a * g * t, while(\"t < 1\"))] {STRUCT}"));
    let expected = "in a mirrored model drives are always there: `y(D)` has a condition; leave `mirror` out, or write a `couple`, a \
                    `force` or a stiff `spring` with `while(\"…\")`";
    assert_eq!(told, [expected]);
}

/// A distance across the mirror is its own image; along a bar that is named from its other end what
/// is left of it is driven.
#[test]
fn images_are_driven_alike() {
    let pair = "#[bar(AD, mass = m, length = l)] #[bar(DB, mass = m, length = l)] #[particle(P, mass = g)] #[particle(Q, mass = g)] \
                #[figure(D = (0, 0), A = (-l, 0), B = (l, 0), P = (-l, a), Q = (l, a))]";
    let told = |attributes: &str| messages(&format!("{pair} {attributes} #[mirror(x = 0)] {STRUCT}"));
    assert_eq!(told("#[drive(distance(P, Q) = a + a * t)]"), [""; 0]);
    assert_eq!(told("#[drive(along(P, AD) = a * t)] #[drive(along(Q, DB) = l - a * t)]"), [""; 0]);
    assert_eq!(
        told("#[drive(along(P, AD) = a * t)] #[drive(along(Q, DB) = a * t)]"),
        ["drives `along(P, AD)` and `along(Q, DB)` are not mirror images: their values differ"]
    );
    assert_eq!(
        told("#[drive(distance(P, D) = a + a * t)]"),
        ["drive `distance(P, D)` has no mirror image; declare one for `distance(D, Q)` too"]
    );
}
