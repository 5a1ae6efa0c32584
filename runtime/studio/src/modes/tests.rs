use super::svg;
use liftoff::modes;
use liftoff::prelude::*;

/// A box for each set, an arrow for each change, a name at each arrow.
#[test]
fn the_graph_is_drawn() {
    let svg = svg(&modes(&liftoff_fixtures::Ladder { m: 1.0, l: 2.0, g: 9.81 }).unwrap());
    let count = |what: &str| svg.matches(what).count();
    assert_eq!((count("<rect "), count("stroke=\"#0072B2\""), count("stroke=\"#D55E00\"")), (4, 3, 3));
    assert!(svg.contains(">A | B</text>") && svg.contains(">1 degree</text>"));
    assert_eq!((count(">A</text>"), count(">B</text>")), (3, 3));
}

/// A bar over seven corners: too many sets to draw them one by one.
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

#[test]
fn many_sets_are_drawn_by_the_number_of_closed_contacts() {
    let svg = svg(&modes(&Plank { m: 1.0, l: 1.0 }).unwrap());
    assert_eq!(svg.matches("<rect ").count(), 8);
    assert!(svg.contains(">3 closed: 35 sets</text>") && svg.contains(">1 closed: 7 sets</text>"));
}
