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

/// From this numerator or denominator on a fraction is written as a decimal.
const LONG: u128 = 10_000;
/// From this denominator on a fraction is written as a decimal where that ends.
const FINE: u128 = 200;
/// Digits of a decimal.
const DIGITS: usize = 7;

/// `1.289743·10⁻⁶`: digits and a power of ten.
pub(super) struct Decimal {
    pub digits: String,
    pub exponent: i32,
}

/// Whether a fraction is better read as a decimal: `0.007`, `1.289744·10⁻⁶`.
pub(crate) fn is_long(numerator: u128, denominator: u128) -> bool {
    denominator > 1 && (numerator.max(denominator) >= LONG || denominator >= FINE && is_finite(denominator))
}

/// Whether a decimal with this denominator ends.
fn is_finite(denominator: u128) -> bool {
    let without = |mut n: u128, factor| {
        while n.is_multiple_of(factor) {
            n /= factor;
        }
        n
    };
    without(without(denominator, 2), 5) == 1
}

/// A fraction, rounded to seven digits.
pub(super) fn decimal(numerator: u128, denominator: u128) -> Decimal {
    let value = numerator as f64 / denominator as f64;
    let written = format!("{value:.*e}", DIGITS - 1);
    let (digits, exponent) = written.split_once('e').unwrap_or((&written, "0"));
    let exponent: i32 = exponent.parse().unwrap_or_default();
    if (-3..6).contains(&exponent) {
        let places = usize::try_from(DIGITS as i32 - 1 - exponent).unwrap_or_default();
        return Decimal { digits: trimmed(&format!("{value:.places$}")), exponent: 0 };
    }
    Decimal { digits: trimmed(digits), exponent }
}

fn trimmed(digits: &str) -> String {
    match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => digits.to_owned(),
    }
}

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
    if is_long(numerator, denominator) {
        let Decimal { digits, exponent } = decimal(numerator, denominator);
        return match exponent {
            0 => digits,
            _ => format!("{digits}·10{}", superscript(&exponent.to_string())),
        };
    }
    match FRACTIONS.iter().find(|(p, q, _)| (*p, *q) == (numerator, denominator)) {
        Some((_, _, sign)) => (*sign).to_owned(),
        None => {
            format!("{}⁄{}", superscript(&numerator.to_string()), subscript(&denominator.to_string()))
        }
    }
}
