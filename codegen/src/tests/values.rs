//! Default values of parameters.

use super::{analysis, find_mistakes};

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
        ("#[value(2, unit = \"t\",)]", 2000.0, "kg"),
        ("#[value(9, unit = \"mg\")]", 9e-6, "kg"),
    ];
    for (field, value, unit) in cases {
        let read = analysis(&pendulum(field)).system.values;
        assert_eq!((read[0].value, &*read[0].unit), (Some(value), unit), "{field}");
        assert_eq!((read[1].value, &*read[1].unit), (None, ""), "{field}");
    }
}

#[test]
fn mistakes_are_reported() {
    let example = "(for example `#[value = 9.81]` or `#[value(9.81, unit = \"m/s²\")]`)";
    let no_number = "a value is a number, or an expression of numbers and `pi`";
    let cases = [
        ("#[value]", "the value is missing"),
        ("#[value = \"2\"]", no_number),
        ("#[value = l]", no_number),
        ("#[value = 2 % 3]", no_number),
        ("#[value = 1 / 0]", "the value is inf, which is no number"),
        ("#[value = 500mm]", "`mm` after a number has no meaning; write the number alone"),
        ("#[value(2, \"kg\")]", "expected identifier"),
        ("#[value(2, units = \"kg\")]", "expected `unit = \"…\"`"),
        ("#[value(2, unit = \"kg\", 3)]", "expected nothing more"),
    ];
    for (field, expected) in cases {
        assert_eq!(find_mistakes(&pendulum(field)), [format!("{expected} {example}")], "{field}");
    }
    assert_eq!(find_mistakes(&pendulum("#[value = 2] #[value = 3]")), ["a parameter has one value"]);
    let misplaced = format!("#[value = 2] {}", pendulum(""));
    assert_eq!(find_mistakes(&misplaced), ["`value` belongs to one parameter; put it on its field"]);
}

#[test]
fn units_are_converted_or_refused() {
    let swing = |value: &str, start: &str, limit: &str| {
        format!(
            "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[pin(O = (0, 0))] #[slider(Q = horizontal(0))]
             #[particle(Q, mass = m)] #[torsion(OA, stiffness = 3 * c, angle = a)] #[figure(A = (l, 0), Q = (0, 0))]
             #[coordinate(phi = angle(OA), from = up)] #[coordinate(x = x(Q))]
             #[run(start = \"{start}\", limit = {limit})]
             struct Swing {{ m: f64, #[value(200, unit = \"{value}\")] l: f64, #[value(9, unit = \"deg\")] a: f64,
             #[value(2, unit = \"kN cm\")] c: f64, g: f64 }}"
        )
    };
    let read = analysis(&swing("mm", "phi = 5 deg, phi' = 60 rpm, x = 9 mm, x' = -36 km/h", "\"5 ms\""));
    let values: Vec<_> = read.system.values.iter().map(|known| (known.value, &*known.unit)).collect();
    let (radian, turn) = (core::f64::consts::PI / 180.0, 2.0 * core::f64::consts::PI);
    assert_eq!(values[1..4], [(Some(0.2), "m"), (Some(9.0 * radian), "rad"), (Some(20.0), "N m")]);
    let run = &read.system.run;
    let start: Vec<_> = run.start.iter().map(|start| (&*start.name, start.value)).collect();
    assert_eq!(start[..3], [("phi", 5.0 * radian), ("phi'", turn), ("x", 9e-3)]);
    // Rounding of km/h.
    assert!((start[3].1 + 10.0).abs() < 1e-14);
    assert_eq!(run.limit, Some(5e-3));

    let limit = "the latest end is a time: `10` or `500 ms`";
    let elsewhere = |name: &str, what: &str, example: &str| {
        format!("`{name}` is {what}; its unit measures something else: write `{name} = {example}`")
    };
    for (value, start, until, wrong) in [
        ("kg", "phi = 1", "1", "`l` is a mass here, but a length by the length of `OA`".to_owned()),
        ("s", "phi = 1", "1", "`l` is a time here, but a length by the length of `OA`".to_owned()),
        ("mmm", "phi = 1", "1", "no unit `mmm`; did you mean `mm`?".to_owned()),
        ("", "phi = 1", "1", "the unit is missing".to_owned()),
        ("m", "phi = 5 mm", "1", elsewhere("phi", "an angle", "80 deg")),
        ("m", "x = 5 deg", "1", elsewhere("x", "a length", "200 mm")),
        ("m", "phi' = 5 deg", "1", elsewhere("phi'", "the rate of an angle", "2 rad/s")),
        ("m", "x' = 5 mm", "1", elsewhere("x'", "the rate of a length", "2 mm/s")),
        ("m", "phi = 5 degs", "1", "`5 degs`: no unit `degs`; did you mean `deg`?".to_owned()),
        ("m", "phi = 5", "\"5 mm\"", limit.to_owned()),
        ("m", "phi = 5", "\"-5 ms\"", "the latest end is a positive time".to_owned()),
    ] {
        let all = find_mistakes(&swing(value, start, until));
        assert!(all.len() == 1 && all[0].starts_with(&wrong), "{all:?} for {wrong}");
    }
}
