//! Mirror images that are inferred, and mismatches that are told.

use super::{messages, place, system};

const PAIR: &str = "#[gravity(g)] #[bar(AD, mass = m, length = l)] #[bar(DB, mass = m, length = l)]";
const FIGURE: &str = "#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))] #[mirror(x = 0)]";
const STRUCT: &str = "struct S { m: f64, l: f64, g: f64 }";

fn told(attributes: &str) -> Vec<String> {
    messages(&format!("{attributes} {STRUCT}"))
}

#[test]
fn the_missing_half_of_a_symmetric_figure_is_its_mirror_image() {
    let system = system(
        "#[gravity(g)]
        #[bar(AD, mass = m, length = l)]
        #[bar(DB, mass = m, length = l)]
        #[support(P = corner(-l / 2, 0), under = AD)]
        #[support(Q = corner(l / 2, 0), under = DB)]
        #[figure(D = (0, 0), A = (-l, 0))]
        #[coordinate(phi = angle(DB), from = horizontal)]
        #[mirror(x = 0)]
        struct FallingPair { m: f64, l: f64, g: f64 }",
    );
    assert_eq!(place(&system, "B"), "l, 0");
    let mirror = system.mirror.unwrap();
    assert_eq!(mirror.points, [2, 1, 0]);
    assert_eq!(mirror.bodies, [(1, true), (0, true)]);
    assert_eq!(mirror.supports, [1, 0]);
}

#[test]
fn images_follow_along_a_chain_of_bars() {
    let system = system(
        "#[gravity(g)]
        #[bar(AB, mass = m2, length = l)] #[bar(BC, mass = m1, length = l)]
        #[bar(CD, mass = m1, length = l)] #[bar(DE, mass = m2, length = l)]
        #[support(A = floor)] #[support(C = floor)] #[support(E = floor)]
        #[figure(C = (0, 0), D = (l / 2, l * sqrt(3) / 2), E = (l, 0))]
        #[equal(angle(AB), angle(CD))]
        #[mirror(x = 0)]
        struct Zigzag { m1: f64, m2: f64, l: f64, g: f64 }",
    );
    let mirror = system.mirror.as_ref().unwrap();
    assert_eq!(mirror.points, [4, 3, 2, 1, 0]);
    assert_eq!(mirror.bodies, [(3, true), (2, true), (1, true), (0, true)]);
    assert_eq!(mirror.supports, [2, 1, 0]);
    assert_eq!(place(&system, "A"), "−l, 0");
}

#[test]
fn bars_on_and_across_a_level_mirror_are_their_own_images() {
    let system = system(
        "#[bar(AB, mass = m, length = 2 * l)] #[bar(CD, mass = m, length = 2 * l)] #[point(G = CD, at = l)]
        #[mass(A, m)] #[mass(B, m)] #[support(A = floor(-l))] #[support(ceiling = slope(pi, (0, l)), under = B)]
        #[bar(GH, mass = m, length = l)]
        #[figure(A = (0, -l), B = (0, l), C = (l, -l), D = (l, l), H = (2 * l, 0))]
        #[mirror(y = 0)]
        struct S { m: f64, l: f64 }",
    );
    let mirror = system.mirror.unwrap();
    assert_eq!(mirror.bodies, [(0, true), (1, true), (2, false)]);
    assert_eq!(mirror.supports, [1, 0]);
}

#[test]
fn coincident_points_are_told_apart_by_their_bars() {
    let system = system(
        "#[gravity(g)] #[bar(AC, mass = m, length = l)] #[bar(CB, mass = m, length = l)] #[bar(CE, mass = m, length = l)]
        #[bar(EF, mass = m, length = l)]
        #[figure(C = (0, 0), E = (0, l), F = (0, 2 * l), A = (0, -l), B = (0, -l))]
        #[mirror(x = 0, swap(A, B))]
        struct S { m: f64, l: f64, g: f64 }",
    );
    assert_eq!(system.mirror.unwrap().bodies, [(1, true), (0, true), (2, false), (3, false)]);
}

#[test]
fn mismatches_are_told_once_naming_both() {
    let heavier = PAIR.replace("DB, mass = m", "DB, mass = 2 * m");
    assert_eq!(
        told(&format!("{heavier} {FIGURE}")),
        ["bars `AD` and `DB` are mirror images but differ in mass"]
    );
    let off_centre = PAIR.replace("DB, mass = m, length = l", "DB, mass = m, length = l, centre = l / 3");
    assert_eq!(
        told(&format!("{off_centre} {FIGURE}")),
        ["bars `AD` and `DB` are mirror images but differ in centre of mass"]
    );
    assert_eq!(
        told(&format!("{PAIR} {FIGURE} #[mass(A, m)]")),
        ["points `A` and `B` are mirror images, but carry different point masses"]
    );
    assert_eq!(
        told(&format!("{PAIR} {FIGURE} #[pin(A = (-l, 0))]")),
        ["points `A` and `B` are mirror images, but `A` is pinned and `B` is not"]
    );
    assert_eq!(
        told(&format!("{PAIR} {FIGURE}").replace("gravity(g)", "gravity(g, g)")),
        ["gravity must pull along the mirror; remove the mirror or this component of gravity"]
    );
}

#[test]
fn centres_reflect_with_their_bars() {
    let mirrored = "#[gravity(g)] #[bar(AD, mass = m, length = l, centre = (l / 3, l / 9))] \
                    #[bar(DB, mass = m, length = l, centre = (2 * l / 3, l / 9))]";
    assert_eq!(told(&format!("{mirrored} {FIGURE}")), [""; 0]);
    let outwards =
        mirrored.replace("DB", "BD").replace("centre = (2 * l / 3, l / 9)", "centre = (l / 3, -l / 9)");
    assert_eq!(told(&format!("{outwards} {FIGURE}")), [""; 0]);
}

#[test]
fn supports_reflect_with_their_free_sides() {
    let floor = format!("{PAIR} {FIGURE} #[support(A = floor)]");
    assert_eq!(told(&floor), ["support `A` has no mirror image; declare one for point `B` too"]);
    assert_eq!(
        told(&format!("{floor} #[support(B = floor(l))]")),
        ["supports `A` and `B` are not mirror images: their places or free sides differ"]
    );
    let walls = format!("{PAIR} {FIGURE} #[support(A = wall(-2 * l))] #[support(B = wall(2 * l))]");
    assert_eq!(told(&walls), [""; 0]);
    assert_eq!(
        told(&walls.replace("wall(2 * l)", "wall(2 * l), facing = right")),
        ["supports `A` and `B` are not mirror images: their places or free sides differ"]
    );
    let slopes = format!(
        "{PAIR} {FIGURE} #[support(A = slope(-pi / 6, (-l, 0)))] #[support(B = slope(pi / 6, (l, 0)))]"
    );
    assert_eq!(told(&slopes), [""; 0]);
    assert_eq!(
        told(&format!("{PAIR} {FIGURE} #[support(D = slope(pi / 6))]")),
        ["support `D` is not symmetric to the mirror"]
    );
}

#[test]
fn figures_without_a_unique_image_are_told() {
    assert_eq!(
        told(&format!("{PAIR} #[figure(D = (0, 0), A = (-l, 0), B = (l, l))] #[mirror(x = 0)]")),
        ["point `A` has no mirror image: no point lies at (l, 0) in the figure"]
    );
    assert_eq!(
        told(&format!(
            "{PAIR} #[bar(DC, mass = m, length = l)] #[figure(D = (0, 0), A = (-l, 0))] #[mirror(x = 0)]"
        )),
        ["the mirror image of point `A` may be `B` or `C`; place `A` in the figure or add `swap(A, B)` here"]
    );
    assert_eq!(
        told(&format!("{PAIR} #[figure(D = (0, 0), A = (-l, 0))] #[mirror(x = 0, swap(A, B), swap(D, A))]")),
        ["`D` or `A` is swapped twice; a point has one mirror image"]
    );
}

#[test]
fn threads_and_circles_have_images() {
    let system = system(
        "#[gravity(g)] #[bar(AD, mass = m, length = l)] #[bar(DB, mass = m, length = l)]
        #[thread(AB, length = l)] #[thread(rope = A -> D, length = 2 * l)] #[thread(line = D -> B, length = 2 * l)]
        #[support(A = circle((-l, -l), l))] #[support(B = circle((l, -l), l))]
        #[figure(D = (0, l), A = (-l / 2, 0), B = (l / 2, 0))] #[mirror(x = 0)]
        struct S { m: f64, l: f64, g: f64 }",
    );
    let names: Vec<&str> = system.supports.iter().map(|s| s.name.as_str()).collect();
    let images = system.mirror.unwrap().supports;
    let images: Vec<(&str, &str)> = images.iter().enumerate().map(|(i, &j)| (names[i], names[j])).collect();
    assert_eq!(images, [("A", "B"), ("B", "A"), ("AB", "AB")]);
}
