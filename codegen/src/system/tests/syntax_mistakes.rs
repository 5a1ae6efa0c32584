//! Malformed attributes and items: what was expected, and an example.

use super::messages;

fn find_mistakes(attribute: &str) -> Vec<String> {
    let rest = "#[gravity(g)] #[bar(AD, mass = m, length = l)] #[pin(A = (0, 0))] struct S { m: f64, l: f64, g: f64 }";
    messages(&format!("{attribute} {rest}"))
}

#[test]
fn errors_show_an_example() {
    let cases = [
        ("#[bar(DC mass = m)]", "expected `,` (for example `#[bar(AD, mass = m, length = l)]`)"),
        ("#[bar(DC, mass = 2 length = l)]", "expected `,` (for example `#[bar(AD, mass = m, length = l)]`)"),
        (
            "#[limit(phi, low = 1 stop)]",
            "expected `,` (for example `#[limit(angle(AB, BC), low = 0, high = pi / 2)]`)",
        ),
        (
            "#[limit(phi, low = -10 deg)]",
            "numbers of a declaration have no unit, an angle of 10° is `10 * pi / 180`; a parameter may have one, \
             `#[value(1, unit = \"kg\")]` (for example `#[limit(angle(AB, BC), low = 0, high = pi / 2)]`)",
        ),
        (
            "#[bar(DC, mas = m, length = l)]",
            "there is no option `mas`; did you mean `mass`? (for example `#[bar(AD, mass = m, length = l)]`)",
        ),
        (
            "#[bar(DC, length = l)]",
            "`DC` has no mass; add `mass = …` (for example `#[bar(AD, mass = m, length = l)]`)",
        ),
        (
            "#[bar(shin, mass = m, length = l)]",
            "bar `shin` needs its ends: `shin = A -> D`; two letters alone name both ends (for example `#[bar(AD, mass = m, length = l)]`)",
        ),
        ("#[pin]", "expected arguments in parentheses (for example `#[pin(O = (0, 0))]`)"),
        ("#[pin(D = 0)]", "expected a position `(x, y)` (for example `#[pin(O = (0, 0))]`)"),
        (
            "#[support(D = flor)]",
            "there is no support of the kind `flor`; did you mean `floor`? (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(P = corner(0, 0))]",
            "a corner is either `under = BAR` or `over = BAR` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(D = floor, mu = m)]",
            "there is no option `mu`: Coulomb friction is `friction = mu`, with `static = mu_s` where that differs; a contact that never slips has the flag `rough` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(D = floor, static = m)]",
            "`static` is the coefficient at rest; add the sliding coefficient: `friction = mu` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(D = floor, rough, friction = m)]",
            "a rough contact never slips, whatever its friction; remove `rough` or `friction` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(D = circle((0, 0), m), moving = m, friction = m)]",
            "only a straight surface can be `moving` along itself: `floor`, `wall`, `slope`, `slot`, `bar`, `edge` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[support(D = floor, moving = m)]",
            "a surface that moves along itself acts by friction only; add `friction = mu` or `rough` (for example `#[support(A = floor)]`)",
        ),
        (
            "#[thread(AD, length = m, friction = m)]",
            "friction acts at supports, in sliders and in hinges; there is none here (for example `#[thread(AB, length = s)]`)",
        ),
        (
            "#[drive(angle(AD) = t, friction = m)]",
            "friction acts at supports, in sliders and in hinges; there is none here (for example `#[drive(phi = omega * t)]`)",
        ),
        (
            "#[pin(D = (0, 0), friction = m)]",
            "declare the friction of a pin by a separate attribute: `#[pin(D, friction = mu, radius = r)]` (for example `#[pin(O = (0, 0))]`)",
        ),
        (
            "#[mass(D, m, while(\"t < 1\"))]",
            "`while` is for what can be there or not: supports, threads, the `stops` of a slider, springs, torsions, forces, couples, drives, pins to the ground and welds (for example `#[mass(A, m)]`)",
        ),
        (
            "#[gravity(g, while(\"t < 1\"))]",
            "`while` is for what can be there or not: supports, threads, the `stops` of a slider, springs, torsions, forces, couples, drives, pins to the ground and welds (for example `#[gravity(g)]`)",
        ),
        (
            "#[support(D = floor, jams)]",
            "`jams` applies to friction only; add `friction = mu` (for example `#[support(A = floor)]`)",
        ),
        ("#[equal(phi)]", "expected two angles or more (for example `#[equal(angle(AB), angle(CD))]`)"),
        (
            "#[coordinate(phi = angel(AD))]",
            "a coordinate is `angle(BAR)`, `x(POINT)` or `y(POINT)` (for example `#[coordinate(phi = angle(AD), from = horizontal)]`)",
        ),
        ("#[mirror(z = 0)]", "a mirror is the line `x = …` or `y = …` (for example `#[mirror(x = 0)]`)"),
        (
            "#[chain(c, links = 0, from = D, mass = m, length = l)]",
            "`links` must be a whole number from 1 to 512 (for example `#[chain(c, links = 16, from = O, mass = m, length = l)]`)",
        ),
        ("#[gravity(0, g)]", "gravity is declared twice; remove one (for example `#[gravity(g)]`)"),
    ];
    for (attribute, expected) in cases {
        assert_eq!(find_mistakes(attribute), [expected], "{attribute}");
    }
}

#[test]
fn names_of_malformed_attributes_are_not_reported_again() {
    let rest =
        "#[bar(DB mass = m)] #[support(B = floor)] #[coordinate(phi = angle(DB))] #[figure(B = (l, 0))]";
    assert_eq!(find_mistakes(rest).len(), 1);
}

#[test]
fn attributes_on_fields_belong_to_the_struct() {
    let item = "#[gravity(g)] #[pin(A = (0, 0))] #[bar(AD, mass = m, length = l)] \
                struct S { #[mass(A, m)] m: f64, l: f64, g: f64 }";
    assert_eq!(messages(item), ["`mass` describes the whole system; put it on the struct"]);
}

#[test]
fn only_structs_of_numbers_are_systems() {
    for (item, what) in
        [("enum E { A }", "an enum"), ("union U { a: f64 }", "a union"), ("struct T(f64);", "a tuple struct")]
    {
        let told = messages(item);
        assert!(
            told.len() == 1 && told[0].starts_with(&format!("{what} cannot be a bar system")),
            "{told:?}"
        );
    }
    assert_eq!(
        messages("struct S<T> { m: T }"),
        ["a bar system has no generic parameters; its parameters are `f64` fields"]
    );
    let mixed = "#[gravity(g)] #[pin(A = (0, 0))] #[bar(AD, mass = m, length = l)] struct S { m: f32, l: f64, g: f64 }";
    assert_eq!(messages(mixed), ["parameter `m` must be an `f64`"]);
}

/// Resolves an item again and again, each time with one word left out or doubled.
fn perturb(item: &str) {
    let spaced = item.replace(',', " , ").replace('(', " ( ").replace(')', " ) ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    for i in 0..words.len() {
        for copies in [0, 2] {
            let mut changed = words.clone();
            changed.splice(i..=i, vec![words[i]; copies]);
            if let Ok(tokens) = changed.join(" ").parse() {
                let _ = crate::syntax::parse(tokens).and_then(|d| crate::system::System::resolve(&d));
            }
        }
    }
}

#[test]
fn no_word_left_out_or_doubled_panics() {
    let bars = "#[gravity(g)] #[bar(AC, mass = m, length = l)] #[bar(shin = C -> B, mass = m, length = l, \
                inertia = m * l.powi(2) / 12, centre = (l / 2, 0))] #[point(G = shin, at = l / 2)] #[mass(G, m)] \
                #[support(A = floor)] #[support(B = wall(2 * l), facing = left)] #[support(P = corner(0, l), under = AC)] \
                #[figure(A = (-l / 2, 0), C = (0, l * sqrt(3) / 2))] #[coordinate(phi = angle(AC), from = horizontal)] \
                #[coordinate(y = -y(C))] #[equal(phi, angle(shin))] #[mirror(x = 0, swap(A, B))] \
                struct S { m: f64, l: f64, g: f64 }";
    let connected = "#[gravity(g)] #[body(hull, points(A = (0, 0), B = (l, 0), C = (0, l)), mass = m)] #[bar(BD, mass = m, \
                     length = l)] #[particle(P, mass = m)] #[ground(O = (0, 3))] #[pin(A = (0, 0))] #[weld(hull, BD)] \
                     #[weld(BD, angle = pi / 3)] #[slider(P = line(m, (0, l)))] #[slider(s = bar(BD), of = O)] \
                     #[support(D = slot(0, (0, l), 2 * l), rough, restitution = m / 2, law = poisson)] \
                     #[support(Q = circle((0, -3), 1), under = P, stop)] #[thread(rope = D -> O -> A, length = 9 * l)] \
                     #[figure(B = (l, 0), D = (l, l), P = (0, 1))] #[mirror(x = 0, swap(A, B))] \
                     struct S { m: f64, l: f64, g: f64 }";
    let loaded = "#[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = l)] #[pin(A = (0, 0))] \
                  #[coordinate(phi = angle(AB), from = down)] #[spring(s = A -> C, stiffness = k, length = l, damping = k)] \
                  #[torsion(AB, BC, stiffness = k, angle = pi / 2)] #[torsion(BC, damping = k)] \
                  #[force(drag = (-k * vx(C) * sqrt(2), tan(t).powi(2)), at = C, frame = BC)] \
                  #[couple(motor = rate(phi) / (1 + phi), on = BC, from = AB)] #[drive(angle(AB) = sin(2 * t))] \
                  #[drive(x(C) = l * t)] #[section(S = AB, at = l / 2)] #[liftoff(sets = 4, crate = other)] \
                  #[figure(B = (0, -l))] #[mirror(y = 0)] struct S { m: f64, l: f64, k: f64 }";
    for item in [bars, connected, loaded] {
        perturb(item);
    }
}

/// `500mm` would be read as 500, in whatever unit the rest is.
#[test]
fn suffixes_of_numbers_are_refused() {
    let text = "`mm` after a number has no meaning; write the number alone";
    let rod = |mass: &str, value: &str| {
        messages(&format!(
            "#[gravity(g)] #[bar(OA, mass = {mass} * m, length = l)] #[pin(O = (0, 0))] #[figure(A = (0, -l))]
             struct Rod {{ m: f64, #[value({value})] l: f64, g: f64 }}"
        ))
    };
    assert_eq!(rod("2", "500"), [""; 0]);
    assert_eq!(rod("2", "0.5f64"), [""; 0]);
    assert_eq!(rod("2mm", "500"), [text]);
    for value in ["500mm", "0.5mm", "2 * 5e2mm"] {
        let example = "(for example `#[value = 9.81]` or `#[value(9.81, unit = \"m/s²\")]`)";
        assert_eq!(rod("2", value), [format!("{text} {example}")]);
    }
}

#[test]
fn a_run_says_each_thing_once() {
    let twice = |run: &str, name: &str| {
        let text = format!("`{name}` is given twice; remove one (for example ");
        let all = find_mistakes(&format!("#[run({run})]"));
        assert!(all.iter().any(|message| message.starts_with(&text)), "{all:?}");
    };
    twice("start = \"x_A = 1\", start = \"x_A = 2\"", "start");
    twice("start = \"x_A = 1, y_A = 0, x_A = 2\"", "x_A");
    twice("limit = 1, limit = 2", "limit");
}

/// What the compiler would refuse where a file is read without it.
#[test]
fn attributes_that_the_compiler_would_refuse_are_reported() {
    let told = |attributes: &str, field: &str| {
        let item = format!("{attributes} struct S {{ {field} m: f64 }}");
        let errors = crate::syntax::check_attributes(&syn::parse_str(&item).unwrap()).err();
        errors.into_iter().flatten().map(|error| error.to_string()).collect::<Vec<_>>()
    };
    let hint = |name: &str, hint: &str| format!("there is no attribute `{name}`; did you mean `{hint}`?");
    assert_eq!(
        told("#[derive(Default)] #[suport(A = floor)] #[gravty(g)] #[rope(AB, length = s)]", "#[default(3)]"),
        [
            hint("suport", "support"),
            hint("gravty", "gravity"),
            hint("rope", "#[thread(AB, length = s)]"),
            hint("default", "#[value(9.81, unit = \"m/s²\")]"),
        ]
    );
    let all = told("#[gelenk(AB)]", "");
    assert!(
        all[0].starts_with("there is no attribute `gelenk`; those of a bar system are `budget`, "),
        "{all:?}"
    );
    let condition = "conditions are not evaluated here; write the attribute without `cfg_attr`";
    assert_eq!(told("#[cfg_attr(test, allow(x), support(A = floor))]", ""), [condition]);
    assert_eq!(
        told("#[cfg_attr(test, collision(A = floor))]", ""),
        [hint("collision", "#[support(A = floor)]")]
    );
    assert_eq!(told("", "#[cfg_attr(test, value = 3)]"), [condition]);
    assert_eq!(told("#[liftoff::bar(AB)]", ""), ["an attribute of a bar system has no path; write `bar`"]);
    // A helper attribute is that of a derive that stands there.
    for derive in ["Serialize", "serde::Deserialize", "serde::Other"] {
        assert_eq!(told(&format!("#[derive({derive})] #[serde(tag)]"), "#[serde(skip)]"), [""; 0]);
        assert_eq!(
            told(&format!("#[derive({derive})] #[rope(AB)]"), ""),
            [hint("rope", "#[thread(AB, length = s)]")]
        );
    }
    assert_eq!(told("#[cfg_attr(test, derive(Builder), builder(x))] #[builder(y)]", ""), [""; 0]);
    assert_eq!(told("#[derive(Clone)] #[serde(tag)]", "").len(), 1);
    let fine = "/// A body.\n#[derive(Clone)] #[allow(dead_code)] #[expect(x)] #[cfg_attr(test, derive(Debug))] \
                #[inline] #[must_use] #[deprecated] #[repr(C)] #[non_exhaustive] #[gravity(g)] #[other::bar(AB)]";
    assert_eq!(told(fine, "/// A mass.\n#[cfg(test)] #[value = 3] #[allow(x)]"), [""; 0]);
}
