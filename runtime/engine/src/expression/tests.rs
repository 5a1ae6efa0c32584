//! Expressions against a layout of a few names.

use super::parse::Parser;
use super::resolve::Vocabulary;
use super::tree::{Expression, Function, Operator};
use super::{Condition, Environment, Formula, Variable};
use crate::error::OutputError;
use crate::model::{Contact, ContactKind, Coordinate, Friction, Law, Layout, Quantity, QuantityKind};

static LAYOUT: Layout = Layout::new("Sample")
    .parameters(&["m", "l"])
    .dimensions(&[None, None])
    .coordinates(&[Coordinate { name: "phi", is_angle: true }])
    .contacts(&[
        Contact {
            label: "A, E",
            supports: &["A", "E"],
            shared: true,
            foot: None,
            kind: ContactKind::Support,
            rough: true,
            friction: None,
            jams: false,
            law: Law::Newton,
            stop: false,
            armed: None,
            breaks: None,
        },
        Contact {
            label: "B, C, D",
            supports: &["B", "C", "D"],
            shared: false,
            foot: None,
            kind: ContactKind::Support,
            rough: false,
            friction: None,
            jams: false,
            law: Law::Newton,
            stop: false,
            armed: None,
            breaks: None,
        },
        Contact {
            label: "P",
            supports: &["P"],
            shared: true,
            foot: None,
            kind: ContactKind::Support,
            rough: false,
            friction: Some(0),
            jams: false,
            law: Law::Newton,
            stop: false,
            armed: None,
            breaks: None,
        },
    ])
    .tangents(&[0, 2])
    .frictions(&[Friction { contact: 2, row: 4, follows_slip: false }])
    .quantities(&[
        Quantity { name: "fx(D, AD)", kind: QuantityKind::JointForce },
        Quantity { name: "fx(D, DB)", kind: QuantityKind::JointForce },
        Quantity { name: "drive(x(D))", kind: QuantityKind::DriveForce },
        Quantity { name: "shear(S)", kind: QuantityKind::SectionForce },
        Quantity { name: "Lz", kind: QuantityKind::AngularMomentum },
        Quantity { name: "m", kind: QuantityKind::Momentum },
        // The unit is that of the kind, whatever the name.
        Quantity { name: "drive(phi)", kind: QuantityKind::DriveTorque },
        Quantity { name: "bend(O)", kind: QuantityKind::BendingMoment },
    ])
    .points(&["D"]);

fn parse(text: &str) -> Result<Expression, OutputError> {
    let mut parser = Parser::new(text, Vocabulary::new(&LAYOUT))?;
    let sum = parser.sum()?;
    parser.end()?;
    Ok(sum)
}

#[test]
fn arithmetic_binds_as_usual() {
    let parameters = [2.0, 3.0];
    for (text, value) in [
        ("1 - 2 - 3", -4.0),
        ("2 + 3 * 4^2 / 8", 8.0),
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("2^3^2", 512.0),
        ("8 / 2 / 2", 2.0),
        ("sqrt(m + 7) * abs(-l)", 9.0),
        ("1.5e-3 * 2e3", 3.0),
        ("cos(pi) + tan(0) + sin(0)", -1.0),
        ("-(m - l)", 1.0),
    ] {
        assert_eq!(parse(text).unwrap().constant(&parameters), Some(value), "{text}");
    }
}

#[test]
fn names_are_those_of_the_model() {
    assert_eq!(parse("phi''").unwrap(), Expression::Coordinate { index: 0, order: 2 });
    assert_eq!(parse("vy(D)").unwrap(), Expression::Point { index: 0, axis: 1, order: 1 });
    assert_eq!(parse("N(E)").unwrap(), Expression::Reaction { contact: 0, share: 2.0 });
    assert_eq!(parse("N(E, A)").unwrap(), Expression::Reaction { contact: 0, share: 1.0 });
    assert_eq!(parse("R(A, E)").unwrap(), Expression::Friction { contact: 0, share: 1.0 });
    let (friction, normal) = (parse("R(A)").unwrap(), parse("N(A)").unwrap());
    assert_eq!(parse("ratio(A)").unwrap(), Expression::join(Operator::Divide, friction, normal));
    assert_eq!(parse("R(P)").unwrap(), Expression::Friction { contact: 2, share: 1.0 });
    assert_eq!(
        [parse("v(P)"), parse("mu(P)")].map(Result::unwrap),
        [Expression::Slip(0), Expression::Coefficient(0)]
    );
    for (text, entry) in [("fx(D,DB)", 1), ("drive( x (D) )", 2), ("shear(S)", 3), ("Lz", 4)] {
        assert_eq!(parse(text).unwrap(), Expression::Quantity(entry), "{text}");
    }
    assert_eq!(parse("m").unwrap(), Expression::Parameter(0));
    assert_eq!(parse("m ** 2").unwrap(), parse("m^2").unwrap());
    assert_eq!(parse("2 s + 30 deg").unwrap(), parse("2 + 0.5235987755982988").unwrap());
    assert!(Condition::parse(&LAYOUT, "t > 0.1 s and phi > 2 deg").is_ok());
    assert_eq!(Condition::parse(&LAYOUT, "t = 0.1 s").unwrap().time(&[1.0, 1.0]), Some(0.1));
    assert_eq!(parse("gap(C)").unwrap(), Expression::Gap(1));
}

#[test]
fn mistakes_are_reported_at_their_place() {
    for (text, message) in [
        ("", "expected a number, a name or `(`, found the end at column 1"),
        ("1 +* 2", "expected a number, a name or `(`, found `*` at column 4"),
        ("phi phi", "expected an operator or the end, found `phi` at column 5"),
        (
            "phi / 2 mm",
            "expected an operator, or one of the units `deg`, `rad` and `s` (else numbers are in SI units), found `mm` at column 9",
        ),
        ("sin(1", "expected `)`, found the end at column 6"),
        ("x(1)", "expected a point or a support, found `1` at column 3"),
        ("1.2.3", "expected a number, found `1.2.3` at column 1"),
        ("2 $", "expected an expression, found `$` at column 3"),
        ("np.sin(phi)", "expected a name without a prefix, as `sin(x)` or `pi`, found `.` at column 3"),
        (
            "phi != 0",
            "expected `=`, `<` or `>`: a condition is met when it becomes true, found `!` at column 5",
        ),
        ("ph", "no name `ph`; did you mean `phi`?"),
        ("phi'''", "no name `phi'''`; known: phi, m, l, Lz, pi, t, T, V, E, D"),
        ("sn(1)", "no function `sn`; did you mean `sin`?"),
        ("y(F)", "no point `F`; known: D"),
        ("y(D1)", "no point `D1`; did you mean `D`?"),
        (
            "x_G",
            "no name `x_G`: write `x(A)` for the x of point A; a centre of mass is a point if the declaration says so, `#[point(G = AB, at = l / 2)]`",
        ),
        (
            "y(G)",
            "no name `G`: write `x(A)` for the x of point A; a centre of mass is a point if the declaration says so, `#[point(G = AB, at = l / 2)]`",
        ),
        ("N(F)", "no support `F`; known: A, E, B, C, D, P"),
        (
            "R(B, C, D)",
            "B, C, D is smooth, with neither a friction force nor a slip velocity: declare it with `friction = mu`, or `rough`",
        ),
        (
            "v(B)",
            "B, C, D is smooth, with neither a friction force nor a slip velocity: declare it with `friction = mu`, or `rough`",
        ),
        ("mu(A)", "A, E is rough and does not slip: declare it with `friction = mu` in place of `rough`"),
        ("v(P, P)", "v takes one support: write v(P)"),
        ("gap(C, B)", "gap takes one support: write gap(C)"),
        ("fx(D, AB)", "no quantity `fx(D,AB)`; did you mean `fx(D, AD)`?"),
        ("fx(Q)", "no quantity `fx(Q)`; known: fx(D, AD), fx(D, DB)"),
        ("shears(S)", "no function `shears`; did you mean `shear`?"),
        ("fx(D", "expected `)`, found the end at column 5"),
        ("N(B)", "only the total reaction of B, C, D is determined: write N(B, C, D)"),
        ("N(A, B)", "A, B are not a single contact"),
        ("x(D, D)", "x takes one point: write x(D)"),
        ("speed(D, P)", "speed takes one point: write speed(D)"),
        ("speed(P)", "no point `P`; known: D"),
        ("vy(A, D)", "vy takes one point: write vy(A)"),
    ] {
        let error = parse(text).map(|_| ()).unwrap_err();
        assert_eq!(error.to_string(), message, "{text}");
    }
    assert!(matches!(parse(&"(".repeat(10_000)), Err(OutputError::Depth { .. })));
    assert!(matches!(parse(&"-".repeat(10_000)), Err(OutputError::Depth { .. })));
}

/// Σ 0.6ᵏ θᵏ less 2: a coordinate by itself as what is calculated.
#[test]
fn a_side_that_is_constant_is_subtracted() {
    let known: super::series::Source = &|_, terms| {
        terms.iter_mut().enumerate().for_each(|(k, term)| *term = 0.6_f64.powi(k as i32));
        Some(())
    };
    let sides = |text: &str| Condition::parse(&LAYOUT, text).unwrap().sides(&[1.0, 1.0], known).unwrap();
    let (own, other) = (sides("phi = 2"), sides("phi + 0 = 2 * m"));
    assert_eq!(own.difference(), other.difference());
    assert_eq!((own.difference()[0], own.difference()[1]), (-1.0, 0.6));
    // The sum at θ = 1; the terms left out.
    let end = (1.0 - 0.6_f64.powi(33)) / 0.4;
    for sides in [own, other] {
        assert!((sides.size() - end).abs() < 1e-14, "{}", sides.size());
        assert!((sides.end() - (end - 2.0)).abs() < 1e-14, "{}", sides.end());
        let tail = 0.6_f64.powi(33) / 0.4;
        assert!((1.0..4.0).contains(&(sides.tail() / tail)), "{} {tail}", sides.tail());
    }
    let negative = sides("-3 * phi = -9");
    assert!((negative.size() - 9.0).abs() < 1e-14 && sides("phi = 2.6").size() == 2.6);
}

#[test]
fn rates_degrees_and_comparisons_have_all_their_spellings() {
    let same = |one: &str, other: &str| assert_eq!(parse(one).unwrap(), parse(other).unwrap(), "{one}");
    same("rate(phi)", "phi'");
    same("rate(rate( phi ))", "phi''");
    same("rate(x(D))", "vx(D)");
    same("speed(D)", "sqrt(vx(D)^2 + vy(D)^2)");
    same("rate(l * phi - m)", "l * phi' - 0");
    same("30deg", &30.0_f64.to_radians().to_string());
    same("2 * 30° + 1 rad", &format!("2 * {} + 1", 30.0_f64.to_radians()));
    assert!(parse("rate(phi'')").is_err() && parse("rate(sin(phi))").is_err() && parse("30 m").is_err());
    let sides = |text: &str| {
        let condition = Condition::parse(&LAYOUT, text).unwrap();
        (condition.relation(), condition.values(&At(0.3)).unwrap())
    };
    assert_eq!(sides("phi == 1"), sides("phi = 1"));
    assert_eq!(sides("phi <= 1"), sides("phi < 1"));
    assert_eq!(sides("phi >= 1 && phi' < 0"), sides("(phi > 1) and (rate(phi) < 0)"));
    assert_eq!(sides("phi > 1 || phi < -1"), sides("phi > 1 or phi < -1"));
}

/// Every variable has this value.
struct At(f64);

impl Environment for At {
    type Value = f64;
    type Error = core::convert::Infallible;

    fn number(&self, x: f64) -> f64 {
        x
    }

    fn get_value(&self, _: Variable) -> Result<f64, Self::Error> {
        Ok(self.0)
    }

    fn apply(&self, function: Function, x: f64) -> Result<f64, Self::Error> {
        Ok(function.apply(x))
    }

    fn join(&self, operator: Operator, a: f64, b: f64) -> Result<f64, Self::Error> {
        Ok(operator.apply(a, b))
    }
}

/// `and` is the least margin, `or` the greatest; `and` goes before `or`.
#[test]
fn joined_comparisons_hold_as_in_logic() {
    let holds = |text: &str, phi: f64| {
        let condition = Condition::parse(&LAYOUT, text).unwrap();
        let [left, right] = condition.values(&At(phi)).unwrap();
        left > right
    };
    for phi in [-2.0, -0.5, 0.5, 2.0] {
        assert_eq!(holds("phi > -1 and phi < 1", phi), phi > -1.0 && phi < 1.0);
        assert_eq!(holds("phi < -1 or phi > 1", phi), !(-1.0..=1.0).contains(&phi));
        assert_eq!(holds("phi < -1 or phi > 0 and phi < 1", phi), phi < -1.0 || phi > 0.0 && phi < 1.0);
        assert_eq!(holds("(phi < -1 or phi > 0) and phi < 1", phi), (phi < -1.0 || phi > 0.0) && phi < 1.0);
    }
    let each = Condition::parse_each(&LAYOUT, "phi = 1 or t = 3 or phi > 0 and phi' > 2").unwrap();
    let texts: Vec<String> = each.iter().map(ToString::to_string).collect();
    assert_eq!(texts, ["phi = 1", "t = 3", "phi > 0 and phi' > 2"]);
    let error = |text: &str| Condition::parse(&LAYOUT, text).unwrap_err();
    assert!(matches!(error("phi = 0 and phi' > 0"), OutputError::Combined { .. }));
    assert!(matches!(error(&vec!["phi > 0"; 9].join(" and ")), OutputError::Clauses { most: 8 }));
    let deep = format!("{}phi > 0{}", "(".repeat(1000), ")".repeat(1000));
    assert!(matches!(error(&deep), OutputError::Depth { .. }));
    let negated = Condition::parse(&LAYOUT, "phi > 0 and phi' > 2").unwrap().negated();
    assert_eq!(negated.to_string(), "not (phi > 0 and phi' > 2)");
}

/// Whatever is accepted is read, evaluated and dropped on the 2 MiB of stack that a thread has.
#[test]
fn length_and_depth_are_bounded() {
    let sum = |terms: usize, term: &str| vec![term; terms].join("+");
    let long = sum(1001, "phi");
    let known: super::series::Source = &|_, terms| {
        terms.fill(0.0);
        terms[0] = 0.5;
        Some(())
    };
    let sides = Condition::parse(&LAYOUT, &format!("{long} = 1")).unwrap().sides(&[1.0, 1.0], known);
    assert_eq!(sides.unwrap().difference()[0], 1001.0 * 0.5 - 1.0);
    assert_eq!(parse(&sum(1001, "m")).unwrap().constant(&[2.0, 0.0]), Some(2002.0));
    let nested = format!("{}m{}", "1+1*2^sin(1-".repeat(31), ")".repeat(31));
    assert!(parse(&nested).unwrap().constant(&[2.0, 0.0]).is_some());
    let products = format!("{}phi{}", "(abs(m*".repeat(31), "*m/m)*2)".repeat(31));
    let condition = Condition::parse(&LAYOUT, &format!("{products} > 0"));
    assert!(condition.unwrap().sides(&[1.0, 1.0], known).is_none());
    assert_eq!(parse(&sum(1002, "m")), Err(OutputError::Operators { column: 2003 }));
    let text = parse(&"m".repeat(10_001)).unwrap_err().to_string();
    assert_eq!(text, "an expression of 10001 characters: at most 10000 are allowed");
    assert!(Formula::parse(&" ".repeat(1_000_000), &[]).is_err());
}

/// Words of the language in any order, and any characters: read or refused, within its bounds.
#[test]
fn whatever_is_written_is_read_or_refused() {
    const WORDS: [&str; 50] = [
        " and ", " or ", "==", "&&", "||", "rate", "°", "if(", "atan2(", "sign(", "phi", "phi'", "m", "l",
        "x", "y", "(", ")", "+", "-", "*", "/", "^", "=", "<", ">", ",", "N", "A", "E", "D", "B", "sin",
        "sqrt", "abs", "fx", "gap", "ratio", "1", "2.5e3", ".", "1e", "e-", "'", "mm", "deg", "kg/s^2", " ",
        "µ", "\0",
    ];
    let mut state = 1u64;
    let mut draw = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    let mut accepted = 0;
    for round in 0..20_000 {
        let length = 1 + draw(if round % 100 == 0 { 300 } else { 12 });
        let mut text: String = (0..length).map(|_| WORDS[draw(WORDS.len())]).collect();
        if round % 3 == 0 {
            let at = (0..=draw(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
            text.insert(at, char::from_u32(draw(0x3000) as u32).unwrap_or('?'));
        }
        accepted += usize::from(parse(&text).is_ok_and(|expression| {
            let _ = expression.constant(&[1.0, 2.0]);
            expression.clone() == expression
        }));
        let _ = Condition::parse(&LAYOUT, &text).map(|condition| condition.to_string());
        let _ = Formula::parse(&text, &["phi", "l"]).map(|formula| formula.value(&[1.0, 2.0]));
        let _ = super::si_unit::unit(&text, &LAYOUT, &[None, None]);
    }
    assert!((100..20_000).contains(&accepted), "{accepted}");
}

#[test]
fn units_follow_from_what_is_multiplied() {
    use super::si_unit::{METRE, SiUnit, unit};
    let parameters = [Some(SiUnit::new(1, 0, 0, 0)), Some(METRE)];
    for (text, expected) in [
        ("phi", Some("rad")),
        ("phi''", Some("rad/s²")),
        ("phi * 180 / pi", Some("°")),
        ("l * phi'", Some("m/s")),
        ("m * l * phi'^2", Some("N")),
        ("N(A) / (m * vx(D)^2 / l)", Some("")),
        ("T + V", Some("J")),
        ("shear(S) * l", Some("J")),
        ("drive(x(D))", Some("N")),
        ("drive(phi)", Some("N m")),
        ("bend(O)", Some("N m")),
        ("m * l^2 * phi'", Some("kg m²/s")),
        ("sqrt(l * ay(D))", Some("m/s")),
        ("R(P) * v(P)", Some("W")),
        ("speed(D)", Some("m/s")),
        ("mu(P)", Some("")),
        ("phi - 0.5", Some("rad")),
        ("m * l^3", Some("kg m³")),
        ("atan2(y(D), l)", Some("rad")),
        ("if(phi > 0 and t < 1, l, 2 * l) * sign(l)", Some("m")),
        ("atan2(m, l)", None),
        ("T + l", None),
        ("sin(l)", None),
        ("sqrt(l)", None),
    ] {
        assert_eq!(unit(text, &LAYOUT, &parameters).as_deref(), expected, "{text}");
    }
    assert_eq!(unit("m * l", &LAYOUT, &[None, Some(METRE)]), None);
}

/// Sides that are to become zero change their sign there.
#[test]
fn touching_arguments_keep_their_sign() {
    for (text, same) in [
        ("abs(phi - 0.5)", "phi - 0.5"),
        ("-2 * abs(phi)^3", "phi"),
        ("abs(phi) / 4", "phi"),
        ("abs(phi) / l", "phi / l"),
        ("abs(phi) * phi^2", "phi * phi"),
        ("abs(phi) - 0.1", "abs(phi) - 0.1"),
        ("sqrt(phi)", "sqrt(phi)"),
    ] {
        assert_eq!(parse(text).unwrap().vanishing(), parse(same).unwrap(), "{text}");
    }
}
