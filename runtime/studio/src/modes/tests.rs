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

/// A bar with one end on a floor with friction and one on a smooth wall.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu)]
#[support(B = wall(0), facing = right)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
struct Rubbing {
    m: f64,
    l: f64,
    mu: f64,
    g: f64,
}

/// What leads to less freedom leads to the right, by dotted arrows where it sticks.
#[test]
fn contacts_that_stick_stand_to_the_right_of_those_that_slide() {
    let svg = svg(&modes(&Rubbing { m: 1.0, l: 1.0, mu: 0.3, g: 9.81 }).unwrap());
    let left = |title: &str| {
        let is = |line: &&str| line.contains("font-weight") && line.contains(&format!(">{title}</text>"));
        let line = svg.lines().find(is).unwrap();
        let x = line.split(" x=\"").nth(1).and_then(|rest| rest.split('"').next());
        x.unwrap().parse::<f64>().unwrap()
    };
    assert!(left("free") < left("A sliding") && left("A sliding") < left("A sticking"));
    assert_eq!(left("B"), left("A sliding"));
    assert_eq!(left("A sticking"), left("A sliding | B"));
    assert!(left("A sliding | B") < left("A sticking | B"));
    // Off the wall, at the wall, and in the legend.
    assert_eq!(svg.matches("stroke-dasharray=\"1 4\"").count(), 3);
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
