//! Dimensions by hand, and what contradicts them at which place.

use proc_macro2::LineColumn;
use quote::ToTokens;

use super::{Dimension, Dimensions};
use crate::algebra::Rational;
use crate::syntax;

fn infer(item: &str) -> syn::Result<Dimensions> {
    Dimensions::infer(&syntax::parse(item.parse()?)?)
}

/// Those of an item with the given attributes and parameters that has no mistakes.
fn found(attributes: &str, parameters: &str) -> Dimensions {
    let fields: Vec<String> = parameters.split(' ').map(|name| format!("{name}: f64")).collect();
    infer(&format!("{attributes} struct S {{ {} }}", fields.join(", "))).unwrap()
}

/// What is told, and the tokens that it is told of.
fn find_mistakes(item: &str) -> Vec<(String, String)> {
    let Err(errors) = infer(item) else { return Vec::new() };
    let lines: Vec<&str> = item.lines().collect();
    let place = |LineColumn { line, column }: LineColumn| -> usize {
        let before = lines[..line - 1].iter().map(|line| line.chars().count() + 1);
        before.sum::<usize>() + column
    };
    let tokens = |error: &syn::Error| -> String {
        let (from, to) = (place(error.span().start()), place(error.span().end()));
        item.chars().skip(from).take(to - from).collect()
    };
    errors.into_iter().map(|error| (tokens(&error), error.to_string())).collect()
}

fn find_mistakes_in(attributes: &str) -> Vec<(String, String)> {
    let bar = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[pin(A = (0, 0))] \
               #[coordinate(phi = angle(AB))] #[coordinate(x = x(B))]";
    find_mistakes(&format!("{bar} {attributes} struct S {{ m: f64, l: f64, g: f64, f: f64, w: f64 }}"))
}

fn powers(length: i64, time: i64, mass: i64) -> Option<Dimension> {
    Some([length, time, mass].map(Rational::from))
}

#[test]
fn dimensions_follow_from_what_parameters_are_used_for() {
    let damped = found(
        "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[mass(A, n)] #[pin(O = (0, 0))]
         #[torsion(OA, stiffness = k, damping = c)] #[force(A = (f * cos(w * t), 0))] #[figure(A = (0, -l))]
         #[coordinate(phi = angle(OA), from = down)]",
        "m n l k c f w g",
    );
    let (mass, length, gravity) = (powers(0, 0, 1), powers(1, 0, 0), powers(1, -2, 0));
    let (stiffness, damping) = (powers(2, -2, 1), powers(2, -1, 1));
    let (force, frequency) = (powers(1, -2, 1), powers(0, -1, 0));
    assert!(damped.covariant);
    assert_eq!(damped.parameters, [mass, mass, length, stiffness, damping, force, frequency, gravity]);
}

#[test]
fn drives_and_roots_tell_of_what_is_in_them() {
    let driven = found(
        "#[gravity(g)] #[bar(OA, mass = m, length = r)] #[bar(AB, mass = m, length = l)] #[pin(O = (0, 0))]
         #[slider(B = horizontal(h))] #[drive(phi = w * t)] #[figure(A = (r, 0), B = (r + sqrt(l * l - h * h), h))]
         #[coordinate(phi = angle(OA), from = right)]",
        "m r l h w g",
    );
    let length = powers(1, 0, 0);
    assert!(driven.covariant);
    let (frequency, gravity) = (powers(0, -1, 0), powers(1, -2, 0));
    assert_eq!(driven.parameters, [powers(0, 0, 1), length, length, length, frequency, gravity]);
}

#[test]
fn a_number_with_a_dimension_is_noticed() {
    let bar =
        |length: &str| format!("#[gravity(g)] #[bar(OA, mass = m, length = {length})] #[pin(O = (0, 0))]");
    let fixed = found(&bar("2"), "m g");
    assert!(!fixed.covariant);
    assert_eq!(fixed.parameters, [powers(0, 0, 1), powers(1, -2, 0)]);
    assert!(!found(&bar("3 * m"), "m g").covariant);
    assert!(!found(&bar("sqrt(l * l + 1)"), "m g l").covariant);
    assert!(found(&bar("l / 2 + 0"), "m g l").covariant);
}

#[test]
fn numbers_with_a_dimension_leave_dimensions_open() {
    let attributes = "#[bar(OA, mass = m, length = 2 * l)] #[figure(A = (2, 0))]";
    let found = found(attributes, "m l");
    assert_eq!((found.covariant, found.parameters), (false, vec![powers(0, 0, 1), None]));
}

#[test]
fn of_a_product_alone_no_factor_is_determined() {
    let attributes = "#[bar(OA, mass = m * n, length = l)] #[mass(A, n * n / m)]";
    let both = found(attributes, "m n l");
    let third = |n: i64| Rational::from(n) * Rational::integer(3).recip();
    let [zero, one, two] = [0, 1, 2].map(third);
    assert_eq!(both.parameters, [Some([zero, zero, one]), Some([zero, zero, two]), powers(1, 0, 0)]);
    let product = found("#[bar(OA, mass = m * n, length = l)]", "m n l");
    assert_eq!((product.covariant, product.parameters), (true, vec![None, None, powers(1, 0, 0)]));
}

#[test]
fn constants_and_pure_numbers_take_part() {
    let attributes = "#[constant(h = l * e)] #[bar(OA, mass = m, length = l)] #[figure(A = (0, h))]
                      #[mass(A, m * (1 + q) * cos(pi * a))]";
    let found = found(attributes, "m l e q a");
    let number = powers(0, 0, 0);
    assert!(found.covariant);
    assert_eq!(found.parameters, [powers(0, 0, 1), powers(1, 0, 0), number, number, number]);
}

#[test]
fn a_contradiction_is_reported_at_its_term() {
    let length = "is a length here, but";
    assert_eq!(
        find_mistakes_in("#[floor] #[support(B = floor(m))]"),
        [("m".to_owned(), format!("`m` {length} a mass by the mass of `AB`"))]
    );
    assert_eq!(
        find_mistakes_in("#[point(G = AB, at = m * g)]"),
        [("m * g".to_owned(), format!("this {length} a force by the mass of `AB`, gravity"))]
    );
    assert_eq!(
        find_mistakes_in("#[couple(AB = m * g)]"),
        [(
            "m * g".to_owned(),
            "this is a torque (force length) here, but a force by the mass of `AB`, gravity".to_owned()
        )]
    );
    assert_eq!(
        find_mistakes_in("#[force(B = (m * g + l * f, f))]"),
        [(
            "f".to_owned(),
            "`f` is a force here, but a stiffness (force/length) by the mass of `AB`, the length of `AB`, gravity, …"
                .to_owned()
        )]
    );
    assert_eq!(
        find_mistakes_in("#[force(B = (m * g - l, 0))]"),
        [(
            "l".to_owned(),
            "`l` is added to a force here, but is a length by the mass of `AB`, the length of `AB`, gravity"
                .to_owned()
        )]
    );
    assert_eq!(
        find_mistakes_in("#[force(B = (m * g * sin(l), 0))]"),
        [("l".to_owned(), "`l` is a pure number here, but a length by the length of `AB`".to_owned())]
    );
}

#[test]
fn one_mistake_is_reported_once() {
    let attributes = "#[pin(C = (m, m))] #[figure(B = (m, -m))] #[support(B = floor(l / m))]";
    let told = find_mistakes_in(attributes);
    assert_eq!(told.len(), 2, "{told:?}");
}

#[test]
fn numbers_and_motion_alone_contradict_nothing() {
    for load in ["-50 * x(B)", "sin(t)", "x(B) + t", "f * (1 - t)", "f * cos(3 * t)", "0 * l", "f * l / 2"] {
        assert_eq!(find_mistakes_in(&format!("#[force(B = (f + 1, {load}))]")), [], "{load}");
    }
}

#[test]
fn rates_are_per_time() {
    let load = |value: &str| find_mistakes_in(&format!("#[force(B = (f, {value}))]"));
    assert_eq!(load("f * rate(phi) / w + m * rate(x) * w + m * vx(B) * w + m * x * w * w"), []);
    let text = "this is added to a force here, but is length^2 time^-3 mass";
    assert_eq!(load("f * cos(phi) + f * rate(x)"), [("f * rate(x)".to_owned(), text.to_owned())]);
}

#[test]
fn pure_numbers_are_not_compared() {
    let attributes = "#[liftoff(dimensionless)] #[bar(OA, mass = l, length = l)]";
    let found = found(attributes, "l");
    assert_eq!((found.covariant, found.parameters), (false, vec![None]));
}

#[test]
fn powers_beyond_measure_say_nothing() {
    let tower = ".powi(64)".repeat(30);
    let found = found(&format!("#[bar(OA, mass = m / m{tower} * m{tower}, length = l)]"), "m l");
    assert_eq!(found.parameters[1], powers(1, 0, 0));
}

/// All declarations of the workspace's models, by name.
fn models() -> Vec<(String, Dimensions, Vec<String>)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/systems/src");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let sources = files.filter(|path| path.is_file()).map(|path| std::fs::read_to_string(path).unwrap());
    let items = sources.flat_map(|source| syn::parse_file(&source).unwrap().items);
    let models = items.filter_map(|item| match item {
        syn::Item::Struct(item) if item.attrs.iter().any(|a| a.path().is_ident("figure")) => Some(item),
        _ => None,
    });
    let analysed = models.map(|item| {
        let description = syntax::parse(item.to_token_stream()).unwrap();
        let names = description.fields.iter().map(ToString::to_string).collect();
        (item.ident.to_string(), Dimensions::infer(&description).unwrap(), names)
    });
    analysed.collect()
}

#[test]
fn models_have_the_dimensions_of_their_letters() {
    let models = models();
    assert!(models.len() > 20, "{}", models.len());
    for (model, dimensions, names) in &models {
        // Their lengths and radii are numbers.
        let fixed = ["BouncingBall", "Squeezer"].contains(&model.as_str());
        assert_eq!(dimensions.covariant, !fixed, "{model}");
        for (name, found) in names.iter().zip(&dimensions.parameters) {
            let expected = match name.trim_end_matches(char::is_numeric) {
                "m" => powers(0, 0, 1),
                "l" | "r" | "s" | "h" => powers(1, 0, 0),
                "g" => powers(1, -2, 0),
                "omega" => powers(0, -1, 0),
                "torque" => powers(2, -2, 1),
                _ => *found,
            };
            assert!(found.is_some() && *found == expected, "{name} of {model}: {found:?}");
        }
    }
}

#[test]
fn units_say_what_parameters_are() {
    let bar = |unit: &str| {
        format!(
            "#[bar(OA, mass = 2 * m, length = 3 * l)] #[pin(O = (0, 0))] #[figure(A = (3 * l, 0))]
             #[coordinate(phi = angle(OA), from = right)]
             struct S {{ m: f64, #[value(200, unit = \"{unit}\")] l: f64 }}"
        )
    };
    assert_eq!(infer(&bar("mm")).unwrap().parameters[1], powers(1, 0, 0));
    // Of a number with a dimension of its own, `3 m/s · l`, the unit decides.
    assert_eq!(infer(&bar("ms")).unwrap().parameters[1], powers(0, 1, 0));
    let item = bar("mm").replace("3 * l, 0", "l, 0").replace("\"mm\"", "\"kg\"");
    let text = "`l` is a mass here, but a length by the place in the figure of `A`";
    assert_eq!(find_mistakes(&item), [("\"kg\"".to_owned(), text.to_owned())]);
}
