//! Degrees of freedom that are known.

use super::modes;
use crate::prelude::*;

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

/// A driven crank above a floor.
#[derive(BarSystem)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 2 * l))]
#[support(A = floor)]
#[figure(A = (l, 2 * l))]
#[coordinate(phi = angle(OA), from = right)]
#[drive(phi = w * t)]
struct Crank {
    m: f64,
    l: f64,
    w: f64,
}

/// A rod on three floors keeps one degree of freedom however many of them it touches.
#[test]
fn redundant_contacts_take_no_freedom() {
    let modes = modes(&Rod { m: 1.0, l: 1.0 }).unwrap();
    let degrees: Vec<usize> = modes.modes.iter().map(|mode| mode.degrees).collect();
    assert_eq!(degrees, [3, 2, 2, 2, 1, 1, 1, 1]);
    assert_eq!(modes.transitions.len(), 12);
}

/// A pendulum has no contacts to be free of; a crank that is driven is not free whatever is open.
#[test]
fn what_nothing_is_closed_in_is_called_by_what_there_is() {
    let title = |text: String| text.split("  ").next().map(str::to_owned);
    let crank = modes(&Crank { m: 1.0, l: 1.0, w: 1.0 }).unwrap();
    assert_eq!((crank.modes[0].degrees, title(crank.to_string())), (0, Some("no contact closed".into())));
    let bars = modes(&liftoff_fixtures::DoublePendulum { m: 1.0, l: 1.0, g: 9.81 }).unwrap();
    assert_eq!(title(bars.to_string()).as_deref(), Some("no contacts"));
    assert!(crank.dot().contains("no contact closed"));
}

#[test]
fn a_ladder_has_four_modes() {
    let modes = modes(&liftoff_fixtures::Ladder { m: 1.0, l: 2.0, g: 9.81 }).unwrap();
    let text = "free     degrees 3, own code; + A; + B\n\
                on A     degrees 2, own code; + B; − A\n\
                on B     degrees 2, own code; + A; − B\n\
                on A, B  degrees 1, own code; − A; − B\n";
    assert_eq!(modes.to_string(), text);
    let dot = modes.dot();
    assert!(dot.contains("3 [label=\"on A, B\\n1\"]") && dot.contains("1 -> 3 [label=\"B\"]"), "{dot}");
}

/// A block on a floor with friction.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, friction = mu)]
#[figure(P = (0, 0))]
struct Block {
    m: f64,
    g: f64,
    mu: f64,
}

/// Sliding takes one degree of freedom, sticking two; a contact closes into either.
#[test]
fn a_contact_with_friction_slides_or_sticks() {
    let modes = modes(&Block { m: 1.0, g: 9.81, mu: 0.3 }).unwrap();
    let text = "free           degrees 2, own code; + P sliding; + P sticking\n\
                on P sliding   degrees 1, own code; P sticks; − P\n\
                on P sticking  degrees 0, own code; − P; P slips\n";
    assert_eq!(modes.to_string(), text);
    assert!(modes.dot().contains("1 -> 2 [label=\"P\", style=dotted]"), "{}", modes.dot());
}
