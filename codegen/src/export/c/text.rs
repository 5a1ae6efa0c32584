//! Comments, strings and lists of C.

use crate::Dimension;
use crate::algebra::Rational;

/// A text within a comment.
pub(super) fn comment(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ").replace("*/", "* /").replace("/*", "/ *")
}

/// A literal; letters that C99 need not know by their bytes.
pub(super) fn string(text: &str) -> String {
    let mut literal = String::from("\"");
    for byte in text.bytes() {
        match byte {
            b'"' | b'\\' => literal.extend(['\\', byte.into()]),
            // A question mark may begin a trigraph.
            b'?' => literal.push_str("\\?"),
            b' '..=b'~' => literal.push(byte.into()),
            _ => literal.push_str(&format!("\\{byte:03o}")),
        }
    }
    literal + "\""
}

/// A list that has an end, since none may be empty.
pub(super) fn ended(items: impl IntoIterator<Item = String>, end: &str) -> String {
    let items: Vec<String> = items.into_iter().chain([end.to_owned()]).collect();
    items.join(", ")
}

/// Statements that keep compilers from telling of parameters that are not read.
pub(super) fn unused<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.map(|name| format!("    (void){name};\n")).collect()
}

/// The unit of a dimension in those of the SI: `kg*m/s^2`; 1 of a plain number.
pub(super) fn unit(dimension: &Dimension) -> String {
    let [length, time, mass] = *dimension;
    let factors = |sign: i128| {
        let powers = [("kg", mass), ("m", length), ("s", time)];
        let powers = powers.into_iter().filter(move |(_, power)| power.signum() as i128 == sign);
        let factor = |(unit, power): (&str, Rational)| match power.abs() {
            Rational::ONE => unit.to_owned(),
            power if power.denominator() == 1 => format!("{unit}^{power}"),
            power => format!("{unit}^({power})"),
        };
        powers.map(factor).collect::<Vec<_>>()
    };
    let (above, below) = (factors(1), factors(-1));
    let above = if above.is_empty() { "1".to_owned() } else { above.join("*") };
    match &below[..] {
        [] => above,
        [one] => format!("{above}/{one}"),
        several => format!("{above}/({})", several.join("*")),
    }
}
