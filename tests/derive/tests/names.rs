//! Names of a model as its constants.

use liftoff_core::BarSystem as _;
use liftoff_core::model::names::{ContactName, CoordinateName, PointName, ThreadName};
use liftoff_derive::BarSystem;

#[derive(BarSystem)]
#[liftoff(crate = liftoff_core)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[ground(O = (0, l))]
#[thread(rope = A -> O, length = 2 * l)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
struct Ladder {
    m: f64,
    l: f64,
    g: f64,
}

fn coordinate(name: impl CoordinateName) -> String {
    name.as_ref().to_owned()
}

fn contact(name: impl ContactName) -> String {
    name.as_ref().to_owned()
}

fn thread(name: impl ThreadName) -> String {
    name.as_ref().to_owned()
}

fn point(name: impl PointName) -> String {
    name.as_ref().to_owned()
}

#[test]
fn constants_and_strings_are_taken_alike() {
    let owned = String::from("A");
    assert_eq!([coordinate(Ladder::PHI), coordinate("phi")], ["phi"; 2]);
    assert_eq!([coordinate(Ladder::PHI.rate()), coordinate(format!("{}'", Ladder::PHI))], ["phi'"; 2]);
    assert_eq!([contact(Ladder::A), contact(Ladder::ROPE), contact(&owned)], ["A", "rope", "A"]);
    assert_eq!([thread(Ladder::ROPE), thread("rope")], ["rope"; 2]);
    assert_eq!([point(Ladder::B), point(Ladder::O)], ["B", "O"]);
    assert_eq!(["A", "O"].iter().map(point).collect::<String>(), "AO");
}

#[test]
fn constants_are_compared_with_what_is_read() {
    assert_eq!(Ladder::LAYOUT.contacts[1].supports, [Ladder::B]);
    assert_eq!(Ladder::LAYOUT.coordinates[0].name, Ladder::PHI);
}

/// A model whose own items have such names.
#[test]
fn a_model_can_do_without() {
    #[derive(BarSystem)]
    #[liftoff(crate = liftoff_core, names = false)]
    #[bar(AB, mass = m, length = l)]
    #[pin(A = (0, 0))]
    struct Rod {
        m: f64,
        l: f64,
    }

    impl Rod {
        const A: f64 = 1.0;
    }

    assert_eq!(Rod::A + Rod { m: 1.0, l: 2.0 }.parameters()[0], 2.0);
}
