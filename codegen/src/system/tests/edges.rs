//! Bars and edges of bodies as supports.

use super::{messages, point, resolve, text};
use crate::system::{Edge, OneSided, System};

const BARS: &str = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[body(hull, points(C = (0, 0), D = (l, 0), E = (0, a)), mass = m)] \
                    #[pin(A = (0, 0))] #[slider(D = horizontal(a))] #[figure(B = (l, 0), C = (l / 2, a), D = (3 * l / 2, a))]";
const STRUCT: &str = "struct S { m: f64, l: f64, g: f64, a: f64 }";

fn contact(system: &System) -> (usize, &Edge, i8) {
    let OneSided::Edge { point, edge, side } = &system.supports[0].contact else { panic!() };
    (*point, edge, *side)
}

#[test]
fn the_figure_says_on_which_side_a_point_stays() {
    let side = |support: &str| {
        let system = resolve(&format!("{BARS} {support}")).unwrap();
        contact(&system).2
    };
    assert_eq!(side("#[support(C = bar(AB))]"), 1);
    assert_eq!(side("#[support(C = bar(AB), facing = right)]"), -1);
    assert_eq!(side("#[support(B = edge(C, D))]"), -1);
    assert_eq!(side("#[support(B = edge(D, C))]"), 1);
    assert_eq!(side("#[support(heel = bar(AB), under = E)]"), 1);
    assert_eq!(side("#[ground(O = (l, -a))] #[support(O = bar(AB))]"), -1);
}

/// Whether C is above AB depends on a, whose sign only a model knows.
#[test]
fn a_side_that_parameters_may_change_is_kept_for_them() {
    let system = resolve(&format!("{BARS} #[support(C = bar(AB))]")).unwrap();
    let side = system.settled.iter().find(|settled| settled.name == "C").unwrap();
    assert_eq!([text(&system, &side.length), text(&system, &side.factor)], ["l a", "l"]);
}

#[test]
fn an_edge_lies_between_two_points_of_a_body() {
    let system = resolve(&format!("{BARS} #[support(B = edge(D, E))]")).unwrap();
    let (on, edge, _) = contact(&system);
    assert_eq!((on, edge.ends), (point(&system, "B"), ["D", "E"].map(|name| point(&system, name))));
    let [l, a] = [0.8_f64, 0.6];
    let values = [1.0, l, 1.0, a];
    let value = |series| system.parameter_value(series, &values);
    assert!((value(&edge.length) - 1.0).abs() < 1e-15);
    assert!((value(&edge.along[0]) + l).abs() < 1e-15 && (value(&edge.along[1]) - a).abs() < 1e-15);
}

#[test]
fn mistakes_are_reported() {
    let cases = [
        ("#[support(B = bar(AB))]", "`B` is a point of `AB`; a body does not meet itself"),
        (
            "#[support(C = bar(AB), facing = left)] #[support(back = bar(AB), facing = right, under = C)]",
            "`C` cannot stay on both sides of the line from `A` to `B`, which has no thickness: it is behind `C` or `back`; declare one \
             of them, give each a condition `while(\"…\")`, or give the body two sides",
        ),
        ("#[support(B = bar(hull))]", "`hull` is not a bar; this needs a bar, which has an axis"),
        (
            "#[support(D = edge(A, C))]",
            "`A` and `C` are not on one body; an edge lies between two points of one body",
        ),
        ("#[support(D = edge(A, A))]", "the ends of an edge must be different points"),
        ("#[support(B = bar(BA))]", "there is no bar `BA`; did you mean `AB`?"),
        ("#[support(B = bar())]", "write `bar(AB)` (for example `#[support(A = floor)]`)"),
        (
            "#[support(B = edge(C))]",
            "write `edge(A, B)` with two points of one body (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(C = bar(AB), facing = up)]",
            "a wall, a bar or an edge faces `left` or `right` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(C = bar(AB), facing = rihgt)]",
            "a wall, a bar or an edge faces `left` or `right`; did you mean `right`? (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(C = bar(AB), over = AB)]",
            "only a corner can be `over` something (for example `#[support(A = floor)]`)",
        ),
        (
            "#[particle(P, mass = m)] #[figure(P = (2 * l, 0))] #[support(P = bar(AB))]",
            "the figure shows `P` in line with it; say on which side it stays, seen from `A` to `B`: `facing = left` or `right`",
        ),
        (
            "#[particle(P, mass = m)] #[figure(P = (2 * l, a - m))] #[support(P = bar(AB))]",
            "the figure shows `P` on one side of it or the other, depending on the parameters; say on which side it stays, seen \
             from `A` to `B`: `facing = left` or `right`",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(messages(&format!("{BARS} {attributes} {STRUCT}")), [expected], "{attributes}");
    }
}

/// Of a bar that nothing else ties a support is enough.
#[test]
fn a_bar_that_meets_another_is_tied() {
    let loose = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(CD, mass = m, length = a)] #[pin(A = (0, 0))] \
                 #[figure(B = (l, 0), C = (0, a), D = (l, a))]";
    assert_eq!(messages(&format!("{loose} {STRUCT}")).len(), 1);
    assert_eq!(messages(&format!("{loose} #[support(B = bar(CD))] {STRUCT}")), [""; 0]);
}

#[test]
fn images_meet_from_the_same_side() {
    let pair = "#[gravity(g)] #[bar(AD, mass = m, length = l)] #[bar(DB, mass = m, length = l)] #[particle(P, mass = m)] \
                #[particle(Q, mass = m)] #[figure(D = (0, 0), A = (-l, 0), B = (l, 0), P = (-l / 2, a), Q = (l / 2, a))] \
                #[support(P = bar(AD))]";
    let mirrored = |support: &str| {
        let item = format!("{pair} {support} #[mirror(x = 0)]");
        resolve(&item).map(|system| system.mirror.unwrap().supports)
    };
    assert_eq!(mirrored("#[support(Q = bar(DB))]").unwrap(), [1, 0]);
    assert_eq!(mirrored("#[support(Q = edge(B, D))]").unwrap(), [1, 0]);
    let told = |support: &str| mirrored(support).unwrap_err().to_string();
    assert_eq!(
        told("#[support(Q = bar(DB), facing = right)]"),
        "supports `P` and `Q` are not mirror images: their places or free sides differ"
    );
    assert_eq!(told(""), "support `P` has no mirror image; declare one for point `Q` too");
}
