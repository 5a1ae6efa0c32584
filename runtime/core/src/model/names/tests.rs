use super::{ContactFilter, Coordinate, CoordinateName, Place, Support, Unknown};

const PHI: Coordinate = Coordinate::new("phi", "phi'");
const A: Place = Place::new("A");

#[test]
fn names_are_their_text() {
    assert_eq!(format!("{PHI}|{:>5}|{A}", PHI.rate()), "phi| phi'|A");
    assert_eq!((<&str>::from(PHI), <&str>::from(A), A.as_ref()), ("phi", "A", "A"));
    assert_eq!([PHI == "phi", PHI == *"psi", "phi" == PHI, A == "B"], [true, false, true, false]);
    assert_eq!((String::from(PHI), String::from(A)), ("phi".to_owned(), "A".to_owned()));
}

#[test]
fn a_filter_is_a_name_or_none() {
    assert_eq!((Support::new("A").contact(), "B".contact()), (Some("A"), Some("B")));
    assert_eq!((None::<&str>.contact(), Some("C").contact()), (None, Some("C")));
}

/// Whatever the mistake was about.
#[test]
fn an_unknown_name_has_a_rate() {
    fn length(name: impl CoordinateName) -> usize {
        name.as_ref().len()
    }
    assert_eq!(length(Unknown::new("phi").rate()), 3);
}
