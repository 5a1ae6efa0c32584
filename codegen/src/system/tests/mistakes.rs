//! What does not fit together is told, all at once and without consequences of the first mistake.

use super::messages;

const BAR: &str = "#[gravity(g)] #[bar(AD, mass = m, length = l)] #[pin(A = (0, 0))]";
const STRUCT: &str = "struct S { m: f64, l: f64, g: f64 }";

fn find_mistakes(attributes: &str) -> Vec<String> {
    messages(&format!("{attributes} {STRUCT}"))
}

#[test]
fn a_right_declaration_is_not_faulted() {
    assert_eq!(find_mistakes(BAR), [""; 0]);
}

#[test]
fn unknown_names_suggest_what_was_meant() {
    assert_eq!(
        find_mistakes(&format!("{BAR} #[support(B = floor)]")),
        ["there is no point `B`; declared: `A`, `D`"]
    );
    assert_eq!(
        find_mistakes(&format!("{BAR} #[coordinate(x_G = x(G))]")),
        [
            "there is no point `G`; a centre of mass gets its name by `#[point(G = AD, at = …)]`, the distance from the first \
          point of `AD`"
        ]
    );
    assert_eq!(
        find_mistakes(&format!("{BAR} #[coordinate(phi = angle(DA))]")),
        ["there is no bar `DA`; did you mean `AD`?"]
    );
    assert_eq!(
        find_mistakes(&BAR.replace("length = l", "length = ll")),
        ["there is no parameter `ll`; did you mean `l`? (a parameter is an `f64` field of the struct)"]
    );
    assert_eq!(
        find_mistakes(&format!("{BAR} #[coordinate(phi = angle(AD))] #[equal(phii, angle(AD))]")),
        ["there is no coordinate `phii`; did you mean `phi`?"]
    );
    assert_eq!(
        find_mistakes(&format!("{BAR} #[equal(AD, angle(AD))]")),
        ["`AD` is a bar; write `angle(AD)` for its direction"]
    );
}

#[test]
fn duplicate_declarations_are_reported() {
    assert_eq!(
        find_mistakes(&format!("{BAR} #[bar(AD, mass = m, length = l)]")),
        ["bar `AD` is declared twice; remove one, or name it: `other = A -> D`"]
    );
    assert_eq!(
        find_mistakes(&format!("{BAR} #[pin(A = (0, 0))]")),
        ["point `A` is pinned twice; remove one pin"]
    );
    let points = "#[point(G = AD, at = l / 2)] #[point(G = AD, at = l / 3)]";
    assert_eq!(find_mistakes(&format!("{BAR} {points}")), ["point `G` is declared twice; remove one"]);
    assert_eq!(
        find_mistakes(&format!("{BAR} #[coordinate(l = angle(AD))]")),
        ["coordinate `l` has the name of a parameter; rename one"]
    );
    assert_eq!(
        find_mistakes(&format!("{BAR} #[coordinate(t = angle(AD))]")),
        ["coordinate `t` has the name of a quantity of every run; rename one"]
    );
    assert_eq!(
        find_mistakes(&format!("{BAR} #[coordinate(p = angle(AD))] #[coordinate(q = angle(AD), from = up)]")),
        ["`q` measures what `p` measures already; remove one"]
    );
    assert_eq!(
        find_mistakes(&format!(
            "{BAR} #[figure(D = (0, -l))] #[support(D = floor(-l))] #[support(D = floor(-2 * l))]"
        )),
        ["support `D` is declared twice; give one another name: `other = …, under = D`"]
    );
}

#[test]
fn literals_that_no_body_can_have_are_reported() {
    let values = "#[gravity(g)] #[bar(AD, mass = -1, length = 0, inertia = -m / m)] #[bar(DC, mass = m, length = -2.5 * l / l)] \
                  #[mass(C, -3)] #[pin(A = (0, 0))]";
    assert_eq!(
        find_mistakes(values),
        [
            "the mass of `AD` is -1; it cannot be negative",
            "the length of `AD` is 0; it must be positive",
            "the inertia of `AD` is -1; it cannot be negative",
            "the length of `DC` is -5/2; it must be positive",
            "the mass of `C` is -3; it cannot be negative",
        ]
    );
}

#[test]
fn a_bar_that_nothing_ties_is_reported() {
    let loose = "#[bar(BC, mass = m, length = l)] #[figure(B = (l, 0))]";
    let text =
        "nothing ties bar `BC` to anything; let it share a point with another bar, or pin or support it";
    assert_eq!(find_mistakes(&format!("{BAR} {loose}")), [text]);
    for tie in ["#[pin(C = (0, 0))]", "#[equal(angle(BC), angle(AD))]", "#[coordinate(x = x(B))]"] {
        assert_eq!(find_mistakes(&format!("{BAR} {loose} {tie}")), [""; 0], "{tie}");
    }
}

#[test]
fn figures_that_say_too_little_or_nothing_are_reported() {
    assert_eq!(
        find_mistakes("#[gravity(g)] #[bar(AD, mass = m, length = l)]"),
        ["point `A` is needed in `#[figure(…)]`: nothing else says where bar `AD` is"]
    );
    assert_eq!(
        find_mistakes(&format!("{BAR} #[figure(D = (0, 0))]")),
        ["both ends of bar `AD` are at one place in the figure"]
    );
    assert_eq!(
        find_mistakes(&format!("{BAR} #[figure(D = (sqrt(-l - 2 * m), 0))]")),
        ["the figure of bar `AD` is not a number with any of the parameters tried"]
    );
    assert_eq!(
        find_mistakes(&format!("{BAR} #[figure(A = (l, 0))]")),
        ["`A` is pinned to another place than the figure says; leave it out of the figure"]
    );
    assert_eq!(
        find_mistakes(&format!("{BAR} #[figure(D = (0, l))] #[support(P = corner(0, 0), under = AD)]")),
        ["bar `AD` is upright in the figure, so a corner is neither under nor over it; tilt the figure"]
    );
}

#[test]
fn unused_parameters_are_reported_only_when_all_is_understood() {
    let item =
        |attributes: &str| messages(&format!("{attributes} struct S {{ m: f64, l: f64, g: f64, k: f64 }}"));
    assert_eq!(item(BAR), ["parameter `k` is used nowhere; use it or remove it"]);
    assert_eq!(item(&BAR.replace("gravity(g)", "gravity()")).len(), 1);
    assert_eq!(
        find_mistakes(&format!("{BAR} #[constant(h = l)]")),
        ["constant `h` is used nowhere; use it or remove it"]
    );
}

#[test]
fn expressions_tell_all_their_mistakes() {
    assert_eq!(
        find_mistakes(
            "#[gravity(g / 0)] #[bar(AD, mass = m + x + y, length = l)] #[pin(A = (sqrt(-1), 1e60))]"
        ),
        [
            "there is no parameter `x`; declared: `m`, `l`, `g` (a parameter is an `f64` field of the struct)",
            "there is no parameter `y`; declared: `m`, `l`, `g` (a parameter is an `f64` field of the struct)",
            "the root of a negative number",
            "this number has too many digits for exact 128-bit fractions; make it a parameter",
            "division by zero",
        ]
    );
}

#[test]
fn mistakes_of_every_stage_are_reported_together() {
    let attributes = "#[gravity(g)] #[bar(AD, mass = -1, length = l)] #[bar(BC, mass = m, length = l)] \
                      #[support(X = floor)] #[coordinate(phi = angle(DA))] #[pin(A = (0, 0))] #[figure(B = (l, 0))]";
    assert_eq!(
        messages(&format!("{attributes} struct S {{ m: f64, l: f64, g: f64, k: f64 }}")),
        [
            "the mass of `AD` is -1; it cannot be negative",
            "there is no point `X`; declared: `A`, `D`, `B`, `C`",
            "there is no bar `DA`; did you mean `AD`?",
            "nothing ties bar `BC` to anything; let it share a point with another bar, or pin or support it",
            "parameter `k` is used nowhere; use it or remove it",
        ]
    );
}

/// Not at the struct, which has no number.
#[test]
fn overflow_is_reported_at_the_longest_number() {
    let item = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[pin(A = (0, 0))]
                #[bar(long = B -> C, mass = 0.123456789 * 0.123456787 * m, length = 1.23456789 * 1.23456787 * l)]
                #[figure(A = (0, 0), B = (l, 0), C = (l + 1.5 * l, 0))]
                struct S { m: f64, l: f64, g: f64 }";
    let error = crate::analyse(item.parse().unwrap()).unwrap_err();
    assert!(error.to_string().contains("overflow"), "{error}");
    assert_eq!(error.span().source_text().as_deref(), Some("long"), "{error}");
}

#[test]
fn a_body_is_no_bar() {
    let told = messages(
        "#[body(hull, points(A = (0, 0), B = (l, 0), C = (0, l)), mass = m)] #[bar(PQ, mass = m, length = l)]
         #[pin(P = (0, 0))] #[figure(A = (0, 0), B = (l, 0), P = (0, 0), Q = (l, 0))] struct S { m: f64, l: f64 }",
    );
    assert_eq!(
        told,
        ["nothing ties body `hull` to anything; let it share a point with another bar, or pin or support it"]
    );
}
