//! Numbers in print: superscripts, subscripts, ½ and ¹⁄₁₂.

use super::super::Rational;

const FRACTIONS: [(i128, i128, &str); 15] = [
    (1, 2, "½"),
    (1, 3, "⅓"),
    (2, 3, "⅔"),
    (1, 4, "¼"),
    (3, 4, "¾"),
    (1, 5, "⅕"),
    (2, 5, "⅖"),
    (3, 5, "⅗"),
    (4, 5, "⅘"),
    (1, 6, "⅙"),
    (5, 6, "⅚"),
    (1, 8, "⅛"),
    (3, 8, "⅜"),
    (5, 8, "⅝"),
    (7, 8, "⅞"),
];

/// Every digit raised.
pub(super) fn superscript(digits: &str) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    digits.chars().map(|c| replaced(c, &RAISED)).collect()
}

/// Every digit lowered.
pub(super) fn subscript(digits: &str) -> String {
    const LOWERED: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];
    digits.chars().map(|c| replaced(c, &LOWERED)).collect()
}

fn replaced(c: char, digits: &[char; 10]) -> char {
    c.to_digit(10).map_or(c, |digit| digits[digit as usize])
}

/// base^exponent for an exponent ≥ 1.
pub(super) fn power(base: &str, exponent: u32) -> String {
    match exponent {
        1 => base.to_owned(),
        _ => format!("{base}{}", superscript(&exponent.to_string())),
    }
}

/// |number|, fractions as one sign.
pub(super) fn magnitude(number: Rational) -> String {
    let (n, d) = (number.numerator().abs(), number.denominator());
    if d == 1 {
        return n.to_string();
    }
    match FRACTIONS.iter().find(|(p, q, _)| (*p, *q) == (n, d)) {
        Some((_, _, sign)) => (*sign).to_owned(),
        None => format!("{}⁄{}", superscript(&n.to_string()), subscript(&d.to_string())),
    }
}
