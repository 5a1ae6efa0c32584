use super::{Geometry, Look, Mark};

#[test]
fn points_of_the_ground_are_reported_once_with_feet_first() {
    let mark = |point, look| Mark { point, look };
    let marks = Box::leak(Box::new([
        mark(0, Look::Peg),
        mark(1, Look::Ground),
        mark(1, Look::Foot),
        mark(2, Look::Ground),
    ]));
    let geometry = Geometry { marks, ..Geometry::EMPTY };
    let grounded: Vec<_> = geometry.grounded().collect();
    assert_eq!(grounded, [(1, Look::Foot), (0, Look::Peg), (2, Look::Ground)]);
    assert_eq!(geometry.marked(Look::Ground).collect::<Vec<_>>(), [1, 2]);
    assert!(geometry.push("A").is_none());
}
