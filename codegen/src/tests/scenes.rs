//! Declarations of all kinds.

/// Their coordinates determine everything: T, V and the gaps are functions of these alone.
pub(crate) const SCENES: [&str; 15] = [
    "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[bar(AB, mass = 2 * m, length = l)] #[pin(O = (0, 0))]
     #[figure(A = (0, -l), B = (0, -2 * l))] struct Double { m: f64, l: f64, g: f64 }",
    super::PAIR,
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[support(A = floor, rough)] #[support(B = wall(2 * l), facing = left)]
     #[figure(A = (0, l), B = (l, l))] struct Rod { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[particle(P, mass = m)] #[support(P = circle((0, 0), l), rough)] #[figure(P = (0, l))]
     struct Marble { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[particle(P, mass = m)] #[support(P = bowl((0, 0), l))] #[figure(P = (0, -l))]
     struct Bowl { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[ground(O = (0, 2 * l))] #[thread(rope = A -> O -> B, length = 4 * l)]
     #[figure(A = (0, 0), B = (l, 0))] struct Hung { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[ground(O = (0, 2 * l))] #[ground(C = (l, 3 * l))]
     #[thread(rope = A -> O -> C, length = 6 * l)] #[figure(A = (0, 0), B = (l, 0))] struct Partly { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[pin(O = (0, 0))] #[ground(C = (2 * l, 0))]
     #[spring(AC, stiffness = k, length = l)] #[torsion(OA, stiffness = k * l * l, angle = 0)] #[section(S = OA, at = l / 3)]
     #[figure(A = (l, 0))] struct Sprung { m: f64, l: f64, g: f64, k: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = l)] #[weld(AB, BC, angle = pi / 2)]
     #[support(A = floor)] #[figure(A = (0, 0), B = (l, 0), C = (l, l))] struct Angle { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[support(A = floor)] #[support(B = floor)]
     #[figure(A = (-l / 2, 0), B = (l / 2, 0))] #[mirror(x = 0)] struct Level { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[chain(c, links = 10, from = O, mass = m, length = l)] #[pin(O = (0, 0))] #[figure(O = (0, 0))]
     struct Chain { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[particle(P, mass = m)] #[support(P = bar(AB), friction = mu)]
     #[figure(A = (0, 0), B = (l, 0), P = (l / 2, l))] struct OnBar { m: f64, l: f64, mu: f64, g: f64 }",
    "#[gravity(g)] #[body(hull, points(A = (0, 0), B = (l, 0), C = (0, h)), mass = m)] #[bar(PQ, mass = m, length = l)]
     #[support(P = edge(C, B), rough)] #[ground(O = (0, -l))] #[support(O = bar(PQ))]
     #[figure(A = (0, 0), B = (l, 0), P = (l, h), Q = (2 * l, h))] struct OnEdge { m: f64, l: f64, h: f64, g: f64 }",
    "#[gravity(g)] #[body(wheel, points(A = (0, 0), B = (r, 0)), mass = m, inertia = m * r * r / 2, centre = (0, 0))] #[disc(A, radius = r)]
     #[bar(CD, mass = m, length = l)] #[point(G = CD, at = l / 2)] #[support(A = bar(CD), friction = mu)]
     #[support(floor = floor(-l), under = A, rough)] #[support(hole = bowl(G, 9 * l), under = A)]
     #[figure(A = (0, r), B = (r, r), C = (-l / 2, 0), D = (l / 2, 0))] struct Wheel { m: f64, l: f64, r: f64, mu: f64, g: f64 }",
    "#[gravity(g)] #[particle(P, mass = m)] #[particle(Q, mass = m)] #[disc(P, radius = r)] #[disc(Q, radius = l)] #[support(P = disc(Q), friction = mu)]
     #[support(Q = circle((0, 9 * l), l))] #[support(top = bowl((0, 0), 20 * l), under = P)] #[figure(P = (0, 0), Q = (3 * l, 0))]
     struct Balls { m: f64, l: f64, r: f64, mu: f64, g: f64 }",
];

/// Joints that close loops, prescribed motions, names that are words of the language, and a chain
/// too long to be written out.
pub(crate) const OTHERS: [&str; 7] = [
    "#[bar(OA, mass = a, length = r)] #[bar(CB, mass = b, length = l)] #[pin(O = (0, h))] #[pin(C = (0, 0))]
     #[slider(A = bar(CB))] #[figure(A = (r, h), B = (4 * l / 5, 3 * l / 5))] #[coordinate(phi = angle(OA))]
     #[coordinate(psi = angle(CB))] #[drive(phi = omega * t)]
     struct QuickReturn { a: f64, b: f64, r: f64, l: f64, h: f64, omega: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = l)] #[bar(CD, mass = m, length = l)]
     #[pin(A = (0, 0))] #[pin(D = (l, 0))] #[figure(B = (0, l), C = (l, l))] struct Parallelogram { m: f64, l: f64, g: f64 }",
    "#[gravity(r#type)] #[bar(AB, mass = r#fn, length = l)] #[pin(A = (0, 0))] #[figure(A = (0, 0), B = (l, 0))]
     #[coordinate(r#match = angle(AB))] #[couple(AB = r#fn * l * r#type * sin(r#match))] struct r#struct { r#fn: f64, l: f64, r#type: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = l)] #[equal(angle(AB), angle(BC))] #[pin(A = (0, 0))]
     #[figure(A = (0, 0), B = (l, 0), C = (2 * l, 0))] struct Equal { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[chain(c, links = 40, from = O, mass = m, length = l)] #[pin(O = (0, 0))] #[figure(O = (0, 0))]
     struct Long { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = a)] #[bar(BC, mass = m, length = b)] #[support(A = floor)] #[support(C = floor)]
     #[support(B = floor)] #[coordinate(phi = angle(AB), from = horizontal)] #[coordinate(psi = angle(BC), from = horizontal)]
     #[figure(A = (0, 0), B = (a, 0), C = (a + b, 0))] struct Rods { m: f64, a: f64, b: f64, g: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[particle(P, mass = m)] #[slider(P = bar(AB), friction = mu / (1 + v * v))]
     #[slider(s = horizontal(0), of = A, friction = mu, static = 2 * mu, jams)]
     #[support(B = floor(-9 * l))] #[figure(A = (l, 0), B = (0, 0), P = (l / 2, 0))] struct Guides { m: f64, l: f64, mu: f64, g: f64 }",
];

#[test]
fn emitted_code_parses_as_rust() {
    for declaration in SCENES.iter().chain(&OTHERS) {
        let code = crate::expand(declaration.parse().unwrap());
        let text = code.to_string();
        assert!(!text.contains("compile_error"), "{declaration}: {text}");
        assert!(syn::parse2::<syn::File>(code).is_ok(), "{declaration}");
    }
}

/// What `rustc` would refuse before it comes to the derive is told, and not repeated.
#[test]
fn malformed_structs_give_compile_errors() {
    for declaration in ["struct pub { l: f64 }", "struct struct Sample { l: f64 }"] {
        let code = crate::expand(declaration.parse().unwrap());
        assert!(code.to_string().contains("compile_error"), "{code}");
        assert!(syn::parse2::<syn::File>(code).is_ok(), "{declaration}");
    }
}

#[test]
fn everything_has_equations() {
    for declaration in SCENES.iter().chain(&OTHERS) {
        let equations = crate::equations(declaration.parse().unwrap()).unwrap();
        assert!(!equations.phases.is_empty() || !equations.joints.is_empty(), "{declaration}");
        let all = equations.phases.iter().flat_map(|phase| &phase.motion).chain(&equations.gaps);
        for equation in all.chain(&equations.mass) {
            let (html, latex) = (equation.mathml(), equation.latex());
            assert_eq!(html.matches("<math").count(), html.matches("</math>").count(), "{html}");
            assert_eq!(latex.matches('{').count(), latex.matches('}').count(), "{latex}");
        }
    }
}

#[test]
fn angles_that_are_equal_already_or_never_are_reported() {
    let bars = "#[bar(AB, mass = m, length = l)] #[bar(BC, mass = m, length = l)] #[figure(A = (0, 0), B = (l, 0), C = (2 * l, 0))]";
    let told = |attributes: &str| {
        super::find_mistakes(&format!("{bars} {attributes} struct S {{ m: f64, l: f64 }}"))
    };
    let again = told("#[equal(angle(AB), angle(BC))] #[equal(angle(BC), angle(AB))]");
    assert_eq!(again, ["angle(BC) and angle(AB) are equal already; remove this constraint"]);
    let welded = told("#[weld(AB, BC)] #[equal(angle(AB), angle(BC))]");
    assert!(welded.len() == 1 && welded[0].contains("already"), "{welded:?}");
    let never = told("#[weld(AB, BC, angle = pi / 2)] #[equal(angle(AB), angle(BC))]");
    assert!(
        never.iter().any(|text| text.contains("cannot be equal") || text.contains("contradicts")),
        "{never:?}"
    );
}

/// Coefficients are fractions of 128 bits, which three such numbers would overflow.
#[test]
fn numbers_of_many_digits_do_not_overflow() {
    let (a, b) = ("0.30000000000000004", "0.6123724356957945");
    let bars = format!(
        "#[bar(OA, mass = {a}, length = {b})] #[bar(AB, mass = {b}, length = {a})] #[bar(BC, mass = {a} * {b}, length = {b})]"
    );
    let figure =
        format!("#[pin(O = (0, 0))] #[figure(A = (0, -{b}), B = (0, -{b} - {a}), C = (0, -2 * {b} - {a}))]");
    let item = format!("#[gravity(9.80665123456789)] {bars} {figure} struct S {{}}");
    assert_eq!(super::find_mistakes(&item), [""; 0]);
}

/// A contact set tells the sides of the first 64 contacts, and guides are the first, whatever is
/// declared before them.
#[test]
fn guides_with_friction_are_the_first_contacts_and_bounded() {
    let beads = |count: usize| {
        let bead = |i: usize| {
            format!(
                "#[particle(P{i}, mass = m)] #[figure(P{i} = ({i}, 0))] #[slider(P{i} = horizontal(0), friction = mu)] "
            )
        };
        let all: String = (0..count).map(bead).collect();
        format!(
            "#[particle(Q, mass = m)] #[support(Q = floor)] #[figure(Q = (0, 1))] {all} struct S {{ m: f64, mu: f64 }}"
        )
    };
    let analysis = crate::analyse(beads(3).parse().unwrap()).unwrap();
    let labels = analysis.motion.contacts.iter().map(|contact| contact.label(&analysis.system));
    assert_eq!(labels.collect::<Vec<_>>(), ["P0", "P1", "P2", "Q"]);
    let sets = analysis.motion.sets(4);
    assert!(sets.len() == 16 && sets.iter().all(|set| set.closed & 0b111 == 0b111), "{sets:?}");
    let error = super::find_mistakes(&beads(65));
    assert_eq!(error, ["a model has at most 64 guides with friction; this is one more"]);
}
