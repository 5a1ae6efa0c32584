//! Welds, sliders, drives, circles, slots and threads.

use super::{messages, point, resolve, text};
use crate::algebra::Angle;
use crate::system::{Driven, Formula, Guide, Law, OneSided, Reading, System};

const BARS: &str = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = a)] \
                    #[pin(A = (0, 0))] #[figure(B = (l, 0), C = (l, a))]";
const STRUCT: &str = "struct S { m: f64, l: f64, g: f64, a: f64 }";

fn bars(attributes: &str) -> System {
    resolve(&format!("{BARS} {attributes}")).unwrap()
}

fn find_mistakes(attributes: &str) -> Vec<String> {
    messages(&format!("{BARS} {attributes} {STRUCT}"))
}

#[test]
fn welds_keep_the_figures_angle_or_the_one_given() {
    let weld = |attributes: &str| {
        let weld = bars(attributes).welds.remove(0);
        (weld.body, weld.to, weld.angle)
    };
    assert_eq!(weld("#[weld(AB, BC)]"), (1, Some(0), Angle::quarters(1)));
    assert_eq!(weld("#[weld(BC, AB)]"), (0, Some(1), Angle::quarters(3)));
    assert_eq!(weld("#[weld(AB, BC, angle = -pi / 2)]"), (1, Some(0), Angle::quarters(3)));
    assert_eq!(weld("#[weld(BC, angle = pi)]"), (1, None, Angle::quarters(2)));
    let oblique = bars("#[weld(AB, BC, angle = a)]").welds.remove(0);
    assert_eq!(oblique.angle.terms().len(), 1);
}

#[test]
fn mistakes_in_welds_are_reported() {
    let unclear = "the figure shows no multiple of a quarter turn between these bars for all parameters; give the \
                   angle from the first to the second: `angle = …`";
    let slanted = BARS.replace("C = (l, a)", "C = (2 * l, a)");
    assert_eq!(messages(&format!("{slanted} #[weld(AB, BC)] {STRUCT}")), [unclear]);
    // Upright with every parameter 1 only.
    let by_chance = BARS.replace("C = (l, a)", "C = (m, a)");
    assert_eq!(messages(&format!("{by_chance} #[weld(AB, BC)] {STRUCT}")), [unclear]);
    assert_eq!(
        find_mistakes("#[bar(CD, mass = m, length = l)] #[weld(AB, CD, angle = 0)]"),
        ["`AB` and `CD` share no point at which they are welded"]
    );
    assert_eq!(find_mistakes("#[weld(AB, AB)]"), ["`AB` is welded to itself"]);
    assert_eq!(find_mistakes("#[weld(AB, BC)] #[weld(BC, AB)]"), ["this weld is declared twice; remove one"]);
    assert_eq!(
        find_mistakes("#[weld(AB)]"),
        [
            "what is `AB` welded to? Name another bar, or the direction it keeps: `AB, angle = a` (for example `#[weld(AB, BC)]`)"
        ]
    );
    assert_eq!(find_mistakes("#[weld(AB, BD)]"), ["there is no bar `BD`; did you mean `BC`?"]);
}

#[test]
fn points_slide_along_lines_and_bars() {
    let system = bars(
        "#[ground(O = (0, l))] #[slider(C = horizontal(a))] #[slider(s = vertical(l), of = C)] \
         #[slider(O = bar(AB))] #[slider(B = line(pi / 2, (l, 0)))]",
    );
    let guides: Vec<_> = system.sliders.iter().map(|s| (s.name.as_str(), s.point, &s.guide)).collect();
    let c = point(&system, "C");
    let Guide::Line { through, direction } = guides[0].2 else { panic!() };
    assert_eq!((guides[0].0, guides[0].1, direction.quarter_turns()), ("C", c, 0));
    assert_eq!(through.each_ref().map(|x| text(&system, x)), ["0", "a"]);
    let Guide::Line { through, direction } = guides[1].2 else { panic!() };
    assert_eq!((guides[1].0, guides[1].1, direction.quarter_turns()), ("s", c, 1));
    assert_eq!(through.each_ref().map(|x| text(&system, x)), ["l", "0"]);
    assert!(guides[2].1 == point(&system, "O") && matches!(guides[2].2, Guide::Axis(0)));
}

/// Each end is a support of its own.
#[test]
fn the_ends_of_a_bar_stop_what_slides_along_it() {
    let system = bars(
        "#[particle(P, mass = m)] #[figure(P = (l, l))] #[slider(s = bar(BC), of = P, stops, restitution = 1/2, stop)]",
    );
    let p = point(&system, "P");
    let ends: Vec<_> = system
        .supports
        .iter()
        .map(|support| match &support.contact {
            OneSided::Stop { point, body: 1, is_last } if *point == p => (support.name.as_str(), *is_last),
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(ends, [("s_B", false), ("s_C", true)]);
    assert!(system.supports.iter().all(|s| s.stop && text(&system, s.restitution.as_ref().unwrap()) == "½"));
    let pair = "#[bar(AD, mass = m, length = l)] #[bar(DB, mass = m, length = l)] #[particle(P, mass = g)] #[particle(Q, mass = g)] \
                #[figure(D = (0, 0), A = (-l, 0), B = (l, 0), P = (-l / 2, 0), Q = (l / 2, 0))] #[mirror(x = 0)]";
    let images = |attributes: &str| {
        resolve(&format!("{pair} {attributes} #[mass(D, a)]")).map(|system| system.mirror.unwrap().supports)
    };
    let first = "#[slider(P = bar(AD), stops)]";
    assert_eq!(images(&format!("{first} #[slider(Q = bar(DB), stops)]")).unwrap(), [3, 2, 1, 0]);
    let told = images(&format!("{first} #[slider(Q = bar(DB))]")).unwrap_err().into_iter().next().unwrap();
    assert_eq!(told.to_string(), "support `P_A` has no mirror image; declare one for point `Q` too");
}

#[test]
fn mistakes_in_sliders_are_reported() {
    let cases = [
        ("#[slider(B = circle((0, 0), 0))]", "the radius of `B` is 0; it must be positive"),
        (
            "#[slider(B = circle(0, 0, l))]",
            "write `circle((x, y), radius)` (for example `#[slider(P = horizontal(0))]`)",
        ),
        (
            "#[slider(B = vertical(l), stops)]",
            "only a bar has ends that stop; a support stops a point on a line of the ground (for example `#[slider(P = horizontal(0))]`)",
        ),
        (
            "#[ground(O = (0, l))] #[slider(O = bar(BC), restitution = 1)]",
            "`restitution`, `law` and `stop` apply to the ends of the bar; add `stops` (for example `#[slider(P = horizontal(0))]`)",
        ),
        (
            "#[ground(O = (0, l))] #[slider(O = bar(BC), slide_off)]",
            "a slider stays on the line of its bar beyond the ends; a point that is to leave a bar at its end lies on one side of \
             it, `support(O = bar(BC))`, or is stopped there: `stops` (for example `#[slider(P = horizontal(0))]`)",
        ),
        (
            "#[ground(O = (0, l))] #[slider(O = bar(BC), while(\"t < 1\"))]",
            "a slider is always there, its `stops` may come and go; a point that is to leave a bar lies on one side of it: \
             `support(O = bar(BC), while(\"…\"))` (for example `#[slider(P = horizontal(0))]`)",
        ),
        (
            "#[ground(O = (0, l))] #[support(O_B = bar(AB), under = C)] #[slider(O = bar(BC), stops)]",
            "support `O_B` is declared twice; rename the slider or the support",
        ),
        ("#[slider(B = bar(AB))]", "`B` is a point of `AB`; it cannot slide along it"),
        (
            "#[slider(B = vertical(l))] #[slider(B = horizontal(0))]",
            "slider `B` is declared twice; rename or remove one",
        ),
        ("#[ground(O = (0, l))] #[slider(O = horizontal(l))]", "`O` is a fixed point; name one that moves"),
        (
            "#[slider(B = horizontl(0))]",
            "there is no guide of the kind `horizontl`; did you mean `horizontal`? (for example `#[slider(P = horizontal(0))]`)",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(find_mistakes(attributes), [expected]);
    }
}

#[test]
fn drives_follow_time() {
    let system = bars(
        "#[coordinate(phi = angle(AB))] #[drive(phi = a * t)] #[drive(angle(BC) = sin(2 * t))] #[drive(y(C) = a)]",
    );
    let names: Vec<_> = system.drives.iter().map(|d| (d.name.as_str(), d.driven.clone())).collect();
    let c = point(&system, "C");
    let expected = [
        ("phi", Driven::Reading(Reading::Coordinate(0))),
        ("angle(BC)", Driven::Reading(Reading::Direction(1))),
        ("y(C)", Driven::Reading(Reading::Position(c, 1))),
    ];
    assert_eq!(names, expected);
    assert!(matches!(system.drives[2].value, Formula::Constant(_)));
    let cases = [
        (
            "#[drive(phi = y(C))]",
            "a drive prescribes motion as a function of time: its value may contain `t` and parameters, no motion",
        ),
        ("#[drive(AB = t)]", "`AB` is a bar; write `angle(AB)` for its direction"),
        ("#[drive(phii = t)]", "there is no coordinate `phii`; did you mean `phi`?"),
        ("#[drive(phi = t)] #[drive(phi = 2 * t)]", "`phi` is driven twice; remove one drive"),
        (
            "#[drive(z(C) = t)]",
            "what is driven or bounded is a coordinate, `angle(BAR)`, `angle(BAR, BAR)`, `x(POINT)`, `y(POINT)`, `distance(POINT, POINT)` or `along(POINT, BAR)` (for example `#[drive(phi = omega * t)]`)",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(find_mistakes(&format!("#[coordinate(phi = angle(AB))] {attributes}")), [expected]);
    }
}

#[test]
fn circles_and_slots_keep_points_on_their_sides() {
    let system = bars(
        "#[support(C = circle((l, -a), a / 2), rough, restitution = 1/2, law = poisson)] \
         #[support(B = bowl((0, 0), 2 * l), stop)] #[support(S = slot(pi / 2, (l, 0), a), under = C)]",
    );
    let OneSided::Circle { radius, inside: false, .. } = &system.supports[0].contact else { panic!() };
    assert_eq!(text(&system, radius), "½ a");
    let first = &system.supports[0];
    assert_eq!((first.rough, first.law, first.stop), (true, Law::Poisson, false));
    assert_eq!(text(&system, first.restitution.as_ref().unwrap()), "½");
    assert!(matches!(system.supports[1].contact, OneSided::Circle { inside: true, .. }));
    assert_eq!(
        (system.supports[1].rough, system.supports[1].law, system.supports[1].stop),
        (false, Law::Newton, true)
    );
    let names: Vec<&str> = system.supports[2..].iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["S_lower", "S_upper"]);
    let lines: Vec<_> = system.supports[2..]
        .iter()
        .map(|support| match &support.contact {
            OneSided::Line { through, direction, .. } => {
                (direction.quarter_turns(), through.each_ref().map(|x| text(&system, x)))
            }
            _ => panic!(),
        })
        .collect();
    // Up the y axis the left is −x: the lower line lies to the right of the middle, free towards
    // the left.
    assert_eq!(lines, [(1, ["½ (2 l + a)".into(), "0".into()]), (3, ["½ (2 l − a)".into(), "0".into()])]);
}

#[test]
fn mistakes_in_supports_are_reported() {
    let far = BARS.replace("B = (l, 0)", "B = (3, 4)");
    let told_far = |attributes: &str| messages(&format!("{far} {attributes} {STRUCT}"));
    assert_eq!(
        told_far("#[support(B = circle((0, 0), 6))]"),
        ["the figure's point is 5 from the centre of this circle; it must be at least 6"]
    );
    assert_eq!(
        told_far("#[support(B = bowl((0, 0), 4))]"),
        ["the figure's point is 5 from the centre of this circle; it must be at most 4"]
    );
    assert_eq!(told_far("#[support(B = bowl((0, 0), 5))]"), [""; 0]);
    let cases = [
        ("#[support(B = circle((0, 0), 1 - 2))]", "the radius of `B` is -1; it must be positive"),
        ("#[support(B = slot(0, (0, 0), 0))]", "the width of `B` is 0; it must be positive"),
        (
            "#[support(B = floor, restitution = 1.5)]",
            "the restitution of `B` is 3/2; it must lie between 0 and 1",
        ),
        (
            "#[support(B = floor, rough = 1)]",
            "`rough` has no value; write `rough` alone (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(B = floor, law = euler)]",
            "the law of impact is `newton` (velocities), `moreau` (velocities, with friction at the end alone), `poisson` (impulses) or `stronge` (energies) (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(B = floor, while(phi > 0))]",
            "write the condition in quotes: `while(\"phi > 0\")` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(B = floor, while(\"phi = 0\"))]",
            "a switch compares two sides by `<` or `>`: `while(\"phi > 0\")` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(B = circle(0, 0, 1))]",
            "write `circle((x, y), radius)` or `circle(POINT, radius)` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(B = circle((0, 0), 1), facing = left)]",
            "only a wall, a bar or an edge has `facing` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(B = slot(0, (0, 0), 1))] #[support(B_lower = floor, under = B)]",
            "support `B_lower` is declared twice; give one another name: `other = …, under = B_lower`",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(find_mistakes(attributes), [expected], "{attributes}");
    }
}

#[test]
fn threads_follow_supports() {
    let system = bars(
        "#[ground(O = (0, l))] #[thread(rope = B -> O -> A -> C, length = 3 * l, restitution = 0)] \
         #[support(C = floor)] #[thread(AC, length = l, stop)]",
    );
    let names: Vec<&str> = system.supports.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["C", "rope", "AC"]);
    let OneSided::Thread { path, length } = &system.supports[1].contact else { panic!() };
    assert_eq!(path, &["B", "O", "A", "C"].map(|name| point(&system, name)));
    assert_eq!(text(&system, length), "3 l");
    assert!(system.supports[2].stop && system.supports[1].restitution.is_some());
}

#[test]
fn mistakes_in_limits_are_reported() {
    let cases = [
        (
            "#[limit(angle(AB, BC), restitution = 0)]",
            "a limit has a bound: `low = …`, `high = …` or both (for example `#[limit(angle(AB, BC), low = 0, high = pi / 2)]`)",
        ),
        (
            "#[limit(angle(AB, BC), low = 1, high = 0.5)]",
            "limit `AB_BC` leaves no motion: its bounds are 1 and 0.5",
        ),
        ("#[limit(distance(A, C), low = -1)]", "the limit of `A_C` is -1; it must be positive"),
        (
            "#[limit(distance(A, B), high = l)]",
            "limit `distance(A, B)` has no effect: the distance of `A` and `B` never changes",
        ),
        ("#[limit(stop = phi, low = 0)]", "there is no coordinate `phi`; no coordinate is declared"),
        (
            "#[limit(x(C), low = -l)] #[limit(x_C = y(C), low = -l)]",
            "limit `x_C_low` is declared twice; give one another name: `other = …`",
        ),
        (
            "#[coordinate(x_C_low = y(C))] #[limit(x(C), low = -l)]",
            "limit `x_C_low` has the name of a coordinate; rename one",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(find_mistakes(attributes), [expected], "{attributes}");
    }
}

#[test]
fn mistakes_in_threads_are_reported() {
    let cases = [
        ("#[thread(AC, length = 0)]", "the length of `AC` is 0; it must be positive"),
        (
            "#[thread(r = A -> B -> C, length = l)]",
            "thread `r` has no effect: none of its parts ever changes its length",
        ),
        ("#[thread(r = C -> C, length = l)]", "thread `r` must join different points"),
        (
            "#[thread(r = A -> B, length = l)]",
            "thread `r` has no effect: the distance of `A` and `B` never changes",
        ),
        ("#[thread(r = A -> X, length = l)]", "there is no point `X`; declared: `A`, `B`, `C`"),
        (
            "#[thread(rope, length = l)]",
            "thread `rope` needs its ends: `rope = A -> D`; two letters alone name both ends (for example `#[thread(AB, length = s)]`)",
        ),
        (
            "#[thread(AC, length = l)] #[thread(AC, length = m)]",
            "thread `AC` is declared twice; give one another name: `other = A -> …`",
        ),
        (
            "#[support(AC = floor, under = C)] #[thread(AC, length = m)]",
            "thread `AC` is declared twice; give one another name: `other = A -> …`",
        ),
        (
            "#[coordinate(AC = x(C))] #[thread(AC, length = m)]",
            "thread `AC` has the name of a coordinate; rename one",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(find_mistakes(attributes), [expected], "{attributes}");
    }
    let far = BARS.replace("C = (l, a)", "C = (3, 4)");
    let told_far = |length: &str| messages(&format!("{far} #[thread(AC, length = {length})] {STRUCT}"));
    assert_eq!(told_far("4"), ["thread `AC` is 4 long, but its points are 5 apart in the figure"]);
    assert_eq!(told_far("5"), [""; 0]);
    assert_eq!(told_far("l"), [""; 0]);
}
