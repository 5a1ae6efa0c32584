//! Angles that are multiples of one another.

use super::{analysis, find_mistakes};
use crate::algebra::Symbol;

const BARS: &str = "#[bar(AB, mass = m, length = l)] #[bar(CD, mass = m, length = l)] #[bar(EF, mass = m, length = l)] \
                    #[pin(A = (0, 0))] #[pin(C = (2 * l, 0))] #[pin(E = (4 * l, 0))] \
                    #[figure(B = (l, 0), D = (3 * l, 0), F = (5 * l, 0))] #[coordinate(phi = angle(AB), from = up)]";
const STRUCT: &str = "struct Gears { m: f64, l: f64 }";

/// Multiples of the angle of each bar.
fn turns(attributes: &str) -> Vec<i16> {
    let analysis = analysis(&format!("{BARS} {attributes} {STRUCT}"));
    let free = analysis.kinematics.coordinates.len();
    assert_eq!(free, 1, "{attributes}");
    analysis
        .kinematics
        .directions
        .iter()
        .map(|direction| direction.coefficient(Symbol::coordinate(0)))
        .collect()
}

#[test]
fn gears_have_one_angle() {
    assert_eq!(turns("#[equal(angle(CD), 2 * phi)] #[equal(angle(EF), -3 * angle(CD))]"), [1, 2, -6]);
    assert_eq!(turns("#[equal(-angle(CD), phi, 4 * angle(EF))]"), [4, -4, 1]);
    // A ratio of 2 : 3 by a third.
    assert_eq!(turns("#[equal(phi, 2 * angle(EF))] #[equal(angle(CD), 3 * angle(EF))]"), [2, 3, 1]);
}

#[test]
fn mistakes_are_reported() {
    let example = "(for example `#[equal(angle(AB), angle(CD))]`)";
    let cases = [
        ("#[equal(phi, 0 * angle(CD))]", format!("the multiple of an angle is a whole number from 1 to 64 {example}")),
        ("#[equal(phi, 65 * angle(CD))]", format!("the multiple of an angle is a whole number from 1 to 64 {example}")),
        ("#[equal(phi, 1.5 * angle(CD))]", format!("the multiple of an angle is a whole number from 1 to 64 {example}")),
        ("#[equal(phi, 2)]", format!("expected `*` {example}")),
        (
            "#[equal(2 * phi, 3 * angle(CD))]",
            "of angles that turn together one is a whole multiple of the other: `equal(phi, 2 * psi)`; where none is, both are \
             multiples of the angle of a third bar"
                .to_owned(),
        ),
        (
            "#[equal(phi, 2 * angle(CD))] #[equal(2 * phi, 4 * angle(CD))]",
            "2 phi and 4 angle(CD) are equal already; remove this constraint".to_owned(),
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(find_mistakes(&format!("{BARS} {attributes} {STRUCT}")), [expected], "{attributes}");
    }
}

/// A train whose last wheel turns beyond what is exact is a mistake, not an overflow.
#[test]
fn long_trains_are_reported() {
    let bars: String = (0..8)
        .map(|i| {
            format!(
                "#[bar(b{i} = P{i} -> Q{i}, mass = m, length = l)] #[pin(P{i} = ({}, 0))] #[figure(Q{i} = ({} + l, 0))] ",
                i, i
            )
        })
        .collect();
    let gears: String = (0..7).map(|i| format!("#[equal(angle(b{}), 64 * angle(b{i}))] ", i + 1)).collect();
    let told =
        find_mistakes(&format!("{bars} {gears} #[gravity(g)] struct Train {{ m: f64, l: f64, g: f64 }}"));
    assert!(told.iter().any(|text| text.contains("overflow")), "{told:?}");
}
