//! Which names give which constants.

use super::{constants, upper_snake};

/// The constants of a declaration, one a line.
fn emitted(declaration: &str) -> String {
    let tokens = constants(&crate::analyse(declaration.parse().unwrap()).unwrap()).to_string();
    tokens.replace("{ # [doc", "{\n# [doc").replace("; #", ";\n#")
}

const LADDER: &str = "
    #[gravity(g)]
    #[bar(AB, mass = m, length = l)]
    #[point(G = AB, at = l / 2)]
    #[support(A = floor)]
    #[support(heel = wall(0), under = B, facing = right)]
    #[thread(rope = G -> O, length = 2 * l)]
    #[ground(O = (0, l))]
    #[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
    #[coordinate(phi_inner = angle(AB), from = horizontal)]
    #[coordinate(x = x(A))]";

#[test]
fn each_kind_has_its_type_and_meaning() {
    let text = emitted(&format!("{LADDER} pub struct Ladder {{ m: f64, l: f64, g: f64 }}"));
    insta::assert_snapshot!(text);
}

#[test]
fn constants_are_as_visible_as_the_struct() {
    for visibility in ["", "pub", "pub (crate)", "pub (super)"] {
        let text = emitted(&format!("{LADDER} {visibility} struct Ladder {{ m: f64, l: f64, g: f64 }}"));
        assert!(text.contains(&format!("] {visibility} const PHI_INNER").replace("  ", " ")), "{text}");
    }
}

#[test]
fn there_are_none_if_none_are_wanted() {
    let ladder = format!("{LADDER} #[liftoff(names = false)] struct Ladder {{ m: f64, l: f64, g: f64 }}");
    assert_eq!(emitted(&ladder), "");
}

/// A coordinate `a` has the constant `A`, a coordinate `layout` none: the trait has one of that
/// name.
#[test]
fn of_names_with_one_constant_the_first_has_it() {
    let text = emitted(
        "#[bar(AB, mass = m, length = l)] #[figure(A = (0, 0), B = (l, 0))] #[coordinate(a = angle(AB))]
         #[coordinate(layout = x(A))]
         struct Rod { m: f64, l: f64 }",
    );
    assert!(
        text.contains("const A : names :: Coordinate = names :: Coordinate :: new (\"a\" , \"a'\")"),
        "{text}"
    );
    assert_eq!(text.matches("const A ").count(), 1, "{text}");
    assert!(!text.contains("LAYOUT"), "{text}");
}

/// So that its uses are no further mistakes.
#[test]
fn a_declaration_with_mistakes_has_its_names() {
    let code = crate::expand(
        "#[bar(AB, mass = m, length = l)] #[support(A = flor)] #[coordinate(phi = angle(AC))] #[pin(A = (0, 0))]
         struct Rod { m: f64, l: f64 }"
            .parse()
            .unwrap(),
    );
    let code = code.to_string();
    for name in ["PHI", "A", "B", "AB"] {
        assert!(code.contains(&format!("const {name} : names :: Unknown")), "{name}: {code}");
    }
}

#[test]
fn words_are_parted_by_underscores() {
    let cases = [
        ("phi", "PHI"),
        ("phi_1", "PHI_1"),
        ("leftFoot", "LEFT_FOOT"),
        ("AB", "AB"),
        ("theta_AB", "THETA_AB"),
        ("φ", "Φ"),
    ];
    for (name, constant) in cases {
        assert_eq!(upper_snake(name), constant);
    }
}
