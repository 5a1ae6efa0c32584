//! Degrees of freedom that are known.

use super::modes;
use crate::prelude::*;

#[path = "../../tests/common/ladder.rs"]
pub(crate) mod ladder;

/// A rod of length 2 `l`, level on three floors.
#[derive(BarSystem)]
#[bar(AB, mass = m, length = 2 * l)]
#[point(C = AB, at = l)]
#[support(A = floor)]
#[support(B = floor)]
#[support(C = floor)]
#[figure(A = (0, 0), B = (2 * l, 0))]
struct Rod {
    m: f64,
    l: f64,
}

/// A rod on three floors keeps one degree of freedom however many of them it touches.
#[test]
fn redundant_contacts_take_no_freedom() {
    let modes = modes(&Rod { m: 1.0, l: 1.0 }).unwrap();
    let degrees: Vec<usize> = modes.modes.iter().map(|mode| mode.degrees).collect();
    assert_eq!(degrees, [3, 2, 2, 2, 1, 1, 1, 1]);
    assert_eq!(modes.transitions.len(), 12);
}

#[test]
fn a_ladder_has_four_modes() {
    let modes = modes(&ladder::Ladder { m: 1.0, l: 2.0, g: 9.81 }).unwrap();
    let text = "free     degrees 3, own code; + A; + B\n\
                on A     degrees 2, own code; + B; − A\n\
                on B     degrees 2, own code; + A; − B\n\
                on A, B  degrees 1, own code; − A; − B\n";
    assert_eq!(modes.to_string(), text);
    let dot = modes.dot();
    assert!(dot.contains("3 [label=\"on A, B\\n1\"]") && dot.contains("1 -> 3 [label=\"B\"]"), "{dot}");
}

/// A box for each set, an arrow for each change, a name at each arrow.
#[cfg(feature = "report")]
#[test]
fn the_graph_is_drawn() {
    let svg = modes(&ladder::Ladder { m: 1.0, l: 2.0, g: 9.81 }).unwrap().svg();
    let count = |what: &str| svg.matches(what).count();
    assert_eq!((count("<rect "), count("url(#closes-0)"), count("url(#closes-1)")), (4, 3, 3));
    assert!(svg.contains(">A | B</text>") && svg.contains(">1 degree</text>"));
    assert_eq!((count(">A</text>"), count(">B</text>")), (3, 3));
}

/// A bar over seven corners: too many sets to draw them one by one.
#[cfg(feature = "report")]
#[derive(BarSystem)]
#[bar(AB, mass = m, length = 9 * l)]
#[support(P1 = corner(l, 0), under = AB)]
#[support(P2 = corner(2 * l, 0), under = AB)]
#[support(P3 = corner(3 * l, 0), under = AB)]
#[support(P4 = corner(4 * l, 0), under = AB)]
#[support(P5 = corner(5 * l, 0), under = AB)]
#[support(P6 = corner(6 * l, 0), under = AB)]
#[support(P7 = corner(7 * l, 0), under = AB)]
#[figure(A = (0, 0), B = (9 * l, 0))]
#[liftoff(sets = 4)]
struct Plank {
    m: f64,
    l: f64,
}

#[cfg(feature = "report")]
#[test]
fn many_sets_are_drawn_by_the_number_of_closed_contacts() {
    let svg = modes(&Plank { m: 1.0, l: 1.0 }).unwrap().svg();
    assert_eq!(svg.matches("<rect ").count(), 8);
    assert!(svg.contains(">3 closed: 35 sets</text>") && svg.contains(">1 closed: 7 sets</text>"));
}
