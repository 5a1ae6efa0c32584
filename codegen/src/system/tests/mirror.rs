//! Mirror images that are inferred, and mismatches that are told.

use super::{messages, system, write_position};

const PAIR: &str = "#[gravity(g)] #[bar(AD, mass = m, length = l)] #[bar(DB, mass = m, length = l)]";
const FIGURE: &str = "#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))] #[mirror(x = 0)]";
const STRUCT: &str = "struct S { m: f64, l: f64, g: f64 }";

fn find_mistakes(attributes: &str) -> Vec<String> {
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
    assert_eq!(write_position(&system, "B"), "l, 0");
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
    assert_eq!(write_position(&system, "A"), "−l, 0");
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
fn coincident_points_are_distinguished_by_their_bars() {
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
fn mismatches_are_reported_once_naming_both() {
    let heavier = PAIR.replace("DB, mass = m", "DB, mass = 2 * m");
    assert_eq!(
        find_mistakes(&format!("{heavier} {FIGURE}")),
        ["bars `AD` and `DB` are mirror images but differ in mass"]
    );
    let off_centre = PAIR.replace("DB, mass = m, length = l", "DB, mass = m, length = l, centre = l / 3");
    assert_eq!(
        find_mistakes(&format!("{off_centre} {FIGURE}")),
        ["bars `AD` and `DB` are mirror images but differ in centre of mass"]
    );
    assert_eq!(
        find_mistakes(&format!("{PAIR} {FIGURE} #[mass(A, m)]")),
        ["points `A` and `B` are mirror images, but carry different point masses"]
    );
    assert_eq!(
        find_mistakes(&format!("{PAIR} {FIGURE} #[pin(A = (-l, 0))]")),
        ["points `A` and `B` are mirror images, but `A` is pinned and `B` is not"]
    );
    assert_eq!(
        find_mistakes(&format!("{PAIR} {FIGURE}").replace("gravity(g)", "gravity(g, g)")),
        ["gravity must pull along the mirror; remove the mirror or this component of gravity"]
    );
}

#[test]
fn centres_reflect_with_their_bars() {
    let mirrored = "#[gravity(g)] #[bar(AD, mass = m, length = l, centre = (l / 3, l / 9))] \
                    #[bar(DB, mass = m, length = l, centre = (2 * l / 3, l / 9))]";
    assert_eq!(find_mistakes(&format!("{mirrored} {FIGURE}")), [""; 0]);
    let outwards =
        mirrored.replace("DB", "BD").replace("centre = (2 * l / 3, l / 9)", "centre = (l / 3, -l / 9)");
    assert_eq!(find_mistakes(&format!("{outwards} {FIGURE}")), [""; 0]);
}

#[test]
fn supports_reflect_with_their_free_sides() {
    let floor = format!("{PAIR} {FIGURE} #[support(A = floor)]");
    assert_eq!(find_mistakes(&floor), ["support `A` has no mirror image; declare one for point `B` too"]);
    assert_eq!(
        find_mistakes(&format!("{floor} #[support(B = floor(l))]")),
        ["supports `A` and `B` are not mirror images: their places or free sides differ"]
    );
    let walls = format!("{PAIR} {FIGURE} #[support(A = wall(-2 * l))] #[support(B = wall(2 * l))]");
    assert_eq!(find_mistakes(&walls), [""; 0]);
    assert_eq!(
        find_mistakes(&walls.replace("wall(2 * l)", "wall(2 * l), facing = right")),
        ["supports `A` and `B` are not mirror images: their places or free sides differ"]
    );
    let slopes = format!(
        "{PAIR} {FIGURE} #[support(A = slope(-pi / 6, (-l, 0)))] #[support(B = slope(pi / 6, (l, 0)))]"
    );
    assert_eq!(find_mistakes(&slopes), [""; 0]);
    assert_eq!(
        find_mistakes(&format!("{PAIR} {FIGURE} #[support(D = slope(pi / 6))]")),
        ["support `D` is not symmetric to the mirror"]
    );
}

#[test]
fn figures_without_a_unique_image_are_reported() {
    assert_eq!(
        find_mistakes(&format!("{PAIR} #[figure(D = (0, 0), A = (-l, 0), B = (l, l))] #[mirror(x = 0)]")),
        ["point `A` has no mirror image: no point lies at (l, 0) in the figure"]
    );
    assert_eq!(
        find_mistakes(&format!(
            "{PAIR} #[bar(DC, mass = m, length = l)] #[figure(D = (0, 0), A = (-l, 0))] #[mirror(x = 0)]"
        )),
        ["the mirror image of point `A` may be `B` or `C`; place `A` in the figure or add `swap(A, B)` here"]
    );
    assert_eq!(
        find_mistakes(&format!(
            "{PAIR} #[figure(D = (0, 0), A = (-l, 0))] #[mirror(x = 0, swap(A, B), swap(D, A))]"
        )),
        ["`D` or `A` is swapped twice; a point has one mirror image"]
    );
}

const FRAME: &str = "#[gravity(g)] #[bar(AB, mass = m, length = l / sqrt(2))] #[bar(BC, mass = m, length = l / sqrt(2))] \
                     #[bar(CD, mass = m, length = l / sqrt(2))] #[bar(DE, mass = m, length = l / sqrt(2))] #[ground(O = (0, 3 * l))] \
                     #[figure(C = (0, 0), B = (-l / 2, l / 2), A = (-l, 0), D = (l / 2, l / 2), E = (l, 0))] #[mirror(x = 0)]";

#[test]
fn mirrored_parts_are_accepted() {
    let pairs = [
        "#[spring(AB2 = A -> C, stiffness = g)] #[spring(CE, stiffness = g)]",
        "#[spring(AE, stiffness = g, length = l, damping = m)]",
        "#[torsion(AB, BC, stiffness = g, angle = -m)] #[torsion(CD, DE, stiffness = g, angle = -m)]",
        "#[torsion(AB, BC, stiffness = g, angle = -m)] #[torsion(DE, CD, stiffness = g, angle = m)]",
        "#[torsion(BC, CD, damping = m)]",
        "#[torsion(AB, stiffness = g, angle = pi / 4)] #[torsion(DE, stiffness = g, angle = -pi / 4)]",
        "#[weld(AB, BC, angle = m)] #[weld(CD, DE, angle = m)]",
        "#[weld(BC, CD, angle = pi / 2)]",
        "#[weld(AB, angle = m)] #[weld(DE, angle = -m)]",
        "#[force(A = (m, g))] #[force(E = (-m, g))]",
        "#[force(C = (0, t))]",
        "#[force(A = (m, g), frame = AB)] #[force(E = (-m, g), frame = DE)]",
        "#[force(A = (-m * vx(A), -vy(A) * m))] #[force(E = (-m * vx(E), -m * vy(E)))]",
        "#[force(A = (x(A) - x(E), 0))] #[force(E = (2 * x(E), 0))]",
        "#[couple(AB = sin(t))] #[couple(DE = -sin(t))]",
        "#[couple(c = g, on = BC, from = AB)] #[couple(d = g, on = DE, from = CD)]",
        "#[coordinate(p = angle(AB), from = horizontal)] #[coordinate(q = angle(DE), from = horizontal)] \
         #[couple(AB = m * rate(p) + p)] #[couple(DE = -q - m * rate(q))]",
        "#[drive(x(A) = -l - t)] #[drive(x(E) = l + t)]",
        "#[drive(angle(AB) = t)] #[drive(angle(DE) = 2 * pi - t)]",
        "#[drive(y(C) = t)]",
        "#[drive(distance(A, E) = 2 * l + t)]",
        "#[drive(distance(A, C) = l + t)] #[drive(distance(E, C) = l + t)]",
        "#[drive(angle(AB, BC) = t)] #[drive(angle(DE, CD) = -t)]",
        "#[slider(C = vertical(0))]",
        "#[slider(A = circle((-2 * l, 0), l))] #[slider(E = circle((2 * l, 0), l))]",
        "#[slider(C = circle((0, l), l))]",
        "#[slider(A = line(m, (-l, 0)))] #[slider(E = line(pi - m, (l, 0)))]",
        "#[thread(AE, length = 4 * l)] #[thread(OC, length = 4 * l)]",
        "#[thread(AO, length = 4 * l)] #[thread(rope = O -> E, length = 4 * l)]",
        "#[support(A = circle((-l, -l), l))] #[support(E = circle((l, -l), l))]",
        "#[support(A = slot(m, (-l, 0), g), rough)] #[support(E = slot(-m, (l, 0), g), rough)]",
        "#[particle(P, mass = m)] #[particle(Q, mass = m)] #[figure(P = (-3 * l, 0))] #[spring(AP, stiffness = g)] \
         #[spring(EQ, stiffness = g)]",
    ];
    for pair in pairs {
        assert_eq!(find_mistakes(&format!("{FRAME} {pair}")), [""; 0], "{pair}");
    }
}

/// What is told of a symmetric frame with attributes added; nothing where the text is empty.
fn check_all(cases: &[(&str, &str)]) {
    for (attributes, expected) in cases {
        let expected: Vec<&str> = [*expected].into_iter().filter(|text| !text.is_empty()).collect();
        assert_eq!(find_mistakes(&format!("{FRAME} {attributes}")), expected, "{attributes}");
    }
}

#[test]
fn springs_torsions_and_welds_without_their_mirror_image_are_reported() {
    check_all(&[
        ("#[spring(AC, stiffness = g)]", "spring `AC` has no mirror image; declare one for `E` and `C` too"),
        (
            "#[spring(AC, stiffness = g)] #[spring(CE, stiffness = m)]",
            "springs `AC` and `CE` are not mirror images: their values differ",
        ),
        (
            "#[torsion(AB, stiffness = g, angle = pi / 4)] #[torsion(DE, stiffness = g, angle = pi / 4)]",
            "torsions `AB` and `DE` are not mirror images: their values differ",
        ),
        ("#[torsion(BC, CD, stiffness = g, angle = m)]", ""),
        ("#[torsion(BC, stiffness = g)]", "torsion `BC` has no mirror image; declare one for `CD` too"),
        (
            "#[weld(AB, BC, angle = m)]",
            "weld `AB, BC` has no mirror image; declare one for `DE` and `CD` too",
        ),
    ]);
}

#[test]
fn loads_drives_and_threads_without_their_mirror_image_are_reported() {
    check_all(&[
        (
            "#[force(A = (m, g))] #[force(E = (m, g))]",
            "loads `A` and `E` are not mirror images: their values differ",
        ),
        ("#[force(C = (m, 0))]", "load `C` is not symmetric to the mirror"),
        (
            "#[force(A = (m * y(A), 0))] #[force(E = (-m * y(C), 0))]",
            "loads `A` and `E` are not mirror images: their values differ",
        ),
        (
            "#[couple(AB = g)] #[couple(DE = g)]",
            "loads `AB` and `DE` are not mirror images: their values differ",
        ),
        ("#[drive(x(A) = t)]", "drive `x(A)` has no mirror image; declare one for `x(E)` too"),
        (
            "#[drive(x(A) = t)] #[drive(x(E) = t)]",
            "drives `x(A)` and `x(E)` are not mirror images: their values differ",
        ),
        (
            "#[drive(distance(A, C) = l + t)]",
            "drive `distance(A, C)` has no mirror image; declare one for `distance(C, E)` too",
        ),
        (
            "#[drive(distance(A, C) = l + t)] #[drive(distance(C, E) = l + 2 * t)]",
            "drives `distance(A, C)` and `distance(C, E)` are not mirror images: their values differ",
        ),
        (
            "#[drive(angle(AB, BC) = t)]",
            "drive `angle(AB, BC)` has no mirror image; declare one for `angle(DE, CD)` too",
        ),
        (
            "#[slider(A = circle((-2 * l, 0), l))] #[slider(E = circle((3 * l, 0), 2 * l))]",
            "sliders `A` and `E` are not mirror images: their values differ",
        ),
        ("#[slider(C = vertical(l))]", "slider `C` is not symmetric to the mirror"),
        ("#[slider(A = horizontal(0))]", "slider `A` has no mirror image; declare one for point `E` too"),
        ("#[thread(AC, length = l)]", "thread `AC` has no mirror image; declare one for `E -> C` too"),
        (
            "#[thread(AC, length = l)] #[thread(CE, length = g)]",
            "threads `AC` and `CE` are not mirror images: their lengths differ",
        ),
    ]);
}

#[test]
fn supports_without_their_mirror_image_are_reported() {
    check_all(&[
        (
            "#[support(A = circle((-l, -l), l))] #[support(E = circle((l, -l), g))]",
            "supports `A` and `E` are not mirror images: their circles differ",
        ),
        (
            "#[support(A = floor, restitution = 1)] #[support(E = floor)]",
            "`A` and `E` are mirror images but differ in restitution",
        ),
        (
            "#[support(A = floor, rough)] #[support(E = floor)]",
            "`A` and `E` are mirror images but differ in roughness",
        ),
        (
            "#[support(A = floor, law = poisson)] #[support(E = floor)]",
            "`A` and `E` are mirror images but differ in the law of impact",
        ),
        (
            "#[support(A = floor, stop)] #[support(E = floor)]",
            "`A` and `E` are mirror images but differ in whether they stop the run",
        ),
        (
            "#[support(A = floor, friction = 0.2)] #[support(E = floor)]",
            "`A` and `E` are mirror images but differ in friction",
        ),
        (
            "#[support(A = floor, friction = 0.3, static = 0.4)] #[support(E = floor, friction = 0.3)]",
            "`A` and `E` are mirror images but differ in friction",
        ),
        (
            "#[support(A = floor, friction = 0.3 / (1 + v * v))] #[support(E = floor, friction = 0.3 / (1 + v.powi(4)))]",
            "`A` and `E` are mirror images but differ in friction",
        ),
        (
            "#[support(A = floor, friction = 0.3, jams)] #[support(E = floor, friction = 0.3)]",
            "`A` and `E` are mirror images but differ in friction",
        ),
        (
            "#[support(A = floor, friction = 0.3, moving = g * t)] #[support(E = floor, friction = 0.3, moving = g * t)]",
            "in a mirror their surfaces move against each other: `A` and `E` have velocities that are not opposite",
        ),
        ("#[ground(P = (l, l))]", "point `P` has no mirror image: no point lies at (−l, l) in the figure"),
    ]);
}

#[test]
fn friction_and_moving_surfaces_may_be_mirror_images() {
    for (a, e) in [
        ("friction = 0.3, static = 0.4", "friction = 3 / 10, static = 0.2 + 0.2"),
        ("friction = 0.3 / (1 + v * v)", "friction = 0.3 / (1 + v.powi(2))"),
        ("friction = 0.3, moving = g * t", "friction = 0.3, moving = -g * t"),
    ] {
        let supports = format!("#[support(A = floor, {a})] #[support(E = floor, {e})]");
        assert_eq!(find_mistakes(&format!("{FRAME} {supports}")), [""; 0], "{supports}");
    }
}

#[test]
fn bodies_reflect_with_their_frames() {
    let hulls = "#[gravity(g, 0)] #[body(left, points(C = (0, 0), A = (l, 0), B = (0, m)), mass = m)] \
                 #[body(right, points(C = (0, 0), D = (0, -m), E = (l, 0)), mass = m)] \
                 #[figure(C = (0, 0), A = (l, 0))] #[mirror(y = 0, swap(A, E), swap(B, D))]";
    let images = |attributes: &str| system(&format!("{attributes} {STRUCT}")).mirror.unwrap().bodies;
    // The reflection of a frame, or that turned by half a turn.
    assert_eq!(images(hulls), [(1, false), (0, false)]);
    assert_eq!(
        images(&hulls.replace("D = (0, -m), E = (l, 0)", "D = (0, m), E = (-l, 0)")),
        [(1, true), (0, true)]
    );
    assert_eq!(
        find_mistakes(&hulls.replace("E = (l, 0)), mass = m", "E = (l, 0)), mass = m, inertia = m")),
        ["bodies `left` and `right` are mirror images but differ in inertia"]
    );
    let oblique = "have the points of mirror images, but their frames are none: one must be the other's reflection \
                   along or across its first axis";
    assert_eq!(
        find_mistakes(&hulls.replace("D = (0, -m), E = (l, 0)", "D = (m, 0), E = (0, l)")),
        [format!("bodies `left` and `right` {oblique}"), format!("bodies `right` and `left` {oblique}")]
    );
}

#[test]
fn a_symmetric_body_is_its_own_image() {
    let hull = "#[gravity(g)] #[body(hull, points(A = (-l, 0), B = (l, 0), C = (0, m)), mass = m)] \
                #[figure(A = (-l, 0), B = (l, 0))] #[mirror(x = 0)]";
    let system = system(&format!("{hull} {STRUCT}"));
    assert_eq!(system.mirror.unwrap().bodies, [(0, true)]);
    assert_eq!(
        find_mistakes(&hull.replace("mass = m)", "mass = m, centre = (l, 0))")),
        ["body `hull` is its own mirror image, but its centre of mass is not symmetric"]
    );
}
