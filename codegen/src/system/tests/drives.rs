//! Drives of relative motions.

use super::{messages, point, resolve, text};
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
