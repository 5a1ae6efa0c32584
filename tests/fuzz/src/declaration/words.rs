//! Words of the language, numbers at its edges, odd names.

use liftoff_tests::random::Source;

const WORDS: [&str; 93] = [
    "liftoff",
    "budget",
    "constant",
    "gravity",
    "bar",
    "chain",
    "body",
    "particle",
    "mass",
    "pin",
    "ground",
    "point",
    "weld",
    "slider",
    "drive",
    "spring",
    "torsion",
    "force",
    "couple",
    "section",
    "support",
    "thread",
    "equal",
    "figure",
    "coordinate",
    "mirror",
    "length",
    "inertia",
    "centre",
    "links",
    "from",
    "to",
    "points",
    "at",
    "of",
    "on",
    "under",
    "over",
    "facing",
    "rough",
    "stop",
    "restitution",
    "poisson",
    "stiffness",
    "damping",
    "angle",
    "frame",
    "floor",
    "wall",
    "ceiling",
    "slope",
    "circle",
    "bowl",
    "slot",
    "line",
    "corner",
    "horizontal",
    "vertical",
    "down",
    "up",
    "left",
    "right",
    "clockwise",
    "x",
    "y",
    "vx",
    "vy",
    "rate",
    "sin",
    "cos",
    "tan",
    "abs",
    "sqrt",
    "powi",
    "pi",
    "t",
    "crate",
    "sets",
    "names",
    "dimensionless",
    "flops",
    "true",
    "false",
    "derive",
    "struct",
    "pub",
    "f64",
    "doc",
    "cfg_attr",
    "direction",
    "outline",
    "law",
    "newton",
];

const NUMBERS: [&str; 28] = [
    "0",
    "1",
    "2",
    "3",
    "7",
    "64",
    "65",
    "4096",
    "0.5",
    "1.0",
    "1e-3",
    "1e30",
    "1e300",
    "1e-300",
    "1e39",
    "0x10",
    "0b1",
    "1_000",
    "170141183460469231731687303715884105727",
    "170141183460469231731687303715884105728",
    "1e999999999999",
    "0.1234567890123456789012345678901234567890",
    "1f32",
    "2u8",
    "1.5e-17",
    "9007199254740993",
    "1.",
    "340282366920938463463374607431768211455",
];

const NAMES: [&str; 40] = [
    "m",
    "l",
    "g",
    "k",
    "A",
    "B",
    "C",
    "D",
    "AB",
    "BC",
    "P",
    "Q",
    "O",
    "phi",
    "phi_1",
    "r#type",
    "r#fn",
    "r#m",
    "S",
    "V",
    "E",
    "T",
    "None",
    "Some",
    "order",
    "state",
    "_x",
    "__",
    "φ",
    "变",
    "É",
    "gen",
    "async",
    "Self",
    "self",
    "crate",
    "k1",
    "x1",
    "Lz",
    "a_very_long_name_that_goes_on_and_on_and_on_for_quite_a_while_until_it_ends_at_last",
];

const MARKS: [&str; 30] = [
    "+", "-", "*", "/", "=", "==", "->", "=>", ",", ";", ":", "::", ".", "..", "#", "!", "&", "|", "<", ">",
    "?", "'a", "\"text\"", "'c'", "b\"x\"", "(", ")", "[", "]", "$",
];

/// Any token.
pub(super) fn word(source: &mut Source) -> String {
    match source.below(8) {
        0..3 => source.choose(&WORDS),
        3..5 => source.choose(&NUMBERS),
        5..7 => source.choose(&NAMES),
        _ => source.choose(&MARKS),
    }
    .to_owned()
}

/// A token that an expression may have.
pub(super) fn term(source: &mut Source) -> String {
    let words =
        ["sin", "cos", "sqrt", "tan", "pi", "t", "m", "l", "g", "+", "-", "*", "/", "rate", "x", "powi", "."];
    if source.chance(0.3) { source.choose(&NUMBERS).to_owned() } else { source.choose(&words).to_owned() }
}

/// A struct with arbitrary tokens in attributes, or tokens alone.
pub(super) fn arbitrary(source: &mut Source) -> Vec<String> {
    let count = source.below(60);
    if source.chance(0.1) {
        return (0..count).map(|_| word(source)).collect();
    }
    let mut tokens = Vec::new();
    for _ in 0..1 + source.below(6) {
        tokens.extend(["#", "["].map(str::to_owned));
        tokens.push(source.choose(&WORDS[..26]).to_owned());
        tokens.push("(".to_owned());
        tokens.extend((0..source.below(12)).map(|_| word(source)));
        tokens.extend([")", "]"].map(str::to_owned));
    }
    let fields = ["struct", "S", "{", "m", ":", "f64", ",", "l", ":", "f64", ",", "g", ":", "f64", "}"];
    tokens.extend(fields.map(str::to_owned));
    tokens
}
