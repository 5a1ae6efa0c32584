//! Discs, and circles about points.

use super::{messages, point, resolve, text};
use crate::system::{Centre, OneSided, System};

const SCENE: &str = "#[gravity(g)] #[body(wheel, points(A = (0, 0), B = (a, 0)), mass = m, inertia = m * a * a / 2, centre = (0, 0))] \
                     #[bar(BC, mass = m, length = l)] #[particle(P, mass = m)] #[ground(O = (0, 5 * l))] \
                     #[figure(A = (0, 0), B = (a, 0), C = (a, l), P = (3 * l, 0))]";
const STRUCT: &str = "struct S { m: f64, l: f64, g: f64, a: f64 }";

fn scene(attributes: &str) -> System {
    resolve(&format!("{SCENE} {attributes}")).unwrap()
}

#[test]
fn discs_touch_with_their_rims() {
    let system = scene(
        "#[disc(A, radius = a)] #[disc(P, radius = l)] #[support(A = floor(-l))] #[support(P = disc(A))] #[support(B = circle(P, l))] \
         #[support(bowl = bowl(O, 9 * l), under = A)]",
    );
    let [a, p] = ["A", "P"].map(|name| point(&system, name));
    assert_eq!(
        system.discs.iter().map(|disc| (disc.centre, disc.body)).collect::<Vec<_>>(),
        [(a, Some(0)), (p, None)]
    );
    let radius = |i: usize| system.supports[i].disc.as_ref().map(|disc| text(&system, &disc.radius));
    assert_eq!([0, 1, 2, 3].map(radius), [Some("a".into()), Some("l".into()), None, Some("a".into())]);
    let circle = |i: usize| match &system.supports[i].contact {
        OneSided::Circle { centre: Centre::Point { point, body }, reach, inside, .. } => {
            (*point, *body, text(&system, reach), *inside)
        }
        other => panic!("{other:?}"),
    };
    assert_eq!(circle(1), (a, Some(0), "l + a".into(), false));
    assert_eq!(circle(2), (p, None, "l".into(), false));
    assert_eq!(circle(3), (point(&system, "O"), None, "9 l − a".into(), true));
}

/// A thread that is tied to the centre of a disc takes the way of its points.
#[test]
fn threads_may_end_at_discs() {
    let system = scene("#[disc(P, radius = l)] #[thread(rope = P -> O -> C, length = 20 * l)]");
    assert!(matches!(&system.supports[0].contact, OneSided::Thread { path, .. } if path.len() == 3));
}

#[test]
fn mistakes_are_reported() {
    let cases = [
        (
            "#[support(lid = circle((0, -l), a), under = BC)]",
            "`BC` is no point; a bar lies on a cylinder as the cylinder's disc on a side of the bar: \
             `#[ground(O = (x, y))] #[disc(O, radius = r)] #[support(O = bar(BC))]`",
        ),
        (
            "#[support(lid = circle(P, a), under = BC)]",
            "`BC` is no point; a bar lies on a cylinder as the cylinder's disc on a side of the bar: \
             `#[disc(P, radius = r)] #[support(P = bar(BC))]`",
        ),
        ("#[disc(A, radius = 0)]", "the radius of `A` is 0; it must be positive"),
        (
            "#[disc(O, radius = a)] #[thread(rope = P -> O -> C, length = 20 * l)]",
            "thread `rope` passes `O`, which has a disc; a thread does not wrap round discs: \
             lead it through a second point there, without a disc",
        ),
        (
            "#[disc(A, radius = a)] #[disc(A, radius = l)]",
            "`A` has two discs; remove one, or name a second point there",
        ),
        (
            "#[disc(B, radius = a)]",
            "`B` is a point of `wheel`, `BC`; name the body with which the disc turns: `on = wheel`",
        ),
        ("#[disc(C, radius = a, on = wheel)]", "`C` is no point of `wheel`"),
        ("#[disc(D, radius = a)]", "there is no point `D`; declared: `A`, `B`, `C`, `P`, `O`"),
        (
            "#[support(P = disc(A))]",
            "there is no disc about `A`; add `#[disc(A, radius = r)]`, or write `circle(A, r)`",
        ),
        (
            "#[support(P = disc(A, a))]",
            "write `disc(POINT)`, about which there is a `#[disc(POINT, radius = radius)]` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(A = circle(B, a))]",
            "support `A` has no effect: the distance of `A` and `B` never changes",
        ),
        ("#[support(O = circle((0, 0), a))]", "`O` is a fixed point; name one that moves"),
        (
            "#[disc(P, radius = 2)] #[support(P = bowl((3 * l, 0), 2))]",
            "the disc about `P` has no room in this bowl",
        ),
        (
            "#[support(P = circle(B, a), friction = l)]",
            "`B` is a point of several bodies, and where there is friction it matters with which the circle turns; name a point \
             of that body alone: `#[point(C = wheel, at = …)]`",
        ),
        (
            "#[disc(A, radius = a)] #[support(P = disc(A), moving = l, rough)]",
            "only a straight surface can be `moving` along itself: `floor`, `wall`, `slope`, `slot`, `bar`, `edge` (for \
             example `#[support(A = floor)]`)",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(messages(&format!("{SCENE} {attributes} {STRUCT}")), [expected], "{attributes}");
    }
}

/// Two of one figure that parameters do not change overlap in it.
#[test]
fn discs_that_overlap_in_the_figure_are_reported() {
    let told = messages(
        "#[particle(P, mass = m)] #[particle(Q, mass = m)] #[disc(P, radius = 1)] #[disc(Q, radius = 2)] #[support(P = disc(Q))] \
         #[figure(P = (0, 0), Q = (2, 0))] struct S { m: f64 }",
    );
    assert_eq!(told, ["the figure's point is 2 from the centre of this circle; it must be at least 3"]);
}

/// A disc that meets its own image, whichever of the two is named first.
#[test]
fn images_meet() {
    let pair = "#[particle(P, mass = m)] #[particle(Q, mass = m)] #[disc(P, radius = a)] #[figure(P = (-l, g), Q = (l, g))]";
    let mirrored = |attributes: &str| {
        let item = format!("{pair} {attributes} #[mirror(x = 0)]");
        resolve(&item).map(|system| system.mirror.unwrap().supports)
    };
    assert_eq!(mirrored("#[disc(Q, radius = a)] #[support(P = disc(Q))]").unwrap(), [0]);
    let floors = "#[support(P = floor)] #[support(Q = floor)]";
    assert_eq!(mirrored(&format!("#[disc(Q, radius = a)] {floors}")).unwrap(), [1, 0]);
    let told = mirrored(&format!("#[disc(Q, radius = 2 * a)] {floors}")).unwrap_err().to_string();
    assert_eq!(told, "`P` and `Q` are mirror images but differ in the radius of their discs");
}
