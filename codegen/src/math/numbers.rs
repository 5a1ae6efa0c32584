//! Numbers in text: superscripts, subscripts, ½ and ¹⁄₁₂.

const FRACTIONS: [(u128, u128, &str); 15] = [
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
    match (c, c.to_digit(10)) {
        (_, Some(digit)) => digits[digit as usize],
        ('-', _) => '⁻',
        _ => c,
    }
}

/// A number, fractions as one sign.
pub(super) fn number(numerator: u128, denominator: u128) -> String {
    if denominator == 1 {
        return numerator.to_string();
    }
    match FRACTIONS.iter().find(|(p, q, _)| (*p, *q) == (numerator, denominator)) {
        Some((_, _, sign)) => (*sign).to_owned(),
        None => {
            format!("{}⁄{}", superscript(&numerator.to_string()), subscript(&denominator.to_string()))
        }
    }
}
