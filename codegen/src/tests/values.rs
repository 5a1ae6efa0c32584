//! Default values of parameters.

use super::{analysis, told};

fn pendulum(field: &str) -> String {
    format!(
        "#[bar(OA, mass = m, length = l)] #[pin(O = (0, 0))] #[figure(A = (l, 0))] #[coordinate(phi = angle(OA), from = up)]
         struct Pendulum {{ {field} m: f64, l: f64 }}"
    )
}

#[test]
fn a_value_is_an_expression_of_numbers_with_a_unit() {
    let cases = [
        ("#[value = 2]", 2.0, ""),
        ("#[value = -(1.5 + 2) * 3 / 7]", -1.5, ""),
        ("#[value(pi / 3 - 1, unit = \"kg\")]", core::f64::consts::PI / 3.0 - 1.0, "kg"),
        ("#[value(0.25f64,)]", 0.25, ""),
        ("#[value(1e3, unit = \"t\",)]", 1000.0, "t"),
    ];
    for (field, value, unit) in cases {
        let read = analysis(&pendulum(field)).system.values;
        assert_eq!((read[0].value, &*read[0].unit), (Some(value), unit), "{field}");
        assert_eq!((read[1].value, &*read[1].unit), (None, ""), "{field}");
    }
}

#[test]
fn mistakes_are_told() {
    let example = "(for example `#[value = 9.81]` or `#[value(9.81, unit = \"m/s²\")]`)";
    let no_number = "a value is a number, or an expression of numbers and `pi`";
    let cases = [
        ("#[value]", "the value is missing"),
        ("#[value = \"2\"]", no_number),
        ("#[value = l]", no_number),
        ("#[value = 2 % 3]", no_number),
        ("#[value = 1 / 0]", "the value is inf, which is no number"),
        ("#[value = 500mm]", "`mm` behind a number has no meaning; write the number alone"),
        ("#[value(2, \"kg\")]", "expected identifier"),
        ("#[value(2, units = \"kg\")]", "expected `unit = \"…\"`"),
        ("#[value(2, unit = \"kg\", 3)]", "expected nothing more"),
    ];
    for (field, expected) in cases {
        assert_eq!(told(&pendulum(field)), [format!("{expected} {example}")], "{field}");
    }
    assert_eq!(told(&pendulum("#[value = 2] #[value = 3]")), ["a parameter has one value"]);
    let misplaced = format!("#[value = 2] {}", pendulum(""));
    assert_eq!(told(&misplaced), ["`value` is that of one parameter; put it on its field"]);
}
