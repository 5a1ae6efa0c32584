//! Springs, torsion springs, forces, couples, sections, and the expressions of time and motion.

use super::{messages, point, resolve, text};
use crate::system::{Formula, Function, LoadKind, Operator, Reading, System};

const BARS: &str = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = a)] \
                    #[pin(A = (0, 0))] #[coordinate(phi = angle(AB))] #[figure(B = (l, 0), C = (l, a))]";
const STRUCT: &str = "struct S { m: f64, l: f64, g: f64, a: f64 }";

fn bars(attributes: &str) -> System {
    resolve(&format!("{BARS} {attributes}")).unwrap()
}

fn find_mistakes(attributes: &str) -> Vec<String> {
    messages(&format!("{BARS} {attributes} {STRUCT}"))
}

/// The value of a couple.
fn formula(expression: &str) -> (System, Formula) {
    let system = bars(&format!("#[couple(AB = {expression})]"));
    let LoadKind::Couple { value, .. } = system.loads[0].kind.clone() else { panic!() };
    (system, value)
}

#[test]
fn springs_join_points_and_directions() {
    let system = bars(
        "#[ground(O = (0, l))] #[spring(AC, stiffness = 2 * g, length = l)] #[spring(damper = O -> C, damping = m)] \
         #[torsion(AB, BC, stiffness = g, angle = pi / 2)] #[torsion(AB, damping = m)]",
    );
    let [a, c, o] = ["A", "C", "O"].map(|name| point(&system, name));
    let [spring, damper] = &system.springs[..] else { panic!() };
    assert_eq!(
        (spring.name.as_str(), spring.ends, text(&system, spring.length.as_series().unwrap())),
        ("AC", [a, c], "l".into())
    );
    assert!(spring.damping.is_none() && damper.stiffness.is_none() && damper.length.is_zero());
    assert_eq!((damper.name.as_str(), damper.ends), ("damper", [o, c]));
    let [between, ground] = &system.torsions[..] else { panic!() };
    assert_eq!((between.name.as_str(), between.body, between.from), ("AB, BC", 1, Some(0)));
    assert_eq!(text(&system, between.angle.as_series().unwrap()), "½ π");
    assert_eq!((ground.name.as_str(), ground.body, ground.from), ("AB", 0, None));
}

/// Only what parameters determine is a series.
#[test]
fn springs_may_change_with_time() {
    let system = bars(
        "#[spring(AC, stiffness = g * (1 + t), length = l + 0 * t, damping = m)] \
         #[torsion(AB, stiffness = g, angle = a * t)]",
    );
    let [spring, torsion] = [&system.springs[0].stiffness, &system.torsions[0].stiffness];
    assert!(
        spring.as_ref().unwrap().as_series().is_none() && torsion.as_ref().unwrap().as_series().is_some()
    );
    assert!(system.springs[0].damping.as_ref().unwrap().as_series().is_some());
    assert!(system.torsions[0].angle.as_series().is_none());
}

#[test]
fn mistakes_in_springs_are_reported() {
    let cases = [
        (
            "#[spring(AC, length = l)]",
            "spring `AC` resists nothing; add `stiffness = …`, `damping = …` or both (for example `#[spring(AB, stiffness = k, length = l)]`)",
        ),
        (
            "#[spring(AC, stiffness = g, while(\"phi\"))]",
            "a switch compares two sides by `<` or `>`: `while(\"phi > 0\")` (for example `#[spring(AB, stiffness = k, length = l)]`)",
        ),
        ("#[spring(AC, stiffness = -2)]", "the stiffness of `AC` is -2; it cannot be negative"),
        (
            "#[spring(AC, stiffness = g, length = -1)]",
            "the natural length of `AC` is -1; it cannot be negative",
        ),
        (
            "#[spring(AB, stiffness = g)]",
            "spring `AB` has no effect: the distance of `A` and `B` never changes",
        ),
        ("#[spring(AX, stiffness = g)]", "there is no point `X`; declared: `A`, `B`, `C`"),
        (
            "#[spring(AC, stiffness = g)] #[spring(AC, damping = g)]",
            "spring `AC` is declared twice; rename or remove one",
        ),
        (
            "#[spring(s = A -> B -> C, stiffness = g)]",
            "spring `s` joins two points, no more (for example `#[spring(AB, stiffness = k, length = l)]`)",
        ),
        (
            "#[spring(AC, stiffness = g, length = y(C))]",
            "what a spring is may change with time: it may contain `t` and parameters, no motion; what follows the motion is a \
             `force` or a `couple`",
        ),
        (
            "#[spring(AC, stiffness = g + q)]",
            "there is no parameter or coordinate `q`; declared: `m`, `l`, `g`, `a`, `phi`",
        ),
        ("#[torsion(AB, damping = -1)]", "the damping of `AB` is -1; it cannot be negative"),
        ("#[torsion(AB, AB, damping = 1)]", "`AB` cannot be turned against itself"),
        (
            "#[torsion(AB, damping = 1)] #[torsion(AB, stiffness = 1)]",
            "torsion `AB` is declared twice; remove one",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(find_mistakes(attributes), [expected], "{attributes}");
    }
}

#[test]
fn forces_and_couples_have_points_and_bars() {
    let system = bars(
        "#[force(C = (m, 0))] #[force(drag = (-a * vx(C), sin(t)), at = C, frame = BC)] #[couple(AB = m)] \
         #[couple(motor = g * rate(phi), on = BC, from = AB)]",
    );
    let c = point(&system, "C");
    let names: Vec<&str> = system.loads.iter().map(|load| load.name.as_str()).collect();
    assert_eq!(names, ["C", "drag", "AB", "motor"]);
    assert!(matches!(system.loads[0].kind, LoadKind::Force { point, frame: None, .. } if point == c));
    assert!(matches!(system.loads[1].kind, LoadKind::Force { point, frame: Some(1), .. } if point == c));
    assert!(matches!(system.loads[2].kind, LoadKind::Couple { body: 0, from: None, .. }));
    assert!(matches!(system.loads[3].kind, LoadKind::Couple { body: 1, from: Some(0), .. }));
}

#[test]
fn what_parameters_determine_is_one_series() {
    let (system, value) = formula("(l + a) * (l - a) / l.powi(2) + tan(pi / 4) * sqrt(4)");
    let Formula::Constant(series) = &value else { panic!("{value:?}") };
    let [l, a] = [0.7_f64, 0.4];
    let number = system.parameter_value(series, &[1.3, l, 9.81, a]);
    assert!((number - ((l + a) * (l - a) / (l * l) + 2.0)).abs() < 1e-14, "{number}");
}

#[test]
fn motion_is_read_by_name() {
    let (system, value) = formula("-(2 * l) * rate(phi).powi(2) + x(C) / (1 + cos(t)) - phi");
    let c = point(&system, "C");
    let motion = |reading, rate| Box::new(Formula::Motion { reading, rate });
    let constant = |n: i64| Box::new(Formula::Constant(crate::algebra::Series::integer(n)));
    let Formula::Join(Operator::Subtract, sum, phi) = value else { panic!() };
    assert_eq!(phi, motion(Reading::Coordinate(0), false));
    let Formula::Join(Operator::Add, drag, ratio) = *sum else { panic!() };
    let squared = Formula::Apply(Function::Power(2), motion(Reading::Coordinate(0), true));
    let Formula::Join(Operator::Multiply, factor, rate) = *drag else { panic!() };
    assert_eq!(*rate, squared);
    assert!(matches!(&*factor, Formula::Constant(series) if text(&system, series) == "−2 l"));
    let cosine = Box::new(Formula::Apply(Function::Cos, Box::new(Formula::Time)));
    let divisor = Box::new(Formula::Join(Operator::Add, constant(1), cosine));
    let expected = Formula::Join(Operator::Divide, motion(Reading::Position(c, 0), false), divisor);
    assert_eq!(*ratio, expected);
}

#[test]
fn a_magnitude_is_the_root_of_a_square() {
    assert_eq!(formula("abs(rate(phi))").1, formula("sqrt(rate(phi).powi(2))").1);
    assert_eq!(formula("(x(C) - l).abs()").1, formula("sqrt((x(C) - l).powi(2))").1);
}

#[test]
fn the_least_and_the_greatest_are_halves_of_sums() {
    let [least, most] = ["min(t, phi)", "max(t, phi)"].map(|text| formula(text).1);
    assert_eq!(least, formula("1 / 2 * (t + phi - abs(t - phi))").1);
    assert_eq!(most, formula("1 / 2 * (t + phi + abs(t - phi))").1);
    assert_eq!(formula("clamp(t, 0, phi)").1, formula("max(0, min(t, phi))").1);
}

/// A choice is two loads with complementary switches; equal conditions have one switch.
#[test]
fn a_choice_is_made_by_a_switch() {
    let (system, value) = formula("if(x(C) * 2 > a && rate(phi) < 0, m * a, t)");
    let [switch] = &system.switches[..] else { panic!("{:?}", system.switches) };
    assert_eq!(switch.condition, "(x(C) * 2) > a and phi' < 0");
    let switch = Box::new(Formula::Switch(0));
    let Formula::Join(Operator::Add, chosen, other) = value else { panic!("{value:?}") };
    assert!(matches!(*chosen, Formula::Join(Operator::Multiply, s, _) if s == switch));
    let Formula::Join(Operator::Multiply, rest, time) = *other else { panic!("{other:?}") };
    assert!(matches!(*rest, Formula::Join(Operator::Subtract, _, s) if s == switch));
    assert_eq!(*time, Formula::Time);
    let system = bars(
        "#[couple(AB = if(t > 1, m, 0) + if(t > 1, t, a))] #[force(C = (sign(phi), 0), while(\"phi > 0\"))]",
    );
    let conditions: Vec<&str> = system.switches.iter().map(|switch| switch.condition.as_str()).collect();
    let labels: Vec<&str> = system.switches.iter().map(|switch| switch.label.as_str()).collect();
    assert_eq!(conditions, ["phi > 0", "phi < 0", "t > 1"]);
    assert_eq!(labels, ["sign(phi > 0), force C", "sign(phi < 0)", "if(t > 1)"]);
}

#[test]
fn mistakes_in_loads_are_reported() {
    let forms = "expected a number, a parameter, `t`, a coordinate, `rate(phi)`, `x(P)`, `y(P)`, `vx(P)`, `vy(P)`, \
                 + − * /, `sqrt(…)`, `sin(…)`, `cos(…)`, `tan(…)`, `exp(…)`, `log(…)`, `tanh(…)`, \
                 `atan(…)`, `atan2(y, x)`, `abs(…)`, `sign(…)`, `min(a, b)`, `max(a, b)`, `clamp(x, low, high)`, \
                 `if(a > b, x, y)`, \
                 `table(x, [x0, x1], [y0, y1])` or `.powi(n)`";
    let jumps = "`if`, `sign` and `atan2` jump, which";
    let prescribed = format!("{jumps} what is prescribed must not; give a drive a condition, `while(\"…\")`");
    let friction = format!("{jumps} a coefficient of friction must not; `tanh(v / w)` is steep and smooth");
    let begins = "`if` begins with a condition: `if(phi > 0, a, b)`";
    let cases = [
        ("#[force(X = (m, 0))]", "there is no point `X`; declared: `A`, `B`, `C`"),
        (
            "#[force(C = (m, 0), while(\"phi\"))]",
            "a switch compares two sides by `<` or `>`: `while(\"phi > 0\")` (for example `#[force(P = (fx, fy))]`)",
        ),
        (
            "#[particle(D, mass = m, while(\"phi > 0\"))]",
            "`while` is for what can be there or not: supports, threads, the `stops` of a slider, springs, torsions, forces, couples, \
             drives, pins to the ground and welds (for example `#[particle(P, mass = m)]`)",
        ),
        ("#[force(C = m)]", "expected a position `(x, y)` (for example `#[force(P = (fx, fy))]`)"),
        ("#[force(C = (phj, 0))]", "there is no parameter or coordinate `phj`; did you mean `phi`?"),
        ("#[couple(AB = rate(psi))]", "there is no coordinate `psi`; did you mean `phi`?"),
        ("#[couple(AB = rate(2 * phi))]", "expected one name: `rate(phi)`"),
        ("#[couple(AB = sinn(t))]", "there is no function `sinn`; did you mean `sin`?"),
        ("#[couple(AB = t.tann())]", "there is no function `tann`; did you mean `tan`?"),
        ("#[couple(AB = mim(t, 1))]", "there is no function `mim`; did you mean `min`?"),
        ("#[couple(AB = cosine(t))]", forms),
        ("#[couple(AB = t ^ 2)]", "a power is written `l.powi(2)`"),
        ("#[couple(AB = t ** 2)]", "a power is written `l.powi(2)`"),
        ("#[couple(AB = t % 2)]", forms),
        ("#[couple(AB = exp(t, 2))]", forms),
        ("#[couple(AB = min(t))]", "`min` takes 2 arguments"),
        ("#[couple(AB = clamp(t, 1))]", "`clamp` takes 3 arguments"),
        ("#[couple(AB = if(t > 1, m))]", "`if` takes 3 arguments"),
        ("#[couple(AB = if(t, m, a))]", begins),
        ("#[couple(AB = if(t + 1, m, a))]", begins),
        ("#[couple(AB = if(l > a, m, a))]", "a condition depends on time or motion"),
        ("#[couple(AB = sign(l))]", "a condition depends on time or motion"),
        ("#[couple(AB = if(sign(t) > phi, m, a))]", "what a condition compares must not jump"),
        ("#[couple(AB = atan2(l, a))]", "`atan2` of what does not vary; write `atan(y / x)`"),
        ("#[couple(AB = atan2(t))]", "`atan2` takes 2 arguments"),
        ("#[drive(phi = if(t > 1, a, l))]", &prescribed),
        ("#[support(B = floor, friction = if(v > 1, a, l))]", &friction),
        ("#[couple(AB = table(t, [0, 1]))]", "`table` takes 3 arguments"),
        ("#[couple(AB = table(t, m, [0, 1]))]", "a list of numbers: `table(x, [0, 1, 2], [3, 5, 4])`"),
        ("#[couple(AB = table(t, [0, 1, 2], [0, 1]))]", "a table has as many values as places; 2 and 3"),
        ("#[couple(AB = table(t, [0], [1]))]", "a table has from 2 to 512 values"),
        ("#[couple(AB = table(t, [0, 2, 1], [0, 1, 2]))]", "the places of a table rise; 1 follows 2"),
        (
            "#[couple(AB = table(t, [0, 1], [0, m]))]",
            "a table has numbers; write a parameter as a factor beside it",
        ),
        ("#[couple(AB = if(table(t, [0, 1], [0, 1]) > t, m, a))]", "a condition compares no table"),
        (
            "#[drive(phi = table(t, [0, 1], [0, 1]))]",
            "a table is for loads: beyond its ends it is constant, where a drive would have a kink",
        ),
        ("#[couple(AB = t / (l - l))]", "division by zero"),
        ("#[couple(AB = sqrt(-1) * t)]", "the root of a negative number"),
        ("#[couple(AB = t.powi(a))]", "expected a whole number between −64 and 64"),
        ("#[couple(c = 1, on = AB, from = AB)]", "couple `c` acts on `AB` from itself"),
        ("#[force(C = (1, 0))] #[force(C = (0, 1))]", "force `C` is declared twice; rename or remove one"),
        (
            "#[force(c = (1, 0), at = C)] #[couple(c = 1, on = AB)]",
            "couple `c` has the name of a force; rename one",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(find_mistakes(attributes), [expected], "{attributes}");
    }
}

#[test]
fn sections_cut_uniform_bars() {
    let system = bars("#[section(S = AB, at = l / 3)]");
    let section = &system.sections[0];
    assert_eq!((section.body, text(&system, &section.at)), (0, "⅓ l".into()));
    let cases = [
        ("#[section(S = AB, at = 1.5 * l)]", "section `S` lies outside bar `AB`"),
        ("#[section(S = AB, at = -1)]", "section `S` lies outside bar `AB`"),
        (
            "#[section(S = AB, at = l / 2)] #[section(S = BC, at = a / 2)]",
            "section `S` is declared twice; rename or remove one",
        ),
        (
            "#[bar(CD, mass = m, length = l, inertia = m)] #[section(S = CD, at = a)]",
            "a section needs a uniform bar; how the mass of `CD` is spread is not known from its inertia and centre",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(find_mistakes(attributes), [expected], "{attributes}");
    }
}

#[test]
fn the_most_sets_can_be_given() {
    assert_eq!(bars("#[liftoff(crate = other::name, sets = 16)]").sets, 16);
    assert_eq!(bars("#[liftoff(sets = 0)]").sets, 0);
    assert_eq!(bars("").sets, crate::limits::CLOSED_FORMS);
    let wrong = " (for example `#[liftoff(crate = path, sets = 16)]`)";
    assert_eq!(
        find_mistakes("#[liftoff(sets = 5000)]"),
        [format!("`sets` must be a whole number from 0 to 4096{wrong}")]
    );
    let expected = "expected `crate = path`, `sets = 16`, `names = false` or `dimensionless`";
    assert_eq!(find_mistakes("#[liftoff(limit = 2)]"), [format!("{expected}{wrong}")]);
}

/// `sin t m` could be the sine of `t m`.
#[test]
fn a_factor_after_a_sine_is_not_its_argument() {
    let text = |couple: &str| {
        let item = format!(
            "#[liftoff(dimensionless)] #[bar(AB, mass = m, length = l)] #[pin(A = (0, 0))] #[figure(A = (0, 0), B = (l, 0))]
             #[coordinate(phi = angle(AB))] #[couple(AB = {couple})] struct S {{ m: f64, l: f64 }}"
        );
        crate::equations(item.parse().unwrap()).unwrap().to_string()
    };
    let cases = [
        ("sin(t) * m", "(sin t) m"),
        ("sin(t) * cos(t) * m", "(sin t) cos t) m"),
        ("m * sin(t)", "m sin t"),
        ("sin(t + 1) * m", "sin(t + 1) m"),
        ("sin(phi) * t / m", "(sin φ) t"),
        ("cos(t) / m", "(cos t)/m"),
    ];
    for (couple, expected) in cases {
        let text = text(couple);
        assert!(text.contains(expected), "{couple}: {text}");
    }
}
